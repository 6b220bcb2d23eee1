"""A desk with a printed target, a bank card and a box on it, as a phone photographs them.

What there is to measure is known. Lengths are in mm, in the frame of the target: its plane is
z = 0, x along its rows, y down its columns (towards the reader), z into the desk.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, lru_cache

import numpy as np
from numpy.typing import NDArray

from course_lib.boards import Checkerboard
from course_lib.camera import Camera
from course_lib.checks import Array
from course_lib.distortion import distort_pixels, undistort_pixels
from course_lib.transforms import look_at
from data_generators.board_scenes import board_texture
from data_generators.quick import QuickRenderer
from data_generators.scene import Patch, Scene, box

Pixels = NDArray[np.uint8]
#: How a camera is held: towards which place (mm), tilt, from where (degrees), distance (mm) and
#: turn (degrees), as `pose_towards` takes them.
Aim = tuple[tuple[float, float], float, float, float, float]

TARGET = Checkerboard(9, 6, 25.0)
#: ISO/IEC 7810, ID-1: every bank card; width, height and thickness, mm.
CARD = (85.60, 53.98, 0.76)
CARD_AT, CARD_TURN = (282.0, 72.0), 0.2  # its upper left corner, and its turn, rad
BOX = (120.0, 80.0, 60.0)  # along x, y and up, mm
BOX_AT, BOX_TURN = (278.0, 28.0), 0.12  # its lower corner that is nearest to the target, rad
#: Of the camera: focal length by the picture's width, and its lens.
FOCAL, LENS = 0.735, (0.06, -0.1, 0.0006, -0.0004, 0.0)
FINER, STEP = 2, 8  # the picture is drawn so much finer; the lens is computed every so many px
WIDER = 0.06  # a lens that bends outwards needs so much more than the picture, at each side
#: From the frame of the target to that of the desk, whose z is up.
UP = np.diag([1.0, -1.0, -1.0])


@dataclass(frozen=True, eq=False)
class DeskView:
    """A photograph of the desk, and the truth about it.

    Attributes
    ----------
    picture : ndarray, shape (h, w, 3), uint8
        RGB.
    camera : Camera
        Its world is the frame of the target.
    """

    picture: Pixels
    camera: Camera

    def project(self, points: Array) -> Array:
        """Return where points of the target's frame are in the picture, shape (N, 2), px."""
        return distort_pixels(self.camera.project(points), self.camera.K, LENS)


def intrinsics(image_size: tuple[int, int]) -> Array:
    """Return K of the phone's camera for a size of its pictures, px."""
    width, height = image_size
    f = FOCAL * width
    return np.array([[f, 0, 0.506 * width], [0, f, 0.495 * height], [0, 0, 1]])


def card_corners() -> Array:
    """Return the corners of the card's upper side, clockwise from the upper left, shape (4, 3)."""
    c, s = np.cos(CARD_TURN), np.sin(CARD_TURN)
    along, down = CARD[0] * np.array([c, s, 0]), CARD[1] * np.array([-s, c, 0])
    corner = np.array([*CARD_AT, -CARD[2]])
    return np.array([corner, corner + along, corner + along + down, corner + down])


def box_corners() -> Array:
    """Return the corners of the box, shape (8, 3): the lower four, then those above them.

    Both times front left (the nearest to the target and the reader), front right, back right,
    back left.
    """
    c, s = np.cos(BOX_TURN), np.sin(BOX_TURN)
    along, back = BOX[0] * np.array([c, -s, 0]), BOX[1] * np.array([-s, -c, 0])
    corner = np.array([*BOX_AT, 0.0])
    low = np.array([corner, corner + along, corner + along + back, corner + back])
    return np.vstack([low, low - (0, 0, BOX[2])])


@cache
def _renderer() -> QuickRenderer:
    """Return what draws the desk."""
    desk = _flat(np.array([-1400, 1200, -0.3]), 3200, 2600, _wood())
    texture, origin, pixel = board_texture(TARGET)
    height, width = texture.shape
    sheet = _flat(UP @ [*origin, 0], width * pixel, height * pixel, _printed(texture))
    upper_left, upper_right, _, lower_left = card_corners() @ UP
    card = Patch(upper_left, upper_right - upper_left, lower_left - upper_left, _card())
    faces = box(UP @ [*BOX_AT, 0.0], BOX, [_label(BOX[0]), _label(BOX[1])] * 2, _lid(), BOX_TURN)
    return QuickRenderer(Scene((desk, sheet, card, *faces), (120, 110, 100)), subpixels=1)


def _flat(corner: Array, width: float, depth: float, texture: Pixels) -> Patch:
    """Return something flat on the desk, from its far left corner."""
    return Patch(corner, np.array([width, 0, 0]), np.array([0, -depth, 0]), texture)


def _wood() -> Pixels:
    """Return planks with a grain, 0.5 pixels a mm."""
    rng = np.random.default_rng(3)
    rows = np.repeat(rng.normal(0, 5, (650, 1, 1)), 2, axis=0)
    rows += np.repeat(rng.normal(0, 7, (13, 1, 1)), 100, axis=0)  # a plank is 200 mm wide
    grain = rows + np.repeat(rng.normal(0, 3, (1300, 100, 1)), 16, axis=1)
    wood = np.clip(np.array([168, 128, 92]) + grain, 0, 255)
    wood[::100] -= 40
    return np.asarray(np.rint(wood), np.uint8)


