"""Wrong answers to the exercise of chapter 05 on the full model."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib.exercises.distortion.model_misconceptions import brown, length, polynomial


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


def opencv_places(points, k, p, s):
    """Pick k3 to k6 where OpenCV's list of twelve has them."""
    return fraction(points, k[[0, 1, 4, 5, 6, 7]]) + aside(points, p, s)


def opencv_kept_place(points, k, p, s):
    """Unpack k as if k3 came last, as in the list of five."""
    return fraction(points, k[[0, 1, 5, 2, 3, 4]]) + aside(points, p, s)


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


def prism_pairs_exchanged(points, k, p, s):
    return fraction(points, k) + aside(points, p, s[[2, 3, 0, 1]])


def prism_same_for_both(points, k, p, s):
    return fraction(points, k) + aside(points, p, s[[0, 1, 0, 1]])


def fraction_without_brackets(points, k, p, s):
    above, below = radial(points, k)
    return points * (above + below - 1) + aside(points, p, s)


def below_left_out(points, k, p, s):
    above, _ = radial(points, k)
    return points * above + aside(points, p, s)


def prism_square_taken_twice(points, k, p, s):
    return fraction(points, k) + aside(points, p, s, (2, 8))


def prism_of_one_coordinate(points, k, p, s):
    prism = points**2 * s[[0, 2]] + points**4 * s[[1, 3]]
    return fraction(points, k) + aside(points, p, np.zeros(4)) + prism


def tangential_left_out_of_twelve(points, k, p, s):
    return fraction(points, k) + aside(points, np.zeros(2), s)
