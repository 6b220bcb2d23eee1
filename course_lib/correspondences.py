"""Checks of points that belong together in pairs, and of how they spread.

Every function here returns its arguments as `float64` arrays, or says what is wrong.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, DegenerateConfigurationError, check_numbers, check_points

#: What points are that spread in too few directions: in none, in one, in two.
TOO_NARROW = (
    "the same point: take points that differ",
    "collinear: take some beside that line",
    "coplanar: take some beside that plane",
)


def check_number_pairs(
    one: ArrayLike, other: ArrayLike, names: tuple[str, str], least: int = 1
) -> tuple[Array, Array]:
    """Return two rows of as many finite numbers, shape (N,), and at least so many."""
    first, second = check_numbers(one, names[0]), check_numbers(other, names[1])
    if first.ndim != 1 or second.ndim != 1:
        raise ValueError(
            f"{names[0]} and {names[1]} must be rows of numbers, got shapes {first.shape} and "
            f"{second.shape}"
        )
    if len(first) != len(second):
        raise ValueError(
            f"{names[0]} and {names[1]} belong together in pairs, got {len(first)} and "
            f"{len(second)}"
        )
    if len(first) < least:
        raise ValueError(f"{names[0]} must be {least} numbers or more, got {len(first)}")
    return first, second


def check_correspondences(
    points: ArrayLike,
    targets: ArrayLike,
    dimensions: tuple[int, int],
    names: tuple[str, str],
    least: int,
) -> tuple[Array, Array]:
    """Return points and what belongs to each of them: as many rows, and at least so many."""
    one = check_points(points, dimensions[0], names[0])
    other = check_points(targets, dimensions[1], names[1])
    if one.ndim != 2 or other.ndim != 2 or len(one) != len(other):
        raise ValueError(
            f"{names[0]} and {names[1]} belong together row by row, got shapes {one.shape} and "
            f"{other.shape}"
        )
    if len(one) < least:
        what = names[0].rstrip("0123456789")  # points1 and points2 are points
        raise ValueError(f"{least} {what} or more are needed, got {len(one)}")
    return one, other


def check_plane_pairs(points: ArrayLike, targets: ArrayLike) -> tuple[Array, Array]:
    """Return points and targets of a homography: four pairs or more, neither all on one line."""
    pair = check_correspondences(points, targets, (2, 2), ("points", "targets"), least=4)
    for array, name in zip(pair, ("points", "targets"), strict=True):
        check_spread(array, 2, name)
    return pair


def check_space_pairs(points: ArrayLike, pixels: ArrayLike) -> tuple[Array, Array]:
    """Return points of space, six or more, not all in a plane, and pixels, not all on a line."""
    pair = check_correspondences(points, pixels, (3, 2), ("points", "pixels"), least=6)
    check_spread(pair[0], 3, "points")
    check_spread(pair[1], 2, "pixels")
    return pair


def check_spread(points: Array, directions: int, name: str) -> None:
    """Raise unless points, shape (N, d), spread in so many directions (to seven digits)."""
    centre = points.mean(axis=0)
    check_scatter((points - centre).T @ (points - centre) / len(points), centre, directions, name)


def check_scatter(scatter: Array, centre: Array, directions: int, name: str) -> None:
    """Raise unless points spread in so many directions, judged by their mean squares.

    Parameters
    ----------
    scatter : ndarray, shape (..., d, d)
        Mean of the products of coordinates, counted from the centre.
    centre : ndarray, shape (..., d)
        Mean of the points.
    directions : int
        In how many directions they must spread.
    name : str
        What the caller calls the points.

    Raises
    ------
    DegenerateConfigurationError
        If the spread in a direction is less than 1e-7 of the largest, or rounding of the points.
    """
    squares = np.linalg.eigvalsh(scatter)[..., ::-1]
    rounding = 1e-30 * (centre * centre).sum(axis=-1, keepdims=True)
    wide = squares > np.maximum(1e-14 * squares[..., :1], rounding)
    found = int(wide.sum(axis=-1).min())
    if found < directions:
        raise DegenerateConfigurationError(f"all {name} are {TOO_NARROW[found]}")
