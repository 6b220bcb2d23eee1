"""Everything that a real camera adds to a pinhole's picture, as settings that can be left out."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera
from course_lib.checks import Array, check_length
from course_lib.distortion.model import check_coefficients
from course_lib.sensor import SensorModel, bayer_mosaic, expose, vignetting
from data_generators.aim import Shutter
from data_generators.lens import Lens
from data_generators.motion import Motion


@dataclass(frozen=True, eq=False)
class Shot:
    """How a photograph is taken. Each setting that is left out costs nothing and does nothing.

    Attributes
    ----------
    distortion : ndarray, optional
        How the lens bends straight lines: coefficients as in `course_lib.distortion.distort`.
    lens : Lens, optional
        Makes what it is not focused on blurred. The camera's K must be that of `Lens.intrinsics`.
    shutter : Shutter, optional
        How long it is open, and whether row after row: smears and slants what moves.
    motion : Motion, optional
        Of the camera, in the world. Things move by the motion of their patches.
    vignetting : bool
        Whether the corners are darker, by the fourth power of the cosine.
    sensor : SensorModel, optional
        Turns light into numbers, with noise; without one, 8-bit numbers without noise.
    white : float
        Photons in a pixel in the middle of the picture where the scene's radiance is 1; see
        `course_lib.sensor.photons_per_pixel`. Only a sensor needs it.
    mosaic : bool
        Whether each pixel sees one colour only, in the pattern RGGB.

    Raises
    ------
    TypeError, ValueError
        If `white` is not positive, or `distortion` not made of coefficients.
    """

    distortion: Array | None = None
    lens: Lens | None = None
    shutter: Shutter | None = None
    motion: Motion | None = None
    vignetting: bool = False
    sensor: SensorModel | None = None
    white: float = 20_000.0
    mosaic: bool = False

    def __post_init__(self) -> None:
        check_length(self.white, "white")
        if self.distortion is not None:
            object.__setattr__(self, "distortion", check_coefficients(self.distortion))

    def on_sensor(self, radiance: Array, camera: Camera) -> Array:
        """Return the light on the sensor, by that of a white surface in the middle."""
        if self.vignetting:
            radiance = radiance * falloff(camera)[..., None]
        return np.asarray(bayer_mosaic(radiance), float) if self.mosaic else radiance

    def written(
        self, irradiance: Array, rng: np.random.Generator | None
    ) -> NDArray[np.unsignedinteger]:
        """Return what the sensor writes down.

        Parameters
        ----------
        irradiance : ndarray
            As of `on_sensor`.
        rng : numpy.random.Generator or None
            For the noise; needed only with a sensor.

        Returns
        -------
        ndarray of the same shape, uint8 or uint16
            DN; without a sensor, 255 is white.

        Raises
        ------
        TypeError
            If there is a sensor but no generator.
        """
        if self.sensor is None:
            return numbers(irradiance)
        if rng is None:
            raise TypeError("a sensor has noise: give an rng, such as numpy.random.default_rng(1)")
        time = self.shutter.exposure_time if self.shutter else 0.0
        return expose(irradiance * self.white, self.sensor, rng, time)


def numbers(irradiance: Array) -> NDArray[np.uint8]:
    """Return what an 8-bit sensor with a linear response writes down.

    Parameters
    ----------
    irradiance : ndarray
        1 fills a pixel; more is clipped.

    Returns
    -------
    ndarray of uint8, the same shape
        Grey values.
    """
    return np.rint(np.clip(irradiance, 0, 1) * 255).astype(np.uint8)


def falloff(camera: Camera) -> Array:
    """Return how much less light reaches each pixel than the middle of the lens's picture.

    Parameters
    ----------
    camera : Camera
        The camera.

    Returns
    -------
    ndarray, shape (height, width)
        The fourth power of the cosine of the angle to the axis.
    """
    width, height = camera.image_size
    v, u = np.indices((height, width))
    directions = camera.pixel_ray(np.stack([u, v], axis=-1).reshape(-1, 2).astype(float))
    cosine = np.clip(directions @ camera.R[2], -1, 1)
    return np.asarray(vignetting(np.arccos(cosine))).reshape(height, width)
