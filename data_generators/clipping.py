"""Polygons in front of a camera: cut to what is in view, and into slabs of depth."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from course_lib.checks import Array

NEAR = 0.05  # m: nothing nearer than this is drawn
MARGIN = 50.0  # px: what is farther outside the picture is cut off
SLAB = 2.0  # farthest by nearest distance of a slab
FORWARD = np.array([0.0, 0.0, 1.0])


def clip(corners: Array, plane: Array, offset: float = 0.0) -> Array:
    """Return the part of a convex polygon with ``corners @ plane >= offset``.

    Parameters
    ----------
    corners : ndarray, shape (M, 3)
        The polygon.
    plane : ndarray, shape (3,)
        Normal of the plane, towards the side that stays.
    offset : float
        Where the plane is along its normal.

    Returns
    -------
    ndarray, shape (L, 3)
        The clipped polygon, in the same order; empty if nothing stays.

    References
    ----------
    I. Sutherland, G. Hodgman, "Reentrant polygon clipping", Comm. ACM 17 (1974) 32-42.
    """
    distance = (corners @ plane - offset).tolist()
    if min(distance, default=0.0) >= 0:
        return corners
    kept, points = [], corners.tolist()  # plain numbers: arrays of three are slow
    for i, here in enumerate(distance):
        before = distance[i - 1]
        if (before >= 0) != (here >= 0):
            share = before / (before - here)
            pair = zip(points[i - 1], points[i], strict=True)
            kept.append([old + share * (new - old) for old, new in pair])
        if here >= 0:
            kept.append(points[i])
    return np.array(kept).reshape(-1, 3)


def view_planes(K: Array, image_size: tuple[int, int]) -> tuple[Array, Array]:
    """Return the five planes that bound what a camera sees: near, left, right, top, bottom.

    Parameters
    ----------
    K : ndarray, shape (3, 3)
        Intrinsics, px.
    image_size : tuple of int
        Width and height, px.

    Returns
    -------
    planes : ndarray, shape (5, 3)
        Normals in the camera frame, inwards.
    offsets : ndarray, shape (5,)
        A point X is inside when ``planes @ X >= offsets``.
    """
    width, height = image_size
    # u >= left means (K X)_0 - left (K X)_2 >= 0, and so on.
    planes = np.array(
        [
            FORWARD,
            K[0] + MARGIN * K[2],
            (width + MARGIN) * K[2] - K[0],
            K[1] + MARGIN * K[2],
            (height + MARGIN) * K[2] - K[1],
        ]
    )
    return planes, np.array([NEAR, 0.0, 0.0, 0.0, 0.0])


def slabs(corners: Array) -> list[Array]:
    """Cut a polygon by depth into parts whose distances differ by less than `SLAB`.

    Parameters
    ----------
    corners : ndarray, shape (M, 3)
        In the camera frame, in front of it.

    Returns
    -------
    list of ndarray, shape (L, 3)
        The parts, the farthest first.
    """
    nearest, farthest = corners[:, 2].min(), corners[:, 2].max()
    count = int(np.ceil(np.log(farthest / nearest) / np.log(SLAB)))
    depths = nearest * (farthest / nearest) ** (np.arange(1, count) / max(count, 1))
    parts, rest = [], corners
    for depth in depths[::-1]:
        parts.append(clip(rest, FORWARD, depth))
        rest = clip(rest, -FORWARD, -depth)
    return [part for part in [*parts, rest] if len(part)]


def pixels(corners: Array, K: Array) -> Array:
    """Return the image of points in front of the camera, shape (M, 2), px; no checks."""
    homogeneous = corners @ K.T
    return np.asarray(homogeneous[:, :2] / homogeneous[:, 2:])


@dataclass(frozen=True)
class Polygons:
    """Many polygons in one array, so that what is done to all is done at once.

    Attributes
    ----------
    corners : ndarray, shape (V, d)
        Corners of all polygons, one polygon after the other.
    starts, ends : ndarray, shape (N,)
        Where each polygon begins, and the next one.
    """

    corners: Array
    starts: NDArray[np.intp]
    ends: NDArray[np.intp]

    @classmethod
    def of(cls, parts: Sequence[Array], dimension: int = 3) -> Polygons:
        """Return polygons, each of shape (M, dimension), together."""
        ends = np.cumsum(np.array([len(part) for part in parts], np.intp))
        starts = ends - np.array([len(part) for part in parts], np.intp)
        return cls(np.concatenate([np.zeros((0, dimension)), *parts]), starts, ends)

    def seen_through(self, K: Array) -> Polygons:
        """Return their images, px."""
        return Polygons(pixels(self.corners, K), self.starts, self.ends)

    def low(self) -> Array:
        """Return the least of each coordinate, shape (N, d)."""
        return np.asarray(np.minimum.reduceat(self.corners, self.starts))

    def high(self) -> Array:
        """Return the greatest of each coordinate, shape (N, d)."""
        return np.asarray(np.maximum.reduceat(self.corners, self.starts))

    def middle(self) -> Array:
        """Return the mean of the corners, shape (N, d)."""
        count = (self.ends - self.starts)[:, None]
        return np.asarray(np.add.reduceat(self.corners, self.starts) / count)
