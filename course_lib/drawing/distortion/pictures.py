"""Pictures bent quickly: a map that is computed on a coarse mesh and filled in between."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera import camera_at
from course_lib.distortion import (
    distort,
    distort_pixels,
    normalised_from_pixels,
    undistort_pixels,
    valid_radius,
)
from course_lib.drawing.diagrams import Floats
from course_lib.drawing.explorers.street import renderer

Picture = NDArray[np.uint8]
#: Distance of the mesh's nodes, px. The lens is smooth: between them the map is a plane.
MESH = 4
#: Column and row of what is in no picture.
NOWHERE = -1e6
#: Size of a picture of the house, and its intrinsics, px: a wide angle.
SIZE = (320, 240)
K = np.array([[240.0, 0, 159.5], [0, 240, 119.5], [0, 0, 1]])
K.flags.writeable = False
#: The pinhole's view is this much larger, so that a barrel finds what it draws in.
MORE = 2
#: Where the camera stands, and the house that it looks at, m in the street.
EYE, HOUSE = (-2.5, 24.5, 4.0), (6.0, 24.5, 4.0)


def mesh_map(where: Callable[[Floats], Floats], size: tuple[int, int]) -> NDArray[np.float32]:
    """Return a smooth map of pixels, computed only at the nodes of a mesh.

    Parameters
    ----------
    where : callable
        From pixels (N, 2) to the pixels in which they look up their colours; NaN for nowhere.
    size : tuple of int
        Width and height of the new picture, px; multiples of 4.

    Returns
    -------
    ndarray, shape (height, width, 2)
        Columns and rows in the old picture.
    """
    import cv2

    width, height = size
    # A cell more on each side, as interpolation needs neighbours.
    u = (np.arange(-1, width // MESH + 1) + 0.5) * MESH - 0.5
    v = (np.arange(-1, height // MESH + 1) + 0.5) * MESH - 0.5
    nodes = np.stack(np.meshgrid(u, v), axis=-1)
    there = where(nodes.reshape(-1, 2)).reshape(nodes.shape)
    there = np.where(np.isfinite(there), there, NOWHERE).astype(np.float32)
    full = cv2.resize(there, (len(u) * MESH, len(v) * MESH), interpolation=cv2.INTER_LINEAR)
    return np.asarray(full[MESH:-MESH, MESH:-MESH], np.float32)


def looked_up(picture: NDArray[Any], places: NDArray[np.float32]) -> Picture:
    """Return a picture that looks its colours up in another; black where there is nothing."""
    import cv2

    return np.asarray(cv2.remap(picture, places, None, cv2.INTER_LINEAR), np.uint8)


@cache
def wide_house() -> tuple[Picture, Floats]:
    """Return a pinhole's view of a house that shows more than `SIZE`, and its intrinsics."""
    width, height = (MORE * side for side in SIZE)
    wide = K.copy()
    wide[:2, 2] = (width - 1) / 2, (height - 1) / 2
    return renderer().picture(camera_at(EYE, HOUSE, wide, (width, height))), wide


def house_through(coefficients: ArrayLike) -> Picture:
    """Return a house as a lens with distortion shows it.

    Parameters
    ----------
    coefficients : array_like
        As in `course_lib.distortion.distort`.

    Returns
    -------
    ndarray, shape (240, 320, 3), uint8
        RGB, with the intrinsics `K`; black beyond what the lens images.
    """
    source, wide = wide_house()

    def where(pixels: Floats) -> Floats:
        there, seen = np.full_like(pixels, np.nan), _within_reach(pixels, coefficients)
        there[seen] = undistort_pixels(pixels[seen], K, coefficients, wide)
        return there

    return looked_up(source, mesh_map(where, SIZE))


def _within_reach(pixels: Floats, coefficients: ArrayLike) -> NDArray[np.bool_]:
    """Return which pixels lie inside the image of the circle up to which the lens is valid.

    Pixels beyond it are the image of nothing, and finding that out one by one takes long.
    """
    limit = 0.999 * min(valid_radius(coefficients), 3.0)
    turn = np.linspace(-np.pi, np.pi, 73)
    edge = distort(limit * np.stack([np.cos(turn), np.sin(turn)], axis=1), coefficients)
    angle, reach = np.arctan2(edge[:, 1], edge[:, 0]), np.hypot(*edge.T)
    x, y = normalised_from_pixels(pixels, K).T
    farthest = np.interp(np.arctan2(y, x), angle, reach, period=2 * np.pi)
    return np.asarray(np.hypot(x, y) <= farthest)


def straight_map(
    K: ArrayLike, coefficients: ArrayLike, size: tuple[int, int]
) -> NDArray[np.float32]:
    """Return where an undistorted picture looks up its colours in the distorted one.

    Parameters
    ----------
    K, coefficients : array_like
        Intrinsics in px, and the lens as in `course_lib.distortion.distort`.
    size : tuple of int
        Width and height of both, px; multiples of 4.

    Returns
    -------
    ndarray, shape (height, width, 2)
        Columns and rows; far outside beyond the lens's valid radius.
    """
    intrinsics, limit = np.asarray(K, dtype=float), valid_radius(coefficients)

    def where(pixels: Floats) -> Floats:
        away = np.hypot(*normalised_from_pixels(pixels, intrinsics).T)
        there = distort_pixels(pixels, intrinsics, coefficients)
        return np.where((away < limit)[:, None], there, np.nan)

    return mesh_map(where, size)
