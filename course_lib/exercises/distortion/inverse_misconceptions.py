"""Wrong answers to the exercises of chapter 05 on the inverse, and on the fold."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib import distortion

# --- undistort_points -------------------------------------------------------------------------


def forward_again(points, coefficients):
    return distortion.distort(points, coefficients)


def rounds(points: Any, coefficients: Any, count: Any) -> Any:
    """Return what some rounds of the iteration give."""
    ideal = points
    for _ in range(count):
        ideal = ideal + (points - distortion.distort(ideal, coefficients))
    return ideal


def one_round(points, coefficients):
    """Take the first step, or the opposite coefficients: the model is linear in them."""
    return rounds(points, coefficients, 1)


def factor_of_the_distorted(points, coefficients):
    k1, k2, _, _, k3 = coefficients
    r2 = (points**2).sum(axis=1, keepdims=True)
    return points / (1 + k1 * r2 + k2 * r2**2 + k3 * r2**3)


def too_few_rounds(points, coefficients):
    return rounds(points, coefficients, 3)


def correction_only(points, coefficients):
    return rounds(points, coefficients, 20) - points


def what_it_misses(points, coefficients):
    return points - distortion.distort(points, coefficients)


def radial_terms_only(points, coefficients):
    k1, k2, _, _, k3 = coefficients
    return rounds(points, np.array([k1, k2, 0, 0, k3]), 20)


def wrong_way(points, coefficients):
    ideal = points
    for _ in range(20):
        ideal = ideal - (points - distortion.distort(ideal, coefficients))
    return ideal


def restarted(points: Any, coefficients: Any, count: Any) -> Any:
    """Return what rounds give that all start from the measured point."""
    ideal = points
    for _ in range(count):
        ideal = points + (points - distortion.distort(ideal, coefficients))
    return ideal


def started_anew(points, coefficients):
    return restarted(points, coefficients, 20)


def started_anew_ten_times(points, coefficients):
    return restarted(points, coefficients, 10)


def started_anew_thirty_times(points, coefficients):
    return restarted(points, coefficients, 30)


def started_anew_hundred_times(points, coefficients):
    return restarted(points, coefficients, 100)


def same_miss_each_time(points, coefficients):
    return points + 20 * (points - distortion.distort(points, coefficients))


def same_miss_ten_times(points, coefficients):
    return points + 10 * (points - distortion.distort(points, coefficients))


def same_miss_thirty_times(points, coefficients):
    return points + 30 * (points - distortion.distort(points, coefficients))


def target_lost(points, coefficients):
    """Compare with the last guess, and no longer with the measured point."""
    ideal = points
    for _ in range(20):
        ideal = ideal + (ideal - distortion.distort(ideal, coefficients))
    return ideal


def guess_forgotten(points, coefficients):
    ideal = points
    for _ in range(20):
        ideal = points - distortion.distort(ideal, coefficients)
    return ideal


def guess_forgotten_from_zero(points, coefficients):
    ideal = np.zeros_like(points)
    for _ in range(20):
        ideal = points - distortion.distort(ideal, coefficients)
    return ideal


def last_guess_divided(points, coefficients):
    k1, k2, _, _, k3 = coefficients
    ideal = points
    for _ in range(20):
        r2 = (ideal**2).sum(axis=1, keepdims=True)
        ideal = ideal / (1 + k1 * r2 + k2 * r2**2 + k3 * r2**3)
    return ideal


def nothing_moved(points, coefficients):
    return points.copy()


# --- valid_radius -----------------------------------------------------------------------------


def positive_roots(polynomial: Any) -> Any:
    """Return the positive real roots; the highest power comes first."""
    return [q.real for q in np.roots(polynomial) if q.imag == 0 and q.real > 0]


def derivative(coefficients: Any) -> Any:
    k1, k2 = coefficients
    return [5 * k2, 3 * k1, 1]


def smallest(roots: Any) -> Any:
    return float(np.sqrt(min(roots))) if roots else np.inf


def square_of_the_radius(coefficients):
    roots = positive_roots(derivative(coefficients))
    return float(min(roots)) if roots else np.inf


def where_the_factor_is_zero(coefficients):
    k1, k2 = coefficients
    return smallest(positive_roots([k2, k1, 1]))


def derivative_of_the_factor(coefficients):
    k1, k2 = coefficients
    return smallest(positive_roots([2 * k2, k1]))


def numbers_not_brought_down(coefficients):
    k1, k2 = coefficients
    return smallest(positive_roots([4 * k2, 2 * k1, 1]))


def farther_fold(coefficients):
    roots = positive_roots(derivative(coefficients))
    return float(np.sqrt(max(roots))) if roots else np.inf


def as_an_angle(coefficients):
    return float(np.arctan(smallest(positive_roots(derivative(coefficients)))))


def as_degrees(coefficients):
    return float(np.degrees(np.arctan(smallest(positive_roots(derivative(coefficients))))))


def as_degrees_but_for_no_fold(coefficients):
    r = smallest(positive_roots(derivative(coefficients)))
    return float(np.degrees(np.arctan(r))) if r < np.inf else np.inf


def second_coefficient_left_out(coefficients):
    return smallest(positive_roots(derivative([coefficients[0], 0])))


def distorted_radius(coefficients):
    k1, k2 = coefficients
    r = smallest(positive_roots(derivative(coefficients)))
    return r * (1 + k1 * r**2 + k2 * r**4) if np.isfinite(r) else np.inf


def nan_without_fold(coefficients):
    roots = positive_roots(derivative(coefficients))
    return smallest(roots) if roots else np.nan


def zero_without_fold(coefficients):
    roots = positive_roots(derivative(coefficients))
    return smallest(roots) if roots else 0.0


def none_without_fold(coefficients):
    roots = positive_roots(derivative(coefficients))
    return smallest(roots) if roots else None


def fails_without_fold(coefficients):
    return float(np.sqrt(min(positive_roots(derivative(coefficients)))))


def fails_in_numpy_without_fold(coefficients):
    return float(np.sqrt(np.min(positive_roots(derivative(coefficients)))))


def first_of_none(coefficients):
    return float(np.sqrt(np.sort(positive_roots(derivative(coefficients)))[0]))


def complex_roots_kept(coefficients):
    roots = np.roots(derivative(coefficients)).real
    return smallest([q for q in roots if q > 0])


def roots_not_chosen(coefficients):
    with np.errstate(invalid="ignore"):
        return float(np.sqrt(np.roots(derivative(coefficients)).real.min()))


def divides_by_second(coefficients):
    k1, k2 = (float(k) for k in coefficients)
    inside = 9 * k1**2 - 20 * k2
    if inside < 0:
        return np.inf
    roots = [(-3 * k1 + sign * inside**0.5) / (10 * k2) for sign in (-1, 1)]
    return smallest([q for q in roots if q > 0])


def complex_roots_compared(coefficients):
    roots = np.roots(derivative(coefficients))
    roots = roots[roots > 0]
    return np.sqrt(roots.min()) if len(roots) else np.inf


def sizes_of_complex_roots(coefficients):
    return float(np.sqrt(np.abs(np.roots(derivative(coefficients))).min()))


def lowest_power_first(coefficients):
    return smallest(positive_roots(derivative(coefficients)[::-1]))


def powers_of_the_radius(coefficients):
    k1, k2 = coefficients
    roots = positive_roots([3 * k2, 2 * k1, 1])
    return min(roots) if roots else np.inf
