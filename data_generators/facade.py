"""The front of a house, photographed at a slant: every window and the wall's corners are known."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera import Camera, camera_at
from course_lib.checks import Array, check_points
from data_generators.bodies import at, house
from data_generators.places import backdrop, ground
from data_generators.quick import QuickRenderer
from data_generators.scene import Scene

#: Width and height of the wall, m.
WALL = (12.0, 8.2)
#: The corners of the wall: right and up from its bottom-left corner, m; bottom left first, then on
#: around to the right.
CORNERS = np.array([[0.0, 0], [12, 0], [12, 8.2], [0, 8.2]])
#: Width and height of a window with its frame, m.
WINDOW = (1.0, 1.3)
FOOT = at(6.6, 16.0, 0)  # m: where the bottom-left corner of the wall stands
COLOURS = ((214, 178, 128), (150, 84, 64))


def in_space(points: ArrayLike) -> Array:
    """Return points of the wall, right and up from its bottom-left corner, in the world, m."""
    points = check_points(points, 2, "points")
    return np.asarray(FOOT + points @ np.array([[0.0, -1, 0], [0, 0, 1]]))


def window(column: int, floor: int) -> Array:
    """Return the corners of a window on the wall, m, bottom left first.

    Parameters
    ----------
    column, floor : int
        0 to 5 from the left, 0 to 2 from the ground; the door is at (3, 0).

    Returns
    -------
    ndarray, shape (4, 2)
        Right and up from the wall's bottom-left corner.
    """
    left_top = np.array([2.0 * column + 0.5, 2.7 * floor + 2.25])
    return np.asarray(left_top + np.array([[0, -1.3], [1, -1.3], [1, 0], [0, 0]]))


def slanted_camera(image_size: tuple[int, int] = (480, 360)) -> Camera:
    """Return a camera on the other side of the street that sees the wall at a slant."""
    f = 1.06 * image_size[0]
    K = np.array([[f, 0, (image_size[0] - 1) / 2], [0, f, (image_size[1] - 1) / 2], [0, 0, 1]])
    return camera_at((-6.8, 21.8, 2.4), (6.6, 10.2, 4.2), K, image_size)


def photograph(camera: Camera) -> NDArray[np.uint8]:
    """Return what a camera sees of the house, shape (height, width, 3), uint8."""
    return _renderer().picture(camera)


@cache
def _renderer() -> QuickRenderer:
    rng = np.random.default_rng(9)
    body = house(FOOT - at(0, WALL[0], 0), (8.0, *WALL), COLOURS, rng)
    scene = Scene((*ground([], rng), *backdrop(rng), *body), (118, 168, 214))
    return QuickRenderer(scene, subpixels=4)
