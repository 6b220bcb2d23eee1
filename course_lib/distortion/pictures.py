"""Distortion of whole pictures: by how much each pixel moves, and the map that moves it back.

Use these functions through `course_lib.distortion`.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from course_lib.checks import Array, check_intrinsics, check_points, check_size
from course_lib.distortion.inverse import valid_radius
from course_lib.distortion.model import (
    check_coefficients,
    check_normalised,
    distort,
    distorted_columns,
)
from course_lib.distortion.pixels import normalised_from_pixels

#: Places of the parts among the twelve coefficients; the displacement is their sum.
PARTS = {
    "complete": list(range(12)),
    "radial": [0, 1, 4, 5, 6, 7],
    "tangential": [2, 3],
    "prism": [8, 9, 10, 11],
}
#: Column and row of a pixel that is in no picture.
NOWHERE = -1e6
#: Rows of a map that are computed together.
ROWS = 16


def pixel_grid(image_size: tuple[int, int], columns: int, rows: int) -> Array:
    """Return pixels that are spread evenly over a picture, from corner to corner.

    Parameters
    ----------
    image_size : tuple of int
        Width and height of the picture in px.
    columns, rows : int
        How many, at least two each.

    Returns
    -------
    ndarray, shape (rows, columns, 2)
        Pixels ``(u, v)``, with the centres of the picture's corner pixels among them.

    Raises
    ------
    ValueError
        If there are fewer than two rows or columns, or the size is not positive.

    Examples
    --------
    >>> pixel_grid((641, 481), columns=3, rows=2)[1]
    array([[  0., 480.],
           [320., 480.],
           [640., 480.]])
    """
    width, height = check_size(image_size, "image_size")
    if columns < 2 or rows < 2:
        raise ValueError(f"a grid has at least 2 columns and 2 rows, got {columns} and {rows}")
    u, v = np.linspace(0, width - 1, columns), np.linspace(0, height - 1, rows)
    return np.stack(np.meshgrid(u, v), axis=-1)


def displacement_field(
    pixels: ArrayLike, K: ArrayLike, coefficients: ArrayLike, part: str = "complete"
) -> Array:
    """Return by how much a lens moves the images of the rays that a pinhole sends to pixels.

    Parameters
    ----------
    pixels : array_like, shape (N, 2) or (2,)
        Ideal pixels ``(u, v)``, in rows.
    K, coefficients : array_like
        Intrinsics in px, and the lens as in `distort`.
    part : {"complete", "radial", "tangential", "prism"}
        Which terms act; the complete displacement is the sum of the other three.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Distorted minus ideal pixel.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or there is no such part.

    References
    ----------
    J.-Y. Bouguet, Camera Calibration Toolbox for MATLAB, first calibration example (the plots of
    the complete, the tangential and the radial displacement).

    Examples
    --------
    >>> K = [[800, 0, 320], [0, 800, 240], [0, 0, 1]]
    >>> displacement_field([720, 240], K, [-0.2, 0, 0.001, 0])
    array([-20. ,   0.2])
    >>> displacement_field([720, 240], K, [-0.2, 0, 0.001, 0], part="tangential").round(9)
    array([0. , 0.2])
    """
    if part not in PARTS:
        raise ValueError(f"part must be one of {', '.join(PARTS)}, got {part!r}")
    pixels, K = check_points(pixels, 2, "pixels"), check_intrinsics(K)
    points, acting = normalised_from_pixels(pixels, K), np.zeros(12)
    acting[PARTS[part]] = check_coefficients(coefficients)[PARTS[part]]
    return (distort(points, acting) - points) @ K[:2, :2].T


def undistortion_map(
    K: ArrayLike,
    coefficients: ArrayLike,
    image_size: tuple[int, int],
    new_K: ArrayLike | None = None,
    dtype: DTypeLike = np.float32,
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return, for each pixel of the undistorted picture, where to look in the distorted one.

    Going backwards, every pixel gets its colour, and the easy direction (`distort`) is enough.

    Parameters
    ----------
    K, coefficients : array_like
        Intrinsics in px, and the lens as in `distort`.
    image_size : tuple of int
        Width and height of the undistorted picture in px.
    new_K : array_like, shape (3, 3), optional
        Its intrinsics; `K` unless given. A smaller focal length shows more of the edges.
    dtype : dtype
        Type of the numbers; OpenCV wants ``float32``.

    Returns
    -------
    map_u, map_v : ndarray, shape (height, width)
        Column and row in the distorted picture, in px. Where the lens has folded over
        (`valid_radius`) there is nothing to look at: both are -1e6 there, far outside of every
        picture.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or the size is not made of whole pixels.

    References
    ----------
    G. Wolberg, Digital Image Warping, section 3.1 (inverse mapping).

    Examples
    --------
    >>> K = [[100, 0, 50], [0, 100, 50], [0, 0, 1]]
    >>> map_u, map_v = undistortion_map(K, [-0.2], (101, 101))
    >>> map_u[50, 100], map_v[50, 100]
    (np.float32(97.5), np.float32(50.0))
    """
    width, height = (int(n) for n in check_size(image_size, "image_size"))
    if (width, height) != tuple(image_size):
        raise ValueError(f"image_size must be whole pixels, got {image_size}")
    K = check_intrinsics(K)
    new_K = K if new_K is None else check_intrinsics(new_K)
    k, limit = check_coefficients(coefficients), valid_radius(coefficients)
    check_normalised(normalised_from_pixels([(0, 0), (width, height)], new_K), "the corners")
    maps = np.empty((2, height, width), dtype=dtype)
    for top in range(0, height, ROWS):
        v, u = np.mgrid[top : min(top + ROWS, height), :width].astype(np.float64)
        y = (v - new_K[1, 2]) / new_K[1, 1]
        x = (u - new_K[0, 2] - new_K[0, 1] * y) / new_K[0, 0]
        x_d, y_d = distorted_columns(x, y, k)
        # Not seen: beyond the fold, or NaN at a pole of the rational model.
        seen = (x * x + y * y < limit**2) & np.isfinite(x_d)
        maps[0, top : top + ROWS] = np.where(seen, K[0, 0] * x_d + K[0, 1] * y_d + K[0, 2], NOWHERE)
        maps[1, top : top + ROWS] = np.where(seen, K[1, 1] * y_d + K[1, 2], NOWHERE)
    return maps[0], maps[1]
