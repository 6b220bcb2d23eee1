"""The one look of the course: colours with a role, figure sizes, Matplotlib settings.

The palette is that of Okabe and Ito (2008), which stays distinct for colour-blind readers. A role
keeps its colour in every figure, widget and feedback block.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

BLUE, ORANGE, GREEN, RED = "#0072B2", "#E69F00", "#009E73", "#D55E00"
SKY, PURPLE, BLACK, GREY = "#56B4E9", "#CC79A7", "#1A1A1A", "#767676"
LIGHT = "#E8EBEE"

#: What a colour means, wherever it appears.
ROLES = {
    "camera": BLUE,
    "ray": ORANGE,
    "image": GREEN,
    "object": RED,
    "second": PURPLE,
    "guide": GREY,
}

#: Width of a figure in inches: one column of the notebook.
FULL_WIDTH = 8.0

RC: dict[Any, Any] = {
    "figure.figsize": (FULL_WIDTH, 4.0),
    "figure.dpi": 100,
    "figure.constrained_layout.use": True,
    "font.size": 11,
    "axes.titlesize": 12,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": False,
    "axes.edgecolor": GREY,
    "axes.labelcolor": BLACK,
    "legend.frameon": False,
    "lines.linewidth": 2.0,
    "image.cmap": "gray",
    "image.interpolation": "nearest",
}


def rgb(colour: str) -> tuple[int, int, int]:
    """Return a ``#RRGGBB`` colour as three numbers from 0 to 255, as OpenCV draws them.

    Parameters
    ----------
    colour : str
        A colour of this module.

    Returns
    -------
    tuple of int
        Red, green, blue.
    """
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)


def on_screen(light: float) -> float:
    """Return the factor on grey values that makes a screen show so much of the light.

    Parameters
    ----------
    light : float
        Part of the light, 0 to 1.

    Returns
    -------
    float
        A screen's light goes with about the 2.2nd power of the grey value (IEC 61966-2-1), so
        half of the light needs 73 % of the value.
    """
    return float(light ** (1 / 2.2))


@contextmanager
def course_style() -> Iterator[None]:
    """Draw with the course's Matplotlib settings inside a ``with`` block."""
    import matplotlib as mpl
    from cycler import cycler

    cycle = cycler(color=[BLUE, ORANGE, GREEN, RED, PURPLE, SKY])
    with mpl.rc_context({**RC, "axes.prop_cycle": cycle}):
        yield
