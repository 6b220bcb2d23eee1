"""The gauge: what pictures alone leave open, and the ways to close it.

Turn, move and scale a whole block, cameras and points, and no pixel changes: seven numbers that
only control points, or a convention, can fix.
"""

from __future__ import annotations

import numpy as np

from course_lib.bundle.block import Indices
from course_lib.bundle.derivatives import Position
from course_lib.checks import Array
from course_lib.similarity import similarity_transform


def free_numbers(position: Position, fixed: bool) -> Indices:
    """Return which of the 6v numbers of the cameras are free: all, or all but seven.

    Parameters
    ----------
    position : Position
        Where the cameras are.
    fixed : bool
        Hold the first camera, and that coordinate of the centre furthest from it that differs most.

    Returns
    -------
    ndarray of int
        Numbers among ``(turn, centre)`` of the first camera, of the second, …
    """
    free = np.ones((len(position.C), 6), dtype=bool)
    if fixed:
        away = np.abs(position.C - position.C[0])
        furthest = int(np.argmax((away**2).sum(axis=1)))
        free[0] = False
        free[furthest, 3 + int(np.argmax(away[furthest]))] = False
    return np.flatnonzero(free)


def laid_over(position: Position, points: Array) -> Position:
    """Return a block, turned, moved and scaled so that its points are nearest to others, (n, 3)."""
    change = similarity_transform(position.X, points)
    return Position(
        position.K, position.R @ change.R.T, change.apply(position.C), change.apply(position.X)
    )


def gauge_directions(position: Position) -> tuple[Array, Array]:
    """Return how cameras and points move when the whole block does, and no pixel changes.

    Parameters
    ----------
    position : Position
        The block.

    Returns
    -------
    cameras, points : ndarray, shape (6v, 7) and (n, 3, 7)
        Columns: three moves, three turns about the middle of the points, and a scale about it.
    """
    middle = position.X.mean(axis=0)
    size = float(np.sqrt(((position.X - middle) ** 2).sum(axis=1).mean()))
    X, C = (position.X - middle) / size, (position.C - middle) / size
    cameras, points = np.zeros((len(C), 6, 7)), np.zeros((len(X), 3, 7))
    for places, block in ((C, cameras[:, 3:]), (X, points)):
        block[:, :, :3] = np.eye(3)
        for axis in range(3):
            block[:, :, 3 + axis] = np.cross(np.eye(3)[axis], places)
        block[:, :, 6] = places
    # A world that turns by w makes R exp(-[w]ₓ) = exp(-[R w]ₓ) R of the rotation R.
    cameras[:, :3, 3:6] = -position.R / size
    return cameras.reshape(-1, 7), points
