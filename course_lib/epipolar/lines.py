"""Epipolar lines and epipoles, and how far points are from where F wants them.

Use these functions through `course_lib.epipolar`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    SMALLEST,
    Array,
    DegenerateConfigurationError,
    check_points,
)
from course_lib.correspondences import check_correspondences
from course_lib.epipolar.matrices import check_two_view, unit
from course_lib.homogeneous import from_homogeneous, to_homogeneous

#: A second singular value that is zero but for rounding, as a share of the first.
RANK_ONE = 1e-12
#: A last number that is zero but for rounding, of a homogeneous point of length 1.
INFINITELY_FAR = 1e-12


def epipolar_lines(points: ArrayLike, F: ArrayLike) -> Array:
    """Return the lines of picture 2 on which the partners of points of picture 1 lie.

    For the lines of picture 1 on which the partners of points of picture 2 lie, give ``F.T``.

    Parameters
    ----------
    points : array_like, shape (N, 2) or (2,)
        Pixels of picture 1 in rows.
    F : array_like, shape (3, 3)
        Fundamental matrix, ``x2ᵀ F x1 = 0``.

    Returns
    -------
    ndarray, shape (N, 3) or (3,)
        Lines ``(a, b, c)`` with ``a u + b v + c = 0`` and ``a² + b² = 1``, so that
        ``a u + b v + c`` is a distance in px. The sign has no meaning.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or F is zero.
    DegenerateConfigurationError
        If a point is the epipole, which has no line, or its line is the one at infinity.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 9.2.4.

    Examples
    --------
    >>> F = np.array([[0, 0, 0], [0, 0, -1], [0, 1, 0]])  # the same row in both pictures
    >>> epipolar_lines([[10, 30]], F)
    array([[ 0., -1., 30.]])
    """
    points, F = check_points(points, 2, "points"), unit(check_two_view(F))
    lines = to_homogeneous(points) @ F.T
    length = np.linalg.norm(lines[..., :2], axis=-1, keepdims=True)
    size = to_homogeneous(np.abs(points)) @ np.abs(F[:2].T)
    if (length <= 1e-14 * size.max(axis=-1, keepdims=True)).any():
        raise DegenerateConfigurationError(
            "a point is the epipole (or its line is at infinity): every line through the other "
            "epipole could be its partner's; leave that point out"
        )
    return np.asarray(lines / length)


def epipole(F: ArrayLike) -> Array:
    """Return where picture 1 shows camera 2: the point that all its epipolar lines share.

    For the epipole of picture 2, where it shows camera 1, give ``F.T``.

    Parameters
    ----------
    F : array_like, shape (3, 3)
        Fundamental matrix; or an essential one, for normalised coordinates.

    Returns
    -------
    ndarray, shape (2,)
        Pixel e1 with ``F (u, v, 1)ᵀ = 0``, in the picture or outside of it. NaN if the epipole is
        at infinity (to twelve digits): then the lines are parallel.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong, a number is not finite, or F is zero.
    DegenerateConfigurationError
        If F has rank 1.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 9.2.4.

    Examples
    --------
    >>> epipole([[0, -1, 50], [1, 0, -60], [-50, 60, 0]]).round(9)
    array([60., 50.])
    """
    e = homogeneous_epipole(F)
    return from_homogeneous(e * [1, 1, e[2] > INFINITELY_FAR])


def homogeneous_epipole(F: ArrayLike) -> Array:
    """Return ``F e1 = 0``, of length 1; its last number is not negative, and zero at infinity."""
    _, s, Vt = np.linalg.svd(unit(check_two_view(F)))
    if s[1] <= RANK_ONE * s[0]:
        raise DegenerateConfigurationError("F has rank 1: a whole line would be its epipole")
    return np.asarray(-Vt[2] if Vt[2, 2] < 0 else Vt[2])


def line_distance(points: ArrayLike, lines: ArrayLike) -> Array:
    """Return the distances of points from lines, one line for each point.

    Parameters
    ----------
    points : array_like, shape (N, 2) or (2,)
        Pixels in rows.
    lines : array_like, shape (N, 3) or (3,)
        Lines ``(a, b, c)`` of any scale; one for each point, or one for all.

    Returns
    -------
    ndarray, shape (N,) or ()
        Distances in px, never negative: ``|a u + b v + c| / √(a² + b²)``.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, or a line is the one at infinity.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 11.4.3.

    Examples
    --------
    >>> line_distance([[3, 4], [0, 0]], [[0, 2, -2], [3, 4, -10]])
    array([3., 2.])
    """
    points, lines = check_points(points, 2, "points"), check_points(lines, 3, "lines")
    if lines.ndim == 2 and points.shape[:-1] not in (lines.shape[:-1], ()):
        raise ValueError(f"each point needs a line, got {len(lines)} lines for {points.shape}")
    length = np.hypot(lines[..., 0], lines[..., 1])
    if (length < SMALLEST).any():
        raise ValueError("a line is the one at infinity, from which no pixel has a distance")
    along = (points * lines[..., :2]).sum(axis=-1) + lines[..., 2]
    return np.asarray(np.abs(along) / length)


def symmetric_distance(points1: ArrayLike, points2: ArrayLike, F: ArrayLike) -> Array:
    """Return how far pairs are from each other's epipolar lines, in both pictures.

    Parameters
    ----------
    points1, points2 : array_like, shape (N, 2)
        Pixels of picture 1, and their partners in picture 2.
    F : array_like, shape (3, 3)
        Fundamental matrix.

    Returns
    -------
    ndarray, shape (N,)
        ``√((d1² + d2²) / 2)`` in px, where d1 is the distance in picture 1 and d2 that in
        picture 2.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, or F is zero.
    DegenerateConfigurationError
        If a point is an epipole.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., equation 11.10.
    """
    points1, points2 = check_pairs(points1, points2, least=1)
    F = check_two_view(F)
    d1 = line_distance(points1, epipolar_lines(points2, F.T))
    d2 = line_distance(points2, epipolar_lines(points1, F))
    return np.asarray(np.sqrt((d1 * d1 + d2 * d2) / 2))


def sampson_error(points1: ArrayLike, points2: ArrayLike, F: ArrayLike) -> Array:
    """Return how far pairs would have to move, both points together, to satisfy F: nearly.

    Parameters
    ----------
    points1, points2 : array_like, shape (N, 2)
        Pixels of picture 1, and their partners in picture 2.
    F : array_like, shape (3, 3)
        Fundamental matrix.

    Returns
    -------
    ndarray, shape (N,)
        ``|x2ᵀ F x1| / √((F x1)₁² + (F x1)₂² + (Fᵀ x2)₁² + (Fᵀ x2)₂²)`` in px: the root of the sum
        of the squares of both shifts, to first order. (Some programs give its square.) Zero
        where both points are epipoles.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, or F is zero.

    References
    ----------
    P. D. Sampson, Computer Graphics and Image Processing 18 (1982); Hartley & Zisserman, Multiple
    View Geometry, 2nd ed., equation 11.9.

    Examples
    --------
    >>> F = np.array([[0, 0, 0], [0, 0, -1], [0, 1, 0]])
    >>> sampson_error([[10, 30]], [[5, 32]], F).round(4)  # each moves by one row
    array([1.4142])
    """
    points1, points2 = check_pairs(points1, points2, least=1)
    F = unit(check_two_view(F))
    return np.abs(sampson_residuals(F, to_homogeneous(points1).T, to_homogeneous(points2).T))


def sampson_residuals(F: Array, x1: Array, x2: Array) -> Array:
    """Return signed Sampson errors, (..., N), of F, (..., 3, 3), for columns of pixels (3, N)."""
    l2 = F @ x1
    l1 = F[..., :2].swapaxes(-1, -2) @ x2
    e = (l2[..., :2, :] * x2[:2]).sum(axis=-2) + l2[..., 2, :]  # the last row of x2 is 1
    l1 *= l1
    square = l1[..., 0, :] + l1[..., 1, :]
    l2 = l2[..., :2, :] * l2[..., :2, :]
    square += l2[..., 0, :]
    square += l2[..., 1, :]
    np.maximum(square, 1e-300, out=square)
    return np.asarray(e / np.sqrt(square))


def check_pairs(points1: ArrayLike, points2: ArrayLike, least: int) -> tuple[Array, Array]:
    """Return pixels of two pictures that belong together in rows: so many pairs or more."""
    return check_correspondences(points1, points2, (2, 2), ("points1", "points2"), least)
