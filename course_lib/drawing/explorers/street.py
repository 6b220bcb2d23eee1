"""The street that the explorers of chapter 01 photograph, and views of the camera in it."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera, first_guess_intrinsics
from course_lib.drawing.explorers.frame import Line, Probe
from course_lib.transforms import rotation_x

if TYPE_CHECKING:
    from data_generators.quick import QuickRenderer

Floats = NDArray[np.float64]

WIDTH = 480  # px of every photograph
#: Where the letter chart of the street stands, and its lower and upper edge, m in the world.
CHART = np.array([1.75, 5.0])
CHART_EDGES = (0.6, 1.8)
#: R of an upright camera that looks north, world to camera: x east, y down, z north.
NORTH = rotation_x(np.pi / 2)


@cache
def renderer() -> QuickRenderer:
    """Return the renderer of the street; made once, as its textures take a second."""
    from data_generators.places import street
    from data_generators.quick import QuickRenderer

    return QuickRenderer(street(), subpixels=2)


def upright_camera(
    eye: tuple[float, float, float], f: float, sensor_size: tuple[float, float]
) -> Camera:
    """Return a camera that looks level along the street.

    Parameters
    ----------
    eye : tuple of float
        Where it stands, m.
    f : float
        Focal length, mm.
    sensor_size : tuple of float
        Width and height, mm; the picture is `WIDTH` px wide and has the sensor's shape,
        to the next even height.

    Returns
    -------
    Camera
        The camera.
    """
    size = (WIDTH, 2 * round(WIDTH * sensor_size[1] / sensor_size[0] / 2))
    K = first_guess_intrinsics(f, sensor_size, size)
    return Camera(K, NORTH, -NORTH @ np.asarray(eye), size)


def corners(camera: Camera) -> Floats:
    """Return the corners of a camera's picture, in order around, shape (4, 2), px."""
    w, h = camera.image_size
    return np.array([[-0.5, -0.5], [w - 0.5, -0.5], [w - 0.5, h - 0.5], [-0.5, h - 0.5]])


def frustum(camera: Camera, depth: float, through: Camera) -> tuple[Line, ...]:
    """Return what a camera sees down to a depth, as another camera sees it.

    Parameters
    ----------
    camera : Camera
        Whose field of view is drawn.
    depth : float
        How far along its axis, m.
    through : Camera
        Through which it is seen.

    Returns
    -------
    tuple of Line
        The four edges and the far rectangle, and the optical axis dashed.
    """
    centre = camera.centre
    rays = camera.pixel_ray(corners(camera))
    far = centre + depth * rays / (rays @ camera.R[2])[:, None]
    edges = np.concatenate([_segment(centre, corner) for corner in far])
    around = np.concatenate(
        [_segment(a, b)[:-1] for a, b in zip(far, np.roll(far, -1, 0), strict=True)]
    )
    axis = _segment(centre, centre + depth * camera.R[2])
    rectangle = around[~np.isnan(around).any(axis=1)]
    return (
        Line(_seen(rectangle, through), "camera", 2.0, closed=True, fill=0.22),
        Line(_seen(edges, through), "camera", 2.0),
        Line(_seen(axis, through), "ray", 1.5, dashed=True),
    )


def _segment(start: Floats, end: Floats, pieces: int = 24) -> Floats:
    """Return points along a segment and a NaN row, so that a part behind a camera can go."""
    share = np.linspace(0, 1, pieces)[:, None]
    return np.vstack([start + share * (end - start), np.full(3, np.nan)])


def _seen(points: Floats, through: Camera) -> Floats:
    """Return the image of points in rows, NaN rows kept."""
    image = np.full((len(points), 2), np.nan)
    there = ~np.isnan(points).any(axis=1)
    image[there] = through.project(points[there])
    return image


def angle_probe(camera: Camera) -> Probe:
    """Return the angle between the optical axis and the ray of the pixel, in degrees."""
    w, h = camera.image_size
    nodes = np.meshgrid(np.linspace(0, w - 1, 25), np.linspace(0, h - 1, 17))
    # The ray K⁻¹ (u, v, 1) = (x, y, 1) has the tangent √(x² + y²).
    x, y = np.tensordot(np.linalg.inv(camera.K)[:2], [*nodes, np.ones_like(nodes[0])], 1)
    return Probe("angle from the axis", "°", np.degrees(np.arctan(np.hypot(x, y))))
