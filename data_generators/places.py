"""Ready places to photograph: a street with houses and trees, and the cameras that stand in it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera, camera_at, first_guess_intrinsics
from course_lib.checks import Array
from data_generators.bodies import at, board, fir, house, lamp, leafy_tree, solid
from data_generators.scene import Patch, Scene, Texture
from data_generators.targets import checkerboard, letter_chart, siemens_star

SUN = np.array([-0.5, -0.6, 0.8])
ROAD, KERB, WALK, STREET_END = 3.0, 3.2, 5.2, 150.0  # m: half widths, and how far it is detailed
FAR = 900.0  # m: the hills
GRASS, ASPHALT, SLABS = (126, 158, 88), (112, 114, 118), (176, 170, 160)
HAZE, ZENITH = (214, 228, 238), (118, 168, 214)

HOUSES = (  # west or east, start and length along y, depth, height of the walls, colours
    (-1, 5.0, 8.0, 8.0, 5.6, (222, 184, 128), (158, 78, 58)),
    (-1, 16.5, 9.0, 7.5, 5.4, (196, 108, 88), (92, 96, 104)),
    (-1, 29.0, 8.0, 8.0, 8.2, (232, 222, 200), (150, 84, 64)),
    (-1, 41.0, 11.0, 8.0, 5.4, (150, 176, 184), (100, 92, 92)),
    (-1, 56.0, 9.0, 8.0, 5.6, (224, 196, 150), (150, 74, 58)),
    (1, 7.5, 9.0, 8.0, 5.5, (158, 180, 196), (96, 98, 106)),
    (1, 20.5, 8.0, 7.5, 8.2, (236, 226, 206), (162, 84, 62)),
    (1, 32.0, 10.0, 8.0, 5.4, (212, 150, 108), (120, 70, 60)),
    (1, 46.0, 9.0, 8.0, 5.6, (188, 200, 158), (104, 98, 98)),
    (1, 59.0, 10.0, 8.0, 8.2, (228, 200, 160), (152, 80, 60)),
)
TREES = (
    (-4.2, 15.0, 5.6),
    (-4.2, 28.0, 6.4),
    (-4.2, 54.0, 5.8),
    (7.6, 18.6, 5.0),
    (-4.2, 72.0, 6.0),
)
FIRS = ((-8.5, 14.8, 7.0), (8.5, 43.5, 8.0), (9.0, 72.5, 9.0), (-9.0, 68.0, 8.0), (6.5, 76.0, 6.5))
LAMPS = (9.0, 23.0, 37.0, 51.0, 65.0)


def street(rng: np.random.Generator | None = None, targets: bool = True) -> Scene:
    """Return a street that runs north, with houses, trees, lamps and hills behind.

    Parameters
    ----------
    rng : numpy.random.Generator, optional
        For the grain of the surfaces; the same street every time without one.
    targets : bool
        Whether a checkerboard, a letter chart and a star stand in the foreground.

    Returns
    -------
    Scene
        World: x east, y north, z up, m. The road's middle is x = 0 and its surface z = 0.
    """
    rng = np.random.default_rng(2026) if rng is None else rng
    bodies: list[list[Patch]] = []
    for side, start, length, depth, height, wall, roof in HOUSES:
        corner = at(6.6 if side > 0 else -6.6 - depth, start, 0)
        bodies.append(house(corner, (depth, length, height), (wall, roof), rng))
    bodies += [leafy_tree(at(x, y, 0), height, rng) for x, y, height in TREES]
    bodies += [fir(at(x, y, 0), height, rng) for x, y, height in FIRS]
    bodies += [lamp(at(4.1, y, 0)) for y in LAMPS]
    if targets:
        bodies += foreground_targets(rng)
    outlines = [outline for body in bodies for outline in shadows(body)]
    patches = [*ground(outlines, rng), *backdrop(rng)]
    return Scene((*patches, *(patch for body in bodies for patch in body)), ZENITH)


def foreground_targets(rng: np.random.Generator) -> list[list[Patch]]:
    """Return a checkerboard, a letter chart and a Siemens star on stands, a few metres north."""
    return [
        board(at(-1.7, 2.4, 0), checkerboard(9, 7, 32), (1.3, 1.04), turn=0.28),
        board(at(1.75, 5.0, 0), letter_chart(512, 7, rng=rng), (1.2, 1.2), turn=-0.12),
        board(at(3.2, 3.9, 0), siemens_star(384, 36), (1.1, 1.1), turn=-0.35),
    ]


def street_camera(
    image_size: tuple[int, int] = (640, 480),
    f: float = 28.0,
    sensor_size: tuple[float, float] = (36.0, 27.0),
    eye: tuple[float, float, float] = (0.5, -3.5, 1.65),
    target: tuple[float, float, float] = (0.1, 30.0, 3.0),
) -> Camera:
    """Return a camera in the street, at eye level.

    Parameters
    ----------
    image_size : tuple of int
        Width and height, px.
    f : float
        Focal length, mm.
    sensor_size : tuple of float
        Width and height, mm.
    eye, target : tuple of float
        Where the camera stands and what it looks at, m.

    Returns
    -------
    Camera
        The camera.

    Raises
    ------
    TypeError, ValueError
        As `first_guess_intrinsics` and `look_at`.
    """
    K = first_guess_intrinsics(f, sensor_size, image_size)
    return camera_at(eye, target, K, image_size)


def shadows(body: list[Patch]) -> list[Array]:
    """Return the outlines of the shadows that the faces of a body cast on the ground, (M, 2), m."""
    cast = []
    for patch in body:
        corners = patch.corners
        cast.append(corners[:, :2] - corners[:, 2:] * SUN[:2] / SUN[2])
    return cast


def ground(outlines: list[Array], rng: np.random.Generator) -> list[Patch]:
    """Return the ground: the street in detail near by and coarser farther away, and meadows."""
    near = painted_ground((-12, -8, 12, 32), 32, outlines, rng)
    middle = painted_ground((-12, 32, 12, STREET_END), 8, outlines, rng)
    plain = [(-FAR, -FAR, -12, FAR), (12, -FAR, FAR, FAR), (-12, -FAR, 12, -8)]
    north = [
        (-12, STREET_END, -ROAD, FAR, GRASS),
        (-ROAD, STREET_END, ROAD, FAR, ASPHALT),
        (ROAD, STREET_END, 12, FAR, GRASS),
    ]
    rest = [(*box, GRASS) for box in plain] + north
    return [near, middle, *(_flat(box[:4], solid(box[4])) for box in rest)]


def _flat(box: tuple[float, float, float, float], texture: Texture) -> Patch:
    """Return a level patch from west, south, east, north; its texture's top is north."""
    west, south, east, north = box
    return Patch(at(west, north, 0), at(east - west, 0, 0), at(0, south - north, 0), texture)


