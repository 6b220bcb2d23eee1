"""A dome scanned with a line of light: the shifts that are measured, and its profile."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.diagrams import Floats, figure, panels, same_shape
from course_lib.drawing.style import FULL_WIDTH, GREY, LIGHT, ROLES
from course_lib.illumination import stripe_height

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Scan(NamedTuple):
    """Where a line of light was seen, x, and how far from its place on the table, both mm."""

    x: Floats
    shift: Floats


def stripe_scan(
    angle: float, height: float = 5.0, pixel: float = 0.1, noise: float = 0.3, step: int = 8
) -> Scan:
    """Move a line of light over a dome and find it in each picture.

    Parameters
    ----------
    angle : float
        Between the light and the vertical, rad.
    height : float
        Of the dome, mm.
    pixel : float
        Side of a pixel on the table, mm.
    noise : float
        Standard deviation with which the line is found, px.
    step : int
        Distance of the places where it is found, px.

    Returns
    -------
    Scan
        Only where the light reaches the dome; the same numbers every time.
    """
    from data_generators.relief import height_map, on_the_table

    row = height_map("dome", height, (300, 1), pixel)
    x = (np.arange(300, dtype=np.float64) - 149.5) * pixel
    place, lit = on_the_table(row, angle, pixel)
    error = noise * pixel * np.random.default_rng(6).standard_normal(300)
    found = np.flatnonzero(lit[0])[::step]
    return Scan(x[found], (place[0] - x + error)[found])


@figure(
    "Height against place: the outline of a dome of {height:g} mm, and below it the smaller "
    "shifts of a line of light that was moved over it."
)
def scanned_profile(
    scan: Scan, angle: float, yours: ArrayLike | None = None, height: float = 5.0
) -> Figure:
    """Show the profile of a dome and the heights found from the shifts of a line of light.

    Parameters
    ----------
    scan : Scan
        From `stripe_scan`.
    angle : float
        Between the light and the vertical, rad.
    yours : array_like, shape (N,), optional
        Heights in mm that a student's function gave for the shifts.
    height : float
        Of the dome, mm.

    Returns
    -------
    Figure
        Height against place, both in mm.
    """
    from data_generators.relief import height_map

    x = (np.arange(300) - 149.5) * 0.1
    fig, ax = panels(1, 1, (FULL_WIDTH, 2.6))
    ax.fill_between(x, height_map("dome", height, (300, 1), 0.1)[0], color=LIGHT, label="the dome")
    ax.plot(scan.x, scan.shift, ".", color=GREY, ms=5, label="shift of the line")
    drawn = same_shape(yours, stripe_height(scan.shift, angle))
    if drawn is not None:
        ax.plot(scan.x, drawn, "o", color=ROLES["second"], ms=5, label="your heights")
    ax.set(xlabel="place x (mm)", ylabel="height, shift (mm)", ylim=(-0.6, 1.5 * height))
    ax.set_aspect("equal")
    ax.legend(loc="upper right", ncols=3, fontsize=9)
    return fig
