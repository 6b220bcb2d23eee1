"""Hilly ground with fields, tracks, trees and some houses, as seen from above.

World: x east, y north, z up, in metres; the ground begins at (0, 0). It is a net of triangles, and
the map is laid over it without a seam.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from course_lib.checks import Array
from data_generators.bodies import house
from data_generators.patterns import as_texture, clouds, spots, target
from data_generators.scene import Patch, Scene, Texture

CELL = 8.0  # side of a square of the net
PIXELS = 56  # of the map, to a cell
BORDER = 4  # px that a cell's texture has beyond it
FIELDS = np.array([[0.42, 0.50, 0.28], [0.58, 0.56, 0.34], [0.50, 0.42, 0.32], [0.36, 0.46, 0.26]])
WALLS = (214, 206, 190), (196, 168, 142), (206, 204, 206)
ROOFS = (158, 78, 58), (120, 72, 62), (96, 92, 94)


class Terrain(NamedTuple):
    """Ground that can be photographed.

    Attributes
    ----------
    scene : Scene
        The ground and what stands on it.
    heights : ndarray, shape (rows + 1, columns + 1)
        Of the corners of the net, the first row in the south.
    marks : ndarray, shape (n, 3)
        The middles of the survey marks.
    """

    scene: Scene
    heights: Array
    marks: Array


def terrain(
    rng: np.random.Generator, cells: tuple[int, int], relief: float, marks: Array, houses: int = 10
) -> Terrain:
    """Return hilly ground.

    Parameters
    ----------
    rng : numpy.random.Generator
        For everything random.
    cells : tuple of int
        Of the net, to the east and to the north; 8 m each.
    relief : float
        Height of the hills above the valleys, m.
    marks : ndarray, shape (n, 2)
        Where survey marks lie, east and north, m.
    houses : int
        How many; none stands on a mark.

    Returns
    -------
    Terrain
        The ground.
    """
    columns, rows = cells
    heights = _hills(rng, cells, relief)
    places = _building_land(rng, cells, marks, houses)
    for column, row in places:
        pad = heights[row : row + 2, column : column + 2]
        pad[:] = pad.mean()
    chart = _chart(rng, heights, marks)
    patches = [
        p for row in range(rows) for c in range(columns) for p in _cell(c, row, heights, chart)
    ]
    for column, row in places:
        corner = [CELL * column + 1, CELL * row + 1.2, heights[row, column]]
        size = rng.uniform(5, 6), rng.uniform(4.5, 5.6), rng.uniform(2.7, 4.2)
        colours = WALLS[rng.integers(3)], ROOFS[rng.integers(3)]
        patches += house(corner, size, colours, rng)
    z = height_at(heights, marks)
    return Terrain(Scene(tuple(patches)), heights, np.column_stack([marks, z]))


def height_at(heights: Array, places: Array) -> Array:
    """Return the height of the net at places, (N, 2): each cell's diagonal runs to the north-east.

    Parameters
    ----------
    heights : ndarray, shape (rows + 1, columns + 1)
        Of the net's corners, m.
    places : ndarray, shape (N, 2)
        East and north, m, on the net.

    Returns
    -------
    ndarray, shape (N,)
        Metres.
    """
    limit = np.array(heights.shape)[::-1] - 2
    cell = np.clip(np.floor(places / CELL).astype(int), 0, limit)
    x, y = (places / CELL - cell).T
    column, row = cell.T
    low, high = heights[row, column], heights[row + 1, column + 1]
    beside = np.where(x >= y, heights[row, column + 1], heights[row + 1, column])
    near, far = np.minimum(x, y), np.maximum(x, y)
    return np.asarray(low + (far - near) * (beside - low) + near * (high - low))


def _hills(rng: np.random.Generator, cells: tuple[int, int], relief: float) -> Array:
    """Return heights of the net's corners, from 0 to `relief`."""
    rough = clouds(rng, (cells[1] + 1, cells[0] + 1), (2.5, 5))
    return np.asarray(relief * (rough - rough.min()) / np.ptp(rough))


