"""Boards in pictures: where their points are, and in a sentence, what is wrong if they are not."""

from __future__ import annotations

from numpy.typing import ArrayLike

from course_lib.boards import Board, Charuco, Checkerboard, DotGrid, SquareGrid
from course_lib.detection.checkerboards import detect_checkerboard
from course_lib.detection.corner_fit import refine_corners
from course_lib.detection.dots import detect_dots
from course_lib.detection.markers import detect_charuco
from course_lib.detection.result import Detection
from course_lib.detection.squares import detect_squares

__all__ = [
    "Board",
    "Charuco",
    "Checkerboard",
    "Detection",
    "DotGrid",
    "SquareGrid",
    "detect_board",
    "refine_corners",
]


def detect_board(image: ArrayLike, board: Board) -> Detection:
    """Return where the points of a board are in a picture.

    Parameters
    ----------
    image : array_like, shape (height, width) or (height, width, 3)
        The picture, grey or RGB: `uint8`, `uint16`, or `float` from 0 to 1.
    board : Checkerboard, DotGrid, Charuco or SquareGrid
        What to look for.

    Returns
    -------
    Detection
        The points to a fraction of a pixel, which ones they are, and a verdict.

    Raises
    ------
    TypeError, ValueError
        If `image` is no picture, or `board` no board.

    Notes
    -----
    Seen from the front, the points run along a row to the right and from row to row downwards, as
    the picture shows them or turned; never mirrored. The first corner of a checkerboard with an odd
    number of corners one way and an even number the other way is that at its dark outermost square.
    All other boards look the same after half a turn (square ones after a quarter): there, the
    turn is taken in which rows lead most to the right. One camera's calibration is the same either
    way; two cameras must see the board the same way up.
    """
    if isinstance(board, Checkerboard):
        return detect_checkerboard(image, board)
    if isinstance(board, DotGrid):
        return detect_dots(image, board)
    if isinstance(board, Charuco):
        return detect_charuco(image, board)
    if isinstance(board, SquareGrid):
        return detect_squares(image, board)
    raise TypeError(f"board must be a Checkerboard, DotGrid, Charuco or SquareGrid, got {board!r}")
