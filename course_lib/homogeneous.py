"""Homogeneous coordinates: points and lines of the plane as three numbers up to scale.

A point ``(x, y)`` is ``w (x, y, 1)`` for any ``w`` but zero; ``(x, y, 0)`` is the point at
infinity in the direction ``(x, y)``. A line ``a x + b y + c = 0`` is ``(a, b, c)``, also up to
scale. A point lies on a line where their scalar product is zero.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    SMALLEST,
    Array,
    DegenerateConfigurationError,
    check_directions,
    check_matrix,
    check_points,
    check_rows,
)

#: The line on which all points at infinity lie.
LINE_AT_INFINITY = np.array([0.0, 0.0, 1.0])
LINE_AT_INFINITY.setflags(write=False)


def to_homogeneous(points: ArrayLike) -> Array:
    """Return points in homogeneous coordinates.

    Parameters
    ----------
    points : array_like, shape (N, d) or (d,)
        Points in rows, of the plane (d = 2), of space (d = 3) or of any other dimension.

    Returns
    -------
    ndarray, shape (N, d + 1) or (d + 1,)
        The same points with a 1 appended.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong or a number is not finite.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 2.2.1.

    Examples
    --------
    >>> to_homogeneous(np.array([[3.0, 4.0], [5.0, 6.0]]))
    array([[3., 4., 1.],
           [5., 6., 1.]])
    """
    points = check_rows(points, "points", least=1)
    return np.concatenate([points, np.ones_like(points[..., :1])], axis=-1)


def from_homogeneous(points: ArrayLike) -> Array:
    """Return the ordinary coordinates of points that are given in homogeneous ones.

    Parameters
    ----------
    points : array_like, shape (N, d + 1) or (d + 1,)
        Homogeneous points in rows; the last number of each is ``w``.

    Returns
    -------
    ndarray, shape (N, d) or (d,)
        The points. A point at infinity, ``w = 0``, has no ordinary coordinates: its row is NaN.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong or a number is not finite.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 2.2.1.

    Examples
    --------
    >>> from_homogeneous(np.array([[6, 8, 2], [1, 1, 0]]))
    array([[ 3.,  4.],
           [nan, nan]])
    """
    points = check_rows(points, "points", least=2)
    w = points[..., -1:]
    # A w below SMALLEST counts as zero: the quotient would overflow.
    return points[..., :-1] / np.where(np.abs(w) >= SMALLEST, w, np.nan)


def line_through(p: ArrayLike, q: ArrayLike) -> Array:
    """Return the line that joins two points of the plane.

    Parameters
    ----------
    p, q : array_like, shape (3,) or (N, 3)
        Homogeneous points, in rows; they may be at infinity.

    Returns
    -------
    ndarray, shape (3,) or (N, 3)
        Homogeneous lines ``(a, b, c)``, with ``a x + b y + c = 0``; their scale has no meaning.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or a row is zero, which is no point.
    DegenerateConfigurationError
        If the two points are the same (to twelve digits).

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 2.2.1, result 2.4.

    Examples
    --------
    >>> line_through(np.array([0.0, 1, 1]), np.array([1.0, 1, 1]))  # y = 1
    array([ 0.,  1., -1.])
    """
    p, q = check_directions(p, "p"), check_directions(q, "q")
    check_distinct(p, q, "points p and q")
    return np.cross(p, q)


def meet(l: ArrayLike, m: ArrayLike) -> Array:  # noqa: E741 (the formula's name)
    """Return the point in which two lines of the plane meet.

    Parameters
    ----------
    l, m : array_like, shape (3,) or (N, 3)
        Homogeneous lines, in rows.

    Returns
    -------
    ndarray, shape (3,) or (N, 3)
        Homogeneous points, whose scale has no meaning. Parallel lines meet at infinity, ``w = 0``.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or a row is zero, which is no line.
    DegenerateConfigurationError
        If the two lines are the same (to twelve digits).

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 2.2.1, result 2.2.

    Examples
    --------
    >>> meet(np.array([1.0, 0, -2]), np.array([0.0, 1, -3]))  # x = 2 and y = 3
    array([2., 3., 1.])
    >>> meet(np.array([1.0, 0, -2]), np.array([1.0, 0, -5]))  # x = 2 and x = 5 meet at infinity
    array([0., 3., 0.])
    """
    first, second = check_directions(l, "l"), check_directions(m, "m")
    check_distinct(first, second, "lines l and m")
    return np.cross(first, second)


def check_distinct(a: Array, b: Array, what: str) -> None:
    """Raise an error if two homogeneous vectors, or rows of them, are the same up to scale."""
    if a.ndim == b.ndim and a.shape != b.shape:
        raise ValueError(f"the {what} must be as many, got shapes {a.shape} and {b.shape}")
    a, b = (v / np.abs(v).max(axis=-1, keepdims=True) for v in (a, b))
    if (np.linalg.norm(np.cross(a, b), axis=-1) <= 1e-12).any():
        raise DegenerateConfigurationError(f"the {what} are the same: move one of them")


def apply_homography(points: ArrayLike, H: ArrayLike) -> Array:
    """Return points of the plane after a projective transformation.

    Parameters
    ----------
    points : array_like, shape (N, 2) or (2,)
        Ordinary points, in rows.
    H : array_like, shape (3, 3)
        The transformation, invertible; its scale has no meaning. Affine ones have the last row
        ``(0, 0, 1)`` and keep parallel lines parallel.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Where the points go; a row of NaN for a point that goes to infinity.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or a number is not finite.
    DegenerateConfigurationError
        If `H` is singular: it squeezes the plane into a line or a point.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 2.3.

    Examples
    --------
    >>> H = np.array([[1, 0, 10], [0, 1, 20], [0, 0, 1]])
    >>> apply_homography(np.array([1, 2]), H)
    array([11., 22.])
    """
    points = check_points(points, 2, "points")
    return from_homogeneous(to_homogeneous(points) @ check_invertible(H).T)


def map_lines(lines: ArrayLike, H: ArrayLike) -> Array:
    """Return lines of the plane after a projective transformation of its points.

    Parameters
    ----------
    lines : array_like, shape (3,) or (N, 3)
        Homogeneous lines, in rows.
    H : array_like, shape (3, 3)
        The transformation of the points, invertible.

    Returns
    -------
    ndarray, shape (3,) or (N, 3)
        The lines through the transformed points: ``l' = H⁻ᵀ l``.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or a row is zero, which is no line.
    DegenerateConfigurationError
        If `H` is singular.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., equation 2.6.

    Examples
    --------
    >>> map_lines([1, 0, -2], [[1, 0, 10], [0, 1, 0], [0, 0, 1]])  # x = 2 becomes x = 12
    array([  1.,   0., -12.])
    """
    return check_directions(lines, "lines") @ np.linalg.inv(check_invertible(H))


def cross_ratio(points: ArrayLike) -> float:
    """Return the cross-ratio of four points on a line, which no camera changes.

    Parameters
    ----------
    points : array_like, shape (4, 2) or (4, 3)
        Ordinary points A, B, C, D on one line, of the plane or of space.

    Returns
    -------
    float
        ``(AC · BD) / (BC · AD)`` with signed lengths along the line: 4/3 for equal steps.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong or a number is not finite.
    DegenerateConfigurationError
        If two of the points that are divided by coincide, or the four are not on one line.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 2.5.

    Examples
    --------
    >>> round(cross_ratio([[0, 0], [1, 0], [2, 0], [3, 0]]), 12)
    1.333333333333
    """
    points = check_rows(points, "points", least=2)
    if points.shape not in ((4, 2), (4, 3)):
        raise ValueError(f"points must have shape (4, 2) or (4, 3), got {points.shape}")
    centred = points - points.mean(axis=0)
    _, sizes, directions = np.linalg.svd(centred)
    if sizes[1] > 1e-6 * sizes[0]:
        raise DegenerateConfigurationError("the four points are not on one line")
    a, b, c, d = centred @ directions[0]
    if b == c or a == d:
        raise DegenerateConfigurationError("B and C, or A and D, coincide: move one of them")
    return float((c - a) * (d - b) / ((c - b) * (d - a)))


def check_invertible(H: ArrayLike) -> Array:
    """Return `H`, shape (3, 3), once it is sure to map the plane to a plane."""
    H = check_matrix(H, (3, 3), "H")
    sizes = np.linalg.svd(H, compute_uv=False)
    if sizes[2] <= 1e-14 * sizes[0]:
        raise DegenerateConfigurationError("H is singular: it does not map the plane to a plane")
    return H
