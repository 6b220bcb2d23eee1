"""Boards as things that can be rendered: flat, or bent about an upright axis."""

from __future__ import annotations

import numpy as np

from course_lib.boards import Board, Charuco, Checkerboard, DotGrid
from course_lib.checks import Array
from data_generators.scene import Colour, Patch, Scene
from data_generators.targets import WHITE, Grey, charuco, checkerboard, dot_grid, square_grid

#: Pixels of the texture for a square or pitch.
FINE = 64
STRIPS = 24  # flat pieces of a bent board


def board_texture(board: Board) -> tuple[Grey, Array, float]:
    """Return a board as a texture.

    Parameters
    ----------
    board : Checkerboard, DotGrid, Charuco or SquareGrid
        The board.

    Returns
    -------
    texture : ndarray, uint8
        With its white border.
    origin : ndarray, shape (2,)
        Where the texture's upper left corner is in the board's frame.
    pixel : float
        Size of a pixel of the texture, in the board's unit.
    """
    if isinstance(board, Checkerboard):
        texture = checkerboard(board.columns + 1, board.rows + 1, FINE, 1.0)
        return texture, np.full(2, -2.0 * board.square), board.square / FINE
    if isinstance(board, Charuco):
        return charuco(board, FINE, 1.0), np.full(2, -2.0 * board.square), board.square / FINE
    half = (board.pitch if isinstance(board, DotGrid) else board.pitch - board.square) / 2
    if isinstance(board, DotGrid):
        texture = dot_grid(board.columns, board.rows, FINE, board.diameter / board.pitch)
    else:
        texture = square_grid(board.columns, board.rows, FINE, board.square / board.pitch)
    texture = np.pad(texture, FINE // 2, constant_values=WHITE)
    return texture, np.full(2, -half - board.pitch / 2), board.pitch / FINE


def board_scene(board: Board, background: Colour, bend: float = 0.0) -> Scene:
    """Return a board before a plain background.

    Parameters
    ----------
    board : Checkerboard, DotGrid, Charuco or SquareGrid
        The board; the world is its frame.
    background : tuple of int
        RGB, 0 to 255.
    bend : float
        How far its middle stands out towards the viewer, in the board's unit.

    Returns
    -------
    Scene
        The scene.
    """
    texture, origin, pixel = board_texture(board)
    height, width = texture.shape
    cuts = np.linspace(0, width, STRIPS + 1).round().astype(int) if bend else np.array([0, width])
    edges = np.zeros((len(cuts), 3))
    edges[:, 0], edges[:, 1] = origin[0] + cuts * pixel, origin[1]
    edges = _bent(board, edges, bend)
    down = np.array([0, height * pixel, 0])
    patches = [
        Patch(start, end - start, down, texture[:, left:right])
        for start, end, left, right in zip(edges[:-1], edges[1:], cuts[:-1], cuts[1:], strict=True)
    ]
    return Scene(tuple(patches), background)


def on_board(board: Board, bend: float = 0.0) -> Array:
    """Return where the board's points are, shape (N, 3), on a flat board or a bent one."""
    return _bent(board, board.points(), bend)


def _bent(board: Board, points: Array, bend: float) -> Array:
    """Return points of a flat board, moved towards the viewer along a parabola over x."""
    x = board.points()[:, 0]
    middle, half = (x.min() + x.max()) / 2, (x.max() - x.min()) / 2
    out = bend * (1 - ((points[:, 0] - middle) / half) ** 2)
    return np.column_stack([points[:, :2], points[:, 2] - out])
