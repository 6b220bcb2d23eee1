"""Still figures: three rails on a table, and how straight they look."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.distortion import straightness
from course_lib.drawing.diagrams import (
    Floats,
    figure,
    panels,
    picture_frame,
    same_shape,
    write,
)
from course_lib.drawing.style import FULL_WIDTH, GREY, ROLES
from course_lib.remapping import undistort_picture
from data_generators.rails import LENS, RAILS, K, photograph, rail_points

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

STYLES = ("-", "--", "-.")
ROLES_OF_RAILS = ("object", "camera", "second")


@figure(
    "Left: a photograph of three rails with a straight edge laid over each. Right: how far the "
    "middle of each rail is from that edge, in px, along the rail."
)
def rails() -> Figure:
    """Show the rails as photographed, and how far they are from straight.

    Returns
    -------
    Figure
        The photograph, and the distances from the straight lines through each rail's ends.
    """
    return _with_edges(photograph(), rail_points(photograph()))


@figure(
    "Left: the photograph of three rails, straightened, with a straight edge laid over each. "
    "Right: how far the middle of each rail is from that edge, in px, along the rail."
)
def straightened_rails(ideal: Sequence[ArrayLike | None]) -> Figure:
    """Show the rails without distortion, and how far they are from straight.

    Parameters
    ----------
    ideal : sequence of array_like, each of shape (N, 2)
        Points on rails A, B and C, as a student's function undistorted them: in normalised
        coordinates. A rail with None, or without numbers, is left out.

    Returns
    -------
    Figure
        The straightened photograph, and the distances from the straight edges.
    """
    shapes = rail_points(photograph())
    drawn = [same_shape(line, shape) for line, shape in zip(ideal, shapes, strict=True)]
    lines = [None if line is None else line @ K[:2, :2].T + K[:2, 2] for line in drawn]
    return _with_edges(undistort_picture(photograph(), K, LENS), lines)


def _with_edges(picture: NDArray[np.uint8], lines: Sequence[Floats | None]) -> Figure:
    """Show a picture of the rails with straight edges, and the distances from them."""
    fig, (left, right) = panels(1, 2, (FULL_WIDTH, 3.3), width_ratios=[1.15, 1])
    left.imshow(picture, vmin=0, vmax=255)
    right.axhline(0, color=GREY, lw=1)
    for rail, line, style, role in zip(RAILS, lines, STYLES, ROLES_OF_RAILS, strict=True):
        if line is not None and np.isfinite(line).all():
            _straight_edge(left, line, rail.name)
            _deviation(right, line, rail.name, style, role)
    picture_frame(left, (picture.shape[1], picture.shape[0]))
    right.set(xlabel="u along the rail (px)", ylabel="above the straight edge (px)")
    right.set(xlim=(90, 610), ylim=(-13, 21))
    if len(right.lines) > 1:
        right.legend(loc="upper right", fontsize=9)
    return fig


def _straight_edge(ax: Axes, line: Floats, name: str) -> None:
    """Lay a straight edge over a rail, from end to end."""
    ends = line[[0, -1]] + np.array([[-20, 0], [20, 0]])
    ax.plot(*ends.T, color=ROLES["ray"], lw=1.2)
    write(ax, (line[0, 0] - 38, line[0, 1]), name, fontweight="bold", color="white")


def _deviation(ax: Axes, line: Floats, name: str, style: str, role: str) -> None:
    """Draw how far a line is above the straight line through its ends, px."""
    chord = np.interp(line[:, 0], line[[0, -1], 0], line[[0, -1], 1])
    label = f"{name}: RMS {straightness(line):.2f} px"
    ax.plot(line[:, 0], chord - line[:, 1], style, color=ROLES[role], label=label)
