"""Wrong answers to the exercises of chapter 02 on points and lines."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- to_homogeneous ---------------------------------------------------------------------------


def zero_appended(points):
    return np.concatenate([points, np.zeros_like(points[..., :1])], axis=-1)


def one_for_all(points):
    return np.append(points, 1)


def one_in_front(points):
    return np.concatenate([np.ones_like(points[..., :1]), points], axis=-1)


def only_for_the_plane(points):
    return np.stack([points[..., 0], points[..., 1], np.ones_like(points[..., 0])], axis=-1)


def points_as_columns(points):
    return np.concatenate([points, np.ones_like(points[..., :1])], axis=-1).T


def last_number_made_one(points):
    return points / points[..., -1:]


def as_many_ones_as_coordinates(points):
    return np.concatenate([points, np.ones_like(points)], axis=-1)


# --- from_homogeneous -------------------------------------------------------------------------


def last_number_dropped(points):
    return np.where(points[..., -1:] == 0, np.nan, points[..., :-1])


def infinity_divided(points):
    return points[..., :-1] / points[..., -1:]


def one_kept(points):
    return points / np.where(points[..., -1:] == 0, np.nan, points[..., -1:])


def always_third(points):
    return points[..., :2] / np.where(points[..., 2:3] == 0, np.nan, points[..., 2:3])


def divided_by_first(points):
    return points[..., 1:] / np.where(points[..., -1:] == 0, np.nan, points[..., :1])


def infinity_left_as_it_is(points):
    w = points[..., -1:]
    return np.where(w == 0, points[..., :-1], points[..., :-1] / np.where(w == 0, 1, w))


def negative_w_refused(points):
    w = points[..., -1:]
    return np.where(w > 0, points[..., :-1] / np.where(w == 0, 1, w), np.nan)


def rows_for_numbers(points):
    return points[:-1] / points[-1]


def first_rows_for_numbers(points):
    return points[:2] / points[2]


# --- line_through -----------------------------------------------------------------------------


def w_ignored(p, q):
    first, second = np.array(p), np.array(q)
    first[..., 2] = second[..., 2] = 1
    return np.cross(first, second)


def _slope_and_height(p: Any, q: Any) -> Any:
    (x1, y1), (x2, y2) = ((v[..., 0] / v[..., 2], v[..., 1] / v[..., 2]) for v in (p, q))
    slope = (y2 - y1) / (x2 - x1)
    return slope, y1 - slope * x1


def slope_and_intercept(p, q):
    slope, height = _slope_and_height(p, q)
    return np.stack([slope, -np.ones_like(slope), height], axis=-1)


def slope_and_height_alone(p, q):
    return np.stack(_slope_and_height(p, q), axis=-1)


def direction_for_normal(p, q):
    line = np.cross(p, q)
    dx, dy = line[..., 1], -line[..., 0]
    x, y, w = p[..., 0], p[..., 1], p[..., 2]
    return np.stack([dx * w, dy * w, -(dx * x + dy * y)], axis=-1)


def sign_of_c(p, q):
    return np.cross(p, q) * [1, 1, -1]


def middle_sign_forgotten(p, q):
    return np.cross(p, q) * [1, -1, 1]


def difference_of_points(p, q):
    return q - p


def scalar_product(p, q):
    return np.sum(p * q, axis=-1)


def number_by_number(p, q):
    return p * q


# --- meet -------------------------------------------------------------------------------------


def c_on_the_other_side(l, m):  # noqa: E741
    return np.cross(l, m) * [-1, -1, 1]


def determinant_with_wrong_sign(l, m):  # noqa: E741
    return np.cross(l, m) * [1, -1, 1]


def must_be_finite(l, m):  # noqa: E741
    x = np.cross(l, m)
    return x / x[..., 2:]


def x_and_y_exchanged(l, m):  # noqa: E741
    return np.cross(l, m)[..., [1, 0, 2]]


def lines_added(l, m):  # noqa: E741
    return l + m


def ordinary_point(l, m):  # noqa: E741
    x = np.cross(l, m)
    return x[..., :2] / x[..., 2:]
