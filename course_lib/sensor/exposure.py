"""Exposure: aperture, time and sensitivity, counted in stops, and the photons behind them.

A stop is a factor of two in light. Use these functions through `course_lib.sensor`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_length, check_numbers, check_positive, check_vector

PLANCK, LIGHT_SPEED = 6.62607015e-34, 299_792_458.0  # J s, m/s: exact by the SI's definition
LUMENS_PER_WATT = 683.0  # at 555 nm, where the eye is most sensitive


def exposure_value(N: ArrayLike, t: ArrayLike, iso: ArrayLike = 100) -> Array:
    """Return the exposure value (EV) of a camera's settings, referred to ISO 100.

    Settings with the same value give equally bright pictures of the same scene. One more is for a
    scene twice as bright: the settings let in, or amplify, half as much.

    Parameters
    ----------
    N : float or array_like
        F-number, positive.
    t : float or array_like
        Exposure time in s, positive.
    iso : float or array_like
        ISO speed, positive: twice the speed makes twice the number out of the same light.

    Returns
    -------
    float or ndarray
        Stops; 0 is one second at f/1 and ISO 100. Arrays broadcast.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    ISO 2720:1974, Photography - General purpose photographic exposure meters.

    Examples
    --------
    Bright sun asks for about 15, a living room in the evening for 6:

    >>> N, t, iso = np.array([16, 2]), np.array([1 / 125, 1 / 60]), np.array([100, 400])
    >>> exposure_value(N, t, iso).round(1)
    array([15. ,  5.9])
    """
    N, t, iso = check_positive(N, "N"), check_positive(t, "t"), check_positive(iso, "iso")
    return np.log2(N**2 / t) - np.log2(iso / 100)


def equivalent_exposure(
    t: ArrayLike, N: ArrayLike, N_new: ArrayLike, iso: ArrayLike = 100, iso_new: ArrayLike = 100
) -> Array:
    """Return the exposure time that keeps a picture as bright after aperture or ISO change.

    Parameters
    ----------
    t : float or array_like
        Exposure time before the change, in s, positive.
    N, N_new : float or array_like
        F-number before and after, positive.
    iso, iso_new : float or array_like
        ISO speed before and after, positive.

    Returns
    -------
    float or ndarray
        Exposure time after the change, in s. Arrays broadcast.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    S. Ray, Applied Photographic Optics, 3rd ed., on exposure.

    Examples
    --------
    Four stops more through the lens, one less of gain:

    >>> float(equivalent_exposure(2, N=16, N_new=4, iso=200, iso_new=100))
    0.25
    """
    t, N, N_new = check_positive(t, "t"), check_positive(N, "N"), check_positive(N_new, "N_new")
    iso, iso_new = check_positive(iso, "iso"), check_positive(iso_new, "iso_new")
    return t * (N_new / N) ** 2 * (iso / iso_new)


def exposure_difference(settings: ArrayLike, other: ArrayLike) -> float:
    """Return how many stops brighter a picture gets with some settings than with others.

    Parameters
    ----------
    settings, other : array_like, shape (3,)
        F-number, exposure time in s, ISO speed.

    Returns
    -------
    float
        Stops: positive where `settings` make the brighter picture, 1 for twice the number.

    Raises
    ------
    TypeError, ValueError
        If there are not three positive numbers each.

    Examples
    --------
    >>> exposure_difference((4, 1 / 30, 100), (4, 1 / 60, 100))
    1.0
    """
    names = "settings (N, t, iso)", "other (N, t, iso)"
    ours = check_positive(check_vector(settings, 3, names[0]), names[0])
    theirs = check_positive(check_vector(other, 3, names[1]), names[1])
    return float(exposure_value(*theirs) - exposure_value(*ours))


def stops(ratio: ArrayLike) -> Array:
    """Return a ratio of light, or of signals, in stops: how often it doubles.

    Examples
    --------
    >>> stops([1, 2, 1024])
    array([ 0.,  1., 10.])
    """
    return np.log2(check_positive(ratio, "ratio"))


def decibels(ratio: ArrayLike) -> Array:
    """Return a ratio of signals (voltages, numbers) in dB: 20 for each factor of ten.

    Examples
    --------
    >>> decibels([1, 10, 1000])
    array([ 0., 20., 60.])
    """
    return 20 * np.log10(check_positive(ratio, "ratio"))


def luminance(illuminance: ArrayLike, reflectance: ArrayLike) -> Array:
    """Return how bright a matt surface is, in cd/m², under a light in lux.

    Parameters
    ----------
    illuminance : float or array_like
        Light on the surface in lux, positive: 100 000 in the sun, 500 in an office, 1 in a street.
    reflectance : float or array_like
        Share that the surface sends back, above 0 and at most 1; a photographer's grey card: 0.18.

    Returns
    -------
    float or ndarray
        Luminance in cd/m², the same in all directions (Lambert's law).

    Raises
    ------
    TypeError, ValueError
        If an argument is outside its range.

    Examples
    --------
    >>> round(float(luminance(500, 0.18)), 2)
    28.65
    """
    illuminance = check_positive(illuminance, "illuminance")
    return illuminance * _check_share(reflectance, "reflectance") / np.pi


def photons_per_pixel(
    luminance: ArrayLike,
    N: ArrayLike,
    t: ArrayLike,
    pitch_um: float,
    *,
    magnification: float = 0.0,
    transmittance: float = 1.0,
    wavelength_um: float = 0.555,
) -> Array:
    """Return how many photons a surface of the scene sends into one pixel.

    All light is taken to be green light of one wavelength, to which the eye is most sensitive;
    white light of the same luminance brings two to three times as many photons, as it holds
    colours that the eye weighs less.

    Parameters
    ----------
    luminance : float or array_like
        Of the surface, in cd/m², positive.
    N : float or array_like
        F-number, positive.
    t : float or array_like
        Exposure time in s, positive.
    pitch_um : float
        Side of a square pixel in µm, positive.
    magnification : float
        Size of the image by that of the object, not negative; 0 for a far scene.
    transmittance : float
        Share of the light that gets through the lens (and a colour filter).
    wavelength_um : float
        Wavelength whose photons are counted, in µm.

    Returns
    -------
    float or ndarray
        Photons in a pixel in the middle of the picture. Arrays broadcast.

    Raises
    ------
    TypeError, ValueError
        If an argument is outside its range.

    References
    ----------
    W. J. Smith, Modern Optical Engineering, 4th ed., on radiometry: the illuminance behind a lens
    is π L / (4 N² (1 + m)²).

    Examples
    --------
    A grey card in an office (28.6 cd/m²), f/4, a hundredth of a second, pixels of 3.45 µm:

    >>> round(float(photons_per_pixel(28.6, 4, 0.01, 3.45)), -1)
    680.0
    """
    luminance, N, t = (
        check_positive(value, name)
        for value, name in ((luminance, "luminance"), (N, "N"), (t, "t"))
    )
    pitch = check_length(pitch_um, "pitch_um") * 1e-6
    m = check_numbers(magnification, "magnification")
    if (m < 0).any():
        raise ValueError(f"magnification must not be negative, got {m:g}: take its absolute value")
    lux = np.pi * luminance * _check_share(transmittance, "transmittance") / (2 * N * (1 + m)) ** 2
    joules = lux / LUMENS_PER_WATT * t * pitch**2
    return joules * check_length(wavelength_um, "wavelength_um") * 1e-6 / (PLANCK * LIGHT_SPEED)


def _check_share(value: ArrayLike, name: str) -> Array:
    array = check_positive(value, name)
    if (array > 1).any():
        raise ValueError(f"{name} must be at most 1, got {array.max():g}: 18 % is 0.18")
    return array
