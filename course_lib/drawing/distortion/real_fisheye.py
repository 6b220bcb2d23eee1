"""Still figure: a real photograph through a fisheye lens, and pinhole views made from it."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from course_lib import data
from course_lib.distortion import fisheye_project
from course_lib.drawing.diagrams import Floats, figure, panels
from course_lib.drawing.distortion.fisheye import EQUIDISTANT, FISHEYE_K, fisheye_picture
from course_lib.drawing.distortion.pictures import Picture, looked_up
from course_lib.drawing.style import FULL_WIDTH

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PHOTOGRAPH = "boofcv/fisheye_chessboard/1.jpg"
#: The published calibration of its camera, by the model of Mei and Rives: focal length and centre
#: in px, offset of the mirror, radial coefficients.
MEI_F, MEI_C, MEI_XI, MEI_K = 398.7722, (319.1788, 319.7174), 1.1331347, (-0.2497210, 0.0096723)
#: Side of the pinhole views, px.
SIDE = 360


@cache
def kannala_brandt(widest: float = np.radians(92)) -> tuple[Floats, Floats]:
    """Return the published camera in the form of Kannala and Brandt: K, and k1 … k4.

    Parameters
    ----------
    widest : float
        Angle from the axis up to which they are to agree, rad.

    Returns
    -------
    K : ndarray, shape (3, 3)
        Intrinsics, px.
    k : ndarray, shape (4,)
        Coefficients for `course_lib.distortion.fisheye_project`.
    """
    f = MEI_F / (1 + MEI_XI)  # what a small angle is multiplied with
    angle = np.linspace(0, widest, 200)
    powers = angle[:, None] ** np.array([3, 5, 7, 9])
    k, *_ = np.linalg.lstsq(powers, mei_distance(angle) / f - angle, rcond=None)
    return np.array([[f, 0, MEI_C[0]], [0, f, MEI_C[1]], [0, 0, 1]]), k


def mei_distance(angle: Floats) -> Floats:
    """Return the distance from the centre in px for angles from the axis, as published."""
    m = np.sin(angle) / (np.cos(angle) + MEI_XI)
    return np.asarray(MEI_F * m * (1 + MEI_K[0] * m**2 + MEI_K[1] * m**4))


@cache
def fisheye_camera() -> tuple[Picture, Floats, Floats, bool]:
    """Return the photograph, its K and k, and whether it is real; else the computed street."""
    import cv2

    try:
        path = data.fetch(PHOTOGRAPH)
    except data.Unavailable:
        return fisheye_picture(), FISHEYE_K, EQUIDISTANT, False
    bgr = cv2.imdecode(np.fromfile(path, np.uint8), cv2.IMREAD_COLOR)
    return np.asarray(bgr, np.uint8)[..., ::-1], *kannala_brandt(), True


def pinhole_view(across: float) -> Picture:
    """Return what a pinhole would have taken: each of its pixels looks up the fisheye's picture.

    Parameters
    ----------
    across : float
        Angle that it sees from its left to its right edge, rad.

    Returns
    -------
    ndarray, shape (360, 360, 3), uint8
        RGB.
    """
    picture, K, k, _ = fisheye_camera()
    plane = (np.arange(SIDE) - (SIDE - 1) / 2) * 2 * np.tan(across / 2) / SIDE
    x, y = np.meshgrid(plane, plane)
    rays = np.stack([x.ravel(), y.ravel(), np.ones(x.size)], axis=1)
    places = fisheye_project(rays, K, k).reshape(SIDE, SIDE, 2)
    return looked_up(np.ascontiguousarray(picture), places.astype(np.float32))


@figure(
    "A photograph through a fisheye lens, its straight edges bent; beside it two pinhole views "
    "made from it, of a smaller and a larger angle, in which they are straight."
)
def fisheye_photograph(angles: tuple[float, float] = (100, 140)) -> Figure:
    """Show a real fisheye photograph, and what pinholes would have taken in its place.

    Parameters
    ----------
    angles : tuple of float
        What the pinholes see from left to right, degrees.

    Returns
    -------
    Figure
        Three pictures.
    """
    picture, *_, real = fisheye_camera()
    fig, axes = panels(1, 3, (FULL_WIDTH, 2.9))
    views = [picture[: picture.shape[1]], *(pinhole_view(np.radians(a)) for a in angles)]
    titles = ["Fisheye" if real else "Fisheye (computed)", *(f"Pinhole, {a:g}°" for a in angles)]
    for ax, view, title in zip(axes, views, titles, strict=True):
        ax.imshow(view)
        ax.axis("off")
        ax.set_title(title, fontsize=11)
    return fig
