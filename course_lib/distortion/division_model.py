"""The division model: one coefficient, strong distortion, and a formula in both directions.

With distances from the centre, ``r = r_d / (1 + λ r_d²)``. Use these functions through
`course_lib.distortion`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_number
from course_lib.distortion.model import LARGEST_COEFFICIENT, check_normalised


def undistort_division(points: ArrayLike, coefficient: float) -> Array:
    """Return ideal points from distorted ones, by the division model.

    Parameters
    ----------
    points : array_like, shape (N, 2) or (2,)
        Distorted points in normalised coordinates, in rows.
    coefficient : float
        λ; negative for a barrel, positive for a pincushion.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        The points divided by ``1 + λ r_d²``. A row of NaN from ``r_d² = 1 / |λ|`` onwards: there a
        barrel has reached a right angle from the axis, and a pincushion has folded over.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or the points are pixels rather than tangents.

    References
    ----------
    A. W. Fitzgibbon, "Simultaneous linear estimation of multiple view geometry and lens
    distortion", CVPR 2001.

    Examples
    --------
    >>> undistort_division([[0.5, 0], [2, 0]], -0.8)
    array([[0.625, 0.   ],
           [  nan,   nan]])
    """
    points, coefficient = check_normalised(points, "points"), _check(coefficient)
    bend = coefficient * (points**2).sum(axis=-1, keepdims=True)
    return points / np.where(np.abs(bend) < 1, 1 + bend, np.nan)


def distort_division(points: ArrayLike, coefficient: float) -> Array:
    """Return distorted points from ideal ones, by the division model.

    Parameters
    ----------
    points : array_like, shape (N, 2) or (2,)
        Ideal points in normalised coordinates, in rows.
    coefficient : float
        λ; negative for a barrel, positive for a pincushion.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Distorted points: the smaller root of ``λ r r_d² - r_d + r = 0``. A row of NaN where there
        is none, beyond ``r² = 1 / (4 λ)`` of a pincushion.

    Raises
    ------
    TypeError, ValueError
        As `undistort_division`.

    References
    ----------
    A. W. Fitzgibbon, "Simultaneous linear estimation of multiple view geometry and lens
    distortion", CVPR 2001.

    Examples
    --------
    >>> distort_division([0.625, 0], -0.8)
    array([0.5, 0. ])
    """
    points, coefficient = check_normalised(points, "points"), _check(coefficient)
    root = 1 - 4 * coefficient * (points**2).sum(axis=-1, keepdims=True)
    # The root as 2 / (1 + √…), which loses no digits where λ r² is small.
    return np.asarray(points * 2 / (1 + np.sqrt(np.where(root >= 0, root, np.nan))))


def _check(coefficient: float) -> float:
    number = check_number(coefficient, "coefficient")
    if abs(number) > LARGEST_COEFFICIENT:
        raise ValueError(f"coefficient is {number:g}, which no lens has")
    return number
