"""Pairs of cameras in the street of chapter 01, what they see, and points that both see."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera, camera_at
from course_lib.drawing.explorers.street import renderer
from course_lib.drawing.explorers.whole_camera import LAMP

if TYPE_CHECKING:
    from data_generators.raycast import SceneIndex

Floats = NDArray[np.float64]

#: Focal length in widths of the picture, and where the second picture has its camera, m.
FOCAL = 1.2
TOWARDS, APART, AHEAD = "turned towards each other", "side by side", "one ahead of the other"
EYES = {
    TOWARDS: ((-2.2, -4.4, 1.7), (2.2, -4.6, 2.3)),
    APART: ((-1.2, -4.0, 1.7), (1.2, -4.0, 1.7)),
    AHEAD: ((0.3, -6.0, 1.7), (0.3, -2.0, 1.7)),
}
TARGETS = {
    TOWARDS: ((0.5, 10.0, 1.6), (0.5, 10.0, 1.6)),
    APART: ((-1.2, 12.0, 1.7), (1.2, 12.0, 1.7)),
    AHEAD: ((0.3, 12.0, 1.7), (0.3, 12.0, 1.7)),
}
#: Farther than that there is only sky and hills, m; a point of the picture's edge is no tie point.
FARTHEST, MARGIN = 80.0, 6


@cache
def cameras(arrangement: str, width: int) -> tuple[Camera, Camera]:
    """Return the two cameras of an arrangement.

    Parameters
    ----------
    arrangement : str
        A key of `EYES`.
    width : int
        Of both pictures, px; they are three quarters as high.

    Returns
    -------
    tuple of two Camera
        The first and the second.
    """
    size = (width, 3 * width // 4)
    f = FOCAL * width
    K = np.array([[f, 0, (size[0] - 1) / 2], [0, f, (size[1] - 1) / 2], [0, 0, 1]])
    one, other = (
        camera_at(eye, target, K, size)
        for eye, target in zip(EYES[arrangement], TARGETS[arrangement], strict=True)
    )
    return one, other


@cache
def photographs(arrangement: str, width: int) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Return what both cameras of an arrangement see."""
    one, other = cameras(arrangement, width)
    return renderer().picture(one), renderer().picture(other)


def relative(arrangement: str, width: int) -> tuple[Floats, Floats]:
    """Return the relative pose of an arrangement, first camera to second, m."""
    from course_lib.epipolar import relative_pose

    one, other = cameras(arrangement, width)
    return relative_pose(one.R, one.t, other.R, other.t)


def lamp(arrangement: str, width: int) -> tuple[Floats, Floats]:
    """Return where both pictures show the bulb of the first street lamp, px."""
    one, other = cameras(arrangement, width)
    return one.project(LAMP), other.project(LAMP)


@cache
def index() -> SceneIndex:
    """Return the street, made ready for rays."""
    from data_generators.raycast import SceneIndex

    return SceneIndex(renderer().scene)


def surface(camera: Camera, pixels: Floats) -> Floats:
    """Return the points of the street that pixels (N, 2) show, (N, 3), m; infinite in the sky."""
    from data_generators.raycast import rays

    origins, directions = rays(camera, np.asarray(pixels, dtype=float))
    far = index().cast(origins, directions).distance
    with np.errstate(invalid="ignore"):
        return np.asarray(origins + far[:, None] * directions)


@cache
def true_pairs(arrangement: str, width: int, count: int = 80) -> tuple[Floats, Floats, Floats]:
    """Return points that both cameras of an arrangement see.

    Parameters
    ----------
    arrangement : str
        A key of `EYES`.
    width : int
        Of both pictures, px.
    count : int
        How many.

    Returns
    -------
    pixels1, pixels2 : ndarray, shape (count, 2)
        Where both pictures show them, px.
    points : ndarray, shape (count, 3)
        In the world, m.
    """
    one, other = cameras(arrangement, width)
    rng = np.random.default_rng(8)
    tried = rng.uniform(MARGIN, np.array(one.image_size) - MARGIN, (12 * count, 2))
    points = surface(one, tried)
    near = np.linalg.norm(points - one.centre, axis=1) < FARTHEST
    tried, points = tried[near], points[near]
    seen = other.project(points)
    inside = ((seen > MARGIN) & (seen < np.array(other.image_size) - MARGIN)).all(axis=1)
    tried, points, seen = tried[inside], points[inside], seen[inside]
    shown = surface(other, seen)  # another point, if something stands before it
    same = np.linalg.norm(shown - points, axis=1) < 0.02
    return tried[same][:count], seen[same][:count], points[same][:count]
