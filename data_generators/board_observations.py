"""Simulated observations of a calibration board: pixels with noise, from a camera that we chose.

Nothing is rendered; for pictures see `calibration_sets`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.random import Generator
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_intrinsics, check_not_negative, check_points
from course_lib.distortion import distort_pixels
from course_lib.transforms import rotation_from_vector, transform_points

#: A board fills about so much of the picture's width, from nearest to farthest.
FILLING = (0.85, 0.45)
#: A view in which the board is not wholly in the picture is drawn again, so often.
ATTEMPTS = 200


@dataclass(frozen=True, eq=False)
class BoardObservations:
    """What a known camera saw of a board in several poses.

    Attributes
    ----------
    points : ndarray, shape (N, 3)
        Points of the board.
    pixels : list of ndarray, shape (N, 2)
        Where they were seen in each view, with noise.
    poses : list of (R, t)
        Board to camera.
    """

    points: Array
    pixels: list[Array]
    poses: list[tuple[Array, Array]]


def observe_board(
    rng: Generator,
    points: ArrayLike,
    K: ArrayLike,
    coefficients: ArrayLike,
    image_size: tuple[int, int],
    views: int,
    noise: float = 0.0,
    tilt: float = 0.5,
) -> BoardObservations:
    """Return simulated pixels of a board that is held in different poses before a camera.

    Parameters
    ----------
    rng : numpy.random.Generator
        Draws poses and noise.
    points : array_like, shape (N, 3)
        Points of the board, z = 0.
    K : array_like, shape (3, 3)
        Intrinsics, px.
    coefficients : array_like
        Distortion, as in `distort`.
    image_size : tuple of int
        Width and height, px; the whole board is inside, before the noise.
    views : int
        How many poses.
    noise : float
        Standard deviation of each coordinate, px.
    tilt : float
        Standard deviation of the turns about the camera's x and y, rad; 0 makes all boards
        parallel.

    Returns
    -------
    BoardObservations
        Pixels, and the poses that made them.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or the board does not come into the picture.
    """
    points, K = check_points(points, 3, "points"), check_intrinsics(K)
    check_not_negative(noise, "noise")
    poses, pixels = [], []
    for _ in range(ATTEMPTS * views):
        pose = _pose(rng, points, K, image_size, tilt)
        seen = _seen(points, pose, K, coefficients)
        if seen is None or (seen < 0).any() or (seen > np.array(image_size) - 1).any():
            continue
        poses.append(pose)
        pixels.append(seen + rng.normal(0, noise, seen.shape))
        if len(poses) == views:
            return BoardObservations(points, pixels, poses)
    raise ValueError("the board does not come wholly into the picture: tilt it less")


def _pose(
    rng: Generator, points: Array, K: Array, image_size: tuple[int, int], tilt: float
) -> tuple[Array, Array]:
    R = rotation_from_vector([*rng.normal(0, tilt, 2), rng.uniform(-0.3, 0.3)])
    wide = float(np.ptp(points, axis=0).max())
    depth = wide * K[0, 0] / image_size[0] / rng.uniform(FILLING[1], FILLING[0])
    # Towards a pixel anywhere, as far as the board's middle may be.
    towards = rng.uniform(0.2, 0.8, 2) * image_size
    ray = np.linalg.solve(K, [*towards, 1])
    return R, depth * ray - R @ points.mean(axis=0)


def _seen(
    points: Array, pose: tuple[Array, Array], K: Array, coefficients: ArrayLike
) -> Array | None:
    """Return the pixels, or None if a point is not before the camera."""
    X = transform_points(points, *pose)
    if not (X[:, 2] > 0).all():
        return None
    ideal = X[:, :2] / X[:, 2:] @ K[:2, :2].T + K[:2, 2]
    return distort_pixels(ideal, K, coefficients)