def _printed(texture: Pixels) -> Pixels:
    """Return a print: its black is dark grey, its white a little grey."""
    return np.asarray(np.rint(28 + texture * (205 / 255)), np.uint8)


def _card() -> Pixels:
    """Return the upper side of a card, 8 pixels a mm."""
    card = np.full((round(8 * CARD[1]), round(8 * CARD[0]), 3), (24, 74, 132), np.uint8)
    card[:, 460:] = (36, 96, 158)
    card[150:220, 60:150] = (214, 184, 104)  # the chip
    for row, end in ((270, 560), (340, 380), (368, 300)):
        card[row : row + 14, 60:end] = (214, 224, 234)
    return card


def _label(width: float) -> Pixels:
    """Return a side of the box, 4 pixels a mm."""
    side = np.full((round(4 * BOX[2]), round(4 * width), 3), (226, 214, 190), np.uint8)
    side[90:150] = (176, 56, 44)
    side[60:66, 30:-30] = side[176:182, 30:-30] = (120, 96, 70)
    return side


def _lid() -> Pixels:
    """Return the top of the box, 4 pixels a mm."""
    lid = np.full((round(4 * BOX[1]), round(4 * BOX[0]), 3), (244, 236, 214), np.uint8)
    lid[130:190, 60:-60] = (176, 56, 44)
    return lid


@lru_cache(maxsize=4)
def _lens(image_size: tuple[int, int]) -> tuple[Array, tuple[int, int], Array]:
    """Return K and size of the finer, wider pinhole picture, and where the lens looks in it."""
    K, size = intrinsics(image_size), np.array(image_size)
    more = np.ceil(WIDER * size).astype(int)
    wide = K.copy()
    wide[:2] *= FINER
    wide[:2, 2] = FINER * (K[:2, 2] + more + 0.5) - 0.5
    nodes = [np.arange(-1, n // STEP + 3) * STEP for n in image_size]
    grid = np.stack(np.meshgrid(*nodes), axis=-1).reshape(-1, 2).astype(float)
    coarse = undistort_pixels(grid, K, LENS, wide).reshape(len(nodes[1]), len(nodes[0]), 2)
    fine = [(np.arange(FINER * n) + 0.5) / FINER - 0.5 for n in image_size]
    across, down = (_between(x, STEP, len(n)) for x, n in zip(fine, nodes, strict=True))
    where = np.stack([down @ coarse[..., k] @ across.T for k in (0, 1)], axis=-1)
    width, height = (FINER * (size + 2 * more)).tolist()
    return wide, (width, height), where.astype(np.float32)


def _between(x: Array, step: int, count: int) -> Array:
    """Return the matrix that interpolates between nodes at -step, 0, step, …, shape (N, count)."""
    place = x / step + 1
    left = np.floor(place).astype(int)
    weights = np.zeros((len(x), count))
    rows = np.arange(len(x))
    weights[rows, left], weights[rows, left + 1] = 1 - (place - left), place - left
    return weights


def photograph_desk(
    R: Array,
    t: Array,
    image_size: tuple[int, int],
    rng: np.random.Generator,
    blur: float = 0.6,
    noise: float = 2.0,
) -> DeskView:
    """Return what the phone sees.

    Parameters
    ----------
    R, t : ndarray, shape (3, 3) and (3,)
        Pose, target to camera, mm.
    image_size : tuple of int
        Width and height, px.
    rng : numpy.random.Generator
        For the noise.
    blur : float
        Standard deviation of the blur, px.
    noise : float
        Of a pixel, grey levels.

    Returns
    -------
    DeskView
        The photograph and its camera.
    """
    import cv2

    wide, size, where = _lens(image_size)
    pinhole = _renderer().picture(Camera(wide, R @ UP, t, size))
    fine = cv2.remap(pinhole, where, None, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    small = cv2.resize(fine, image_size, interpolation=cv2.INTER_AREA)
    soft = cv2.GaussianBlur(small, (0, 0), blur).astype(np.float32)
    grain = rng.standard_normal(soft.shape[:2], dtype=np.float32)[..., None]
    picture = np.clip(np.rint(soft + noise * grain), 0, 255).astype(np.uint8)
    return DeskView(picture, Camera(intrinsics(image_size), R, t, image_size))


def pose_towards(
    middle: tuple[float, float], tilt_deg: float, way_deg: float, distance: float, roll_deg: float
) -> tuple[Array, Array]:
    """Return the pose of a camera that looks at a place on the desk.

    Parameters
    ----------
    middle : tuple of float
        x and y in the target's frame, mm.
    tilt_deg : float
        Of the optical axis from straight down, degrees.
    way_deg : float
        Where the camera stands: 0 on the reader's side, 90 on the right.
    distance : float
        From the place, mm.
    roll_deg : float
        About the optical axis, degrees.

    Returns
    -------
    R, t : ndarray, shape (3, 3) and (3,)
        Target to camera, mm.
    """
    tilt, way, roll = np.radians([tilt_deg, way_deg, roll_deg])
    out = np.array([np.sin(tilt) * np.sin(way), np.sin(tilt) * np.cos(way), -np.cos(tilt)])
    place = np.array([*middle, 0.0])
    R, t = look_at(place + distance * out, place, (0, -1, -0.6))
    turn = np.array(
        [[np.cos(roll), -np.sin(roll), 0], [np.sin(roll), np.cos(roll), 0], [0, 0, 1.0]]
    )
    return turn @ R, turn @ t
