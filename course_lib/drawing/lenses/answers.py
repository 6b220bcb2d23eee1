"""The stars of a student's answer in the figures of chapter 03, and what lies outside of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.style import BLACK, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MOST = 3  # values beside each other that there is room for


def stars(
    ax: Axes, x: ArrayLike, y: ArrayLike, texts: Sequence[str], label: str | None = None
) -> None:
    """Draw stars, and say which values lie outside of the axes.

    Parameters
    ----------
    ax : Axes
        Where; its limits are set already.
    x, y : array_like, shape (N,)
        Places of the stars.
    texts : sequence of str
        What was answered, one text for each star.
    label : str, optional
        For the legend.
    """
    x, y = np.broadcast_arrays(np.asarray(x, dtype=float), np.asarray(y, dtype=float))
    ax.plot(x, y, "*", color=ROLES["second"], ms=14, ls="", zorder=5, label=label)
    (left, right), (bottom, top) = ax.get_xlim(), sorted(ax.get_ylim())
    inside = (left <= x) & (x <= right) & (bottom <= y) & (y <= top)
    say_outside(ax, [text for text, seen in zip(texts, inside, strict=True) if not seen])


def say_outside(ax: Axes, texts: Sequence[str]) -> None:
    """Write above a figure, at the right, which of a student's values it cannot show."""
    if texts:
        first = ", ".join([*texts[:MOST], *["…"] * (len(texts) > MOST)]).replace("-", "−")
        words = f"your values lie outside the figure: {first}"
        ax.set_title(words, loc="right", fontsize=10, color=BLACK, weight="normal")


def numbers(values: ArrayLike, unit: str = "") -> list[str]:
    """Return values with four digits and their unit, as texts."""
    flat = np.asarray(values, dtype=float).ravel()
    return [f"{value:.4g} {unit}".rstrip() for value in flat]
