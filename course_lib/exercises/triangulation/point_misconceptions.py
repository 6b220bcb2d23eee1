"""Wrong answers to the exercises of chapter 09 on the linear method and the refined point."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- triangulate_linear -----------------------------------------------------------------------


def rows_of(pixels: Any, cameras: Any) -> Any:
    return np.array(
        [
            row
            for (u, v), P in zip(pixels, cameras, strict=True)
            for row in (u * P[2] - P[0], v * P[2] - P[1])
        ]
    )


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


# --- refine_point -----------------------------------------------------------------------------


def linearised(X: Any, pixels: Any, cameras: Any) -> Any:
    """Return the right J and residuals."""
    J, r = [], []
    for pixel, P in zip(pixels, cameras, strict=True):
        a = P @ np.append(X, 1)
        seen = a[:2] / a[2]
        J.extend((P[:2, :3] - seen[:, None] * P[2, :3]) / a[2])
        r.extend(seen - pixel)
    return np.array(J), np.array(r)


def step(J: Any, r: Any) -> Any:
    return np.linalg.lstsq(J, -r, rcond=None)[0]


def with_derivatives(X: Any, pixels: Any, cameras: Any, derive: Any) -> Any:
    """Step with other derivatives: `derive` takes P, the projected and the measured pixel, c."""
    J, r = [], []
    for pixel, P in zip(pixels, cameras, strict=True):
        a = P @ np.append(X, 1)
        seen = a[:2] / a[2]
        J.extend(derive(P, seen, pixel, a[2]))
        r.extend(seen - pixel)
    return X + step(np.array(J), np.array(r))


def uphill(X, pixels, cameras):
    return X - step(*linearised(X, pixels, cameras))


def step_only(X, pixels, cameras):
    return step(*linearised(X, pixels, cameras))


def negative_step_only(X, pixels, cameras):
    return -step(*linearised(X, pixels, cameras))


def measured_pixel_in_J(X, pixels, cameras):
    return with_derivatives(
        X, pixels, cameras, lambda P, _, x, c: (P[:2, :3] - x[:, None] * P[2, :3]) / c
    )


def depth_left_out_of_J(X, pixels, cameras):
    return with_derivatives(
        X, pixels, cameras, lambda P, x, _, __: P[:2, :3] - x[:, None] * P[2, :3]
    )


def depth_taken_for_constant(X, pixels, cameras):
    return with_derivatives(X, pixels, cameras, lambda P, _, __, c: P[:2, :3] / c)


def sign_in_the_derivative(X, pixels, cameras):
    return with_derivatives(
        X, pixels, cameras, lambda P, x, _, c: (P[:2, :3] + x[:, None] * P[2, :3]) / c
    )


def only_one_term_divided(X, pixels, cameras):
    return with_derivatives(
        X, pixels, cameras, lambda P, x, _, c: P[:2, :3] - x[:, None] * P[2, :3] / c
    )


def squared_depth(X, pixels, cameras):
    return with_derivatives(
        X, pixels, cameras, lambda P, x, _, c: (P[:2, :3] - x[:, None] * P[2, :3]) / c**2
    )


def same_pixel_in_both_rows(X, pixels, cameras):
    return with_derivatives(
        X, pixels, cameras, lambda P, x, _, c: (P[:2, :3] - x[0] * P[2, :3]) / c
    )


def pixels_not_divided(X, pixels, cameras):
    J, r = [], []
    for pixel, P in zip(pixels, cameras, strict=True):
        a = P @ np.append(X, 1)
        J.extend((P[:2, :3] - a[:2, None] * P[2, :3]) / a[2])
        r.extend(a[:2] - pixel)
    return X + step(np.array(J), np.array(r))


def downhill_only(X, pixels, cameras):
    J, r = linearised(X, pixels, cameras)
    return X - J.T @ r


def four_columns(X, pixels, cameras):
    rows = []
    for P in cameras:
        a = P @ np.append(X, 1)
        rows.extend((P[:2] - (a[:2] / a[2])[:, None] * P[2]) / a[2])
    return X + step(np.array(rows), linearised(X, pixels, cameras)[1])


def until_nothing_moves(X, pixels, cameras):
    for _ in range(10):
        X = X + step(*linearised(X, pixels, cameras))
    return X


def two_steps(X, pixels, cameras):
    X = X + step(*linearised(X, pixels, cameras))
    return X + step(*linearised(X, pixels, cameras))


def equations_of_u(X, pixels, cameras):
    J, r = linearised(X, pixels, cameras)
    return X + step(J[::2], r[::2])


def first_camera(X, pixels, cameras):
    return X + step(*linearised(X, pixels[:1], cameras[:1]))


def last_camera(X, pixels, cameras):
    return X + step(*linearised(X, pixels[-1:], cameras[-1:]))


def two_cameras_of_all(X, pixels, cameras):
    return X + step(*linearised(X, pixels[:2], cameras[:2]))


def order_of_rows_mixed(X, pixels, cameras):
    J, r = linearised(X, pixels, cameras)
    return X + step(J, r.reshape(-1, 2).T.ravel())


def all_that_lstsq_gives(X, pixels, cameras):
    J, r = linearised(X, pixels, cameras)
    return X + np.linalg.lstsq(J, -r, rcond=None)
