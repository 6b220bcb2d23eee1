"""Small things on a table under a slanted pattern of light, as a camera straight above sees them.

Light and camera are far away, so all rays of light are parallel, and so are all lines of sight.
The light comes from the left, `angle` from the vertical: on something of height h it lands
``h tan(angle)`` farther left than on the table.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import Array, check_length, check_numbers

Picture = NDArray[np.uint8]

#: Light of the room, by that of a stripe.
ROOM = 0.18


def step(x: Array, y: Array, height: float) -> Array:
    """Return the height of a block with upright sides, mm."""
    return np.where((np.abs(x) < 8) & (np.abs(y) < 7), height, 0.0)


def wedge(x: Array, y: Array, height: float) -> Array:
    """Return the height of a ramp that rises to the right, mm."""
    return np.where((np.abs(x) < 11) & (np.abs(y) < 7), height * (x + 11) / 22, 0.0)


def dome(x: Array, y: Array, height: float) -> Array:
    """Return the height of the cap of a sphere with a radius of 10 mm at its foot, mm."""
    if height <= 0:
        return np.zeros(np.broadcast(x, y).shape)
    radius = (10.0**2 + height**2) / (2 * height)
    squared = radius**2 - x**2 - y**2
    cap = np.sqrt(np.maximum(squared, 0)) - (radius - height)
    return np.where(x**2 + y**2 < 100.0, np.maximum(cap, 0), 0.0)


def scratch(x: Array, y: Array, height: float) -> Array:
    """Return the height of a plate of that height with a groove half as deep along y, mm."""
    plate = np.where((np.abs(x) < 13) & (np.abs(y) < 9), height, 0.0)
    return np.where((np.abs(x) < 3) & (np.abs(y) < 9), height / 2, plate)


SHAPES: dict[str, Callable[[Array, Array, float], Array]] = {
    "block": step,
    "ramp": wedge,
    "dome": dome,
    "plate with a groove": scratch,
}


def height_map(shape: str, height: float, size: tuple[int, int], pixel: float) -> Array:
    """Return the heights of a shape in the middle of a table.

    Parameters
    ----------
    shape : str
        A key of `SHAPES`.
    height : float
        Of its highest point, mm; 0 is the empty table.
    size : tuple of int
        Width and height of the picture, px.
    pixel : float
        Side of a pixel on the table, mm.

    Returns
    -------
    ndarray, shape (height, width)
        mm above the table.

    Raises
    ------
    ValueError
        If there is no such shape, or a length is negative.
    """
    if shape not in SHAPES:
        raise ValueError(f"no shape {shape!r}; there are {', '.join(SHAPES)}")
    if height < 0:
        raise ValueError(f"height must not be negative, got {height:g} mm")
    check_length(pixel, "pixel")
    width, rows = size
    x: Array = (np.arange(width, dtype=np.float64) - (width - 1) / 2) * pixel
    y: Array = (np.arange(rows, dtype=np.float64) - (rows - 1) / 2) * pixel
    return SHAPES[shape](x[None, :], y[:, None], height)


def on_the_table(heights: ArrayLike, angle: float, pixel: float) -> tuple[Array, NDArray[np.bool_]]:
    """Return where the light of each pixel would land on the empty table.

    Parameters
    ----------
    heights : array_like, shape (rows, columns)
        mm.
    angle : float
        Between the light and the vertical, rad.
    pixel : float
        Side of a pixel, mm.

    Returns
    -------
    place : ndarray, shape (rows, columns)
        x on the table, mm from the middle column: x of the pixel plus ``h tan(angle)``.
    lit : ndarray of bool, the same shape
        False in the shadow: something to the left meets that ray first.
    """
    h = check_numbers(heights, "heights")
    x = (np.arange(h.shape[1]) - (h.shape[1] - 1) / 2) * pixel
    place = x + h * np.tan(angle)
    before = np.maximum.accumulate(place, axis=1)
    lit = np.ones(h.shape, bool)
    lit[:, 1:] = place[:, 1:] > before[:, :-1]
    return place, lit


def striped(
    heights: Array, angle: float, pixel: float, period: float, width: float, offset: float = 0.0
) -> Array:
    """Return the light on things under a pattern of stripes along y.

    Parameters
    ----------
    heights : ndarray, shape (rows, columns)
        mm.
    angle : float
        Between the light and the vertical, rad.
    pixel, period, width : float
        Side of a pixel; distance from stripe to stripe and width of one, on the table, mm.
    offset : float
        Middle of one stripe on the table, mm.

    Returns
    -------
    ndarray, shape (rows, columns), float32
        1 in a stripe, `ROOM` beside it; edges fall off over one pixel.
    """
    place, lit = on_the_table(heights, angle, pixel)
    apart = np.abs(np.mod(place - offset + period / 2, period) - period / 2).astype(np.float32)
    inside = np.clip(np.float32(0.5) + (np.float32(width / 2) - apart) / np.float32(pixel), 0, 1)
    return np.asarray(ROOM + (1 - ROOM) * inside * lit, np.float32)
