"""Wrong answers to the exercise of chapter 09 on the covariance of a point."""

from __future__ import annotations

from typing import Any

import numpy as np


def derivatives(point: Any, cameras: Any) -> Any:
    """Return the right J."""
    a = cameras[:, :, :3] @ point + cameras[:, :, 3]
    seen = a[:, :2] / a[:, 2:]
    J = (cameras[:, :2, :3] - seen[..., None] * cameras[:, 2:, :3]) / a[:, 2:, None]
    return J.reshape(-1, 3)


def inverted(J: Any) -> Any:
    return np.linalg.inv(J.T @ J)


def sigma_not_squared(point, cameras, sigma):
    return sigma * inverted(derivatives(point, cameras))


def sigma_left_out(point, cameras, sigma):
    return inverted(derivatives(point, cameras))


def divided_by_sigma(point, cameras, sigma):
    return inverted(derivatives(point, cameras)) / sigma**2


def not_inverted(point, cameras, sigma):
    J = derivatives(point, cameras)
    return sigma**2 * J.T @ J


def not_inverted_but_divided(point, cameras, sigma):
    J = derivatives(point, cameras)
    return J.T @ J / sigma**2


def rows_for_unknowns(point, cameras, sigma):
    J = derivatives(point, cameras)
    return sigma**2 * np.linalg.inv(J @ J.T)


def inverted_entry_by_entry(point, cameras, sigma):
    J = derivatives(point, cameras)
    return sigma**2 / (J.T @ J)


def roots_of_the_diagonal(point, cameras, sigma):
    return np.sqrt(np.diag(sigma**2 * inverted(derivatives(point, cameras))))


def variances_only(point, cameras, sigma):
    return np.diag(sigma**2 * inverted(derivatives(point, cameras)))


def roots_of_all(point, cameras, sigma):
    return np.sqrt(np.abs(sigma**2 * inverted(derivatives(point, cameras))))


def diagonal_only(point, cameras, sigma):
    return np.diag(np.diag(sigma**2 * inverted(derivatives(point, cameras))))


def each_axis_alone(point, cameras, sigma):
    J = derivatives(point, cameras)
    return sigma**2 * np.diag(1 / np.diag(J.T @ J))


def divided_by_rows(point, cameras, sigma):
    J = derivatives(point, cameras)
    return sigma**2 * inverted(J) / len(J)


def divided_by_cameras(point, cameras, sigma):
    return sigma**2 * inverted(derivatives(point, cameras)) / len(cameras)


def divided_by_freedom(point, cameras, sigma):
    J = derivatives(point, cameras)
    return sigma**2 * inverted(J) / (len(J) - 3)


def first_two_cameras(point, cameras, sigma):
    return sigma**2 * inverted(derivatives(point, cameras[:2]))


def last_camera_only(point, cameras, sigma):
    return sigma**2 * inverted(derivatives(point, cameras[-1:]))


def equations_of_u(point, cameras, sigma):
    return sigma**2 * inverted(derivatives(point, cameras)[::2])


def last_column_left_out(point, cameras, sigma):
    rows = []
    for P in cameras:
        a = P[:, :3] @ point
        rows.extend((P[:2, :3] - (a[:2] / a[2])[:, None] * P[2, :3]) / a[2])
    return sigma**2 * inverted(np.array(rows))


def first_row_for_v(point, cameras, sigma):
    rows = []
    for P in cameras:
        a = P @ np.append(point, 1)
        rows.extend((P[0, :3] - (a[:2] / a[2])[:, None] * P[2, :3]) / a[2])
    return sigma**2 * inverted(np.array(rows))


def depth_left_out_of_J(point, cameras, sigma):
    rows = []
    for P in cameras:
        a = P @ np.append(point, 1)
        rows.extend(P[:2, :3] - (a[:2] / a[2])[:, None] * P[2, :3])
    return sigma**2 * inverted(np.array(rows))


def depth_taken_for_constant(point, cameras, sigma):
    rows = []
    for P in cameras:
        rows.extend(P[:2, :3] / (P[2] @ np.append(point, 1)))
    return sigma**2 * inverted(np.array(rows))


def sign_in_the_derivative(point, cameras, sigma):
    rows = []
    for P in cameras:
        a = P @ np.append(point, 1)
        rows.extend((P[:2, :3] + (a[:2] / a[2])[:, None] * P[2, :3]) / a[2])
    return sigma**2 * inverted(np.array(rows))


def only_one_term_divided(point, cameras, sigma):
    rows = []
    for P in cameras:
        a = P @ np.append(point, 1)
        rows.extend(P[:2, :3] - (a[:2] / a[2])[:, None] * P[2, :3] / a[2])
    return sigma**2 * inverted(np.array(rows))


def pixels_not_divided(point, cameras, sigma):
    rows = []
    for P in cameras:
        a = P @ np.append(point, 1)
        rows.extend((P[:2, :3] - a[:2, None] * P[2, :3]) / a[2])
    return sigma**2 * inverted(np.array(rows))


def same_pixel_in_both_rows(point, cameras, sigma):
    rows = []
    for P in cameras:
        a = P @ np.append(point, 1)
        rows.extend((P[:2, :3] - a[0] / a[2] * P[2, :3]) / a[2])
    return sigma**2 * inverted(np.array(rows))


def four_columns(point, cameras, sigma):
    rows = []
    for P in cameras:
        a = P @ np.append(point, 1)
        rows.extend((P[:2] - (a[:2] / a[2])[:, None] * P[2]) / a[2])
    return sigma**2 * inverted(np.array(rows))


def sigma_counted_twice(point, cameras, sigma):
    return 2 * sigma**2 * inverted(derivatives(point, cameras))


def twice_sigma_squared(point, cameras, sigma):
    return (2 * sigma) ** 2 * inverted(derivatives(point, cameras))
