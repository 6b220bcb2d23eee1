"""Still figures of the second sitting: what a pixel shows, overlap, the pit from above."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.diagrams import dimension, figure, fit, panels, sketch, stroke, write
from course_lib.drawing.planning.site import (
    DEPTH,
    EXTENT,
    HALF_AXES,
    PIT,
    WALL,
    Floats,
    counts,
    flight,
    grid,
    ground,
)
from course_lib.drawing.style import BLACK, FULL_WIDTH, GREY, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from course_lib.planning import FlightPlan

SIZES = (1, 2, 3, 5, 10)  # GSD: of the crosses on the ground
WEST = (54.0, 30.0, 6.0)  # m: of three cameras from the edge of the pit
#: Colours of numbers of pictures: none or one, two, 3 to 5, 6 to 8, more.
STEPS = (0, 2, 3, 6, 9)
COLOURS = ("#4D2C00", "#E69F00", "#F6E3B8", "#BFDCEE", "#6BA9D0")


def crosses(size: float, side: int = 14, fine: int = 40) -> Floats:
    """Return a white cross of `size` pixels on dark ground, as a camera sees it, (side, side).

    It does not lie on the grid of the pixels: each pixel is the mean of what it covers.
    """
    step = (np.arange(side * fine) + 0.5) / fine - side / 2
    x, y = np.meshgrid(step - 0.3, step + 0.2)
    x, y = x * np.cos(0.3) - y * np.sin(0.3), x * np.sin(0.3) + y * np.cos(0.3)
    u, v = np.abs(x) / size, np.abs(y) / size
    cross = (np.maximum(u, v) < 0.5) & (np.minimum(u, v) < 1 / 6)
    picture = np.where(cross, 0.95, 0.2)
    return np.asarray(picture.reshape(side, fine, side, fine).mean(axis=(1, 3)))


@figure("A cross on the ground of 1, 2, 3, 5 and 10 pixels: found from 3 on, a cross from 5.")
def smallest_object() -> Figure:
    """Show crosses on the ground that are a few pixels large.

    Returns
    -------
    Figure
        A picture for each size.
    """
    fig, axes = panels(1, len(SIZES), (FULL_WIDTH, 2.0))
    for ax, size in zip(axes, SIZES, strict=True):
        ax.imshow(crosses(size), vmin=0, vmax=1)
        ax.set_title(f"{size} GSD", fontsize=11)
        ax.axis("off")
    return fig


@figure("Footprints of pictures along a strip, with overlaps of 50, 67 and 80 percent.")
def overlaps() -> Figure:
    """Show how many pictures of a strip see the same place, for three overlaps.

    Returns
    -------
    Figure
        Pictures from the side, and their footprints below each other.
    """
    fig, axes = panels(1, 3, (FULL_WIDTH, 2.9))
    for ax, share in zip(axes, (0.5, 2 / 3, 0.8), strict=True):
        _strip(ax, share)
    return fig


def _strip(ax: Axes, share: float, H: float = 1.0, footprint: float = 1.0) -> None:
    """Draw the pictures of a strip from the side, and their footprints."""
    base = (1 - share) * footprint
    seen = round(1 / (1 - share))
    sketch(ax, f"{100 * share:.0f} %: {seen} pictures")
    centres = base * (np.arange(seen + 1) - seen / 2)
    place = base / 2  # in the middle between two pictures' edges
    stroke(ax, [(-1.2, 0), (1.2, 0)], "guide", lw=1.5)
    stroke(ax, [(place, 0.0), (place, -0.2 - 0.13 * len(centres))], "object", lw=1.2, ls=":")
    for level, x in enumerate(centres):
        sees = abs(x - place) < footprint / 2 - 1e-9
        ends = np.array([x - footprint / 2, x + footprint / 2])
        role = "image" if sees else "guide"
        ax.plot([ends[0], x, ends[1]], [0, H, 0], color=ROLES["camera"], lw=0.7, alpha=0.6)
        ax.plot(x, H, "o", color=ROLES["camera"], ms=5)
        stroke(ax, np.column_stack([ends, np.full(2, -0.2 - 0.13 * level)]), role, lw=4)
    dimension(ax, (centres[0], 1.16), (centres[1], 1.16), "", fontsize=9)
    write(ax, (float(centres[:2].mean()), 1.3), "base", "guide", fontsize=10)
    fit(ax, -1.25, 1.25, -1.1, 1.45)


@figure("The gravel pit from above: pictures, strips, and how many pictures show each place.")
def flight_map(plan: FlightPlan | None = None) -> Figure:
    """Show a flight on the map, with the number of pictures that show each place.

    Parameters
    ----------
    plan : FlightPlan, optional
        The flight; that of the text unless given.

    Returns
    -------
    Figure
        A map in metres.
    """
    plan = plan or flight()
    fig, ax = panels(1, 1, (FULL_WIDTH, 4.4))
    heat(ax, counts(plan))
    x, y = plan.centres[:, :2].T
    ax.plot(x, y, color=ROLES["camera"], lw=0.8)
    ax.plot(x, y, ".", color=ROLES["camera"], ms=5, label="picture")
    around = np.vstack([plan.polygon, plan.polygon[:1]])
    ax.plot(*around.T, color=BLACK, lw=1.5, label="area")
    first, *others = (np.vstack([f, f[:1]]) for f in plan.footprints()[plan.strips == 0])
    look: dict[str, Any] = {"color": ROLES["object"]}
    ax.plot(*first.T, "--", **look, lw=1.5, label="first picture's footprint, and its line's")
    for footprint in others:
        ax.plot(*footprint.T, **look, lw=0.4)
    ax.set(xlabel="east (m)", ylabel="north (m)", aspect="equal")
    ax.set(xlim=(-60, EXTENT[0] + 35), ylim=(-25, EXTENT[1] + 20))
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3, fontsize=10)
    return fig


def heat(ax: Axes, seen: ArrayLike) -> None:
    """Draw how many pictures show each place of the grid, with the scale of colours."""
    from matplotlib.colors import BoundaryNorm, ListedColormap
    from matplotlib.patches import Patch

    shape = (len(np.unique(grid()[:, 1])), -1)
    edges = [*STEPS, 10_000]
    look: dict[str, Any] = {"cmap": ListedColormap(COLOURS), "norm": BoundaryNorm(edges, 5)}
    ax.imshow(np.reshape(seen, shape), extent=(0, EXTENT[0], 0, EXTENT[1]), **look)
    names = ("0 or 1", "2", "3 to 5", "6 to 8", "9 or more")
    keys = [Patch(fc=c, ec=GREY, label=n) for c, n in zip(COLOURS, names, strict=True)]
    ax.figure.legend(handles=keys, loc="outside right center", title="seen in pictures")


@figure("A section through the pit's wall: what cameras farther out cannot see behind its edge.")
def hidden() -> Figure:
    """Show what the edge of the pit hides from three pictures of a strip.

    Returns
    -------
    Figure
        The ground from the side, with rays over the edge.
    """
    plan = flight()
    x = np.linspace(-10, 120, 1500)
    z = ground(x, np.full(x.size, PIT[1]))
    fig, ax = panels(1, 1, (FULL_WIDTH, 4.2))
    ax.fill_between(x, -42, z, color=GREY, alpha=0.35, lw=0)
    ax.plot(x, z, color=BLACK, lw=1.5)
    edge = np.array([PIT[0] - HALF_AXES[0], 0.0])
    for number, (west, style) in enumerate(zip(WEST, ("-", "--", ":"), strict=True)):
        camera = np.array([edge[0] - west, plan.H])
        foot = edge + (edge - camera) * DEPTH / plan.H
        ax.plot(*np.array([camera, foot]).T, style, color=ROLES["ray"], lw=1.5)
        ax.plot(*camera, "o", color=ROLES["camera"], ms=6)
        write(ax, (camera[0], plan.H + 7), "ABC"[number], "camera")
    wall = edge[0] + WALL * HALF_AXES[0] / min(HALF_AXES)
    far = edge[0] + WEST[0] * DEPTH / plan.H
    ax.plot([wall, far], [-DEPTH, -DEPTH], color=ROLES["object"], lw=4)
    write(ax, (wall, -29), "hidden from A", "object", ha="left")
    ax.set(xlabel="east (m)", ylabel="height (m)", xlim=(-10, 120), ylim=(-42, 90))
    ax.set_aspect("equal")
    return fig
