"""Which f-number to choose: deep enough, and not blurred by diffraction.

Distances are measured from a thin lens along the optical axis, in mm. Use these functions through
`course_lib.optics`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    check_distance,
    check_outside_focus,
    check_positive,
)
from course_lib.optics.diffraction import airy_diameter
from course_lib.optics.focus import circle_of_confusion


def check_range(f: ArrayLike, near: ArrayLike, far: ArrayLike) -> tuple[Array, Array]:
    """Return the two ends of a range, once they are outside the focal length and in order."""
    near, far = check_positive(near, "near"), check_distance(far, "far")
    check_outside_focus(near, check_positive(f, "f"), "near")
    if (near >= far).any():
        raise ValueError(
            f"near must be smaller than far, got near = {np.max(near):g} and far = "
            f"{np.min(far):g}: exchange them, or widen the range"
        )
    return near, far


def apertures_for_limits(
    f: ArrayLike, near: ArrayLike, far: ArrayLike, focus_distance: ArrayLike, c: ArrayLike
) -> tuple[Array, Array]:
    """Return the f-numbers that the near and the far end of a range need, each for itself.

    The larger of the two makes both ends sharp enough.

    Parameters
    ----------
    f : float or array_like
        Focal length in mm, positive.
    near, far : float or array_like
        Distances from the lens to the ends of the range in mm, with near < far; far may be
        ``np.inf``.
    focus_distance : float or array_like
        Distance from the lens at which a point is sharp, in mm, from near to far.
    c : float or array_like
        Diameter of the largest spot that counts as sharp, in mm, positive. Arrays broadcast.

    Returns
    -------
    N_near, N_far : float or ndarray
        f-numbers at which the spots of the near and the far end measure c; exact for a thin lens.

    Raises
    ------
    TypeError, ValueError
        If the range is empty or not outside the focal length, the focus is not inside the range,
        or an argument is not positive.

    References
    ----------
    S. F. Ray, Applied Photographic Optics, 3rd ed., chapter on depth of field.

    Examples
    --------
    >>> N_near, N_far = apertures_for_limits(50, near=900, far=1100, focus_distance=1000, c=0.02)
    >>> print(f"{N_near:.1f} and {N_far:.1f}")
    14.6 and 12.0
    """
    near, far = check_range(f, near, far)
    s, c = check_distance(focus_distance, "focus_distance"), check_positive(c, "c")
    if (s < near).any() or (s > far).any():
        raise ValueError("focus_distance must lie between near and far: focus inside the range")
    # The spot shrinks as 1/N: at f/1 it is N times as large as at f/N.
    return circle_of_confusion(near, s, f, 1) / c, circle_of_confusion(far, s, f, 1) / c


def aperture_for_depth(
    f: ArrayLike, near: ArrayLike, far: ArrayLike, c: ArrayLike
) -> tuple[Array, Array]:
    """Return the smallest f-number that makes a whole range sharp enough, and where to focus.

    The spots of the near and the far end are then equally large: c.

    Parameters
    ----------
    f : float or array_like
        Focal length in mm, positive.
    near, far : float or array_like
        Distances from the lens to the ends of the range in mm, with f < near < far; far may be
        ``np.inf``.
    c : float or array_like
        Diameter of the largest spot that counts as sharp, in mm, positive. Arrays broadcast.

    Returns
    -------
    N, focus_distance : float or ndarray
        f-number, and the distance from the lens to focus on in mm; exact for a thin lens.

    Raises
    ------
    TypeError, ValueError
        If the range is empty or not outside the focal length, or an argument is not positive.

    References
    ----------
    S. F. Ray, Applied Photographic Optics, 3rd ed., chapter on depth of field.

    Examples
    --------
    >>> N, focus_distance = aperture_for_depth(50, near=900, far=1100, c=0.02)
    >>> print(f"f/{N:.1f}, focused on {focus_distance:.0f} mm")
    f/13.3, focused on 990 mm
    """
    near, far = check_range(f, near, far)
    f, c = check_positive(f, "f"), check_positive(c, "c")
    focus_distance = 2 / (1 / near + 1 / far)  # in 1/Z, halfway between the ends
    return f**2 * (focus_distance / near - 1) / (c * (focus_distance - f)), focus_distance


def sharpest_f_number(
    Z: ArrayLike, focus_distance: ArrayLike, f: ArrayLike, wavelength: ArrayLike
) -> Array:
    """Return the f-number at which a point out of focus makes the smallest spot.

    A wide opening blurs it by defocus, a narrow one by diffraction. The spot is taken as the sum
    of the two diameters, a rule of thumb: circle of confusion and Airy disk.

    Parameters
    ----------
    Z : float or array_like
        Distance from the point to the lens in mm, positive; ``np.inf`` for a star.
    focus_distance : float or array_like
        Distance from the lens at which a point is sharp, in mm, larger than f; not equal to Z.
    f : float or array_like
        Focal length in mm, positive.
    wavelength : float or array_like
        Wavelength of the light in mm, positive (550 nm are 0.00055 mm). Arrays broadcast.

    Returns
    -------
    float or ndarray
        Best f-number. There the two parts of the spot are equally large.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive, the focus distance is not larger than f, or the point is
        in focus: then the widest opening is the sharpest.

    References
    ----------
    S. F. Ray, Applied Photographic Optics, 3rd ed., chapter on depth of field.

    Examples
    --------
    >>> round(float(sharpest_f_number(Z=1100, focus_distance=1000, f=50, wavelength=0.00055)), 1)
    13.0
    """
    defocus = circle_of_confusion(Z, focus_distance, f, 1)
    if (defocus == 0).any():
        raise ValueError(
            "Z must differ from focus_distance: a point in focus has no defocus to balance, and "
            "is sharpest at the smallest f-number that the lens has"
        )
    # Seen from the sensor the opening is 1 / (1 - f / focus_distance) times as far as f.
    spread = airy_diameter(wavelength, 1 / (1 - np.asarray(f) / np.asarray(focus_distance)))
    return np.sqrt(defocus / spread)  # least of defocus / N + spread N
