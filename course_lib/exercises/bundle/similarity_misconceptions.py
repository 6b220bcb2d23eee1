"""Wrong answers to the exercises of chapter 10 on circles of pictures and on orientation."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

# --- pictures_for_circle ----------------------------------------------------------------------


def rounded_down(step):
    return int(2 * np.pi / step + 1e-9)


def rounded_down_without_care(step):
    return math.floor(2 * np.pi / step)


def rounded_to_the_nearest(step):
    return round(2 * np.pi / step)


def not_rounded(step):
    return 2 * np.pi / step


def degrees_of_a_circle(step):
    return math.ceil(360 / step)


def degrees_for_radians(step):
    return math.ceil(360 / np.radians(step))


def half_a_circle(step):
    return math.ceil(np.pi / step - 1e-9)


def one_more(step):
    return math.ceil(2 * np.pi / step - 1e-9) + 1


def down_and_one_more(step):
    return int(2 * np.pi / step) + 1


def one_less(step):
    return math.ceil(2 * np.pi / step - 1e-9) - 1


def rounding_asks_for_one_more(step):
    return math.ceil(2 * np.pi / step)


def upside_down(step):
    return math.ceil(step / (2 * np.pi))


# --- similarity_transform ---------------------------------------------------------------------


def parts(points: Any, targets: Any) -> Any:
    """Return the means, what is left of points and targets, and the SVD of M."""
    middle, goal = points.mean(axis=0), targets.mean(axis=0)
    x, y = points - middle, targets - goal
    return middle, goal, x, y, *np.linalg.svd(y.T @ x)


def right(points: Any, targets: Any) -> Any:
    """Return the right answer."""
    middle, goal, x, _, U, S, Vt = parts(points, targets)
    signs = np.array([1, 1, np.sign(np.linalg.det(U @ Vt))])
    R, scale = (U * signs) @ Vt, (S * signs).sum() / (x**2).sum()
    return scale, R, goal - scale * R @ middle


def laid(points: Any, targets: Any, scale: Any, R: Any) -> Any:
    """Return an answer that brings the mean to the mean."""
    return scale, R, targets.mean(axis=0) - scale * R @ points.mean(axis=0)


def reflection_returned(points, targets):
    _, _, x, _, U, S, Vt = parts(points, targets)
    return laid(points, targets, S.sum() / (x**2).sum(), U @ Vt)


def scale_of_the_reflection(points, targets):
    _, _, x, _, _, S, _ = parts(points, targets)
    return laid(points, targets, S.sum() / (x**2).sum(), right(points, targets)[1])


def whole_matrix_turned(points, targets):
    _, _, x, _, U, S, Vt = parts(points, targets)
    R = U @ Vt
    return laid(points, targets, S.sum() / (x**2).sum(), R * np.sign(np.linalg.det(R)))


def first_column_turned(points, targets):
    _, _, x, _, U, S, Vt = parts(points, targets)
    signs = np.array([np.sign(np.linalg.det(U @ Vt)), 1, 1])
    return laid(points, targets, (S * signs).sum() / (x**2).sum(), (U * signs) @ Vt)


def row_of_U_turned(points, targets):
    _, _, x, _, U, S, Vt = parts(points, targets)
    signs = np.array([1, 1, np.sign(np.linalg.det(U @ Vt))])
    return laid(points, targets, (S * signs).sum() / (x**2).sum(), (U.T * signs).T @ Vt)


def scale_from_one_distance(points, targets):
    scale = np.linalg.norm(targets[1] - targets[0]) / np.linalg.norm(points[1] - points[0])
    return laid(points, targets, scale, right(points, targets)[1])


def scale_from_the_last_distance(points, targets):
    scale = np.linalg.norm(targets[-1] - targets[0]) / np.linalg.norm(points[-1] - points[0])
    return laid(points, targets, scale, right(points, targets)[1])


def scale_of_the_spreads(points, targets):
    _, _, x, y, *_ = parts(points, targets)
    scale = np.linalg.norm(y) / np.linalg.norm(x)
    return laid(points, targets, scale, right(points, targets)[1])


def divided_by_the_targets(points, targets):
    _, _, x, y, *_ = parts(points, targets)
    scale, R, _ = right(points, targets)
    return laid(points, targets, scale * (x**2).sum() / (y**2).sum(), R)


def scale_upside_down(points, targets):
    scale, R, _ = right(points, targets)
    return laid(points, targets, 1 / scale, R)


def mean_of_the_lengths(points, targets):
    _, _, x, *_ = parts(points, targets)
    scale, R, _ = right(points, targets)
    return laid(points, targets, scale * len(x), R)


def mean_of_all_coordinates(points, targets):
    _, _, x, *_ = parts(points, targets)
    scale, R, _ = right(points, targets)
    return laid(points, targets, scale * x.size, R)


def lengths_not_squared(points, targets):
    _, _, x, *_ = parts(points, targets)
    scale, R, _ = right(points, targets)
    lengths = np.linalg.norm(x, axis=1).sum()
    return laid(points, targets, scale * (x**2).sum() / lengths, R)


def root_of_the_squares(points, targets):
    _, _, x, *_ = parts(points, targets)
    scale, R, _ = right(points, targets)
    return laid(points, targets, scale * np.linalg.norm(x), R)


def scale_left_out(points, targets):
    return laid(points, targets, 1.0, right(points, targets)[1])


def world_to_model(points, targets):
    return right(targets, points)


def M_transposed(points, targets):
    scale, R, _ = right(points, targets)
    return laid(points, targets, scale, R.T)


def last_factor_transposed(points, targets):
    _, _, x, _, U, S, Vt = parts(points, targets)
    signs = np.array([1, 1, np.sign(np.linalg.det(U @ Vt.T))])
    return laid(points, targets, (S * signs).sum() / (x**2).sum(), (U * signs) @ Vt.T)


def last_factor_transposed_unguarded(points, targets):
    _, _, x, _, U, S, Vt = parts(points, targets)
    return laid(points, targets, S.sum() / (x**2).sum(), U @ Vt.T)


def means_left_on(points, targets):
    U, S, Vt = np.linalg.svd(targets.T @ points)
    signs = np.array([1, 1, np.sign(np.linalg.det(U @ Vt))])
    return laid(points, targets, (S * signs).sum() / (points**2).sum(), (U * signs) @ Vt)


def means_left_on_unguarded(points, targets):
    U, S, Vt = np.linalg.svd(targets.T @ points)
    return laid(points, targets, S.sum() / (points**2).sum(), U @ Vt)


def mean_of_all_numbers(points, targets):
    middle, goal = points.mean(), targets.mean()
    x, y = points - middle, targets - goal
    U, S, Vt = np.linalg.svd(y.T @ x)
    signs = np.array([1, 1, np.sign(np.linalg.det(U @ Vt))])
    R, scale = (U * signs) @ Vt, (S * signs).sum() / (x**2).sum()
    return scale, R, goal - scale * R @ np.full(3, middle)


def move_without_turn(points, targets):
    scale, R, _ = right(points, targets)
    return scale, R, targets.mean(axis=0) - scale * points.mean(axis=0)


def move_without_scale(points, targets):
    scale, R, _ = right(points, targets)
    return scale, R, targets.mean(axis=0) - R @ points.mean(axis=0)


def move_between_the_means(points, targets):
    scale, R, _ = right(points, targets)
    return scale, R, targets.mean(axis=0) - points.mean(axis=0)


def move_turned_from_the_right(points, targets):
    scale, R, _ = right(points, targets)
    return scale, R, targets.mean(axis=0) - scale * points.mean(axis=0) @ R


def move_the_other_way(points, targets):
    scale, R, t = right(points, targets)
    return scale, R, -t


def in_another_order(points, targets):
    scale, R, t = right(points, targets)
    return R, t, scale


def scale_at_the_end_of_R(points, targets):
    scale, R, t = right(points, targets)
    return scale, scale * R, t


# --- check_point_rmse -------------------------------------------------------------------------


def roots(squares: Any) -> Any:
    """Return the errors along the axes and in space, from their squares."""
    return np.sqrt(np.append(squares, np.sum(squares)))


def mean_of_sizes(estimated, surveyed):
    off = estimated - surveyed
    return np.append(np.abs(off).mean(axis=0), np.linalg.norm(off, axis=1).mean())


def mean_of_differences(estimated, surveyed):
    off = (estimated - surveyed).mean(axis=0)
    return np.append(off, np.linalg.norm(off))


def root_left_out(estimated, surveyed):
    squares = ((estimated - surveyed) ** 2).mean(axis=0)
    return np.append(squares, squares.sum())


def deviations_from_the_mean(estimated, surveyed):
    return roots((estimated - surveyed).var(axis=0))


def divided_by_one_less(estimated, surveyed):
    squares = ((estimated - surveyed) ** 2).sum(axis=0)
    return roots(squares / (len(estimated) - 1))


def sum_not_divided(estimated, surveyed):
    return roots(((estimated - surveyed) ** 2).sum(axis=0))


def divided_outside_of_the_root(estimated, surveyed):
    return roots(((estimated - surveyed) ** 2).sum(axis=0)) / len(estimated)


def over_all_coordinates(estimated, surveyed):
    squares = (estimated - surveyed) ** 2
    return np.sqrt(np.append(squares.mean(axis=0), squares.mean()))


def mean_of_the_axes(estimated, surveyed):
    axes = np.sqrt(((estimated - surveyed) ** 2).mean(axis=0))
    return np.append(axes, axes.mean())


def sum_of_the_axes(estimated, surveyed):
    axes = np.sqrt(((estimated - surveyed) ** 2).mean(axis=0))
    return np.append(axes, axes.sum())


def mean_distance(estimated, surveyed):
    off = estimated - surveyed
    axes = np.sqrt((off**2).mean(axis=0))
    return np.append(axes, np.linalg.norm(off, axis=1).mean())


def horizontal_for_space(estimated, surveyed):
    axes = np.sqrt(((estimated - surveyed) ** 2).mean(axis=0))
    return np.append(axes, np.hypot(axes[0], axes[1]))


def axes_only(estimated, surveyed):
    return np.sqrt(((estimated - surveyed) ** 2).mean(axis=0))


def space_only(estimated, surveyed):
    return np.sqrt(((estimated - surveyed) ** 2).sum(axis=1).mean())


def all_coordinates_only(estimated, surveyed):
    return np.sqrt(((estimated - surveyed) ** 2).mean())


def of_each_point(estimated, surveyed):
    return np.sqrt(((estimated - surveyed) ** 2).mean(axis=1))


def distance_of_each_point(estimated, surveyed):
    return np.linalg.norm(estimated - surveyed, axis=1)


def largest_errors(estimated, surveyed):
    off = np.abs(estimated - surveyed)
    return np.append(off.max(axis=0), np.linalg.norm(off, axis=1).max())


def places_for_errors(estimated, surveyed):
    return roots((estimated**2).mean(axis=0))
