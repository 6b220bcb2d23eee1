"""Still figures: moves one after another, turns in the plane and turns in space."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.diagrams import (
    Floats,
    figure,
    fit,
    panels,
    same_shape,
    sketch,
    stroke,
    write,
)
from course_lib.drawing.space import onlooker, show_arrow, show_face, show_path
from course_lib.drawing.style import BLACK, FULL_WIDTH, GREY, ROLES
from course_lib.homogeneous import apply_homography
from course_lib.transforms import (
    rotation_about_axis,
    rotation_x,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: A flag on a pole: its corners in a plane.
FLAG = np.array([[0, 0], [0, 1.0], [0.7, 0.8], [0, 0.6]])
#: The slanted hinges of a door, and the corners of the door in space, m; it hangs on the hinges.
AXIS = np.array([1.0, -1.0, 2.0])
_ALONG, _ACROSS = AXIS / np.sqrt(6), np.array([1.0, 1.0, 0]) / np.sqrt(2)
DOOR = np.array([[0, 0], [1.3, 0], [1.3, 0.55], [1.0, 0.8], [0, 0.8]]) @ [_ALONG, _ACROSS]


@figure(
    "Two paths of one flag. Turned by {angle_deg:g} degrees and then moved 2 to the right, it ends "
    "beside its start; moved and then turned, it ends elsewhere."
)
def order_matters(angle_deg: float = 60.0, way: float = 2.0) -> Figure:
    """Show a turn and a translation in both orders.

    Parameters
    ----------
    angle_deg, way : float
        Angle of the turn, degrees, and length of the translation along x.

    Returns
    -------
    Figure
        The flag before, between and after, for both orders.
    """
    c, s = np.cos(np.radians(angle_deg)), np.sin(np.radians(angle_deg))
    R = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    T = np.array([[1, 0, way], [0, 1, 0], [0, 0, 1]])
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.2))
    titles = (r"$T\,R$: turn, then move", r"$R\,T$: move, then turn")
    for ax, steps, title in zip(axes, ((R, T @ R), (T, R @ T)), titles, strict=True):
        sketch(ax, title)
        _ruled_axes(ax, 3, 2)
        for H, role, alpha in zip(
            (np.eye(3), *steps), ("guide", "camera", "object"), (0.25, 0.25, 0.7), strict=True
        ):
            corners = apply_homography(FLAG, H)
            ax.fill(*corners.T, color=ROLES[role], alpha=alpha, lw=0)
            stroke(ax, corners[:2], role, lw=3)
            ax.plot(*corners[0], "o", color=ROLES[role], ms=6)
        foot = "({:.3g}, {:.3g})".format(*corners[0] + 0.0)
        write(ax, corners[0] + np.array([0.12, 0.12]), foot, "object", ha="left", va="bottom")
        fit(ax, -1.3, way + 1.4, -0.5, way + 0.8)
    return fig


def _ruled_axes(ax: Axes, right: int, top: int) -> None:
    """Draw the two axes of a plane with a tick and a number at each unit."""
    ax.axhline(0, color=GREY, lw=0.8)
    ax.axvline(0, color=GREY, lw=0.8)
    for k in range(1, right + 1):
        stroke(ax, np.array([(k, -0.06), (k, 0.06)]), lw=0.8)
        write(ax, (k, -0.24), f"{k}", "guide", fontsize=9)
    for k in range(1, top + 1):
        stroke(ax, np.array([(-0.06, k), (0.06, k)]), lw=0.8)
        write(ax, (-0.2, k), f"{k}", "guide", fontsize=9)


@figure(
    "One rotation matrix, angle {angle_deg:g} degrees, in two frames. With y up it turns a flag "
    "counter-clockwise; with y down, as in pictures, the same matrix turns it clockwise."
)
def clockwise(angle_deg: float = 30.0) -> Figure:
    """Show what one matrix does where y points up, and where y points down.

    Parameters
    ----------
    angle_deg : float
        The angle in the matrix, degrees.

    Returns
    -------
    Figure
        A flag before and after, on school's axes and on those of a picture.
    """
    c, s = np.cos(np.radians(angle_deg)), np.sin(np.radians(angle_deg))
    R = np.array([[c, -s], [s, c]])
    arm = np.array([[0.0, 0], [1.0, 0], [0.85, 0.3], [0.7, 0]])
    fig, axes = panels(1, 2, (FULL_WIDTH, 2.9))
    for ax, down, title in zip(axes, (1, -1), ("y up", "y down"), strict=True):
        sketch(ax, title)
        for corners, role in ((arm, "guide"), (arm @ R.T, "object")):
            drawn = corners * [1, down]
            ax.fill(*drawn.T, color=ROLES[role], alpha=0.6, lw=0)
            stroke(ax, drawn[:2], role, lw=3)
        turn = np.radians(np.linspace(0, angle_deg, 20))
        arc = 1.12 * np.stack([np.cos(turn), down * np.sin(turn)], axis=1)
        arrow = {"arrowstyle": "-|>", "color": BLACK, "shrinkA": 0, "shrinkB": 0}
        ax.plot(*arc.T, color=BLACK, lw=1.2)
        ax.annotate("", xy=tuple(arc[-1]), xytext=tuple(arc[-3]), arrowprops=arrow)
        _cross(ax, down)
        fit(ax, -0.4, 1.5, min(-0.3, down * 1.2), max(0.3, down * 1.2))
    return fig


def _cross(ax: Axes, down: int) -> None:
    """Draw the two axes of a plane, y up (1) or down (-1)."""
    arrow = {"arrowstyle": "-|>", "color": GREY, "shrinkA": 0, "shrinkB": 0}
    for tip, name in (((1.35, 0), "$x$"), ((0, 1.05 * down), "$y$")):
        ax.annotate("", xy=tip, xytext=(0, 0), arrowprops=arrow)
        write(ax, (tip[0] * 1.06, tip[1] * 1.1), name, "guide", fontsize=13)


@figure("A door on slanted hinges, opened by several angles; one corner runs on a circle.")
def opening_door(angles: ArrayLike, yours: Sequence[ArrayLike | None] = ()) -> Figure:
    """Show a door turned about its hinges, which point along `AXIS`.

    Parameters
    ----------
    angles : array_like, shape (N,)
        Angles, rad.
    yours : sequence of array_like, shape (3, 3), or None
        Rotation matrices that a student's function gave for them.

    Returns
    -------
    Figure
        Open circles: one corner by the course's function. Coloured doors: the student's.
    """
    angles = np.asarray(angles, dtype=float)
    view = onlooker((3.4, -4.6, 2.4), (0.0, 0.0, 0.45), 1250)
    fig, ax = panels(1, 1, (6.4, 4.4))
    sketch(ax)
    circle = [rotation_about_axis(AXIS, a) @ DOOR[3] for a in np.linspace(0, 2 * np.pi, 90)]
    show_path(ax, view, np.array(circle), "guide", lw=1, ls=(0, (4, 3)))
    show_face(ax, view, DOOR, "guide", alpha=0.45)
    show_arrow(ax, view, -0.3 * _ALONG, 1.7 * _ALONG, "camera")
    write(ax, view.project(1.95 * _ALONG), "hinges", "camera")
    for angle, R in zip(angles, [*yours, *[None] * len(angles)], strict=False):
        ax.plot(*view.project(rotation_about_axis(AXIS, angle) @ DOOR[3]), "o", mfc="none", **_RING)
        drawn = same_shape(R, np.eye(3))
        if drawn is not None and (np.abs(drawn) < 1e9).all():
            show_face(ax, view, DOOR @ drawn.T, "second", alpha=0.2)
    _legend(ax, len(yours) > 0 and yours[0] is not None)
    ax.set(xlim=(80, 560), ylim=(430, 20))
    return fig


_RING: dict[str, Any] = {"color": BLACK, "ms": 11, "mew": 1.5}


def _legend(ax: Axes, drawn: bool) -> None:
    """Say what is the course's and what is the student's."""
    ax.plot([], [], "o", mfc="none", label="the course's function", **_RING)
    if drawn:
        ax.fill([], [], color=ROLES["second"], alpha=0.4, label="your function")
    ax.legend(loc="lower left")


@figure(
    "A vector X and an axis n. The part of X along the axis stays; the part across it turns by "
    "{angle_deg:g} degrees on a circle around the axis."
)
def split_by_axis(angle_deg: float = 110.0) -> Figure:
    """Show the parts of a vector that a turn about an axis keeps and turns.

    Parameters
    ----------
    angle_deg : float
        Angle of the turn, degrees.

    Returns
    -------
    Figure
        Axis, vector, its two parts and the vector after the turn; the circle from above.
    """
    n, X = np.array([0.0, 0, 1]), np.array([-0.8, -0.45, 0.9])
    along, R = n * (n @ X), rotation_about_axis(n, np.radians(angle_deg))
    view = onlooker((3.0, -4.4, 2.3), (0.0, 0.0, 0.55), 1180)
    fig, (ax, above) = panels(1, 2, (FULL_WIDTH, 3.7), width_ratios=(3, 2))
    sketch(ax)
    _circle_from_above(sketch(above, "the circle, seen from above"), angle_deg)
    reach = np.linalg.norm(X - along)
    show_path(ax, view, along + reach * _ring(n), "guide", lw=1, ls=(0, (4, 3)))
    show_arrow(ax, view, 0 * n, 1.5 * n, "camera")
    show_path(ax, view, np.array([0 * n, along]), "image", lw=5)
    for end, name in ((X, "$X$"), (R @ X, "$R X$")):
        show_arrow(ax, view, 0 * n, end, "object")
        show_path(ax, view, np.array([along, end]), "image", lw=2.5)
        write(ax, view.project(1.12 * end), name, fontsize=13)
    write(ax, view.project(1.58 * n), "axis $n$", "camera")
    write(ax, view.project(0.5 * along) - np.array([30.0, 0]), "stays", "image")
    middle = rotation_about_axis(n, np.radians(angle_deg) / 2) @ X
    write(ax, view.project(0.6 * along + 0.62 * middle), "turns", "image")
    ax.set(xlim=(60, 580), ylim=(400, 20))
    return fig


def _circle_from_above(ax: Axes, angle_deg: float) -> None:
    """Draw the part across the axis, n × X, and what of both the turned part is made of."""
    angle = np.radians(angle_deg)
    c, s = np.cos(angle), np.sin(angle)
    stroke(ax, _ring(np.array([0.0, 0, 1]))[:, :2], "guide", lw=1)
    for tip, role, name, place in (
        ((1, 0), "image", "across", (1.12, -0.16)),
        ((0, 1), "camera", r"$n \times X$", (0.34, 1.12)),
        ((c, s), "image", "turned", (1.24 * c - 0.08, 1.15 * s)),
    ):
        look = {"arrowstyle": "-|>", "color": ROLES[role], "lw": 2, "shrinkA": 0, "shrinkB": 0}
        ax.annotate("", xy=tip, xytext=(0, 0), arrowprops=look)
        write(ax, place, name, role)
    stroke(ax, np.array([(0, 0), (c, 0)]), "image", lw=5)
    stroke(ax, np.array([(c, 0), (c, s)]), "camera", lw=5)
    write(ax, (c / 2, -0.17), r"$\cos\theta$", "image")
    write(ax, (c - 0.27, s / 2), r"$\sin\theta$", "camera")
    fit(ax, -1.5, 1.5, -1.2, 1.35)


@figure(
    "A camera's three turning axes, drawn as rings. At a tilt of 90 degrees the ring of the pan "
    "and the ring of the roll lie in one plane."
)
def gimbal_lock(tilts_deg: Sequence[float] = (20.0, 90.0)) -> Figure:
    """Show the axes of pan, tilt and roll, and what becomes of them at a tilt of 90°.

    Parameters
    ----------
    tilts_deg : sequence of float
        Tilt of each drawing, degrees.

    Returns
    -------
    Figure
        Three rings; each axis is the one about which its ring turns the camera.
    """
    fig, axes = panels(1, len(tilts_deg), (FULL_WIDTH, 3.6))
    view = onlooker((3.4, -4.6, 2.6), (0, 0, 0), 1080)
    for ax, tilt in zip(axes, np.radians(tilts_deg), strict=True):
        sketch(ax, f"tilt {np.degrees(tilt):.0f}°")
        turns = (
            ("pan", np.array([0.0, 0, 1]), 1.0, "camera"),
            ("tilt", np.array([1.0, 0, 0]), 0.86, "image"),
            ("roll", rotation_x(tilt) @ (0.0, 1.0, 0.0), 0.72, "object"),
        )
        for name, axis, radius, role in turns:
            show_path(ax, view, radius * _ring(axis), role, lw=3)
            show_arrow(ax, view, 0 * axis, (1.0 if name == "roll" else 1.3) * axis, role)
            shift = 1.12 if name == "roll" else 1.42
            write(ax, view.project(shift * axis) + _aside(name, axis), name, role)
        ax.set(xlim=(60, 580), ylim=(470, 10))
    return fig


def _aside(name: str, axis: Floats) -> Floats:
    """Keep the names of two axes apart where they lie on one line."""
    return np.array([46.0, 12.0]) if name == "roll" and abs(axis[2]) > 0.99 else np.zeros(2)


def _ring(axis: Floats) -> Floats:
    """Return points of the unit circle at right angles to a unit vector."""
    first = np.cross(axis, (0.3, 0.5, 0.8))
    first = first / np.linalg.norm(first)
    turn = np.linspace(0, 2 * np.pi, 91)[:, None]
    return np.asarray(np.cos(turn) * first + np.sin(turn) * np.cross(axis, first))
