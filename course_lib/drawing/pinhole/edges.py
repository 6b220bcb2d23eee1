"""Still figures on one real photograph: what it shows, and where its parallel edges meet."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.diagrams import Floats, figure, panels, picture_frame, stroke, write
from course_lib.drawing.style import BLACK, BLUE, FULL_WIDTH, GREEN, ORANGE, PURPLE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: An edge in a picture: its two ends in pixels.
Edge = tuple[tuple[float, float], tuple[float, float]]


#: px: what meets farther away than that is not drawn.
FARTHEST = 1e6


@figure(
    "A photograph. A square marks its middle, a cross its principal point, and coloured lines "
    "the edges in it that are named."
)
def photograph(picture: ArrayLike, c: ArrayLike, edges: Mapping[str, Edge] | None = None) -> Figure:
    """Show a photograph with its middle, its principal point and some edges.

    Parameters
    ----------
    picture : array_like, shape (height, width, 3)
        RGB.
    c : array_like, shape (2,)
        Principal point, px.
    edges : mapping of str to two pixels, optional
        Name of each edge and its ends, px.

    Returns
    -------
    Figure
        The picture with pixel coordinates.
    """
    picture = np.asarray(picture)
    height, width = picture.shape[:2]
    fig, ax = panels(1, 1, (FULL_WIDTH, 5.6))
    ax.imshow(picture)
    picture_frame(ax, (width, height))
    _mark(ax, ((width - 1) / 2, (height - 1) / 2), "s", "middle of the picture")
    _mark(ax, c, "P", "principal point")
    for (name, edge), colour in zip((edges or {}).items(), _colours(), strict=False):
        stroke(ax, edge, color="white", lw=7.5)
        stroke(ax, edge, color=colour, lw=5)
        along = np.abs(np.subtract(*edge))
        beside = (0, 18) if along[0] > along[1] else (-48, 0)
        _label(ax, np.mean(edge, axis=0) + np.array(beside), name, colour)
    ax.legend(loc="lower left", frameon=True, framealpha=0.9)
    return fig


@figure(
    "A photograph, drawn small: two of its edges, made longer, meet far outside of it, at "
    "({meeting[0]:.0f}, {meeting[1]:.0f}) px."
)
def meeting_lines(picture: ArrayLike, edges: Mapping[str, Edge], meeting: ArrayLike) -> Figure:
    """Show how edges of a photograph, made longer, meet far outside of it.

    Parameters
    ----------
    picture : array_like, shape (height, width, 3)
        RGB.
    edges : mapping of str to two pixels
        Two edges that are parallel in the world, and their ends, px.
    meeting : array_like, shape (2,)
        Where their lines meet, px.

    Returns
    -------
    Figure
        The picture, small, and the two lines up to the point where they meet; the edges alone, and
        the reason, where that is no pixel.
    """
    picture, meeting = np.asarray(picture), np.asarray(meeting, dtype=float)
    if not (np.abs(meeting) < FARTHEST).all():
        return _edges_alone(picture, edges, meeting)
    height, width = picture.shape[:2]
    upright = abs(meeting[1] - height / 2) > abs(meeting[0] - width / 2)
    fig, ax = panels(1, 1, (4.6, 5.2) if upright else (FULL_WIDTH, 2.4))
    ax.imshow(picture, extent=(-0.5, width - 0.5, height - 0.5, -0.5))
    for (name, edge), colour in zip(edges.items(), _colours(), strict=False):
        far = max(edge, key=lambda end: float(np.linalg.norm(np.subtract(end, meeting))))
        stroke(ax, np.array([far, meeting]), color=colour, lw=1.6, label=name)
    ax.plot(*meeting, "*", color=BLACK, ms=13, clip_on=False, label="vanishing point")
    corners = np.array([(0, 0), (width, height), meeting])
    low, high = corners.min(axis=0) - 90, corners.max(axis=0) + 90
    ax.set(xlim=(low[0], high[0]), ylim=(high[1], low[1]), aspect="equal")
    ax.set(xlabel="u (px)", ylabel="v (px)")
    if upright:
        ax.legend(loc="upper left", bbox_to_anchor=(1.02, 1))
    else:
        ax.legend(loc="lower left")
    return fig


def _edges_alone(picture: Floats, edges: Mapping[str, Edge], meeting: Floats) -> Figure:
    """Show edges whose lines do not meet in any pixel that could be drawn."""
    height, width = picture.shape[:2]
    fig, ax = panels(1, 1, (FULL_WIDTH, 2.4))
    ax.imshow(picture, extent=(-0.5, width - 0.5, height - 0.5, -0.5))
    for edge, colour in zip(edges.values(), _colours(), strict=False):
        stroke(ax, np.asarray(edge), color=colour, lw=1.6)
    ax.set(xlabel="u (px)", ylabel="v (px)")
    ax.set_title("no place for the star: ({:.3g}, {:.3g})".format(*meeting))
    return fig


def _colours() -> tuple[str, ...]:
    return (BLUE, ORANGE, PURPLE, GREEN)


def _mark(ax: Axes, at: ArrayLike, marker: str, label: str) -> None:
    """Mark a pixel so that it is seen on light and on dark."""
    ax.plot(*np.asarray(at), marker, mfc="white", mec=BLACK, ms=11, mew=1.5, ls="", label=label)


def _label(ax: Axes, at: ArrayLike, name: str, colour: str) -> None:
    paper = {"facecolor": "white", "edgecolor": colour, "boxstyle": "round", "alpha": 0.9}
    write(ax, at, name, fontsize=9, bbox=paper)
