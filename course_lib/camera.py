"""Cameras: from world points to pixels, and back to rays.

The camera frame has x right, y down, z forward, with the hole (the centre of projection) at the
origin; the world has z up. Pixel ``(0, 0)`` is the centre of the top-left pixel.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    check_matrix,
    check_points,
    check_rotation,
    check_size,
    check_vector,
)
from course_lib.pinhole import (
    dolly_zoom,
    first_guess_intrinsics,
    image_centre,
    pixel_focal_length,
    project_pinhole,
    vanishing_point,
)
from course_lib.transforms import look_at, transform_points

__all__ = [
    "Camera",
    "camera_at",
    "dolly_zoom",
    "first_guess_intrinsics",
    "image_centre",
    "pixel_focal_length",
    "pixel_ray",
    "project",
    "project_pinhole",
    "vanishing_point",
]


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
        K = check_matrix(self.K, (3, 3), "K")
        if (np.diag(K) <= 0).any() or np.tril(K, -1).any() or K[2, 2] != 1:
            raise ValueError(f"K must be [[fx, s, cx], [0, fy, cy], [0, 0, 1]], got {K.tolist()}")
        for name, value in (
            ("K", K),
            ("R", check_rotation(self.R)),
            ("t", check_vector(self.t, 3, "t")),
        ):
            object.__setattr__(self, name, value.copy())
            getattr(self, name).setflags(write=False)
        width, height = check_size(self.image_size, "image_size")
        if (width, height) != (width // 1, height // 1):
            raise ValueError(f"image_size must be whole pixels, got {self.image_size}")
        object.__setattr__(self, "image_size", (int(width), int(height)))


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


def project(points: ArrayLike, camera: Camera) -> Array:
    """Return the image of world points.

    Parameters
    ----------
    points : array_like, shape (N, 3) or (3,)
        Points in the world frame, in rows, in the unit of ``camera.t``.
    camera : Camera
        The camera.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Pixels ``(u, v)``; a row of NaN for a point that is not in front of the camera.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong or a number is not finite.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 6.1.
    """
    points = transform_points(points, camera.R, camera.t)
    normalised = project_pinhole(points, 1, (0, 0))
    return normalised @ camera.K[:2, :2].T + camera.K[:2, 2]


def pixel_ray(pixels: ArrayLike, camera: Camera) -> Array:
    """Return the directions in which pixels look: the inverse of `project`, up to the distance.

    Parameters
    ----------
    pixels : array_like, shape (N, 2) or (2,)
        Pixels ``(u, v)``, in rows.
    camera : Camera
        The camera. The rays start at its centre.

    Returns
    -------
    ndarray, shape (N, 3) or (3,)
        Unit vectors in the world frame.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong or a number is not finite.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 6.2.2.
    """
    pixels = check_points(pixels, 2, "pixels")
    homogeneous = np.concatenate([pixels, np.ones_like(pixels[..., :1])], axis=-1)
    rays = homogeneous @ np.linalg.inv(camera.K).T @ camera.R  # Rᵀ K⁻¹ u, in rows
    return np.asarray(rays / np.linalg.norm(rays, axis=-1, keepdims=True))
