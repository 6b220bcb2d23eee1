"""Rays through a lens, at a time: which way each sample of a pixel looks, and when."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera
from course_lib.checks import Array, check_not_negative, check_number
from course_lib.distortion.pixels import undistort_pixels
from data_generators.lens import MM, Lens
from data_generators.motion import Motion
from data_generators.raycast import rays

GOLDEN = (np.sqrt(5) - 1) / 2
#: Steps of a sequence that fills a square evenly (M. Roberts, "R2", after the plastic number).
EVEN = (0.7548776662466927, 0.5698402909980532)


@dataclass(frozen=True, eq=False)
class Shutter:
    """When the sensor looks.

    The top row is exposed from ``-exposure_time / 2`` to ``exposure_time / 2``, so that a picture
    of moving things shows them, smeared, around where the scene has them.

    Attributes
    ----------
    exposure_time : float
        How long each row is exposed, s.
    row_time : float
        How much later each row begins than the one above it, s; 0 for a global shutter.

    Raises
    ------
    TypeError, ValueError
        If a time is negative.
    """

    exposure_time: float = 0.0
    row_time: float = 0.0

    def __post_init__(self) -> None:
        for name in ("exposure_time", "row_time"):
            check_number(check_not_negative(getattr(self, name), name), name)


@dataclass(frozen=True, eq=False)
class Aim:
    """Where a bundle of rays comes from.

    Attributes
    ----------
    camera : Camera
        The camera at time 0.
    lens : Lens, optional
        Its lens; without one, all rays pass the centre.
    motion : Motion, optional
        Of the camera.
    points : ndarray, shape (N, 2)
        Where each ray passes the lens, to the right and down, m.
    times : ndarray, shape (N,)
        When, s.
    distortion : ndarray, optional
        Coefficients of the lens, as in `course_lib.distortion.distort`.
    """

    camera: Camera
    lens: Lens | None
    motion: Motion | None
    points: Array
    times: Array
    distortion: Array | None = None

    def rays(self, pixels: Array) -> tuple[Array, Array]:
        """Return the rays that reach pixels, shape (N, 2), px, through these points of the lens.

        Returns
        -------
        origins, directions : ndarray, shape (N, 3)
            In the world, m; the directions are unit vectors.

        Raises
        ------
        ValueError
            If the distortion folds the picture so that a pixel has no ray.
        """
        if self.distortion is not None:
            pixels = undistort_pixels(pixels, self.camera.K, self.distortion)
            if not np.isfinite(pixels).all():
                raise ValueError("this lens has no ray for some pixels: make its distortion weaker")
        origins, directions = rays(self.camera, pixels)
        if self.lens is not None:
            # A ray through the middle and one through the point meet where the lens is focused.
            sideways = self.points @ self.camera.R[:2]
            forward = directions / (directions @ self.camera.R[2])[:, None]
            bent = forward - sideways / (self.lens.focus_distance * MM)
            origins = origins + sideways
            directions = bent / np.linalg.norm(bent, axis=1, keepdims=True)
        if self.motion is not None:
            return self.motion.carry(origins, directions, self.times)
        return origins, directions

    def among(self, mine: NDArray[np.intp]) -> Aim:
        """Return the same for some of the rays."""
        return replace(self, points=self.points[mine], times=self.times[mine])

    def disks(self, Z: Array) -> Array:
        """Return the diameters of the disks of points at distances Z, m, in px."""
        return np.zeros_like(Z) if self.lens is None else self.lens.disks(Z, self.camera)


def aim_at(
    camera: Camera,
    pixels: Array,
    samples: int,
    lens: Lens | None = None,
    shutter: Shutter | None = None,
    motion: Motion | None = None,
    distortion: Array | None = None,
) -> Aim:
    """Return an even choice of points of the lens and of times for the samples of pixels.

    Parameters
    ----------
    camera : Camera
        The camera.
    pixels : ndarray, shape (N, 2)
        Samples on the picture, px: `samples` × `samples` in each pixel.
    samples : int
        Samples a pixel, along each axis.
    lens, shutter, motion, distortion
        What the camera has; nothing of it for a still pinhole camera.

    Returns
    -------
    Aim
        The samples of a pixel share the lens and the time evenly, each pixel in its own way, but
        the same way every time.
    """
    if lens is None and shutter is None:
        still = np.zeros(len(pixels))
        return Aim(camera, None, motion, np.zeros_like(pixels), still, distortion)
    column, row = np.floor(pixels + 0.5).T
    within = np.floor((pixels + 0.5 - np.stack([column, row], axis=1)) * samples)
    count = samples**2
    # A step that shares no divisor with the count visits every place once.
    step = next(s for s in range(int(count * GOLDEN) or 1, 2 * count + 1) if np.gcd(s, count) == 1)
    place = (within[:, 1] * samples + within[:, 0]) * step % count
    angle = 2 * np.pi * ((place + 0.5) * GOLDEN + column * EVEN[0] + row * EVEN[1])
    radius = np.sqrt((place + 0.5) / count) * (0 if lens is None else lens.diameter / 2 * MM)
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1)
    start = column * EVEN[1] + row * EVEN[0] + (place * step % count + 0.5) / count
    shutter = shutter or Shutter()
    times = (start % 1 - 0.5) * shutter.exposure_time + row * shutter.row_time
    return Aim(camera, lens, motion, points, times, distortion)
