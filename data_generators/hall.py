"""A measurement hall: a plain room with targets on its walls and parts to measure on its floor."""

from __future__ import annotations

import numpy as np

from course_lib.camera import Camera, camera_at, first_guess_intrinsics
from data_generators.bodies import at, board, solid
from data_generators.scene import Patch, Scene, Texture, box, check_texture, lit_patch
from data_generators.targets import bar_target, checkerboard, dot_grid

WIDTH, DEPTH, HEIGHT = 10.0, 12.0, 4.5  # m: x from -5 to 5, y from 0 to 12
WALL, FLOOR, JOINT = (214, 216, 214), (158, 164, 168), (128, 134, 138)
PARTS = (  # corner, size, turn, colour of the crates
    ((-3.4, 7.2, 0), (1.4, 1.0, 1.1), 0.25, (198, 142, 70)),
    ((-3.1, 7.5, 1.1), (0.8, 0.7, 0.7), 0.45, (84, 132, 168)),
    ((1.9, 6.4, 0), (1.0, 1.0, 1.9), -0.35, (96, 146, 112)),
    ((0.2, 9.3, 0), (2.2, 0.9, 0.8), 0.05, (178, 92, 78)),
)


def hall(rng: np.random.Generator | None = None) -> Scene:
    """Return the hall.

    Parameters
    ----------
    rng : numpy.random.Generator, optional
        For the grain of the floor; the same hall every time without one.

    Returns
    -------
    Scene
        World: x to the right, y into the hall, z up, m. The floor is z = 0.
    """
    rng = np.random.default_rng(7) if rng is None else rng
    patches = _room(rng)
    for corner, size, turn, colour in PARTS:
        x, y, z = size
        front, side = crate(colour, (x, z)), crate(colour, (y, z))
        sides = [front, side, front, side]
        patches += box(corner, size, sides, crate(colour, (x, y)), turn)
    patches += board(at(-0.9, 5.2, 0), checkerboard(9, 7, 40), (1.35, 1.05), turn=0.15)
    patches += board(at(1.0, 7.6, 0), bar_target(384), (0.9, 0.9), turn=-0.1)
    return Scene(tuple(patches), WALL)


def _room(rng: np.random.Generator) -> list[Patch]:
    """Return floor, three walls with dots on them, and ceiling."""
    west, east = -WIDTH / 2, WIDTH / 2
    along, into, down = at(WIDTH, 0, 0), at(0, DEPTH, 0), at(0, 0, -HEIGHT)
    dots = np.minimum(dot_grid(10, 4, 64, 0.16), 216)
    side_dots = np.minimum(dot_grid(12, 4, 64, 0.16), 216)
    return [
        Patch(at(west, DEPTH, 0), along, -into, tiles(rng), repeat=(5.0, 6.0)),
        Patch(at(west, 0, HEIGHT), along, into, solid((232, 233, 232))),
        Patch(at(west, DEPTH, HEIGHT), along, down, dots),
        lit_patch(at(west, 0, HEIGHT), into, down, side_dots),
        lit_patch(at(east, DEPTH, HEIGHT), -into, down, side_dots),
    ]


def tiles(rng: np.random.Generator) -> Texture:
    """Return 2 m x 2 m of floor: four slabs with joints, 128 px a metre."""
    grain = 1 + 0.03 * rng.standard_normal((256, 256, 1))
    picture = np.clip(np.array(FLOOR) * grain, 0, 255)
    row, column = np.indices((256, 256))
    picture[(row % 128 < 2) | (column % 128 < 2)] = JOINT
    return picture.astype(np.uint8)


def crate(colour: tuple[int, int, int], size: tuple[float, float]) -> Texture:
    """Return a side of a crate, 96 px a metre: planks, a frame, a round mark near each corner."""
    columns, rows = round(size[0] * 96), round(size[1] * 96)
    picture = np.empty((rows, columns, 3))
    picture[:] = colour
    row, column = np.indices((rows, columns))
    right, below = columns - 1 - column, rows - 1 - row
    picture[row % 24 < 2] *= 0.75
    picture[np.minimum.reduce([row, column, right, below]) < 6] *= 0.8
    # Distance from the nearest of four marks, 20 px from both edges.
    distance = np.hypot(np.minimum(row, below) - 20, np.minimum(column, right) - 20)
    picture[distance < 9] = 238
    picture[distance < 4.5] = 20
    return check_texture(picture.astype(np.uint8))


def hall_camera(
    image_size: tuple[int, int] = (640, 480),
    f: float = 24.0,
    sensor_size: tuple[float, float] = (36.0, 27.0),
) -> Camera:
    """Return a camera near the door of the hall, a little above eye level.

    Parameters
    ----------
    image_size : tuple of int
        Width and height, px.
    f : float
        Focal length, mm.
    sensor_size : tuple of float
        Width and height, mm.

    Returns
    -------
    Camera
        The camera.

    Raises
    ------
    TypeError, ValueError
        As `first_guess_intrinsics`.
    """
    K = first_guess_intrinsics(f, sensor_size, image_size)
    return camera_at((0.8, 0.6, 1.9), (-0.1, 8.0, 1.1), K, image_size)
