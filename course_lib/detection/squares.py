"""Boards of separate squares: the four edges of each are found, and meet in its corners."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.boards import SquareGrid
from course_lib.checks import Array
from course_lib.detection.dots import find_grid, why_no_grid
from course_lib.detection.result import Detection, Picture, Problem, grey_picture

#: Where an edge is looked for: parts of it, and how far to each side by the width of the square.
ALONG = np.linspace(0.18, 0.82, 25)
ACROSS = np.linspace(-0.3, 0.3, 25)
TURNS = 3  # each from the corners of the last
NARROW = 8.0  # px: edges are blurred too wide for less


def detect_squares(image: ArrayLike, board: SquareGrid) -> Detection:
    """Return the corners of all squares; see `course_lib.detection.detect_board`."""
    grey = grey_picture(image)
    grid, shapes = find_grid(grey, board)
    if grid is None:
        return why_no_grid(grey, shapes, board)
    there = np.flatnonzero(grid[..., 2].ravel() >= 0)
    steps = _steps(grid).reshape(-1, 2, 2)[there]
    which = grid[..., 2].ravel()[there].astype(int)
    corners = _first_corners(shapes.middles[which], shapes.spreads[which], steps)
    for _ in range(TURNS):
        corners = _on_edges(grey, corners)
    good = np.isfinite(corners).all(axis=(1, 2))
    ids = (4 * there[good, None] + np.arange(4)).ravel()
    points, count = corners[good].reshape(-1, 2), 4 * board.columns * board.rows
    if len(ids) == count:
        return Detection(True, points, ids, "", f"All {board.name} found.")
    problem: Problem = "covered" if len(ids) < 0.95 * count else ""
    said = f"The squares were found, but some are hidden: {len(ids)} of {count} corners are usable."
    return Detection(True, points, ids, problem, said)


def _steps(grid: Array) -> Array:
    """Return the steps along the row and down the column at each place, shape (…, 2, 2)."""
    along = np.nanmean(np.diff(grid[..., :2], axis=1), axis=1, keepdims=True)
    down = np.nanmean(np.diff(grid[..., :2], axis=0), axis=0, keepdims=True)
    shape = (*grid.shape[:2], 2)
    return np.stack([np.broadcast_to(along, shape), np.broadcast_to(down, shape)], axis=2)


def _first_corners(middles: Array, spreads: Array, steps: Array) -> Array:
    """Return parallelograms along the steps with the shapes' spread, shape (N, 4, 2)."""
    # A square of half side h has spread h² / 3 along both sides.
    inverse = np.linalg.inv(steps)
    within = inverse.mT @ spreads @ inverse
    half = np.sqrt(3 * within[:, [0, 1], [0, 1]])[..., None] * steps
    across, down = half[:, 0], half[:, 1]
    ways = [-across - down, across - down, across + down, down - across]
    return np.asarray(middles[:, None] + np.stack(ways, axis=1))


def _on_edges(grey: Picture, corners: Array) -> Array:
    """Return where lines through the edges beside these sides meet; NaN where there is no edge."""
    starts, ends = corners, np.roll(corners, -1, axis=1)
    sides = ends - starts
    length = np.linalg.norm(sides, axis=2, keepdims=True)
    normals = np.stack([sides[..., 1], -sides[..., 0]], axis=2) / length
    places = starts[:, :, None] + ALONG[:, None] * sides[:, :, None]
    # As far as to a third of the way to the opposite side.
    beside = np.roll(sides, -1, axis=1)
    across = np.abs((beside * normals).sum(axis=2, keepdims=True))
    offsets = ACROSS * np.maximum(across, NARROW)
    samples = places[:, :, :, None] + offsets[:, :, None, :, None] * normals[:, :, None, None]
    values = _between_pixels(grey, samples)
    rise = np.maximum(np.diff(values, axis=3), 0)  # from dark inside to light outside
    rise = np.where(rise > 0.25 * rise.max(axis=3, keepdims=True), rise, 0)
    between = (offsets[:, :, 1:] + offsets[:, :, :-1])[:, :, None] / 2
    with np.errstate(invalid="ignore"):
        edge = (rise * between).sum(axis=3) / rise.sum(axis=3)
    return _meeting(starts, sides, normals, edge)


def _meeting(starts: Array, sides: Array, normals: Array, edge: Array) -> Array:
    """Return where each side, moved to its edge, meets the one before."""
    columns = np.stack([np.ones_like(ALONG), ALONG], axis=1)
    offset, slope = np.moveaxis(edge @ np.linalg.pinv(columns).T, -1, 0)
    first = starts + offset[..., None] * normals
    along = sides + slope[..., None] * normals
    before, way = np.roll(first, 1, axis=1), np.roll(along, 1, axis=1)
    cross = way[..., 0] * along[..., 1] - way[..., 1] * along[..., 0]
    gap = first - before
    part = (gap[..., 0] * along[..., 1] - gap[..., 1] * along[..., 0]) / cross
    return np.asarray(before + part[..., None] * way)


def _between_pixels(grey: Picture, places: Array) -> Array:
    """Return the picture between its pixels; beyond its border, that of the border."""
    import cv2

    flat = places.reshape(-1, places.shape[-2], 2).astype(np.float32)
    found = cv2.remap(
        grey.astype(np.float32),
        flat[..., 0],
        flat[..., 1],
        cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_REPLICATE,
    )
    return np.asarray(found, float).reshape(places.shape[:-1])
