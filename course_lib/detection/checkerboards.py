"""Checkerboards: OpenCV says roughly where the corners are, the fit of `corner_fit` exactly."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from course_lib.boards import Checkerboard
from course_lib.checks import Array
from course_lib.detection.corner_fit import MOST, SHARE, CornerFit, fit_corners, refine_corners
from course_lib.detection.lattices import cell_middles, next_row, turned
from course_lib.detection.reasons import (
    Seen,
    cannot_be,
    is_board,
    judged,
    part_in,
    part_of_board,
    same_every_time,
    why_not_found,
)
from course_lib.detection.result import (
    LOOKED_AT,
    Detection,
    Grey,
    Picture,
    grey_picture,
    in_full_size,
    in_small_size,
    nothing,
    shrunk,
    smaller_pictures,
)

#: Squares beyond the board's last: so many must be dark or light in turn, with so much contrast.
MANY, STRONG = 0.8, 0.4
#: So much of all cells is of the right shade; all of it on the real photographs that were tried.
UNIFORM = 0.9
#: Squares of so many px are not overlooked in one size of a picture and found in another.
LARGE = 20.0
#: Blur at which corners are fitted best, px.
SHARP = 1.2


def detect_checkerboard(image: ArrayLike, board: Checkerboard) -> Detection:
    """Return the corners of a checkerboard; see `course_lib.detection.detect_board`."""
    grey = grey_picture(image)
    rough, seen = find_corners(grey, board)
    if rough is None:
        return why_not_found(seen, board)
    rough = in_order(grey, rough, board)
    fit = fit_in_suitable_size(grey, rough.reshape(-1, 2))
    if not is_board(fit):
        return why_not_found(part_of_board(grey), board)
    larger = _beyond(grey, rough)
    if larger or not _alternating(grey, rough):
        return _part_of_another(grey, board, larger or (0, 0))
    ids = np.flatnonzero(fit.good)
    problem, verdict = judged(grey, fit, rough, board)
    return Detection(True, fit.points[ids], ids, problem, verdict, float(np.median(fit.blur[ids])))


def _part_of_another(grey: Picture, board: Checkerboard, more: tuple[int, int]) -> Detection:
    """Return a detection without points for a board that goes on beyond what was found of it."""
    seen = part_of_board(grey)
    counts = board.columns + more[0], board.rows + more[1]
    if seen is not None and seen.corners > counts[0] * counts[1]:
        few, many = sorted(seen.grid.shape[:2])
        counts = (many, few) if board.columns >= board.rows else (few, many)
    return nothing(
        "wrong size",
        f"Saw {counts[0]} × {counts[1]} corners or more, but the board should have {board.name}. "
        "Count the inner corners, where four squares meet.",
        counts,
    )


def fit_in_suitable_size(grey: Picture, rough: Array, share: float = SHARE) -> CornerFit:
    """Return corners, fitted in the picture made so small that edges are about a pixel wide.

    Averaging the pixels of a wide edge loses nothing, and a window sees more of it.
    """
    small = fit_corners(grey, rough, share=share)
    blur = float(np.median(small.blur[small.good])) if small.good.any() else MOST
    factor = min(blur / SHARP, max(1.0, min(grey.shape) / 100))
    if factor < 1.5:
        return small
    picture, ratio = shrunk(grey, factor)
    fit = fit_corners(picture, in_small_size(rough, ratio), share=share)
    return replace(
        fit,
        points=in_full_size(fit.points, ratio),
        blur=factor * fit.blur,
        sigma=factor * fit.sigma,
    )


def find_corners(grey: Picture, board: Checkerboard) -> tuple[Array | None, Seen | None]:
    """Return roughly where the corners are, in some order, shape (rows, columns, 2), or None.

    Then also the largest part of any checkerboard that was seen, or None.
    """
    best = None
    for number, (picture, ratio) in enumerate(smaller_pictures(grey)):
        corners = _usual(picture, board)
        if corners is None and number == 0:
            corners = _thorough(picture, board)
        if corners is None:
            seen = part_in(picture)
            best = max((p for p in (best, seen) if p), key=lambda p: p.corners, default=None)
            if number == 0 and seen and cannot_be(seen, board):
                return None, part_of_board(grey)  # the other sizes are not worth their time
            if seen and seen.is_of(board):
                corners = turned(seen.grid, board.columns, board.rows).reshape(-1, 2)
            elif seen and number > 0 and seen.square < LARGE:
                corners = _thorough(picture, board)
        if corners is not None:
            if ratio.max() > 1:
                # To a few px of a large picture, where windows cover little of a square.
                corners = in_full_size(refine_corners(picture, corners), ratio)
            return corners.reshape(board.rows, board.columns, 2), best
    return None, best


def _usual(picture: Grey, board: Checkerboard) -> Array | None:
    """Return what OpenCV's usual finder sees; it takes seconds in large pictures full of things."""
    import cv2

    if max(picture.shape) > LOOKED_AT[0]:
        return None
    flags = cv2.CALIB_CB_ADAPTIVE_THRESH | cv2.CALIB_CB_NORMALIZE_IMAGE
    found, corners = cv2.findChessboardCorners(picture, (board.columns, board.rows), flags=flags)
    return np.asarray(corners, float).reshape(-1, 2) if found else None


