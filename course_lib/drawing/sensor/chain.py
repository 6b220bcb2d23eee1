"""Still figures: the way of the light from the lamp to the numbers in a file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from course_lib.drawing.diagrams import figure, fit, panels, sketch, stroke, write
from course_lib.drawing.style import BLACK, BLUE, FULL_WIDTH, GREEN, GREY, ORANGE, RED, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Volts of one electron on the capacitor of a pixel: a usual value.
VOLTS = 40e-6
#: The four phases: name, what happens, colour.
PHASES = (
    ("1 illumination", "a lamp sends\nphotons", ORANGE),
    ("2 image formation", "the lens brings them\nto one place", BLUE),
    ("3 detection", "silicon turns photons\ninto electrons", GREEN),
    ("4 formatting", "charge becomes\nnumbers in a file", RED),
)


@figure(
    "Four boxes from left to right: a lamp lights a part; a lens focuses its light on a "
    "sensor; photons fall into a pixel's well and become electrons; grey squares with "
    "numbers."
)
def acquisition_chain() -> Figure:
    """Show the four phases of image acquisition, from the lamp to the file.

    Returns
    -------
    Figure
        A drawing from left to right, not to scale.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 2.9))
    sketch(ax)
    for k, (name, what, colour) in enumerate(PHASES):
        x = 2.6 * k
        ax.fill([x, x + 2.3, x + 2.3, x], [-1.35, -1.35, 1.15, 1.15], color=colour, alpha=0.08)
        write(ax, (x + 1.15, 1.4), name, fontweight="bold", fontsize=10)
        write(ax, (x + 1.15, -1.75), what, fontsize=9)
        if k:
            _arrow(ax, (x - 0.27, 0), (x - 0.03, 0))
    _lamp_and_part(ax, 0.0)
    _lens(ax, 2.6)
    _photodiode(ax, 5.2)
    _numbers(ax, 7.8)
    fit(ax, -0.1, 10.2, -2.15, 1.7)
    return fig


def _arrow(ax: Axes, start: Sequence[float], end: Sequence[float], colour: str = BLACK) -> None:
    arrow = {"arrowstyle": "-|>", "color": colour, "shrinkA": 0, "shrinkB": 0, "lw": 1.6}
    ax.annotate("", xy=(end[0], end[1]), xytext=(start[0], start[1]), arrowprops=arrow)


def _lamp_and_part(ax: Axes, x: float) -> None:
    ax.plot(x + 0.45, 0.75, "o", color=ORANGE, ms=17)
    for way in ((0.75, -1.2), (1.05, -1.15), (1.3, -1.0)):
        _arrow(ax, (x + 0.55, 0.6), (x + 0.5 + way[0], 0.6 + way[1]), ORANGE)
    ax.fill([x + 0.9, x + 2.0, x + 2.0, x + 0.9], [-1.0, -1.0, -0.65, -0.65], color=ROLES["object"])
    write(ax, (x + 1.45, -1.16), "part", "object", fontsize=9)


def _lens(ax: Axes, x: float) -> None:
    turn = np.linspace(-0.9, 0.9, 40)
    bulge = 0.16 * np.cos(turn / 0.9 * np.pi / 2)
    ax.fill(
        np.r_[x + 1.0 - bulge, (x + 1.0 + bulge)[::-1]],
        np.r_[turn, turn[::-1]],
        color=BLUE,
        alpha=0.45,
        lw=0,
    )
    for y in (-0.8, 0.0, 0.8):
        stroke(ax, [(x + 0.12, 0.0), (x + 1.0, y), (x + 2.05, 0.0)], "ray", lw=1.4)
    stroke(ax, [(x + 2.05, -0.7), (x + 2.05, 0.7)], color=BLACK, lw=4)
    write(ax, (x + 2.0, -0.95), "sensor", fontsize=9, ha="right")


