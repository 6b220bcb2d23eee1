"""Still figures: where a camera is, its pixels, its gimbal, and the axes of photogrammetry."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from course_lib.camera import Camera
from course_lib.drawing.diagrams import Floats, figure, fit, panels, sketch, stroke, write
from course_lib.drawing.space import onlooker, show_arrow, show_axes, show_frustum, show_path
from course_lib.drawing.style import BLACK, FULL_WIDTH, GREY, ROLES
from course_lib.transforms import gimbal_pose

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

FLIP = np.diag([1.0, -1.0, -1.0])  # x right, y down, z forward to x right, y up, z backwards


@figure(
    "A camera in the world. One arrow leads from the world's origin to the camera: its centre C. "
    "The other leads from the camera to the world's origin: t, measured along the camera's axes."
)
def where_is_it() -> Figure:
    """Show the difference between the centre of a camera and its translation t.

    Returns
    -------
    Figure
        World frame, camera frame, and both vectors.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 4.2))
    sketch(ax)
    view = onlooker((3.4, -6.4, 3.6), (0.5, 0.6, 0.75), 1080)
    camera = onlooker((1.1, 0.9, 1.4), (0.9, 4.0, 1.0), 700)
    show_frustum(ax, view, camera, depth=1.1, name="")
    world = np.array([-1.5, 0.2, 0.0])
    show_axes(ax, view, world, 0.8 * np.eye(3), "XYZ", "guide", "world")
    show_axes(ax, view, camera.centre, 0.8 * camera.R, "xyz", "camera")
    write(ax, view.project(camera.centre) + np.array([70.0, 40]), "camera", "camera")
    _both_ways(ax, view, world, camera.centre)
    ax.set(xlim=(0, 640), ylim=(460, 60))
    return fig


def _both_ways(ax: Axes, view: Camera, world: Floats, centre: Floats) -> None:
    """Draw C and t side by side, as they lie on one line."""
    a, b = view.project(world), view.project(centre)
    across = np.array([a[1] - b[1], b[0] - a[0]]) / np.linalg.norm(b - a)
    ways = (
        (a, b, "$C$, counted along\nthe world's X, Y, Z", "object", 5, "left"),
        (b, a, "$t$, counted along\nthe camera's x, y, z", "second", -5, "right"),
    )
    for start, end, name, role, side, ha in ways:
        shift = side * across
        arrow = {"arrowstyle": "-|>", "color": ROLES[role], "lw": 2, "shrinkA": 6, "shrinkB": 6}
        ax.annotate("", xy=tuple(end + shift), xytext=tuple(start + shift), arrowprops=arrow)
        write(ax, (a + b) / 2 + 5 * shift, name, ha=ha, fontsize=11)


@figure(
    "Three grids of pixels: square; higher than wide; slanted by a skew. Beside each, the circle "
    "that the same lens draws on it."
)
def pixel_shapes(aspect: float = 0.7, skew: float = 0.35) -> Figure:
    """Show what aspect and skew mean: the same light on three kinds of pixels.

    Parameters
    ----------
    aspect, skew : float
        The ratio fy / fx, and s / fx.

    Returns
    -------
    Figure
        Upper row: the sensors in millimetres. Lower row: their pictures in pixels.
    """
    fig, axes = panels(2, 3, (FULL_WIDTH, 4.6))
    turn = np.linspace(0, 2 * np.pi, 73)
    circle = 1.4 * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    kinds = {
        "square": np.eye(2),
        f"aspect {aspect:g}": np.diag([1.0, aspect]),
        f"skew {skew:g}": np.array([[1.0, skew], [0, 1]]),
    }
    for column, (name, pixel_from_mm) in zip(axes.T, kinds.items(), strict=True):
        _grid(sketch(column[0]), circle, np.linalg.inv(pixel_from_mm))
        column[0].set_title(name, loc="center")
        _grid(sketch(column[1]), circle @ pixel_from_mm.T, np.eye(2))
    for ax, words in zip(axes[:, 0], ("on the sensor", "in the picture"), strict=True):
        write(ax, (-3.35, 0), words, rotation=90, fontsize=10)
    return fig


def _grid(ax: Axes, circle: Floats, mm_from_pixel: Floats) -> None:
    """Draw 5 × 5 pixels, one of them coloured, and a circle of light."""
    for k in np.arange(-2.5, 3):
        for line in ([(-2.5, k), (2.5, k)], [(k, -2.5), (k, 2.5)]):
            stroke(ax, np.array(line) @ mm_from_pixel.T, "guide", lw=0.8)
    one = np.array([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]) @ mm_from_pixel.T
    ax.fill(*one.T, color=ROLES["image"], alpha=0.5, lw=0)
    stroke(ax, circle, "ray", lw=2.5)
    fit(ax, -3.7, 3.6, 3.7, -3.7)  # v down


