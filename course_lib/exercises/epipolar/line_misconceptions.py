"""Wrong answers to the exercises of chapter 08 on lines, epipoles and distances from lines."""

from __future__ import annotations

from typing import Any

import numpy as np


def homogeneous(points: Any) -> Any:
    return np.column_stack([points, np.ones(len(points))])


def scaled(lines: Any) -> Any:
    return lines / np.hypot(lines[:, 0], lines[:, 1])[:, None]


# --- epipolar_lines ---------------------------------------------------------------------------


def lines_of_the_other_picture(points, F):
    return scaled(homogeneous(points) @ F)


def not_scaled(points, F):
    return homogeneous(points) @ F.T


def other_picture_and_not_scaled(points, F):
    return homogeneous(points) @ F


def scaled_by_all_three(points, F):
    lines = homogeneous(points) @ F.T
    return lines / np.linalg.norm(lines, axis=1, keepdims=True)


def last_number_one(points, F):
    lines = homogeneous(points) @ F.T
    return lines / lines[:, 2:]


def scaled_all_alike(points, F):
    lines = homogeneous(points) @ F.T
    return lines / np.linalg.norm(lines[:, :2])


def scaled_all_alike_by_everything(points, F):
    lines = homogeneous(points) @ F.T
    return lines / np.linalg.norm(lines)


def scaled_by_columns(points, F):
    lines = homogeneous(points) @ F.T
    return lines / np.linalg.norm(lines, axis=0)


def root_left_out(points, F):
    lines = homogeneous(points) @ F.T
    return lines / (lines[:, :1] ** 2 + lines[:, 1:2] ** 2)


def c_left_as_it_was(points, F):
    lines = homogeneous(points) @ F.T
    lines[:, :2] = scaled(lines)[:, :2]
    return lines


def lines_in_columns(points, F):
    return scaled(homogeneous(points) @ F.T).T


def zero_for_one(points, F):
    return scaled(np.column_stack([points, np.zeros(len(points))]) @ F.T)


def one_in_front(points, F):
    return scaled(np.column_stack([np.ones(len(points)), points]) @ F.T)


def rows_and_columns_swapped(points, F):
    return scaled(homogeneous(points[:, ::-1]) @ F.T)


def normals_only(points, F):
    return scaled(homogeneous(points) @ F.T)[:, :2]


# --- epipole ----------------------------------------------------------------------------------


def pixel(e: Any) -> Any:
    return e[:2] / e[2]


def epipole_of_picture_2(F):
    return pixel(np.linalg.svd(F)[0][:, 2])


def column_of_the_last_factor(F):
    return pixel(np.linalg.svd(F)[2][:, 2])


def row_of_the_first_factor(F):
    return pixel(np.linalg.svd(F)[0][2])


def largest_singular_value(F):
    return pixel(np.linalg.svd(F)[2][0])


def not_divided(F):
    return np.linalg.svd(F)[2][2]


def not_divided_but_cut(F):
    return np.linalg.svd(F)[2][2][:2]


def divided_and_not_cut(F):
    e = np.linalg.svd(F)[2][2]
    return e / e[2]


def row_before_column(F):
    return pixel(np.linalg.svd(F)[2][2])[::-1]


def divided_by_the_length(F):
    e = np.linalg.svd(F)[2][2][:2]
    return e / np.linalg.norm(e)


def singular_value_for_vector(F):
    return np.linalg.svd(F)[1][:2]


def zero_vector(F):
    return np.full(2, np.nan)  # 0 / 0


def zero_vector_not_divided(F):
    return np.zeros(3)


def zero_vector_cut(F):
    return np.zeros(2)


def smallest_by_symmetric_eigenvectors(F):
    return pixel(np.linalg.eigh(F)[1][:, 0])


def last_column(F):
    return pixel(F[:, 2])


def last_row(F):
    return pixel(F[2])


# --- line_distance ----------------------------------------------------------------------------


def along(points: Any, lines: Any) -> Any:
    return (homogeneous(points) * lines).sum(axis=1)


def lengths(lines: Any) -> Any:
    return np.hypot(lines[:, 0], lines[:, 1])


def not_divided_by_the_length(points, lines):
    return np.abs(along(points, lines))


def sign_kept(points, lines):
    return along(points, lines) / lengths(lines)


def sign_kept_and_not_divided(points, lines):
    return along(points, lines)


def root_of_the_squares_left_out(points, lines):
    return np.abs(along(points, lines)) / lengths(lines) ** 2


def length_of_all_three(points, lines):
    return np.abs(along(points, lines)) / np.linalg.norm(lines, axis=1)


def c_forgotten(points, lines):
    return np.abs((points * lines[:, :2]).sum(axis=1)) / lengths(lines)


def every_point_with_every_line(points, lines):
    return np.abs(homogeneous(points) @ lines.T) / lengths(lines)


def every_point_with_every_line_not_divided(points, lines):
    return homogeneous(points) @ lines.T


def every_point_with_every_line_without_sign(points, lines):
    return np.abs(homogeneous(points) @ lines.T)


def every_point_with_every_line_divided_by_rows(points, lines):
    return np.abs(homogeneous(points) @ lines.T) / lengths(lines)[:, None]


def brackets_left_out(points, lines):
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.abs(along(points, lines)) / lines[:, 0] ** 2 + lines[:, 1] ** 2


def root_of_one_number(points, lines):
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.abs(along(points, lines)) / np.sqrt(lines[:, 0] ** 2) + lines[:, 1] ** 2


def added_down_the_columns(points, lines):
    return np.abs((homogeneous(points) * lines).sum(axis=0)) / lengths(lines)[:3]


def one_length_for_all(points, lines):
    return np.abs(along(points, lines)) / np.linalg.norm(lines[:, :2])


def lengths_of_columns(points, lines):
    return np.abs(homogeneous(points) * lines).sum(axis=1) / lengths(lines)


def in_a_column(points, lines):
    return (np.abs(along(points, lines)) / lengths(lines))[:, None]


def squared(points, lines):
    return (along(points, lines) / lengths(lines)) ** 2


def a_and_b_swapped(points, lines):
    return np.abs(along(points[:, ::-1], lines)) / lengths(lines)


def added_up(points, lines):
    return np.abs(along(points, lines) / lengths(lines)).sum()


def averaged(points, lines):
    return np.abs(along(points, lines) / lengths(lines)).mean()
