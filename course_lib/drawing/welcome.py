"""The figures of chapter 00: the map of the course, the frames, a point in a photograph."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.diagrams import figure, fit, panels, picture_frame, sketch, write
from course_lib.drawing.space import onlooker, show_axes, show_frustum
from course_lib.drawing.style import BLACK, BLUE, FULL_WIDTH, GREY, LIGHT, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


class Chapter(NamedTuple):
    """A box on the map: where it stands, what it is called and what it asks."""

    column: int
    row: int
    title: str
    question: str


CHAPTERS = {
    1: Chapter(0, 0, "Pinhole", "Where does a\npoint land?"),
    2: Chapter(1, 0, "Camera matrix", "How does it look\nfrom anywhere?"),
    3: Chapter(0, 1, "Lenses", "What is sharp,\nand how far?"),
    4: Chapter(0, 2, "Sensor", "How sure is\na grey value?"),
    5: Chapter(1, 1, "Distortion", "Why are straight\nlines bent?"),
    6: Chapter(2, 0, "Least squares", "What if the data\ndisagree?"),
    7: Chapter(2, 1, "Calibration", "What is my\ncamera like?"),
    8: Chapter(3, 0, "Two views", "Where is it in the\nother picture?"),
    9: Chapter(3, 1, "Triangulation", "Where is it\nin space?"),
    10: Chapter(3, 2, "Many views", "How do pictures\nmake a model?"),
    11: Chapter(1, 2, "Planning", "Which camera, lens\nand place?"),
    12: Chapter(2, 2, "Lab", "How long is it,\nand how sure?"),
}

BOX = np.array([1.62, 0.92])
STEP = np.array([2.05, 1.45])

#: What builds on what, as the way of each arrow in units of the grid of boxes: column and row.
ARROWS: dict[tuple[int, int], list[tuple[float, float]]] = {
    (1, 2): [(0, 0), (1, 0)],
    (1, 3): [(0, 0), (0, 1)],
    (2, 5): [(1, 0), (1, 1)],
    (2, 6): [(1, 0), (2, 0)],
    (3, 4): [(0, 1), (0, 2)],
    (5, 7): [(1, 1), (2, 1)],
    (6, 7): [(2, 0), (2, 1)],
    (7, 8): [(2, 0.88), (2.46, 0.88), (2.46, 0), (3, 0)],
    (8, 9): [(3, 0), (3, 1)],
    (9, 10): [(3, 1), (3, 2)],
    (9, 11): [(3, 1.12), (2.54, 1.12), (2.54, 1.5), (1, 1.5), (1, 2)],
    (4, 11): [(0, 2), (1, 2)],
    (10, 12): [(3, 2), (2, 2)],
    (11, 12): [(1, 2), (2, 2)],
}


@figure(
    "Twelve boxes, one a chapter, each with its question; arrows lead from a chapter to those "
    "that build on it."
)
def course_map(here: int | None = None) -> Figure:
    """Draw the chapters, the question that each answers, and what each builds on.

    Parameters
    ----------
    here : int, optional
        A chapter to mark.

    Returns
    -------
    Figure
        Boxes, with arrows from a chapter to those that need it.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 4.4))
    sketch(ax)
    for way in ARROWS.values():
        _arrow(ax, way)
    for number, chapter in CHAPTERS.items():
        _box(ax, number, chapter, number == here)
    fit(ax, -0.9, 7.05, -3.45, 0.55)
    return fig


def _box(ax: Axes, number: int, chapter: Chapter, marked: bool) -> None:
    from matplotlib.patches import FancyBboxPatch

    centre = np.array([chapter.column, -chapter.row]) * STEP
    edge, width = (BLUE, 2.5) if marked else (GREY, 1.0)
    style = "round,pad=0,rounding_size=0.08"
    x, y = centre - BOX / 2
    frame = FancyBboxPatch((x, y), BOX[0], BOX[1], boxstyle=style)
    frame.set(facecolor=LIGHT, edgecolor=edge, linewidth=width, zorder=2)
    ax.add_patch(frame)
    x, y = centre
    write(ax, (x, y + 0.27), f"{number:02d} {chapter.title}", fontweight="bold", fontsize=9.5)
    write(ax, (x, y - 0.13), chapter.question, fontsize=9.5)