def _thorough(picture: Grey, board: Checkerboard) -> Array | None:
    """Return what OpenCV's thorough finder sees."""
    import cv2

    if min(board.columns, board.rows) <= 2:
        return None
    same_every_time()
    flags = cv2.CALIB_CB_NORMALIZE_IMAGE | cv2.CALIB_CB_EXHAUSTIVE
    found, corners = cv2.findChessboardCornersSB(picture, (board.columns, board.rows), flags=flags)
    return np.asarray(corners, float).reshape(-1, 2) if found else None


def in_order(grey: Picture, grid: Array, board: Checkerboard) -> Array:
    """Return corners in the board's order: right turns, and if it can be told, dark first.

    With an odd number of corners one way and an even number the other way, the board looks
    different after half a turn. Then the first corner is the one at the dark outermost square.
    """
    grid = turned(grid, board.columns, board.rows)
    if (board.columns + board.rows) % 2 and not _dark_first(grey, grid):
        grid = grid[::-1, ::-1]
    elif board.columns == board.rows and board.columns % 2 and not _dark_first(grey, grid):
        grid = turned(np.rot90(grid), board.columns, board.rows)
    return grid


def _dark_first(grey: Picture, grid: Array) -> bool:
    """Return whether the first inner square, and so the outermost, is of the dark ones."""
    even, odd = _squares(grey, grid)
    return bool(even.mean() < odd.mean())


def _alternating(grey: Picture, grid: Array) -> bool:
    """Return whether each cell is of one shade, and its neighbours of another.

    If not, rows or columns were jumped over, and cells are made of several squares.
    """
    values = _in_cells(grey, grid)
    means = np.pad(values.mean(axis=2), 1, constant_values=np.nan)
    sides = [np.roll(means, step, axis) for axis in (0, 1) for step in (-1, 1)]
    around = np.nanmean(np.stack(sides)[:, 1:-1, 1:-1], axis=0)
    difference = (means[1:-1, 1:-1] - around)[..., None]
    right = (values - around[..., None] - difference / 2) * difference > 0
    return bool(right.mean() >= UNIFORM)


def _in_cells(grey: Picture, grid: Array) -> Array:
    """Return grey levels at nine places in each cell, shape (rows - 1, columns - 1, 9)."""
    first, right, below, last = grid[:-1, :-1], grid[:-1, 1:], grid[1:, :-1], grid[1:, 1:]
    parts = [(x, y) for x in (0.25, 0.5, 0.75) for y in (0.25, 0.5, 0.75)]
    places = [
        (1 - y) * ((1 - x) * first + x * right) + y * ((1 - x) * below + x * last) for x, y in parts
    ]
    columns, rows = np.rint(np.stack(places, axis=2)).astype(int).transpose(3, 0, 1, 2)
    inside = np.clip(rows, 0, grey.shape[0] - 1), np.clip(columns, 0, grey.shape[1] - 1)
    return np.asarray(grey[inside], float)


def _squares(grey: Picture, grid: Array) -> tuple[Array, Array]:
    """Return the grey levels in the middle of every other square, and of those between."""
    middles = np.rint(cell_middles(grid)).astype(int)
    column = np.clip(middles[..., 0], 0, grey.shape[1] - 1)
    row = np.clip(middles[..., 1], 0, grey.shape[0] - 1)
    odd = np.indices(column.shape).sum(axis=0) % 2 == 1
    values = grey[row, column]
    return values[~odd], values[odd]


def _beyond(grey: Picture, grid: Array) -> tuple[int, int] | None:
    """Return how many columns and rows more there seem to be, or None if there are no more."""
    longer = [_goes_on(grey, np.rot90(grid, turn)) for turn in range(4)]
    return (longer[1] + longer[3], longer[0] + longer[2]) if any(longer) else None


def _goes_on(grey: Picture, grid: Array) -> bool:
    """Return whether there are squares, dark and light in turns, beyond those after the last row.

    The squares right after the last row of corners are the board's own.
    """
    first = next_row(grid)
    # Half a square is enough: many boards end in halves.
    beyond = np.stack([first, (first + next_row(np.concatenate([grid, first[None]]))) / 2])
    if (beyond < 0).any() or (beyond > np.array(grey.shape)[::-1] - 1).any():
        return False
    even, odd = _squares(grey, grid)
    # The row of squares beyond is number ``rows`` of the squares, counted from 0.
    new_even, new_odd = _squares(grey, beyond)[:: 1 if len(grid) % 2 == 0 else -1]
    level, sign = (even.mean() + odd.mean()) / 2, np.sign(even.mean() - odd.mean())
    right = np.concatenate([sign * (new_even - level) > 0, sign * (level - new_odd) > 0])
    contrast = sign * (new_even.mean() - new_odd.mean()) / abs(even.mean() - odd.mean())
    return bool(right.mean() >= MANY and contrast > STRONG)
