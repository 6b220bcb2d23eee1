"""Wrong answers to the exercises of chapter 06 on one unknown, lines and affine maps."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- solve_one_unknown ------------------------------------------------------------------------


def mean_of_the_single_answers(a, b):
    return np.mean(b / a)


def sums_divided(a, b):
    return np.sum(b) / np.sum(a)


def middle_of_the_single_answers(a, b):
    return np.median(b / a)


def product_of_sums(a, b):
    return np.sum(a) * np.sum(b) / np.sum(a**2)


def square_of_the_sum(a, b):
    return a @ b / np.sum(a) ** 2


def first_equation_only(a, b):
    return b[0] / a[0]


def lengths_divided(a, b):
    return np.linalg.norm(b) / np.linalg.norm(a)


def not_divided(a, b):
    return a @ b


def divided_by_the_length(a, b):
    return a @ b / np.linalg.norm(a)


def divided_by_the_sum(a, b):
    return a @ b / np.sum(a)


def divided_by_the_number(a, b):
    return a @ b / len(a)


def divided_by_29(a, b):
    return a @ b / 29


def divided_by_b(a, b):
    return b @ b / (a @ b)


def upside_down(a, b):
    return a @ a / (a @ b)


def bracket_forgotten(a, b):
    return a @ b / a @ a


def an_answer_for_each_equation(a, b):
    return b / a


def products_not_added(a, b):
    return a * b / a * a


def squares_not_added(a, b):
    return a @ b / a**2


# --- fit_line ---------------------------------------------------------------------------------


def _line(x: Any, y: Any) -> Any:
    slope = np.sum((x - x.mean()) * (y - y.mean())) / np.sum((x - x.mean()) ** 2)
    return slope, y.mean() - slope * x.mean()


def intercept_before_slope(x, y):
    slope, intercept = _line(x, y)
    return intercept, slope


def errors_in_x(x, y):
    slope, intercept = _line(y, x)
    return 1 / slope, -intercept / slope


def x_and_y_exchanged(x, y):
    return _line(y, x)


def across_the_line(x, y):
    centred = np.column_stack([x - x.mean(), y - y.mean()])
    along = np.linalg.svd(centred)[2][0]
    slope = along[1] / along[0]
    return slope, y.mean() - slope * x.mean()


def through_the_origin(x, y):
    return x @ y / (x @ x), 0.0


def two_points_only(x, y):
    slope = (y[-1] - y[0]) / (x[-1] - x[0])
    return slope, y[0] - slope * x[0]


def outermost_points(x, y):
    first, last = np.argmin(x), np.argmax(x)
    slope = (y[last] - y[first]) / (x[last] - x[first])
    return slope, y[first] - slope * x[first]


def extremes_of_both(x, y):
    slope = (y.max() - y.min()) / (x.max() - x.min())
    return slope, y.mean() - slope * x.mean()


def first_two_points(x, y):
    slope = (y[1] - y[0]) / (x[1] - x[0])
    return slope, y[0] - slope * x[0]


def first_y_as_intercept(x, y):
    return _line(x, y)[0], y[0]


def mean_y_as_intercept(x, y):
    return _line(x, y)[0], y.mean()


def mean_of_slopes(x, y):
    slope = np.mean(np.diff(y) / np.diff(x))
    return slope, y.mean() - slope * x.mean()


def one_more_counted(x, y):
    slope = np.cov(x, y)[0, 1] / np.var(x)
    return slope, y.mean() - slope * x.mean()


def inverse_of_a_tall_matrix(x, y):
    A = np.column_stack([x, np.ones(len(x))])
    slope, intercept = np.linalg.inv(A) @ y
    return slope, intercept


def all_that_lstsq_returns(x, y):
    return np.linalg.lstsq(np.column_stack([x, np.ones(len(x))]), y)


def lstsq_into_two_names(x, y):
    slope, intercept = np.linalg.lstsq(np.column_stack([x, np.ones(len(x))]), y)
    return slope, intercept


def slope_of_a_fit_through_the_origin(x, y):
    slope = x @ y / (x @ x)
    return slope, np.mean(y - slope * x)


# --- fit_affine -------------------------------------------------------------------------------


def _solved(X: Any, targets: Any) -> Any:
    return np.linalg.lstsq(X, targets)[0].T


def _with_ones(points: Any) -> Any:
    return np.column_stack([points, np.ones(len(points))])


def left_transposed(points, targets):
    return _solved(_with_ones(points), targets).T


def way_back(points, targets):
    return _solved(_with_ones(targets), points)


def ones_in_front(points, targets):
    return _solved(np.column_stack([np.ones(len(points)), points]), targets)


def first_three_points(points, targets):
    return _solved(_with_ones(points[:3]), targets[:3])


def inverse_of_a_table(points, targets):
    return (np.linalg.inv(_with_ones(points)) @ targets).T


def no_translation(points, targets):
    return _solved(points, targets)


def column_of_zeros(points, targets):
    return _solved(np.column_stack([points, np.zeros(len(points))]), targets)


def _with_two_ones(points: Any) -> Any:
    return np.column_stack([points, np.ones_like(points)])


def two_columns_of_ones(points, targets):
    return _solved(_with_two_ones(points), targets)


def two_columns_of_ones_left_transposed(points, targets):
    return _solved(_with_two_ones(points), targets).T


def two_columns_of_ones_in_normal_equations(points, targets):
    X = _with_two_ones(points)
    return (np.linalg.inv(X.T @ X) @ X.T @ targets).T


def lstsq_transposed_at_once(points, targets):
    found: Any = np.linalg.lstsq(_with_ones(points), targets)
    return found.T


def all_that_lstsq_returns_for_a_map(points, targets):
    return np.linalg.lstsq(_with_ones(points), targets)


def reshaped_for_transposed(points, targets):
    return _solved(_with_ones(points), targets).T.reshape(2, 3)


def _from_the_mean(points: Any, targets: Any) -> Any:
    return _solved(points - points.mean(axis=0), targets - targets.mean(axis=0))


def counted_from_the_mean(points, targets):
    return np.column_stack([_from_the_mean(points, targets), targets.mean(axis=0)])


def difference_of_the_means(points, targets):
    shift = targets.mean(axis=0) - points.mean(axis=0)
    return np.column_stack([_from_the_mean(points, targets), shift])


def translation_from_the_means(points, targets):
    linear = _solved(points, targets)
    return np.column_stack([linear, (targets - points @ linear.T).mean(axis=0)])


def rows_exchanged(points, targets):
    return _solved(_with_ones(points), targets)[::-1]


def coordinates_exchanged(points, targets):
    return _solved(_with_ones(points[:, ::-1]), targets)


def square_matrix(points, targets):
    return np.vstack([_solved(_with_ones(points), targets), [0, 0, 1]])


def shift_and_scale_only(points, targets):
    out = np.zeros((2, 3))
    for i in range(2):
        slope, intercept = _line(points[:, i], targets[:, i])
        out[i, i], out[i, 2] = slope, intercept
    return out


def same_row_twice(points, targets):
    return _solved(_with_ones(points), targets)[[0, 0]]


def pseudo_inverse_without_the_last_factor(points, targets):
    X = _with_ones(points)
    return (X.T @ targets).T
