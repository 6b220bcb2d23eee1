"""Fisheye lenses: the distance in the image follows the angle, not its tangent.

A pinhole needs an endless plane for half of what is in front of it. A fisheye lens images a ray at
the angle θ from its axis at the distance ``θ (1 + k1 θ² + k2 θ⁴ + k3 θ⁶ + k4 θ⁸)`` from the centre,
in focal lengths. Use these functions through `course_lib.distortion`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import SMALLEST, Array, check_intrinsics, check_numbers, check_points
from course_lib.distortion.model import LARGEST_COEFFICIENT
from course_lib.distortion.monotone import invert_increasing, smallest_positive_root
from course_lib.distortion.pixels import normalised_from_pixels


def fisheye_project(points: ArrayLike, K: ArrayLike, k: ArrayLike) -> Array:
    """Return the image of points through a fisheye lens.

    Parameters
    ----------
    points : array_like, shape (N, 3) or (3,)
        Points in the camera frame, in rows; also beside the camera or behind it.
    K : array_like, shape (3, 3)
        Intrinsics in px.
    k : array_like, shape (4,)
        Coefficients ``k1 k2 k3 k4`` of the angle; all zero is the equidistant lens.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Pixels ``(u, v)``. A row of NaN for the camera's centre, a point straight behind, and one
        beyond the `fisheye_valid_angle`.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite or `K` is not upper triangular with positive
        focal lengths.

    References
    ----------
    J. Kannala, S. Brandt, "A generic camera model and calibration method for conventional,
    wide-angle, and fish-eye lenses", IEEE PAMI 28 (2006), equation 6.

    Examples
    --------
    At a right angle from the axis, where a pinhole has no image:

    >>> K = [[200, 0, 320], [0, 200, 240], [0, 0, 1]]
    >>> fisheye_project([1, 0, 0], K, [0, 0, 0, 0]).round(3)
    array([634.159, 240.   ])
    """
    points, K, k = check_points(points, 3, "points"), check_intrinsics(K), _check_angular(k)
    aside = np.hypot(points[..., 0], points[..., 1])
    angle = np.arctan2(aside, points[..., 2])
    # On the axis the direction in the image has no meaning, and needs none.
    ahead = (aside < SMALLEST) & (points[..., 2] >= SMALLEST)
    seen = ahead | ((aside >= SMALLEST) & (angle <= fisheye_valid_angle(k)))
    scale = np.where(ahead, 0, image_distance(angle, k)) / np.where(aside < SMALLEST, 1, aside)
    plane = points[..., :2] * np.where(seen, scale, np.nan)[..., None]
    return np.asarray(plane @ K[:2, :2].T + K[:2, 2])


def fisheye_ray(pixels: ArrayLike, K: ArrayLike, k: ArrayLike) -> Array:
    """Return the directions in which the pixels of a camera with a fisheye lens look.

    Parameters
    ----------
    pixels : array_like, shape (N, 2) or (2,)
        Pixels ``(u, v)``, in rows.
    K, k : array_like
        As in `fisheye_project`.

    Returns
    -------
    ndarray, shape (N, 3) or (3,)
        Unit vectors in the camera frame; a row of NaN for a pixel outside of the image circle,
        which no ray within the `fisheye_valid_angle` reaches.

    Raises
    ------
    TypeError, ValueError
        As `fisheye_project`.

    References
    ----------
    J. Kannala, S. Brandt, IEEE PAMI 28 (2006), section 2.3 (backward model).

    Examples
    --------
    >>> K = [[200, 0, 320], [0, 200, 240], [0, 0, 1]]
    >>> fisheye_ray([320 + 50 * np.pi, 240], K, [0, 0, 0, 0]).round(3)
    array([0.707, 0.   , 0.707])
    """
    k = _check_angular(k)
    plane = normalised_from_pixels(pixels, K)
    distance = np.hypot(plane[..., 0], plane[..., 1])
    angle = invert_increasing(
        distance.ravel(),
        lambda angle: image_distance(angle, k),
        lambda angle: _image_distance_slope(angle, k),
        fisheye_valid_angle(k),
    ).reshape(distance.shape)
    on_axis = distance < SMALLEST
    towards = plane / np.where(on_axis, 1, distance)[..., None]
    angle = np.where(on_axis, 0, angle)[..., None]
    return np.concatenate([np.sin(angle) * towards, np.cos(angle)], axis=-1)


def fisheye_valid_angle(k: ArrayLike) -> float:
    """Return up to which angle from its axis the model of a fisheye lens can be used.

    Parameters
    ----------
    k : array_like, shape (4,)
        As in `fisheye_project`.

    Returns
    -------
    float
        Angle in rad at which the image's distance from the centre stops growing; at most π.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong or a number is not finite.

    References
    ----------
    The derivative of Kannala's and Brandt's equation 6.

    Examples
    --------
    >>> fisheye_valid_angle([0, 0, 0, 0]) == np.pi
    True
    >>> round(fisheye_valid_angle([-0.1, 0, 0, 0]), 6)
    1.825742
    """
    k = _check_angular(k)
    slope = [1, *(np.array([3, 5, 7, 9]) * k)]
    return min(float(np.pi), float(np.sqrt(smallest_positive_root(slope))))


def image_distance(angle: Array, k: Array) -> Array:
    """Return the distance from the centre in focal lengths, for an angle from the axis."""
    return np.asarray(angle * np.polynomial.polynomial.polyval(angle**2, [1, *k]))


def _image_distance_slope(angle: Array, k: Array) -> Array:
    slope = np.polynomial.polynomial.polyval(angle**2, [1, *(np.array([3, 5, 7, 9]) * k)])
    return np.asarray(slope)


def _check_angular(k: ArrayLike) -> Array:
    k = check_numbers(k, "k")
    if k.shape != (4,):
        raise ValueError(f"k must be the four coefficients k1 k2 k3 k4, got shape {k.shape}")
    if np.abs(k).max() > LARGEST_COEFFICIENT:
        raise ValueError(f"k holds {np.abs(k).max():g}, which no lens has")
    return k
