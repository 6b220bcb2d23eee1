"""Still figures: circles of confusion, and the range that is sharp enough."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.diagrams import (
    dimension,
    figure,
    fit,
    panels,
    plain_numbers,
    same_shape,
    sketch,
    stroke,
    write,
)
from course_lib.drawing.lenses.answers import numbers, say_outside, stars
from course_lib.drawing.lenses.imaging import lens_shape
from course_lib.drawing.style import BLACK, FULL_WIDTH, ORANGE, ROLES
from course_lib.optics import (
    circle_of_confusion,
    closeup_depth_of_field,
    depth_of_field,
    depth_of_field_approximate,
    hyperfocal_distance,
    image_distance,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@figure("Light of a point before and of a point behind the plane of focus makes a spot.")
def blur_cones(
    f: float = 1.5, d: float = 1.7, focus: float = 5.0, near: float = 3.2, far: float = 9.0
) -> Figure:
    """Show where the light of a near and of a far point meets, and the spots on the sensor.

    Parameters
    ----------
    f, d : float
        Focal length and diameter of the opening, one unit of length.
    focus, near, far : float
        Distances that the lens is focused on, and of the two points.

    Returns
    -------
    Figure
        Two side views, to scale.
    """
    sensor = float(image_distance(f, focus))
    fig, axes = panels(2, 1, (FULL_WIDTH, 5.8))
    titles = (
        "A near point: its light would meet behind the sensor",
        "A far point: its light has met before the sensor",
    )
    for ax, Z, title in zip(axes, (near, far), titles, strict=True):
        sketch(ax, title)
        stroke(ax, [(-far - 0.4, 0), (3.2, 0)], "guide", lw=1, ls=(0, (8, 4)))
        _cone(ax, Z, d, float(image_distance(f, Z)), sensor)
        lens_shape(ax, 0, d)
        stroke(ax, [(-focus, -0.9), (-focus, 0.9)], "guide", lw=1.2, ls=":")
        write(ax, (-focus, 1.1), "in focus", "guide")
        write(ax, (sensor, 1.15), "sensor", "guide")
        dimension(ax, (-0.5, -d / 2), (-0.5, d / 2), "$d$")
        dimension(ax, (-Z, -1.2), (0, -1.2), "$Z$")
        dimension(ax, (-focus, -1.7), (0, -1.7), "$D$")
        dimension(ax, (0, -1.2), (sensor, -1.2), "$s_D$")
        dimension(ax, (0, -1.7), (float(image_distance(f, Z)), -1.7), "$s_Z$")
        fit(ax, -far - 0.5, 3.4, -1.95, 1.35)
    return fig


def _cone(ax: Axes, Z: float, d: float, meet: float, sensor: float) -> None:
    """Draw the light of a point that passes a lens and meets at a place, and its spot.

    Both similar triangles, with the opening and with the spot as their base, are filled.
    """
    end, spot = max(meet, sensor), abs(d * (sensor - meet) / meet)
    turned = d / 2 * (1 - end / meet)
    ax.fill([0, meet, 0], [d / 2, 0, -d / 2], color=ORANGE, alpha=0.25, lw=0)
    ax.fill([sensor, meet, sensor], [spot / 2, 0, -spot / 2], color=ORANGE, alpha=0.55, lw=0)
    for side in (-1, 1):
        stroke(ax, [(-Z, 0), (0, side * d / 2), (end, side * turned)], "ray", lw=1.5)
    stroke(ax, [(sensor, -1), (sensor, 1)], "guide", lw=2)
    stroke(ax, [(sensor, -spot / 2), (sensor, spot / 2)], "image", lw=4)
    ax.plot(-Z, 0, "o", color=ROLES["object"], ms=9)
    ax.plot(meet, 0, "o", color=BLACK, ms=6, zorder=5)
    write(ax, (-Z, 0.35), "point", "object")
    write(ax, (sensor + 0.14, -0.8), "spot", "image", ha="left")


@figure("Blur of a point on the sensor against its distance, for f = {f:g} mm at f/{N:g}.")
def blur_against_distance(
    f: float = 85.0,
    N: float = 8.0,
    focus: float = 2200.0,
    c: float = 0.0135,
    yours: ArrayLike | None = None,
) -> Figure:
    """Show the circle of confusion at all distances, and where it is smaller than c.

    Parameters
    ----------
    f, N, focus, c : float
        Focal length, f-number, distance of focus and permissible spot; lengths in mm.
    yours : array_like, shape (2,), optional
        Near and far limit that a student's function gave, mm.

    Returns
    -------
    Figure
        Diameter of the spot against distance, with the limits of the depth of field.
    """
    near, far = (float(limit) for limit in depth_of_field(f, N, focus, c))
    wide = min(far - near, focus)
    Z = np.linspace(max(near - 1.5 * wide, 1.1 * f), min(far, focus + wide) + 2 * wide, 800)
    spot = circle_of_confusion(Z, focus, f, N)
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.6))
    ax.plot(Z, spot, color=ROLES["ray"], label="spot of a point")
    ax.axhline(c, color=ROLES["guide"], ls=(0, (6, 4)), lw=1.4)
    write(ax, (Z[-1], c), f"c = {c:.3g} mm ", "guide", ha="right", va="bottom")
    ax.axvspan(near, min(far, Z[-1]), color=ROLES["image"], alpha=0.2, lw=0)
    end = "∞" if np.isinf(far) else f"{far:.0f} mm"
    top = max(1.3 * float(spot[-1]), 1.3 * c)
    write(ax, ((near + min(far, Z[-1])) / 2, 0.85 * top), f"{near:.0f} mm\nto {end}", "image")
    ax.set(xlabel="distance Z of the point (mm)", ylabel="diameter of the spot (mm)")
    ax.set(xlim=(Z[0], Z[-1]), ylim=(0, top))
    drawn = same_shape(yours, np.zeros(2))
    if drawn is not None:
        stars(ax, drawn, [c, c], numbers(drawn, "mm"), "your limits")
    ax.legend(loc="upper right")
    return fig


@figure("Ranges that are sharp for several distances of focus, f = {f:g} mm at f/{N:g}.")
def ranges(
    f: float = 24.0,
    N: float = 8.0,
    c: float = 0.006,
    focus: Sequence[float] = (1000, 2000, 4000, 12024, 30000),
    yours: Sequence[ArrayLike | None] | None = None,
) -> Figure:
    """Show the sharp range for several distances of focus, up to and beyond the hyperfocal one.

    Parameters
    ----------
    f, N, c : float
        Focal length, f-number and permissible spot; lengths in mm.
    focus : sequence of float
        Distances that the lens is focused on, mm.
    yours : sequence of array_like, shape (2,), optional
        Near and far limits that a student's function gave, mm.

    Returns
    -------
    Figure
        A bar for each distance, on a logarithmic axis in m.
    """
    H, end = float(hyperfocal_distance(f, N, c)) / 1000, 200.0
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.6))
    for row, distance in enumerate(focus):
        near, far = (float(limit) / 1000 for limit in depth_of_field(f, N, distance, c))
        ax.barh(row, min(far, end) - near, left=near, height=0.5, color=ROLES["image"], alpha=0.45)
        ax.plot(distance / 1000, row, "o", color=BLACK, ms=7)
        label = "∞" if np.isinf(far) else f"{far:.2f}"
        write(ax, (near * 0.87, row), f"{near:.2f}", ha="right")
        write(ax, (min(far, end) * 1.15, row), label, ha="left")
    ax.axvline(H, color=ROLES["guide"], ls=(0, (6, 4)), lw=1.4)
    write(ax, (1.06 * H, -0.75), "hyperfocal distance", "guide", ha="left", fontsize=9)
    ax.set(xscale="log", xlim=(0.5, 320), ylim=(len(focus) - 0.4, -1.1), yticks=[])
    ax.set(xlabel="distance from the lens (m)")
    ax.spines["left"].set_visible(False)
    ax.plot([], [], "o", color=BLACK, ms=7, label="focus")
    ax.barh([0], [0], color=ROLES["image"], alpha=0.45, label="sharp")
    ax.legend(loc="lower left", bbox_to_anchor=(0, 0.97), ncols=2, fontsize=10)
    plain_numbers(ax)
    _mark_limits(ax, yours or (), end)
    return fig


def _mark_limits(ax: Axes, yours: Sequence[ArrayLike | None], end: float) -> None:
    """Mark the limits in mm that a student's function gave for each row; infinity at the end."""
    rows = [(row, same_shape(pair, np.zeros(2))) for row, pair in enumerate(yours)]
    limits = np.array(
        [(row, limit / 1000) for row, pair in rows if pair is not None for limit in pair]
    )
    if not limits.size:
        return
    row, limit = limits.T
    left, right = ax.get_xlim()
    shown = (limit >= left) & ((limit <= right) | np.isposinf(limit))
    for place, height in zip(np.minimum(limit, end)[shown], row[shown], strict=True):
        ax.plot(place, height, "*", color=ROLES["second"], ms=13, zorder=5)
    say_outside(ax, numbers(limit[~shown], "m"))


