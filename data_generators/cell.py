"""A robot's table under two cameras: markers, targets, a raised block, a calibration object.

The world is measured in millimetres here. Its origin is the first marker of the table, x runs
along the longer side, z is up. Everything that a chapter estimates is known: the cameras, where
the markers and the targets are, and what a bent cover before a camera does to its picture.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera import Camera, camera_at
from course_lib.checks import Array, check_not_negative, check_points
from data_generators.quick import QuickRenderer
from data_generators.scene import Patch, Scene, Texture, box, check_texture, lit_patch

SIZE = (640, 480)
#: Intrinsics of both cameras, px.
K = np.array([[820.0, 0, 319.5], [0, 820, 239.5], [0, 0, 1]])
STEP, COLUMNS, ROWS = 80.0, 7, 5
#: Where the markers of the table are, mm, x first: shape (35, 2).
MARKERS = np.stack(np.meshgrid(np.arange(COLUMNS), np.arange(ROWS)), axis=-1).reshape(-1, 2) * STEP
#: Where the needle must go: six places on the table, and three on top of the block, mm.
TARGETS = np.array([[42.0, 118], [118, 42], [198, 202], [278, 122], [265, 285], [438, 38]])
BLOCK = np.array([[400.0, 180, 60], [430, 215, 60], [460, 180, 60]])
#: Corner of the calibration object, side of its panels, and places of the dots along a side, mm.
CORNER, PANEL, DOTS = np.array([40.0, 270, 0]), 190.0, np.array([35.0, 75, 115, 155])
MAT, PAPER, INK = (70, 110, 100), (238, 238, 232), (24, 26, 30)
FLESH, WOOD = (222, 128, 122), (176, 138, 96)
BORDER, SCALE = 70.0, 3  # mm of table around the markers, px of its texture a mm
WAVES = np.array([[1.0, 0.4], [-0.4, 0.9], [1.1, -0.8], [0.3, 1.5]]) * 2 * np.pi  # of the cover


def camera_above() -> Camera:
    """Return the camera that looks straight down, mounted with a small turn."""
    return camera_at((240, 160, 800), (240, 160, 0), K, SIZE, up=(np.sin(0.14), np.cos(0.14), 0))


def camera_beside() -> Camera:
    """Return the camera that looks at the table from a corner."""
    return camera_at((680, -400, 600), (232, 155, 25), K, SIZE)


def on_table(points: ArrayLike, z: float = 0.0) -> Array:
    """Return points of the table (N, 2) in space, mm, at a height."""
    points = check_points(points, 2, "points")
    return np.asarray(np.concatenate([points, np.full_like(points[..., :1], z)], axis=-1))


def object_points() -> Array:
    """Return the 48 dots of the calibration object, mm: floor, side wall, back wall."""
    a, b = (grid.ravel() for grid in np.meshgrid(DOTS, DOTS))
    zero = np.zeros_like(a)
    floor, side, back = [a, -b, zero], [zero, -a, b], [a, zero, b]
    dots = np.concatenate([np.stack(panel, axis=1) for panel in (floor, side, back)])
    return np.asarray(CORNER + dots)


def observed(pixels: ArrayLike, sigma: float, rng: np.random.Generator) -> Array:
    """Return pixels as a program finds them: with a normal error of `sigma` px in u and v.

    Parameters
    ----------
    pixels : array_like, shape (N, 2)
        Where the points are.
    sigma : float
        Standard deviation, px.
    rng : numpy.random.Generator
        Draws the errors.

    Returns
    -------
    ndarray, shape (N, 2)
        Where they are found.
    """
    pixels, sigma = check_points(pixels, 2, "pixels"), float(check_not_negative(sigma, "sigma"))
    return pixels + sigma * rng.standard_normal(pixels.shape)


def cover_shift(pixels: ArrayLike, image_size: tuple[int, int] = SIZE) -> Array:
    """Return by how much a bent cover before the camera moves what is seen, px.

    Parameters
    ----------
    pixels : array_like, shape (N, 2)
        Where the points would be without the cover.
    image_size : tuple of int
        Width and height, px.

    Returns
    -------
    ndarray, shape (N, 2)
        A smooth shift of about two pixels that no usual model of a lens describes.
    """
    pixels = check_points(pixels, 2, "pixels")
    phase = pixels / np.asarray(image_size) @ WAVES.T
    across = 1.5 * np.sin(phase[..., 0]) + 0.9 * np.cos(phase[..., 2]) - 0.5 * np.sin(phase[..., 3])
    down = 1.3 * np.cos(phase[..., 1]) - 0.8 * np.sin(phase[..., 2]) + 0.6 * np.sin(phase[..., 0])
    return np.stack([across, down], axis=-1)


def photograph(camera: Camera, standing: str = "block") -> NDArray[np.uint8]:
    """Return what a camera sees of the table.

    Parameters
    ----------
    camera : Camera
        The camera, mm.
    standing : {"block", "object", "nothing"}
        What stands on the table.

    Returns
    -------
    ndarray, shape (height, width, 3), uint8
        The picture.

    Raises
    ------
    ValueError
        If nothing of that name can stand there.
    """
    if standing not in ("block", "object", "nothing"):
        raise ValueError(f"standing must be block, object or nothing, got {standing!r}")
    return _renderer(standing).picture(camera)


@cache
def _renderer(standing: str) -> QuickRenderer:
    return QuickRenderer(table(standing), subpixels=4)


def table(standing: str) -> Scene:
    """Return the table with its markers and targets, and what stands on it."""
    width, depth = STEP * (COLUMNS - 1), STEP * (ROWS - 1)
    left_top = np.array([-BORDER, depth + BORDER, 0])
    across, down = np.array([width + 2 * BORDER, 0, 0]), np.array([0, -depth - 2 * BORDER, 0])
    ground = Patch(left_top, across, down, _mat())
    bodies = {"block": _block, "object": _calibration_object}
    there = bodies[standing]() if standing in bodies else []
    return Scene((ground, *there), (44, 48, 54))


def _mat() -> Texture:
    """Return the table's top: markers on white, and targets on pads; linear in light."""
    size = np.array([STEP * (COLUMNS - 1), STEP * (ROWS - 1)]) + 2 * BORDER
    columns, rows = (round(side * SCALE) for side in size.tolist())
    grain = np.random.default_rng(6).normal(1, 0.04, (rows, columns, 1))
    picture = np.clip(np.array(MAT) * grain, 0, 255).astype(np.uint8)
    places = (np.array([BORDER, size[1] - BORDER]), np.array([1, -1]))
    for marker in MARKERS:
        _square(picture, places[0] + places[1] * marker, 11, PAPER)
        _disc(picture, places[0] + places[1] * marker, 6, INK)
    for target in TARGETS:
        _disc(picture, places[0] + places[1] * target, 15, FLESH)
        _disc(picture, places[0] + places[1] * target, 3.5, INK)
    return picture


