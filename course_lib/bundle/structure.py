"""The order in which a block's observations are worked through; it stays while numbers change."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from course_lib.bundle.block import Indices, Observations
from course_lib.checks import Array


@dataclass(frozen=True, eq=False)
class Structure:
    """Observations camera after camera, and the pairs of them that see the same point.

    Attributes
    ----------
    seen : Observations
        In the order of cameras, and of points within each.
    order : ndarray of int, shape (m,)
        Their numbers among those that were given.
    cameras, points : int
        How many there are.
    bounds : ndarray of int, shape (v + 1,)
        Where each camera's observations begin.
    left, right : ndarray of int, shape (p,)
        Two observations of one point, that of the camera with the smaller number first; sorted by
        their cameras.
    pairs : list of tuple of int
        For each two cameras with common points: ``(i, j, first, last)``, their part of `left`.
    """

    seen: Observations
    order: Indices
    cameras: int
    points: int
    bounds: Indices
    left: Indices
    right: Indices
    pairs: list[tuple[int, int, int, int]]

    @classmethod
    def of(cls, observations: Observations, cameras: int, points: int) -> Structure:
        """Return the structure of what was seen by so many cameras of so many points."""
        order = np.lexsort((observations.points, observations.cameras))
        seen = observations.only(order)
        bounds = np.searchsorted(seen.cameras, np.arange(cameras + 1))
        left, right = _pairs(seen)
        key = seen.cameras[left] * cameras + seen.cameras[right]
        by_cameras = np.argsort(key, kind="stable")
        left, right, key = left[by_cameras], right[by_cameras], key[by_cameras]
        names, first = np.unique(key, return_index=True)
        last = np.append(first, len(key))[1:]
        i, j = np.divmod(names, cameras)
        pairs = list(zip(i.tolist(), j.tolist(), first.tolist(), last.tolist(), strict=True))
        return cls(seen, order, cameras, points, bounds, left, right, pairs)

    def by_point(self, rows: Array) -> Array:
        """Return rows, shape (k, m), summed over the observations of each point: (k, n)."""
        sums = [np.bincount(self.seen.points, row, self.points) for row in rows]
        return np.array(sums, dtype=np.float64)


def _pairs(seen: Observations) -> tuple[Indices, Indices]:
    """Return all pairs of observations of the same point, the earlier first."""
    by_point = np.argsort(seen.points, kind="stable")
    points = seen.points[by_point]
    left, right = [np.zeros(0, np.intp)], [np.zeros(0, np.intp)]
    for apart in range(1, len(points)):
        same = np.flatnonzero(points[apart:] == points[:-apart])
        if not len(same):
            break
        left.append(by_point[same])
        right.append(by_point[same + apart])
    return np.concatenate(left), np.concatenate(right)
