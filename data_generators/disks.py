"""Disks to blur a picture with, in less than a millisecond: large disks on reduced pictures."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

SHARP = 0.3  # px: smaller disks change nothing that a pixel shows
WIDEST = (5.0, 22.0, 60.0, 130.0)  # px: the largest disk drawn at 1/1, 1/2, 1/4, 1/8 of the size
SMALL = 2.6  # px: smaller disks are three pixels wide
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
        return disk(round(20 * diameter) / 20)
    # Variance D² / 16 of a disk, less r² / 4: (r² - 1) / 12 of the mean of r × r pixels, and
    # r² / 6 + 1 / 12 of the interpolation back.
    within = np.sqrt((diameter / r) ** 2 - 4)
    return disk(round(20 * float(within)) / 20)


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
    half = int(np.ceil(diameter / 2 - 0.6))
    squares = np.arange(-half, half + 1.0) ** 2
    radius = np.sqrt(squares[:, None] + squares)
    edge = diameter / 2
    for _ in range(12):  # Whole pixels change the variance of the disk: make up for it.
        inside = np.clip(edge + 0.5 - radius, 0, 1)
        inside /= inside.sum()
        edge = math.sqrt(edge**2 + 2 * (diameter**2 / 16 - float(inside.sum(axis=0) @ squares)))
    return inside.astype(np.float32)
