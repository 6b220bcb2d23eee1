"""Wrong answers to the exercises of chapter 07 on residuals and the refinement."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- reprojection_residuals -------------------------------------------------------------------


def pixels_of(points: Any, K: Any, R: Any, t: Any, k: Any) -> Any:
    """Return the pixels, rightly."""
    X = points @ R.T + t
    return bent(X[:, :2] / X[:, 2:], k) @ K[:2, :2].T + K[:2, 2]


def bent(x: Any, k: Any) -> Any:
    r2 = (x**2).sum(axis=1, keepdims=True)
    return x * (1 + k[0] * r2 + k[1] * r2**2)


def observed_minus_projected(points, pixels, K, R, t, k):
    return pixels - pixels_of(points, K, R, t, k)


def distortion_left_out(points, pixels, K, R, t, k):
    return pixels_of(points, K, R, t, [0, 0]) - pixels


def radius_not_squared(points, pixels, K, R, t, k):
    X = points @ R.T + t
    x = X[:, :2] / X[:, 2:]
    r = np.hypot(*x.T)[:, None]
    return x * (1 + k[0] * r + k[1] * r**2) @ K[:2, :2].T + K[:2, 2] - pixels


def square_for_fourth_power(points, pixels, K, R, t, k):
    return pixels_of(points, K, R, t, [k[0] + k[1], 0]) - pixels


def sixth_power_for_fourth(points, pixels, K, R, t, k):
    X = points @ R.T + t
    x = X[:, :2] / X[:, 2:]
    r2 = (x**2).sum(axis=1, keepdims=True)
    return x * (1 + k[0] * r2 + k[1] * r2**3) @ K[:2, :2].T + K[:2, 2] - pixels


def divided_by_distortion(points, pixels, K, R, t, k):
    X = points @ R.T + t
    x = X[:, :2] / X[:, 2:]
    r2 = (x**2).sum(axis=1, keepdims=True)
    return x / (1 + k[0] * r2 + k[1] * r2**2) @ K[:2, :2].T + K[:2, 2] - pixels


def not_divided_by_depth(points, pixels, K, R, t, k):
    X = points @ R.T + t
    return bent(X[:, :2], k) @ K[:2, :2].T + K[:2, 2] - pixels


def not_divided_after_K(points, pixels, K, R, t, k):
    return ((points @ R.T + t) @ K.T)[:, :2] - pixels


def radius_in_pixels(points, pixels, K, R, t, k):
    return with_radius_of(pixels_of(points, K, R, t, [0, 0]), points, K, R, t, k) - pixels


def radius_in_pixels_from_the_centre(points, pixels, K, R, t, k):
    seen = pixels_of(points, K, R, t, [0, 0]) - K[:2, 2]
    return with_radius_of(seen, points, K, R, t, k) - pixels


def with_radius_of(far: Any, points: Any, K: Any, R: Any, t: Any, k: Any) -> Any:
    """Return pixels whose distortion is taken at the distances of other points from zero."""
    r2 = (far**2).sum(axis=1, keepdims=True)
    offset = pixels_of(points, K, R, t, [0, 0]) - K[:2, 2]
    return offset * (1 + k[0] * r2 + k[1] * r2**2) + K[:2, 2]


def radius_of_the_observed(points, pixels, K, R, t, k):
    seen = (pixels - K[:2, 2]) / [K[0, 0], K[1, 1]]
    return with_radius_of(seen, points, K, R, t, k) - pixels


def one_left_out(points, pixels, K, R, t, k):
    offset = pixels_of(points, K, R, t, k) - pixels_of(points, K, R, t, [0, 0])
    return offset + K[:2, 2] - pixels


def radius_before_depth(points, pixels, K, R, t, k):
    return with_radius_of((points @ R.T + t)[:, :2], points, K, R, t, k) - pixels


def fx_for_v(points, pixels, K, R, t, k):
    X = points @ R.T + t
    return bent(X[:, :2] / X[:, 2:], k) * K[0, 0] + K[:2, 2] - pixels


def projected_only(points, pixels, K, R, t, k):
    return pixels_of(points, K, R, t, k)


def sign_lost(points, pixels, K, R, t, k):
    return np.abs(pixels_of(points, K, R, t, k) - pixels)


def squared_already(points, pixels, K, R, t, k):
    return (pixels_of(points, K, R, t, k) - pixels) ** 2


def pixels_distorted(points, pixels, K, R, t, k):
    X = points @ R.T + t
    return bent(X[:, :2] / X[:, 2:] @ K[:2, :2].T + K[:2, 2], k) - pixels


def distortion_backwards(points, pixels, K, R, t, k):
    return pixels_of(points, K, R, t, -np.asarray(k)) - pixels


def rotation_transposed(points, pixels, K, R, t, k):
    return pixels_of(points, K, R.T, t, k) - pixels


def moved_before_turned(points, pixels, K, R, t, k):
    return pixels_of(points + t, K, R, np.zeros(3), k) - pixels


def translation_left_out(points, pixels, K, R, t, k):
    return pixels_of(points, K, R, np.zeros(3), k) - pixels


def v_before_u(points, pixels, K, R, t, k):
    return pixels_of(points, K, R, t, k)[:, ::-1] - pixels


def principal_point_swapped(points, pixels, K, R, t, k):
    return pixels_of(points, K, R, t, k) - K[:2, 2] + K[:2, 2][::-1] - pixels


def still_normalised(points, pixels, K, R, t, k):
    X = points @ R.T + t
    return bent(X[:, :2] / X[:, 2:], k) - pixels


def only_moved_to_the_centre(points, pixels, K, R, t, k):
    X = points @ R.T + t
    return bent(X[:, :2] / X[:, 2:], k) + K[:2, 2] - pixels


def all_in_one_row(points, pixels, K, R, t, k):
    return (pixels_of(points, K, R, t, k) - pixels).ravel()


def columns_for_rows(points, pixels, K, R, t, k):
    return (pixels_of(points, K, R, t, k) - pixels).T


def half_a_pixel_off(points, pixels, K, R, t, k):
    return pixels_of(points, K, R, t, k) + 0.5 - pixels


def half_a_pixel_back(points, pixels, K, R, t, k):
    return pixels_of(points, K, R, t, k) - 0.5 - pixels


def principal_point_left_out(points, pixels, K, R, t, k):
    return pixels_of(points, K, R, t, k) - K[:2, 2] - pixels


def lengths_of_residuals(points, pixels, K, R, t, k):
    return np.linalg.norm(pixels_of(points, K, R, t, k) - pixels, axis=1)


# --- rms_error --------------------------------------------------------------------------------


def over_coordinates(residuals):
    return np.sqrt((residuals**2).mean())


def mean_length(residuals):
    return np.hypot(*residuals.T).mean()


def root_left_out(residuals):
    return (residuals**2).sum(axis=1).mean()


def largest_error(residuals):
    return np.hypot(*residuals.T).max()


def length_of_the_mean(residuals):
    return np.hypot(*residuals.mean(axis=0))


def deviation_from_the_mean(residuals):
    return residuals.std()


def divided_outside_of_the_root(residuals):
    return np.sqrt((residuals**2).sum()) / len(residuals)


def not_divided(residuals):
    return np.sqrt((residuals**2).sum())


def columns_for_points(residuals):
    return np.sqrt((residuals**2).sum(axis=0).mean())


def one_error_for_u_one_for_v(residuals):
    return np.sqrt((residuals**2).mean(axis=0))


def mean_of_u_and_v(residuals):
    return np.sqrt((residuals**2).mean(axis=0)).mean()


def length_of_each(residuals):
    return np.sqrt((residuals**2).sum(axis=1))


def rms_of_each(residuals):
    return np.sqrt((residuals**2).mean(axis=1))


def lengths_of_columns(residuals):
    return np.sqrt((residuals**2).sum(axis=0))


# --- refine_calibration -----------------------------------------------------------------------


def step_with(J: Any, residuals: Any, added: Any) -> Any:
    return np.linalg.solve(J.T @ J + added, -J.T @ residuals)


def marquardt(J: Any, damping: Any) -> Any:
    return damping * np.diag(np.diag(J.T @ J))


def uphill(parameters, residuals, J, damping):
    return parameters - step_with(J, residuals, marquardt(J, damping))


def step_only(parameters, residuals, J, damping):
    return step_with(J, residuals, marquardt(J, damping))


def not_damped(parameters, residuals, J, damping):
    return parameters + step_with(J, residuals, 0)


def ones_on_the_diagonal(parameters, residuals, J, damping):
    return parameters + step_with(J, residuals, damping * np.eye(len(parameters)))


def row_added_to_the_matrix(parameters, residuals, J, damping):
    return parameters + step_with(J, residuals, damping * np.diag(J.T @ J))


def residuals_for_parameters(parameters, residuals, J, damping):
    N = J @ J.T
    return parameters + np.linalg.solve(N + damping * np.diag(np.diag(N)), -J.T @ residuals)


def residuals_for_parameters_undamped(parameters, residuals, J, damping):
    N = J @ J.T
    return parameters + np.linalg.solve(N + damping * np.diag(np.diag(N)), -J @ residuals)


def all_entries_damped(parameters, residuals, J, damping):
    return parameters + step_with(J, residuals, damping * J.T @ J)


def downhill_only(parameters, residuals, J, damping):
    return parameters - J.T @ residuals


def diagonal_only(parameters, residuals, J, damping):
    N = np.diag(np.diag(J.T @ J))
    return parameters + np.linalg.solve((1 + damping) * N, -J.T @ residuals)


def diagonal_of_J(parameters, residuals, J, damping):
    return parameters + step_with(J, residuals, damping * np.diag(J))


def matrix_of_the_diagonal_of_J(parameters, residuals, J, damping):
    return parameters + step_with(J, residuals, damping * np.diag(np.diag(J)))