def _photodiode(ax: Axes, x: float) -> None:
    """Draw a pixel: photons from above, electrons in a bucket."""
    left, right, top, bottom = x + 0.45, x + 1.85, -0.1, -1.1
    stroke(ax, [(left, top), (left, bottom), (right, bottom), (right, top)], color=BLACK, lw=3)
    ax.fill([left, right, right, left], [bottom, bottom, -0.62, -0.62], color=GREEN, alpha=0.3)
    for dx in (0.25, 0.6, 0.95, 1.25):
        _arrow(ax, (left + dx - 0.1, 0.95), (left + dx, 0.15), ORANGE)
    for k, dx in enumerate((0.22, 0.5, 0.75, 1.02, 1.22)):
        ax.plot(left + dx, -0.96 + 0.17 * (k % 2), "o", color=GREEN, ms=6)
    write(ax, (x + 2.13, 0.62), "photons", fontsize=9, rotation=90)
    write(ax, (x + 2.13, -0.6), "electrons", "image", fontsize=9, rotation=90)


def _numbers(ax: Axes, x: float) -> None:
    values = ((212, 209, 130), (215, 114, 154), (190, 112, 215))
    for i, row in enumerate(values):
        for j, value in enumerate(row):
            left, top = x + 0.25 + 0.6 * j, 0.85 - 0.6 * i
            ax.fill(
                [left, left + 0.6, left + 0.6, left],
                [top, top, top - 0.6, top - 0.6],
                color=str(value / 255),
                ec=GREY,
                lw=0.5,
            )
            ink = BLACK if value > 125 else "white"
            ax.text(
                left + 0.3, top - 0.3, str(value), color=ink, ha="center", va="center", fontsize=8
            )
    write(ax, (x + 1.15, -1.16), "8-bit numbers", fontsize=9)


@figure(
    "Six boxes in a row: {photons:g} photons, electrons, the full well, volts, the amplifier,"
    " and the number in the file, each with its value and the noise that it adds."
)
def light_to_number(
    photons: float = 8000.0,
    quantum_efficiency: float = 0.6,
    gain: float = 0.2,
    offset: float = 64.0,
    bits: int = 12,
) -> Figure:
    """Show what one pixel does with its photons, with the number after each step.

    Parameters
    ----------
    photons : float
        That arrive during the exposure.
    quantum_efficiency : float
        Electrons for each photon.
    gain, offset : float
        DN for each electron, and DN without any.
    bits : int
        Of the number that is written.

    Returns
    -------
    Figure
        Boxes from left to right: the mean number after each step, and the noise that it adds.
    """
    electrons = photons * quantum_efficiency
    number = electrons * gain + offset
    top = 2**bits - 1
    steps = (
        ("photons", f"{photons:.0f}", "arrive by\nchance", ORANGE),
        ("electrons", f"{electrons:.0f}", f"× {quantum_efficiency:g}\nshot, dark noise", GREEN),
        ("full well", f"{electrons:.0f}", "no more\nfit in", GREEN),
        ("volts", f"{electrons * VOLTS:.3f}", "on a capacitor,\nread noise", BLUE),
        ("amplifier", f"{number:.1f}", f"{gain:g} DN an electron,\n+ {offset:g} DN", BLUE),
        ("a number", f"{min(np.rint(number), top):.0f}", f"rounded,\nat most {top}", RED),
    )
    fig, ax = panels(1, 1, (FULL_WIDTH, 1.9))
    sketch(ax)
    for k, step in enumerate(steps):
        _step(ax, 2.0 * k, *step)
    fit(ax, -0.1, 11.75, -0.95, 1.25)
    return fig


def _step(ax: Axes, x: float, name: str, value: str, note: str, colour: str) -> None:
    """Draw one box with its number, and the arrow that leads to it."""
    ax.fill([x, x + 1.65, x + 1.65, x], [0, 0, 1.15, 1.15], color=colour, alpha=0.16, lw=0)
    write(ax, (x + 0.82, 0.85), name, fontsize=9, fontweight="bold")
    write(ax, (x + 0.82, 0.38), value, fontsize=12)
    write(ax, (x + 0.82, -0.42), note, fontsize=8)
    if x:
        _arrow(ax, (x - 0.33, 0.58), (x - 0.02, 0.58))
