"""Wrong answers to the exercise of chapter 09 on the refined point."""

from __future__ import annotations

from typing import Any

import numpy as np


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


def first_row_for_v(X, pixels, cameras):
    return with_derivatives(
        X, pixels, cameras, lambda P, x, _, c: (P[0, :3] - x[:, None] * P[2, :3]) / c
    )


def last_column_left_out(X, pixels, cameras):
    J, r = [], []
    for pixel, P in zip(pixels, cameras, strict=True):
        a = P[:, :3] @ X
        J.extend((P[:2, :3] - (a[:2] / a[2])[:, None] * P[2, :3]) / a[2])
        r.extend(a[:2] / a[2] - pixel)
    return X + step(np.array(J), np.array(r))


def measured_for_residuals(X, pixels, cameras):
    return X + step(linearised(X, pixels, cameras)[0], pixels.ravel())


def measured_with_the_other_sign(X, pixels, cameras):
    return X - step(linearised(X, pixels, cameras)[0], pixels.ravel())


def projected_for_residuals(X, pixels, cameras):
    J, r = linearised(X, pixels, cameras)
    return X + step(J, r + pixels.ravel())


def matrix_not_inverted(X, pixels, cameras):
    J, r = linearised(X, pixels, cameras)
    return X - J.T @ J @ (J.T @ r)


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
