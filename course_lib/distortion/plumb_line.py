"""Distortion from straight lines: threads with a weight, edges of houses, and nothing else known.

A pinhole images straight lines as straight lines. Whatever bends them is the lens; so the
coefficients are those that straighten the pictures of lines. Use these functions through
`course_lib.distortion`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_intrinsics,
    check_points,
)
from course_lib.distortion.inverse import undistort_points
from course_lib.distortion.model import distortion_jacobian
from course_lib.distortion.pixels import normalised_from_pixels

#: What a point counts, in px, that a trial's lens does not image at all.
OUT_OF_REACH = 1e4


class PlumbLines(NamedTuple):
    """What straight lines say about a lens.

    Attributes
    ----------
    coefficients : ndarray, shape (1,) or (2,)
        ``k1``, or ``k1, k2``, as in `distort`.
    sigma : ndarray, shape of `coefficients`
        Their standard deviations, if the points scatter independently.
    rms_before, rms : float
        Distance of the points from straight lines, without and with the lens: root mean square in
        px of the real picture.
    """

    coefficients: Array
    sigma: Array
    rms_before: float
    rms: float


def straightness(points: ArrayLike) -> float:
    """Return how far points are from a straight line.

    Parameters
    ----------
    points : array_like, shape (N, 2)
        Three or more points, in rows.

    Returns
    -------
    float
        Root mean square of the distances from the line that fits best, in the points' unit;
        measured across the line, so that a vertical one is as good as any.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong, a number is not finite, or there are fewer than three points.

    References
    ----------
    K. Pearson, "On lines and planes of closest fit to systems of points in space", Philosophical
    Magazine 2 (1901).

    Examples
    --------
    >>> straightness([[0, 0], [1, 1], [2, 2]]) < 1e-12
    True
    >>> round(straightness([[0, 0], [1, 0.3], [2, 0]]), 6)
    0.141421
    """
    points = check_line(points)
    # The least singular value is the root of the sum of the squares across the best line.
    across = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)[1]
    return float(across / np.sqrt(len(points)))


def distortion_from_lines(lines: Sequence[ArrayLike], K: ArrayLike, terms: int = 2) -> PlumbLines:
    """Return the radial coefficients that make the pictures of straight lines straight.

    Parameters
    ----------
    lines : sequence of array_like, each of shape (N, 2)
        For each line three or more points of its picture, in px.
    K : array_like, shape (3, 3)
        Intrinsics in px. Lines do not tell the focal length: with another one, the coefficients
        change by powers of the ratio, and straighten as well. The principal point matters.
    terms : {1, 2}
        How many coefficients.

    Returns
    -------
    PlumbLines
        Coefficients for `distort`, their standard deviations, and how straight the lines got.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, a line has fewer than three points, or there
        are no more points than unknowns.
    DegenerateConfigurationError
        If the lines do not determine the coefficients (those through the centre stay straight), or
        are so crooked that no lens straightens them.

    References
    ----------
    D. C. Brown, "Close-range camera calibration", Photogrammetric Engineering 37 (1971); F.
    Devernay, O. Faugeras, "Straight lines have to be straight", Machine Vision and Applications 13
    (2001).

    Examples
    --------
    >>> from course_lib.distortion import distort_pixels
    >>> K, u = [[500, 0, 320], [0, 500, 240], [0, 0, 1]], np.linspace(0, 640, 20)
    >>> ideal = [np.stack([u, np.full(20, v)], axis=1) for v in (20, 120, 380)]
    >>> lines = [distort_pixels(line, K, [-0.25, 0.1]) for line in ideal]
    >>> distortion_from_lines(lines, K).coefficients.round(6)
    array([-0.25,  0.1 ])
    """
    from scipy.optimize import least_squares

    if terms not in (1, 2):
        raise ValueError(f"terms must be 1 (k1) or 2 (k1 and k2), got {terms!r}")
    pixels = [check_line(line) for line in lines]
    if not pixels:
        raise ValueError("lines must be one or more lines, got none")
    K, count = check_intrinsics(K), sum(map(len, pixels))
    if count - 2 * len(pixels) <= terms:  # each line has two unknowns of its own
        raise ValueError(
            f"{terms} coefficients and {len(pixels)} lines need more than "
            f"{terms + 2 * len(pixels)} points, got {count}"
        )
    points = normalised_from_pixels(np.concatenate(pixels), K)
    ends = np.cumsum([len(line) for line in pixels])[:-1]

    def distances(k: Array) -> Array:
        return _bent_distances(points, ends, K, k)

    start, tight = np.zeros(terms), {"xtol": 1e-12, "ftol": 1e-12, "max_nfev": 60}
    fit = least_squares(distances, start, jac="3-point", **tight)
    if not fit.success:
        raise DegenerateConfigurationError(
            "no lens straightens these lines: leave out what is not the picture of a straight line"
        )
    return _judged(fit.x, fit.jac, fit.fun, distances(start), count - 2 * len(pixels))


def _judged(k: Array, jacobian: Array, after: Array, before: Array, freedom: int) -> PlumbLines:
    """Return the result with its standard deviations, unless the lines do not determine it."""
    # By how many px the least visible change of the coefficients by 1 bends the lines.
    _, bends, directions = np.linalg.svd(jacobian, full_matrices=False)
    if bends[-1] < 1e-3 * np.sqrt(len(after)):
        raise DegenerateConfigurationError(
            "the lines do not determine the coefficients: take lines that pass the centre of the "
            "picture at several distances and run through all of it, or ask for one term"
        )
    variance = (after @ after) / (freedom - len(k))
    sigma = np.sqrt(variance * ((directions / bends[:, None]) ** 2).sum(axis=0))
    rms_before, rms = (float(np.sqrt(np.mean(d**2))) for d in (before, after))
    return PlumbLines(k, sigma, rms_before, rms)


def _bent_distances(points: Array, ends: Array, K: Array, k: Array) -> Array:
    """Return how far points are from their lines after the lens, in px of the real picture.

    An error in the real picture grows or shrinks when it is undistorted; dividing by how much
    keeps a trial from looking good only because it shrinks everything.
    """
    ideal = undistort_points(points, k)
    seen = np.isfinite(ideal[:, 0])
    ideal[~seen] = points[~seen]
    parts = [across_line(part) for part in np.split(ideal, ends)]
    distances = np.concatenate([part[0] for part in parts])
    normals = np.concatenate([np.tile(part[1], (len(part[0]), 1)) for part in parts])
    # d(ideal)/d(pixel) = (K J)⁻¹; a distance along n changes by its transpose times n.
    (a, b), (c, d) = np.moveaxis(K[:2, :2] @ distortion_jacobian(ideal, k), (-2, -1), (0, 1))
    x, y = normals.T
    growth = np.hypot(d * x - c * y, a * y - b * x)  # times the determinant
    near = seen & (growth > 0)
    pixels = distances * np.abs(a * d - b * c) / np.where(near, growth, 1)
    return np.where(near, pixels, OUT_OF_REACH)


def across_line(points: Array) -> tuple[Array, Array]:
    """Return signed distances from the best line, and the direction across it."""
    centred = points - points.mean(axis=0)
    x, y = np.linalg.svd(centred, full_matrices=False)[2][0]
    # The same side is positive whichever way the decomposition points.
    along = 1 if (points[-1] - points[0]) @ (x, y) >= 0 else -1
    normal = along * np.array([-y, x])
    return centred @ normal, normal


def check_line(points: ArrayLike) -> Array:
    """Return points of one line, shape ``(N, 2)`` with three or more rows."""
    points = check_points(points, 2, "points of a line")
    if points.ndim != 2 or len(points) < 3:
        raise ValueError(
            f"a line needs three or more points in rows, got shape {points.shape}: "
            "two are always straight"
        )
    return points