def _block() -> list[Patch]:
    """Return a wooden block with three targets on its top."""
    corner, size = np.array([385.0, 165, 0]), (90.0, 65.0, 60.0)
    top = np.empty((round(size[1] * 4), round(size[0] * 4), 3), np.uint8)
    top[:] = WOOD
    for x, y in BLOCK[:, :2] - corner[:2]:
        _disc(top, np.array([x, size[1] - y]), 11, FLESH, scale=4)
        _disc(top, np.array([x, size[1] - y]), 3.5, INK, scale=4)
    return box(corner, size, check_texture(np.array(WOOD)), top)


def _calibration_object() -> list[Patch]:
    """Return three panels with dots that meet at right angles, seen from +x and -y."""
    x, y, z = PANEL * np.eye(3)
    lifted = CORNER + z / PANEL * 0.2  # mm: so that the floor panel hides the table
    upright = _panel(-1)
    return [
        lit_patch(lifted, x, -y, _panel(1)),
        lit_patch(CORNER + z - y, y, -z, upright[:, ::-1]),
        lit_patch(CORNER + z, x, -z, upright),
    ]


def _panel(down: int) -> Texture:
    """Return a white panel with dots; the corner of the object is at v = 0, or below (-1)."""
    side = round(PANEL * 4)
    picture = np.empty((side, side, 3), np.uint8)
    picture[:] = PAPER
    for a in DOTS:
        for b in DOTS:
            _disc(picture, np.array([a, b if down > 0 else PANEL - b]), 8, INK, scale=4)
    return picture


def _disc(
    picture: Texture, at: Array, radius: float, colour: ArrayLike, scale: int = SCALE
) -> None:
    """Paint a disc with a smooth edge, mm."""
    import cv2

    centre = np.rint((at * scale - 0.5) * 16).astype(int).tolist()
    ink = [int(c) for c in np.asarray(colour)]
    cv2.circle(picture, centre, round(radius * scale * 16), ink, -1, cv2.LINE_AA, 4)


def _square(picture: Texture, at: Array, half: float, colour: ArrayLike) -> None:
    left, top = np.rint((at - half) * SCALE).astype(int).tolist()
    right, bottom = np.rint((at + half) * SCALE).astype(int).tolist()
    picture[top:bottom, left:right] = colour
