"""Distortion undone: from where a ray met the image to where a pinhole would have sent it.

There is no formula for it. Newton's method begins at the solution without tangential and prism
terms, which a table of the distance from the centre gives; whatever has not settled after a few
steps is solved again, with care. Use these functions through `course_lib.distortion`.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array
from course_lib.distortion.model import (
    SIDEWAYS,
    check_coefficients,
    check_normalised,
    columns,
    distorted_columns_and_slopes,
    radial_factor,
    radial_factor_and_slope,
    sideways_columns,
)
from course_lib.distortion.monotone import invert_increasing, smallest_positive_root

#: Points that are worked on together: few enough for the processor's fast memory.
CHUNK = 8192
#: Entries of the table of ratios.
ENTRIES = 4096
#: A step below this, by the distance, was Newton's last: the next would be about its square.
SETTLED = 1e-7

Guess = Callable[[Array, Array], tuple[Array, Array]]


def valid_radius(coefficients: ArrayLike) -> float:
    """Return how far from the centre a radial model can be used: up to where it folds over.

    Up to there, points farther out have their images farther out. Then the polynomial turns round
    (or the rational model's denominator becomes zero), and two rays would share an image.

    Parameters
    ----------
    coefficients : array_like, shape (1,), (2,), (4,), (5,), (8,) or (12,)
        As in `distort`; the tangential and prism terms are left out.

    Returns
    -------
    float
        Ideal distance ``r`` from the centre in normalised coordinates: the smallest at which the
        derivative of ``r g(r²)`` is zero or g has a pole. Infinity if there is none.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong or a number is not finite.

    References
    ----------
    M. J. Leotta, D. Russell, A. Matrai, "On the maximum radius of polynomial lens distortion",
    WACV 2022.

    Examples
    --------
    ``r - 0.1 r³`` grows until ``1 = 0.3 r²``:

    >>> round(valid_radius([-0.1]), 6)
    1.825742
    >>> valid_radius([0.1])
    inf
    """
    k = check_coefficients(coefficients)
    above, below = np.array([1, k[0], k[1], k[4]]), np.array([1, *k[5:8]])
    # d(r N/D)/dr is N D + 2 q (N' D - N D') over D², with q = r²; lowest power first.
    powers = np.arange(4)
    rise = np.convolve(above, below)
    rise += 2 * (np.convolve(powers * above, below) - np.convolve(above, powers * below))
    pole = smallest_positive_root(below) if below[1:].any() else np.inf
    return float(np.sqrt(min(smallest_positive_root(rise), pole)))


def undistort_points(points: ArrayLike, coefficients: ArrayLike) -> Array:
    """Return where an ideal lens would have imaged the rays of a lens with distortion.

    Parameters
    ----------
    points : array_like, shape (N, 2) or (2,)
        Distorted points in normalised coordinates (pixels after K⁻¹), in rows.
    coefficients : array_like, shape (1,), (2,), (4,), (5,), (8,) or (12,)
        As in `distort`.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Ideal points in normalised coordinates, to 1e-12 or better. A row of NaN for a point that is
        no image of anything within the `valid_radius`.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or the points are pixels rather than tangents.

    References
    ----------
    Press et al., Numerical Recipes, 3rd ed., sections 9.6 and 9.7 (Newton's method in several
    dimensions, with steps that are cut back).

    Examples
    --------
    >>> undistort_points([[0.475, 0], [9, 9]], [-0.2])
    array([[0.5, 0. ],
           [nan, nan]])
    """
    points, k = check_normalised(points, "points"), check_coefficients(coefficients)
    distorted = points.reshape(-1, 2)
    undistorted = np.empty_like(distorted)
    if distorted.size:
        limit, (x, y) = valid_radius(k), distorted.T
        guess = radial_guess(k, limit, float(np.sqrt((x * x + y * y).max())))
        for start in range(0, len(distorted), CHUNK):
            part = slice(start, start + CHUNK)
            undistorted[part] = _undistort_part(distorted[part], k, limit, guess)
    return undistorted.reshape(points.shape)


def _undistort_part(distorted: Array, k: Array, limit: float, guess: Guess) -> Array:
    """Return ideal points: a few Newton steps for all, then care for those that need it."""
    x_d, y_d = columns(distorted)
    x, y = guess(x_d, y_d)
    with np.errstate(all="ignore"):
        if k[SIDEWAYS].any():  # again, without what those terms have added
            aside_x, aside_y = sideways_columns(x, y, k)
            x, y = guess(x_d - aside_x, y_d - aside_y)
        for _ in range(4):
            step_x, step_y, determinant, *_ = _newton_step(x, y, x_d, y_d, k)
            x -= step_x
            y -= step_y
            moved = step_x * step_x + step_y * step_y
            if moved.max() <= SETTLED**2:
                break
        near = x * x + y * y
        # NaN compares as False.
        good = (moved <= SETTLED**2 * near) & (determinant > 0) & (near < (0.99 * limit) ** 2)
    good |= (x_d == 0) & (y_d == 0)
    undistorted = np.stack([x, y], axis=-1)
    if not good.all():
        undistorted[~good] = _undistort_carefully(distorted[~good], k, limit)
    return undistorted


def _newton_step(x: Array, y: Array, x_d: Array, y_d: Array, k: Array) -> tuple[Array, ...]:
    """Return by how much x and y are too large, the determinant there, and the excess of both."""
    found_x, found_y, xx, xy, yx, yy = distorted_columns_and_slopes(x, y, k)
    found_x -= x_d
    found_y -= y_d
    determinant = xx * yy - xy * yx
    inverse = 1 / determinant
    step_x = (yy * found_x - xy * found_y) * inverse
    step_y = (xx * found_y - yx * found_x) * inverse
    return step_x, step_y, determinant, found_x, found_y


def _undistort_carefully(distorted: Array, k: Array, limit: float) -> Array:
    """Return ideal points by Newton's method from several starts; NaN where there is none."""
    far = np.hypot(*distorted.T)
    r, end = _invert_radial(k, limit, far)
    if not k[SIDEWAYS].any():
        return np.asarray(distorted * (r / far)[:, None])
    # Tangential terms may still bring a point within reach.
    start = distorted * (np.where(np.isnan(r), end, r) / far)[:, None]
    undistorted = np.full_like(distorted, np.nan)
    # At the fold no step is of use; then a start nearer to the centre is.
    for share in (1.0, 0.8, 0.5):
        left = np.isnan(undistorted[:, 0])
        if left.any():
            undistorted[left] = _descend(share * start[left], distorted[left], k)
            undistorted[np.hypot(*undistorted.T) > limit] = np.nan
    return undistorted


def _descend(start: Array, distorted: Array, k: Array) -> Array:
    """Return ideal points by Newton's method, each step cut back until it helps."""
    (x, y), (x_d, y_d) = columns(start), columns(distorted)
    far = np.hypot(x_d, y_d)
    with np.errstate(all="ignore"):
        state = _newton_step(x, y, x_d, y_d, k)
        share = np.ones_like(x)
        for _ in range(100):
            step_x, step_y, _, *excess = state
            error = np.hypot(*excess)
            if not ((error > 1e-15 * far) & (share > 1e-12)).any():
                break
            tried = x - share * step_x, y - share * step_y
            found = _newton_step(*tried, x_d, y_d, k)
            better = (np.hypot(*found[3:]) < error) & (found[2] > 0)
            x, y = np.where(better, tried[0], x), np.where(better, tried[1], y)
            state = tuple(np.where(better, *pair) for pair in zip(found, state, strict=True))
            share = np.where(better, np.minimum(1, 2 * share), share / 2)
        good = (np.hypot(*state[3:]) <= 1e-13 * (1 + far)) & (state[2] > 0)
    return np.where(good[:, None], np.stack([x, y], axis=-1), np.nan)


def _invert_radial(k: Array, limit: float, far: Array) -> tuple[Array, float]:
    """Return the ideal distance for each distorted one, by the radial terms, and the largest."""

    def distance(r: Array) -> Array:
        return r * radial_factor(r * r, k)

    def rise(r: Array) -> Array:
        factor, slope = radial_factor_and_slope(r * r, k)
        return factor + 2 * r * r * slope

    end = _end(k, limit, float(far.max(initial=0)))
    return invert_increasing(far, distance, rise, end), end


def _end(k: Array, limit: float, farthest: float) -> float:
    """Return an ideal distance whose image is as far out as asked, or the last valid one."""
    end = max(farthest, 1e-9)
    while end < limit and end < 1e9 and end * radial_factor(np.array(end * end), k) < farthest:
        end *= 2
    # A step back from the fold, where the derivative is zero, and from the pole.
    return min(end, limit * (1 - 1e-7))


def radial_guess(k: Array, limit: float, farthest: float) -> Guess:
    """Return a function that undoes the radial terms, to eight digits or so.

    It reads the ratio of ideal to distorted distance from a table with equal steps of the latter's
    square, so that looking up is one multiplication.
    """
    r = np.linspace(0, _end(k, limit, farthest), ENTRIES)
    r_d = r * radial_factor(r * r, k)
    top = max(min(farthest, r_d[-1]), 1e-9)
    square = np.linspace(0, top**2, ENTRIES)
    ratio = np.ones(ENTRIES)
    ratio[1:] = np.interp(np.sqrt(square[1:]), r_d, r) / np.sqrt(square[1:])
    rise = np.append(np.diff(ratio), 0)

    def guess(x: Array, y: Array) -> tuple[Array, Array]:
        place = (x * x + y * y) * ((ENTRIES - 1) / top**2)
        np.minimum(place, ENTRIES - 1, out=place)
        entry = place.astype(np.intp)
        place -= entry
        looked_up = ratio[entry] + place * rise[entry]
        return x * looked_up, y * looked_up

    return guess
