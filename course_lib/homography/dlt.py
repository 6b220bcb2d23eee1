"""A homography from points and their images: normalised direct linear transformation."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_rows
from course_lib.correspondences import check_plane_pairs, check_spread
from course_lib.homography.fit import (
    check_plane_kept,
    with_usual_scale,
)
from course_lib.least_squares.linear import solve_homogeneous


def normalise_points(points: ArrayLike) -> tuple[Array, Array]:
    """Return points moved to the origin and scaled to a usual size, and the matrix that does it.

    Parameters
    ----------
    points : array_like, shape (N, d)
        Points in rows, of the plane (d = 2) or of space (d = 3), not all the same.

    Returns
    -------
    normalised : ndarray, shape (N, d)
        The points, shifted so that their mean is the origin, then all scaled by one factor so that
        their mean distance from it is √d: √2 in the plane, √3 in space.
    T : ndarray, shape (d + 1, d + 1)
        The matrix that takes each ``(x, y, 1)`` to its normalised point, in homogeneous
        coordinates.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong or a number is not finite.
    DegenerateConfigurationError
        If all points are the same.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 4.4.4.

    Examples
    --------
    >>> normalised, T = normalise_points(np.array([[0, 0], [4, 0], [4, 4], [0, 4]]))
    >>> T
    array([[ 0.5,  0. , -1. ],
           [ 0. ,  0.5, -1. ],
           [ 0. ,  0. ,  1. ]])
    """
    points = check_rows(points, "points")
    points = points[None] if points.ndim == 1 else points
    check_spread(points, 1, "points")
    d = points.shape[1]
    centre = points.mean(axis=0)
    scale = np.sqrt(d) / np.linalg.norm(points - centre, axis=1).mean()
    T = np.diag([scale] * d + [1.0])
    T[:d, d] = -scale * centre
    return scale * (points - centre), T


def homography_dlt(points: ArrayLike, targets: ArrayLike) -> Array:
    """Return the homography that takes points to their targets, by the normalised DLT.

    Points and targets are normalised by `normalise_points`. Each pair gives two rows of A. Of all
    vectors h of length 1, the one is taken for which ``A h`` is shortest.

    Parameters
    ----------
    points : array_like, shape (N, 2)
        N ≥ 4 points in rows.
    targets : array_like, shape (N, 2)
        Where each of them should go, with errors.

    Returns
    -------
    ndarray, shape (3, 3)
        H with ``H[2, 2] = 1``, or of length 1 if that entry is zero.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or there are fewer than four points.
    DegenerateConfigurationError
        If the points or the targets are on one line, or all but one of them are.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., algorithm 4.2.

    Examples
    --------
    >>> square = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    >>> homography_dlt(square, square * [2, 3]).round(9) + 0.0
    array([[2., 0., 0.],
           [0., 3., 0.],
           [0., 0., 1.]])
    """
    points, targets = check_plane_pairs(points, targets)
    near_points, T_points = normalise_points(points)
    near_targets, T_targets = normalise_points(targets)
    (u, v), (x, y) = near_points.T, near_targets.T
    one, zero = np.ones_like(u), np.zeros_like(u)
    rows_x = np.stack([u, v, one, zero, zero, zero, -x * u, -x * v, -x], axis=1)
    rows_y = np.stack([zero, zero, zero, u, v, one, -y * u, -y * v, -y], axis=1)
    H = solve_homogeneous(np.concatenate([rows_x, rows_y])).reshape(3, 3)
    check_plane_kept(H)
    return with_usual_scale(np.linalg.inv(T_targets) @ H @ T_points)