@figure("How much too deep the approximate depth of field is, against the focus distance.")
def approximation(f: float = 85.0, N: float = 8.0, c: float = 0.0135) -> Figure:
    """Show by how much the engineer's approximation differs from the exact thin lens.

    Parameters
    ----------
    f, N, c : float
        Focal length, f-number and permissible spot; lengths in mm.

    Returns
    -------
    Figure
        Relative error of the depth, far minus near, against the focus distance in focal lengths.
    """
    ratio = np.geomspace(2, 200, 300)
    exact, rough = (
        np.subtract(*limits(f, N, ratio * f, c)[::-1])
        for limits in (depth_of_field, depth_of_field_approximate)
    )
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.3))
    ax.loglog(ratio, 100 * (rough / exact - 1), color=ROLES["camera"])
    for place in (3, 10, 100):
        error = float(np.interp(place, ratio, 100 * (rough / exact - 1)))
        ax.plot(place, error, "o", color=BLACK, ms=7)
        write(ax, (place * 1.08, error * 1.25), f"{error:.2g} %", ha="left")
    ax.set(xlabel="focus distance by focal length (no unit)")
    ax.set(ylabel="depth too large by (%)", xlim=(2, 200), ylim=(0.4, 200))
    plain_numbers(ax)
    return fig


