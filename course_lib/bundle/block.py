"""What a bundle adjustment is about: cameras, points, and who sees which point where."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import (
    Array,
    check_intrinsics,
    check_numbers,
    check_points,
    check_positive,
    check_rotation,
)

Indices = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class Block:
    """Cameras and points of one world.

    Attributes
    ----------
    K : ndarray, shape (v, 3, 3)
        Intrinsics of each camera, px; one (3, 3) is given to all. Distortion must be taken out of
        the pixels before.
    R, t : ndarray, shape (v, 3, 3) and (v, 3)
        Pose of each camera, world to camera, ``X_c = R X_w + t``.
    points : ndarray, shape (n, 3)
        The points, in the world's unit of length.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or a matrix is no intrinsics or no rotation.
    """

    K: Array
    R: Array
    t: Array
    points: Array

    def __post_init__(self) -> None:
        R, t = check_numbers(self.R, "R"), check_points(self.t, 3, "t")
        points = check_points(self.points, 3, "points")
        if R.ndim != 3 or t.shape != (len(R), 3) or points.ndim != 2:
            raise ValueError(
                "a block needs R of shape (v, 3, 3), t of shape (v, 3) and points of shape "
                f"(n, 3), got {R.shape}, {t.shape} and {points.shape}"
            )
        K = check_numbers(self.K, "K")
        if K.ndim != 3:
            K = np.repeat(check_intrinsics(K)[None], len(R), axis=0)
        else:
            for each in K:
                check_intrinsics(each)
        if len(K) != len(R):
            raise ValueError(f"K must be one matrix or one for each of {len(R)}, got {len(K)}")
        _check_rotations(R)
        for name, value in (("K", K), ("R", R), ("t", t), ("points", points)):
            object.__setattr__(self, name, value)

    @cached_property
    def centres(self) -> Array:
        """The centres of projection, ``C = -Rᵀ t``, shape (v, 3)."""
        return np.asarray(-np.einsum("vji,vj->vi", self.R, self.t))

    def moved_to(self, points: ArrayLike) -> Block:
        """Return a block with the same cameras and other points, shape (n, 3)."""
        return replace(self, points=np.asarray(points))

    def project(self, cameras: ArrayLike, points: ArrayLike) -> Array:
        """Return where cameras see points.

        Parameters
        ----------
        cameras, points : array_like of int, shape (m,)
            Numbers of cameras and of points, in pairs.

        Returns
        -------
        ndarray, shape (m, 2)
            Pixels; a row of NaN for a point that is not in front of its camera.

        Raises
        ------
        TypeError, ValueError
            If there is no such camera or point, or the numbers are not whole.
        """
        i = check_numbers_of(cameras, len(self.R), "cameras")
        j = check_numbers_of(points, len(self.points), "points")
        rays = np.einsum("mij,mj->mi", self.R[i], self.points[j] - self.centres[i])
        z = np.where(rays[:, 2] > 0, rays[:, 2], np.nan)
        return np.asarray(np.einsum("mij,mj->mi", self.K[i], rays / z[:, None])[:, :2])


@dataclass(frozen=True, eq=False)
class Observations:
    """Which camera sees which point where.

    Attributes
    ----------
    cameras, points : ndarray of int, shape (m,)
        Numbers of the camera and of the point, counted from 0.
    pixels : ndarray, shape (m, 2)
        Where it is seen, ``(u, v)``, freed from distortion.
    sigma : ndarray, shape (m,)
        Standard deviation of a coordinate, px; one number is given to all.

    Raises
    ------
    TypeError, ValueError
        If the rows do not belong together, a number is not finite or a sigma not positive.
    """

    cameras: Indices
    points: Indices
    pixels: Array
    sigma: Array | float = 1.0

    def __post_init__(self) -> None:
        pixels = check_points(self.pixels, 2, "pixels")
        cameras = check_numbers_of(self.cameras, None, "cameras")
        points = check_numbers_of(self.points, None, "points")
        sigma = check_positive(self.sigma, "sigma")
        count = len(cameras)
        if pixels.shape != (count, 2) or len(points) != count or sigma.shape not in ((), (count,)):
            raise ValueError(
                "cameras, points, pixels and sigma belong together row by row, got shapes "
                f"{cameras.shape}, {points.shape}, {pixels.shape} and {sigma.shape}"
            )
        if not count:
            raise ValueError("there are no observations: a block needs pixels")
        sigma = np.broadcast_to(sigma, count)
        object.__setattr__(self, "cameras", cameras)
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "pixels", pixels)
        object.__setattr__(self, "sigma", sigma)

    def __len__(self) -> int:
        """Return how many observations there are."""
        return len(self.cameras)

    def only(self, keep: Any) -> Observations:
        """Return some of the observations: a mask or numbers, as NumPy takes them."""
        sigma = np.asarray(self.sigma)[keep]
        return Observations(self.cameras[keep], self.points[keep], self.pixels[keep], sigma)


def _check_rotations(R: Array) -> None:
    """Raise unless all of R, shape (v, 3, 3), are rotations; all at once, as long as they are."""
    if R.shape[1:] == (3, 3) and np.abs(R).max(initial=0) <= 2:
        apart = np.abs(R @ R.swapaxes(1, 2) - np.eye(3)).max(initial=0)
        if apart <= 1e-6 and (np.linalg.det(R) > 0).all():
            return
    for each in R:
        check_rotation(each)


def check_numbers_of(value: ArrayLike, count: int | None, name: str) -> Indices:
    """Return whole numbers from 0, shape (m,); below a count, if one is given."""
    array = np.asarray(value)
    if array.ndim != 1 or (array.size and array.dtype.kind not in "iu"):
        raise TypeError(f"{name} must be a row of whole numbers, got {value!r:.60}")
    array = array.astype(np.intp)
    if array.size and array.min() < 0:
        raise ValueError(f"{name} are counted from 0, got {array.min()}")
    if count is not None and array.size and array.max() >= count:
        raise ValueError(
            f"{name} holds number {array.max()}, but the block has only {count}, counted from 0"
        )
    return array