def painted_ground(
    box: tuple[float, float, float, float],
    scale: int,
    outlines: list[Array],
    rng: np.random.Generator,
) -> Patch:
    """Return a level patch with road, markings, pavement, grass and shadows painted on it.

    Parameters
    ----------
    box : tuple of float
        West, south, east, north, m.
    scale : int
        Texture px a metre.
    outlines : list of ndarray, shape (M, 2)
        Outlines of shadows, m.
    rng : numpy.random.Generator
        For the grain.

    Returns
    -------
    Patch
        The patch.
    """
    west, south, east, north = box
    columns, rows = round((east - west) * scale), round((north - south) * scale)
    x = west + (np.arange(columns)[None, :] + 0.5) / scale
    y = north - (np.arange(rows)[:, None] + 0.5) / scale
    x, y = np.broadcast_arrays(x, y)
    across = np.abs(x)
    colour = np.empty((rows, columns, 3))
    colour[:] = GRASS
    colour[across < WALK] = SLABS
    joint = ((across - KERB) % 1.0 < 0.04) | (y % 1.0 < 0.04)
    colour[(across < WALK) & joint] = (140, 135, 128)
    colour[across < KERB] = (206, 202, 196)
    colour[across < ROAD] = ASPHALT
    dashes = (across < 0.07) & (y % 4.0 < 2.2)
    edges = np.abs(across - ROAD + 0.3) < 0.05
    colour[dashes | edges] = (236, 236, 230)
    grain = np.where(across < WALK, 0.05, 0.10) * rng.standard_normal((rows, columns))
    shade = _shadow_mask(outlines, box, scale, (rows, columns))
    light = (1 + grain * min(1, scale / 24)) * (1 - 0.42 * shade)
    return _flat(box, np.clip(colour * light[..., None], 0, 255).astype(np.uint8))


