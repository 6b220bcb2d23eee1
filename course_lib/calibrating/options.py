"""What is typed at the keyboard, as a board and a camera's model."""

from __future__ import annotations

import argparse
import math
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
DICTIONARY = "DICT_5X5_1000"
#: Which options belong to one kind of board only.
OF_KIND = {"diameter": "dots", "marker": "charuco", "dictionary": "charuco", "pitch": "squares"}
#: No board's squares are smaller or larger, mm.
SMALLEST, LARGEST = 0.5, 2000.0
COEFFICIENTS = ["k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4"]


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
        command.add_argument(f"--{name}", required=needed, type=length, metavar="MM", help=meaning)
    command.add_argument("--dictionary", help=f"of ChArUco markers ({DICTIONARY})")


def counts(text: str) -> tuple[int, int]:
    """Return the two numbers of ``9x6``."""
    found = re.fullmatch(r"\s*(\d+)\s*[x×X*,]\s*(\d+)\s*", text)
    if not found:
        raise argparse.ArgumentTypeError(f"write it like 9x6, got {text!r}")
    return int(found[1]), int(found[2])


def length(text: str) -> float:
    """Return the number of millimetres that was typed."""
    try:
        value = float(text)
    except ValueError:
        value = float("nan")
    if math.isfinite(value):
        return value
    found = re.fullmatch(r"\s*(\d+)[.,]?(\d*)\s*(mm|cm|m)?\s*", text)
    if not found:
        raise argparse.ArgumentTypeError(f"write a number of millimetres like 30, got {text!r}")
    number = float(f"{found[1]}.{found[2] or 0}") * {"cm": 10, "m": 1000}.get(found[3], 1)
    raise argparse.ArgumentTypeError(
        f"write {number} (in mm, with a point, without the unit), got {text!r}"
    )


def coefficients_of(text: str) -> tuple[str, ...]:
    """Return the names of ``k1,k2``; of ``none``, no names.

    Raises
    ------
    ValueError
        If it is empty, or a name is unknown or there twice.
    """
    names = tuple(name for name in text.replace(" ", "").split(",") if name)
    if names == ("none",):
        return ()
    if not names:
        raise ValueError(
            "--coefficients is empty: write --coefficients none for a lens without distortion"
        )
    wrong = [name for name in names if name not in COEFFICIENTS or names.count(name) > 1]
    if wrong:
        raise ValueError(
            f"--coefficients must be some of {','.join(COEFFICIENTS)}, each once, got {wrong[0]}"
        )
    return names


def _check_options(options: argparse.Namespace) -> None:
    """Raise if an option is of another kind of board, or a length is none of a board."""
    for name, kind in OF_KIND.items():
        if getattr(options, name) is not None and options.kind != kind:
            raise ValueError(
                f"--{name} is for --kind {kind}, and this is --kind {options.kind}: "
                "leave one of them out"
            )
    for name in LENGTHS:
        value = getattr(options, name)
        if value is None or (SMALLEST <= value <= LARGEST):
            continue
        if name == "square" or value <= 0:
            raise ValueError(
                f"--{name} must be from {SMALLEST:g} mm to {LARGEST:g} mm, got {value:g}: measure "
                "it on the print, in mm"
            )


def lengths_of(board: Board) -> str:
    """Return the sizes of what is on a board, in words."""
    sizes = {"square": "squares of", "pitch": "steps of", "diameter": "dots of"}
    sizes["marker"] = "markers of"
    told = [f"{word} {getattr(board, n):g} mm" for n, word in sizes.items() if hasattr(board, n)]
    return ", ".join(told)


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
    _check_options(options)
    (columns, rows), square = options.board, options.square
    if options.kind == "dots":
        return DotGrid(columns, rows, square, options.diameter or 0.6 * square)
    if options.kind == "charuco":
        marker = options.marker or round(0.73 * square, 1)
        return Charuco(columns, rows, square, marker, options.dictionary or DICTIONARY)
    if options.kind == "squares":
        if options.pitch is None:
            raise ValueError("separate squares need --pitch, from the edge of one to the next's")
        return SquareGrid(columns, rows, square, options.pitch)
    return Checkerboard(columns, rows, square)
