"""Control and check points: how good a block is that surveyed points have oriented.

The residuals of control points flatter: the orientation was chosen to make them small. Points that
had no part in it tell the truth.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_length
from course_lib.correspondences import check_correspondences
from course_lib.similarity import similarity_transform


class CheckErrors(NamedTuple):
    """Root mean square errors of check points.

    Attributes
    ----------
    x, y, z : float
        Along each axis.
    horizontal : float
        Of the distances in plan, ``√(x² + y²)``.
    total : float
        Of the distances in space, ``√(x² + y² + z²)``.
    """

    x: float
    y: float
    z: float
    horizontal: float
    total: float


def check_point_rmse(estimated: ArrayLike, surveyed: ArrayLike) -> CheckErrors:
    """Return the root mean square errors of points, by their surveyed places.

    Nothing is fitted: divide by the number of points, not by a redundancy.

    Parameters
    ----------
    estimated, surveyed : array_like, shape (N, 3)
        Points in the world, in the same order.

    Returns
    -------
    CheckErrors
        Along the axes, in plan and in space, in the unit of the points.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite or there are no points.

    References
    ----------
    ASPRS Positional Accuracy Standards for Digital Geospatial Data, 2nd ed. (2023).

    Examples
    --------
    >>> check_point_rmse([[3, 4, 0], [0, 0, 0]], [[0, 0, 0], [0, 0, 0]]).total.__round__(3)
    3.536
    """
    names = "estimated points", "surveyed points"
    one, other = check_correspondences(estimated, surveyed, (3, 3), names, least=1)
    x, y, z = (((one - other) ** 2).mean(axis=0)).tolist()
    roots = (math.sqrt(value) for value in (x, y, z, x + y, x + y + z))
    return CheckErrors(*roots)


def leave_one_out(points: ArrayLike, targets: ArrayLike) -> Array:
    """Return how far each control point is from where the others alone would put it.

    Parameters
    ----------
    points, targets : array_like, shape (N, 3)
        N ≥ 4 points of a model, and where they were surveyed.

    Returns
    -------
    ndarray, shape (N, 3)
        Put there by the similarity of the others, minus surveyed.

    Raises
    ------
    TypeError, ValueError, DegenerateConfigurationError
        As `similarity_transform`, for any choice of all points but one.

    Examples
    --------
    >>> square = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]])
    >>> np.abs(leave_one_out(square, 3 * square)).max().round(9)
    np.float64(0.0)
    """
    one, other = check_correspondences(points, targets, (3, 3), ("points", "targets"), least=4)
    gaps = np.empty_like(one)
    for i in range(len(one)):
        rest = np.arange(len(one)) != i
        gaps[i] = similarity_transform(one[rest], other[rest]).apply(one[i]) - other[i]
    return gaps


def pictures_for_circle(step: float) -> int:
    """Return how many pictures all around an object are needed, so that neighbours are near.

    Parameters
    ----------
    step : float
        Largest angle between the directions of two neighbours, rad; up to 2π.

    Returns
    -------
    int
        Pictures, evenly around the circle.

    Raises
    ------
    TypeError, ValueError
        If `step` is not a number from above 0 to 2π.

    Examples
    --------
    >>> pictures_for_circle(np.deg2rad(10))
    36
    """
    step = check_length(step, "step")
    if step > 2 * np.pi * (1 + 1e-12):
        raise ValueError(f"step must be at most 2π rad, got {step:g}: is it in degrees?")
    # Rounding must not ask for one picture more.
    return math.ceil(2 * np.pi / step * (1 - 1e-12))
