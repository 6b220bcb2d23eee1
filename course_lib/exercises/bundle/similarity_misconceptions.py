"""Wrong answers to the exercise of chapter 10 on absolute orientation."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib.exercises.bundle.remembering import once


def parts(points: Any, targets: Any) -> Any:
    """Return the means, what is left of points and targets, and the SVD of M."""
    return once(taken_apart, points, targets)


def right(points: Any, targets: Any) -> Any:
    """Return the right answer."""
    return once(laid_rightly, points, targets)


def taken_apart(points: Any, targets: Any) -> Any:
    middle, goal = points.mean(axis=0), targets.mean(axis=0)
    x, y = points - middle, targets - goal
    return middle, goal, x, y, *np.linalg.svd(y.T @ x)


def laid_rightly(points: Any, targets: Any) -> Any:
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


def column_of_R_turned(points, targets):
    _, _, x, _, U, S, Vt = parts(points, targets)
    signs = np.array([1, 1, np.sign(np.linalg.det(U @ Vt))])
    return laid(points, targets, (S * signs).sum() / (x**2).sum(), (U @ Vt) * signs)


def column_of_R_turned_but_not_S(points, targets):
    _, _, x, _, U, S, Vt = parts(points, targets)
    signs = np.array([1, 1, np.sign(np.linalg.det(U @ Vt))])
    return laid(points, targets, S.sum() / (x**2).sum(), (U @ Vt) * signs)


def product_of_all_points(points, targets):
    _, _, x, y, *_ = parts(points, targets)
    U, S, Vt = np.linalg.svd(y @ x.T)
    return laid(points, targets, S.sum() / (x**2).sum(), U @ Vt)


def star_for_matrix_product(points, targets):
    _, _, x, y, *_ = parts(points, targets)
    U, S, Vt = np.linalg.svd(y * x)
    return laid(points, targets, S.sum() / (x**2).sum(), U @ Vt)


def mean_of_S(points, targets):
    scale, R, _ = right(points, targets)
    return laid(points, targets, scale / 3, R)


def mean_of_the_ratios(points, targets):
    _, _, x, y, *_ = parts(points, targets)
    scale = np.mean(np.linalg.norm(y, axis=1) / np.linalg.norm(x, axis=1))
    return laid(points, targets, scale, right(points, targets)[1])


def ratio_of_the_mean_lengths(points, targets):
    _, _, x, y, *_ = parts(points, targets)
    scale = np.linalg.norm(y, axis=1).sum() / np.linalg.norm(x, axis=1).sum()
    return laid(points, targets, scale, right(points, targets)[1])


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


def means_left_on_M(points, targets):
    U, S, Vt = np.linalg.svd(targets.T @ points)
    signs = np.array([1, 1, np.sign(np.linalg.det(U @ Vt))])
    x = points - points.mean(axis=0)
    return laid(points, targets, (S * signs).sum() / (x**2).sum(), (U * signs) @ Vt)


def rotation_before_the_test(points, targets):
    *_, U, _, Vt = parts(points, targets)
    return laid(points, targets, right(points, targets)[0], U @ Vt)


def mean_of_all_numbers_in_M(points, targets):
    x, y = points - points.mean(), targets - targets.mean()
    U, S, Vt = np.linalg.svd(y.T @ x)
    signs = np.array([1, 1, np.sign(np.linalg.det(U @ Vt))])
    return laid(points, targets, (S * signs).sum() / (x**2).sum(), (U * signs) @ Vt)


def mean_of_all_numbers_turned(points, targets):
    """Turn the single number, which NumPy refuses."""
    middle, goal = points.mean(), targets.mean()
    x, y = points - middle, targets - goal
    U, S, Vt = np.linalg.svd(y.T @ x)
    R, scale = U @ Vt, S.sum() / (x**2).sum()
    return scale, R, goal - scale * R @ middle


def mean_of_all_numbers(points, targets):
    middle, goal = points.mean(), targets.mean()
    x, y = points - middle, targets - goal
    U, S, Vt = np.linalg.svd(y.T @ x)
    signs = np.array([1, 1, np.sign(np.linalg.det(U @ Vt))])
    R, scale = (U * signs) @ Vt, (S * signs).sum() / (x**2).sum()
    return scale, R, goal - scale * R @ np.full(3, middle)


def move_of_one_point(points, targets):
    scale, R, _ = right(points, targets)
    return scale, R, targets[0] - scale * R @ points[0]


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
