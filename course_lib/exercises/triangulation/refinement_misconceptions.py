"""Wrong answers to the exercise of chapter 09 on the refined point."""

from __future__ import annotations

from typing import Any

import numpy as np


def linearised(point: Any, pixels: Any, cameras: Any) -> Any:
    """Return the right J and residuals."""
    a = cameras[:, :, :3] @ point + cameras[:, :, 3]
    seen = a[:, :2] / a[:, 2:]
    J = (cameras[:, :2, :3] - seen[..., None] * cameras[:, 2:, :3]) / a[:, 2:, None]
    return J.reshape(-1, 3), (seen - pixels).ravel()


def step(J: Any, r: Any) -> Any:
    return np.linalg.lstsq(J, -r, rcond=None)[0]


def with_derivatives(point: Any, pixels: Any, cameras: Any, derive: Any) -> Any:
    """Step with other derivatives: `derive` takes P, the projected and the measured pixel, c."""
    J, r = [], []
    for pixel, P in zip(pixels, cameras, strict=True):
        a = P @ np.append(point, 1)
        seen = a[:2] / a[2]
        J.extend(derive(P, seen, pixel, a[2]))
        r.extend(seen - pixel)
    return point + step(np.array(J), np.array(r))


def uphill(point, pixels, cameras):
    return point - step(*linearised(point, pixels, cameras))


def step_only(point, pixels, cameras):
    return step(*linearised(point, pixels, cameras))


def measured_pixel_in_J(point, pixels, cameras):
    return with_derivatives(
        point, pixels, cameras, lambda P, _, x, c: (P[:2, :3] - x[:, None] * P[2, :3]) / c
    )


def depth_left_out_of_J(point, pixels, cameras):
    return with_derivatives(
        point, pixels, cameras, lambda P, x, _, __: P[:2, :3] - x[:, None] * P[2, :3]
    )


def depth_taken_for_constant(point, pixels, cameras):
    return with_derivatives(point, pixels, cameras, lambda P, _, __, c: P[:2, :3] / c)


def sign_in_the_derivative(point, pixels, cameras):
    return with_derivatives(
        point, pixels, cameras, lambda P, x, _, c: (P[:2, :3] + x[:, None] * P[2, :3]) / c
    )


def only_one_term_divided(point, pixels, cameras):
    return with_derivatives(
        point, pixels, cameras, lambda P, x, _, c: P[:2, :3] - x[:, None] * P[2, :3] / c
    )


def squared_depth(point, pixels, cameras):
    return with_derivatives(
        point, pixels, cameras, lambda P, x, _, c: (P[:2, :3] - x[:, None] * P[2, :3]) / c**2
    )


def same_pixel_in_both_rows(point, pixels, cameras):
    return with_derivatives(
        point, pixels, cameras, lambda P, x, _, c: (P[:2, :3] - x[0] * P[2, :3]) / c
    )


def depth_in_the_world(point, pixels, cameras):
    return with_derivatives(
        point,
        pixels,
        cameras,
        lambda P, x, _, __: (P[:2, :3] - x[:, None] * P[2, :3]) / point[2],
    )


def columns_for_rows(point, pixels, cameras):
    return with_derivatives(
        point,
        pixels,
        cameras,
        lambda P, x, _, c: (P[:, :2].T - x[:, None] * P[:, 2]) / c,
    )


def camera_after_camera(point, pixels, cameras):
    for i in range(len(cameras)):
        point = point + step(*linearised(point, pixels[i : i + 1], cameras[i : i + 1]))
    return point


def first_row_for_v(point, pixels, cameras):
    return with_derivatives(
        point, pixels, cameras, lambda P, x, _, c: (P[0, :3] - x[:, None] * P[2, :3]) / c
    )


def last_column_left_out(point, pixels, cameras):
    J, r = [], []
    for pixel, P in zip(pixels, cameras, strict=True):
        a = P[:, :3] @ point
        J.extend((P[:2, :3] - (a[:2] / a[2])[:, None] * P[2, :3]) / a[2])
        r.extend(a[:2] / a[2] - pixel)
    return point + step(np.array(J), np.array(r))


def measured_for_residuals(point, pixels, cameras):
    return point + step(linearised(point, pixels, cameras)[0], pixels.ravel())


def measured_with_the_other_sign(point, pixels, cameras):
    return point - step(linearised(point, pixels, cameras)[0], pixels.ravel())


def projected_for_residuals(point, pixels, cameras):
    J, r = linearised(point, pixels, cameras)
    return point + step(J, r + pixels.ravel())


def matrix_not_inverted(point, pixels, cameras):
    J, r = linearised(point, pixels, cameras)
    return point - J.T @ J @ (J.T @ r)


def pixels_not_divided(point, pixels, cameras):
    J, r = [], []
    for pixel, P in zip(pixels, cameras, strict=True):
        a = P @ np.append(point, 1)
        J.extend((P[:2, :3] - a[:2, None] * P[2, :3]) / a[2])
        r.extend(a[:2] - pixel)
    return point + step(np.array(J), np.array(r))


def downhill_only(point, pixels, cameras):
    J, r = linearised(point, pixels, cameras)
    return point - J.T @ r


def four_columns(point, pixels, cameras):
    rows = []
    for P in cameras:
        a = P @ np.append(point, 1)
        rows.extend((P[:2] - (a[:2] / a[2])[:, None] * P[2]) / a[2])
    return point + step(np.array(rows), linearised(point, pixels, cameras)[1])


def until_nothing_moves(point, pixels, cameras):
    for _ in range(10):
        point = point + step(*linearised(point, pixels, cameras))
    return point


def two_steps(point, pixels, cameras):
    point = point + step(*linearised(point, pixels, cameras))
    return point + step(*linearised(point, pixels, cameras))


def equations_of_u(point, pixels, cameras):
    J, r = linearised(point, pixels, cameras)
    return point + step(J[::2], r[::2])


def first_camera(point, pixels, cameras):
    return point + step(*linearised(point, pixels[:1], cameras[:1]))


def last_camera(point, pixels, cameras):
    return point + step(*linearised(point, pixels[-1:], cameras[-1:]))


def two_cameras_of_all(point, pixels, cameras):
    return point + step(*linearised(point, pixels[:2], cameras[:2]))


def order_of_rows_mixed(point, pixels, cameras):
    J, r = linearised(point, pixels, cameras)
    return point + step(J, r.reshape(-1, 2).T.ravel())


def all_that_lstsq_gives(point, pixels, cameras):
    J, r = linearised(point, pixels, cameras)
    return point + np.linalg.lstsq(J, -r, rcond=None)
