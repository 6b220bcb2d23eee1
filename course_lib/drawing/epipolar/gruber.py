"""What the five numbers of a relative orientation do at the six positions of von Gruber."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from course_lib.drawing.diagrams import Floats, figure, fit, panels, sketch, write
from course_lib.drawing.style import FULL_WIDTH, GREY, ROLES
from course_lib.orientation.relative import pose_from_relative

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Below the first and the second centre, above both, and below both: model coordinates, base 1.
POSITIONS = np.array([(0, 0), (1, 0), (0, 1), (1, 1), (0, -1), (1, -1)], dtype=float)
HEIGHT = 1.6  # of the flight, in bases
NAMES = ("$b_y$", "$b_z$", "$\\omega$", "$\\varphi$", "$\\kappa$")
#: How much of each is given: hundredths of the base, or of a radian.
AMOUNT = 0.01


def parallaxes() -> Floats:
    """Return the y-parallaxes that each of the five numbers makes at the six positions.

    Returns
    -------
    ndarray, shape (5, 6)
        Upwards in the second picture, in focal lengths for one unit of each number.
    """
    ground = np.column_stack([POSITIONS, np.full(6, -HEIGHT)])
    to_camera = ground * [1, -1, -1]  # y up and z backwards become y down and z forward
    rows = []
    for step in AMOUNT * np.eye(5):
        sides = []
        for numbers in (step, -step):
            R, t = pose_from_relative([1, numbers[0], numbers[1]], numbers[2:])
            seen = to_camera @ R.T + t
            sides.append(-seen[:, 1] / seen[:, 2])
        rows.append((sides[0] - sides[1]) / (2 * AMOUNT))
    return np.array(rows)


@figure(
    "Six numbered positions in the overlap of two aerial pictures, five times: arrows show how a "
    "wrong number of the relative orientation moves points up or down there. Squares: right below "
    "the two cameras."
)
def von_gruber() -> Figure:
    """Show what each of the five numbers does to the rows of partners.

    Returns
    -------
    Figure
        A panel for each number.
    """
    fig, axes = panels(1, 5, (FULL_WIDTH, 2.6))
    for ax, name, moved in zip(axes, NAMES, parallaxes(), strict=True):
        sketch(ax)
        ax.set_title(name, fontsize=14, loc="center")
        outline = np.array([(-0.25, -1.5), (1.25, -1.5), (1.25, 1.5), (-0.25, 1.5), (-0.25, -1.5)])
        ax.plot(*outline.T, color=GREY, lw=1)
        for number, (x, y), up in zip((1, 2, 3, 4, 5, 6), POSITIONS, moved, strict=True):
            below = "camera" if number <= 2 else "guide"  # right below a camera
            ax.plot(x, y, "s" if number <= 2 else "o", color=ROLES[below], ms=6)
            write(ax, (x - 0.16, y), str(number), fontsize=9)
            length = 0.45 * up / np.abs(moved).max()
            if abs(length) > 0.02:
                look = {"arrowstyle": "-|>", "color": ROLES["object"], "lw": 2.2}
                look |= {"shrinkA": 0, "shrinkB": 0}
                ax.annotate("", xy=(x, y + length), xytext=(x, y), arrowprops=look)
        fit(ax, -0.35, 1.35, -1.7, 1.7)
    return fig
