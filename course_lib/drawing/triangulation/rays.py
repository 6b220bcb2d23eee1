"""Still figures of rays: two that miss each other, and a plane of light that one meets."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from course_lib.camera import Camera
from course_lib.drawing.diagrams import Floats, figure, fit, panels, same_shape, sketch, write
from course_lib.drawing.space import onlooker
from course_lib.drawing.style import FULL_WIDTH, ROLES
from course_lib.triangulation import closest_points_on_rays

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: From the frame of a camera, y down, to that of the onlooker, z up.
UPRIGHT = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
#: The rays of the worked example.
ORIGINS = np.array([[0.0, 0, 0], [1, 2, 0]])
DIRECTIONS = np.array([[0.0, 0, 1], [-1, 0, 5]])
OUTSIDE = "yours: not all inside the figure"
CORNER = np.array([1.6, 1.4, 5.2])  # where the arrows of the axes begin
LENGTH = 6.3  # of the rays as they are drawn, along z


@figure("Two rays in space pass each other; the shortest way between them is at right angles.")
def two_rays(yours: Any = None) -> Figure:
    """Show the two rays of the worked example, where they come closest, and a student's points.

    Parameters
    ----------
    yours : tuple of two array_like, shape (3,), optional
        Closest points of both rays.

    Returns
    -------
    Figure
        Rays, the way between them, and stars at a student's points.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.75, 3.6))
    sketch(ax)
    view = onlooker((6.5, -3.2, 2.6), (0.3, 3.0, -1.0), 760, (640, 400))
    ends = ORIGINS + DIRECTIONS * (LENGTH / DIRECTIONS[:, 2:])
    for number, role in enumerate(("camera", "second")):
        _path(ax, view, [ORIGINS[number], ends[number]], role, lw=2.5)
        _spot(ax, view, ORIGINS[number], role, "s", 9)
    one, other = closest_points_on_rays(ORIGINS[0], DIRECTIONS[0], ORIGINS[1], DIRECTIONS[1])
    _path(ax, view, [one, other], "object", lw=2.5)
    _helps(ax, view, one, other)
    for point, role in ((one, "camera"), (other, "second")):
        _spot(ax, view, point, role, "o", 8)
    _named(ax, view, one, other)
    drawn = _pair(yours)
    for point in drawn:
        _spot(ax, view, point, "ray", "*", 17)
    if yours is not None and len(drawn) < 2:
        write(ax, (480, -370), OUTSIDE, "guide")
    fit(ax, 10, 630, -440, -40)
    return fig


def _named(ax: Axes, view: Camera, one: Floats, other: Floats) -> None:
    """Write names beside the ends of both rays and beside the way between them."""
    names = (
        (ORIGINS[0], "$\\mathbf{o}_1 = (0, 0, 0)$", "camera", (20, -24)),
        (ORIGINS[1], "$\\mathbf{o}_2 = (1, 2, 0)$", None, (20, -24)),
        (0.5 * (ORIGINS[0] + one), "$\\mathbf{d}_1 = (0, 0, 1)$", "camera", (0, 22)),
        (0.5 * (ORIGINS[1] + other), "$\\mathbf{d}_2 = (-1, 0, 5)$", None, (76, -14)),
        (one, "$(0, 0, 5)$", "camera", (0, 22)),
        (other, "$(0, 2, 5)$", None, (44, -8)),
        (
            (one + other) / 2,
            "along $\\mathbf{n} = \\mathbf{d}_1 \\times \\mathbf{d}_2$",
            "object",
            (90, 0),
        ),
    )
    for at, text, role, (right, up) in names:
        u, v = view.project(UPRIGHT @ at)
        write(ax, (u + right, -v + up), text, role)


def _helps(ax: Axes, view: Camera, one: Floats, other: Floats) -> None:
    """Draw both right angles, the arrows of both directions, and those of x, y and z."""
    for end, way, along in ((one, other - one, 0), (other, one - other, 1)):
        _right_angle(ax, view, end, way, -DIRECTIONS[along])
    for number, role in enumerate(("camera", "second")):
        _arrow(ax, view, ORIGINS[number], DIRECTIONS[number], role)
    for name, axis in zip("xyz", np.eye(3), strict=True):
        _arrow(ax, view, CORNER, 0.6 * axis, "guide", f"${name}$")


def _right_angle(ax: Axes, view: Camera, at: Floats, one: Floats, other: Floats) -> None:
    """Draw a small square between two directions at a point of space."""
    a, b = (0.28 * v / np.linalg.norm(v) for v in (one, other))
    _path(ax, view, [at + a, at + a + b, at + b], "guide", lw=1.5, zorder=4)


def _arrow(
    ax: Axes, view: Camera, start: Floats, way: Floats, role: str, name: str | None = None
) -> None:
    """Draw an arrow of space: a long one of a ray, or a thin one of an axis with its name."""
    (u, v), (u2, v2) = view.project(np.stack([start, start + way]) @ UPRIGHT.T)
    thin = name is not None
    look = {"arrowstyle": "-|>", "color": ROLES[role], "lw": 1.2 if thin else 4, "shrinkA": 0}
    look |= {"shrinkB": 0, "mutation_scale": 10 if thin else 22}
    ax.annotate("", (u2, -v2), (u, -v), arrowprops=look, zorder=4)
    if name is not None:
        write(ax, (1.3 * u2 - 0.3 * u, -1.3 * v2 + 0.3 * v), name, role, fontsize=10)


def _path(ax: Axes, view: Camera, points: ArrayLike, role: str, **options: Any) -> None:
    """Draw a polyline of the camera's frame, up in the figure being up."""
    u, v = view.project(np.asarray(points) @ UPRIGHT.T).T
    ax.plot(u, -v, color=ROLES[role], **options)


def _spot(ax: Axes, view: Camera, point: Floats, role: str, marker: str, size: float) -> None:
    u, v = view.project(UPRIGHT @ point)
    ax.plot(
        u, -v, marker, color=ROLES[role], ms=size, zorder=5, mec="black" if marker == "*" else None
    )


def _pair(yours: Any) -> list[Floats]:
    """Return a student's two points, those that are points."""
    if not isinstance(yours, tuple | list) or len(yours) != 2:
        return []
    points = [same_shape(one, np.zeros(3)) for one in yours]
    seen = [one for one in points if one is not None and np.isfinite(one).all()]
    return [one for one in seen if np.abs(one).max() < 8]
