"""A length in space: two cameras and their rays, as seen from above."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.diagrams import Floats, figure, panels, write
from course_lib.drawing.style import FULL_WIDTH, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@figure("From above: the target, two places of the camera, and their rays to both ends.")
def rays_from_above(
    target: ArrayLike, centres: Sequence[ArrayLike], ends: ArrayLike, angle_deg: float
) -> Figure:
    """Show from where a length in space was seen.

    Parameters
    ----------
    target : array_like, shape (N, 3)
        Its points, mm.
    centres : sequence of array_like, shape (3,)
        Where the camera was, mm.
    ends : array_like, shape (2, 3)
        Both ends of the length, mm.
    angle_deg : float
        Between the rays.

    Returns
    -------
    Figure
        A map; y runs down, as on the target.
    """
    board, both = np.asarray(target, float), np.asarray(ends, float)
    fig, ax = panels(1, 1, (FULL_WIDTH, 4.2))
    ax.plot(*board[:, :2].T, ".", color=ROLES["guide"], ms=3)
    write(ax, board[:, :2].mean(axis=0), "target", fontsize=9)
    for number, centre in enumerate(centres, 1):
        _camera(ax, np.asarray(centre, float), both, number)
    ax.plot(*both[:, :2].T, "o-", color=ROLES["object"], ms=5)
    ax.set_title(f"rays meet at {angle_deg:.0f}°", fontsize=10)
    ax.set_aspect("equal")
    ax.margins(0.12, 0.16)
    ax.invert_yaxis()
    ax.set(xlabel="x (mm)", ylabel="y (mm)")
    return fig


def _camera(ax: Axes, place: Floats, ends: Floats, number: int) -> None:
    """Draw where a picture was taken, and its rays."""
    for end in ends:
        ax.plot(*np.array([place, end])[:, :2].T, "-", color=ROLES["ray"], lw=1)
    ax.plot(*place[:2], "o", color=ROLES["camera"], ms=9)
    said = f"picture {number},\n{-place[2]:.0f} mm up"
    below = place[:2] + np.array([0, 14])
    write(ax, below, said, "camera", fontsize=9, va="top")