@figure(
    "How a camera is aimed: z points to the target, x is level, at right angles to z and to the "
    "direction up, and y is at right angles to both."
)
def looking_at() -> Figure:
    """Show how the axes of a camera follow from its place, its target and the direction up.

    Returns
    -------
    Figure
        Camera, target, the direction up, and the three axes.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.5))
    sketch(ax)
    view = onlooker((3.0, -5.4, 3.4), (0.6, 0.6, 3.4), 1000)  # level: upright lines stay upright
    target = np.array([1.9, 2.2, 0.2])
    camera = onlooker((-0.5, -0.3, 1.2), target, 700)
    show_path(ax, view, np.array([camera.centre, target]), "guide", lw=1.2, ls=(0, (5, 3)))
    show_arrow(ax, view, camera.centre, camera.centre + np.array([0, 0, 0.8]), "image")
    write(ax, view.project(camera.centre + np.array([0, 0, 0.9])), "up", "image")
    show_axes(ax, view, camera.centre, 0.8 * camera.R, "xyz", "camera")
    for point, name in ((target, "target"), (camera.centre, "camera")):
        ax.plot(*view.project(point), "o", color=BLACK, ms=8)
        write(ax, view.project(point) + np.array([-12.0, 14]), name, ha="right")
    ax.set(xlim=(0, 640), ylim=(790, 430))
    return fig


@figure(
    "A camera on a gimbal: the two axes cross in the mount, and the centre of projection is "
    "offset from it, so that it moves on a circle when the gimbal pans."
)
def gimbal(pan_deg: float = 25.0, tilt_deg: float = 15.0) -> Figure:
    """Show a camera on a gimbal, its two axes, and the way of its centre.

    Parameters
    ----------
    pan_deg, tilt_deg : float
        How it is turned, degrees.

    Returns
    -------
    Figure
        Mast, axes, camera frame and the path of the centre of projection.
    """
    pan, tilt = np.radians([pan_deg, tilt_deg])
    mount, offset = np.array([0.0, 0, 1.2]), np.array([0.0, -0.25, 0.45])
    view = onlooker((3.4, -3.6, 2.6), (0.2, 0.2, 1.35), 1200)
    fig, ax = panels(1, 1, (FULL_WIDTH, 4.4))
    sketch(ax)
    place = [gimbal_pose(a, tilt, mount, offset) for a in np.linspace(-np.pi, np.pi, 91)]
    show_path(ax, view, np.array([-R.T @ t for R, t in place]), "second", lw=1.2, ls=(0, (4, 3)))
    R, t = gimbal_pose(pan, tilt, mount, offset)
    _mount(ax, view, mount, {"pan axis": np.array([0, 0, 0.8]), "tilt axis": 0.85 * R[0]})
    K = np.array([[700.0, 0, 319.5], [0, 700, 239.5], [0, 0, 1]])
    camera = Camera(K, R, t, (640, 480))
    show_path(ax, view, np.array([mount, camera.centre]), "object", lw=2.5)
    low = view.project(mount + 0.25 * (camera.centre - mount))
    write(ax, low - np.array([14.0, 0]), "offset", "object", ha="right")
    left = min((view.project(-R.T @ t) for R, t in place), key=lambda pixel: float(pixel[0]))
    write(ax, left - np.array([10.0, 0]), "way of the hole\nas it pans", ha="right")
    show_frustum(ax, view, camera, depth=0.7, name="")
    show_axes(ax, view, camera.centre, 0.45 * R, "xyz", "camera")
    ax.set(xlim=(80, 600), ylim=(440, 30))
    return fig


def _mount(ax: Axes, view: Camera, mount: Floats, axes: dict[str, Floats]) -> None:
    """Draw a mast and the two axes that cross on top of it."""
    show_path(ax, view, np.array([mount - (0, 0, 0.5), mount]), "guide", lw=6)
    for name, axis in axes.items():
        show_arrow(ax, view, mount, mount + axis, "image")
        place = view.project(mount + 1.05 * axis)
        level = abs(axis[2]) < 0.5
        aside = np.array([-8.0, 12.0]) if level else np.array([-14.0, 0.0])
        write(ax, place + aside, name, "image", ha="right", va="top" if level else "center")
    ax.plot(*view.project(mount), "o", color=BLACK, ms=8)
    write(ax, view.project(mount) + np.array([-14.0, 8]), "mount", ha="right")


@figure(
    "One camera with two sets of axes. Computer vision: x right, y down, z forward. Graphics and "
    "photogrammetry: x right, y up, z backwards."
)
def two_conventions() -> Figure:
    """Show one camera with the axes of computer vision, and with those of other programs.

    Returns
    -------
    Figure
        The same frustum twice.
    """
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.3))
    view = onlooker((3.9, -2.4, 2.5), (0.2, 0.6, 0.25), 820)
    camera = onlooker((0, 0, 0.3), (0, 4, 0.3), 700)
    titles = ("this course, OpenCV", "Blender, OpenGL, photogrammetry")
    for ax, axes_of, title in zip(axes, (camera.R, FLIP @ camera.R), titles, strict=True):
        sketch(ax, title)
        show_frustum(ax, view, camera, depth=1.8)
        show_axes(ax, view, camera.centre, 0.8 * axes_of, "xyz", "camera")
        ax.plot(*view.project(camera.centre), "o", color=GREY, ms=7)
        ax.set(xlim=(-60, 560), ylim=(420, 70))
    return fig
