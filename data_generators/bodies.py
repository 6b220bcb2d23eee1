"""Things to build places of: houses, trees, lamps, boards on stands; and how they are painted."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array
from data_generators.scene import (
    Colour,
    Patch,
    Texture,
    box,
    check_texture,
    lit_patch,
    polygon,
    shaded,
)

SCALE = 40  # px of a facade's texture a metre
GLASS, FRAME, DOOR = (62, 84, 104), (238, 236, 230), (96, 62, 48)
WOOD, STEEL = (150, 112, 74), (74, 80, 88)


def at(x: float, y: float, z: float) -> Array:
    """Return a vector."""
    return np.array([x, y, z], float)


def solid(colour: Colour) -> Texture:
    """Return a texture of one colour."""
    return check_texture(np.array(colour))


def _rectangle(
    picture: Texture, left: float, top: float, size: tuple[float, float], c: Colour
) -> None:
    """Paint a rectangle given in metres."""
    x, y = round(left * SCALE), round(top * SCALE)
    picture[y : y + round(size[1] * SCALE), x : x + round(size[0] * SCALE)] = c


def facade(size: tuple[float, float], colour: Colour, rng: np.random.Generator) -> Texture:
    """Return the front of a house: plaster, rows of windows, a door.

    Parameters
    ----------
    size : tuple of float
        Width and height, m.
    colour : tuple of int
        Of the plaster.
    rng : numpy.random.Generator
        For the plaster's grain and the windows' brightness.

    Returns
    -------
    ndarray, shape (40 height, 40 width, 3), uint8
        The texture.
    """
    width, height = size
    shape = (round(height * SCALE), round(width * SCALE), 1)
    wall = np.array(colour) * (1 + 0.035 * rng.standard_normal(shape))
    picture = np.clip(wall, 0, 255).astype(np.uint8)
    _rectangle(picture, 0, height - 0.45, (width, 0.45), (128, 122, 116))
    floors, columns = max(1, int(height / 2.7)), max(1, int(width / 1.9))
    for floor in range(floors):
        for column in range(columns):
            left = (column + 0.5) * width / columns - 0.5
            top = height - 2.7 * floor - 2.25
            if floor == 0 and column == columns // 2:
                _door(picture, left, top, height)
            else:
                _window(picture, left, top, float(rng.uniform(0.75, 1.25)))
    return picture


def _window(picture: Texture, left: float, top: float, light: float) -> None:
    """Paint a window 1.0 m x 1.3 m with frame, crossbar and sill."""
    _rectangle(picture, left, top, (1.0, 1.3), FRAME)
    red, green, blue = (min(255, round(value * light)) for value in GLASS)
    for x, y, w, h in ((0.08, 0.08, 0.38, 0.4), (0.54, 0.08, 0.38, 0.4)):
        _rectangle(picture, left + x, top + y, (w, h), (red + 40, green + 45, blue + 50))
        _rectangle(picture, left + x, top + 0.56, (w, 0.66), (red, green, blue))
    _rectangle(picture, left - 0.08, top + 1.3, (1.16, 0.08), (205, 200, 192))


def _door(picture: Texture, left: float, top: float, height: float) -> None:
    """Paint a door down to the ground, with a window above."""
    _rectangle(picture, left - 0.05, top - 0.05, (1.1, height - top + 0.05), FRAME)
    _rectangle(picture, left + 0.05, top + 0.5, (0.9, height - top - 0.5), DOOR)
    _rectangle(picture, left + 0.05, top + 0.05, (0.9, 0.35), GLASS)
    _rectangle(picture, left + 0.8, top + 1.4, (0.07, 0.07), (225, 200, 120))


def roof_tiles(size: tuple[float, float], colour: Colour, rng: np.random.Generator) -> Texture:
    """Return rows of roof tiles, 20 px a metre; `size` is along the eaves and up the slope, m."""
    columns, rows = round(size[0] * 20), round(size[1] * 20)
    row, column = np.indices((rows, columns))
    course, within = np.divmod(row, 6)
    tone = rng.uniform(0.86, 1.08, (rows // 6 + 1, columns // 5 + 2))
    tone = tone[course, (column + 3 * (course % 2)) // 5]
    tone = np.where(within == 5, 0.72 * tone, tone)
    return np.asarray(np.clip(np.array(colour) * tone[..., None], 0, 255), np.uint8)


def house(
    corner: ArrayLike,
    size: tuple[float, float, float],
    colours: tuple[Colour, Colour],
    rng: np.random.Generator,
) -> list[Patch]:
    """Return a house with a gabled roof, its ridge along y.

    Parameters
    ----------
    corner : array_like, shape (3,)
        The corner on the ground with the smallest x and y, m.
    size : tuple of float
        Along x and y, and the height of the walls, m.
    colours : tuple of colours
        Of walls and roof.
    rng : numpy.random.Generator
        For the grain of the surfaces.

    Returns
    -------
    list of Patch
        Walls, gables, roof.
    """
    x, y, z = size
    wall, tiles = colours
    base = np.asarray(corner, float)
    gable_wall, long_wall = facade((x, z), wall, rng), facade((y, z), wall, rng)
    walls = box(base, size, [gable_wall, long_wall, gable_wall, long_wall], solid(wall))[:4]
    rise, over = 0.42 * x, 0.35
    south, north = base + at(0, 0, z), base + at(0, y, z)
    ridge = np.array([x / 2, 0, rise])
    gables = [
        polygon(
            [south, south + ridge, south + at(x, 0, 0)], _lit(wall, (0, -1, 0)), one_sided=True
        ),
        polygon([north + at(x, 0, 0), north + ridge, north], _lit(wall, (0, 1, 0)), one_sided=True),
    ]
    # Each slope from the ridge down past the wall, and past both gables.
    slope = np.array([x / 2 + over, 0, -rise * (1 + 2 * over / x)])
    along = np.array([0, y + 2 * over, 0])
    tile = roof_tiles((y + 2 * over, float(np.linalg.norm(slope))), tiles, rng)
    top = south + ridge - at(0, over, 0)
    east = lit_patch(top, along, slope, tile)
    west = lit_patch(top + along, -along, slope * at(-1, 1, 1), tile)
    return [*walls, *gables, east, west]


def _lit(colour: Colour, normal: ArrayLike) -> Array:
    """Return one colour as the sun lights it on a surface with this normal."""
    return np.asarray(shaded(np.array(colour), normal)[0, 0])


def lathe(
    centre: ArrayLike,
    profile: ArrayLike,
    colour: Colour,
    rng: np.random.Generator,
    sides: int = 9,
) -> list[Patch]:
    """Return a faceted body of revolution about the vertical, such as the crown of a tree.

    Parameters
    ----------
    centre : array_like, shape (3,)
        Where the axis meets height 0 of the profile, m.
    profile : array_like, shape (M, 2)
        Radius and height, m, from the bottom up; a radius of 0 makes a point.
    colour : tuple of int
        Of the surface; facets differ a little.
    rng : numpy.random.Generator
        For these differences.
    sides : int
        Facets around.

    Returns
    -------
    list of Patch
        The facets, visible from outside.
    """
    angle = np.arange(sides + 1) * 2 * np.pi / sides + 0.2
    ring = np.stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)], axis=1)
    rings = [np.asarray(centre) + r * ring + at(0, 0, z) for r, z in np.asarray(profile, float)]
    facets = []
    for low, high in pairwise(rings):
        for i in range(sides):
            corners = [low[i], high[i], high[i + 1], low[i + 1]]
            distinct = [
                c for c, d in zip(corners, np.roll(corners, 1, 0), strict=True) if (c != d).any()
            ]
            normal = np.cross(distinct[1] - distinct[0], distinct[-1] - distinct[0])
            tone = _lit(colour, -normal / np.linalg.norm(normal)) * rng.uniform(0.93, 1.07)
            facets.append(polygon(distinct, np.clip(tone, 0, 255).astype(int), one_sided=True))
    bottom = _lit(colour, (0, 0, -1))
    facets.append(polygon(rings[0][:-1], bottom.astype(int), one_sided=True))
    return facets


def leafy_tree(foot: ArrayLike, height: float, rng: np.random.Generator) -> list[Patch]:
    """Return a tree with a round crown; `foot` is where it stands, lengths in m."""
    base, r = np.asarray(foot, float), 0.27 * height
    trunk = box(
        base - at(0.12, 0.12, 0), (0.24, 0.24, 0.36 * height), solid((112, 84, 60)), solid(WOOD)
    )
    crown = [(0.55 * r, 0.36), (r, 0.52), (0.95 * r, 0.72), (0.5 * r, 0.94), (0, 1.0)]
    profile = [(radius, share * height) for radius, share in crown]
    return [*trunk[:4], *lathe(base, profile, (104, 146, 66), rng)]


def fir(foot: ArrayLike, height: float, rng: np.random.Generator) -> list[Patch]:
    """Return a fir: a trunk and a cone; `foot` is where it stands, lengths in m."""
    base = np.asarray(foot, float)
    trunk = box(base - at(0.1, 0.1, 0), (0.2, 0.2, 0.15 * height), solid((96, 72, 54)), solid(WOOD))
    profile = [(0.2 * height, 0.15 * height), (0.0, height)]
    return [*trunk[:4], *lathe(base, profile, (62, 112, 78), rng, 7)]


def lamp(foot: ArrayLike, height: float = 5.0, reach: float = -1.4) -> list[Patch]:
    """Return a street lamp whose arm reaches along x; lengths in m."""
    base, steel = np.asarray(foot, float), solid(STEEL)
    post = box(base - at(0.06, 0.06, 0), (0.12, 0.12, height), steel, steel)
    start = min(0.0, reach) + (-0.06 if reach < 0 else 0.06)
    arm = box(base + at(start, -0.04, height), (abs(reach), 0.08, 0.08), steel, steel)
    head = box(
        base + at(reach - 0.25, -0.12, height - 0.14),
        (0.5, 0.24, 0.14),
        steel,
        solid((235, 225, 190)),
    )
    return [*post, *arm, *head]


def board(
    foot: ArrayLike,
    texture: ArrayLike,
    size: tuple[float, float],
    turn: float = 0.0,
    lift: float = 0.6,
) -> list[Patch]:
    """Return a picture on two legs.

    Parameters
    ----------
    foot : array_like, shape (3,)
        The middle between the legs, m.
    texture : array_like
        What is on it.
    size : tuple of float
        Width and height of the picture, m.
    turn : float
        Rotation about the vertical, rad; at 0 it is seen from the south.
    lift : float
        Height of its lower edge, m.

    Returns
    -------
    list of Patch
        The picture first, then its back and the legs.
    """
    base, (width, height) = np.asarray(foot, float), size
    along = np.array([np.cos(turn), np.sin(turn), 0.0])
    back = np.array([-np.sin(turn), np.cos(turn), 0.0])
    corner = base - along * width / 2 + at(0, 0, lift + height)
    front = Patch(
        corner, along * width, np.array([0, 0, -height]), np.asarray(texture), one_sided=True
    )
    rear = lit_patch(corner + along * width, -along * width, np.array([0, 0, -height]), solid(WOOD))
    legs: list[Patch] = []
    for side in (-0.4, 0.4):
        stand = base + along * side * width - along * 0.025 + back * 0.03
        legs += box(stand, (0.05, 0.05, lift + 0.6 * height), solid(WOOD), solid(WOOD), turn)
    return [front, rear, *legs]
