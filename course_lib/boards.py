"""Boards to calibrate a camera with: which points are on them, and where.

A board lies in the plane z = 0 of its own frame, x along its rows, y down its columns, the first
point at the origin. Lengths are in whatever unit the board was measured in.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from course_lib.calibration.views import board_points
from course_lib.checks import Array, check_length

#: Fewer points in a row or column make no grid; corners are looked for three by three at least.
FEWEST, FEWEST_CORNERS, MOST = 2, 3, 200


def _check_counts(columns: int, rows: int, what: str, fewest: int = FEWEST) -> None:
    for name, count in (("columns", columns), ("rows", rows)):
        if not isinstance(count, int | np.integer) or not fewest <= count <= MOST:
            raise ValueError(
                f"{name} must be a whole number from {fewest} to {MOST}, got {count!r}: "
                f"count the {what}"
            )


@dataclass(frozen=True)
class Checkerboard:
    """A checkerboard. Its points are the inner corners, where four squares meet.

    Attributes
    ----------
    columns, rows : int
        Inner corners across and down; there is one square more.
    square : float
        Side of a square.

    Raises
    ------
    TypeError, ValueError
        If a count is not a whole number of at least 3 or the square is not positive.
    """

    columns: int
    rows: int
    square: float

    def __post_init__(self) -> None:
        what = "inner corners, where four squares meet"
        _check_counts(self.columns, self.rows, what, FEWEST_CORNERS)
        check_length(self.square, "square")

    def points(self) -> Array:
        """Return the inner corners in the board's frame, shape (rows columns, 3)."""
        return board_points(self.columns, self.rows, self.square)

    @property
    def name(self) -> str:
        """What it is called in a sentence."""
        return f"{self.columns} × {self.rows} corners"


@dataclass(frozen=True)
class DotGrid:
    """A rectangular grid of round dots. Its points are their centres.

    Attributes
    ----------
    columns, rows : int
        Dots across and down.
    pitch : float
        Distance of the centres of neighbours.
    diameter : float
        Of a dot, in the same unit.

    Raises
    ------
    TypeError, ValueError
        If a count is not a whole number of at least 2, a length is not positive, or dots touch.
    """

    columns: int
    rows: int
    pitch: float
    diameter: float

    def __post_init__(self) -> None:
        _check_counts(self.columns, self.rows, "dots")
        if check_length(self.diameter, "diameter") >= check_length(self.pitch, "pitch"):
            raise ValueError(
                f"diameter must be smaller than pitch ({self.pitch:g}), got {self.diameter:g}: "
                "the dots would touch"
            )

    def points(self) -> Array:
        """Return the dots' centres in the board's frame, shape (rows columns, 3)."""
        return board_points(self.columns, self.rows, self.pitch)

    @property
    def name(self) -> str:
        """What it is called in a sentence."""
        return f"{self.columns} × {self.rows} dots"


@dataclass(frozen=True)
class Charuco:
    """A checkerboard with a marker in each light square, so that each corner has a number.

    Attributes
    ----------
    columns, rows : int
        Inner corners across and down; there is one square more.
    square, marker : float
        Side of a square and of a marker.
    dictionary : str
        Markers, as OpenCV calls them; the first is in the upper left.

    Raises
    ------
    TypeError, ValueError
        If a count is not a whole number of at least 2, a length is not positive, or markers are
        not smaller than squares.
    """

    columns: int
    rows: int
    square: float
    marker: float
    dictionary: str = "DICT_5X5_1000"

    def __post_init__(self) -> None:
        _check_counts(self.columns, self.rows, "inner corners, where four squares meet")
        if check_length(self.marker, "marker") >= check_length(self.square, "square"):
            raise ValueError(
                f"marker must be smaller than square ({self.square:g}), got {self.marker:g}"
            )

    def points(self) -> Array:
        """Return the inner corners in the board's frame, shape (rows columns, 3)."""
        return board_points(self.columns, self.rows, self.square)

    @property
    def name(self) -> str:
        """What it is called in a sentence."""
        return f"{self.columns} × {self.rows} numbered corners"


@dataclass(frozen=True)
class SquareGrid:
    """Separate dark squares, as on the board of Zhang's paper. Its points are all their corners.

    Attributes
    ----------
    columns, rows : int
        Squares across and down.
    square : float
        Side of a square.
    pitch : float
        Distance from a square to the next, from edge to the same edge.

    Raises
    ------
    TypeError, ValueError
        If a count is not a whole number of at least 2, a length is not positive, or squares touch.

    References
    ----------
    Z. Zhang, A flexible new technique for camera calibration, IEEE PAMI 22 (2000), section 4.
    """

    columns: int
    rows: int
    square: float
    pitch: float

    def __post_init__(self) -> None:
        _check_counts(self.columns, self.rows, "squares")
        if check_length(self.square, "square") >= check_length(self.pitch, "pitch"):
            raise ValueError(
                f"square must be smaller than pitch ({self.pitch:g}), got {self.square:g}"
            )

    def points(self) -> Array:
        """Return the corners in the board's frame, shape (4 rows columns, 3).

        Square after square, row by row; each from its upper left corner to the right and around.
        """
        around = self.square * np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]])
        corners = board_points(self.columns, self.rows, self.pitch)[:, None] + around
        return np.asarray(corners.reshape(-1, 3))

    @property
    def name(self) -> str:
        """What it is called in a sentence."""
        return f"{self.columns} × {self.rows} squares"


Board = Checkerboard | DotGrid | Charuco | SquareGrid
