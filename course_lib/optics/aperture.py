"""How wide a lens is open: f-numbers and stops.

Use these functions through `course_lib.optics`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_not_negative, check_positive


def f_number(f: ArrayLike, d: ArrayLike) -> Array:
    """Return the f-number of a lens.

    Parameters
    ----------
    f : float or array_like
        Focal length in mm, positive.
    d : float or array_like
        Diameter of the opening (the entrance pupil) in mm, positive.

    Returns
    -------
    float or ndarray
        The number N that photographers write as f/N.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 5.3.3 (relative aperture and f-number).

    Examples
    --------
    >>> float(f_number(100, d=25))
    4.0
    """
    return check_positive(f, "f") / check_positive(d, "d")


def aperture_diameter(f: ArrayLike, N: ArrayLike) -> Array:
    """Return the diameter of a lens's opening.

    Parameters
    ----------
    f : float or array_like
        Focal length in mm, positive.
    N : float or array_like
        f-number, positive.

    Returns
    -------
    float or ndarray
        Diameter of the opening (the entrance pupil) in mm.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 5.3.3 (relative aperture and f-number).

    Examples
    --------
    >>> float(aperture_diameter(200, N=4))
    50.0
    """
    return check_positive(f, "f") / check_positive(N, "N")


def working_f_number(N: ArrayLike, m: ArrayLike) -> Array:
    """Return the f-number that light and diffraction feel when a lens is focused close by.

    The sensor then stands farther than f behind the lens, and sees the opening as smaller.

    Parameters
    ----------
    N : float or array_like
        f-number as engraved on the lens (for objects at infinity), positive.
    m : float or array_like
        Magnification, not negative; 0 for an object at infinity.

    Returns
    -------
    float or ndarray
        Image distance divided by the diameter of the opening, for a thin lens.

    Raises
    ------
    TypeError, ValueError
        If N is not positive, m is negative, or one of them is not finite.

    References
    ----------
    S. F. Ray, Applied Photographic Optics, 3rd ed. (effective aperture).

    Examples
    --------
    At life size (m = 1) a lens at f/8 lets as little light through as at f/16:

    >>> float(working_f_number(8, m=1))
    16.0
    """
    return check_positive(N, "N") * (1 + check_not_negative(m, "m"))


def stops_between(N: ArrayLike, N_new: ArrayLike) -> Array:
    """Return by how many stops the picture gets darker from one f-number to another.

    One stop halves the light.

    Parameters
    ----------
    N, N_new : float or array_like
        f-numbers before and after, positive.

    Returns
    -------
    float or ndarray
        Stops; negative where the picture gets brighter.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    ISO 517, Photography: apertures and related properties of photographic lenses.

    Examples
    --------
    >>> float(stops_between(4, 8))
    2.0
    """
    return 2 * np.log2(check_positive(N_new, "N_new") / check_positive(N, "N"))
