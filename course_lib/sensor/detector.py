"""The detector: photons become electrons, electrons a voltage, and the voltage a number.

Use these functions through `course_lib.sensor`. Counts of photons and electrons are those of one
pixel and one exposure; DN ("digital number") is what the file holds.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import (
    Array,
    check_generator,
    check_not_negative,
    check_number,
    check_numbers,
)
from course_lib.sensor.sensor_model import SensorModel

#: Electrons from which the normal distribution stands in for Poisson's (skewness below 0.06).
NORMAL_FROM = 300


def mean_electrons(photons: ArrayLike, camera: SensorModel, exposure_time: float = 0.0) -> Array:
    """Return the electrons that light and warmth set free in a pixel, on average.

    Parameters
    ----------
    photons : float or array_like
        Photons that arrive in a pixel during the exposure, on average; not negative.
    camera : SensorModel
        Its quantum efficiency and dark current count.
    exposure_time : float
        Seconds during which the dark current is collected.

    Returns
    -------
    float or ndarray
        Electrons, with the shape of `photons`; the well may overflow.

    Raises
    ------
    TypeError, ValueError
        If an argument is negative or not finite.

    References
    ----------
    EMVA Standard 1288, release 4.0 (linear), section 2.

    Examples
    --------
    >>> float(mean_electrons(1000, SensorModel(quantum_efficiency=0.6, dark_current=5), 2))
    610.0
    """
    photons, exposure_time = check_light(photons, exposure_time)
    return camera.quantum_efficiency * photons + camera.dark_current * exposure_time


def sensor_response(photons: ArrayLike, camera: SensorModel, exposure_time: float = 0.0) -> Array:
    """Return the number that a pixel would hold if nothing in it fluctuated.

    Parameters
    ----------
    photons : float or array_like, shape (...)
        Photons that arrive in a pixel during the exposure; not negative.
    camera : SensorModel
        What a pixel makes of them: ``camera.quantum_efficiency``, ``camera.full_well`` (electrons),
        ``camera.dark_current`` (electrons per second), ``camera.gain`` (DN per electron),
        ``camera.offset`` (DN) and ``camera.white``, the largest number (DN).
    exposure_time : float
        Seconds during which the dark current is collected.

    Returns
    -------
    float or ndarray, shape (...)
        DN, not rounded: the mean of many pictures lies between the whole numbers. A full pixel
        holds no more electrons, and nothing is written above ``camera.white``.

    Raises
    ------
    TypeError, ValueError
        If an argument is negative or not finite.

    References
    ----------
    EMVA Standard 1288, release 4.0 (linear), section 2.

    Examples
    --------
    >>> camera = SensorModel(quantum_efficiency=0.5, full_well=10_000, gain=0.3, offset=16, bits=12)
    >>> sensor_response(np.array([0, 2000, 18_000, 90_000]), camera)
    array([  16.,  316., 2716., 3016.])
    """
    photons, exposure_time = check_light(photons, exposure_time)
    electrons = camera.quantum_efficiency * photons + camera.dark_current * exposure_time
    electrons = np.minimum(electrons, camera.full_well)
    return np.minimum(camera.gain * electrons + camera.offset, camera.white)


def expose(
    photons: ArrayLike,
    camera: SensorModel,
    rng: np.random.Generator,
    exposure_time: float = 0.0,
) -> NDArray[np.unsignedinteger]:
    """Return the numbers of one picture, with all its noise.

    In this order: electrons are set free one by one (shot noise), a well holds no more than it
    can, the readout adds its noise, the amplifier multiplies, the digitiser rounds and clips.

    Parameters
    ----------
    photons : float or array_like
        Photons that arrive in each pixel during the exposure, on average; not negative.
    camera : SensorModel
        What the pixels make of them.
    rng : numpy.random.Generator
        Where chance comes from.
    exposure_time : float
        Seconds during which the dark current is collected.

    Returns
    -------
    ndarray, the shape of `photons`, uint8 or uint16
        DN; `uint8` for up to 8 bits. Beware of subtracting such pictures: an unsigned number
        cannot be negative, it wraps around.

    Raises
    ------
    TypeError, ValueError
        If an argument is negative or not finite, or `rng` is not a generator.

    Notes
    -----
    From `NORMAL_FROM` electrons on, the Poisson distribution of the shot noise is taken as normal
    with the same mean and variance, which is faster.

    References
    ----------
    EMVA Standard 1288, release 4.0 (linear), section 2; J. Janesick, Photon Transfer, chapter 3.
    """
    check_generator(rng)
    electrons = _poisson(mean_electrons(photons, camera, exposure_time), rng)
    electrons = np.minimum(electrons, camera.full_well)
    if camera.read_noise:
        electrons += camera.read_noise * rng.standard_normal(electrons.shape)
    return digitise(camera.gain * electrons + camera.offset, camera)


def expose_with_field(
    photons: ArrayLike, camera: SensorModel, field: ArrayLike, exposure_time: float = 0.0
) -> NDArray[np.unsignedinteger]:
    """Return the numbers of one picture, with noise made from random numbers drawn before.

    For sliders: drawing is what takes time in `expose`, and a picture whose noise stays while its
    light changes is easier to read. Shot and readout noise are one normal distribution here.

    Parameters
    ----------
    photons : float or array_like
        Photons that arrive in each pixel during the exposure, on average; not negative.
    camera : SensorModel
        What the pixels make of them.
    field : array_like
        Numbers from the standard normal distribution, of the shape of `photons`.
    exposure_time : float
        Seconds during which the dark current is collected.

    Returns
    -------
    ndarray, the shape of `photons`, uint8 or uint16
        DN, as from `expose`. Mean and variance are the same up to rounding; the Poisson
        distribution's skewness, visible below about 10 electrons, is missing.

    Raises
    ------
    TypeError, ValueError
        If an argument is negative or not finite, or the shapes differ.
    """
    electrons = mean_electrons(photons, camera, exposure_time)
    field = check_numbers(field, "field")
    if field.shape != electrons.shape:
        raise ValueError(
            f"field must have the shape of photons, {electrons.shape}, got {field.shape}: "
            "one random number for each pixel"
        )
    # A full well holds a fixed number of electrons: no shot noise is left in it.
    variance = np.where(electrons < camera.full_well, electrons, 0) + camera.read_noise**2
    levels = np.sqrt(variance, out=variance) * field
    levels += np.minimum(electrons, camera.full_well)
    levels *= camera.gain
    levels += camera.offset
    return digitise(levels, camera)


def digitise(levels: ArrayLike, camera: SensorModel) -> NDArray[np.unsignedinteger]:
    """Return the whole numbers that a digitiser makes of amplified levels.

    Parameters
    ----------
    levels : float or array_like
        Levels in DN, before rounding; what is below 0 or above ``camera.white`` is clipped.
    camera : SensorModel
        Its bits count.

    Returns
    -------
    ndarray, the same shape, uint8 or uint16
        DN; `uint8` for up to 8 bits.

    Raises
    ------
    TypeError, ValueError
        If a level is not a finite number.
    """
    levels = check_numbers(levels, "levels")
    kind = np.uint8 if camera.bits <= 8 else np.uint16
    whole = np.rint(levels)
    return np.clip(whole, 0, camera.white, out=whole if whole.ndim else None).astype(kind)


def check_light(photons: ArrayLike, exposure_time: float) -> tuple[Array, float]:
    """Return photons and seconds as numbers from zero upwards; the seconds are one number."""
    seconds = check_number(check_not_negative(exposure_time, "exposure_time"), "exposure_time")
    return check_not_negative(photons, "photons"), seconds


def _poisson(mean: Array, rng: np.random.Generator) -> Array:
    """Draw whole electrons around their mean number: Poisson's, or normal where that is near."""
    many = mean >= NORMAL_FROM
    if not many.any():
        return np.asarray(rng.poisson(mean), dtype=np.float64)
    electrons = np.rint(mean + np.sqrt(mean) * rng.standard_normal(mean.shape))
    if not many.all():
        electrons[~many] = rng.poisson(mean[~many])
    return np.asarray(electrons, dtype=np.float64)
