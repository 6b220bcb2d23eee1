"""Still figures: rays as vectors, principal planes, and a zoom of two lenses."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.diagrams import (
    dimension,
    figure,
    fit,
    in_figures,
    panels,
    same_shape,
    sketch,
    stroke,
    write,
)
from course_lib.drawing.lenses.imaging import lens_shape
from course_lib.drawing.style import BLACK, FULL_WIDTH, ROLES
from course_lib.optics import free_space, lens_system, thin_lens

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@figure("A way of length d changes a ray's height, a thin lens changes its angle.")
def ray_steps(d: float = 4.0, f: float = 3.0) -> Figure:
    """Show what free space and a thin lens do to a ray.

    Parameters
    ----------
    d, f : float
        Length of the way and focal length, one unit of length.

    Returns
    -------
    Figure
        Two side views with the ray before and after.
    """
    fig, axes = panels(1, 2, (FULL_WIDTH, 2.7))
    for ax, title in zip(axes, ("free space", "thin lens"), strict=True):
        sketch(ax, title)
        stroke(ax, [(-0.5, 0), (5.2, 0)], "guide", lw=1, ls=(0, (8, 4)))
        fit(ax, -1.0, 5.6, -0.9, 2.5)
    y, angle = 0.6, 0.28
    y2, _ = free_space(d) @ (y, angle)
    stroke(axes[0], [(0, y), (d, y2)], "ray")
    for x, height, name in ((0, y, "$y$"), (d, y2, "$y + d\\,\\theta$")):
        stroke(axes[0], [(x, 0), (x, height)], "object", lw=1.5)
        write(axes[0], (x + 0.12, height / 2), name, "object", ha="left")
    stroke(axes[0], [(0, y), (1.5, y)], "guide", lw=1)
    write(axes[0], (1.15, y + 0.13), r"$\theta$")
    dimension(axes[0], (0, -0.45), (d, -0.45), "$d$")
    at, height = 2.2, 1.3
    after = (thin_lens(f) @ (height, angle))[1]
    stroke(axes[1], [(0, height - angle * at), (at, height), (5, height + after * (5 - at))], "ray")
    stroke(axes[1], [(at, 0), (at, height)], "object", lw=1.5)
    lens_shape(axes[1], at, 3.4)
    write(axes[1], (at + 0.25, 0.5), "$y$", "object", ha="left")
    write(axes[1], (0.7, 1.35), r"$\theta$")
    write(axes[1], (4.0, 1.55), r"$\theta - y/f$", ha="left")
    fit(axes[1], -1.0, 5.6, -0.9, 2.5)
    return fig


@figure("Two lenses act like a single one that stands in their back principal plane.")
def principal_planes(f1: float = 50.0, f2: float = -30.0, d: float = 30.0) -> Figure:
    """Show a parallel ray through two lenses, and the one lens that does the same.

    Parameters
    ----------
    f1, f2, d : float
        Focal lengths and distance of the lenses, mm; the whole must collect light.

    Returns
    -------
    Figure
        Side view, heights enlarged, with the back principal plane and the focal length.
    """
    f, _, back = lens_system(f1, f2, d)
    plane, focus, y = d + back, d + back + f, 10.0
    at_second, _ = free_space(d) @ thin_lens(f1) @ (y, 0)
    left = min(plane, 0) - 15
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.3))
    sketch(ax)
    ax.set_aspect("auto")
    stroke(ax, [(left, 0), (focus + 8, 0)], "guide", lw=1, ls=(0, (8, 4)))
    for side in (-1, 1):
        ray = [(left, y), (0, y), (d, at_second), (focus, 0)]
        stroke(ax, [(x, side * height) for x, height in ray], "ray")
        stroke(ax, [(plane, side * y), (d, side * at_second)], "ray", lw=1.2, ls=":")
    for x, lens in ((0, f1), (d, f2)):
        _glass(ax, x, lens)
        write(ax, (x, 15.2), f"{lens:g} mm".replace("-", "−"), "camera")
    stroke(ax, [(plane, -13), (plane, 13)], "second", lw=1.8, ls=(0, (5, 3)))
    write(ax, (plane, 15.2), "$H'$")
    ax.plot(focus, 0, "o", color=BLACK, ms=7, zorder=5)
    write(ax, (focus, 2.5), "$F'$")
    dimension(ax, (plane, -16), (focus, -16), f"f = {f:.0f} mm")
    dimension(ax, (0, -20.5), (focus, -20.5), f"{focus:.0f} mm from the first lens to the sensor")
    fit(ax, left - 2, focus + 10, -22.5, 17.5)
    return fig


def _glass(ax: Axes, x: float, f: float) -> None:
    """Draw a lens as a line whose tips say whether it collects or spreads light."""
    out = 2.0 if f > 0 else -2.0
    stroke(ax, [(x, -12), (x, 12)], "camera", lw=3)
    for end in (-12, 12):
        tip = [(x - 2, end - np.sign(end) * out), (x, end), (x + 2, end - np.sign(end) * out)]
        stroke(ax, tip, "camera", lw=3)


@figure("A zoom of two lenses at several distances between them: the focal length changes.")
def zoom(
    f1: float = 50.0,
    f2: float = -30.0,
    distances: Sequence[float] = (27, 30, 35),
    yours: Sequence[ArrayLike | None] | None = None,
) -> Figure:
    """Show how the distance between two lenses sets the focal length of the pair.

    Parameters
    ----------
    f1, f2 : float
        Focal lengths of both lenses, mm.
    distances : sequence of float
        Distances between them, mm.
    yours : sequence of array_like, shape (3,), optional
        Focal length and principal planes that a student's function gave for each distance, mm.

    Returns
    -------
    Figure
        A row for each distance: lenses, light from a far point, and the sensor.
    """
    fig, axes = panels(len(distances), 1, (FULL_WIDTH, 1.65 * len(distances)), squeeze=False)
    systems = [lens_system(f1, f2, d) for d in distances]
    end = max(d + back + f for d, (f, _, back) in zip(distances, systems, strict=True))
    for row, (ax, d, (f, _, back)) in enumerate(zip(axes[:, 0], distances, systems, strict=True)):
        sketch(ax)
        ax.set_aspect("auto")
        focus = d + back + f
        at_second, _ = free_space(d) @ thin_lens(f1) @ (10.0, 0)
        stroke(ax, [(-25, 0), (end + 5, 0)], "guide", lw=1, ls=(0, (8, 4)))
        for side in (-1, 1):
            ray = [(-25, 10), (0, 10), (d, at_second), (focus, 0)]
            stroke(ax, [(x, side * height) for x, height in ray], "ray", lw=1.6)
        for x, lens in ((0, f1), (d, f2)):
            _glass(ax, x, lens)
        stroke(ax, [(focus, -11), (focus, 11)], "image", lw=3)
        write(ax, (-27, 6), f"d = {d:g} mm", ha="right")
        write(ax, (-27, -1), f"f = {f:.0f} mm", ha="right", fontweight="bold")
        _yours(ax, d, None if yours is None else yours[row], end + 8)
        fit(ax, -62, end + 8, -15, 15)
    return fig


def _yours(ax: Axes, d: float, yours: ArrayLike | None, right: float) -> None:
    """Write a student's focal length of a row, and mark the focus where the row shows it."""
    drawn = same_shape(yours, np.zeros(3))
    if drawn is None or not np.isfinite(drawn).all():
        return
    place, words = d + drawn[2] + drawn[0], f"yours: {in_figures(drawn[0], 0)} mm"
    if -20 < place < right:
        ax.plot(place, 0, "*", color=ROLES["second"], ms=15, zorder=5)
    else:
        words += f",\nits focus at {in_figures(place, 0)} mm"
    write(ax, (-27, -8), words.replace("-", "−"), ha="right", va="top", fontsize=10)
