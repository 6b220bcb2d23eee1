"""Diffraction: how small a spot of light can get behind a round opening.

Use these functions through `course_lib.optics`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import Array, check_positive

Truth = NDArray[np.bool_]


def airy_diameter(wavelength: ArrayLike, N: ArrayLike) -> Array:
    """Return the diameter of the first dark ring around the image of a point of light.

    Even without any geometric blur, light spreads at the edge of a round opening.

    Parameters
    ----------
    wavelength : float or array_like
        Wavelength of the light, positive, in any unit of length.
    N : float or array_like
        f-number: distance from the opening to the image, divided by its diameter; positive.

    Returns
    -------
    float or ndarray
        Diameter of the Airy disk in the unit of `wavelength`.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 10.2.5 (the circular aperture).

    Examples
    --------
    Green light of 0.55 µm at f/8, in µm:

    >>> round(float(airy_diameter(0.55, 8)), 3)
    10.736
    """
    return 2.44 * check_positive(wavelength, "wavelength") * check_positive(N, "N")


def is_diffraction_limited(N: ArrayLike, wavelength: ArrayLike, pitch: ArrayLike) -> Truth:
    """Say whether diffraction, rather than the pixels, limits the detail in a picture.

    A picture is called diffraction-limited here when the Airy disk of a point is wider than one
    pixel. (Diffraction becomes visible gradually; other rules allow for two or three pixels.)

    Parameters
    ----------
    N : float or array_like
        f-number, positive.
    wavelength : float or array_like
        Wavelength of the light, positive, in any unit of length.
    pitch : float or array_like
        Distance from one pixel to the next, positive, in the same unit. Arrays broadcast.

    Returns
    -------
    bool or ndarray of bool
        True where the disk is wider than the pixel, with the broadcast shape.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 10.2.5 (the circular aperture).

    Examples
    --------
    A pixel of 5 µm in green light of 0.55 µm:

    >>> is_diffraction_limited(np.array([2.8, 4, 8]), wavelength=0.55, pitch=5)
    array([False,  True,  True])
    """
    return airy_diameter(wavelength, N) > check_positive(pitch, "pitch")
