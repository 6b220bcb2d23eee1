"""Points from two pictures, all at once, by the answer that moves the pixels least.

Each pair of pixels is moved to the nearest pair whose rays meet (to first order), then the point
is where they meet. Use `triangulate` through `course_lib.triangulation`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, DegenerateConfigurationError, check_points
from course_lib.epipolar.matrices import transfer_and_epipole
from course_lib.transforms.rotations import skew

#: So many points are worked on together: their intermediate results stay in the cache.
BLOCK = 4096
#: Rays that are parallel but for rounding: their angle, in rad.
PARALLEL = 1e-12


def triangulate(points1: ArrayLike, points2: ArrayLike, P1: ArrayLike, P2: ArrayLike) -> Array:
    """Return the points of space that two cameras see at pairs of pixels.

    Of all pairs of pixels whose rays meet, the nearest to the measured ones is taken, in one step
    of Sampson's: it differs from the nearest one by far less than the error of a pixel.

    Parameters
    ----------
    points1, points2 : array_like, shape (N, 2) or (2,)
        Pixels of picture 1 without distortion, and their partners in picture 2.
    P1, P2 : array_like, shape (3, 4)
        Camera matrices.

    Returns
    -------
    ndarray, shape (N, 3) or (3,)
        Points in the world frame of the cameras. A wrong pair may give a point behind a camera.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or a number is not finite.
    DegenerateConfigurationError
        If both cameras are at the same place, the centre of one is at infinity, or two rays are
        parallel: the first such pair is named.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., sections 12.3 and 12.4 (Sampson).

    Examples
    --------
    >>> P1 = np.array([[800, 0, 320, 0], [0, 800, 240, 0], [0, 0, 1, 0]])
    >>> P2 = P1 - [[0, 0, 0, 800], [0, 0, 0, 0], [0, 0, 0, 0]]
    >>> triangulate([[520, 240]], [[320, 240]], P1, P2).round(9)
    array([[1., 0., 4.]])
    """
    one, other = check_points(points1, 2, "points1"), check_points(points2, 2, "points2")
    if one.shape != other.shape:
        raise ValueError(
            f"points1 and points2 belong together row by row, got {one.shape} and {other.shape}"
        )
    A, e, centre, back = transfer_and_epipole(P1, P2)
    F = skew(e) @ A
    F /= np.abs(F).max() or 1
    flat1, flat2 = one.reshape(-1, 2), other.reshape(-1, 2)
    found = np.empty((len(flat1), 3))
    for start in range(0, len(found), BLOCK):
        part = slice(start, start + BLOCK)
        x1, x2 = meeting_pixels(flat1[part], flat2[part], F)
        depths = _depths(x1, x2, A, e, start)
        x1 *= depths
        np.add((back @ x1).T, centre, out=found[part])
    return found.reshape(*one.shape[:-1], 3)


def meeting_pixels(points1: Array, points2: Array, F: Array) -> tuple[Array, Array]:
    """Return homogeneous pixels, (3, n), moved by Sampson's step so that their rays nearly meet."""
    x1, x2 = np.ones((3, len(points1))), np.ones((3, len(points1)))
    x1[:2], x2[:2] = points1.T, points2.T
    l2, l1 = F @ x1, F[:, :2].T @ x2
    products = x2[:2] * l2[:2]
    error = products[0] + products[1]
    error += l2[2]
    l2 = l2[:2]
    square = np.einsum("in,in->n", l2, l2)
    square += np.einsum("in,in->n", l1, l1)
    # Where both points are epipoles there is nothing to move.
    np.maximum(square, 1e-300, out=square)
    error /= square
    l1 *= error
    l2 *= error
    x1[:2] -= l1
    x2[:2] -= l2
    return x1, x2


def _depths(x1: Array, x2: Array, A: Array, e: Array, first: int) -> Array:
    """Return how far along the ray of x1 its point is: ``x2 ~ λ A x1 + e``, two equations for λ."""
    a = A @ x1
    left = x2[:2] * a[2]
    left -= a[:2]
    right = e[:2, None] - x2[:2] * e[2]
    size = np.einsum("in,in->n", left, left)
    limit = PARALLEL**2 * np.einsum("in,in->n", a, a)
    if not (size > limit).all():
        raise DegenerateConfigurationError(
            f"the rays of pair {first + int(np.argmin(size > limit))} (counted from 0) are "
            "parallel: its point is infinitely far away; leave the pair out, or use a longer "
            "baseline"
        )
    depths: Array = np.einsum("in,in->n", left, right)
    depths /= size
    return depths