def _arrow(ax: Axes, way: list[tuple[float, float]]) -> None:
    """Draw an arrow along a way of straight pieces; boxes hide what lies under them."""
    points = np.array(way) * (1, -1) * STEP
    last = np.sign(points[-1] - points[-2])
    points[-1] -= last * BOX / 2
    ax.plot(*points[:-1].T, color=BLACK, lw=1.2, zorder=1)
    arrow = {"arrowstyle": "-|>", "color": BLACK, "lw": 1.2, "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", xy=tuple(points[-1]), xytext=tuple(points[-2]), arrowprops=arrow, zorder=1)


@figure(
    "Left: a camera in the world, whose Z axis points up; the camera's own x axis points "
    "right, y down and z forward. Right: its picture of 8 × 6 pixels, u to the right and v "
    "down."
)
def frames() -> Figure:
    """Show the camera frame and the world frame in space, and the pixel frame in the picture.

    Returns
    -------
    Figure
        Left: a camera in the world, seen by another camera. Right: the picture it takes.
    """
    fig, (left, right) = panels(1, 2, (FULL_WIDTH, 3.7), width_ratios=[1.15, 1])
    sketch(left, "In space")
    view = onlooker((4.6, -5.4, 4.0), (0.75, 1.2, 0.55), 900)
    small = onlooker((0.0, 0.0, 1.1), (0.55, 4.0, 0.75), 700)
    show_frustum(left, view, small)
    world = np.array([1.1, 0.1, 0.0])
    show_axes(left, view, world, np.eye(3) * 0.75, "XYZ", "guide", "world")
    show_axes(left, view, small.centre, small.R * 0.9, "xyz", "camera", "camera")
    left.set(xlim=(40, 460), ylim=(420, 60))
    _picture_axes(right)
    return fig


def _picture_axes(ax: Axes) -> None:
    picture_frame(ax, (8, 6))
    for k in range(9):
        ax.axvline(k - 0.5, color=LIGHT, lw=0.8, zorder=0)
        ax.axhline(k - 0.5, color=LIGHT, lw=0.8, zorder=0)
    ax.plot(0, 0, "o", color=BLUE)
    ax.text(0.35, 0.0, "(0, 0)", color=BLUE, va="center")
    ax.plot(5, 2, "s", color=ROLES["object"])
    ax.text(5.4, 2, "(5, 2)", color=ROLES["object"], va="center")
    ax.set(xticks=range(8), yticks=range(6), title="In the picture (8 × 6 px)")
    ax.set(xlabel="u (px): column", ylabel="v (px): row")


@figure("A photograph with a mark at the pixel {pixel}.")
def point_in_picture(picture: NDArray[np.uint8], pixel: ArrayLike) -> Figure:
    """Show a photograph with one pixel marked.

    Parameters
    ----------
    picture : ndarray, shape (height, width, 3)
        The photograph.
    pixel : array_like, shape (2,)
        Column and row (u, v), px; NaN marks nothing.

    Returns
    -------
    Figure
        The photograph; the title says when the pixel lies outside.
    """
    height, width = picture.shape[:2]
    fig, ax = panels(1, 1, (6.4, 4.9))
    ax.imshow(picture)
    picture_frame(ax, (width, height))
    u, v = np.asarray(pixel, dtype=float)
    inside = 0 <= u <= width - 1 and 0 <= v <= height - 1
    ax.plot(u, v, "o", ms=16, mfc="none", mec="white", mew=5)
    ax.plot(u, v, "o", ms=16, mfc="none", mec=ROLES["object"], mew=2.5)
    ax.set_title(
        f"The point lands on (u, v) = ({u:.0f}, {v:.0f})" + ("" if inside else ": outside")
    )
    return fig
