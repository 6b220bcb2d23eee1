"""Focus: how large the blur of a point is, and between which distances it is small enough.

A thin lens is focused on one distance, the focus distance. A point elsewhere makes a spot on the
sensor: the circle of confusion. Distances are measured from the lens along the optical axis, in
mm; c is the largest spot that still counts as sharp, often one pixel. The formulas are exact for
a thin lens without diffraction. Use these functions through `course_lib.optics`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_distance, check_outside_focus, check_positive


def circle_of_confusion(
    Z: ArrayLike, focus_distance: ArrayLike, f: ArrayLike, N: ArrayLike
) -> Array:
    """Return the diameter of the spot that a point of light makes on the sensor.

    Parameters
    ----------
    Z : float or array_like
        Distance from the point to the lens in mm, positive; ``np.inf`` for a star.
    focus_distance : float or array_like
        Distance from the lens at which a point is sharp, in mm, larger than f; may be ``np.inf``.
    f : float or array_like
        Focal length in mm, positive.
    N : float or array_like
        f-number, positive. Arrays broadcast.

    Returns
    -------
    float or ndarray
        Diameter of the spot on the sensor in mm, with the broadcast shape.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive, or the focus distance is not larger than f.

    References
    ----------
    S. F. Ray, Applied Photographic Optics, 3rd ed., chapter on depth of field.

    Examples
    --------
    >>> circle_of_confusion(Z=[1000, 2000, np.inf], focus_distance=2000, f=50, N=4).round(4)
    array([0.3205, 0.    , 0.3205])
    """
    Z, focus_distance = check_distance(Z, "Z"), check_distance(focus_distance, "focus_distance")
    f, N = check_positive(f, "f"), check_positive(N, "N")
    check_outside_focus(focus_distance, f, "focus_distance")
    # Similar triangles behind the lens: spot / (f / N) = |image distance - sensor distance| /
    # image distance, with 1 / image distance = 1/f - 1/Z.
    return f / N * f / (1 - f / focus_distance) * np.abs(1 / focus_distance - 1 / Z)


def hyperfocal_distance(f: ArrayLike, N: ArrayLike, c: ArrayLike) -> Array:
    """Return the nearest focus distance at which a star is still sharp enough.

    Parameters
    ----------
    f : float or array_like
        Focal length in mm, positive.
    N : float or array_like
        f-number, positive.
    c : float or array_like
        Diameter of the largest spot that counts as sharp, in mm, positive. Arrays broadcast.

    Returns
    -------
    float or ndarray
        Distance from the lens in mm, exact for a thin lens. A star's spot then measures c.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    S. F. Ray, Applied Photographic Optics, 3rd ed., chapter on depth of field.

    Examples
    --------
    >>> float(hyperfocal_distance(50, N=8, c=0.01))
    31300.0
    """
    f, N, c = check_positive(f, "f"), check_positive(N, "N"), check_positive(c, "c")
    return f * f / (N * c) + f


def depth_of_field(
    f: ArrayLike, N: ArrayLike, focus_distance: ArrayLike, c: ArrayLike
) -> tuple[Array, Array]:
    """Return the nearest and the farthest distance at which a point is sharp enough.

    Parameters
    ----------
    f : float or array_like
        Focal length in mm, positive.
    N : float or array_like
        f-number, positive.
    focus_distance : float or array_like
        Distance from the lens at which a point is sharp, in mm, larger than f.
    c : float or array_like
        Diameter of the largest spot that counts as sharp, in mm, positive. Arrays broadcast.

    Returns
    -------
    near, far : float or ndarray
        Distances from the lens in mm, exact for a thin lens. From the hyperfocal distance on,
        everything behind the near limit is sharp: far is ``np.inf``.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive, or the focus distance is not larger than f.

    References
    ----------
    S. F. Ray, Applied Photographic Optics, 3rd ed., chapter on depth of field.

    Examples
    --------
    >>> near, far = depth_of_field(50, N=8, focus_distance=2000, c=0.01)
    >>> print(f"from {near:.1f} mm to {far:.1f} mm")
    from 1882.5 mm to 2133.1 mm
    """
    f, N, c = check_positive(f, "f"), check_positive(N, "N"), check_positive(c, "c")
    s = check_distance(focus_distance, "focus_distance")
    check_outside_focus(s, f, "focus_distance")
    h = f * f / (N * c)
    # The spots of both limits measure c: h |1/limit - 1/s| = 1 - f/s.
    near = h / (1 - f / s + h / s)
    ratio = (h + f) / s  # hyperfocal distance / focus distance; up to 1, even a star is sharp
    far = h / np.where(ratio > 1, ratio - 1, np.nan)
    return near, np.where(ratio > 1, far, np.inf)[()]


def depth_of_field_approximate(
    f: ArrayLike, N: ArrayLike, focus_distance: ArrayLike, c: ArrayLike
) -> tuple[Array, Array]:
    """Return the limits of sharpness as they are worked out on the back of an envelope.

    With ``H = f² / (N c)`` in place of the exact hyperfocal distance, and f neglected beside the
    focus distance. The relative error of the width, near to far, is about f / focus_distance;
    the far limit becomes infinite one focal length too early.

    Parameters
    ----------
    f, N, focus_distance, c : float or array_like
        As in `depth_of_field`; the focus distance is finite.

    Returns
    -------
    near, far : float or ndarray
        Approximate distances from the lens in mm; far is ``np.inf`` from H on.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    S. F. Ray, Applied Photographic Optics, 3rd ed., chapter on depth of field.

    Examples
    --------
    >>> near, far = depth_of_field_approximate(50, N=8, focus_distance=2000, c=0.01)
    >>> print(f"from {near:.1f} mm to {far:.1f} mm")
    from 1879.7 mm to 2136.8 mm
    """
    f, N, c = check_positive(f, "f"), check_positive(N, "N"), check_positive(c, "c")
    d, H = check_positive(focus_distance, "focus_distance"), f * f / (N * c)
    far = H * d / np.where(d < H, H - d, np.nan)
    return H * d / (H + d), np.where(d < H, far, np.inf)[()]


def closeup_depth_of_field(m: ArrayLike, N: ArrayLike, c: ArrayLike) -> Array:
    """Return how deep the sharp range is when a small thing fills the picture.

    The magnification alone decides, whatever the focal length. The formula is nearly exact as
    long as c N is much smaller than m f.

    Parameters
    ----------
    m : float or array_like
        Magnification, positive: size of the sharp image divided by the size of the object.
    N : float or array_like
        f-number as engraved on the lens, positive.
    c : float or array_like
        Diameter of the largest spot that counts as sharp, in mm, positive. Arrays broadcast.

    Returns
    -------
    float or ndarray
        Distance from the nearest to the farthest sharp point in mm.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    References
    ----------
    S. F. Ray, Applied Photographic Optics, 3rd ed., chapter on depth of field.

    Examples
    --------
    >>> round(float(closeup_depth_of_field(m=1, N=8, c=0.005)), 3)
    0.16
    """
    m, N, c = check_positive(m, "m"), check_positive(N, "N"), check_positive(c, "c")
    return 2 * c * N * (m + 1) / m**2
