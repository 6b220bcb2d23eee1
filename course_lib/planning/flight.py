"""The arithmetic of a flight: what a pixel covers, how pictures overlap, how fast to fly.

Lengths are metres unless a name says otherwise. Use these functions through `course_lib.planning`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    check_length,
    check_not_negative,
    check_numbers,
    check_positive,
)
from course_lib.sensor import fastest_speed

SMALLEST_OBJECT = 3  # ground sampling distances: what can still be told from its surroundings


def ground_sample_distance(H: ArrayLike, f_mm: ArrayLike, pitch_um: ArrayLike) -> Array:
    """Return what one pixel covers on the ground: ``GSD = H pitch / f``.

    Parameters
    ----------
    H : float or array_like
        Height above the ground, m, positive.
    f_mm : float or array_like
        Focal length, mm, positive.
    pitch_um : float or array_like
        Pixel pitch, µm, positive. Arrays broadcast.

    Returns
    -------
    float or ndarray
        Ground sampling distance, m. The smallest object that can be identified is about three.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive.

    References
    ----------
    K. Kraus, Photogrammetry, 2nd ed., section 3.7 (planning a flight).

    Examples
    --------
    >>> round(float(ground_sample_distance(100, f_mm=8.8, pitch_um=2.41)), 4)
    0.0274
    """
    H, f = check_positive(H, "H"), check_positive(f_mm, "f_mm")
    return H * check_positive(pitch_um, "pitch_um") * 1e-3 / f


def height_for_resolution(gsd: ArrayLike, f_mm: ArrayLike, pitch_um: ArrayLike) -> Array:
    """Return the height above the ground that gives a ground sampling distance.

    Parameters
    ----------
    gsd : float or array_like
        Ground sampling distance, m, positive.
    f_mm, pitch_um : float or array_like
        As in `ground_sample_distance`.

    Returns
    -------
    float or ndarray
        Height, m.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive.

    Examples
    --------
    >>> round(float(height_for_resolution(0.02, f_mm=8.8, pitch_um=2.41)), 1)
    73.0
    """
    return check_positive(gsd, "gsd") / ground_sample_distance(1, f_mm, pitch_um)


def overlap(base: ArrayLike, footprint: ArrayLike) -> Array:
    """Return which share of a picture the next one shows too, on flat ground.

    Parameters
    ----------
    base : float or array_like
        Distance between the two centres of projection, m, not negative.
    footprint : float or array_like
        Length of what a picture covers in that direction, m, positive. Arrays broadcast.

    Returns
    -------
    float or ndarray
        ``1 - base / footprint``; negative if there is a gap between them.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of its range.

    References
    ----------
    K. Kraus, Photogrammetry, 2nd ed., section 3.7 (planning a flight).

    Examples
    --------
    >>> overlap(20, 80)
    np.float64(0.75)
    """
    return 1 - check_not_negative(base, "base") / check_positive(footprint, "footprint")


def base_for_overlap(share: ArrayLike, footprint: ArrayLike) -> Array:
    """Return how far apart pictures are taken so that neighbours overlap by a share.

    Parameters
    ----------
    share : float or array_like
        Overlap, from 0 to below 1; 2/3 shows every point in three pictures of a strip.
    footprint : float or array_like
        As in `overlap`.

    Returns
    -------
    float or ndarray
        Base, m.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of its range.

    References
    ----------
    K. Kraus, Photogrammetry, 2nd ed., section 3.7 (planning a flight).

    Examples
    --------
    >>> round(float(base_for_overlap(0.8, 90)), 6)
    18.0
    """
    share = check_numbers(share, "share")
    if ((share < 0) | (share >= 1)).any():
        raise ValueError(
            f"share must be from 0 to below 1, got {share.min():g} to {share.max():g}: "
            "80 % is 0.8, and at 100 % the camera would not move"
        )
    return (1 - share) * check_positive(footprint, "footprint")


def max_speed(
    base: ArrayLike,
    interval: ArrayLike,
    gsd: ArrayLike,
    exposure_time: ArrayLike,
    blur: ArrayLike = 0.5,
) -> Array:
    """Return how fast a camera may fly: in time for the next picture, and without a smear.

    Parameters
    ----------
    base : float or array_like
        Distance from picture to picture, m, positive.
    interval : float or array_like
        Shortest time from picture to picture, s, positive.
    gsd : float or array_like
        Ground sampling distance, m, positive.
    exposure_time : float or array_like
        s, positive.
    blur : float or array_like
        Longest smear accepted, px, positive. Arrays broadcast.

    Returns
    -------
    float or ndarray
        The smaller of ``base / interval`` and ``blur gsd / exposure_time``, m/s.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive.

    Examples
    --------
    >>> round(float(max_speed(18, 2, gsd=0.02, exposure_time=1 / 1000)), 6)  # the pictures decide
    9.0
    >>> round(float(max_speed(18, 2, gsd=0.02, exposure_time=1 / 500)), 6)  # the smear decides
    5.0
    """
    in_time = check_positive(base, "base") / check_positive(interval, "interval")
    return np.minimum(in_time, fastest_speed(exposure_time, gsd, blur))


def photo_count(
    length: float, width: float, base: float, distance: float, footprint_width: float
) -> tuple[int, int]:
    """Return how many pictures a rectangle on flat ground takes: in a strip, and strips.

    Parameters
    ----------
    length, width : float
        Of the rectangle, along and across the strips, m.
    base : float
        From picture to picture along a strip, m.
    distance : float
        From strip to strip, m.
    footprint_width : float
        Of what a picture covers across the strip, m.

    Returns
    -------
    pictures, strips : int
        Pictures in each strip: from one end of the rectangle to the other or beyond, so that each
        of its points lies between two neighbours. Strips: so many that the outer ones reach the
        rectangle's sides. All together pictures × strips.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive, or the strips leave gaps.

    References
    ----------
    K. Kraus, Photogrammetry, 2nd ed., section 3.7 (planning a flight).

    Examples
    --------
    >>> photo_count(length=500, width=300, base=18, distance=36, footprint_width=110)
    (29, 7)
    """
    names = ("length", "width", "base", "distance", "footprint_width")
    values = (length, width, base, distance, footprint_width)
    length, width, base, distance, footprint_width = map(check_length, values, names)
    if distance > footprint_width:
        raise ValueError(
            f"strips {distance:g} m apart leave gaps: a picture is only {footprint_width:g} m wide"
        )
    tiny = 1e-9  # a quotient that is whole but for rounding is whole
    pictures = int(np.ceil(length / base - tiny)) + 1
    strips = max(int(np.ceil((width - footprint_width) / distance - tiny)), 0) + 1
    return pictures, strips
