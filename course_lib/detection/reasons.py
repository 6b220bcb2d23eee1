"""Why a checkerboard was not found, or is not as good as it should be: in words for its owner."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from course_lib.boards import Checkerboard
from course_lib.checks import Array
from course_lib.detection.corner_fit import CornerFit, fit_corners
from course_lib.detection.lattices import cell_middles, next_row
from course_lib.detection.result import Detection, Picture, Problem, nothing, smaller_pictures

#: A blur is too wide beyond this part of a square, px of the picture's long side, and px.
BLUR_OF_SQUARE, BLUR_OF_PICTURE, BLUR_PIXELS = 0.12, 0.0035, 1.5
#: So many of a board's corners must be where two edges cross, and what a crossing does not explain
#: must be a smaller part of the contrast.
CORNERS, UNLIKE = 0.7, 0.2
#: Grey levels from here on count as white without detail.
CLIPPED = 250
#: A corner whose contrast is a smaller part of the usual one is washed out.
FAINT = 0.4


class Seen(NamedTuple):
    """A part of a checkerboard."""

    picture: Picture
    grid: Array  # shape (rows, columns, 2), px of the picture

    @property
    def corners(self) -> int:
        """How many corners it has."""
        return int(self.grid.shape[0] * self.grid.shape[1])

    @property
    def square(self) -> float:
        """How long the sides of its squares are, px."""
        steps = [np.linalg.norm(np.diff(self.grid, axis=k), axis=2).ravel() for k in (0, 1)]
        return float(np.median(np.concatenate(steps)))

    def is_of(self, board: Checkerboard) -> bool:
        """Return whether it has as many columns and rows as a board, in whichever order."""
        return sorted(self.grid.shape[:2]) == sorted((board.columns, board.rows))


def judged(grey: Picture, fit: CornerFit, grid: Array, board: Checkerboard) -> tuple[Problem, str]:
    """Return what is wrong with a board that was found, and a sentence."""
    lost = int((~fit.good).sum())
    rest = f" {len(fit.good) - lost} of {len(fit.good)} corners are usable." if lost else ""
    if glare := _glare(grey, fit):
        return "glare", (
            f"The board was found, but light is reflected at {glare} of {len(fit.good)} corners."
            f"{rest} Turn the board or the lamp and take it again."
        )
    steps = [np.linalg.norm(np.diff(grid, axis=k), axis=2).ravel() for k in (0, 1)]
    square, blur = np.median(np.concatenate(steps)), np.median(fit.blur[fit.good])
    if not fit.good.any() or too_blurred(float(blur), float(square), grey.shape):
        return "blurred", (
            f"The board was found, but it is blurred over {2.5 * blur:.0f} px, where a square has "
            f"{square:.0f}.{rest} Hold the camera still, focus, and take it again."
        )
    if lost > 0.1 * len(fit.good):
        return "covered", f"The board was found, but something hides a part of it.{rest}"
    return "", f"All {board.name} found." if not lost else f"The board was found.{rest}"


def is_board(fit: CornerFit) -> bool:
    """Return whether places are the corners of a board, and not of something like it."""
    unlike = np.median(fit.noise / np.maximum(fit.contrast, 1e-9))
    return bool(fit.good.mean() >= CORNERS and unlike < UNLIKE)


def too_blurred(blur: float, square: float, shape: tuple[int, ...]) -> bool:
    """Return whether a blur is too wide for squares of so many px in a picture of this shape."""
    return blur > max(BLUR_PIXELS, min(BLUR_OF_SQUARE * square, BLUR_OF_PICTURE * max(shape)))


def _glare(grey: Picture, fit: CornerFit) -> int:
    """Return at how many corners the picture is white all around."""
    usual = np.median(fit.contrast[fit.good]) if fit.good.any() else 0.0
    faint = ~fit.good | (fit.contrast < FAINT * usual)
    whites = sum(_is_white(grey, point) for point in fit.points[faint])
    return whites if whites > 0.03 * len(fit.good) else 0


def _is_white(grey: Picture, point: Array, reach: int = 5) -> bool:
    """Return whether there is nothing but white around a place."""
    column, row = (round(float(x)) for x in point)
    rows, columns = (slice(max(k - reach, 0), max(k + reach + 1, 0)) for k in (row, column))
    window = grey[rows, columns]
    return bool(window.size and np.mean(window >= CLIPPED) > 0.6)


def why_not_found(seen: Seen | None, board: Checkerboard) -> Detection:
    """Return a detection without points that says what can be seen instead of the board."""
    if seen is None:
        return nothing(
            "no board",
            f"No checkerboard was found: neither the {board.name}, nor others. The whole board "
            "with a light border around it must be visible, evenly lit and sharp.",
        )
    rows, columns = seen.grid.shape[:2]
    if rows > columns and board.columns >= board.rows:
        rows, columns = columns, rows
    if seen.is_of(board):
        return nothing(
            "blurred",
            f"The {board.name} can be seen, but are too blurred to be measured. Hold the camera "
            "still, focus, and take it again.",
            (columns, rows),
        )
    problem, cause = _cause(seen, board)
    said = f"Saw {columns} × {rows} corners instead of {board.name}{cause}"
    return nothing(problem, said, (columns, rows))


def _cause(seen: Seen, board: Checkerboard) -> tuple[Problem, str]:
    """Return why only a part of a board is seen, and the end of a sentence."""
    if cannot_be(seen, board):
        return "wrong size", ". Count the inner corners, where four squares meet."
    sides = [_around(seen, turn) for turn in range(4)]
    if "white" in sides and not _paper_is_white(seen):
        return "glare", ": light is reflected beside them. Turn the board or the lamp."
    if "outside" in sides:
        return "cut off", (
            ", up to the edge of the picture. The whole board with its light border must be in "
            "the picture; if it is, count its inner corners."
        )
    return "wrong size", (
        ". Count the inner corners, where four squares meet; if the count is right, something "
        "hides a part of the board."
    )


def cannot_be(seen: Seen, board: Checkerboard) -> bool:
    """Return whether more is seen than this board has, one way or the other."""
    few, many = sorted(seen.grid.shape[:2])
    return bool(many > max(board.columns, board.rows) or few > min(board.columns, board.rows))


def _paper_is_white(seen: Seen) -> bool:
    """Return whether the light squares are too bright themselves to tell a reflection."""
    column, row = np.rint(cell_middles(seen.grid)).astype(int).reshape(-1, 2).T
    return bool(np.percentile(seen.picture[row, column], 75) >= CLIPPED)


def part_of_board(grey: Picture, once: bool = False) -> Seen | None:
    """Return the largest part of any checkerboard that can be seen, or None.

    With `once`, only the likeliest of all sizes of the picture is looked at.
    """
    pictures = [picture for picture, _ in smaller_pictures(grey)]
    parts = [part_in(picture) for picture in (pictures[:1] if once else pictures)]
    return max((p for p in parts if p is not None), key=lambda p: p.corners, default=None)


def part_in(picture: Picture) -> Seen | None:
    """Return the largest part of any checkerboard that can be seen in a picture of this size."""
    import cv2

    same_every_time()
    flags = cv2.CALIB_CB_NORMALIZE_IMAGE | cv2.CALIB_CB_EXHAUSTIVE | cv2.CALIB_CB_LARGER
    found, corners, meta = cv2.findChessboardCornersSBWithMeta(picture, (3, 3), flags)
    if not found:
        return None
    points = np.asarray(corners, float).reshape(-1, 2)
    if not is_board(fit_corners(picture, points)):
        return None
    return Seen(picture, points.reshape(*meta.shape[:2], 2))


def same_every_time() -> None:
    """Let OpenCV's thorough finder draw the same lots: a picture shall have one verdict."""
    import cv2

    cv2.setRNGSeed(-1)


def _around(seen: Seen, turn: int) -> str:
    """Return what is where the next row would be: outside of the picture, white, or something."""
    places = next_row(np.rot90(seen.grid, turn))
    limit = np.array(seen.picture.shape)[::-1] - 1
    outside = ((places < 0) | (places > limit)).any(axis=1)
    if outside.any():
        return "outside"
    white = [_is_white(seen.picture, place, 3) for place in places]
    return "white" if np.mean(white) > 0.3 else "something"
