"""One page for whoever reads a lab report: photographs, camera, lengths, and where was pointed."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.diagrams import figure
from course_lib.drawing.lab.lengths import bars
from course_lib.drawing.style import FULL_WIDTH, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Pixels = NDArray[np.uint8]


@dataclass(frozen=True, eq=False)
class Length:
    """A length on the page.

    Attributes
    ----------
    text : str
        What it is, and its value with interval.
    parts : dict of str to float
        Standard deviation from each source, mm.
    pictures : tuple of (ndarray, ndarray)
        Cuttings of the photographs, RGB, with both ends in each, shape (2, 2), px of the cutting.
    """

    text: str
    parts: dict[str, float]
    pictures: tuple[tuple[Pixels, NDArray[np.float64]], ...]


@figure("The lab report on one page: photographs, the camera, and each length with its ends.")
def report_page(
    title: str,
    thumbnails: Sequence[tuple[str, Pixels]],
    lines: Sequence[str],
    lengths: Sequence[Length],
) -> Figure:
    """Show a lab report.

    Parameters
    ----------
    title : str
        The page's.
    thumbnails : sequence of (str, ndarray), the pictures of shape (h, w, 3), uint8
        All photographs, and what is written above each.
    lines : sequence of str
        On the camera.
    lengths : sequence of Length
        What was measured.

    Returns
    -------
    Figure
        Photographs above, a row for each length below.
    """
    import matplotlib.pyplot as plt

    count = max(len(thumbnails), 1)
    across = min(9, count)
    down = -(-count // across)
    folded = [fold(line, 128) for line in lines]
    heights = [0.8 * down, 0.165 * sum(f.count("\n") + 1 for f in folded) + 0.1]
    heights += [2.5] * len(lengths)
    fig = plt.figure(figsize=(FULL_WIDTH, sum(heights) + 0.4))
    parts = fig.subfigures(len(heights), 1, height_ratios=heights, squeeze=False)[:, 0]
    grid = parts[0].subplots(down, across, squeeze=False)
    for ax in grid.ravel():
        ax.axis("off")
    for ax, (caption, picture) in zip(grid.ravel(), thumbnails, strict=False):
        ax.imshow(picture)
        ax.set_title(caption, fontsize=6, fontweight="normal")
    fig.suptitle(title, x=0.02, ha="left", fontsize=11, fontweight="bold")
    parts[1].text(0.02, 0.98, "\n".join(folded), va="top", fontsize=8, linespacing=1.3)
    for part, length in zip(parts[2:], lengths, strict=True):
        _row(part, length)
    return fig


def _row(part: object, length: Length) -> None:
    """Draw one length: its cuttings, and its parts."""
    columns = len(length.pictures) + 1
    axes = part.subplots(1, columns, width_ratios=[1] * (columns - 1) + [1.2])  # type: ignore[attr-defined]
    for ax, (picture, ends) in zip(axes[:-1], length.pictures, strict=True):
        _cutting(ax, picture, ends)
    bars(axes[-1], length.parts)
    part.suptitle(fold(length.text, 105), x=0.02, ha="left", fontsize=9)  # type: ignore[attr-defined]


def fold(text: str, width: int) -> str:
    """Return a text in lines of so many characters."""
    return textwrap.fill(text, width, break_long_words=False)


def _cutting(ax: Axes, picture: Pixels, ends: NDArray[np.float64]) -> None:
    ax.imshow(picture)
    ax.plot(*ends.T, "-", color=ROLES["ray"], lw=1)
    ax.plot(*ends.T, "+", color=ROLES["object"], ms=9, mew=1.4)
    ax.set_axis_off()
