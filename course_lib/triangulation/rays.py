"""Rays: where two of them come closest, and where one meets a plane.

Use these functions through `course_lib.triangulation`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.camera.projection import check_finite_camera
from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_direction,
    check_directions,
    check_points,
    check_vector,
)

#: The sine of an angle between rays that are parallel but for rounding.
PARALLEL = 1e-12
FAR_AWAY = (
    "the rays of pair {0} (counted from 0) are parallel: they meet nowhere, or their point is "
    "infinitely far away; leave the pair out, or use a longer baseline"
)


def closest_points_on_rays(
    origin1: ArrayLike, directions1: ArrayLike, origin2: ArrayLike, directions2: ArrayLike
) -> tuple[Array, Array]:
    """Return the points in which pairs of lines of sight come closest to each other.

    The vector between both points is perpendicular to both lines, ``d1 × d2`` times a number:
    ``o1 + λ1 d1 + μ (d1 × d2) = o2 + λ2 d2`` are three equations for three unknowns.

    Parameters
    ----------
    origin1, origin2 : array_like, shape (3,)
        Where the rays begin: the centres of two cameras.
    directions1, directions2 : array_like, shape (N, 3) or (3,)
        Where they go; of any length but zero.

    Returns
    -------
    points1, points2 : ndarray, shape (N, 3) or (3,)
        The point of each first line that is nearest to the second one, and the other way round.
        They may lie behind a camera: a line of sight goes on there.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, or a direction is zero.
    DegenerateConfigurationError
        If the lines of a pair are parallel, or both origins are the same.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 11.2.4.

    Examples
    --------
    >>> one, other = closest_points_on_rays([0, 0, 0], [0, 0, 1], [1, 2, 0], [-1, 0, 5])
    >>> one, other
    (array([0., 0., 5.]), array([0., 2., 5.]))
    """
    o1, o2 = check_vector(origin1, 3, "origin1"), check_vector(origin2, 3, "origin2")
    d1 = _unit(check_directions(directions1, "directions1"))
    d2 = _unit(check_directions(directions2, "directions2"))
    if d1.shape != d2.shape:
        raise ValueError(f"each ray needs a partner, got shapes {d1.shape} and {d2.shape}")
    check_apart(o1, o2)
    normal = np.cross(d1, d2)
    square = (normal * normal).sum(axis=-1, keepdims=True)
    parallel = np.atleast_1d(square[..., 0] <= PARALLEL**2)
    if parallel.any():
        raise DegenerateConfigurationError(FAR_AWAY.format(int(np.argmax(parallel))))
    # Cramer's rule: λ1 = det(o2 - o1, d2, n) / |n|², and λ2 with d1 in the place of d2.
    length1 = (np.cross(o2 - o1, d2) * normal).sum(axis=-1, keepdims=True) / square
    length2 = (np.cross(o2 - o1, d1) * normal).sum(axis=-1, keepdims=True) / square
    return o1 + length1 * d1, o2 + length2 * d2


def triangulate_midpoint(
    points1: ArrayLike, points2: ArrayLike, P1: ArrayLike, P2: ArrayLike
) -> Array:
    """Return the points halfway between the lines of sight of two cameras.

    Easy to picture, but not the best answer: a ray that comes from far away counts as much as one
    from near by. See `triangulate`.

    Parameters
    ----------
    points1, points2 : array_like, shape (N, 2) or (2,)
        Pixels of picture 1 without distortion, and their partners in picture 2.
    P1, P2 : array_like, shape (3, 4)
        Camera matrices.

    Returns
    -------
    ndarray, shape (N, 3) or (3,)
        Points in the world frame of the cameras.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit or a number is not finite.
    DegenerateConfigurationError
        If both cameras are at the same place, the centre of one is at infinity, or two rays are
        parallel.

    References
    ----------
    R. Hartley & P. Sturm, "Triangulation", CVIU 68 (1997), section 5.3.

    Examples
    --------
    >>> P1 = np.array([[800, 0, 320, 0], [0, 800, 240, 0], [0, 0, 1, 0]])
    >>> P2 = P1 - [[0, 0, 0, 800], [0, 0, 0, 0], [0, 0, 0, 0]]
    >>> triangulate_midpoint([520, 240], [320, 240], P1, P2).round(9)
    array([1., 0., 4.])
    """
    rays1, rays2 = _rays(points1, P1, "points1"), _rays(points2, P2, "points2")
    one, other = closest_points_on_rays(*rays1, *rays2)
    return np.asarray((one + other) / 2)


def intersect_ray_plane(origin: ArrayLike, directions: ArrayLike, plane: ArrayLike) -> Array:
    """Return where rays meet a plane: a laser's sheet of light, a projector's stripe, the ground.

    Parameters
    ----------
    origin : array_like, shape (3,)
        Where the rays begin.
    directions : array_like, shape (N, 3) or (3,)
        Where they go; of any length but zero.
    plane : array_like, shape (4,)
        ``(a, b, c, d)`` with ``a X + b Y + c Z + d = 0``, of any scale.

    Returns
    -------
    ndarray, shape (N, 3) or (3,)
        The points; a row of NaN for a ray that goes away from the plane: the camera does not see
        it there.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, a direction is zero, or a, b and c are zero.
    DegenerateConfigurationError
        If a ray is parallel to the plane, or begins on it.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 13.2.1 (active rangefinding).

    Examples
    --------
    >>> intersect_ray_plane([0, 0, 2], [[1, 0, -1], [0, 0, 1]], [0, 0, 1, 0])  # the ground
    array([[ 2.,  0.,  0.],
           [nan, nan, nan]])
    """
    origin, directions = check_vector(origin, 3, "origin"), check_directions(directions, "rays")
    plane = check_vector(plane, 4, "plane")
    normal = check_direction(plane[:3], "the plane's normal (a, b, c)")
    unit = _unit(directions)
    size = np.linalg.norm(normal)
    slope = unit @ normal / size
    if (np.abs(slope) <= PARALLEL).any():
        first = int(np.argmax(np.atleast_1d(np.abs(slope) <= PARALLEL)))
        raise DegenerateConfigurationError(
            f"ray {first} (counted from 0) is parallel to the plane: leave it out, or turn the "
            "plane towards the camera"
        )
    height = float(normal @ origin + plane[3]) / size
    if abs(height) <= PARALLEL * (np.linalg.norm(origin) + abs(plane[3]) / size):
        raise DegenerateConfigurationError(
            "the rays begin on the plane: the camera sees it as a line; move one of them"
        )
    along = -height / slope
    along = np.where(along > 0, along, np.nan)
    return np.asarray(origin + along[..., None] * unit)


def check_apart(centre1: Array, centre2: Array) -> None:
    """Raise if two centres are the same, but for rounding."""
    apart = np.abs(centre1 - centre2).max()
    if apart <= 1e-14 * max(np.abs(centre1).max(), np.abs(centre2).max()):
        raise DegenerateConfigurationError(
            "both rays begin at the same place (zero baseline): one place tells directions only; "
            "move the camera"
        )


def _rays(points: ArrayLike, P: ArrayLike, name: str) -> tuple[Array, Array]:
    """Return a camera's centre and the directions of pixels."""
    pixels, P = check_points(points, 2, name), check_finite_camera(P)
    inverse = np.linalg.inv(P[:, :3] * np.sign(np.linalg.det(P[:, :3])))
    directions = pixels @ inverse[:, :2].T + inverse[:, 2]
    return -np.asarray(np.linalg.solve(P[:, :3], P[:, 3])), directions


def _unit(directions: Array) -> Array:
    """Return directions of length 1."""
    directions = directions / np.abs(directions).max(axis=-1, keepdims=True)
    return np.asarray(directions / np.linalg.norm(directions, axis=-1, keepdims=True))
