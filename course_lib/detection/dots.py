"""Grids of separate dark shapes: round dots, or squares whose corners are wanted."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from course_lib.boards import DotGrid, SquareGrid
from course_lib.checks import Array
from course_lib.detection.lattices import grid_of_loose_points, turned
from course_lib.detection.reasons import part_of_board, too_blurred
from course_lib.detection.result import (
    Detection,
    Grey,
    Picture,
    Problem,
    grey_picture,
    in_full_size,
    nothing,
    smaller_pictures,
)

#: Smallest area of a dot, px, and the largest by the picture's.
SMALLEST, LARGEST = 12.0, 0.02
#: Area by that of an ellipse with the same spread: 1 for ellipses, 0.955 for squares.
ROUND = (0.88, 1.1)
#: Sizes of the surroundings that a dot must be darker than, by the picture's height.
SURROUNDINGS = (0.12, 0.3, 0.06)
DARKER = 12  # grey levels
#: How much of a grid must be there.
MOST = 0.85
#: How far a dot and the paper around it reach, by its own radius; and px of blur on top.
DOT, PAPER, EDGE = 1.1, 1.7, 2.0
NEIGHBOURS = 8


class Blobs(NamedTuple):
    """Dark shapes."""

    middles: Array  # shape (N, 2), px
    spreads: Array  # shape (N, 2, 2): of an ellipse, a quarter of its axes' squares


def detect_dots(image: ArrayLike, board: DotGrid) -> Detection:
    """Return the dots' centroids; see `course_lib.detection.detect_board`."""
    grey = grey_picture(image)
    grid, blobs = find_grid(grey, board)
    if grid is None:
        return why_no_grid(grey, blobs, board)
    there = grid[..., 2].ravel() >= 0
    which = grid[..., 2].ravel()[there].astype(int)
    points, blur = centroids(grey, Blobs(blobs.middles[which], blobs.spreads[which]))
    ids, lost = np.flatnonzero(there), int((~there).sum())
    rest = f" {len(ids)} of {len(there)} dots are usable." if lost else ""
    usual = np.median(blur)
    width = 4 * np.median(np.linalg.det(blobs.spreads[which])) ** 0.25
    problem: Problem = ""
    said = f"All {board.name} found."
    if too_blurred(float(usual), float(width), grey.shape):
        problem, said = "blurred", f"The dots were found, but blurred over {2.5 * usual:.0f} px."
        said += f"{rest} Hold the camera still, focus, and take it again."
    elif lost:
        problem = "covered" if lost > 0.05 * len(there) else ""
        said = f"The dots were found, but some are hidden or washed out.{rest}"
    return Detection(True, points, ids, problem, said, float(usual))


def find_grid(grey: Picture, board: DotGrid | SquareGrid) -> tuple[Array | None, Blobs]:
    """Return a grid in the board's order and its shapes; without the grid, the shapes of a part.

    The grid has shape (rows, columns, 3): u and v in px and the number of the shape; NaN and -1
    where there is none.
    """
    best = Blobs(np.empty((0, 2)), np.empty((0, 2, 2)))
    for picture, ratio in smaller_pictures(grey):
        for surroundings in SURROUNDINGS:
            blobs = dark_shapes(picture, surroundings)
            places = grid_of_loose_points(blobs.middles, _areas(blobs))
            mine = Blobs(in_full_size(blobs.middles, ratio), blobs.spreads * ratio[:, None] * ratio)
            grid = _board_of(places, mine.middles, board)
            if grid is not None:
                return grid, mine
            if len(places) > len(best.middles):
                which = list(places.values())
                best = Blobs(mine.middles[which], mine.spreads[which])
    return None, best


