"""What moves while the shutter is open, and what moves while the rows are read one by one.

Use these functions through `course_lib.sensor`.
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from course_lib.checks import Array, check_not_negative, check_numbers, check_positive


def motion_blur_pixels(speed: ArrayLike, exposure_time: ArrayLike, pixel_size: ArrayLike) -> Array:
    """Return over how many pixels a moving point is smeared during the exposure.

    Parameters
    ----------
    speed : float or array_like
        Of the object across the line of sight, or of the camera; not negative. In mm/s, if
        `pixel_size` is in mm.
    exposure_time : float or array_like
        Seconds, positive.
    pixel_size : float or array_like
        What one pixel covers on the object (the ground sampling distance), positive.

    Returns
    -------
    float or ndarray
        Length of the smear in px. Arrays broadcast.

    Raises
    ------
    TypeError, ValueError
        If an argument is outside its range.

    References
    ----------
    T. Luhmann et al., Close-Range Photogrammetry and 3D Imaging, 4th ed., chapter 3.

    Examples
    --------
    A drone at 10 m/s, 1/500 s, 25 mm on the ground a pixel:

    >>> round(float(motion_blur_pixels(10, 1 / 500, 0.025)), 6)
    0.8
    """
    speed = check_not_negative(speed, "speed")
    exposure_time = check_positive(exposure_time, "exposure_time")
    return speed * exposure_time / check_positive(pixel_size, "pixel_size")


def fastest_speed(exposure_time: ArrayLike, pixel_size: ArrayLike, blur: ArrayLike = 0.5) -> Array:
    """Return the speed at which the smear reaches what is accepted.

    Parameters
    ----------
    exposure_time : float or array_like
        Seconds, positive.
    pixel_size : float or array_like
        What one pixel covers on the object, positive.
    blur : float or array_like
        Smear that is accepted, in px, positive; half a pixel is a common limit.

    Returns
    -------
    float or ndarray
        Speed in units of `pixel_size` per second.

    Raises
    ------
    TypeError, ValueError
        If an argument is not positive and finite.

    Examples
    --------
    >>> float(fastest_speed(1 / 500, 0.025))
    6.25
    """
    pixel_size = check_positive(pixel_size, "pixel_size")
    return (
        check_positive(blur, "blur") * pixel_size / check_positive(exposure_time, "exposure_time")
    )


def rolling_shutter_skew(speed: ArrayLike, row_time: ArrayLike, rows: ArrayLike) -> Array:
    """Return how far the bottom of a moving upright edge is from below its top, in the picture.

    A rolling shutter reads row after row, from the top of the picture down; meanwhile the edge
    moves on.

    Parameters
    ----------
    speed : float or array_like
        Of the edge in the picture, in px/s: positive to the right, negative to the left.
    row_time : float or array_like
        From the reading of one row to that of the next, in s, positive.
    rows : float or array_like
        How many rows lower the bottom of the edge is than its top, positive.

    Returns
    -------
    float or ndarray
        Columns from the top to the bottom, positive to the right, in px. Arrays broadcast.

    Raises
    ------
    TypeError, ValueError
        If an argument is outside its range.

    References
    ----------
    C. Geyer, M. Meingast, S. Sastry, "Geometric models of rolling-shutter cameras", OMNIVIS 2005.

    Examples
    --------
    >>> float(rolling_shutter_skew(-2000, row_time=20e-6, rows=500))
    -20.0
    """
    row_time = check_positive(row_time, "row_time")
    return check_numbers(speed, "speed") * row_time * check_positive(rows, "rows")