def _building_land(
    rng: np.random.Generator, cells: tuple[int, int], marks: Array, houses: int
) -> list[tuple[int, int]]:
    """Return cells, column and row, that do not touch each other and hold no mark."""
    taken = {(int(x // CELL), int(y // CELL)) for x, y in marks}
    chosen: list[tuple[int, int]] = []
    every = [(c, r) for c in range(1, cells[0] - 1) for r in range(1, cells[1] - 1)]
    for number in rng.permutation(len(every)).tolist():
        c, r = every[number]
        if len(chosen) < houses and (c, r) not in taken:
            chosen.append((c, r))
            taken |= {(c + i, r + j) for i in (-1, 0, 1) for j in (-1, 0, 1)}
    return chosen


def _chart(rng: np.random.Generator, heights: Array, marks: Array) -> Texture:
    """Return the map, north up, with a border of `BORDER` px."""
    rows, columns = (np.array(heights.shape) - 1) * PIXELS + 2 * BORDER
    shape = int(rows), int(columns)
    picture = _fields(rng, shape) + 0.05 * clouds(rng, shape, (1.2, 2.5, 6, 20))[..., None]
    _tracks(picture, rng)
    spots(picture, rng, shape[0] * shape[1] // 4000, (3, 11), np.array([0.20, 0.32, 0.16]))
    spots(picture, rng, shape[0] * shape[1] // 9000, (1, 4), np.array([0.62, 0.58, 0.52]))
    picture *= _sunlight(heights, shape)[..., None]
    for x, y in marks * PIXELS / CELL:
        target(picture, x + BORDER - 0.5, shape[0] - BORDER - y - 0.5, 7)
    return as_texture(picture)


def _fields(rng: np.random.Generator, shape: tuple[int, int]) -> Array:
    """Return for each pixel the colour of the field that it is part of."""
    import cv2

    seeds = rng.uniform(0, 1, (max(6, shape[0] * shape[1] // 40_000), 2)) * shape
    turn = 0.4
    turned = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    row, column = np.arange(0.0, shape[0], 8), np.arange(0.0, shape[1], 8)
    small = np.stack(np.meshgrid(row, column, indexing="ij"), axis=-1) @ turned
    away = np.abs(small[:, :, None] - seeds @ turned).max(axis=-1)
    colours = FIELDS[rng.integers(0, len(FIELDS), len(seeds))]
    return np.asarray(cv2.resize(colours[away.argmin(axis=-1)], (shape[1], shape[0])))


def _tracks(picture: Array, rng: np.random.Generator) -> None:
    """Paint a winding track from west to east, and one from south to north."""
    import cv2

    height, width = picture.shape[:2]
    s = np.linspace(0, 1, 60)
    bend = 0.06 * np.sin(2 * np.pi * (1.3 * s + rng.uniform(0, 1, (2, 1))))
    across = np.stack([s * width, (0.42 + bend[0]) * height], axis=1)
    along = np.stack([(0.58 + bend[1]) * width, s * height], axis=1)
    for line in (across, along):
        points = np.rint(16 * line).astype(np.int32)
        cv2.polylines(picture, [points], False, (0.66, 0.63, 0.57), 22, cv2.LINE_AA, 4)


def _sunlight(heights: Array, shape: tuple[int, int]) -> Array:
    """Return how bright the ground is for its slope, the sun in the north-west."""
    import cv2

    fine = cv2.resize(heights[::-1], (shape[1], shape[0]), interpolation=cv2.INTER_CUBIC)
    south, east = np.gradient(fine, CELL / PIXELS)
    return np.asarray(np.clip(1 + 0.6 * (east + south) / np.sqrt(2), 0.6, 1.3))


def _cell(column: int, row: int, heights: Array, chart: Texture) -> list[Patch]:
    """Return the two triangles of a cell, with the part of the map that they show."""
    top = chart.shape[0] - 2 * BORDER - (row + 1) * PIXELS
    left = column * PIXELS
    side = PIXELS + 2 * BORDER
    texture = np.ascontiguousarray(chart[top : top + side, left : left + side])
    x, y = CELL * column, CELL * row
    corners = np.array([[x, y], [x + CELL, y], [x + CELL, y + CELL], [x, y + CELL]])
    z = heights[[row, row, row + 1, row + 1], [column, column + 1, column + 1, column]]
    sw, se, ne, nw = np.column_stack([corners, z])
    near, far = BORDER / side, (BORDER + PIXELS) / side
    grow, shift = side / PIXELS, BORDER / PIXELS
    patches = []
    for right, down, origin, outline in (
        (se - sw, se - ne, sw - (se - ne), [[near, far], [far, near], [far, far]]),
        (ne - nw, sw - nw, nw, [[near, near], [far, near], [near, far]]),
    ):
        begin = origin - shift * (right + down)
        patches.append(
            Patch(begin, grow * right, grow * down, texture, np.array(outline), one_sided=True)
        )
    return patches
