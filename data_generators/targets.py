"""Test targets as textures: boards to calibrate with, stars and bars to judge sharpness by.

All are `uint8` pictures, linear in light, with the values `DARK` and `WHITE` of printed paper.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from course_lib.boards import Charuco
from course_lib.checks import Array
from data_generators.markers import charuco_markers

Grey = NDArray[np.uint8]

DARK, WHITE = 20, 235
FINE = 4  # samples a pixel along each axis where a curve meets the pixel grid


def checkerboard(columns: int, rows: int, square: int = 32, border: float = 0.5) -> Grey:
    """Return a checkerboard with a white border.

    Parameters
    ----------
    columns, rows : int
        Squares across and down; the top-left one is dark. There is one inner corner fewer.
    square : int
        Side of a square, px.
    border : float
        Width of the border in squares.

    Returns
    -------
    ndarray, shape ((rows + 2 border) square, (columns + 2 border) square), uint8
        The board. Inner corner (i, j) is ``(border + 1 + i) square`` px from the left edge.

    Raises
    ------
    ValueError
        If a count is not positive.
    """
    _check_counts(columns=columns, rows=rows, square=square)
    dark = np.indices((rows, columns)).sum(axis=0) % 2 == 0
    board = np.kron(np.where(dark, DARK, WHITE), np.ones((square, square), int))
    return np.pad(board, round(border * square), constant_values=WHITE).astype(np.uint8)


def dot_grid(columns: int, rows: int, pitch: int = 32, diameter: float = 0.5) -> Grey:
    """Return a grid of dark dots.

    Parameters
    ----------
    columns, rows : int
        Dots across and down.
    pitch : int
        Distance of neighbouring centres, px.
    diameter : float
        Of a dot, in pitches.

    Returns
    -------
    ndarray, shape (rows pitch, columns pitch), uint8
        The grid; the first centre is half a pitch from both edges.

    Raises
    ------
    ValueError
        If a count is not positive.
    """
    _check_counts(columns=columns, rows=rows, pitch=pitch)

    def dark(x: Array, y: Array) -> NDArray[np.bool_]:
        return np.hypot(x % pitch - pitch / 2, y % pitch - pitch / 2) < diameter * pitch / 2

    return _drawn(columns * pitch, rows * pitch, dark)


def square_grid(columns: int, rows: int, pitch: int = 32, side: float = 0.5) -> Grey:
    """Return a grid of separate dark squares.

    Parameters
    ----------
    columns, rows : int
        Squares across and down.
    pitch : int
        From a square to the next, px.
    side : float
        Of a square, in pitches.

    Returns
    -------
    ndarray, shape (rows pitch, columns pitch), uint8
        The grid; the middle of the first square is half a pitch from both edges.

    Raises
    ------
    ValueError
        If a count is not positive.
    """
    _check_counts(columns=columns, rows=rows, pitch=pitch)

    def dark(x: Array, y: Array) -> NDArray[np.bool_]:
        away = np.maximum(np.abs(x % pitch - pitch / 2), np.abs(y % pitch - pitch / 2))
        return np.asarray(away < side * pitch / 2)

    return _drawn(columns * pitch, rows * pitch, dark)


def charuco(board: Charuco, square: int = 64, border: float = 0.5) -> Grey:
    """Return a checkerboard with a numbered marker in each light square.

    Parameters
    ----------
    board : Charuco
        The board.
    square : int
        Side of a square, px.
    border : float
        Width of the border in squares.

    Returns
    -------
    ndarray, shape ((rows + 1 + 2 border) square, (columns + 1 + 2 border) square), uint8
        The board.

    Raises
    ------
    ValueError
        If a count is not positive.
    """
    picture = checkerboard(board.columns + 1, board.rows + 1, square, border)
    edge, side = round(border * square), square * board.marker / board.square
    for column, row, cells in charuco_markers(board):
        left = edge + column * square + (square - side) / 2
        top = edge + row * square + (square - side) / 2
        cell = side / len(cells)
        for i, j in np.argwhere(cells):
            _fill(picture, left + j * cell, top + i * cell, cell, cell)
    return picture


def siemens_star(size: int = 512, spokes: int = 36) -> Grey:
    """Return a Siemens star: spokes whose period shrinks towards the centre.

    Parameters
    ----------
    size : int
        Width and height, px.
    spokes : int
        Dark spokes around.

    Returns
    -------
    ndarray, shape (size, size), uint8
        The star, on white.

    Raises
    ------
    ValueError
        If a count is not positive.
    """
    _check_counts(size=size, spokes=spokes)

    def dark(x: Array, y: Array) -> NDArray[np.bool_]:
        x, y = x - size / 2, y - size / 2
        return np.asarray((np.sin(spokes * np.arctan2(y, x)) > 0) & (np.hypot(x, y) < 0.46 * size))

    return _drawn(size, size, dark)


def bar_target(size: int = 512, groups: int = 6, ratio: float = 2**0.5) -> Grey:
    """Return groups of three upright and three lying bars, each group finer than the last.

    Parameters
    ----------
    size : int
        Width and height, px.
    groups : int
        How many.
    ratio : float
        Bar width of a group by that of the next.

    Returns
    -------
    ndarray, shape (size, size), uint8
        The target, on white.

    Raises
    ------
    ValueError
        If a count is not positive or the bars do not get finer.

    References
    ----------
    MIL-STD-150A, Photographic Lenses (1959): bars five times as long as wide.
    """
    _check_counts(size=size, groups=groups)
    if ratio <= 1:
        raise ValueError(f"ratio must be more than 1, so that the groups get finer, got {ratio}")
    widths = ratio ** -np.arange(groups)
    widths *= 0.94 * size / (7 * widths.sum())
    target = np.full((size, size), WHITE, np.uint8)
    top = 0.03 * size
    for width in widths:
        for k in (0, 2, 4):
            _fill(target, 0.1 * size + k * width, top, width, 5 * width)
            _fill(target, 0.1 * size + 7 * width, top + k * width, 5 * width, width)
        top += 7 * width
    return target


def letter_chart(size: int = 512, lines: int = 7, *, rng: np.random.Generator) -> Grey:
    """Return an eye test: lines of the letter E, turned at random, smaller line by line.

    Parameters
    ----------
    size : int
        Width and height, px.
    lines : int
        How many.
    rng : numpy.random.Generator
        Turns the letters.

    Returns
    -------
    ndarray, shape (size, size), uint8
        The chart, on white.

    Raises
    ------
    ValueError
        If a count is not positive.

    References
    ----------
    ISO 8596, Ophthalmic optics - Visual acuity testing: each stroke a fifth of the letter.
    """
    _check_counts(size=size, lines=lines)
    chart = np.full((size, size), WHITE, np.uint8)
    letter = np.array([[1, 1, 1, 1, 1], [1, 0, 0, 0, 0], [1, 1, 1, 1, 1], [1, 0, 0, 0, 0]])
    letter = np.vstack([letter, letter[:1]])
    heights = 0.75 ** np.arange(lines)
    heights *= 0.94 * size / (1.5 * heights.sum())
    top = 0.04 * size
    for line, height in enumerate(heights):
        count = min(line + 1, int(0.94 * size / (1.6 * height)))
        for left in size / 2 + 1.6 * height * (np.arange(count) - (count - 1) / 2) - height / 2:
            turned = np.rot90(letter, int(rng.integers(4)))
            for row, column in np.argwhere(turned):
                stroke = height / 5
                _fill(chart, left + column * stroke, top + row * stroke, stroke, stroke)
        top += 1.5 * height
    return chart


def _check_counts(**counts: int) -> None:
    for name, count in counts.items():
        if count < 1:
            raise ValueError(f"{name} must be a whole number of at least 1, got {count}")


def _drawn(width: int, height: int, dark: Callable[[Array, Array], NDArray[np.bool_]]) -> Grey:
    """Return a picture of a region, each pixel the mean over its area; the corner is (0, 0)."""
    x = (np.arange(width * FINE) + 0.5) / FINE
    y = (np.arange(height * FINE) + 0.5) / FINE
    inside = dark(*np.meshgrid(x, y)).reshape(height, FINE, width, FINE).mean(axis=(1, 3))
    return np.asarray(np.rint(WHITE + (DARK - WHITE) * inside), np.uint8)


def _fill(picture: Grey, left: float, top: float, width: float, height: float) -> None:
    """Darken a rectangle inside the picture, its edges by the share of the pixel they cover."""

    def cover(start: float, length: float) -> tuple[slice, Array]:
        pixels = np.arange(int(start), int(np.ceil(start + length)))
        ends = np.minimum(pixels + 1, start + length)
        return slice(pixels[0], pixels[-1] + 1), ends - np.maximum(pixels, start)

    (rows, down), (columns, across) = cover(top, height), cover(left, width)
    dark = picture[rows, columns] + (DARK - WHITE) * np.outer(down, across)
    picture[rows, columns] = np.rint(np.maximum(dark, DARK)).astype(np.uint8)
