"""Still figures: light from the front, from behind and in stripes, and a lamp that fades."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.diagrams import dimension, figure, fit, panels, sketch, stroke, write
from course_lib.drawing.sensor.screen import grey_squares
from course_lib.drawing.style import BLACK, BLUE, FULL_WIDTH, GREY, LIGHT, ORANGE, RED, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: The 8 × 8 picture of a back-lit part: 0 to 15.
BACK_LIT = (
    (15, 15, 15, 15, 15, 15, 15, 15),
    (15, 15, 15, 15, 15, 15, 15, 15),
    (15, 1, 0, 15, 15, 0, 1, 15),
    (15, 1, 0, 10, 10, 0, 1, 15),
    (15, 1, 0, 0, 0, 0, 1, 15),
    (15, 1, 0, 0, 0, 0, 1, 15),
    (15, 1, 1, 1, 1, 1, 1, 15),
    (15, 15, 15, 15, 15, 15, 15, 15),
)


@figure(
    "Three drawings from the side: lamps above the part and beside the camera; a bright panel"
    " below the part; a projector that sends a fan of light from the side."
)
def three_lights() -> Figure:
    """Show where lamp, part and camera stand for front light, back light and structured light.

    Returns
    -------
    Figure
        Three drawings from the side, with the camera above.
    """
    fig, axes = panels(1, 3, (FULL_WIDTH, 3.0))
    for ax, title in zip(axes, ("front light", "back light", "structured light"), strict=True):
        sketch(ax, title)
        _camera(ax)
        ax.fill([-0.8, 0.8, 0.8, -0.8], [-1.0, -1.0, -0.4, -0.4], color=ROLES["object"], lw=0)
        fit(ax, -2.6, 2.6, -2.5, 2.6)
    for side in (-1, 1):
        axes[0].plot(side * 1.9, 1.3, "o", color=ORANGE, ms=16)
        _ray(axes[0], (side * 1.7, 1.1), (side * 0.35, -0.32))
    stroke(axes[0], [(-2.3, -1.05), (2.3, -1.05)], color=GREY, lw=3)
    write(axes[0], (0, -1.75), "surface: print, texture,\nscratches", fontsize=9)
    axes[1].fill([-2.2, 2.2, 2.2, -2.2], [-1.75, -1.75, -1.45, -1.45], color=ORANGE, lw=0)
    for x in (-1.7, -1.2, 1.2, 1.7):
        _ray(axes[1], (x, -1.4), (0.62 * x, 0.9))
    write(axes[1], (0, -2.2), "outline: size, holes", fontsize=9)
    axes[2].plot(-2.1, 1.5, "s", color=RED, ms=13)
    for x in (-0.4, 0.0, 0.4):
        stroke(axes[2], [(-2.0, 1.4), (x, -0.4)], color=RED, lw=1.2)
    for x in (1.1, 1.5):
        stroke(axes[2], [(-2.0, 1.4), (x, -1.0)], color=RED, lw=1.2)
    stroke(axes[2], [(-2.3, -1.05), (2.3, -1.05)], color=GREY, lw=3)
    write(axes[2], (0, -1.75), "height", fontsize=9)
    return fig


def _camera(ax: Axes) -> None:
    ax.fill([-0.45, 0.45, 0.45, -0.45], [1.7, 1.7, 2.4, 2.4], color=BLUE, lw=0)
    ax.fill([-0.22, 0.22, 0.28, -0.28], [1.7, 1.7, 1.4, 1.4], color=BLACK, lw=0)


def _ray(ax: Axes, start: tuple[float, float], end: tuple[float, float]) -> None:
    arrow = {"arrowstyle": "-|>", "color": ORANGE, "shrinkA": 0, "shrinkB": 0, "lw": 1.6}
    ax.annotate("", xy=end, xytext=start, arrowprops=arrow)


@figure(
    "An 8 by 8 table of grey values with a dark U-shaped part of 0 and 1 before a background "
    "of 15; the histogram has two groups with a threshold between them."
)
def back_lit(threshold: float = 7.5, pixel: float = 0.5) -> Figure:
    """Show the grey values of a small back-lit part, and which pixels a threshold takes for it.

    Parameters
    ----------
    threshold : float
        Pixels below it belong to the part.
    pixel : float
        Side of a pixel on the part, mm.

    Returns
    -------
    Figure
        The numbers of an 8 × 8 picture of 16 grey values, and their histogram.
    """
    grey = np.array(BACK_LIT)
    fig, (ax, counts) = panels(1, 2, (FULL_WIDTH, 3.3), width_ratios=(1, 1.25))
    grey_squares(ax, grey, 15)
    ax.set_title(f"pixels of {pixel:g} mm")
    for i, j in np.argwhere(grey < threshold).tolist():
        square = np.array([(j, i)]) + np.array([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)])
        ax.fill(*square.T, fill=False, ec=ORANGE, lw=2)
    height = np.bincount(grey.ravel(), minlength=16)
    counts.bar(np.arange(16), height, color=[ORANGE if g < threshold else GREY for g in range(16)])
    counts.axvline(threshold, color=BLACK, lw=1.5, ls=(0, (5, 3)))
    counts.text(threshold + 0.3, height.max() * 0.92, f"threshold {threshold:g}", fontsize=9)
    counts.set(xlabel="grey value (DN)", ylabel="number of pixels (px)")
    return fig


@figure(
    "A cut: light from the left stops on a block of height h; seen from above it is shifted "
    "by s from where it would meet the table; the angle at the top of the triangle is theta."
)
def stripe_geometry(height: float = 3.0, angle_deg: float = 40.0) -> Figure:
    """Show why a stripe of slanted light moves sideways where it meets something high.

    Parameters
    ----------
    height : float
        Of the block, mm.
    angle_deg : float
        Between the light and the vertical, degrees.

    Returns
    -------
    Figure
        A cut: light from the left, the camera above, the triangle of height and shift.
    """
    angle = np.radians(angle_deg)
    shift = height * np.tan(angle)
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.2))
    sketch(ax)
    ax.fill([-9, 9, 9, -9], [0, 0, -0.6, -0.6], color=LIGHT, lw=0)
    right = shift / 2 + 0.4
    ax.fill(
        [-4 - shift, right - shift, right - shift, -4 - shift],
        [0, 0, height, height],
        color=GREY,
        alpha=0.35,
        lw=0,
    )
    top = height + 2.6
    stroke(ax, [(-top * np.tan(angle), top), (-shift, height)], "ray", lw=3)
    stroke(ax, [(-shift, height), (0, 0)], "ray", lw=2, ls=(0, (4, 3)))
    for x, y in ((-shift, height), (0.0, 0.0)):
        stroke(ax, [(x, y), (x, top)], "camera", lw=1.6)
    stroke(ax, [(-shift, 0), (-shift, height)], "object", lw=3)
    ax.plot([-shift, 0], [height, 0], "o", color=BLACK, ms=8, zorder=5)
    dimension(ax, (-shift, -1.1), (0, -1.1), "shift $s$")
    _names(ax, shift, height, top, angle)
    fit(ax, -9, 9, -1.7, top + 0.4)
    return fig


def _names(ax: Axes, shift: float, height: float, top: float, angle: float) -> None:
    """Write what is what into the cut."""
    write(ax, (-shift - 0.25, height / 2), "$h$", "object", ha="right", fontsize=14)
    write(ax, (-top * np.tan(angle) - 0.2, top - 0.2), "light", ha="right")
    write(ax, (0.2, top - 0.2), "to the camera", "camera", ha="left")
    write(ax, (0.25, 0.45), "where it would be without the block", ha="left", fontsize=9)
    write(ax, (-shift + 0.62, height * 0.42), r"$\theta$", fontsize=12)


@figure(
    "Grey values against hours of use: part and white patch lose 15 % in the first 100 hours "
    "and a little more later; the part divided by the patch stays level."
)
def lamp_drift(hours: float = 400.0) -> Figure:
    """Show how a fluorescent lamp fades, and what a reference patch in the picture saves.

    Parameters
    ----------
    hours : float
        Drawn, h.

    Returns
    -------
    Figure
        Measured brightness of a part against time: as it is, and divided by the patch.
    """
    time = np.linspace(0, hours, 240)
    lamp = fading(time)
    rng = np.random.default_rng(3)
    part = 180 * lamp * (1 + 0.008 * rng.standard_normal(time.size))
    patch = 220 * lamp * (1 + 0.004 * rng.standard_normal(time.size))
    fig, ax = panels(1, 1, (FULL_WIDTH, 2.7))
    ax.plot(time, part, color=GREY, lw=1.2, label="part, as measured")
    ax.plot(time, 220 * part / patch, color=BLUE, lw=1.2, label="part / patch × 220")
    ax.plot(time, patch, color=ORANGE, lw=1.2, label="white patch, 220 when new")
    ax.set(xlabel="hours of use (h)", ylabel="grey value (DN)", ylim=(120, 250), xlim=(0, hours))
    ax.legend(loc="upper right", ncols=3, fontsize=9)
    return fig


def fading(hours: ArrayLike) -> NDArray[np.float64]:
    """Return the light of a fluorescent lamp by that when new: 15 % less after 100 h.

    Parameters
    ----------
    hours : array_like
        Of use, h.

    Returns
    -------
    ndarray
        A fast loss that ends at 100 h and a slow one, ``0.85 (h / 100)^-0.02``, that goes on.
    """
    h = np.asarray(hours, dtype=float)
    return np.where(h < 100, 1 - 0.15 * h / 100, 0.85 * (np.maximum(h, 100) / 100) ** -0.02)
