"""Wrong answers to the exercises of chapter 05 on models: radial, tangential, prism."""

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


def divided(points, k):
    return points / polynomial(length(points), k, (2, 4, 6))


def one_radius_for_all(points, k):
    return points * polynomial(np.sqrt((points**2).sum()), k, (2, 4, 6))


def each_coordinate_alone(points, k):
    return points * polynomial(np.abs(points), k, (2, 4, 6))


def first_coefficient_only(points, k):
    return points * polynomial(length(points), k[:1], (2,))


def backwards(points, k):
    return points * np.polyval([1, *k], length(points) ** 2)


def from_the_last(points, k):
    return points * polynomial(length(points), k[::-1], (2, 4, 6))


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
    k1, k2, p1, p2, k3 = coefficients
    r = length(points)
    aside = brown(points, (0, 0, p1, p2, 0)) - points
    return points * (1 + k1 * r + k2 * r**2 + k3 * r**3) + aside


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


# --- distort_rational_prism -------------------------------------------------------------------


def radial(points: Any, k: Any) -> Any:
    """Return the two polynomials of the fraction."""
    r = length(points)
    return polynomial(r, k[:3], (2, 4, 6)), polynomial(r, k[3:], (2, 4, 6))


def aside(points: Any, p: Any, s: Any, powers: Any = (2, 4)) -> Any:
    """Return what the tangential and prism terms add."""
    r, (a, b) = length(points), powers
    prism = np.concatenate([s[0] * r**a + s[1] * r**b, s[2] * r**a + s[3] * r**b], axis=1)
    return brown(points, (0, 0, *p, 0)) - points + prism


def fraction(points: Any, k: Any) -> Any:
    above, below = radial(points, k)
    return points * above / below


def below_multiplied(points, k, p, s):
    above, below = radial(points, k)
    return points * above * below + aside(points, p, s)


def below_without_one(points, k, p, s):
    above, below = radial(points, k)
    with np.errstate(divide="ignore", invalid="ignore"):
        return points * above / (below - 1) + aside(points, p, s)


def fraction_upside_down(points, k, p, s):
    above, below = radial(points, k)
    return points * below / above + aside(points, p, s)


def six_powers(points, k, p, s):
    g = polynomial(length(points), k, (2, 4, 6, 8, 10, 12))
    return points * g + aside(points, p, s)


def opencv_order(points, k, p, s):
    return fraction(points, k[[0, 1, 4, 2, 3, 5]]) + aside(points, p, s)


def prism_by_distance(points, k, p, s):
    return fraction(points, k) + aside(points, p, s, (1, 2))


def prism_same_power(points, k, p, s):
    return fraction(points, k) + aside(points, p, s, (2, 2))


def prism_alternating(points, k, p, s):
    return fraction(points, k) + aside(points, p, s[[0, 2, 1, 3]])


def prism_times_point(points, k, p, s):
    prism = aside(points, (0, 0), s)
    return fraction(points, k) + aside(points, p, np.zeros(4)) + points * prism


def all_divided(points, k, p, s):
    above, below = radial(points, k)
    return (points * above + aside(points, p, s)) / below


def prism_left_out(points, k, p, s):
    return fraction(points, k) + aside(points, p, np.zeros(4))


def tangential_exchanged(points, k, p, s):
    return fraction(points, k) + aside(points, p[::-1], s)
