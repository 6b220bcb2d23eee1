"""Wrong answers to the exercises of chapter 05 on the first models."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- distort_radial ---------------------------------------------------------------------------


def polynomial(r: Any, k: Any, powers: Any) -> Any:
    """Return 1 + k1 r^a + k2 r^b + … for chosen powers."""
    return 1 + sum(c * r**n for c, n in zip(k, powers, strict=False))


def length(points: Any) -> Any:
    return np.sqrt((points**2).sum(axis=-1, keepdims=True))


def distance_not_squared(points, k):
    return points * polynomial(length(points), k, (1, 2, 3))


def powers_one_by_one(points, k):
    return points * polynomial(length(points), k, (2, 3, 4))


def same_power_for_all(points, k):
    return points * polynomial(length(points), k, (2, 2, 2))


def one_forgotten(points, k):
    return points * (polynomial(length(points), k, (2, 4, 6)) - 1)


def factor_alone(points, k):
    return polynomial(length(points), k, (2, 4, 6))[..., 0]


def factor_in_a_column(points, k):
    return polynomial(length(points), k, (2, 4, 6))


def lens_of_the_text(points, k):
    return points * polynomial(length(points), (-0.31, 0.12), (2, 4))


def divided(points, k):
    return points / polynomial(length(points), k, (2, 4, 6))


def one_radius_for_all(points, k):
    return points * polynomial(np.sqrt((points**2).sum()), k, (2, 4, 6))


def added_along_the_wrong_axis(points, k):
    return points * polynomial(np.sqrt((points**2).sum(axis=0)), k, (2, 4, 6))


def each_coordinate_alone(points, k):
    return points * polynomial(np.abs(points), k, (2, 4, 6))


def first_coefficient_only(points, k):
    return points * polynomial(length(points), k[:1], (2,))


def backwards(points, k):
    return points * np.polyval([1, *k], length(points) ** 2)


def from_the_last(points, k):
    return points * polynomial(length(points), k[::-1], (2, 4, 6))


def square_taken_twice(points, k):
    return points * polynomial(length(points), k, (4, 8, 12))


def powers_from_the_fourth(points, k):
    return points * polynomial(length(points), k, (4, 6, 8))


def counted_from_zero(points, k):
    return points * polynomial(length(points), k, (0, 2, 4))


def last_coefficient_only(points, k):
    return points * polynomial(length(points), k[-1:], (2 * len(k),))


def factor_added(points, k):
    return points + polynomial(length(points), k, (2, 4, 6))


def opposite_sign(points, k):
    return points * polynomial(length(points), -k, (2, 4, 6))


def rows_do_not_fit(points, k):
    r = np.sqrt((points**2).sum(axis=-1))
    return points * polynomial(r, k, (2, 4, 6))


# --- distort ----------------------------------------------------------------------------------


def brown(points: Any, coefficients: Any, two: Any = 2.0, own: Any = 2.0) -> Any:
    """Return distorted x and y with other numbers in the tangential terms."""
    k1, k2, p1, p2, k3 = coefficients
    x, y = points.T
    r2 = x**2 + y**2
    g = 1 + k1 * r2 + k2 * r2**2 + k3 * r2**3
    x_d = x * g + two * p1 * x * y + p2 * (r2 + own * x**2)
    y_d = y * g + p1 * (r2 + own * y**2) + two * p2 * x * y
    return np.stack([x_d, y_d], axis=1)


def tangential_swapped(points, coefficients):
    k1, k2, p1, p2, k3 = coefficients
    return brown(points, (k1, k2, p2, p1, k3))


def third_radial_third(points, coefficients):
    k1, k2, k3, p1, p2 = coefficients
    return brown(points, (k1, k2, p1, p2, k3))


def factor_two_forgotten(points, coefficients):
    return brown(points, coefficients, two=1.0)


def own_square_once(points, coefficients):
    return brown(points, coefficients, own=1.0)


def own_square_forgotten(points, coefficients):
    return brown(points, coefficients, own=0.0)


def radial_by_distance(points, coefficients):
    return radial_by_powers(points, coefficients, (1, 2, 3))


def tangential_left_out(points, coefficients):
    k1, k2, _, _, k3 = coefficients
    return brown(points, (k1, k2, 0, 0, k3))


def tangential_scaled_too(points, coefficients):
    k1, k2, p1, p2, k3 = coefficients
    r = length(points)
    return brown(points, (0, 0, p1, p2, 0)) * polynomial(r, (k1, k2, k3), (2, 4, 6))


def one_after_the_other(points, coefficients):
    k1, k2, p1, p2, k3 = coefficients
    return brown(brown(points, (k1, k2, 0, 0, k3)), (0, 0, p1, p2, 0))


def x_overwritten(points, coefficients):
    k1, k2, p1, p2, k3 = coefficients
    x, y = points.T
    r2 = x**2 + y**2
    g = 1 + k1 * r2 + k2 * r2**2 + k3 * r2**3
    x = x * g + 2 * p1 * x * y + p2 * (r2 + 2 * x**2)
    y = y * g + p1 * (r2 + 2 * y**2) + 2 * p2 * x * y
    return np.stack([x, y], axis=1)


def same_aside_for_both(points, coefficients):
    k1, k2, p1, p2, k3 = coefficients
    x, y = points.T
    aside = 2 * p1 * x * y + p2 * (x**2 + y**2 + 2 * x**2)
    return brown(points, (k1, k2, 0, 0, k3)) + aside[:, None]


def displacement_only(points, coefficients):
    return brown(points, coefficients) - points


def y_like_x(points, coefficients):
    k1, k2, p1, p2, k3 = coefficients
    x, _ = brown(points, coefficients).T
    _, y = brown(points, (k1, k2, p2, p1, k3)).T
    return np.stack([x, y], axis=1)


def own_square_of_x(points, coefficients):
    x, y = points.T
    p1 = coefficients[2]
    found = brown(points, coefficients)
    return np.stack([found[:, 0], found[:, 1] + 2 * p1 * (x**2 - y**2)], axis=1)


def own_squares_exchanged(points, coefficients):
    _, _, p1, p2, _ = coefficients
    x, y = points.T
    return brown(points, coefficients) + 2 * (y**2 - x**2)[:, None] * [p2, -p1]


def opposite_tangential(points, coefficients):
    k1, k2, p1, p2, k3 = coefficients
    return brown(points, (k1, k2, -p1, -p2, k3))


def two_squared_too(points, coefficients):
    return brown(points, coefficients, own=4.0)


def own_not_squared(points, coefficients):
    _, _, p1, p2, _ = coefficients
    return brown(points, coefficients, own=0.0) + 2 * points * [p2, p1]


def bracket_forgotten(points, coefficients):
    return brown(points, coefficients, own=0.0) + 2 * points**2


def bracket_forgotten_in_x(points, coefficients):
    p2, square = coefficients[3], points[:, :1] ** 2
    return brown(points, coefficients) + 2 * (1 - p2) * square * [1, 0]


def radial_by_powers(points: Any, coefficients: Any, powers: Any) -> Any:
    """Return distorted points with other powers in the radial factor."""
    k1, k2, p1, p2, k3 = coefficients
    side = brown(points, (0, 0, p1, p2, 0)) - points
    return points * polynomial(length(points), (k1, k2, k3), powers) + side


def square_taken_twice_again(points, coefficients):
    return radial_by_powers(points, coefficients, (4, 8, 12))


def third_like_the_second(points, coefficients):
    return radial_by_powers(points, coefficients, (2, 4, 4))


def powers_as_of_the_distance(points, coefficients):
    return radial_by_powers(points, coefficients, (2, 8, 12))


def tangential_multiplied(points, coefficients):
    k1, k2, p1, p2, k3 = coefficients
    side = brown(points, (0, 0, p1, p2, 0)) - points
    return points * (polynomial(length(points), (k1, k2, k3), (2, 4, 6)) + side)


def third_radial_left_out(points, coefficients):
    k1, k2, p1, p2, _ = coefficients
    return brown(points, (k1, k2, p1, p2, 0))


def root_in_the_brackets(points, coefficients):
    _, _, p1, p2, _ = coefficients
    r = length(points)
    return brown(points, coefficients) + (r - r**2) * [p2, p1]
