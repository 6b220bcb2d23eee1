"""Still figures: a picture as a function, and what sampling and rounding make of it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.diagrams import figure, panels
from course_lib.drawing.sensor.screen import grey_squares
from course_lib.drawing.style import BLUE, FULL_WIDTH, GREY, ORANGE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@figure(
    "One small part of a photograph as grey squares, as a table of numbers, and as a "
    "landscape with hills where it is bright."
)
def height_field(picture: ArrayLike, box: tuple[int, int, int, int] = (252, 130, 40, 30)) -> Figure:
    """Show one small part of a picture three times: as grey squares, as numbers, as a landscape.

    Parameters
    ----------
    picture : array_like, shape (height, width)
        Grey values.
    box : tuple of int
        Left, top, width and height of the part, px.

    Returns
    -------
    Figure
        The part as a picture, some of its numbers, and its grey values as heights.
    """
    left, top, width, height = box
    part = np.asarray(picture)[top : top + height, left : left + width]
    fig, axes = _three_panels()
    image, numbers, land = axes
    image.imshow(
        part,
        vmin=0,
        vmax=255,
        extent=(left - 0.5, left + width - 0.5, top + height - 0.5, top - 0.5),
    )
    image.set(title="as light", xlabel="u (px)", ylabel="v (px)")
    _numbers(numbers, part)
    u, v = np.meshgrid(left + np.arange(width), top + np.arange(height))
    land.plot_surface(u, v, part, cmap="gray", rstride=1, cstride=1, lw=0, antialiased=False)
    land.view_init(elev=42, azim=-62)
    land.set_box_aspect((4, 3, 2), zoom=0.88)
    land.invert_yaxis()
    land.set(title="as heights", xlabel="u (px)", ylabel="v (px)")
    land.locator_params(nbins=4)
    land.set_zticks((0, 100, 200))
    land.tick_params(labelsize=7)
    return fig


def _three_panels() -> tuple[Figure, Any]:
    """Return a figure, and its axes: two flat ones and one in three dimensions."""
    import matplotlib.pyplot as plt

    fig = plt.figure(figsize=(FULL_WIDTH, 3.1))
    grid = fig.add_gridspec(1, 3, width_ratios=(1, 1, 1.25))
    kinds: tuple[Any, ...] = (None, None, "3d")
    return fig, [fig.add_subplot(grid[0, k], projection=kind) for k, kind in enumerate(kinds)]


def _numbers(ax: Axes, part: NDArray[np.generic], shown: tuple[int, int] = (6, 9)) -> None:
    """Write the grey values of the middle of a part, each on a square of its grey."""
    rows, columns = shown
    top, left = (part.shape[0] - rows) // 2, (part.shape[1] - columns) // 2
    grey_squares(ax, part[top : top + rows, left : left + columns], 255, 7)
    ax.set(title="as numbers", xlabel="its middle")


@figure(
    "A star with fine spokes on finer and coarser pixels: where each pixel looks at one point"
    " there are false patterns near the middle, where it looks at its whole area mostly grey."
)
def aliasing(pitches: Sequence[int] = (1, 6, 12), size: int = 240) -> Figure:
    """Show a star with fine spokes on sensors with small and with large pixels.

    Parameters
    ----------
    pitches : sequence of int
        Sides of a pixel, in units of the finest.
    size : int
        Side of the star, in the same unit.

    Returns
    -------
    Figure
        Two rows: above, each pixel looks at one point in its middle; below, at its whole area.
    """
    from data_generators.targets import siemens_star

    star = siemens_star(size, 24).astype(float)
    fig, axes = panels(2, len(pitches), (FULL_WIDTH, 5.3))
    for column, pitch in enumerate(pitches):
        middle = pitch // 2
        points = star[middle::pitch, middle::pitch]
        cells = size // pitch
        areas = star[: cells * pitch, : cells * pitch]
        areas = areas.reshape(cells, pitch, cells, pitch).mean(axis=(1, 3))
        for row, sampled in enumerate((points, areas)):
            ax = axes[row, column]
            ax.imshow(sampled, vmin=0, vmax=255)
            ax.set(xticks=[], yticks=[])
        axes[0, column].set_title(
            f"pixels {pitch} times as wide" if pitch > 1 else "finest pixels", fontsize=11
        )
    axes[0, 0].set_ylabel("one point a pixel")
    axes[1, 0].set_ylabel("the whole pixel")
    return fig


@figure(
    "A wave with a period of {period:g} px, a sample in each pixel, and the much slower wave "
    "that passes through the same samples."
)
def sampled_wave(period: float = 1.25, length: float = 10.0) -> Figure:
    """Show a fine pattern of light, samples one pixel apart, and the coarse wave through them.

    Parameters
    ----------
    period : float
        Of the pattern, px; below 2 the samples belong to a coarser wave as well.
    length : float
        How much is drawn, px.

    Returns
    -------
    Figure
        The wave, its samples, and the slowest wave that has the same samples.
    """
    x, samples = np.linspace(0, length, 1201), np.arange(int(length) + 1)
    frequency = 1 / period
    alias = frequency - np.rint(frequency)
    fig, ax = panels(1, 1, (FULL_WIDTH, 2.2))
    ax.plot(x, np.cos(2 * np.pi * frequency * x), color=GREY, lw=1.2, label="light on the sensor")
    if abs(alias) > 1e-9 and abs(alias - frequency) > 1e-9:
        slow = np.cos(2 * np.pi * alias * x)
        ax.plot(x, slow, color=ORANGE, lw=2.5, label=f"what we read: period {1 / abs(alias):.3g}")
    values = np.cos(2 * np.pi * frequency * samples)
    ax.plot(samples, values, "o", color=BLUE, ms=8, label="samples")
    ax.set(xlabel="position (px)", yticks=[], xlim=(-0.2, length + 0.2), ylim=(-1.25, 2.1))
    ax.legend(loc="upper center", ncols=3, fontsize=9)
    return fig


@figure(
    "One photograph with fewer and fewer grey values, and a row of each below: a smooth curve"
    " turns into stairs and then into two levels."
)
def quantisation(picture: ArrayLike, bits: Sequence[int] = (8, 4, 2, 1), row: int = 150) -> Figure:
    """Show a photograph with fewer and fewer grey values, and one of its rows.

    Parameters
    ----------
    picture : array_like, shape (height, width)
        Grey, 8 bits.
    bits : sequence of int
        Of each version.
    row : int
        Whose grey values are drawn below, px.

    Returns
    -------
    Figure
        The versions above, the row below each.
    """
    grey = np.asarray(picture)
    fig, axes = panels(2, len(bits), (FULL_WIDTH, 3.6), sharey="row", height_ratios=(1.1, 1))
    for column, count in enumerate(bits):
        step = 2 ** (8 - count)
        coarse = (grey // step) * step + (step - 1) / 2
        top, bottom = axes[:, column]
        top.imshow(coarse, vmin=0, vmax=255)
        top.set(xticks=[], yticks=[])
        top.set_title(f"{count} bit{'s' if count > 1 else ''}: {2**count}", fontsize=10)
        top.axhline(row, color=ORANGE, lw=1)
        bottom.step(np.arange(grey.shape[1]), coarse[row], color=ORANGE, lw=1.2, where="mid")
        bottom.set(xlabel="u (px)", ylim=(0, 262))
    axes[1, 0].set_ylabel("grey value (DN)")
    return fig
