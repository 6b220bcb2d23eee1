"""A glazed vase on a turntable: faceted, with a pattern that fits from facet to facet.

The axis is that of z; the plate is at height 0. Units are metres.
"""

from __future__ import annotations

import numpy as np

from course_lib.checks import Array
from data_generators.patterns import as_texture, clouds, spots, target
from data_generators.scene import Patch, Scene, Texture, polygon

HEIGHT = 0.3
SIDES, RINGS = 36, 15
PLATE = 0.2  # radius
#: px of the glaze around and along the axis, and of the plate.
GLAZE = 1080, 450
PLATE_PIXELS = 600
#: A facet's texture goes on beyond its border by this share, so that the border does not show.
MARGIN = 0.15
#: Survey marks: facets of the vase (around, along), and angles and radii on the plate.
ON_VASE = [(4, 3), (13, 2), (22, 3), (31, 2), (0, 10), (9, 11), (18, 10), (27, 11)]
ON_PLATE = [(np.pi * (0.25 + 0.5 * k), 0.165) for k in range(4)]


def radius(height: Array) -> Array:
    """Return the radius of the vase at heights."""
    return np.asarray(0.09 + 0.03 * np.sin(2 * np.pi * height / HEIGHT))


def vase(rng: np.random.Generator) -> tuple[Scene, Array]:
    """Return the vase on its plate, and the middles of its survey marks.

    Parameters
    ----------
    rng : numpy.random.Generator
        For the pattern.

    Returns
    -------
    scene : Scene
        540 facets, the rim and the plate.
    marks : ndarray, shape (12, 3)
        Eight on the vase, four on the plate.
    """
    glaze, places = _glaze(rng)
    facets = [_facet(side, ring, glaze) for side in range(SIDES) for ring in range(RINGS)]
    inside = polygon(_ring(HEIGHT)[::-1], (6, 5, 5))
    plate, on_plate = _plate(rng)
    return Scene((plate, inside, *facets), (196, 200, 206)), np.concatenate([places, on_plate])


def _glaze(rng: np.random.Generator) -> tuple[Array, Array]:
    """Return the glaze unrolled, with marks, and where these are in space."""
    shape = GLAZE[1], GLAZE[0]
    warm = clouds(rng, shape, (6, 12, 30), wrap=True)[..., None]
    fine = clouds(rng, shape, (1.2, 2.2, 4), wrap=True)[..., None]
    blue, sand = np.array([0.22, 0.42, 0.62]), np.array([0.80, 0.66, 0.46])
    share = 1 / (1 + np.exp(-4 * warm))
    picture = np.ascontiguousarray(blue * share + sand * (1 - share) + 0.07 * fine)
    spots(picture, rng, 260, (1.5, 7), np.array([0.45, 0.22, 0.16]))
    spots(picture, rng, 160, (1.5, 5), np.array([0.88, 0.86, 0.76]))
    px = GLAZE[0] / SIDES, GLAZE[1] / RINGS
    places = []
    for side, ring in ON_VASE:
        target(picture, (side + 0.5) * px[0] - 0.5, (ring + 0.5) * px[1] - 0.5, 7)
        places.append(_corners(side, ring).mean(axis=0))
    return picture, np.array(places)


def _ring(height: float) -> Array:
    """Return the corners of the vase at a height, shape (SIDES, 3)."""
    angle = 2 * np.pi * np.arange(SIDES) / SIDES
    r = float(radius(np.array(height)))
    return np.stack([r * np.cos(angle), r * np.sin(angle), np.full(SIDES, height)], axis=1)


def _corners(side: int, ring: int) -> Array:
    """Return a facet's corners: top left, top right, bottom right, bottom left, from outside."""
    high = _ring(HEIGHT * (1 - ring / RINGS))
    low = _ring(HEIGHT * (1 - (ring + 1) / RINGS))
    after = (side + 1) % SIDES
    return np.array([high[side], high[after], low[after], low[side]])


def _facet(side: int, ring: int, glaze: Array) -> Patch:
    """Return a facet with its part of the glaze."""
    corners = _corners(side, ring)
    top, bottom = corners[1] - corners[0], corners[2] - corners[3]
    widths = float(np.linalg.norm(top)), float(np.linalg.norm(bottom))
    full = max(widths) * (1 + 2 * MARGIN)
    upper, lower = corners[:2].mean(axis=0), corners[2:].mean(axis=0)
    down = (lower - upper) * (1 + 2 * MARGIN)
    right = full * top / widths[0]
    origin = upper - MARGIN * (lower - upper) - right / 2
    begin, end = MARGIN / (1 + 2 * MARGIN), (1 + MARGIN) / (1 + 2 * MARGIN)
    near = 0.5 + np.array([-0.5, 0.5]) * np.array(widths)[:, None] / full
    outline = [[near[0, 0], begin], [near[0, 1], begin], [near[1, 1], end], [near[1, 0], end]]
    texture = _cut(glaze, side, ring, widths, full)
    return Patch(origin, right, down, texture, np.array(outline), one_sided=True)


def _cut(glaze: Array, side: int, ring: int, widths: tuple[float, float], full: float) -> Texture:
    """Return the part of the glaze that a facet shows, stretched to its width at each height."""
    import cv2

    rows, columns = round(30 * (1 + 2 * MARGIN)), round(30 * (1 + 2 * MARGIN))
    a, b = (np.arange(columns) + 0.5) / columns, (np.arange(rows) + 0.5) / rows
    along = b * (1 + 2 * MARGIN) - MARGIN
    width = np.clip(widths[0] + (widths[1] - widths[0]) * along, 1e-3, None)
    across = 0.5 + (a - 0.5) * full / width[:, None]
    u = (side + across) * GLAZE[0] / SIDES - 0.5
    v = np.broadcast_to(((ring + along) * GLAZE[1] / RINGS - 0.5)[:, None], u.shape)
    v = np.clip(v, 0, GLAZE[1] - 1)
    maps = (u % GLAZE[0]).astype(np.float32), v.astype(np.float32)
    picture = cv2.remap(glaze, *maps, cv2.INTER_LINEAR, borderMode=cv2.BORDER_WRAP)
    return as_texture(np.asarray(picture))


def _plate(rng: np.random.Generator) -> tuple[Patch, Array]:
    """Return the turntable's plate with its marks, and where these are."""
    n = PLATE_PIXELS
    tone = clouds(rng, (n, n), (1.5, 3, 8, 20))[..., None]
    picture = np.ascontiguousarray(np.array([0.52, 0.5, 0.46]) + 0.09 * tone)
    spots(picture, rng, 220, (2, 8), np.array([0.3, 0.34, 0.3]))
    places = []
    for angle, r in ON_PLATE:
        x, y = r * np.cos(angle), r * np.sin(angle)
        target(picture, (x / PLATE + 1) * n / 2 - 0.5, (1 - y / PLATE) * n / 2 - 0.5, 10)
        places.append([x, y, 0.0])
    turn = 2 * np.pi * np.arange(48) / 48
    outline = 0.5 + 0.5 * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    origin, right, down = np.array([[-1, 1, 0], [2, 0, 0], [0, -2, 0]]) * PLATE
    return Patch(origin, right, down, as_texture(picture), outline), np.array(places)
