"""Measure a sensor with its own pictures, and undo what is uneven in them.

Use these functions through `course_lib.sensor`. Pictures hold DN, linear in light.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_not_negative,
    check_number,
    check_numbers,
)
from course_lib.sensor.detector import check_light
from course_lib.sensor.sensor_model import SensorModel

#: Share of pixels at the largest number from which on a picture counts as saturated.
SATURATED = 0.001


def signal_to_noise(photons: ArrayLike, camera: SensorModel, exposure_time: float = 0.0) -> Array:
    """Return how many times larger the signal of a pixel is than its noise.

    The noise has four independent sources: the photons' own chance (shot noise), the dark current,
    the readout, and the rounding to whole numbers.

    Parameters
    ----------
    photons : float or array_like
        Photons that arrive in a pixel during the exposure, on average; not negative. So many that
        nothing is clipped; beyond, the picture is white and the ratio means nothing.
    camera : SensorModel
        ``camera.quantum_efficiency``, ``camera.dark_current`` (electrons per second),
        ``camera.read_noise`` and ``camera.quantisation_noise`` (both standard deviations in
        electrons) count.
    exposure_time : float
        Seconds during which the dark current is collected.

    Returns
    -------
    float or ndarray
        Electrons that light has set free, by the standard deviation of all electrons.

    Raises
    ------
    TypeError, ValueError
        If an argument is negative or not finite.

    References
    ----------
    EMVA Standard 1288, release 4.0 (linear), section 2.

    Examples
    --------
    >>> camera = SensorModel(quantum_efficiency=0.5, read_noise=10, gain=1)
    >>> signal_to_noise(np.array([20, 20_000]), camera).round(2)
    array([ 0.95, 99.5 ])
    """
    photons, exposure_time = check_light(photons, exposure_time)
    signal = camera.quantum_efficiency * photons
    # Independent noises add by their variances; that of counted electrons is their number.
    shot = signal + camera.dark_current * exposure_time
    return signal / np.sqrt(shot + camera.read_noise**2 + camera.quantisation_noise**2)


def dynamic_range(camera: SensorModel) -> float:
    """Return the brightest light that a picture tells from white, by the darkest above its noise.

    Parameters
    ----------
    camera : SensorModel
        Its full well, read noise, gain, offset and bits count.

    Returns
    -------
    float
        A ratio; `stops` and `decibels` give it in other units. Saturation in electrons, by the
        noise of a dark pixel (readout and rounding).

    References
    ----------
    EMVA Standard 1288, release 4.0 (linear), section 2.

    Examples
    --------
    >>> round(dynamic_range(SensorModel(full_well=10_000, read_noise=10, gain=0.39, offset=0)))
    997
    """
    floor = np.hypot(camera.read_noise, camera.quantisation_noise)
    return float(camera.saturation / floor)


def clipped_fraction(image: ArrayLike, black: float = 0, white: float = 255) -> Array:
    """Return the share of a picture's pixels that are clipped: at its black and its white end.

    Parameters
    ----------
    image : array_like, shape (rows, columns) or (rows, columns, 3)
        Grey values or colours. A coloured pixel is clipped as soon as one of its colours is.
    black, white : float
        The smallest and the largest number of the camera: what is there or beyond is clipped.

    Returns
    -------
    ndarray, shape (2,)
        Shares from 0 to 1, ``[black, white]``. With colours, a pixel may count in both.

    Raises
    ------
    TypeError, ValueError
        If `image` is not a picture, or black is not below white.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 10.2 (high dynamic range imaging).

    Examples
    --------
    >>> clipped_fraction(np.array([[0, 7, 255, 255], [3, 0, 254, 255]]))
    array([0.25 , 0.375])
    """
    image = check_picture(image, "image")
    black, white = check_number(black, "black"), check_number(white, "white")
    if black >= white:
        raise ValueError(f"black must be below white, got {black:g} and {white:g}")
    pixels = image.reshape(*image.shape[:2], -1)
    ends = [(pixels <= black).any(axis=2), (pixels >= white).any(axis=2)]
    return np.array([end.mean() for end in ends])


def camera_gain_from_pairs(
    first: ArrayLike, second: ArrayLike, dark_first: ArrayLike, dark_second: ArrayLike, white: float
) -> float:
    """Return the gain of a camera, measured with pairs of pictures of an even surface.

    Electrons come by chance: where there are n of them on average, their variance is n too. So a
    camera's numbers give its gain away. The two pictures of a pair are taken alike; what differs
    between them is noise, what is the same in both (dust, uneven pixels, an uneven lamp) is not.

    Parameters
    ----------
    first, second : array_like, shape (levels, rows, columns)
        The pictures of each pair, in DN; each pair in another light, some perhaps too bright.
    dark_first, dark_second : array_like, shape (rows, columns)
        A pair without light.
    white : float
        The largest number of the camera. A pair is left out where more than one pixel of a
        thousand, in one of its pictures, holds this number.

    Returns
    -------
    float
        Gain in DN per electron.

    Raises
    ------
    TypeError, ValueError
        If shapes differ.
    DegenerateConfigurationError
        If no pair is left that is brighter than the dark one and not saturated.

    References
    ----------
    J. Janesick, Photon Transfer, chapters 5 and 6; EMVA Standard 1288, release 4.0 (linear).

    Notes
    -----
    Pictures are often unsigned whole numbers, which wrap around below zero: make them `float`
    before you subtract.
    """
    first, second, dark_first, dark_second = check_pairs(first, second, dark_first, dark_second)
    mean = (first + second).mean(axis=(1, 2)) / 2 - (dark_first + dark_second).mean() / 2
    # Var(a - b) = 2 Var(a) for independent a and b of the same distribution.
    variance = (first - second).var(axis=(1, 2)) / 2 - (dark_first - dark_second).var() / 2
    clipped = [(pictures >= white).mean(axis=(1, 2)) for pictures in (first, second)]
    good = (np.max(clipped, axis=0) <= SATURATED) & (mean > 0)
    if not good.any():
        raise DegenerateConfigurationError(
            "no pair is both brighter than the dark pictures and not saturated: take others"
        )
    # The straight line through the origin: variance = gain · mean.
    return float(mean[good] @ variance[good] / (mean[good] @ mean[good]))


def flat_field(image: ArrayLike, dark: ArrayLike, flat: ArrayLike) -> Array:
    """Return a picture without the unevenness of lens, lamp and pixels.

    Parameters
    ----------
    image : array_like, shape (rows, columns) or (rows, columns, 3)
        The picture in DN, linear in light.
    dark : array_like, the same shape
        A picture without light (the mean of many is best).
    flat : array_like, the same shape
        A picture of an even, white surface in the same light.

    Returns
    -------
    ndarray, the same shape
        What is left of the picture above the dark one, as if all pixels saw the flat surface
        equally bright: as bright as they see it on average (for each colour).

    Raises
    ------
    TypeError, ValueError
        If shapes differ, or a pixel of `flat` is not brighter than in `dark`.

    References
    ----------
    J. Janesick, Photon Transfer, chapter 8 (flat fielding).

    Notes
    -----
    Pictures are often unsigned whole numbers, which wrap around below zero: make them `float`
    before you subtract.

    Examples
    --------
    The right pixel sees half as much of everything:

    >>> image, dark, flat = np.array([[110, 60]]), np.array([[10, 10]]), np.array([[210, 110]])
    >>> flat_field(image, dark, flat)
    array([[75., 75.]])
    """
    image, dark, flat = (
        check_picture(picture, name)
        for picture, name in ((image, "image"), (dark, "dark"), (flat, "flat"))
    )
    check_same_shape(image, {"dark": dark, "flat": flat})
    light = flat - dark
    if (light <= 0).any():
        count = np.count_nonzero(light <= 0)
        raise ValueError(
            f"flat is not brighter than dark in {count} of {light.size} values: these pixels are "
            "dead, or the two pictures were exchanged. Mend them from their neighbours first"
        )
    return np.asarray((image - dark) / light * light.mean(axis=(0, 1)))


def check_pairs(*pictures: ArrayLike) -> list[Array]:
    """Return the pairs of `camera_gain_from_pairs` as `float64`, once their shapes fit."""
    names = ("first", "second", "dark_first", "dark_second")
    arrays = [check_not_negative(p, name) for p, name in zip(pictures, names, strict=True)]
    if arrays[0].ndim != 3 or not arrays[0].size:
        raise ValueError(
            f"first must have shape (levels, rows, columns), got {arrays[0].shape}: "
            "use picture[None] for a single pair"
        )
    shapes = (arrays[0].shape, arrays[0].shape, arrays[0].shape[1:], arrays[0].shape[1:])
    for array, shape, name in zip(arrays, shapes, names, strict=True):
        if array.shape != shape:
            raise ValueError(f"{name} must have shape {shape}, as first has, got {array.shape}")
    return arrays


def check_picture(value: ArrayLike, name: str) -> Array:
    """Return a picture, of grey values or colours, as `float64`."""
    array = check_numbers(value, name)
    if array.ndim not in (2, 3) or not array.size:
        raise ValueError(
            f"{name} must have shape (rows, columns) or (rows, columns, 3), got {array.shape}"
        )
    return array


def check_same_shape(image: Array, others: dict[str, Array]) -> None:
    """Raise unless each of the named pictures has the shape of `image`."""
    for name, other in others.items():
        if other.shape != image.shape:
            raise ValueError(
                f"{name} must have the shape of image, {image.shape}, got {other.shape}"
            )
