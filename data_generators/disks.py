"""Disks to blur a picture with, in less than a millisecond: large disks on reduced pictures."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from course_lib.checks import Array

SHARP = 0.3  # px: smaller disks change nothing that a pixel shows
WIDEST = (5.0, 16.0, 56.0, 120.0)  # px: the largest disk drawn at 1/1, 1/2, 1/4, 1/8 of the size
SMALL = 1.6  # px: smaller disks are only a little more than a pixel
GRID = 2 ** len(WIDEST)  # px: pictures must be multiples of this


def reduction(diameter: float) -> int:
    """Return how many times a picture is halved before it is blurred by a disk of this size."""
    return sum(diameter > widest for widest in WIDEST)


def kernel(diameter: float) -> NDArray[np.float32] | None:
    """Return what to filter a picture with, once it is reduced, or None where it stays sharp.

    Together with the reduction and the bilinear way back, the second moment of the blur is that
    of the disk.

    Parameters
    ----------
    diameter : float
        Of the disk, in pixels of the full picture.

    Returns
    -------
    ndarray, shape (n, n), n odd, or None
        The kernel, in sum 1.
    """
    if diameter < SHARP:
        return None
    r = 2 ** reduction(diameter)
    if r == 1:
        return disk(round(diameter, 2))
    # Variance D² / 16 of a disk, less that of the r × r mean and of the interpolation back.
    left = diameter**2 - 16 * ((r**2 - 1) / 12 + r**2 / 6)
    return disk(round(float(np.sqrt(left)) / r, 2))


@lru_cache(512)
def disk(diameter: float) -> NDArray[np.float32]:
    """Return the share of each pixel around the middle that a disk covers, in sum 1.

    Parameters
    ----------
    diameter : float
        px.

    Returns
    -------
    ndarray, shape (n, n), n odd
        The kernel. Its second moment is that of the disk.
    """
    if diameter < SMALL:
        side = diameter**2 / 32
        row = np.array([side, 1 - 2 * side, side])
        return np.outer(row, row).astype(np.float32)
    # Covering whole pixels widens the disk by a pixel's variance, 1 / 12.
    narrow = np.sqrt(diameter**2 - 16 / 12)
    half = int(np.ceil(narrow / 2 - 0.5))
    inside = _coverage(narrow, half)
    return np.asarray(inside / inside.sum(), np.float32)


def _coverage(diameter: float, half: int, n: int = 16) -> Array:
    """Return the share of each pixel of a square that a disk covers, by n × n points."""
    points = (np.arange((2 * half + 1) * n) + 0.5) / n - half - 0.5
    inside = np.hypot(points[:, None], points[None, :]) <= diameter / 2
    side = 2 * half + 1
    return np.asarray(inside.reshape(side, n, side, n).mean(axis=(1, 3)))
