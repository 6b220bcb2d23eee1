"""Three steel rails on a table, photographed from straight above through a wide-angle lens.

Two of them are straight, one is bowed. The lens bows all three in the picture, so that the bowed
one is the one that looks straight.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from course_lib.checks import Array
from course_lib.distortion import undistort_pixels

SIZE = (640, 480)
#: Intrinsics in px of the left camera of OpenCV's stereo set, as published but for the decimals.
K = np.array([[536.0, 0, 342], [0, 536, 236], [0, 0, 1]])
K.flags.writeable = False
#: Its lens, k1 k2 p1 p2 k3, as the straight lines in its pictures tell.
LENS = (-0.31, 0.12, 0.0, 0.0, 0.0)
#: From the lens to the table, and the size of a rail, mm.
DISTANCE, LENGTH, WIDTH = 1000.0, 900.0, 16.0
TABLE, STEEL, NOISE = 58.0, 178.0, 1.5


class Rail(NamedTuple):
    """A rail across the picture.

    Attributes
    ----------
    name : str
        What is written on it.
    y : float
        Place of its ends on the table, mm below the optical axis.
    bow : float
        By how much its middle lies farther up than its ends, mm.
    """

    name: str
    y: float
    bow: float


RAILS = (Rail("A", -365.0, 0.0), Rail("B", 150.0, 9.0), Rail("C", 375.0, 0.0))


@cache
def photograph() -> NDArray[np.uint8]:
    """Return the photograph of the rails, with a little noise; always the same.

    Returns
    -------
    ndarray, shape (480, 640), uint8
        Grey values.
    """
    u, v = np.meshgrid(np.arange(SIZE[0], dtype=float), np.arange(SIZE[1], dtype=float))
    seen = undistort_pixels(np.stack([u.ravel(), v.ravel()], axis=1), K, LENS)
    x, y = ((seen - K[:2, 2]) / K[0, 0] * DISTANCE).T.reshape(2, SIZE[1], SIZE[0])
    light = _light(x, y) + np.random.default_rng(5).normal(0, NOISE, x.shape)
    picture = np.asarray(np.rint(np.clip(light, 0, 255)), np.uint8)
    picture.flags.writeable = False
    return picture


def _light(x: Array, y: Array) -> Array:
    """Return grey values from where each pixel looks on the table: dark, with shining rails."""
    light = np.full(x.shape, TABLE)
    wide, high = np.gradient(x, axis=1), np.gradient(y, axis=0)  # mm: what a pixel covers
    for rail in RAILS:
        across = y - middle_line(rail, x)
        # How much of a pixel an edge leaves covered, as long as the edge is nearly upright to it.
        covered = np.clip((WIDTH / 2 - np.abs(across)) / high + 0.5, 0, 1)
        covered *= np.clip((LENGTH / 2 - np.abs(x)) / wide + 0.5, 0, 1)
        shine = np.sqrt(np.clip(1 - (2 * across / WIDTH) ** 2, 0, 1))
        light += covered * (STEEL - TABLE + 50 * shine)
    return light


def middle_line(rail: Rail, x: Array) -> Array:
    """Return the place of a rail's middle line on the table, mm, for places along it."""
    return np.asarray(rail.y - rail.bow * (1 - (2 * x / LENGTH) ** 2))


def rail_points(picture: NDArray[np.uint8]) -> list[Array]:
    """Return points on the middle lines of the rails, as a measuring program finds them.

    In every fifth column it takes the centre of the light of each rail.

    Parameters
    ----------
    picture : ndarray, shape (480, 640), uint8
        The photograph.

    Returns
    -------
    list of ndarray, each of shape (N, 2)
        Pixels ``(u, v)`` of rails A, B and C, from left to right.
    """
    from scipy.ndimage import label

    light = np.clip(picture.astype(float) - TABLE - 5 * NOISE, 0, None)
    regions, _ = label(light > (STEEL - TABLE) / 2)
    sizes = np.bincount(regions.ravel())[1:]
    largest = 1 + np.argsort(sizes)[-len(RAILS) :]
    found = [_centres(light, regions == region) for region in largest]
    return sorted(found, key=lambda points: float(points[:, 1].mean()))


def _centres(light: Array, mask: NDArray[np.bool_]) -> Array:
    """Return the centre of light of a region in every fifth column, its ends left out."""
    columns = np.flatnonzero(mask.any(axis=0))[4:-4:5]
    points = []
    for u in columns:
        rows = np.flatnonzero(mask[:, u])
        v = np.arange(rows[0] - 2, rows[-1] + 3)
        points.append((u, v @ light[v, u] / light[v, u].sum()))
    return np.array(points, dtype=float)
