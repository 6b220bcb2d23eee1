"""Depth from the disparity of a rectified pair, and what an error of a pixel makes of it.

Use these functions through `course_lib.triangulation`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_length,
    check_number,
    check_numbers,
    check_positive,
)


def depth_from_disparity(
    disparity: ArrayLike, f: float, baseline: float, offset: float = 0.0
) -> Array:
    """Return how far away points are that a rectified pair shows apart, ``Z = f b / (d + offset)``.

    Parameters
    ----------
    disparity : array_like, any shape
        ``d = u_left - u_right`` in px.
    f : float
        Focal length of both rectified pictures in px.
    baseline : float
        Distance of the cameras.
    offset : float
        ``c_x,right - c_x,left`` in px: by how much the principal points differ. Zero if both
        pictures have the same intrinsics.

    Returns
    -------
    ndarray, shape of `disparity`
        Depths in the unit of the baseline.

    Raises
    ------
    TypeError, ValueError
        If a number is not finite, or f or the baseline is not positive.
    DegenerateConfigurationError
        If ``d + offset`` is not positive: such a point is infinitely far away, or a wrong match.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., equation 12.1; D. Scharstein et al., "High-resolution
    stereo datasets with subpixel-accurate ground truth" (2014), for the offset.

    Examples
    --------
    >>> depth_from_disparity([100, 50], f=1000, baseline=0.2)
    array([2., 4.])
    """
    d = check_numbers(disparity, "disparity")
    f, b = check_length(f, "f"), check_length(baseline, "baseline")
    apart = d + check_number(offset, "offset")
    if (apart <= 0).any():
        raise DegenerateConfigurationError(
            f"disparity + offset must be positive, got {apart.min():g} px: at zero a point is "
            "infinitely far away, below it the match is wrong or left and right are swapped; leave "
            "such points out"
        )
    return np.asarray(f * b / apart)


def depth_uncertainty(Z: ArrayLike, f: float, baseline: float, sigma: float) -> Array:
    """Return the standard deviation of depths, ``σ_Z = Z² σ_d / (f b)``.

    Twice as far away is four times as uncertain; twice the baseline is half as uncertain.

    Parameters
    ----------
    Z : array_like, any shape
        Depths.
    f : float
        Focal length of both rectified pictures in px.
    baseline : float
        Distance of the cameras, in the unit of Z.
    sigma : float
        Standard deviation of the disparity in px: √2 times that of a pixel in each picture, if
        their errors are independent.

    Returns
    -------
    ndarray, shape of `Z`
        Standard deviations in the unit of Z, to first order.

    Raises
    ------
    TypeError, ValueError
        If a number is not finite or not positive.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 12.1; the derivative of ``Z = f b / d``.

    Examples
    --------
    >>> depth_uncertainty([2, 4], f=1000, baseline=0.2, sigma=0.5)
    array([0.01, 0.04])
    """
    Z = check_positive(Z, "Z")
    f, b = check_length(f, "f"), check_length(baseline, "baseline")
    return np.asarray(Z * Z * (check_length(sigma, "sigma") / (f * b)))
