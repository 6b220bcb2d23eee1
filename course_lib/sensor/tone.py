"""Tones and colours: from numbers that count light to numbers that suit eyes and screens.

Use these functions through `course_lib.sensor`. Colours are red, green and blue in the last axis,
from 0 to 1.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_numbers

#: Weights of linear red, green and blue in the luminance (Rec. ITU-R BT.709).
LUMINANCE_WEIGHTS = (0.2126, 0.7152, 0.0722)


def srgb_encode(linear: ArrayLike) -> Array:
    """Return light as a file or a screen wants it: the sRGB curve, often called gamma.

    Parameters
    ----------
    linear : array_like
        Light from 0 (black) to 1 (white).

    Returns
    -------
    float or ndarray
        Code values from 0 to 1. Half of the codes are left for the darkest fifth of the light,
        where eyes tell steps apart best.

    Raises
    ------
    TypeError, ValueError
        If a value is outside of 0 to 1.

    References
    ----------
    IEC 61966-2-1:1999, section 5.2.

    Examples
    --------
    >>> srgb_encode([0, 0.214, 1]).round(3)
    array([0. , 0.5, 1. ])
    """
    linear = check_unit_range(linear, "linear")
    curve = 1.055 * linear ** (1 / 2.4) - 0.055
    return np.where(linear <= 0.0031308, 12.92 * linear, curve)[()]


def srgb_decode(encoded: ArrayLike) -> Array:
    """Return the light behind sRGB code values; the inverse of `srgb_encode`.

    Parameters
    ----------
    encoded : array_like
        Code values from 0 to 1 (a file's numbers, divided by 255).

    Returns
    -------
    float or ndarray
        Light from 0 to 1: now twice the number is twice the light.

    Raises
    ------
    TypeError, ValueError
        If a value is outside of 0 to 1.

    References
    ----------
    IEC 61966-2-1:1999, section 5.2.

    Examples
    --------
    >>> srgb_decode([0, 0.5, 1]).round(3)
    array([0.   , 0.214, 1.   ])
    """
    encoded = check_unit_range(encoded, "encoded")
    curve = ((encoded + 0.055) / 1.055) ** 2.4
    return np.where(encoded <= 0.04045, encoded / 12.92, curve)[()]


def grey_from_rgb(linear: ArrayLike) -> Array:
    """Return how bright colours look: green counts most, blue least.

    Parameters
    ----------
    linear : array_like, shape (..., 3)
        Red, green and blue, linear in light (`srgb_decode` first), 0 to 1.

    Returns
    -------
    ndarray, shape (...)
        Luminance, 0 to 1.

    Raises
    ------
    TypeError, ValueError
        If these are not colours.

    References
    ----------
    Recommendation ITU-R BT.709-6, item 3.2.

    Examples
    --------
    >>> grey_from_rgb([[1, 0, 0], [0, 1, 0], [1, 1, 1]]).round(2)
    array([0.21, 0.72, 1.  ])
    """
    grey: Array = check_colours(linear, "linear") @ np.array(LUMINANCE_WEIGHTS)
    return grey


def hsv_from_rgb(rgb: ArrayLike) -> Array:
    """Return hue, saturation and value of colours.

    Parameters
    ----------
    rgb : array_like, shape (..., 3)
        Red, green and blue, 0 to 1.

    Returns
    -------
    ndarray, shape (..., 3)
        Hue from 0 to 1 around the circle of colours (red 0, green 1/3, blue 2/3), saturation from
        0 (grey) to 1, value (the largest of the three). A grey has the hue 0.

    Raises
    ------
    TypeError, ValueError
        If these are not colours.

    References
    ----------
    A. R. Smith, "Color gamut transform pairs", SIGGRAPH 1978.

    Examples
    --------
    Light and shade on the same green differ in the value only:

    >>> hsv_from_rgb([[0.2, 0.8, 0.2], [0.1, 0.4, 0.1]]).round(3)
    array([[0.333, 0.75 , 0.8  ],
           [0.333, 0.75 , 0.4  ]])
    """
    rgb = check_colours(rgb, "rgb")
    value = rgb.max(axis=-1)
    spread = value - rgb.min(axis=-1)
    grey = spread == 0
    # Where on the circle: 0, 2 or 4 sixths for the strongest colour, and up to one sixth aside.
    turned = np.roll(rgb, -1, axis=-1) - np.roll(rgb, -2, axis=-1)
    sixths = turned / np.where(grey, 1, spread)[..., None] + np.array([0, 2, 4])
    strongest = rgb.argmax(axis=-1)[..., None]
    hue = np.take_along_axis(sixths, strongest, axis=-1)[..., 0] / 6 % 1
    saturation = spread / np.where(value == 0, 1, value)
    return np.stack([np.where(grey, 0, hue), saturation, value], axis=-1)


def rgb_from_hsv(hsv: ArrayLike) -> Array:
    """Return red, green and blue of colours given by hue, saturation and value.

    Parameters
    ----------
    hsv : array_like, shape (..., 3)
        As from `hsv_from_rgb`.

    Returns
    -------
    ndarray, shape (..., 3)
        Red, green and blue, 0 to 1.

    Raises
    ------
    TypeError, ValueError
        If these are not colours.

    References
    ----------
    A. R. Smith, "Color gamut transform pairs", SIGGRAPH 1978.

    Examples
    --------
    >>> rgb_from_hsv([1 / 3, 0.75, 0.8]).round(3)
    array([0.2, 0.8, 0.2])
    """
    hue, saturation, value = np.moveaxis(check_colours(hsv, "hsv"), -1, 0)
    # How far around the circle each of the three colours is: full for a sixth on either side.
    away = np.abs((hue[..., None] * 6 - np.array([0, 2, 4]) + 3) % 6 - 3)
    pure = np.clip(2 - away, 0, 1)
    rgb: Array = value[..., None] * (1 - saturation[..., None] * (1 - pure))
    return rgb


def check_unit_range(values: ArrayLike, name: str) -> Array:
    """Return numbers from 0 to 1, such as colours, as `float64`."""
    array = check_numbers(values, name)
    if array.size and not 0 <= array.min() <= array.max() <= 1:
        raise ValueError(
            f"{name} must be from 0 to 1, got {array.min():g} to {array.max():g}: "
            "divide 8-bit numbers by 255"
        )
    return array


def check_colours(values: ArrayLike, name: str) -> Array:
    """Return colours, shape (..., 3), from 0 to 1, as `float64`."""
    array = check_unit_range(values, name)
    if array.ndim == 0 or array.shape[-1] != 3:
        raise ValueError(f"{name} must have shape (..., 3), got {array.shape}")
    return array
