"""The panel on the shaker: what is asked of its cameras, and what they would see."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera
from course_lib.planning import (
    Box,
    CameraModel,
    LensModel,
    Setup,
    Task,
    aperture_window,
    depth_range,
    read_cameras,
    read_lenses,
)
from course_lib.planning.setup import motion_blur

if TYPE_CHECKING:
    from data_generators.defocus import DefocusedView
    from data_generators.quick import QuickRenderer
    from data_generators.scene import Patch, Scene

Floats = NDArray[np.float64]
Pixels = NDArray[np.uint8]

AMPLITUDE, FREQUENCY = 0.003, 100.0  # m and 1/s: how the shaker moves it up and down
BOX = Box([0.6, 0.06, 0.5])
TASK = Task(
    BOX,
    np.array([0.0, -1.0, 0.0]),
    resolution=0.0004,
    motion=AMPLITUDE,
    speed=2 * np.pi * FREQUENCY * AMPLITUDE,
    frame_rate=10 * FREQUENCY,
    blur_px=1.5,
    sigma=0.0001,
    exposure_at_f1=2e-6,
)
PHANTOM, ZEISS = "Phantom v2640, 2048 x 1920", "Zeiss Milvus 1.4/85"
STAR, STAR_PX = 0.03, 240  # m and px: side of the stars at the ends of the box
WALL = (70, 74, 80)  # colour behind the panel
#: Where the stars stand: near and far from a camera on the right, at the top and at the bottom.
ENDS = np.array([[0.283, -0.03, 0.232], [-0.283, 0.029, -0.232]])


def stand(
    camera: CameraModel, lens: LensModel, distance: float, turn: float, N: float, t: float
) -> Setup:
    """Return a set-up before the panel, focused so that both ends of its box are equally sharp.

    Parameters
    ----------
    camera, lens : CameraModel, LensModel
        Of the catalogue.
    distance : float
        From the middle of the box, m.
    turn : float
        How far it stands to the right of straight ahead, rad; negative to the left.
    N, t : float
        f-number, and exposure time in s.

    Returns
    -------
    Setup
        It looks at the middle of the box.
    """
    eye = distance * np.array([np.sin(turn), -np.cos(turn), 0.0])
    first = Setup(camera, lens, eye, np.zeros(3), N, t, distance)
    near, far = depth_range(BOX, first.view)
    focus = aperture_window(lens.f_mm, near, far, TASK.blur_px * camera.pitch_um).focus_distance
    return Setup(camera, lens, eye, np.zeros(3), N, t, focus)


def pair(
    distance: float, turn: float, N: float, t: float, lens: str = ZEISS
) -> tuple[Setup, Setup]:
    """Return two high-speed cameras, turned to both sides of straight ahead."""
    camera, glass = read_cameras()[PHANTOM], read_lenses()[lens]
    one, other = (stand(camera, glass, distance, side * turn, N, t) for side in (1, -1))
    return one, other


@cache
def panel() -> Scene:
    """Return the panel with its ribs, marks and stars, before a dark wall."""
    from data_generators.scene import Scene, box

    grey = np.array((150, 154, 160))
    ribs = [
        face
        for x in (-0.14, 0.0, 0.14)
        for face in box((x - 0.008, -0.03, -0.25), (0.016, 0.06, 0.5), grey, grey)
    ]
    near, far = _end(0), _end(1)
    return Scene((*far[:-1], *ribs, *near[1:], far[-1]), WALL)


@cache
def _end(number: int) -> tuple[Patch, ...]:
    """Return the wall, what is at one end of the panel, and the star on it."""
    from data_generators.bodies import at
    from data_generators.scene import Patch, box
    from data_generators.targets import siemens_star

    grey, (back, side) = np.array((150, 154, 160)), (np.array(WALL), STAR)
    wall = Patch(at(-6, 2, 4), at(12, 0, 0), at(0, 0, -8), back)
    corner = ENDS[number] + at(-side / 2, -1e-4, side / 2)
    star = Patch(corner, at(side, 0, 0), at(0, 0, -side), siemens_star(STAR_PX, 16))
    if number == 0:
        return wall, *box((0.264, -0.0299, -0.25), (0.036, 0.06, 0.5), grey, grey), star
    return wall, Patch(at(-0.3, 0.03, 0.25), at(0.6, 0, 0), at(0, 0, -0.5), _dots()), star


def _dots() -> Pixels:
    """Return the paint of the panel: light, with dark round marks every 20 mm."""
    texture = np.full((1000, 1200, 3), (206, 198, 176), np.uint8)  # 2 px a mm
    y, x = np.mgrid[:40, :40] - 19.5
    mark = np.hypot(x, y) < 6
    tiles = texture.reshape(25, 40, 30, 40, 3).transpose(0, 2, 1, 3, 4)
    tiles[:, :, mark] = (40, 40, 44)
    return texture


@cache
def renderer() -> QuickRenderer:
    """Return what draws the panel; made once."""
    from data_generators.quick import QuickRenderer

    return QuickRenderer(panel(), subpixels=2)


def overview(setup: Setup, width: int) -> tuple[Camera, Pixels]:
    """Return a set-up's camera with a picture of so many pixels across, and that picture.

    Parameters
    ----------
    setup : Setup
        The set-up.
    width : int
        px.

    Returns
    -------
    camera : Camera
        The same view with larger pixels.
    picture : ndarray, shape (height, width, 3), uint8
        RGB.
    """
    view = setup.view
    scale = width / view.image_size[0]
    size = width, round(view.image_size[1] * scale)
    K = view.K.copy()
    K[:2] *= scale
    K[:2, 2] += (scale - 1) / 2  # corners of pixels stay corners: they are at -0.5
    small = Camera(K, view.R, view.t, size)
    return small, renderer().picture(small)


def close_up(setup: Setup, end: int, side: int = 64) -> Pixels:
    """Return some pixels of a set-up's picture: a star at one end of the box.

    Defocus is that of the lens, the smear that of the fastest moment; light that is missing makes
    it darker. Diffraction is left out.

    Parameters
    ----------
    setup : Setup
        The set-up.
    end : int
        0 for the near end (seen from the right), 1 for the far one.
    side : int
        Width and height, px.

    Returns
    -------
    ndarray, shape (side, side, 3), uint8
        RGB.
    """
    from data_generators.lens import Lens

    view = setup.view
    middle = np.rint(view.project(ENDS[end]))
    K = view.K.copy()
    K[:2, 2] += (side - 1) / 2 - middle
    camera = Camera(K, view.R, view.t, (side, side))
    lens = Lens(setup.lens.f_mm, setup.N, 1000 * setup.focus_distance)
    picture = _defocused(end).picture(camera, lens)
    smear = motion_blur(setup, TASK).value
    light = setup.exposure_time / (TASK.exposure_at_f1 * setup.N**2)
    return _exposed(picture, smear, light)


@cache
def _defocused(end: int) -> DefocusedView:
    """Return the view of one end; each keeps its layers while only the blur changes."""
    from data_generators.defocus import DefocusedView
    from data_generators.scene import Scene

    return DefocusedView(Scene(_end(end), WALL), breathes=False)


def _exposed(picture: Pixels, smear: float, light: float) -> Pixels:
    """Return a picture that is smeared upright over so many pixels, and darker if light lacks."""
    import cv2

    half = int(np.ceil(smear / 2 + 0.5))
    ends = np.clip(np.arange(-half, half + 2) - 0.5, -smear / 2, smear / 2)
    weights = np.diff(ends)
    weights = weights / weights.sum() if smear > 1e-6 else np.array([1.0])
    smeared = cv2.filter2D(picture, -1, weights[:, None], borderType=cv2.BORDER_REPLICATE)
    dark = min(light, 1.0) ** (1 / 2.2)
    return np.asarray(np.rint(smeared * dark), np.uint8)
