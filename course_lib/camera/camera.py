"""A pinhole camera with a place in the world."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from course_lib.camera.projection import camera_matrix, pixel_ray, project
from course_lib.checks import (
    Array,
    check_intrinsics,
    check_rotation,
    check_size,
    check_vector,
)
from course_lib.transforms import camera_centre, look_at


@dataclass(frozen=True, eq=False)
class Camera:
    """A camera somewhere in the world: what it is made of and where it stands.

    The arrays are stored as read-only `float64` copies.

    Attributes
    ----------
    K : ndarray, shape (3, 3)
        Intrinsics ``[[fx, s, cx], [0, fy, cy], [0, 0, 1]]`` in px.
    R, t : ndarray, shape (3, 3) and (3,)
        Pose, world to camera: ``X_c = R X_w + t``; t in the world's unit of length.
    image_size : tuple of int
        Width and height of the picture in px.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, `K` is not upper triangular with positive focal lengths, `R` is not a
        rotation or the size is not made of positive whole numbers.
    """

    K: Array
    R: Array
    t: Array
    image_size: tuple[int, int]

    def __post_init__(self) -> None:
        for name, value in (
            ("K", check_intrinsics(self.K)),
            ("R", check_rotation(self.R)),
            ("t", check_vector(self.t, 3, "t")),
        ):
            object.__setattr__(self, name, _read_only(value.copy()))
        width, height = check_size(self.image_size, "image_size")
        if (width, height) != (width // 1, height // 1):
            raise ValueError(f"image_size must be whole pixels, got {self.image_size}")
        object.__setattr__(self, "image_size", (int(width), int(height)))

    @cached_property
    def P(self) -> Array:
        """The camera matrix ``K [R | t]``, shape (3, 4)."""
        return _read_only(camera_matrix(self.K, self.R, self.t))

    @cached_property
    def centre(self) -> Array:
        """The centre of projection in the world frame, shape (3,)."""
        return _read_only(camera_centre(self.R, self.t))

    def project(self, points: ArrayLike) -> Array:
        """Return the image of world points.

        Parameters
        ----------
        points : array_like, shape (N, 3) or (3,)
            Points in the world frame, in rows, in the unit of `t`.

        Returns
        -------
        ndarray, shape (N, 2) or (2,)
            Pixels ``(u, v)``; a row of NaN for a point that is not in front of the camera.

        Raises
        ------
        TypeError, ValueError
            If the shape is wrong or a number is not finite.
        """
        return project(points, self.P)

    def pixel_ray(self, pixels: ArrayLike) -> Array:
        """Return the directions in which pixels look; the rays begin at `centre`.

        Parameters
        ----------
        pixels : array_like, shape (N, 2) or (2,)
            Pixels ``(u, v)``, in rows.

        Returns
        -------
        ndarray, shape (N, 3) or (3,)
            Unit vectors in the world frame.

        Raises
        ------
        TypeError, ValueError
            If the shape is wrong or a number is not finite.
        """
        return pixel_ray(pixels, self.K, self.R, self.t)[1]


def _read_only(array: Array) -> Array:
    array.setflags(write=False)
    return array


def camera_at(
    eye: ArrayLike,
    target: ArrayLike,
    K: ArrayLike,
    image_size: tuple[int, int],
    up: ArrayLike = (0, 0, 1),
) -> Camera:
    """Return a camera that stands at `eye`, looks at `target` and is held upright.

    Parameters
    ----------
    eye, target, up : array_like, shape (3,)
        As in `look_at`, world frame.
    K : array_like, shape (3, 3)
        Intrinsics in px.
    image_size : tuple of int
        Width and height of the picture in px.

    Returns
    -------
    Camera
        The camera.

    Raises
    ------
    TypeError, ValueError
        As `look_at` and `Camera`.
    """
    R, t = look_at(eye, target, up)
    return Camera(np.asarray(K), R, t, image_size)
