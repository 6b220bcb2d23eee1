"""Still figures: a street through a pinhole and through a fisheye lens."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.camera import Camera
from course_lib.distortion import fisheye_project, fisheye_ray
from course_lib.drawing.diagrams import (
    Floats,
    figure,
    panels,
    picture_frame,
    same_shape,
)
from course_lib.drawing.distortion.pictures import Picture, looked_up
from course_lib.drawing.explorers.street import NORTH, renderer
from course_lib.drawing.style import BLACK, FULL_WIDTH, ROLES

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Where the camera stands, and five things around it, m in the world: two lamps, three treetops.
EYE = np.array([0.3, 7.6, 1.7])
THINGS = np.array(
    [[2.7, 9.0, 4.94], [2.7, 23.0, 4.94], [-4.2, 15.0, 5.6], [-4.2, 28.0, 6.4], [7.6, 18.6, 5.0]]
)
#: A fisheye that shows 180° in its circle, and a pinhole that shows 110° across; both 400 px.
SIDE = 400
FISHEYE_K = np.array([[SIDE / np.pi, 0, 199.5], [0, SIDE / np.pi, 199.5], [0, 0, 1]])
EQUIDISTANT = np.zeros(4)
#: Side of a face of the cube around the camera, px; rows are its axes in the camera frame.
FACE = 480
FACES = np.array(
    [
        [[1.0, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[0, 0, -1], [0, 1, 0], [1, 0, 0]],
        [[0, 0, 1], [0, 1, 0], [-1, 0, 0]],
        [[1, 0, 0], [0, 0, -1], [0, 1, 0]],
        [[1, 0, 0], [0, 0, 1], [0, -1, 0]],
    ]
)


def things() -> Floats:
    """Return two street lamps and three treetops in the frame of the fisheye camera.

    Returns
    -------
    ndarray, shape (5, 3)
        x right, y down, z forward, m.
    """
    return np.asarray((THINGS - EYE) @ NORTH.T)


@figure(
    "The same street from the same place: through a pinhole that sees 110° across, and through a "
    "fisheye lens that sees 180° in its circle, with rings around two lamps and three treetops."
)
def fisheye_street(yours: ArrayLike | None = None) -> Figure:
    """Show a street through a pinhole and through a fisheye lens.

    Parameters
    ----------
    yours : array_like, shape (5, 2), optional
        Pixels of the `things` that a student's `fisheye_project` gave.

    Returns
    -------
    Figure
        Two pictures of 400 px.
    """
    fig, (left, right) = panels(1, 2, (FULL_WIDTH, 4.1))
    left.imshow(pinhole_picture())
    left.set_title("Pinhole, 110° across")
    right.imshow(fisheye_picture())
    right.set_title("Fisheye, 180° across")
    for ax in (left, right):
        picture_frame(ax, (SIDE, SIDE))
    there = fisheye_project(things(), FISHEYE_K, EQUIDISTANT)
    right.plot(*there.T, "o", ms=13, mfc="none", mec=ROLES["object"], mew=1.6, ls="")
    drawn = same_shape(yours, there)
    if drawn is not None:
        right.plot(*drawn.T, "*", color=ROLES["second"], ms=10, mec=BLACK, mew=0.4, ls="")
    return fig


@cache
def fisheye_picture() -> Picture:
    """Return the street through the fisheye lens, black around its circle."""
    rays = fisheye_ray(_pixels(), FISHEYE_K, EQUIDISTANT)
    rays[rays[:, 2] < 0] = np.nan
    return _street_along(rays)


@cache
def pinhole_picture(across: float = np.radians(110)) -> Picture:
    """Return the street through a pinhole that sees an angle across."""
    f = SIDE / 2 / np.tan(across / 2)
    plane = (_pixels() - 199.5) / f
    return _street_along(np.column_stack([plane, np.ones(len(plane))]))


def _pixels() -> Floats:
    u, v = np.meshgrid(np.arange(SIDE, dtype=float), np.arange(SIDE, dtype=float))
    return np.stack([u.ravel(), v.ravel()], axis=1)


def _street_along(rays: Floats) -> Picture:
    """Return the street in the directions of rays (400², 3); black where they are NaN."""
    picture = np.zeros((SIDE, SIDE, 3), np.uint8)
    for axes in FACES:
        x, y, z = (rays @ axes.T).T
        with np.errstate(invalid="ignore", divide="ignore"):
            mine = (z > 0) & (np.abs(x) <= 1.0001 * z) & (np.abs(y) <= 1.0001 * z)
            places = np.stack([x / z, y / z], axis=1) * FACE / 2 + (FACE + 3) / 2
        places = np.where(mine[:, None], places, -1e6).reshape(SIDE, SIDE, 2)
        seen = looked_up(_face(axes.tobytes()), np.asarray(places, np.float32))
        mask = mine.reshape(SIDE, SIDE)
        picture[mask] = seen[mask]
    return picture


@cache
def _face(axes: bytes) -> Picture:
    """Return what a camera with these axes sees; two pixels more than a right angle all round."""
    R = np.frombuffer(axes).reshape(3, 3) @ NORTH
    middle = (FACE + 3) / 2
    K = np.array([[FACE / 2, 0, middle], [0, FACE / 2, middle], [0, 0, 1]])
    return renderer().picture(Camera(K, R, -R @ EYE, (FACE + 4, FACE + 4)))