def _shadow_mask(
    outlines: list[Array],
    box: tuple[float, float, float, float],
    scale: int,
    shape: tuple[int, int],
) -> NDArray[np.float32]:
    """Return where the ground lies in shadow, 0 to 1, with a soft edge."""
    import cv2

    mask = np.zeros(shape, np.uint8)
    for outline in outlines:
        pixels = (outline - (box[0], box[3])) * (scale, -scale) - 0.5
        hull = cv2.convexHull(pixels.astype(np.float32))
        cv2.fillConvexPoly(mask, np.rint(hull * 16).astype(np.int32), 255, cv2.LINE_AA, 4)
    soft = cv2.GaussianBlur(mask, (0, 0), 0.06 * scale + 0.3)
    return np.asarray(soft / np.float32(255), np.float32)


def backdrop(rng: np.random.Generator) -> list[Patch]:
    """Return hills and sky around the place, on eight upright panels."""
    patches = []
    angle = np.arange(9) * np.pi / 4 + np.pi / 8
    corners = FAR / np.cos(np.pi / 8) * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    hills, sky = 130.0, 1000.0
    phases = rng.uniform(0, 2 * np.pi, (3, 12))
    for left, right, start in zip(corners[1:], corners[:-1], angle[:-1], strict=True):
        azimuth = start + np.pi / 4 * (1 - (np.arange(1024) + 0.5) / 1024)
        texture = _hills(azimuth, hills, phases)
        patches.append(Patch(left + at(0, 0, hills), right - left, at(0, 0, -hills), texture))
        up = np.linspace(sky, hills, 128)[:, None]
        gradient = np.repeat(_sky(up)[:, None], 2, axis=1).reshape(128, 2, 3)
        patches.append(Patch(left + at(0, 0, sky), right - left, at(0, 0, hills - sky), gradient))
    return patches


def _sky(height: Array) -> Texture:
    """Return the colour of the sky at heights on the backdrop, m."""
    share = np.clip(height / 1000.0, 0, 1)[..., None] ** 0.6
    return np.asarray(np.rint(np.array(HAZE) * (1 - share) + np.array(ZENITH) * share), np.uint8)


def _hills(azimuth: Array, top: float, phases: Array) -> Texture:
    """Return three ranges of hills before the sky, the farthest the palest."""
    up = top * (1 - (np.arange(256) + 0.5) / 256)
    picture = np.repeat(_sky(up)[:, None], len(azimuth), axis=1)
    ranges = ((62, 24, (176, 198, 206)), (40, 16, (146, 176, 164)), (20, 7, (112, 148, 104)))
    waves = np.arange(3, 15)
    for (height, swing, colour), phase in zip(ranges, phases, strict=True):
        wave = np.sin(waves * azimuth[:, None] + phase) / np.sqrt(waves)
        ridge = height + swing * wave.sum(axis=1) / np.sqrt(3)
        share = np.clip((ridge - up[:, None]) / (top / 256) + 0.5, 0, 1)[..., None]
        picture = np.rint(picture * (1 - share) + np.array(colour) * share).astype(np.uint8)
    return picture
