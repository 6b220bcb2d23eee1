"""Which patch hides which: the order of painting, from back to front."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from course_lib.checks import Array

Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]

TOUCHING = 1e-4  # m: a corner this near to a plane lies on either side of it


def side_table(
    corners: Array, starts: Indices, origins: Array, normals: Array
) -> tuple[Flags, Flags]:
    """Return on which side of each patch's plane every other patch lies.

    Parameters
    ----------
    corners : ndarray, shape (V, 3)
        Corners of all patches, one patch after the other, m.
    starts : ndarray, shape (N,)
        Index of each patch's first corner.
    origins, normals : ndarray, shape (N, 3)
        A point and the unit normal of each plane.

    Returns
    -------
    in_front, behind : ndarray, shape (N, N), bool
        ``in_front[i, j]``: patch j lies wholly on the normal's side of plane i.
    """
    distance = normals @ corners.T - np.sum(normals * origins, axis=1)[:, None]
    lowest = np.minimum.reduceat(distance, starts, axis=1)
    highest = np.maximum.reduceat(distance, starts, axis=1)
    return lowest >= -TOUCHING, highest <= TOUCHING


def back_to_front(near_side: Flags, far_side: Flags, boxes: Array, distance: Array) -> list[int]:
    """Return an order in which no patch is painted over one that hides it.

    Parameters
    ----------
    near_side, far_side : ndarray, shape (N, N), bool
        ``near_side[i, j]``: patch j lies wholly on the eye's side of plane i, or beyond it.
    boxes : ndarray, shape (N, 4)
        Left, top, right, bottom of each patch in the picture, px.
    distance : ndarray, shape (N,)
        Of each patch from the eye; decides where the planes do not.

    Returns
    -------
    list of int
        The patches' indices, first the one to paint first.

    References
    ----------
    M. Newell, R. Newell, T. Sancha, "A solution to the hidden surface problem", Proc. ACM
    Annual Conference (1972) 443-450.
    """
    left, top, right, bottom = boxes.T
    overlap = (left[:, None] <= right) & (top[:, None] <= bottom)
    overlap &= overlap.T
    # i may come before j when j is nearer than plane i, or i is beyond plane j.
    may_precede = near_side | far_side.T
    must_precede = may_precede & ~may_precede.T & overlap
    waiting_for = must_precede.sum(axis=0)
    order: list[int] = []
    while len(order) < len(distance):
        # All that wait for nothing; in a cycle, the one that waits for the fewest.
        ready = np.flatnonzero(waiting_for == max(0, waiting_for.min()))
        if waiting_for[ready[0]] > 0:
            ready = ready[[np.argmax(distance[ready])]]
        order += ready[np.argsort(-distance[ready], kind="stable")].tolist()
        waiting_for = waiting_for - must_precede[ready].sum(axis=0)
        waiting_for[ready] = len(distance) ** 2
    return order
