"""Wrong answers to the exercises of chapter 08 on the matrices of known cameras."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib.exercises.epipolar.keeping import kept
from course_lib.transforms import skew

# --- skew -------------------------------------------------------------------------------------


def crossing(v: Any) -> Any:
    """Return the right matrix."""
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def transposed(v):
    return crossing(v).T


def without_signs(v):
    x, y, z = v
    return np.array([[0, z, y], [z, 0, x], [y, x, 0]])


def minus_above_only(v):
    x, y, z = v
    return np.array([[0, -z, -y], [z, 0, -x], [y, x, 0]])


def z_the_other_way(v):
    x, y, z = v
    return np.array([[0, z, y], [-z, 0, -x], [-y, x, 0]])


def x_the_other_way(v):
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, x], [-y, -x, 0]])


def first_and_last_swapped(v):
    return crossing(v[::-1])


def last_two_swapped(v):
    return crossing(v[[0, 2, 1]])


def first_two_swapped(v):
    return crossing(v[[1, 0, 2]])


def one_place_on(v):
    return crossing(v[[1, 2, 0]])


def one_place_back(v):
    return crossing(v[[2, 0, 1]])


def upper_half_only(v):
    return np.triu(crossing(v))


def lower_half_only(v):
    return np.tril(crossing(v))


def on_the_diagonal(v):
    return np.diag(v)


def every_product(v):
    return np.outer(v, v)


def made_a_unit_vector(v):
    return crossing(v / np.linalg.norm(v))


def cut_to_whole_numbers(v):
    return crossing(v).astype(int)


def crossed_with_itself(v):
    return np.cross(v, v)


# --- essential_from_pose ----------------------------------------------------------------------


def turned_first(R, t):
    return R @ skew(t)


def turned_shift(R, t):
    return skew(R @ t) @ R


def only_the_shift_turned(R, t):
    return skew(t @ R)


def only_the_shift_turned_forth(R, t):
    return skew(R @ t)


def entry_by_entry(R, t):
    return skew(t) * R


def rotation_transposed(R, t):
    return skew(t) @ R.T


def other_way_round(R, t):
    return (skew(t) @ R).T


def shift_of_the_centre(R, t):
    return skew(-R.T @ t) @ R


def cross_product_of_rows(R, t):
    return np.cross(t, R)


def cross_product_with_rotation(R, t):
    return np.cross(R, t)


def matrix_without_skew(R, t):
    return t * R


def column_without_skew(R, t):
    return t[:, None] * R


def product_without_skew(R, t):
    return R @ t


def shift_times_rotation(R, t):
    return t @ R


def rotation_left_out(R, t):
    return skew(t)


def added(R, t):
    return skew(t) + R


# --- fundamental_from_cameras -----------------------------------------------------------------


@kept
def blocks(P1: Any, P2: Any) -> Any:
    """Return M1, M2, the inverse of M1, and the epipole of picture 2."""
    M1, M2 = P1[:, :3], P2[:, :3]
    inverse = np.linalg.inv(M1)
    return M1, M2, inverse, P2[:, 3] - M2 @ inverse @ P1[:, 3]


def cameras_swapped(P1, P2):
    _, M1, inverse, e1 = blocks(P2, P1)
    return skew(e1) @ M1 @ inverse


def not_inverted(P1, P2):
    M1, M2, _, e2 = blocks(P1, P2)
    return skew(e2) @ M2 @ M1


def transposed_for_inverted(P1, P2):
    M1, M2, _, e2 = blocks(P1, P2)
    return skew(e2) @ M2 @ M1.T


def other_one_inverted(P1, P2):
    M1, M2, _, e2 = blocks(P1, P2)
    return skew(e2) @ np.linalg.inv(M2) @ M1


def other_one_inverted_last(P1, P2):
    M1, M2, _, e2 = blocks(P1, P2)
    return skew(e2) @ M1 @ np.linalg.inv(M2)


def left_inverse_not_transposed(P1, P2):
    # F is also M2⁻ᵀ [M2⁻¹ e2]ₓ M1⁻¹: from one centre to the other, in space.
    _, M2, inverse, e2 = blocks(P1, P2)
    return np.linalg.inv(M2) @ skew(np.linalg.solve(M2, e2)) @ inverse


def inverse_transposed(P1, P2):
    _, M2, inverse, e2 = blocks(P1, P2)
    return skew(e2) @ M2 @ inverse.T


def factors_turned_round(P1, P2):
    _, M2, inverse, e2 = blocks(P1, P2)
    return skew(e2) @ inverse @ M2


def entries_multiplied(P1, P2):
    _, M2, inverse, e2 = blocks(P1, P2)
    return skew(e2) * M2 * inverse


def last_entries_multiplied(P1, P2):
    _, M2, inverse, e2 = blocks(P1, P2)
    return skew(e2) @ (M2 * inverse)


def first_entries_multiplied(P1, P2):
    _, M2, inverse, e2 = blocks(P1, P2)
    return skew(e2) * (M2 @ inverse)


def epipole_last(P1, P2):
    _, M2, inverse, e2 = blocks(P1, P2)
    return M2 @ inverse @ skew(e2)


def second_camera_left_out(P1, P2):
    _, _, inverse, e2 = blocks(P1, P2)
    return skew(e2) @ inverse


def first_camera_left_out(P1, P2):
    _, M2, _, e2 = blocks(P1, P2)
    return skew(e2) @ M2


def only_the_epipole(P1, P2):
    return skew(blocks(P1, P2)[3])


def only_the_plane_at_infinity(P1, P2):
    _, M2, inverse, _ = blocks(P1, P2)
    return M2 @ inverse


def epipole_of_picture_1(P1, P2):
    _, M2, inverse, _ = blocks(P1, P2)
    return skew(blocks(P2, P1)[3]) @ M2 @ inverse


def sign_of_the_centre(P1, P2):
    _, M2, inverse, _ = blocks(P1, P2)
    return skew(M2 @ inverse @ P1[:, 3] + P2[:, 3]) @ M2 @ inverse


def last_column_for_the_centre(P1, P2):
    _, M2, inverse, _ = blocks(P1, P2)
    return skew(M2 @ P1[:, 3] + P2[:, 3]) @ M2 @ inverse


def minus_last_column_for_the_centre(P1, P2):
    _, M2, inverse, _ = blocks(P1, P2)
    return skew(P2[:, 3] - M2 @ P1[:, 3]) @ M2 @ inverse


def transpose_in_the_centre(P1, P2):
    M1, M2, inverse, _ = blocks(P1, P2)
    return skew(P2[:, 3] - M2 @ M1.T @ P1[:, 3]) @ M2 @ inverse


def last_column_for_the_epipole(P1, P2):
    _, M2, inverse, _ = blocks(P1, P2)
    return skew(P2[:, 3]) @ M2 @ inverse


def difference_of_last_columns(P1, P2):
    _, M2, inverse, _ = blocks(P1, P2)
    return skew(P2[:, 3] - P1[:, 3]) @ M2 @ inverse


def centre_as_a_direction(P1, P2):
    _, M2, inverse, _ = blocks(P1, P2)
    return skew(-M2 @ inverse @ P1[:, 3]) @ M2 @ inverse


def centre_of_camera_2(P1, P2):
    _, M2, inverse, _ = blocks(P1, P2)
    return skew(P2[:, 3] - P2[:, 3]) @ M2 @ inverse


def centre_not_projected(P1, P2):
    _, M2, inverse, _ = blocks(P1, P2)
    return skew(-inverse @ P1[:, 3]) @ M2 @ inverse
