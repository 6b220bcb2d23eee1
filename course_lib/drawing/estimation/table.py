"""Still figures of the robot's table: photographs, where the needle goes, and why it misses."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera import Camera
from course_lib.drawing.diagrams import (
    Floats,
    dimension,
    figure,
    fit,
    in_figures,
    panels,
    picture_frame,
    same_shape,
    sketch,
    stroke,
    write,
)
from course_lib.drawing.style import BLACK, FULL_WIDTH, GREY, LIGHT, ROLES
from data_generators import cell

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Where the needle must go: first the targets on the table, then those on the block, mm.
GOALS = np.vstack([cell.on_table(cell.TARGETS), cell.BLOCK])
SINGLE = (0.75 * FULL_WIDTH, 4.3)  # inches: of a figure with one panel
SIGMA = 0.2  # px: how well a marker is found


def found(camera: Camera, points: ArrayLike, seed: int = 6) -> Floats:
    """Return the pixels at which a program finds points of the table, good to `SIGMA`.

    Parameters
    ----------
    camera : Camera
        Who looks.
    points : array_like, shape (N, 2) or (N, 3)
        On the table, or in space, mm.
    seed : int
        Which chance errors.

    Returns
    -------
    ndarray, shape (N, 2)
        Pixels.
    """
    places = np.asarray(points, dtype=float)
    space = cell.on_table(places) if places.shape[-1] == 2 else places
    return cell.observed(camera.project(space), SIGMA, np.random.default_rng(seed))


@figure("A robot's table with markers, six targets on it and three on a block, by two cameras.")
def two_views() -> Figure:
    """Show the table from straight above and from the side.

    Returns
    -------
    Figure
        Two photographs with the axes of the robot.
    """
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.2))
    views = {
        "camera A, from above": cell.camera_above(),
        "camera B, from the side": cell.camera_beside(),
    }
    for ax, (title, camera) in zip(axes, views.items(), strict=True):
        ax.imshow(cell.photograph(camera, "block"))
        picture_frame(ax, cell.SIZE)
        ax.set_title(title)
        _robot_axes(ax, camera)
    return fig


def _robot_axes(ax: Axes, camera: Camera) -> None:
    """Draw the robot's x and y axis, 80 mm long, from the first marker."""
    start, *ends = camera.project([[0, 0, 0], [80, 0, 0], [0, 80, 0]])
    for name, end in zip("xy", ends, strict=True):
        arrow = {"arrowstyle": "-|>", "color": "white", "lw": 2, "shrinkA": 0, "shrinkB": 0}
        ax.annotate("", xy=tuple(end), xytext=tuple(start), arrowprops=arrow)
        beyond = end + 22 * (end - start) / np.linalg.norm(end - start)
        ax.text(
            beyond[0], beyond[1], f"${name}$", color="white", ha="center", va="center", fontsize=13
        )


@figure("Where the needle goes (crosses) instead of where it should, on the table from above.")
def misses(results: Mapping[str, ArrayLike | None], goals: ArrayLike, times: float = 1.0) -> Figure:
    """Show places on the table and how far the needle is from them.

    Parameters
    ----------
    results : mapping of str to array_like, shape (N, 2), or None
        By title: where the needle goes, mm.
    goals : array_like, shape (N, 2) or (N, 3)
        Where it should go, mm; those that are higher than the table are drawn as squares.
    times : float
        How many times too long the misses are drawn.

    Returns
    -------
    Figure
        A panel for each result with a cross where the needle goes, and the root of the mean
        square.
    """
    places = np.asarray(goals, dtype=float)
    size = (FULL_WIDTH, 3.0) if len(results) > 1 else SINGLE
    fig, axes = panels(1, len(results), size, squeeze=False)
    for ax, (title, result) in zip(axes[0], results.items(), strict=True):
        _table(ax, places)
        there = same_shape(result, places[:, :2])
        if there is None or not np.isfinite(there).all():
            ax.set_title(title)
            write(ax, (240, 160), "no answer yet", "guide")
            continue
        miss = there - places[:, :2]
        for goal, way in zip(places[:, :2], times * miss, strict=True):
            ax.plot(*np.array([goal, goal + way]).T, color=ROLES["object"], lw=2, zorder=3)
            ax.plot(*(goal + way), "x", color=ROLES["object"], ms=6, mew=1.6, zorder=3)
        ax.set_title(f"{title}: {_how_far(miss, places)}", fontsize=10.5)
    note = f"misses drawn {times:g} times as long" if times != 1 else "misses drawn to scale"
    fig.suptitle(note, fontsize=9, color=GREY, x=0.99, ha="right")
    return fig


