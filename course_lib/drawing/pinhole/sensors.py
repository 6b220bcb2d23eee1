"""Still figures: pixels, angles of view and sensor sizes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.camera import image_centre
from course_lib.drawing.diagrams import (
    dimension,
    figure,
    fit,
    panels,
    same_shape,
    sketch,
    stroke,
    write,
)
from course_lib.drawing.sensors import SENSORS
from course_lib.drawing.style import BLACK, BLUE, FULL_WIDTH, GREEN, GREY, ORANGE, PURPLE, RED
from course_lib.optics import equivalent_focal_length, field_of_view

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: What a sensor is known from, where its name does not say it.
FOUND_IN = {"1/2.3 inch": " (compact camera)"}


@figure(
    "A grid of {width} × {height} pixels: the corner of the picture is at (−0.5, −0.5), the "
    "centre of the first pixel at (0, 0), and the middle between the first and the last "
    "pixel."
)
def pixel_grid(width: int = 8, height: int = 5) -> Figure:
    """Show where the pixel coordinates (u, v) start and where the middle of a picture is.

    Parameters
    ----------
    width, height : int
        Size of the picture, px.

    Returns
    -------
    Figure
        The pixels, their centres, the corners and the middle.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.6))
    for k in range(width + 1):
        ax.plot([k - 0.5] * 2, [-0.5, height - 0.5], color=GREY, lw=0.8)
    for k in range(height + 1):
        ax.plot([-0.5, width - 0.5], [k - 0.5] * 2, color=GREY, lw=0.8)
    u, v = np.meshgrid(np.arange(width), np.arange(height))
    ax.plot(u.ravel(), v.ravel(), ".", color=GREY, ms=5)
    c_x, c_y = image_centre((width, height))
    marks = [
        ("s", (-0.5, -0.5), "corner of the picture: (−0.5, −0.5)", GREEN),
        ("o", (0, 0), "centre of the first pixel: (0, 0)", BLUE),
        ("P", (c_x, c_y), f"middle of the picture: ({c_x:g}, {c_y:g})", RED),
    ]
    for row, (marker, at, label, colour) in enumerate(marks):
        line = {"ls": "", "ms": 10, "color": colour, "clip_on": False}
        ax.plot(*at, marker, **line)
        ax.plot(width + 0.3, 0.6 + row, marker, **line)
        write(ax, (width + 0.7, 0.6 + row), label, color=colour, ha="left")
    ax.set_xlabel("u (px): column", loc="left")
    ax.set(ylabel="v (px): row", xlim=(-0.7, width + 5.5), aspect="equal")
    ax.set(ylim=(height - 0.3, -0.7), xticks=range(width), yticks=range(height))
    ax.spines[["left", "bottom"]].set_visible(False)
    return fig


@figure(
    "From above: a sensor {width:g} mm wide, {f:g} mm from the hole. Half of its width and f "
    "are the sides of a right triangle; its angle at the hole is half of the angle of view."
)
def view_angle(f: float = 50.0, width: float = 36.0) -> Figure:
    """Show the triangle from which the angle of view is read.

    Parameters
    ----------
    f, width : float
        Focal length and width of the sensor, mm.

    Returns
    -------
    Figure
        Top view of hole and sensor, to scale.
    """
    half = width / 2
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.2))
    sketch(ax)
    ax.fill([0, f, f], [0, 0, half], color=ORANGE, alpha=0.3, lw=0)
    for side in (-1, 1):
        stroke(ax, [(0, 0), (1.5 * f, 1.5 * side * half)], "ray")
    stroke(ax, [(-0.05 * f, 0), (1.55 * f, 0)], "guide", lw=1, ls=(0, (8, 4)))
    stroke(ax, [(f, -half), (f, half)], "image", lw=5)
    ax.plot(0, 0, "o", color=BLACK, ms=8)
    _arc(ax, 0.42 * f, half / f)
    theta = np.degrees(field_of_view(f, (width, width))[0])
    write(ax, (0.47 * f, -0.05 * f), rf"$\theta$ = {theta:.1f}°", ha="left", va="top")
    write(ax, (f * 1.03, half / 2), r"$W/2$", "image", ha="left", fontsize=13)
    write(ax, (f * 1.03, -half / 2), f"sensor, W = {width:g} mm", "image", ha="left")
    dimension(ax, (0, -1.35 * half), (f, -1.35 * half), f"f = {f:g} mm")
    fit(ax, -0.1 * f, 1.75 * f, -1.65 * half, 1.6 * half)
    return fig


