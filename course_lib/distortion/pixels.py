"""Distortion of pixels: the intrinsics off, the lens, the intrinsics on again.

Use these functions through `course_lib.distortion`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_intrinsics, check_points
from course_lib.distortion.inverse import undistort_points
from course_lib.distortion.model import distort


def normalised_from_pixels(pixels: ArrayLike, K: ArrayLike) -> Array:
    """Return the tangents ``(X/Z, Y/Z)`` of the directions in which pixels look.

    Parameters
    ----------
    pixels : array_like, shape (N, 2) or (2,)
        Pixels ``(u, v)``, in rows.
    K : array_like, shape (3, 3)
        Intrinsics in px; the skew need not be zero.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Normalised coordinates: the point on the plane at distance 1 in front of the camera.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite or `K` is not upper triangular with positive
        focal lengths.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 6.2.4 (normalised camera).

    Examples
    --------
    >>> normalised_from_pixels([720, 240], [[800, 0, 320], [0, 800, 240], [0, 0, 1]])
    array([0.5, 0. ])
    """
    pixels, K = check_points(pixels, 2, "pixels"), check_intrinsics(K)
    y = (pixels[..., 1] - K[1, 2]) / K[1, 1]
    x = (pixels[..., 0] - K[0, 2] - K[0, 1] * y) / K[0, 0]
    return np.stack([x, y], axis=-1)


def pixels_from_normalised(points: ArrayLike, K: ArrayLike) -> Array:
    """Return the pixels of points that are given by their tangents ``(X/Z, Y/Z)``.

    Parameters
    ----------
    points : array_like, shape (N, 2) or (2,)
        Normalised coordinates, in rows.
    K : array_like, shape (3, 3)
        Intrinsics in px.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Pixels ``(u, v)``.

    Raises
    ------
    TypeError, ValueError
        As `normalised_from_pixels`.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 6.1.

    Examples
    --------
    >>> pixels_from_normalised([0.5, 0], [[800, 0, 320], [0, 800, 240], [0, 0, 1]])
    array([720., 240.])
    """
    return _on_sensor(check_points(points, 2, "points"), check_intrinsics(K))


def distort_pixels(pixels: ArrayLike, K: ArrayLike, coefficients: ArrayLike) -> Array:
    """Return where the real lens images what a pinhole would image at these pixels.

    Parameters
    ----------
    pixels : array_like, shape (N, 2) or (2,)
        Ideal pixels ``(u, v)``, in rows.
    K : array_like, shape (3, 3)
        Intrinsics in px.
    coefficients : array_like, shape (1,), (2,), (4,), (5,), (8,) or (12,)
        As in `distort`.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Pixels in the real picture.

    Raises
    ------
    TypeError, ValueError
        As `normalised_from_pixels` and `distort`.

    References
    ----------
    OpenCV, calib3d, detailed description.

    Examples
    --------
    >>> distort_pixels([720, 240], [[800, 0, 320], [0, 800, 240], [0, 0, 1]], [-0.2])
    array([700., 240.])
    """
    K = check_intrinsics(K)
    return _on_sensor(distort(normalised_from_pixels(pixels, K), coefficients), K)


def undistort_pixels(
    pixels: ArrayLike, K: ArrayLike, coefficients: ArrayLike, new_K: ArrayLike | None = None
) -> Array:
    """Return where a pinhole camera would image what the real lens images at these pixels.

    Parameters
    ----------
    pixels : array_like, shape (N, 2) or (2,)
        Pixels ``(u, v)`` of the real picture, in rows.
    K, coefficients : array_like
        Intrinsics in px, and the lens as in `distort`.
    new_K : array_like, shape (3, 3), optional
        Intrinsics of the pinhole camera; `K` unless given.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Ideal pixels; a row of NaN where `undistort_points` has one.

    Raises
    ------
    TypeError, ValueError
        As `normalised_from_pixels` and `undistort_points`.

    References
    ----------
    OpenCV, calib3d, detailed description.

    Examples
    --------
    >>> undistort_pixels([700, 240], [[800, 0, 320], [0, 800, 240], [0, 0, 1]], [-0.2]).round(9)
    array([720., 240.])
    """
    ideal = undistort_points(normalised_from_pixels(pixels, K), coefficients)
    return _on_sensor(ideal, check_intrinsics(K if new_K is None else new_K))


def _on_sensor(points: Array, K: Array) -> Array:
    """Return the pixels of normalised points, of which rows may be NaN."""
    return points @ K[:2, :2].T + K[:2, 2]
