"""What a length is uncertain by, and the ruler beside it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.diagrams import figure, panels
from course_lib.drawing.style import FULL_WIDTH, GREY, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@figure("What each source contributes to the uncertainty of each length, as bars, and their sum.")
def contributions(lengths: Mapping[str, Mapping[str, float]]) -> Figure:
    """Show the parts of several lengths' uncertainty.

    Parameters
    ----------
    lengths : mapping of str to mapping of str to float
        By the name of a length: standard deviation from each source, mm.

    Returns
    -------
    Figure
        A panel for each, all to one scale.
    """
    fig, grid = panels(1, len(lengths), (FULL_WIDTH, 2.6), sharex=True, squeeze=False)
    for ax, (name, parts) in zip(grid[0], lengths.items(), strict=True):
        bars(ax, parts)
        ax.set_title(name, fontsize=10)
    most = max(float(np.hypot.reduce(list(parts.values()))) for parts in lengths.values())
    grid[0, 0].set_xlim(0, 1.28 * most)
    return fig


def bars(ax: Axes, parts: Mapping[str, float]) -> None:
    """Draw the parts of one length's uncertainty that there are, and all of them together."""
    some = {name: value for name, value in parts.items() if value > 0}
    values = [*some.values(), float(np.hypot.reduce(list(parts.values())))]
    names = [*some, "together"]
    colours = [ROLES["camera"]] * len(some) + [ROLES["object"]]
    places = np.arange(len(names))[::-1]
    ax.barh(places, values, color=colours, height=0.6)
    name_rows(ax, places, names)
    for place, value in zip(places, values, strict=True):
        ax.text(value + 0.02 * max(values), place, f"{value:.3f}", va="center", fontsize=8)
    ax.set(xlabel="standard deviation (mm)", xlim=(0, 1.28 * max(values)))


def name_rows(ax: Axes, rows: NDArray[np.int_], names: Sequence[str]) -> None:
    """Write what each row is, to the left of it."""
    ax.set_yticks([])
    for row, name in zip(rows.tolist(), names, strict=True):
        look: dict[str, Any] = {"textcoords": "offset points", "ha": "right", "va": "center"}
        at = ax.get_yaxis_transform()
        ax.annotate(name, (0, row), (-5, 0), xycoords=at, fontsize=10, **look)


@figure(
    "Each length by the camera and by the ruler, with intervals of 95 %, about the ruler's value."
)
def ruler_and_camera(
    names: Sequence[str],
    differences: Sequence[float],
    camera: Sequence[float],
    ruler: Sequence[float],
) -> Figure:
    """Show how camera and ruler agree.

    Parameters
    ----------
    names : sequence of str
        Of the lengths.
    differences : sequence of float
        Camera minus ruler, mm.
    camera, ruler : sequence of float
        Half the width of their intervals of 95 %, mm.

    Returns
    -------
    Figure
        A row for each.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 0.9 + 0.65 * len(names)))
    rows = np.arange(len(names))[::-1]
    for row, difference, mine, other in zip(rows, differences, camera, ruler, strict=True):
        ax.fill_between([-other, other], row - 0.3, row + 0.3, color=GREY, alpha=0.3, lw=0)
        ax.errorbar(difference, row, xerr=mine, fmt="o", color=ROLES["camera"], capsize=4)
    ax.axvline(0, color=GREY, lw=1)
    name_rows(ax, rows, names)
    ax.set(xlabel="from the ruler's value (mm); grey: the ruler's ±", ylim=(-0.6, len(names) - 0.4))
    return fig


@figure("How far each length is from the truth, with its interval of 95 %; few do not reach zero.")
def off_by(names: Sequence[str], off: Sequence[float], plus_minus: Sequence[float]) -> Figure:
    """Show whether intervals hold the truth as often as they should.

    Parameters
    ----------
    names : sequence of str
        Of the measurements, several may share one.
    off : sequence of float
        Measured minus true, mm.
    plus_minus : sequence of float
        Half the width of the intervals, mm.

    Returns
    -------
    Figure
        Those that do not hold the truth have another colour and a square.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.2))
    places = {name: k for k, name in enumerate(dict.fromkeys(names))}
    seen: dict[str, int] = {}
    for name, error, around in zip(names, off, plus_minus, strict=True):
        x = places[name] + 0.3 * seen.get(name, 0) - 0.15
        seen[name] = seen.get(name, 0) + 1
        role, marker = ("camera", "o") if abs(error) <= around else ("object", "s")
        ax.errorbar(x, error, yerr=around, fmt=marker, ms=4, color=ROLES[role], capsize=3, lw=1.3)
    ax.axhline(0, color=GREY, lw=1)
    ax.set_xticks(list(places.values()), list(places))
    ax.set(xlabel="pair that was held out (number)", ylabel="from the truth (mm)")
    return fig
