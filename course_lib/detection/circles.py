"""Pictures of circles: ellipses, whose centre is not the picture of the circle's centre.

The nearer half of a tilted circle is drawn larger than the farther half, so the middle of its
picture lies too near. A dot's centroid is off by this much.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_intrinsics,
    check_length,
    check_points,
    check_rotation,
    check_vector,
)
from course_lib.distortion.model import distort

#: Corners of the polygon that stands for a circle.
CORNERS = 48


def image_of_circles(H: Array, centres: Array, radius: float) -> Array:
    """Return the pictures of circles of a plane.

    Parameters
    ----------
    H : ndarray, shape (3, 3)
        From the plane to the picture.
    centres : ndarray, shape (N, 2)
        On the plane.
    radius : float
        In the same unit.

    Returns
    -------
    ndarray, shape (N, 3, 3)
        Conics: ``xᵀ C x = 0`` for the pixels ``x`` of the outline.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., result 2.13: ``C' = H⁻ᵀ C H⁻¹``.
    """
    x, y = centres.T
    one, none = np.ones_like(x), np.zeros_like(x)
    rows = [one, none, -x, none, one, -y, -x, -y, x * x + y * y - radius**2]
    inverse = np.linalg.inv(H)
    return np.asarray(inverse.T @ np.stack(rows, axis=1).reshape(-1, 3, 3) @ inverse)


def circle_bias(
    centres: ArrayLike, radius: float, K: ArrayLike, R: ArrayLike, t: ArrayLike
) -> Array:
    """Return how far the middles of pictures of circles are from the pictures of their centres.

    Parameters
    ----------
    centres : array_like, shape (N, 3)
        Centres of circles in the plane z = 0 of a board, in any unit of length.
    radius : float
        Of the circles, in the same unit.
    K : array_like, shape (3, 3)
        Intrinsics, px; the camera is without distortion.
    R, t : array_like, shape (3, 3) and (3,)
        Pose of the board: ``X_camera = R X_board + t``.

    Returns
    -------
    ndarray, shape (N, 2)
        Middle of the ellipse minus picture of the centre, px. Subtract it from centroids.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or the radius not positive.
    DegenerateConfigurationError
        If a circle reaches behind the camera, so that its picture is no ellipse.

    References
    ----------
    J. Heikkilä, Geometric camera calibration using circular control points, IEEE PAMI 22 (2000).

    Examples
    --------
    A dot of 15 mm, half a metre away and tilted by 45°:

    >>> K = [[800, 0, 320], [0, 800, 240], [0, 0, 1]]
    >>> c = np.sqrt(0.5)
    >>> circle_bias([[0, 0, 0]], 7.5, K, [[c, 0, -c], [0, 1, 0], [c, 0, c]], [0, 0, 500]).round(3)
    array([[-0.09,  0.  ]])
    """
    centres = check_points(centres, 3, "centres").reshape(-1, 3)
    radius, K = check_length(radius, "radius"), check_intrinsics(K)
    H = K @ np.column_stack([check_rotation(R)[:, :2], check_vector(t, 3, "t")])
    conics = image_of_circles(H, centres[:, :2], radius)
    if (np.linalg.det(conics[:, :2, :2]) <= 0).any():
        raise DegenerateConfigurationError(
            "a circle reaches behind the camera: its picture is no ellipse and has no middle"
        )
    middles = np.linalg.solve(conics[:, :2, :2], -conics[:, :2, 2:])[..., 0]
    pictures = np.column_stack([centres[:, :2], np.ones(len(centres))]) @ H.T
    return np.asarray(middles - pictures[:, :2] / pictures[:, 2:])


def distorted_circle_bias(
    centres: ArrayLike,
    radius: float,
    K: ArrayLike,
    R: ArrayLike,
    t: ArrayLike,
    coefficients: ArrayLike,
) -> Array:
    """Return how far the centroids of pictures of circles are off, through a lens that distorts.

    Parameters
    ----------
    centres, radius, K, R, t
        As for `circle_bias`.
    coefficients : array_like
        Distortion as in `course_lib.distortion.distort`.

    Returns
    -------
    ndarray, shape (N, 2)
        Centroid of the picture of the disk minus picture of its centre, px.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or the radius not positive.
    DegenerateConfigurationError
        If a circle reaches behind the camera.

    References
    ----------
    The centroid of a polygon, by Green's theorem; a circle has 48 corners here.

    Examples
    --------
    >>> K = [[800, 0, 320], [0, 800, 240], [0, 0, 1]]
    >>> distorted_circle_bias([[100, 0, 0]], 15, K, np.eye(3), [0, 0, 500], [-0.2]).round(3)
    array([[-0.086,  0.   ]])
    """
    centres = check_points(centres, 3, "centres").reshape(-1, 3)
    radius, K = check_length(radius, "radius"), check_intrinsics(K)
    R, t = check_rotation(R), check_vector(t, 3, "t")
    turn = np.arange(CORNERS) * 2 * np.pi / CORNERS
    # A polygon of the same area.
    radius *= np.sqrt(2 * np.pi / CORNERS / np.sin(2 * np.pi / CORNERS))
    rim = radius * np.stack([np.cos(turn), np.sin(turn), np.zeros(CORNERS)], axis=1)
    X = np.concatenate([centres[:, None] + rim, centres[:, None]], axis=1) @ R.T + t
    if (X[..., 2] <= 0).any():
        raise DegenerateConfigurationError("a circle reaches behind the camera: it has no picture")
    ideal = (X[..., :2] / X[..., 2:]).reshape(-1, 2)
    pixels = (distort(ideal, coefficients) @ K[:2, :2].T + K[:2, 2]).reshape(*X.shape[:2], 2)
    return _centroids(pixels[:, :-1] - pixels[:, -1:])


def _centroids(polygons: Array) -> Array:
    """Return the centroids of the areas of polygons, shape (N, M, 2)."""
    after = np.roll(polygons, -1, axis=1)
    area = polygons[..., 0] * after[..., 1] - after[..., 0] * polygons[..., 1]
    moment = ((polygons + after) * area[..., None]).sum(axis=1)
    return np.asarray(moment / (3 * area.sum(axis=1, keepdims=True)))
