"""The fits of the lesson: one unknown, a line, an affine map."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import SMALLEST, Array, DegenerateConfigurationError
from course_lib.correspondences import (
    check_correspondences,
    check_number_pairs,
    check_spread,
)
from course_lib.least_squares.linear import (
    solve_qr,
)


def solve_one_unknown(a: ArrayLike, b: ArrayLike) -> float:
    """Return the one unknown x for which the equations ``a x = b`` are best fulfilled.

    Parameters
    ----------
    a, b : array_like, shape (N,)
        Left and right numbers of N equations ``a[i] x = b[i]`` that contradict each other a little.

    Returns
    -------
    float
        The x for which the sum of the squares ``(a[i] x - b[i])²`` is smallest.

    Raises
    ------
    TypeError, ValueError
        If the shapes differ or a number is not finite.
    DegenerateConfigurationError
        If all of `a` is zero: then x may be anything.

    References
    ----------
    G. Strang, Introduction to Linear Algebra, 5th ed., section 4.2.

    Examples
    --------
    >>> solve_one_unknown(np.array([2, 3, 4]), np.array([2, 3, 4]))
    1.0
    >>> twice = np.array([10, 20])  # two measurements of one length: x is their mean
    >>> solve_one_unknown(np.array([1, 1]), twice)
    15.0
    """
    a, b = check_number_pairs(a, b, ("a", "b"))
    if np.abs(a).max() < SMALLEST:  # as good as zero
        raise DegenerateConfigurationError("all numbers of a are zero: x may be anything")
    return float(a @ b / (a @ a))


def fit_line(x: ArrayLike, y: ArrayLike) -> tuple[float, float]:
    """Return the line ``y = slope x + intercept`` that fits points best, measured along y.

    Parameters
    ----------
    x, y : array_like, shape (N,)
        Coordinates of N ≥ 2 points. The errors are in `y`: x is what was set, y what was measured.

    Returns
    -------
    slope, intercept : float
        Those for which the sum of the squares ``(slope x[i] + intercept - y[i])²`` is smallest.

    Raises
    ------
    TypeError, ValueError
        If the shapes differ, a number is not finite, or there are fewer than two points.
    DegenerateConfigurationError
        If all x are the same (to twelve digits): the line is vertical or a point.

    References
    ----------
    G. Strang, Introduction to Linear Algebra, 5th ed., section 4.3.

    Examples
    --------
    >>> slope, intercept = fit_line(np.array([0, 1, 2]), np.array([1, 3, 5]))
    >>> round(slope, 9), round(intercept, 9)
    (2.0, 1.0)
    """
    x, y = check_number_pairs(x, y, ("x", "y"), least=2)
    if np.ptp(x) <= 1e-12 * np.abs(x).max():
        raise DegenerateConfigurationError(
            "all x are the same, so there is no slope: measure at different x"
        )
    A = np.stack([x, np.ones_like(x)], axis=1)  # a row (x, 1) for each point
    slope, intercept = solve_qr(A, y)
    return float(slope), float(intercept)


def fit_affine(points: ArrayLike, targets: ArrayLike) -> Array:
    """Return the affine map of the plane that takes points to their targets best.

    Parameters
    ----------
    points : array_like, shape (N, 2)
        N ≥ 3 points in rows, not all on one line.
    targets : array_like, shape (N, 2)
        Where each point should go, with errors.

    Returns
    -------
    ndarray, shape (2, 3)
        The matrix A for which the sum of the squared distances between ``A (u, v, 1)`` and the
        targets is smallest; ``(u, v)`` is a point.

    Raises
    ------
    TypeError, ValueError
        If the shapes differ, a number is not finite, or there are fewer than three points.
    DegenerateConfigurationError
        If the points are all on one line (to twelve digits).

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 2.4.3.

    Examples
    --------
    >>> points = np.array([[0, 0], [1, 0], [0, 1]])
    >>> targets = np.array([[10, 20], [12, 20], [10, 23]])
    >>> fit_affine(points, targets).round(9) + 0.0
    array([[ 2.,  0., 10.],
           [ 0.,  3., 20.]])
    """
    points, targets = check_correspondences(points, targets, (2, 2), ("points", "targets"), least=3)
    check_spread(points, 2, "points")
    X = np.concatenate([points, np.ones_like(points[:, :1])], axis=1)  # a row (u, v, 1) each
    # Two problems with the same left side: one for x, one for y.
    return solve_qr(X, targets).T
