"""Pictures of even surfaces: pairs that give a camera's gain away, and all that is uneven."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import Array, check_numbers
from course_lib.sensor import SensorModel, expose, vignetting
from data_generators.belt import SIZE, belt

Numbers = NDArray[np.unsignedinteger]


class Pairs(NamedTuple):
    """Two pictures alike of each light level, (levels, rows, columns), and two without light."""

    first: Numbers
    second: Numbers
    dark_first: Numbers
    dark_second: Numbers


class Uneven(NamedTuple):
    """A picture, one without light and one of an even white surface, by the same camera, DN."""

    image: Array
    dark: Array
    flat: Array


def flat_pairs(
    sensor: SensorModel,
    photons: ArrayLike,
    rng: np.random.Generator,
    shape: tuple[int, int] = (64, 96),
) -> Pairs:
    """Photograph an even surface twice in each of several lights.

    Parameters
    ----------
    sensor : SensorModel
        The camera.
    photons : array_like, shape (levels,)
        Photons in a pixel, on average, in each light.
    rng : numpy.random.Generator
        Where chance comes from.
    shape : tuple of int
        Rows and columns.

    Returns
    -------
    Pairs
        Pixels differ in sensitivity by 1 %, the same in all pictures, and the surface is darker
        at its edges: what the two pictures of a pair have in common is not noise.
    """
    v, u = np.indices(shape) / np.reshape(shape, (2, 1, 1)) - 0.5
    even = (1 - 0.15 * (u**2 + v**2)) * (1 + 0.01 * rng.standard_normal(shape))
    light = check_numbers(photons, "photons").reshape(-1, 1, 1) * even
    none = np.zeros(shape)
    pictures = [expose(surface, sensor, rng) for surface in (light, light, none, none)]
    return Pairs(*pictures)


def uneven_pictures(rng: np.random.Generator, f: float = 8.0) -> Uneven:
    """Photograph the belt with a wide lens, dust on the sensor and pixels that glow.

    Parameters
    ----------
    rng : numpy.random.Generator
        Where chance comes from.
    f : float
        Focal length before a sensor of 9.6 mm × 6.4 mm, mm.

    Returns
    -------
    Uneven
        Each the mean of 16 exposures, shape (320, 480).
    """
    sensor = SensorModel(full_well=20_000, gain=0.2, offset=64, bits=12)
    width, height = SIZE
    pitch = 9.6 / width
    v, u = np.indices((height, width)) * pitch - np.array([6.4, 9.6]).reshape(2, 1, 1) / 2
    share = vignetting(np.arctan2(np.hypot(u, v), f)) * (0.85 + 0.15 * (u / 4.8 + 1) / 2)
    for _ in range(14):
        x, y = rng.uniform(-4.6, 4.6), rng.uniform(-3, 3)
        share = share * (1 - 0.35 * np.exp(-((u - x) ** 2 + (v - y) ** 2) / 0.06**2))
    glow = 300 * rng.exponential(0.2, share.shape) + 900 * (rng.random(share.shape) < 4e-4)
    grey = belt().mean(axis=2, dtype=float)
    scenes = (30_000 * share * grey + glow, glow, 25_000 * share + glow)
    return Uneven(*(_mean(scene, sensor, rng) for scene in scenes))


def _mean(photons: Array, sensor: SensorModel, rng: np.random.Generator, count: int = 16) -> Array:
    """Return the mean of several exposures, DN."""
    pictures = (expose(photons, sensor, rng).astype(float) for _ in range(count))
    return np.asarray(sum(pictures) / count)
