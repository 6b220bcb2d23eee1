"""Still figures of how pictures are taken, and of what came before: two plans and a timeline."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from course_lib.drawing.diagrams import figure, fit, panels, sketch, stroke, write
from course_lib.drawing.style import BLACK, FULL_WIDTH, GREY, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Year (the first of several), how it is written, what happened; above or below the line.
HISTORY = (
    (1816, "1816", "Niépce: a picture\nin a camera, it fades"),
    (1849, "from 1849", "Laussedat: maps\nfrom pictures"),
    (1867, "1867", "Meydenbauer\nnames it"),
    (1903, "1903", "the Wright\nbrothers fly"),
    (1921, "1921", "Fairchild: Manhattan\nfrom the air"),
    (1946, "after 1945", "spare aeroplanes\nmap countries"),
    (1958, "1958", "Brown: the bundle\nadjustment"),
    (2004, "2004", "Lowe: SIFT\ntie points"),
    (2006, "2006", "Snavely: Bundler,\nfrom any pictures"),
    (2010, "2010", "Furukawa, Ponce:\nPMVS, dense"),
)


@figure("Ten steps from the first camera picture of 1816 to dense models from any pictures, 2010.")
def timeline() -> Figure:
    """Show two centuries of measuring in pictures.

    Returns
    -------
    Figure
        Events in order, evenly spaced, in two rows.
    """
    fig, axes = panels(2, 1, (FULL_WIDTH, 3.3))
    half = len(HISTORY) // 2
    for ax, events in zip(axes, (HISTORY[:half], HISTORY[half:]), strict=True):
        ax.axis("off")
        ax.set(xlim=(-0.5, half - 0.5), ylim=(-1.1, 0.55))
        ax.annotate("", (half - 0.5, 0), (-0.5, 0), arrowprops={"arrowstyle": "->", "color": GREY})
        for place, (_, year, what) in enumerate(events):
            ax.plot(place, 0, "o", color=ROLES["camera"], ms=9)
            write(ax, (place, 0.35), year, "camera", fontweight="bold")
            write(ax, (place, -0.6), what, fontsize=9.5)
    return fig


@figure("Convergent: cameras around an object look at it. Parallel: overlapping strips from above.")
def acquisition() -> Figure:
    """Show the two ways to take pictures of an object and of a plane.

    Returns
    -------
    Figure
        From above: a circle around a vase; strips over terrain.
    """
    fig, (left, right) = panels(1, 2, (FULL_WIDTH, 3.9))
    _circle(sketch(left, "convergent: 36 to a circle"))
    _strips(sketch(right, "parallel: flown to and fro"))
    return fig


def _circle(ax: Axes) -> None:
    """Draw 36 cameras that look at an object, and the angle between two of them."""
    turn = np.linspace(0, 2 * np.pi, 60)
    ax.fill(0.18 * np.cos(turn), 0.18 * np.sin(turn), color=ROLES["object"], alpha=0.35, lw=0)
    write(ax, (0, -0.27), "object", "object")
    for a in np.deg2rad(np.arange(0, 360, 10)):
        out, side = np.array([np.cos(a), np.sin(a)]), np.array([-np.sin(a), np.cos(a)])
        ax.fill(
            *np.array([0.96 * out, 1.08 * out + 0.05 * side, 1.08 * out - 0.05 * side]).T,
            color=ROLES["camera"],
            lw=0,
        )
    for a in np.deg2rad([30, 40]):
        stroke(
            ax,
            [(0.2 * np.cos(a), 0.2 * np.sin(a)), (0.95 * np.cos(a), 0.95 * np.sin(a))],
            "ray",
            lw=1.3,
        )
    a = np.deg2rad(np.linspace(30, 40, 9))
    stroke(ax, 0.72 * np.column_stack([np.cos(a), np.sin(a)]), "guide", lw=1.2)
    write(ax, (0.42, 0.52), "10°", fontsize=12)
    fit(ax, -1.15, 1.15, -1.15, 1.15)


def _strips(ax: Axes) -> None:
    """Draw three strips of six pictures: the track, and the footprints of neighbours."""
    width, high = 1.24, 0.93
    along, across = 0.2 * width, 0.4 * high
    track = []
    for row in range(3):
        columns = range(6) if row % 2 == 0 else range(5, -1, -1)
        track += [(column * along, row * across) for column in columns]
    stroke(ax, track, "camera", lw=1.5)
    ax.plot(*np.array(track).T, "o", color=ROLES["camera"], ms=6)
    for x, y in ((0, 0), (along, 0), (0, across)):
        box = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * [width / 2, high / 2] + [x, y]
        ax.plot(*np.vstack([box, box[:1]]).T, color=ROLES["image"], lw=1.5)
    write(ax, (-width / 2, -high / 2 - 0.1), "footprints of three pictures", "image", ha="left")
    write(
        ax,
        (-width / 2, -high / 2 - 0.24),
        "overlap 80 % along, 60 % across",
        ha="left",
        color=BLACK,
    )
    fit(ax, -0.75, 1.95, -1.05, 1.65)
