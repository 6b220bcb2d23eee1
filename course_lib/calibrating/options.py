"""What is typed at the keyboard, as a board and a camera's model."""

from __future__ import annotations

import argparse
import re

from course_lib.boards import Board, Charuco, Checkerboard, DotGrid, SquareGrid

LENGTHS = {
    "square": "side of a square, measured on the print; of a dot grid, the distance of "
    "neighbouring centres",
    "diameter": "of a dot (0.6 of the distance)",
    "marker": "side of a ChArUco marker (0.73 of a square)",
    "pitch": "with --kind squares: from one edge to the same edge of the next",
}
KINDS = ("checkerboard", "dots", "charuco", "squares")


def add_board_options(command: argparse.ArgumentParser) -> None:
    """Add the options that describe a board."""
    command.add_argument(
        "--board",
        required=True,
        type=counts,
        metavar="9x6",
        help="inner corners across and down (one fewer than squares); or dots, or squares",
    )
    command.add_argument("--kind", choices=KINDS, default=KINDS[0], help="(%(default)s)")
    for name, meaning in LENGTHS.items():
        needed = name == "square"
        command.add_argument(f"--{name}", required=needed, type=float, metavar="MM", help=meaning)
    command.add_argument(
        "--dictionary", default="DICT_5X5_1000", help="of ChArUco markers (%(default)s)"
    )


def counts(text: str) -> tuple[int, int]:
    """Return the two numbers of ``9x6``."""
    found = re.fullmatch(r"\s*(\d+)\s*[x×X*,]\s*(\d+)\s*", text)
    if not found:
        raise argparse.ArgumentTypeError(f"write it like 9x6, got {text!r}")
    return int(found[1]), int(found[2])


def board_of(options: argparse.Namespace) -> Board:
    """Return the board that the options describe.

    Parameters
    ----------
    options : argparse.Namespace
        As of `add_board_options`.

    Returns
    -------
    Checkerboard, DotGrid, Charuco or SquareGrid
        The board.

    Raises
    ------
    ValueError
        If a number is impossible.
    """
    (columns, rows), square = options.board, options.square
    if options.kind == "dots":
        return DotGrid(columns, rows, square, options.diameter or 0.6 * square)
    if options.kind == "charuco":
        marker = options.marker or round(0.73 * square, 1)
        return Charuco(columns, rows, square, marker, options.dictionary)
    if options.kind == "squares":
        if options.pitch is None:
            raise ValueError("separate squares need --pitch, from the edge of one to the next's")
        return SquareGrid(columns, rows, square, options.pitch)
    return Checkerboard(columns, rows, square)
