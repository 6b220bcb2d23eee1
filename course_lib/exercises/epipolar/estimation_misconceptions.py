"""Wrong answers to the exercises of chapter 08 on F from eight or more pairs."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib.exercises.epipolar.keeping import kept
from course_lib.exercises.epipolar.line_misconceptions import homogeneous
from course_lib.homography import normalise_points

# --- eight_point ------------------------------------------------------------------------------


@kept
def null_matrix(one: Any, other: Any) -> Any:
    """Return F as the equations give it, of rank 3."""
    x1, x2 = homogeneous(one), homogeneous(other)
    A = (x2[:, :, None] * x1[:, None, :]).reshape(-1, 9)
    return np.linalg.svd(A)[2][-1].reshape(3, 3)


def rank_two(F: Any) -> Any:
    U, s, Vt = np.linalg.svd(F)
    return U[:, :2] * s[:2] @ Vt[:2]


@kept
def normalised(points1: Any, points2: Any) -> Any:
    """Return F of the normalised points, of rank 3, and both T."""
    near1, T1 = normalise_points(points1)
    near2, T2 = normalise_points(points2)
    return null_matrix(near1, near2), T1, T2


def pictures_swapped(points1, points2):
    F, T1, T2 = normalised(points1, points2)
    return T1.T @ rank_two(F.T) @ T2


def laid_out_by_columns(points1, points2):
    F, T1, T2 = normalised(points1, points2)
    return T2.T @ rank_two(F.T) @ T1


def rank_left_out(points1, points2):
    F, T1, T2 = normalised(points1, points2)
    return T2.T @ F @ T1


def rank_made_in_pixels(points1, points2):
    F, T1, T2 = normalised(points1, points2)
    return rank_two(T2.T @ F @ T1)


def rank_one(points1, points2):
    F, T1, T2 = normalised(points1, points2)
    U, s, Vt = np.linalg.svd(F)
    return T2.T @ (s[0] * np.outer(U[:, 0], Vt[0])) @ T1


def largest_made_zero(points1, points2):
    F, T1, T2 = normalised(points1, points2)
    U, s, Vt = np.linalg.svd(F)
    return T2.T @ U @ np.diag([0, s[1], s[2]]) @ Vt @ T1


def put_together_with_the_transpose(points1, points2):
    F, T1, T2 = normalised(points1, points2)
    U, s, Vt = np.linalg.svd(F)
    return T2.T @ U @ np.diag([s[0], s[1], 0]) @ Vt.T @ T1


def singular_values_not_a_matrix(points1, points2):
    F, T1, T2 = normalised(points1, points2)
    U, s, Vt = np.linalg.svd(F)
    return T2.T @ (U @ np.array([s[0], s[1], 0]) @ Vt) @ T1


def not_normalised(points1, points2):
    return rank_two(null_matrix(points1, points2))


def neither_normalised_nor_rank_two(points1, points2):
    return null_matrix(points1, points2)


def left_normalised(points1, points2):
    return rank_two(normalised(points1, points2)[0])


def left_normalised_with_rank_three(points1, points2):
    return normalised(points1, points2)[0]


def by_one(T: Any, points1: Any, points2: Any) -> Any:
    """Return F by one normalisation of both pictures."""
    one, other = (homogeneous(points) @ T.T for points in (points1, points2))
    return T.T @ rank_two(null_matrix(one[:, :2], other[:, :2])) @ T


def normalised_alike(points1, points2):
    return by_one(normalise_points(points1)[1], points1, points2)


def normalised_alike_by_picture_2(points1, points2):
    return by_one(normalise_points(points2)[1], points1, points2)


def normalised_together(points1, points2):
    return by_one(normalise_points(np.vstack([points1, points2]))[1], points1, points2)


def back_as_a_homography(points1, points2):
    F, T1, T2 = normalised(points1, points2)
    return np.linalg.inv(T2) @ rank_two(F) @ T1


def back_inverted(points1, points2):
    F, T1, T2 = normalised(points1, points2)
    return np.linalg.inv(T2).T @ rank_two(F) @ np.linalg.inv(T1)


def back_not_transposed(points1, points2):
    F, T1, T2 = normalised(points1, points2)
    return T2 @ rank_two(F) @ T1


def back_with_the_other_T(points1, points2):
    F, T1, T2 = normalised(points1, points2)
    return T1.T @ rank_two(F) @ T2


def back_with_one_T(points1, points2):
    F, T1, _ = normalised(points1, points2)
    return T1.T @ rank_two(F) @ T1


def pixels_in_the_equations(points1, points2):
    _, T1, T2 = normalised(points1, points2)
    return T2.T @ rank_two(null_matrix(points1, points2)) @ T1


def last_number_fixed(points1, points2):
    near1, T1 = normalise_points(points1)
    near2, T2 = normalise_points(points2)
    x1, x2 = homogeneous(near1), homogeneous(near2)
    A = (x2[:, :, None] * x1[:, None, :]).reshape(-1, 9)
    f = np.linalg.lstsq(A[:, :8], -A[:, 8], rcond=None)[0]
    return T2.T @ rank_two(np.append(f, 1).reshape(3, 3)) @ T1


def entries_multiplied(points1, points2):
    F, T1, T2 = normalised(points1, points2)
    U, s, Vt = np.linalg.svd(F)
    return T2.T @ (U * np.diag([s[0], s[1], 0]) * Vt) @ T1


def entries_multiplied_on_the_way_back(points1, points2):
    F, T1, T2 = normalised(points1, points2)
    return T2.T * rank_two(F) * T1


def first_vector(points1, points2):
    return of_vector(points1, points2, lambda Vt: Vt[0])


def last_column(points1, points2):
    return of_vector(points1, points2, lambda Vt: Vt[:, -1])


def of_vector(points1: Any, points2: Any, choose: Any) -> Any:
    near1, T1 = normalise_points(points1)
    near2, T2 = normalise_points(points2)
    x1, x2 = homogeneous(near1), homogeneous(near2)
    A = (x2[:, :, None] * x1[:, None, :]).reshape(-1, 9)
    return T2.T @ rank_two(choose(np.linalg.svd(A)[2]).reshape(3, 3)) @ T1
