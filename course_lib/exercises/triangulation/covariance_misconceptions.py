"""Wrong answers to the exercise of chapter 09 on the covariance of a point."""

from __future__ import annotations

from typing import Any

import numpy as np


def derivatives(X: Any, cameras: Any) -> Any:
    """Return the right J."""
    rows = []
    for P in cameras:
        a = P @ np.append(X, 1)
        rows.extend((P[:2, :3] - (a[:2] / a[2])[:, None] * P[2, :3]) / a[2])
    return np.array(rows)


def inverted(J: Any) -> Any:
    return np.linalg.inv(J.T @ J)


def sigma_not_squared(X, cameras, sigma):
    return sigma * inverted(derivatives(X, cameras))


def sigma_left_out(X, cameras, sigma):
    return inverted(derivatives(X, cameras))


def divided_by_sigma(X, cameras, sigma):
    return inverted(derivatives(X, cameras)) / sigma**2


def not_inverted(X, cameras, sigma):
    J = derivatives(X, cameras)
    return sigma**2 * J.T @ J


def not_inverted_but_divided(X, cameras, sigma):
    J = derivatives(X, cameras)
    return J.T @ J / sigma**2


def rows_for_unknowns(X, cameras, sigma):
    J = derivatives(X, cameras)
    return sigma**2 * np.linalg.inv(J @ J.T)


def inverted_entry_by_entry(X, cameras, sigma):
    J = derivatives(X, cameras)
    return sigma**2 / (J.T @ J)


def roots_of_the_diagonal(X, cameras, sigma):
    return np.sqrt(np.diag(sigma**2 * inverted(derivatives(X, cameras))))


def variances_only(X, cameras, sigma):
    return np.diag(sigma**2 * inverted(derivatives(X, cameras)))


def roots_of_all(X, cameras, sigma):
    return np.sqrt(np.abs(sigma**2 * inverted(derivatives(X, cameras))))


def diagonal_only(X, cameras, sigma):
    return np.diag(np.diag(sigma**2 * inverted(derivatives(X, cameras))))


def each_axis_alone(X, cameras, sigma):
    J = derivatives(X, cameras)
    return sigma**2 * np.diag(1 / np.diag(J.T @ J))


def divided_by_rows(X, cameras, sigma):
    J = derivatives(X, cameras)
    return sigma**2 * inverted(J) / len(J)


def divided_by_cameras(X, cameras, sigma):
    return sigma**2 * inverted(derivatives(X, cameras)) / len(cameras)


def divided_by_freedom(X, cameras, sigma):
    J = derivatives(X, cameras)
    return sigma**2 * inverted(J) / (len(J) - 3)


def first_two_cameras(X, cameras, sigma):
    return sigma**2 * inverted(derivatives(X, cameras[:2]))


def last_camera_only(X, cameras, sigma):
    return sigma**2 * inverted(derivatives(X, cameras[-1:]))


def equations_of_u(X, cameras, sigma):
    return sigma**2 * inverted(derivatives(X, cameras)[::2])


def last_column_left_out(X, cameras, sigma):
    rows = []
    for P in cameras:
        a = P[:, :3] @ X
        rows.extend((P[:2, :3] - (a[:2] / a[2])[:, None] * P[2, :3]) / a[2])
    return sigma**2 * inverted(np.array(rows))


def first_row_for_v(X, cameras, sigma):
    rows = []
    for P in cameras:
        a = P @ np.append(X, 1)
        rows.extend((P[0, :3] - (a[:2] / a[2])[:, None] * P[2, :3]) / a[2])
    return sigma**2 * inverted(np.array(rows))


def depth_left_out_of_J(X, cameras, sigma):
    rows = []
    for P in cameras:
        a = P @ np.append(X, 1)
        rows.extend(P[:2, :3] - (a[:2] / a[2])[:, None] * P[2, :3])
    return sigma**2 * inverted(np.array(rows))


def depth_taken_for_constant(X, cameras, sigma):
    rows = []
    for P in cameras:
        rows.extend(P[:2, :3] / (P[2] @ np.append(X, 1)))
    return sigma**2 * inverted(np.array(rows))


def sign_in_the_derivative(X, cameras, sigma):
    rows = []
    for P in cameras:
        a = P @ np.append(X, 1)
        rows.extend((P[:2, :3] + (a[:2] / a[2])[:, None] * P[2, :3]) / a[2])
    return sigma**2 * inverted(np.array(rows))


def only_one_term_divided(X, cameras, sigma):
    rows = []
    for P in cameras:
        a = P @ np.append(X, 1)
        rows.extend(P[:2, :3] - (a[:2] / a[2])[:, None] * P[2, :3] / a[2])
    return sigma**2 * inverted(np.array(rows))


def pixels_not_divided(X, cameras, sigma):
    rows = []
    for P in cameras:
        a = P @ np.append(X, 1)
        rows.extend((P[:2, :3] - a[:2, None] * P[2, :3]) / a[2])
    return sigma**2 * inverted(np.array(rows))


def same_pixel_in_both_rows(X, cameras, sigma):
    rows = []
    for P in cameras:
        a = P @ np.append(X, 1)
        rows.extend((P[:2, :3] - a[0] / a[2] * P[2, :3]) / a[2])
    return sigma**2 * inverted(np.array(rows))


def four_columns(X, cameras, sigma):
    rows = []
    for P in cameras:
        a = P @ np.append(X, 1)
        rows.extend((P[:2] - (a[:2] / a[2])[:, None] * P[2]) / a[2])
    return sigma**2 * inverted(np.array(rows))
