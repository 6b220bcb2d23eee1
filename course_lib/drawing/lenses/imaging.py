"""Still figures: from the hole to the lens, and where a lens makes its image."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.diagrams import (
    dimension,
    figure,
    fit,
    hole_in_wall,
    panels,
    plain_numbers,
    same_shape,
    sketch,
    stroke,
    tree,
    write,
)
from course_lib.drawing.lenses.answers import numbers, stars
from course_lib.drawing.style import BLACK, FULL_WIDTH, ORANGE, ROLES
from course_lib.optics import image_distance, magnification
from course_lib.optics import pixel_on_object as sampled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@figure("Light of one point through a small hole, a large hole and a lens of the same size.")
def hole_and_lens(d: float = 1.6) -> Figure:
    """Show how much light of one point gets through, and how wide its spot is.

    Parameters
    ----------
    d : float
        Diameter of the large hole and of the lens; the sensor is 3 behind, the point 6 before.

    Returns
    -------
    Figure
        Three side views: small hole, large hole, and a lens in the large one.
    """
    fig, axes = panels(3, 1, (FULL_WIDTH, 5.4))
    titles = ("A small hole: sharp, dark", "A large hole: bright, blurred")
    for ax, title, hole, lens in zip(
        axes,
        (*titles, "A lens in the large hole: bright and sharp"),
        (0.16, d, d),
        (False, False, True),
        strict=True,
    ):
        sketch(ax, title)
        end = 0.0 if lens else hole / 2 * (6 + 3) / 6
        edges = [(-6, 0), (0, hole / 2), (3, end), (3, -end), (0, -hole / 2)]
        ax.fill(*np.array(edges).T, color=ORANGE, alpha=0.3, lw=0)
        for side in (-1, 1):
            stroke(ax, [(-6, 0), (0, side * hole / 2), (3, side * end)], "ray", lw=1.5)
        hole_in_wall(ax, 0, hole, 1.25, 0.12)
        if lens:
            lens_shape(ax, 0, d)
        stroke(ax, [(3, -1.25), (3, 1.25)], "guide", lw=2)
        stroke(ax, [(3, -max(end, 0.06)), (3, max(end, 0.06))], "image", lw=7)
        ax.plot(-6, 0, "o", color=ROLES["object"], ms=9)
        write(ax, (-6, 0.35), "point", "object", va="bottom")
        write(ax, (3.2, 0), "spot", "image", ha="left")
        fit(ax, -6.8, 4.4, -1.3, 1.35)
    return fig


def lens_shape(ax: Axes, x: float, height: float, converging: bool = True) -> None:
    """Draw the outline of a thin lens of a height at a place on the axis.

    Parameters
    ----------
    ax : Axes
        Where.
    x, height : float
        Place on the optical axis, and the diameter of the lens.
    converging : bool
        Thicker in the middle; thinner if not.
    """
    y = np.linspace(-height / 2, height / 2, 60)
    bulge = min(0.09 * height, 0.16) * (1 - (2 * y / height) ** 2)
    side = bulge if converging else 0.2 - bulge
    outline = np.concatenate([np.stack([x + side, y], 1), np.stack([x - side, y], 1)[::-1]])
    ax.fill(*outline.T, facecolor=ROLES["camera"], alpha=0.35, lw=0, zorder=3)
    ax.plot(*np.vstack([outline, outline[:1]]).T, color=ROLES["camera"], lw=1.5, zorder=3)


@figure("Three rays from the tip of a tree through a lens meet in the tip of its image.")
def image_construction(f: float = 2.0, Z: float = 5.0, height: float = 1.5) -> Figure:
    """Show the three rays that are easy to draw, and the triangles of the thin lens equation.

    Parameters
    ----------
    f, Z, height : float
        Focal length, distance and height of the object, one unit of length; Z above f.

    Returns
    -------
    Figure
        Side view, to scale.
    """
    s = float(image_distance(f, Z))
    low = -height * float(magnification(f, Z))
    fig, ax = panels(1, 1, (FULL_WIDTH, 4.2))
    sketch(ax)
    stroke(ax, [(-Z - 0.7, 0), (s + 1.2, 0)], "guide", lw=1, ls=(0, (8, 4)))
    ax.fill([0, f, 0], [0, 0, height], color=ORANGE, alpha=0.3, lw=0)
    ax.fill([s, f, s], [0, 0, low], color=ORANGE, alpha=0.3, lw=0)
    for at_lens in (height, 0.0, low):
        stroke(ax, [(-Z, height), (0, at_lens), (s, low)], "ray", lw=1.8)
    lens_shape(ax, 0, 2.2 * max(height, -low) + 0.6)
    tree(ax, (-Z, 0), height)
    tree(ax, (s, 0), low, "image")
    for x, name in ((-f, "$F$"), (f, "$F'$")):
        ax.plot(x, 0, "o", color=BLACK, ms=6, zorder=5)
        write(ax, (x + 0.08, 0.22), name, ha="left")
    _number_rays(ax, [(-Z / 2, height), (-Z / 3, height / 3), (s / 2, low)])
    for place in ((-Z - 0.55, height / 2), (-0.36, 0.6 * height)):
        write(ax, place, "$h$", "object", fontsize=13)
    write(ax, (s + 0.5, low / 2), "$h'$", "image", fontsize=13)
    below, above = min(low, -1.1 * height) - 0.75, height + 0.55
    _dimensions(ax, below, [(-Z, 0, "$Z$"), (0, s, "$s$")])
    _dimensions(ax, above, [(0, f, "$f$"), (f, s, "$s - f$")])
    fit(ax, -Z - 1.0, s + 1.4, below - 0.3, height + 0.9)
    return fig


def _dimensions(ax: Axes, y: float, ways: list[tuple[float, float, str]]) -> None:
    """Draw dimension lines at a height, each from one place on the axis to another."""
    for start, end, name in ways:
        dimension(ax, (start, y), (end, y), name)


def _number_rays(ax: Axes, places: list[tuple[float, float]]) -> None:
    """Write the numbers of the rays, from 1 on, at these places."""
    paper = {"facecolor": "white", "edgecolor": ROLES["ray"], "boxstyle": "circle,pad=0.25"}
    for number, place in enumerate(places, start=1):
        write(ax, place, f"{number}", fontsize=9, bbox=paper, zorder=6)


@figure("Image distance behind a lens of {f:g} mm, against the distance of the object.")
def image_against_object(
    f: float = 85.0, Z: ArrayLike | None = None, yours: ArrayLike | None = None
) -> Figure:
    """Show where the sharp image lies for objects at all distances.

    Parameters
    ----------
    f : float
        Focal length, mm.
    Z : array_like, shape (N,), optional
        Distances of objects, mm.
    yours : array_like, shape (N,), optional
        The image distances that a student's function gave for them, mm.

    Returns
    -------
    Figure
        Image distance against object distance, on logarithmic axes.
    """
    distances = np.geomspace(1.04 * f, 300 * f, 300)
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.8))
    ax.loglog(distances, image_distance(f, distances), color=ROLES["camera"])
    ax.axhline(f, color=ROLES["guide"], ls=(0, (6, 4)), lw=1.2)
    ax.axvline(f, color=ROLES["guide"], ls=(0, (6, 4)), lw=1.2)
    ax.plot(2 * f, 2 * f, "o", color=BLACK, ms=8)
    write(ax, (2.4 * f, 2.0 * f), "$Z = s = 2f$: as large as the object", ha="left")
    write(ax, (120 * f, 0.84 * f), "far away: $s$ is nearly $f$", "guide")
    write(ax, (1.2 * f, 20 * f), "at $Z = f$: no image", "guide", ha="left")
    places = np.asarray([] if Z is None else Z, dtype=float)
    ax.set(xlabel="distance of the object Z (mm)", ylabel="distance of the image s (mm)")
    ax.set(ylim=(0.7 * f, 30 * f), xlim=(0.9 * f, 320 * f))
    plain_numbers(ax)
    drawn = same_shape(yours, places)
    if drawn is not None and places.size:
        stars(ax, places, drawn, numbers(drawn, "mm"), "your function")
        ax.legend(loc="upper right")
    return fig


@figure("An object of {width:g} mm, and its image of {sensor_width:g} mm with {pixels} pixels.")
def pixel_on_object(width: float = 80.0, sensor_width: float = 4.0, pixels: int = 100) -> Figure:
    """Show an object and its image on a sensor, both to scale, and what single pixels see of it.

    Parameters
    ----------
    width, sensor_width : float
        Of the object and of the sensor that it fills, mm.
    pixels : int
        Along the width of the sensor.

    Returns
    -------
    Figure
        Object, a corner of it under a magnifying glass, and the sensor in true proportion.
    """
    m, pitch = sensor_width / width, sensor_width / pixels
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.0))
    sketch(ax)
    field = float(sampled(pitch, m))
    sensor, glass = 2.8 * width, 1.35 * width
    _square(ax, 0, width, "object")
    _square(ax, sensor, sensor_width, "image")
    _fields(ax, width, glass, field)
    middle = sensor + sensor_width / 2
    write(ax, (width / 2, width / 2), f"object\n{width:g} mm")
    write(ax, (glass + width / 2, -0.12 * width), f"a pixel sees {field:g} mm", "image")
    write(ax, (middle, 0.24 * width), f"sensor\n{sensor_width:g} mm", "image")
    write(ax, (middle, -0.12 * width), f"{pixels} pixels of {pitch:g} mm", "image")
    write(ax, (width / 2, -0.12 * width), f"m = 1/{1 / m:g}")
    fit(ax, -0.1 * width, 3.3 * width, -0.22 * width, 1.06 * width)
    return fig


def _fields(ax: Axes, width: float, left: float, field: float, shown: int = 5) -> None:
    """Draw what some pixels see, as a corner of the object and enlarged to its width."""
    _square(ax, width - shown * field, shown * field, "object", lw=1)
    for low, high in ((0, 0), (shown * field, width)):
        stroke(ax, [(width, low), (left, high)], "guide", lw=1, ls=":")
    _square(ax, left, width, "object")
    for edge in np.arange(1, shown) * width / shown:
        stroke(ax, [(left + edge, 0), (left + edge, width)], "object", lw=1)
        stroke(ax, [(left, edge), (left + width, edge)], "object", lw=1)
    _square(ax, left, width / shown, "image", alpha=1)


def _square(
    ax: Axes, left: float, side: float, role: str, lw: float = 2, alpha: float = 0.15
) -> None:
    """Draw a square that stands on the axis."""
    corners = np.array([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)]) * side + (left, 0)
    ax.fill(*corners.T, color=ROLES[role], alpha=alpha, lw=0)
    stroke(ax, corners, role, lw=lw)
