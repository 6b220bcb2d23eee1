"""Sketches in space and from above: the epipolar plane, and the four poses of one matrix."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from course_lib.camera import Camera, camera_at
from course_lib.drawing.diagrams import Floats, figure, fit, panels, sketch, write
from course_lib.drawing.space import onlooker, show_face, show_path
from course_lib.drawing.style import FULL_WIDTH, GREY, ROLES
from course_lib.epipolar import poses_from_essential
from course_lib.transforms import camera_centre, rotation_y, skew

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

POINT = np.array([0.1, 3.0, 1.0])
NEAR = 1.25  # how far before each camera its picture is drawn
PAPER = {"facecolor": "white", "edgecolor": "none", "pad": 0.8, "alpha": 0.8}


@cache
def sketched_cameras() -> tuple[Camera, Camera]:
    """Return two cameras that look at `POINT` from both sides."""
    K = np.array([[150.0, 0, 79.5], [0, 150, 59.5], [0, 0, 1]])
    eyes = ((-2.0, 0.0, 0.0), (2.0, 0.0, 0.0))
    aims = ((0.3, 2.0, 0.45), (-0.3, 2.0, 0.45))
    one, other = (camera_at(e, a, K, (160, 120)) for e, a in zip(eyes, aims, strict=True))
    return one, other


def _on_plane(camera: Camera, point: Floats) -> Floats:
    """Return where the line from a camera's centre to a point meets the plane of its picture."""
    way = np.asarray(point) - camera.centre
    return np.asarray(camera.centre + NEAR / (camera.R[2] @ way) * way)


def _face(camera: Camera) -> Floats:
    """Return the corners of a camera's picture in space."""
    w, h = camera.image_size
    rays = camera.pixel_ray(np.array([[0, 0], [w, 0], [w, h], [0, h]]) - 0.5)
    return np.asarray(camera.centre + NEAR * rays / (rays @ camera.R[2])[:, None])


@figure(
    "Two cameras, a point and its two rays. Both rays and the baseline between the cameras lie in "
    "one plane, which cuts each picture in a line through its epipole."
)
def epipolar_plane() -> Figure:
    """Show the plane of two centres and a point, with everything that has a name.

    Returns
    -------
    Figure
        A view of both cameras from in front and above.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 4.3))
    sketch(ax)
    view = onlooker((0.5, -5.6, 5.4), (0.0, 1.15, 0.3), 900, (760, 400))
    one, other = sketched_cameras()
    show_face(ax, view, np.array([one.centre, other.centre, POINT]), "ray", alpha=0.13)
    show_path(ax, view, np.array([one.centre, other.centre]), "guide", lw=3)
    for camera, partner, n in ((one, other, 1), (other, one, 2)):
        show_face(ax, view, _face(camera), "image", alpha=0.22)
        show_path(ax, view, np.array([camera.centre, POINT]), "ray", lw=2)
        x, e = _on_plane(camera, POINT), _on_plane(camera, partner.centre)
        beyond = x + 0.45 * (x - e) / np.linalg.norm(x - e)
        show_path(ax, view, np.array([e, beyond]), "second", lw=2.5)
        _spot(ax, view, x, "image", f"$x_{n}$", (-15 if n == 1 else 16, -14))
        _spot(ax, view, e, "second", f"$e_{n}$", (0, 22))
        name = f"camera {n}, centre $C_{n}$"
        _spot(ax, view, camera.centre, "camera", name, (-34 if n == 1 else 20, 26))
    _spot(ax, view, POINT, "object", "$X$", (0, -18))
    part = view.project(0.71 * one.centre + 0.29 * other.centre)
    write(ax, part + np.array([0, 20]), "baseline", "guide", fontsize=11, bbox=PAPER)
    inside = view.project((one.centre + other.centre + 2.2 * POINT) / 4.2)
    write(ax, inside, "epipolar\nplane", fontsize=11)
    fit(ax, 0, 760, 400, 0)
    return fig


def _spot(
    ax: Axes, view: Camera, point: Floats, role: str, name: str, away: tuple[float, float]
) -> None:
    """Mark a point of space with its name."""
    at = view.project(point)
    ax.plot(*at, "o", color=ROLES[role], ms=7, mec="white")
    colour = None if role in ("ray", "second") else role  # too light for letters
    write(ax, at + away, name, colour, fontsize=12, bbox=PAPER)


#: A pair for the four poses, from above: camera 2 to the right, turned a little to the left.
TURN, SHIFT = rotation_y(np.radians(35)), np.array([-1.15, 0, 0.8])
SEEN = np.array([-1.1, 0, 2.0])


@figure(
    "Four relative poses with the same essential matrix, from above. Only in one of them the two "
    "rays meet in front of both cameras."
)
def four_poses() -> Figure:
    """Show the four poses that one essential matrix allows, and where two rays meet in each.

    Returns
    -------
    Figure
        Four panels, seen from above.
    """
    fig, axes = panels(1, 4, (FULL_WIDTH, 2.7))
    second = TURN @ SEEN + SHIFT
    for ax, (R, t) in zip(axes, poses_from_essential(skew(SHIFT) @ TURN), strict=True):
        depths = _depths(R, t, SEEN / SEEN[2], second / second[2])
        in_front = [bool(z > 0) for z in depths]
        both = all(in_front)
        count = sum(in_front)
        said = ("behind both", "behind one", "in front of both")[count]
        sketch(ax)
        ax.set_title(said, fontsize=10, color=ROLES["image"] if both else GREY)
        point = depths[0] * SEEN / SEEN[2]
        centre = camera_centre(R, t)
        for at, role in ((np.zeros(3), "camera"), (centre, "second")):
            ax.plot(*np.stack([at, point])[:, [0, 2]].T, color=ROLES["ray"], lw=1.5)
            forward = np.array([0, 0, 1.0]) if role == "camera" else R[2]
            _from_above(ax, at, forward, role)
        ax.plot(point[0], point[2], "o", color=ROLES["object"], ms=7, mec="white")
        fit(ax, -2.1, 1.8, -2.0, 2.4)
    write(axes[0], (-0.2, -1.3), "blue: camera 1", fontsize=9)
    write(axes[0], (-0.2, -1.75), "purple: camera 2", fontsize=9)
    return fig


def _depths(R: Floats, t: Floats, x1: Floats, x2: Floats) -> Floats:
    """Return Z1 and Z2 with ``Z2 x2 = Z1 R x1 + t``, by least squares."""
    A = np.column_stack([R @ x1, -x2])
    return np.asarray(np.linalg.lstsq(A, -t, rcond=None)[0])


def _from_above(ax: Axes, centre: Floats, forward: Floats, role: str) -> None:
    """Draw a camera from above: a wide triangle, a dot at its centre, an arrow along its view."""
    at, way = centre[[0, 2]], forward[[0, 2]] / np.linalg.norm(forward[[0, 2]])
    across = np.array([way[1], -way[0]])
    corners = np.array([at, at + 0.35 * way + 0.5 * across, at + 0.35 * way - 0.5 * across])
    ax.fill(*corners.T, fc=ROLES[role], ec=ROLES[role], lw=1.5, alpha=0.4)
    look = {"arrowstyle": "-|>", "color": ROLES[role], "lw": 2, "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", xy=tuple(at + way), xytext=tuple(at), arrowprops=look)
    ax.plot(*at, "o", color=ROLES[role], ms=6, mec="white")
