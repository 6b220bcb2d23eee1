"""Still figures: three rails on a table, and how straight they look."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.diagrams import (
    Floats,
    figure,
    in_figures,
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
    lines = rail_points(photograph())
    return _with_edges(photograph(), lines, [_middle(line) for line in lines])


def _middle(line: Floats) -> str:
    """Return how far the farthest point of a line is above the straight edge, in words."""
    off = _above(line)
    return f"middle {off[np.argmax(np.abs(off))]:.1f} px".replace("-", "−")


@figure(
    "Left: the photograph of three rails, straightened, with a straight edge laid over each. "
    "Right: how far the middle of each rail is from that edge, in px, along the rail."
)
def straightened_rails(
    lines: Sequence[ArrayLike | None], rms: Sequence[float | None] | None = None
) -> Figure:
    """Show the rails without distortion, and how far they are from straight.

    Parameters
    ----------
    lines : sequence of array_like, each of shape (N, 2)
        Points on rails A, B and C, px, as a student's function undistorted them. A rail with None,
        or without numbers, is left out; without any rail the picture is shown as photographed.
    rms : sequence of float, optional
        How straight a student's function found each rail, px.

    Returns
    -------
    Figure
        The straightened photograph, and the distances from the straight edges.
    """
    shapes = rail_points(photograph())
    drawn = [same_shape(line, shape) for line, shape in zip(lines, shapes, strict=False)]
    drawn += [None] * (len(shapes) - len(drawn))
    known = any(line is not None for line in drawn)
    picture = undistort_picture(photograph(), K, LENS) if known else photograph()
    return _with_edges(picture, drawn, [_of(n, rms) for n in range(len(shapes))])


def _of(number: int, rms: Sequence[float | None] | None) -> str:
    """Return a student's straightness of a rail in words, if there is one."""
    given = rms[number] if rms is not None and number < len(rms) else None
    value = same_shape(given, np.zeros(()))
    return "" if value is None else f"RMS {in_figures(float(value), 2)} px"


def _with_edges(
    picture: NDArray[np.uint8], lines: Sequence[Floats | None], said: Sequence[str]
) -> Figure:
    """Show a picture of the rails with straight edges, and the distances from them."""
    fig, (left, right) = panels(1, 2, (FULL_WIDTH, 3.3), width_ratios=[1.15, 1])
    left.imshow(picture, vmin=0, vmax=255)
    right.axhline(0, color=GREY, lw=1)
    looks = zip(RAILS, lines, said, STYLES, ROLES_OF_RAILS, strict=True)
    for rail, line, words, style, role in looks:
        if line is not None and np.isfinite(line).all():
            _straight_edge(left, line, rail.name)
            label = f"{rail.name}: {words}" if words else rail.name
            right.plot(line[:, 0], _above(line), style, color=ROLES[role], label=label)
    picture_frame(left, (picture.shape[1], picture.shape[0]))
    right.set(xlabel="u along the rail (px)", ylabel="above the straight edge (px)")
    right.set(xlim=(90, 610), ylim=(-13, 21))
    if len(right.lines) > 1:
        right.legend(loc="upper right", fontsize=9)
    else:
        write(right, (350, 4), "your rails go here", color=GREY)
    return fig


def _straight_edge(ax: Axes, line: Floats, name: str) -> None:
    """Lay a straight edge over a rail, from end to end."""
    ends = line[[0, -1]] + np.array([[-20, 0], [20, 0]])
    ax.plot(*ends.T, color=ROLES["ray"], lw=1.2)
    write(ax, (line[0, 0] - 38, line[0, 1]), name, fontweight="bold", color="white")


def _above(line: Floats) -> Floats:
    """Return how far a line is above the straight line through its ends, px."""
    chord = np.interp(line[:, 0], line[[0, -1], 0], line[[0, -1], 1])
    return np.asarray(chord - line[:, 1])
