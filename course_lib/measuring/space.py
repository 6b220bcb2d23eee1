"""Lengths in space, from two or more pictures.

Use these functions through `course_lib.measuring`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from course_lib.camera import camera_matrix
from course_lib.checks import Array, check_numbers, check_points
from course_lib.distortion import undistort_pixels
from course_lib.measuring.measured import Measured
from course_lib.measuring.plane import length_and_line
from course_lib.measuring.shares import check_sigmas, shares
from course_lib.measuring.view import View, pixels_and_slopes
from course_lib.triangulation import refine_point, triangulate_linear


def point_in_space(pixels: ArrayLike, views: Sequence[View]) -> Array:
    """Return the points that are seen at these pixels of several pictures.

    Parameters
    ----------
    pixels : array_like, shape (V, N, 2) or (V, 2)
        Pixels of N points, or one, in V ≥ 2 real pictures.
    views : sequence of View
        The pictures: as `views_of_pair` gives them, or `view_of_target` for pictures between which
        neither the target nor the object has moved.

    Returns
    -------
    ndarray, shape (N, 3) or (3,)
        Points with the smallest reprojection error, in the frame of the target or, for a pair, of
        the left camera.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, the distortion cannot be undone at a pixel, or
        the pixels show no point before the cameras.
    DegenerateConfigurationError
        If the cameras are at the same place, or the rays of a point are parallel.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., sections 12.2 and 12.3.
    """
    seen = check_numbers(pixels, "pixels")
    if seen.ndim not in (2, 3) or seen.shape[-1] != 2 or len(seen) != len(views):
        raise ValueError(
            f"pixels must have shape (V, N, 2) or (V, 2) for V = {len(views)} views, got "
            f"{seen.shape}"
        )
    straight = np.stack(
        [undistort_pixels(own, v.K, v.coefficients) for own, v in zip(seen, views, strict=True)]
    )
    if np.isnan(straight).any():
        raise ValueError(
            "the lens model says nothing about one of these pixels: it is too far outside; point "
            "nearer to the middle of the picture"
        )
    cameras = [camera_matrix(view.K, view.R, view.t) for view in views]
    return refine_point(triangulate_linear(straight, cameras), straight, cameras)


def rays_miss(pixels: ArrayLike, views: Sequence[View]) -> float:
    """Return how far the rays of the same points miss each other, in the pictures.

    Two pictures give four numbers for the three of a point: one is left over, and tells whether
    all of them belong together. Much more than what was pointed with means that something has
    moved between the pictures, or that two different points were taken for one.

    Parameters
    ----------
    pixels : array_like, shape (V, N, 2) or (V, 2)
        As for `point_in_space`.
    views : sequence of View
        As for `point_in_space`.

    Returns
    -------
    float
        Standard deviation of a coordinate of a pixel, px, judged by the residuals r of all points:
        ``√(Σ r² / (N (2 V - 3)))``.

    Raises
    ------
    TypeError, ValueError, DegenerateConfigurationError
        As `point_in_space`.

    References
    ----------
    E. M. Mikhail, F. Ackermann, Observations and Least Squares, chapter 4 (reference variance).
    """
    points = np.atleast_2d(point_in_space(pixels, views))
    seen = np.asarray(pixels, float).reshape(len(views), -1, 2)
    squares = sum(
        float(((pixels_and_slopes(view, points)[0] - own) ** 2).sum())
        for view, own in zip(views, seen, strict=True)
    )
    return float(np.sqrt(squares / (len(points) * (2 * len(views) - 3))))


def distance_in_space(
    one: ArrayLike,
    other: ArrayLike,
    views: Sequence[View],
    pointing: float = 0.5,
    scale: float = 0.0,
) -> Measured:
    """Return the distance of two points that are seen in two or more pictures.

    With the derivatives J of all pixels of a point by the point, ``M = (Jᵀ J)⁻¹ Jᵀ`` moves it by
    ``M (δpixels - J_θ δθ - Jₚ δp)``. Both points share poses and camera, so the moves that these
    cause are subtracted before they are squared.

    Parameters
    ----------
    one, other : array_like, shape (V, 2)
        Pixels of both points in each picture.
    views : sequence of View
        As for `point_in_space`.
    pointing : float
        Standard deviation of each coordinate of a pixel pointed at, px; see `pointing_sigma`.
    scale : float
        Relative standard deviation of the target's lengths.

    Returns
    -------
    Measured
        With the parts ``"pointing"``, ``"pose"``, ``"camera"`` and ``"target"`` (its corners), and
        ``"scale"`` if it is given.

    Raises
    ------
    TypeError, ValueError
        As `point_in_space`; also if a standard deviation is negative, or both points are the same.
    DegenerateConfigurationError
        As `point_in_space`.

    References
    ----------
    E. M. Mikhail, F. Ackermann, Observations and Least Squares, chapter 4; Hartley & Zisserman,
    Multiple View Geometry, 2nd ed., section 5.2 (covariance of an estimate).
    """
    check_sigmas(pointing, scale=scale)
    both = [check_points(p, 2, name) for p, name in ((one, "one"), (other, "other"))]
    points = np.stack([point_in_space(pixels, views) for pixels in both])
    value, line = length_and_line(points)
    states, slopes = zip(*(pixels_and_slopes(view, points)[1:] for view in views), strict=True)
    J = np.stack(slopes, axis=1).reshape(2, 2 * len(views), 3)
    # One row for each point: how the length answers when its pixels are moved.
    towards = np.array([-line, line])[..., None]
    weights = np.linalg.solve(J.swapaxes(1, 2) @ J, towards)
    by_pixel = (J @ weights).reshape(2, len(views), 2)
    by_state = [-np.einsum("ki,kij->j", by_pixel[:, i], s) for i, s in enumerate(states)]
    parts = shares(views, by_state, by_pixel)
    parts["pointing"] *= pointing
    return Measured(value, parts | ({"scale": scale * value} if scale else {}))
