"""Wrong answers to the exercises of chapter 07 on the board and the closed form."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- board_points -----------------------------------------------------------------------------


def columns_and_rows_swapped(columns, rows, square):
    return grid(rows, columns) * square


def square_forgotten(columns, rows, square):
    return grid(columns, rows)


def column_after_column(columns, rows, square):
    return grid(rows, columns)[:, [1, 0, 2]] * square


def x_and_y_swapped(columns, rows, square):
    return grid(columns, rows)[:, [1, 0, 2]] * square


def squares_counted(columns, rows, square):
    return grid(columns + 1, rows + 1) * square


def last_row_and_column_left_out(columns, rows, square):
    return grid(columns - 1, rows - 1) * square


def last_column_left_out(columns, rows, square):
    return grid(columns - 1, rows) * square


def last_row_left_out(columns, rows, square):
    return grid(columns, rows - 1) * square


def first_corner_at_one(columns, rows, square):
    return (grid(columns, rows) + np.array([1, 1, 0])) * square


def origin_in_the_middle(columns, rows, square):
    points = grid(columns, rows) * square
    return points - points.mean(axis=0)


def without_z(columns, rows, square):
    return grid(columns, rows)[:, :2] * square


def cut_to_whole_numbers(columns, rows, square):
    return (grid(columns, rows) * square).astype(int)


def grid(columns: Any, rows: Any) -> Any:
    return np.array([(c, r, 0.0) for r in range(rows) for c in range(columns)])


# --- homography_constraints -------------------------------------------------------------------


def v(p: Any, q: Any) -> Any:
    return np.array(
        [
            p[0] * q[0],
            p[0] * q[1] + p[1] * q[0],
            p[1] * q[1],
            p[0] * q[2] + p[2] * q[0],
            p[1] * q[2] + p[2] * q[1],
            p[2] * q[2],
        ]
    )


def rows_for_columns(H):
    h1, h2 = H[0], H[1]
    return np.array([v(h1, h2), v(h1, h1) - v(h2, h2)])


def lengths_added(H):
    h1, h2 = H[:, 0], H[:, 1]
    return np.array([v(h1, h2), v(h1, h1) + v(h2, h2)])


def half_of_the_mixed_products(H):
    h1, h2 = H[:, 0], H[:, 1]
    return np.array([once(h1, h2), once(h1, h1) - once(h2, h2)])


def once(p: Any, q: Any) -> Any:
    return np.array([p[0] * q[0], p[0] * q[1], p[1] * q[1], p[0] * q[2], p[1] * q[2], p[2] * q[2]])


def half_of_the_mixed_squares(H):
    h1, h2 = H[:, 0], H[:, 1]
    return np.array([v(h1, h2), once(h1, h1) - once(h2, h2)])


def half_in_v11(H):
    h1, h2 = H[:, 0], H[:, 1]
    return np.array([v(h1, h2), once(h1, h1) - v(h2, h2)])


def half_in_v22(H):
    h1, h2 = H[:, 0], H[:, 1]
    return np.array([v(h1, h2), v(h1, h1) - once(h2, h2)])


def three_rows(H):
    h1, h2 = H[:, 0], H[:, 1]
    return np.array([v(h1, h2), v(h1, h1), v(h2, h2)])


def subtracted_the_other_way(H):
    h1, h2 = H[:, 0], H[:, 1]
    return np.array([v(h1, h2), v(h2, h2) - v(h1, h1)])


def in_the_order_of_rows(H):
    h1, h2 = H[:, 0], H[:, 1]
    return np.array([v(h1, h2), v(h1, h1) - v(h2, h2)])[:, [0, 1, 3, 2, 4, 5]]


def equations_swapped(H):
    h1, h2 = H[:, 0], H[:, 1]
    return np.array([v(h1, h1) - v(h2, h2), v(h1, h2)])


def only_one_length(H):
    h1, h2 = H[:, 0], H[:, 1]
    return np.array([v(h1, h2), v(h1, h1)])


def second_and_third_column(H):
    h2, h3 = H[:, 1], H[:, 2]
    return np.array([v(h2, h3), v(h2, h2) - v(h3, h3)])


# --- intrinsics_from_homographies -------------------------------------------------------------


def all_rows(Hs: Any) -> Any:
    return np.concatenate([[v(h1, h2), v(h1, h1) - v(h2, h2)] for h1, h2, _ in Hs.swapaxes(1, 2)])


def null_vector(Hs: Any) -> Any:
    b = np.linalg.svd(all_rows(Hs))[2][-1]
    return b if b[0] > 0 else -b


def matrix(b: Any) -> Any:
    b11, b12, b22, b13, b23, b33 = b
    return np.array([[b11, b12, b13], [b12, b22, b23], [b13, b23, b33]])


def not_scaled(Hs):
    return np.linalg.inv(np.linalg.cholesky(matrix(null_vector(Hs))).T)


def inverse_left_out(Hs):
    K = np.linalg.cholesky(matrix(null_vector(Hs))).T
    return K / K[2, 2]


def inverse_and_scale_left_out(Hs):
    return np.linalg.cholesky(matrix(null_vector(Hs))).T


def scaled_by_the_first(Hs):
    K = np.linalg.inv(np.linalg.cholesky(matrix(null_vector(Hs))).T)
    return K / K[0, 0]


def mixed_entries_halved(Hs):
    B = matrix(null_vector(Hs))
    return factor(B + np.diag(np.diag(B)))  # twice the diagonal: the same up to scale


def mixed_entries_doubled(Hs):
    B = matrix(null_vector(Hs))
    return factor(2 * B - np.diag(np.diag(B)))


def upper_triangle_only(Hs):
    return factor(np.triu(matrix(null_vector(Hs))))


def signs_of_B_lost(Hs):
    return factor(np.abs(matrix(null_vector(Hs))))


def skew_set_to_zero(Hs):
    K = factor(matrix(null_vector(Hs)))
    return K * [[1, 0, 1], [0, 1, 1], [0, 0, 1]]


def one_view_is_enough(Hs):
    """With the principal point guessed and no skew, one view gives fx and fy."""
    to_middle = np.array([[1, 0, -319.5], [0, 1, -239.5], [0, 0, 1]])
    rows = all_rows(to_middle @ Hs[:1])[:, [0, 2, 5]]
    b11, b22, b33 = np.cross(rows[0], rows[1])
    return np.array([[np.sqrt(b33 / b11), 0, 319.5], [0, np.sqrt(b33 / b22), 239.5], [0, 0, 1]])


def first_view_only(Hs):
    return factor(matrix(null_vector(Hs[:1])))


def last_view_only(Hs):
    return factor(matrix(null_vector(Hs[-1:])))


def rows_side_by_side(Hs):
    b = np.linalg.svd(np.hstack(all_rows(Hs).reshape(-1, 2, 6)))[2][-1][:6]
    return factor(matrix(b if b[0] > 0 else -b))


def lower_triangle(Hs):
    K = np.linalg.inv(np.linalg.cholesky(matrix(null_vector(Hs))))
    return K / K[2, 2]


def B_itself_inverted(Hs):
    K = np.linalg.inv(matrix(null_vector(Hs)))
    return K / K[2, 2]


def B_for_K(Hs):
    B = matrix(null_vector(Hs))
    return B / B[2, 2]


def order_of_b_mixed_up(Hs):
    b11, b12, b13, b22, b23, b33 = null_vector(Hs)
    B = np.array([[b11, b12, b13], [b12, b22, b23], [b13, b23, b33]])
    return factor(B)


def largest_singular_value(Hs):
    b = np.linalg.svd(all_rows(Hs))[2][0]
    return factor(matrix(b if b[0] > 0 else -b))


def column_of_the_last_factor(Hs):
    b = np.linalg.svd(all_rows(Hs))[2][:, -1]
    return factor(matrix(b if b[0] > 0 else -b))


def rows_not_below_each_other(Hs):
    b = last_of_each_view(Hs)
    if b[0] < 0:
        b = -b
    return factor(matrix(b))


def rows_not_below_each_other_without_if(Hs):
    b = last_of_each_view(Hs)
    return factor(matrix(b * np.sign(b[0])))


def last_of_each_view(Hs: Any) -> Any:
    """Return what is no vector: the equations of each view were decomposed on their own."""
    return np.linalg.svd(all_rows(Hs).reshape(-1, 2, 6))[2][-1]


def factor(B: Any) -> Any:
    K = np.linalg.inv(np.linalg.cholesky(B).T)
    return K / K[2, 2]
