"""Pieces of figures in space, drawn as the course's own camera sees them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from course_lib.camera import Camera, camera_at
from course_lib.drawing.diagrams import Floats, write
from course_lib.drawing.style import GREY, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def onlooker(
    eye: ArrayLike, target: ArrayLike, f: float, size: tuple[int, int] = (640, 480)
) -> Camera:
    """Return the camera through which a figure shows space, or a small one to be shown.

    Parameters
    ----------
    eye, target : array_like, shape (3,)
        Where it stands, and what is in the middle.
    f : float
        Focal length, px.
    size : tuple of int
        Width and height, px.

    Returns
    -------
    Camera
        The camera.
    """
    K = np.array([[f, 0, (size[0] - 1) / 2], [0, f, (size[1] - 1) / 2], [0, 0, 1]])
    return camera_at(eye, target, K, size)


def show_path(ax: Axes, view: Camera, points: ArrayLike, role: str, **options: Any) -> None:
    """Draw a polyline through points of space (N, 3) in the colour of a role."""
    ax.plot(*view.project(points).T, **{"color": ROLES[role], "lw": 2, **options})


def show_face(ax: Axes, view: Camera, corners: ArrayLike, role: str, alpha: float = 0.2) -> None:
    """Fill a polygon of space (N, 3) in the colour of a role, and draw its outline."""
    seen = view.project(corners)
    ax.fill(*seen.T, fc=ROLES[role], alpha=alpha, ec="none")
    ax.plot(*np.vstack([seen, seen[:1]]).T, color=ROLES[role], lw=1.5)


def show_arrow(ax: Axes, view: Camera, start: ArrayLike, end: ArrayLike, role: str) -> None:
    """Draw an arrow between two points of space."""
    (u, v), tip = view.project(start), view.project(end)
    arrow = {"arrowstyle": "-|>", "color": ROLES[role], "lw": 2, "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", xy=tuple(tip), xytext=(u, v), arrowprops=arrow)


def show_axes(
    ax: Axes,
    view: Camera,
    origin: ArrayLike,
    directions: Floats,
    names: str,
    role: str,
    label: str = "",
) -> None:
    """Draw a frame: arrows from `origin` along the rows of `directions`, their names, its name."""
    start = view.project(origin)
    for name, direction in zip(names, directions, strict=True):
        show_arrow(ax, view, origin, np.asarray(origin) + direction, role)
        tip = view.project(np.asarray(origin) + direction)
        beyond = tip + 13 * (tip - start) / np.linalg.norm(tip - start)
        write(ax, beyond, f"${name}$", role, fontsize=13)
    if label:
        ax.text(start[0] - 8, start[1] + 14, label, color=ROLES[role], ha="right", va="center")


def show_frustum(
    ax: Axes, view: Camera, camera: Camera, depth: float = 2.0, name: str = "picture"
) -> None:
    """Draw a camera's image plane at a depth, with its name, and the four edges of its view."""
    width, height = camera.image_size
    corners = np.array([[0, 0], [width, 0], [width, height], [0, height]]) - 0.5
    rays = np.column_stack([corners, np.ones(4)]) @ np.linalg.inv(camera.K).T * depth
    world = (rays - camera.t) @ camera.R
    show_face(ax, view, world, "image", alpha=0.18)
    for corner in world:
        ax.plot(*view.project([camera.centre, corner]).T, color=GREY, lw=0.8)
    u, v = view.project(world).mean(axis=0)
    if name:
        ax.text(u + 20, v + 14, name, color=ROLES["image"], ha="center")