def _how_far(miss: Floats, places: Floats) -> str:
    """Return the root of the mean square of misses, on the table and on the block, in words."""
    high = _are_high(places)
    groups = {"table": miss[~high], "block": miss[high]} if high.any() else {"": miss}
    sizes = {name: np.sqrt((m**2).sum(axis=1).mean()) for name, m in groups.items()}
    words = [f"{n} {in_figures(s, 1 if s >= 10 else 2)}".strip() for n, s in sizes.items()]
    return ", ".join(words) + " mm"


def _are_high(places: Floats) -> NDArray[np.bool_]:
    """Return which places are above the table."""
    return places[:, 2] > 0 if places.shape[1] == 3 else np.zeros(len(places), bool)


def _table(ax: Axes, places: Floats) -> None:
    """Draw the table from above and places on it."""
    ax.set_aspect("equal")
    ax.set_facecolor(LIGHT)
    ax.plot(*cell.MARKERS.T, "s", color="white", ms=5, zorder=1)
    high = _are_high(places)
    for chosen, mark in ((~high, "o"), (high, "s")):
        ax.plot(*places[chosen, :2].T, mark, color=BLACK, ms=4, zorder=2)
    ax.set(xlim=(-60, 540), ylim=(-60, 380), xlabel="x (mm)", ylabel="y (mm)")
    ax.set_xticks([0, 160, 320, 480])
    ax.set_yticks([0, 160, 320])


@figure("From the side: the ray to a target above the table meets the table farther out.")
def too_high() -> Figure:
    """Show why a target on a block is taken for a place farther out.

    Returns
    -------
    Figure
        Camera, ray, block and table in the plane of the ray.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.2))
    sketch(ax)
    table, height, out = 0.0, 1.3, 2.6
    ground = out * 5 / (5 - height)  # the camera is 5 above the table
    stroke(ax, [(-1, table), (5.4, table)], "guide", lw=3)
    ax.fill([2.2, 3.0, 3.0, 2.2], [0, 0, height, height], color="#B08A60", alpha=0.5, lw=0)
    stroke(ax, [(0, 5), (ground, table)], "ray", lw=2)
    stroke(ax, [(0, 5), (0, 0)], "guide", lw=1, ls=(0, (5, 4)))
    stroke(ax, [(out, height), (out, 0)], "object", lw=1.2, ls=(0, (3, 2)))
    look: dict[str, Any] = {"ls": "", "ms": 9, "zorder": 4}
    ax.plot(0, 5, "o", color=ROLES["camera"], **look)
    ax.plot(out, height, "o", color=ROLES["object"], **look)
    ax.plot(ground, 0, "x", color=BLACK, mew=2.5, **look)
    write(ax, (0.2, 5.1), "camera", "camera", ha="left")
    write(ax, (out + 0.55, height + 0.25), "target", "object", ha="left")
    write(ax, (ground + 0.2, -0.35), "where the needle goes", ha="left")
    stroke(ax, [(out, -0.75), (ground, -0.75)], "object", lw=3)
    write(ax, ((out + ground) / 2, -1.1), "miss", "object")
    dimension(ax, (-0.5, 0), (-0.5, 5), "$Z_C$")
    dimension(ax, (4.9, 0), (4.9, height), "$Z$")
    dimension(ax, (0, -0.75), (out, -0.75), "$r$")
    fit(ax, -1.1, 7.2, -1.3, 5.4)
    return fig


@figure("Where the homography's residuals point on the picture, drawn {times:g} times as long.")
def residual_field(
    fields: Mapping[str, tuple[ArrayLike, ArrayLike]], times: float = 20.0
) -> Figure:
    """Show residuals where they were measured.

    Parameters
    ----------
    fields : mapping of str to (pixels, residuals)
        By title: pixels (N, 2) and what is left there (N, 2), px.
    times : float
        How many times too long they are drawn.

    Returns
    -------
    Figure
        A panel for each, with the root of the mean square.
    """
    size = (FULL_WIDTH, 3.0) if len(fields) > 1 else SINGLE
    fig, axes = panels(1, len(fields), size, squeeze=False)
    for ax, (title, (pixels, residuals)) in zip(axes[0], fields.items(), strict=True):
        at, left = np.asarray(pixels, dtype=float), np.asarray(residuals, dtype=float)
        picture_frame(ax, cell.SIZE)
        look: dict[str, Any] = {"angles": "xy", "scale_units": "xy", "scale": 1 / times}
        ax.quiver(*at.T, *left.T, color=ROLES["object"], width=0.004, **look)
        ax.plot(*at.T, ".", color=GREY, ms=3)
        ax.set_title(f"{title}: {np.sqrt((left**2).sum(axis=1).mean()):.2f} px (RMS)")
    note = f"arrows drawn {times:g} times as long"
    fig.suptitle(note, fontsize=9, color=GREY, x=0.99, ha="right")
    return fig