@figure("Depth of field against magnification, from small parts to the microscope, at f/{N:g}.")
def closeup(N: float = 16.0, c: float = 0.038, yours: ArrayLike | None = None) -> Figure:
    """Show how thin the sharp range gets when things are imaged large.

    Parameters
    ----------
    N, c : float
        f-number and permissible spot in mm.
    yours : array_like, shape (2,), optional
        Depths that a student's function gave for the magnifications 1/20 and 100, mm.

    Returns
    -------
    Figure
        Depth against magnification, with the two examples of the text.
    """
    m, shown = np.geomspace(0.02, 200, 200), np.array([0.05, 1.0, 100.0])
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.6))
    ax.loglog(m, closeup_depth_of_field(m, N, c), color=ROLES["camera"])
    depth = closeup_depth_of_field(shown, N, c)
    ax.plot(shown, depth, "o", color=BLACK, ms=7)
    for place, value, name in zip(shown, depth, ("1/20", "1", "100"), strict=True):
        text = f"m = {name}: " + (f"{1000 * value:.0f} µm" if value < 0.1 else f"{value:.3g} mm")
        write(ax, (1.25 * place, 1.35 * value), text, ha="left", va="bottom")
    ax.set(xlabel="magnification m (no unit)", ylabel="depth of field (mm)")
    ax.set(xlim=(0.02, 2000), ylim=(0.003, 6000))
    plain_numbers(ax)
    drawn = same_shape(yours, np.zeros(2))
    if drawn is not None:
        stars(ax, shown[[0, 2]], drawn, numbers(drawn, "mm"), "yours")
        ax.legend(loc="lower left")
    return fig