def dark_shapes(picture: Grey, surroundings: float) -> Blobs:
    """Return the shapes that are darker than their surroundings and as full as ellipses."""
    import cv2

    size = int(surroundings * picture.shape[0]) // 2 * 2 + 3
    dark = cv2.adaptiveThreshold(
        picture, 255, cv2.ADAPTIVE_THRESH_MEAN_C, cv2.THRESH_BINARY_INV, size, DARKER
    )
    contours, _ = cv2.findContours(dark, cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
    limit, middles, spreads = LARGEST * picture.size, [], []
    for contour in contours:
        m = cv2.moments(contour)
        if not SMALLEST <= m["m00"] <= limit:
            continue
        spread = np.array([[m["mu20"], m["mu11"]], [m["mu11"], m["mu02"]]]) / m["m00"]
        full = m["m00"] / (4 * np.pi * np.sqrt(max(np.linalg.det(spread), 1e-9)))
        if ROUND[0] < full < ROUND[1]:
            middles.append((m["m10"] / m["m00"], m["m01"] / m["m00"]))
            spreads.append(spread)
    return Blobs(np.array(middles).reshape(-1, 2), np.array(spreads).reshape(-1, 2, 2))


def _areas(shapes: Blobs) -> Array:
    return np.asarray(np.sqrt(np.linalg.det(shapes.spreads)))


def _board_of(
    places: dict[tuple[int, int], int], points: Array, board: DotGrid | SquareGrid
) -> Array | None:
    """Return the grid of `find_grid`, if these places have its size and are nearly all taken."""
    if not places:
        return None
    rows, columns = (1 + max(place[k] for place in places) for k in (0, 1))
    if sorted((rows, columns)) != sorted((board.rows, board.columns)):
        return None
    if len(places) < MOST * rows * columns:
        return None
    grid = np.full((rows, columns, 3), np.nan)
    grid[..., 2] = -1
    for place, number in places.items():
        grid[place] = *points[number], number
    return turned(grid, board.columns, board.rows)


def centroids(grey: Picture, blobs: Blobs) -> tuple[Array, Array]:
    """Return the centroids of dots, weighted by how dark their pixels are, and their blurs, px."""
    points, blurs = np.empty_like(blobs.middles), np.empty(len(blobs.middles))
    for i, middle in enumerate(blobs.middles):
        near = np.argsort(np.linalg.norm(blobs.middles - middle, axis=1))[: 1 + NEIGHBOURS]
        points[i], blurs[i] = _centroid(grey, Blobs(blobs.middles[near], blobs.spreads[near]))
    return points, blurs


def _centroid(grey: Picture, dots: Blobs) -> tuple[Array, float]:
    """Return the centroid of the first of some dots, the others being near, and its blur."""
    middle, spread = dots.middles[0], dots.spreads[0]
    reach = np.ceil(PAPER * 2 * np.sqrt(np.diagonal(spread)) + 2).astype(int)
    first = np.maximum(np.rint(middle).astype(int) - reach, 0)
    window = grey[first[1] : first[1] + 2 * reach[1] + 1, first[0] : first[0] + 2 * reach[0] + 1]
    window = window.astype(float)
    v, u = np.indices(window.shape)
    places = np.stack([u + first[0], v + first[1]], axis=-1)
    radii = np.stack([_radii(places, *dot) for dot in zip(*dots, strict=True)])
    # What is nearer to a neighbour is its own.
    mine = radii[0] < radii[1:].min(axis=0, initial=np.inf)
    dot, paper = mine & (radii[0] <= 1), (radii > 1).all(axis=0)
    if paper.sum() < 6:
        return middle, 0.0
    from_middle = places - middle
    plane = np.column_stack([np.ones(paper.sum()), from_middle[paper]])
    level = np.linalg.lstsq(plane, window[paper], rcond=None)[0]
    darkness = np.where(dot, level[0] + from_middle @ level[1:] - window, 0)
    down, across = np.gradient(window)
    steepest = np.percentile(np.hypot(down, across)[dot], 97)
    contrast = np.percentile(darkness[dot], 75)
    # A step of height c blurred by s is steepest with c / (s √(2 π)).
    blur = contrast / (np.sqrt(2 * np.pi) * max(steepest, 1e-9))
    weight = darkness / max(darkness.sum(), 1e-9)
    return middle + np.einsum("vu,vui->i", weight, from_middle), float(blur)


def _radii(places: Array, middle: Array, spread: Array) -> Array:
    """Return how far places are from a dot: 1 where its blurred edge surely ends."""
    from_middle = places - middle
    inverse = np.linalg.inv(spread)
    # The outline is where dᵀ S⁻¹ d = 4; beyond it comes the blur.
    radius = np.sqrt(np.einsum("vui,ij,vuj->vu", from_middle, inverse, from_middle))
    return np.asarray(radius / (2 * DOT + EDGE / np.sqrt(np.linalg.eigvalsh(spread)[0])))


def why_no_grid(grey: Picture, part: Blobs, board: DotGrid | SquareGrid) -> Detection:
    """Return a detection without points that says what was seen instead."""
    if (other := _checkerboard_instead(grey, board)) is not None:
        return other
    places = grid_of_loose_points(part.middles, _areas(part))
    if len(places) < 9:
        return nothing(
            "no board",
            f"No grid was found: neither {board.name}, nor others. All of it must be visible, "
            "dark on light, evenly lit and sharp.",
        )
    rows, columns = (1 + max(place[k] for place in places) for k in (0, 1))
    said = f"Saw about {columns} × {rows} instead of {board.name}"
    apart = np.linalg.norm(part.middles[:, None] - part.middles, axis=2)
    margin = 0.9 * np.median(np.sort(apart, axis=1)[:, 1])  # the next ones would be outside
    limit = np.array(grey.shape)[::-1] - 1 - margin
    at_edge = ((part.middles < margin) | (part.middles > limit)).any(axis=1)
    if at_edge.any() and len(places) < board.rows * board.columns:
        return nothing(
            "cut off",
            f"{said}, up to the edge of the picture. All of it must be in the picture.",
            (columns, rows),
        )
    said += ". Count them; if the count is right, some are hidden."
    return nothing("wrong size", said, (columns, rows))


def _checkerboard_instead(grey: Picture, board: DotGrid | SquareGrid) -> Detection | None:
    """Return that there is a checkerboard in the picture, or None if there is none."""
    seen = part_of_board(grey, once=True)
    if seen is None:
        return None
    rows, columns = sorted(seen.grid.shape[:2])
    said = f"This looks like a checkerboard of {columns} × {rows} corners, not {board.name}."
    return nothing("other kind", said, (columns, rows))