def _arc(ax: Axes, radius: float, tangent: float) -> None:
    angles = np.linspace(-np.arctan(tangent), np.arctan(tangent), 60)
    ax.plot(radius * np.cos(angles), radius * np.sin(angles), color=BLACK, lw=1.5)


@figure("Sensors drawn to scale around a common corner, each with its size and its crop factor.")
def sensors_to_scale(sensors: Mapping[str, tuple[float, float]] | None = None) -> Figure:
    """Show sensors in their true proportions, with diagonal and crop factor.

    Parameters
    ----------
    sensors : mapping of str to (float, float), optional
        Name to width and height, mm.

    Returns
    -------
    Figure
        Sensors with a common corner, and a line of numbers for each.
    """
    sensors = sensors or SENSORS
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.9))
    colours = [GREY, BLUE, ORANGE, GREEN, RED, PURPLE]
    tallest = max(height for _, height in sensors.values())
    row = tallest / len(sensors)
    for k, ((name, size), colour) in enumerate(zip(sensors.items(), colours, strict=False)):
        width, height = size
        ax.fill([0, width, width, 0], [0, 0, height, height], color=colour, alpha=0.25, lw=0)
        stroke(ax, [(0, height), (width, height), (width, 0)], color=colour, lw=2.5)
        y = tallest - (k + 0.5) * row
        crop = equivalent_focal_length(1, size)
        ax.plot(39, y, "s", color=colour, ms=10)
        label = f"{name}{FOUND_IN.get(name, '')}\n{width:g} × {height:g} mm, crop factor {crop:.2f}"
        write(ax, (40.5, y), label, ha="left")
    ax.set(xlabel="width (mm)", ylabel="height (mm)", xlim=(0, 66), ylim=(0, tallest * 1.02))
    ax.set(aspect="equal", xticks=range(0, 37, 6), yticks=range(0, 25, 6))
    ax.spines["bottom"].set_bounds(0, 36)
    return fig


@figure(
    "Wedges from above: the horizontal angles of view of lenses with f = {focal_lengths} mm; "
    "the longer the lens, the narrower its wedge."
)
def lens_fan(
    focal_lengths: Sequence[float] = (14, 24, 50, 85, 200, 600),
    sensor_size: tuple[float, float] = (36.0, 24.0),
    yours: ArrayLike | None = None,
) -> Figure:
    """Show the horizontal angles of view of several lenses, seen from above.

    Parameters
    ----------
    focal_lengths : sequence of float
        mm.
    sensor_size : tuple of float
        Width and height, mm.
    yours : array_like, shape (N, 3), optional
        Horizontal, vertical and diagonal angles in rad that a student's function gave; the
        horizontal ones are dotted.

    Returns
    -------
    Figure
        A wedge for each lens.
    """
    angles = np.array([field_of_view(f, sensor_size) for f in focal_lengths])
    fig, ax = panels(1, 1, (FULL_WIDTH, 4.2))
    sketch(ax)
    colours = [BLUE, GREEN, ORANGE, RED, PURPLE, BLACK]
    for k, (f, angle) in enumerate(zip(focal_lengths, angles[:, 0], strict=True)):
        _wedge(ax, angle, 1 + 0.13 * k, colours[k % 6], f"{f:g} mm, {np.degrees(angle):.1f}°")
    drawn = same_shape(yours, angles)
    for k, angle in enumerate([] if drawn is None else drawn[:, 0]):
        tip = (1.04 + 0.13 * k) * np.array([np.sin(angle / 2), np.cos(angle / 2)])
        for side in (-1, 1):
            stroke(ax, [(0, 0), (side * tip[0], tip[1])], color=BLACK, lw=1, ls=":")
    ax.plot(0, 0, "o", color=BLACK, ms=8)
    note = "dotted: your function" if drawn is not None else ""
    write(ax, (0.9, 0.05), note, ha="left")
    fit(ax, -1.25, 2.1, -0.08, 1.75)
    return fig


def _wedge(ax: Axes, angle: float, radius: float, colour: str, label: str) -> None:
    """Draw a wedge of an angle around straight ahead, with its label at the end of its arc."""
    turns = np.linspace(-angle / 2, angle / 2, 60)
    arc = radius * np.stack([np.sin(turns), np.cos(turns)], axis=1)
    ax.fill(*np.vstack([(0, 0), arc]).T, color=colour, alpha=0.15, lw=0)
    stroke(ax, np.vstack([(0, 0), arc, (0, 0)]), color=colour, lw=1.8)
    end = arc[-1]
    ax.plot([end[0], 1.15], [end[1], end[1]], color=colour, lw=0.8)
    write(ax, (1.18, end[1]), label, ha="left")
