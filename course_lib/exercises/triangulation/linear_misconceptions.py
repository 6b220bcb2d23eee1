"""Wrong answers to the exercise of chapter 09 on the linear method."""

from __future__ import annotations

from typing import Any

import numpy as np


def rows_of(pixels: Any, cameras: Any) -> Any:
    return (pixels[:, :, None] * cameras[:, 2:] - cameras[:, :2]).reshape(-1, 4)


def null_point(rows: Any) -> Any:
    X = np.linalg.svd(rows)[2][-1]
    return X[:3] / X[3]


def rows_mixed_up(pixels, cameras):
    return null_point(rows_of(pixels[:, ::-1], cameras))


def rows_added(pixels, cameras):
    return null_point(rows_of(-pixels, cameras))


def third_row_forgotten(pixels, cameras):
    rows = [row for x, P in zip(pixels, cameras, strict=True) for row in (x[0] - P[0], x[1] - P[1])]
    return null_point(np.array(rows))


def columns_for_rows(pixels, cameras):
    rows = [
        row
        for (u, v), P in zip(pixels, cameras, strict=True)
        for row in (u * P[:, 2] - P[:, 0], v * P[:, 2] - P[:, 1])
    ]
    X = np.linalg.svd(np.array(rows))[2][-1]
    return X[:3] / X[3]


def columns_and_last_number(pixels, cameras):
    rows = [
        row
        for (u, v), P in zip(pixels, cameras, strict=True)
        for row in (u * P[:, 2] - P[:, 0], v * P[:, 2] - P[:, 1])
    ]
    X = np.linalg.svd(np.array(rows))[2][-1]
    return X[:3] / X[-1]


def not_divided(pixels, cameras):
    return np.linalg.svd(rows_of(pixels, cameras))[2][-1][:3]


def four_numbers(pixels, cameras):
    X = np.linalg.svd(rows_of(pixels, cameras))[2][-1]
    return X / X[3]


def four_numbers_of_length_one(pixels, cameras):
    return np.linalg.svd(rows_of(pixels, cameras))[2][-1]


def divided_by_the_third(pixels, cameras):
    X = np.linalg.svd(rows_of(pixels, cameras))[2][-1]
    return X[:3] / X[2]


def two_numbers(pixels, cameras):
    X = np.linalg.svd(rows_of(pixels, cameras))[2][-1]
    return X[:2] / X[2]


def last_column(pixels, cameras):
    X = np.linalg.svd(rows_of(pixels, cameras))[2][:, -1]
    return X[:3] / X[3]


def largest_singular_value(pixels, cameras):
    X = np.linalg.svd(rows_of(pixels, cameras))[2][0]
    return X[:3] / X[3]


def first_factor(pixels, cameras):
    X = np.linalg.svd(rows_of(pixels, cameras))[0][:, -1]
    return X[:3] / X[3]


def equations_of_u_only(pixels, cameras):
    return null_point(rows_of(pixels, cameras)[::2])


def equations_of_v_only(pixels, cameras):
    return null_point(rows_of(pixels, cameras)[1::2])


def first_two_cameras(pixels, cameras):
    return null_point(rows_of(pixels[:2], cameras[:2]))


def last_camera_only(pixels, cameras):
    return null_point(rows_of(pixels[-1:], cameras[-1:]))


def first_camera_only(pixels, cameras):
    return null_point(rows_of(pixels[:1], cameras[:1]))


def one_matrix_for_all(pixels, cameras):
    return null_point(rows_of(pixels, np.array([cameras[0]] * len(pixels))))


def three_rows_a_camera(pixels, cameras):
    rows = [
        row
        for (u, v), P in zip(pixels, cameras, strict=True)
        for row in (u * P[2] - P[0], v * P[2] - P[1], u * P[1] - v * P[0])
    ]
    return null_point(np.array(rows))


def rows_in_pairs(pixels, cameras):
    return rows_in_pairs_of(rows_of(pixels, cameras))


def rows_in_pairs_and_last_of_each(pixels, cameras):
    X = np.linalg.svd(rows_of(pixels, cameras).reshape(-1, 2, 4))[2][:, -1]
    return X[:3] / X[3]


def rows_in_pairs_with_other_signs(pixels, cameras):
    return rows_in_pairs_of(-rows_of(pixels, cameras))


def rows_in_pairs_of(rows: Any) -> Any:
    X = np.linalg.svd(rows.reshape(-1, 2, 4))[2][-1]
    return X[:3] / X[3]


def whole_factor(pixels, cameras):
    Vt = np.linalg.svd(rows_of(pixels, cameras))[2]
    return Vt[:3] / Vt[3]


def whole_factor_with_other_signs(pixels, cameras):
    Vt = np.linalg.svd(-rows_of(pixels, cameras))[2]
    return Vt[:3] / Vt[3]


def first_row_in_both(pixels, cameras):
    rows = [
        row
        for (u, v), P in zip(pixels, cameras, strict=True)
        for row in (u * P[2] - P[0], v * P[2] - P[0])
    ]
    return null_point(np.array(rows))


def u_in_both(pixels, cameras):
    return null_point(rows_of(pixels[:, [0, 0]], cameras))


def one_pixel_for_all(pixels, cameras):
    return null_point(rows_of(np.array([pixels[0]] * len(pixels)), cameras))


def zero_for_the_solution(pixels, cameras):
    rows = rows_of(pixels, cameras)
    return np.linalg.lstsq(rows, np.zeros(len(rows)), rcond=None)[0][:3]


def sign_of_the_last_column(pixels, cameras):
    rows = rows_of(pixels, cameras)
    return np.linalg.lstsq(rows[:, :3], rows[:, 3], rcond=None)[0]


def both_equations_in_one_row(pixels, cameras):
    return null_point(rows_of(pixels, cameras).reshape(-1, 8))


def all_in_one_row(pixels, cameras):
    return null_point(rows_of(pixels, cameras).reshape(1, -1))


def singular_values(pixels, cameras):
    s = np.linalg.svd(rows_of(pixels, cameras))[1]
    return s[:3] / s[3]


def counted_from_one(pixels, cameras):
    rows = [u * P[3] - P[1] for (u, _), P in zip(pixels, cameras, strict=True)]
    return null_point(np.array(rows))


def two_numbers_of_three(pixels, cameras):
    return null_point(rows_of(pixels, cameras))[:2]
