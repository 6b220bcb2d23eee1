"""Wrong answers to the exercises of chapter 07 on views to reject and on the covariance."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- reject_views -----------------------------------------------------------------------------


def view_rms(residuals: Any) -> Any:
    return np.sqrt((residuals**2).sum(axis=2).mean(axis=1))


def those_to_reject(residuals, limit):
    rms = view_rms(residuals)
    return rms > limit * np.median(rms)


def mean_for_median(residuals, limit):
    rms = view_rms(residuals)
    return rms <= limit * rms.mean()


def mean_and_deviation(residuals, limit):
    rms = view_rms(residuals)
    return rms <= rms.mean() + limit * rms.std()


def stack(residuals: Any) -> Any:
    """Return what the RMS of one view makes of the whole stack."""
    return np.sqrt((residuals**2).sum(axis=1).mean())


def one_error_for_all(residuals, limit):
    return stack(residuals) <= limit * np.median(stack(residuals))


def each_against_itself(residuals, limit):
    rms = [stack(view) for view in residuals]
    return np.array([value <= limit * np.median(value) for value in rms])


def limit_in_pixels(residuals, limit):
    return view_rms(residuals) <= limit


def compared_with_the_best(residuals, limit):
    rms = view_rms(residuals)
    return rms <= limit * rms.min()


def above_the_median(residuals, limit):
    rms = view_rms(residuals)
    return rms <= np.median(rms)


def mean_length(residuals, limit):
    errors = np.linalg.norm(residuals, axis=2).mean(axis=1)
    return errors <= limit * np.median(errors)


def median_of_residuals(residuals, limit):
    return view_rms(residuals) <= limit * np.median(residuals)


def numbers_of_the_views(residuals, limit):
    rms = view_rms(residuals)
    return np.flatnonzero(rms <= limit * np.median(rms))


def places_from_where(residuals, limit):
    return np.where(view_rms(residuals) <= limit * np.median(view_rms(residuals)))


def numbers_of_those_that_go(residuals, limit):
    rms = view_rms(residuals)
    return np.flatnonzero(rms > limit * np.median(rms))


def residuals_that_stay(residuals, limit):
    rms = view_rms(residuals)
    return residuals[rms <= limit * np.median(rms)]


def squares_compared(residuals, limit):
    squares = view_rms(residuals) ** 2
    return squares <= limit * np.median(squares)


def worst_corner(residuals, limit):
    errors = np.linalg.norm(residuals, axis=2).max(axis=1)
    return errors <= limit * np.median(errors)


def each_point(residuals, limit):
    errors = np.linalg.norm(residuals, axis=2)
    return errors <= limit * np.median(errors)


def point_by_point_over_views(residuals, limit):
    errors = np.sqrt((residuals**2).sum(axis=2).mean(axis=0))
    return errors <= limit * np.median(errors)


def u_and_v_of_each_view(residuals, limit):
    errors = np.sqrt((residuals**2).mean(axis=1))
    return errors <= limit * np.median(errors)


# --- parameter_covariance ---------------------------------------------------------------------


def variance_with(J: Any, residuals: Any, freedom: Any) -> Any:
    return residuals @ residuals / freedom * np.linalg.inv(J.T @ J)


def divided_by_all(J, residuals):
    return variance_with(J, residuals, len(residuals))


def divided_by_all_but_one(J, residuals):
    return variance_with(J, residuals, len(residuals) - 1)


def variance_of_numpy(J, residuals):
    return residuals.var() * np.linalg.inv(J.T @ J)


def not_squared(J, residuals):
    m, n = J.shape
    return residuals.sum() / (m - n) * np.linalg.inv(J.T @ J)


def sum_squared(J, residuals):
    m, n = J.shape
    return residuals.sum() ** 2 / (m - n) * np.linalg.inv(J.T @ J)


def divided_by_points(J, residuals):
    return variance_with(J, residuals, len(residuals) / 2)


def points_without_parameters(J, residuals):
    m, n = J.shape
    return variance_with(J, residuals, m / 2 - n)


def variances_only(J, residuals):
    m, n = J.shape
    return np.diag(np.diag(variance_with(J, residuals, m - n)))


def variances_in_a_row(J, residuals):
    m, n = J.shape
    return np.diag(variance_with(J, residuals, m - n))


def residuals_left_out(J, residuals):
    return np.linalg.inv(J.T @ J)


def deviation_for_variance(J, residuals):
    m, n = J.shape
    return np.sqrt(residuals @ residuals / (m - n)) * np.linalg.inv(J.T @ J)


def not_inverted(J, residuals):
    m, n = J.shape
    return residuals @ residuals / (m - n) * (J.T @ J)


def roots_of_the_diagonal(J, residuals):
    m, n = J.shape
    return np.sqrt(np.diag(variance_with(J, residuals, m - n)))


def diagonal_inverted_only(J, residuals):
    m, n = J.shape
    return residuals @ residuals / (m - n) * np.diag(1 / np.diag(J.T @ J))


def inverted_entry_by_entry(J, residuals):
    m, n = J.shape
    return residuals @ residuals / (m - n) / (J.T @ J)


def rows_for_parameters(J, residuals):
    return variance_with(J, residuals, len(residuals) - len(J))


def more_parameters_than_residuals(J, residuals):
    m, n = J.shape
    return variance_with(J, residuals, n - m)


def residuals_for_parameters(J, residuals):
    m, n = J.shape
    return residuals @ residuals / (m - n) * np.linalg.inv(J @ J.T)
