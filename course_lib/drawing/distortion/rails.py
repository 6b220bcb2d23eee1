"""Still figures: three rails on a table, and how straight they look."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.distortion import straightness
from course_lib.drawing.diagrams import Floats, figure, panels, picture_frame, write
from course_lib.drawing.style import FULL_WIDTH, GREY, ROLES
from data_generators.rails import RAILS, photograph, rail_points

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

STYLES = ("-", "--", "-.")


@figure(
    "Left: a photograph of three rails with a straight edge laid over each. Right: how far the "
    "middle of each rail is from that edge, in px, along the rail."
)
def rails(
    picture: NDArray[np.uint8] | None = None, points: Sequence[ArrayLike | None] | None = None
) -> Figure:
    """Show the rails, and how far they are from straight.

    Parameters
    ----------
    picture : ndarray, shape (480, 640), uint8, optional
        The photograph; the one with distortion unless given.
    points : sequence of array_like, each of shape (N, 2), optional
        Points on the rails in that photograph, px; a rail with None is left out.

    Returns
    -------
    Figure
        The photograph, and the distances from the straight lines through each rail's ends.
    """
    shown = photograph() if picture is None else picture
    lines = rail_points(photograph()) if points is None else points
    fig, (left, right) = panels(1, 2, (FULL_WIDTH, 3.3), width_ratios=[1.15, 1])
    left.imshow(shown, vmin=0, vmax=255)
    for rail, line, style, role in zip(
        RAILS, lines, STYLES, ("object", "camera", "second"), strict=True
    ):
        if line is not None:
            _straight_edge(left, np.asarray(line, dtype=float), rail.name)
            _deviation(right, np.asarray(line, dtype=float), rail.name, style, role)
    picture_frame(left, (shown.shape[1], shown.shape[0]))
    right.axhline(0, color=GREY, lw=1)
    right.set(xlabel="u along the rail (px)", ylabel="above the straight edge (px)")
    right.set(ylim=(-13, 21))
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
