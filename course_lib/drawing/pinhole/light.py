"""Still figures: light, a hole, and how sharp and bright its picture is."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from course_lib.drawing.diagrams import (
    Floats,
    dimension,
    figure,
    fit,
    hole_in_wall,
    panels,
    plain_numbers,
    same_shape,
    sketch,
    stroke,
    write,
)
from course_lib.drawing.style import BLACK, BLUE, FULL_WIDTH, GREEN, GREY, ORANGE, RED, ROLES
from course_lib.optics import airy_diameter, best_pinhole_diameter, pinhole_blur_diameter

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Three lamps: height and colour. They stand at a distance of 4 from the wall with the hole.
LAMPS = ((1.2, RED), (0.0, GREEN), (-1.2, BLUE))
LAMP_X, SENSOR_X, SENSOR_REACH = -4.0, 4.0, 2.2


#: From hole to sensor in the lecture's box, mm.
LECTURE_DISTANCE = 100.0
#: The smallest and the largest hole that are drawn, mm.
HOLES = (0.05, 3.0)


@figure(
    "The Sun, its upper part covered by the Moon, shines through a small hole into a dark "
    "room; its image on the far wall is upside down, so its lower part is covered."
)
def eclipse(moon: float = 0.45) -> Figure:
    """Show how a solar eclipse is watched in a dark room, as Gemma Frisius did in 1544.

    Parameters
    ----------
    moon : float
        Height of the Moon's centre above the Sun's, in diameters of the Sun.

    Returns
    -------
    Figure
        Sun, hole and image from the side; the two discs are shown face-on.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.0))
    sketch(ax)
    sun, wall, radius, small = -6.0, 3.6, 1.25, 0.75
    for y in (radius, -radius):
        stroke(ax, [(sun, y), (0, 0), (wall, -y * small / radius)], "ray", lw=1.5)
    for x, r, side in ((sun, radius, 1), (wall, small, -1)):
        _crescent(ax, (x, 0.0), r, side * moon)
    hole_in_wall(ax, 0, 0.16, 1.7, 0.12)
    stroke(ax, [(0, 1.7), (wall + 1.0, 1.7), (wall + 1.0, -1.7), (0, -1.7)], color=BLACK, lw=3)
    write(ax, (sun, -1.65), "Sun, partly covered\nby the Moon", va="top")
    write(ax, (-0.2, 2.05), "hole in the wall", ha="right")
    write(ax, (wall, -1.0), "image,\nupside down", va="top")
    write(ax, (wall / 2 + 0.4, 2.05), "dark room")
    fit(ax, -7.6, 5.0, -2.75, 2.3)
    return fig


def _crescent(ax: Axes, centre: tuple[float, float], radius: float, moon: float) -> None:
    """Draw the Sun face-on with the Moon before it, `moon` diameters higher."""
    from matplotlib.patches import Circle

    x, y = centre
    sun = Circle((x, y), radius, color=ORANGE, lw=0, zorder=3)
    shade = Circle((x, y + 2 * radius * moon), radius, color=GREY, lw=0, zorder=4)
    for disc in (sun, shade):
        ax.add_patch(disc)
    shade.set_clip_path(sun)


@figure(
    "Three lamps shine on a sensor. Without a hole every pixel gets light from all of them; "
    "behind a hole of d = {d:g} each lamp makes a spot twice as wide as the hole, in reversed "
    "order."
)
def bare_sensor_and_hole(d: float = 0.3) -> Figure:
    """Show which light reaches a bare sensor, and which a sensor behind a hole.

    Parameters
    ----------
    d : float
        Diameter of the hole; the lamps are 1.2 apart.

    Returns
    -------
    Figure
        Two side views. The strip right of each sensor is the picture that it takes: the light of
        the three lamps on each of its pixels, added up.
    """
    fig, axes = panels(1, 2, (FULL_WIDTH, 2.9))
    titles = ("No hole", f"A hole of d = {d:g}")
    for ax, hole, title in zip(axes, (None, d), titles, strict=True):
        sketch(ax, title)
        for height, colour in LAMPS:
            for y in _where_rays_end(height, hole):
                ax.plot([LAMP_X, SENSOR_X], [height, y], color=colour, lw=1, alpha=0.55)
            ax.plot(LAMP_X, height, "o", color=colour, ms=9)
        if hole is not None:
            hole_in_wall(ax, 0, hole, SENSOR_REACH + 0.2, 0.14)
        picture = _strip(hole)
        edges = (SENSOR_X, SENSOR_X + 0.8, -SENSOR_REACH, SENSOR_REACH)
        ax.imshow(picture[:, None], extent=edges, origin="lower", aspect="equal", zorder=3)
        write(ax, (LAMP_X, -SENSOR_REACH - 0.35), "lamps", va="top")
        write(ax, (SENSOR_X + 0.4, -SENSOR_REACH - 0.35), "sensor", va="top")
        fit(ax, -5.0, 5.6, -3.1, 2.5)
    return fig


def _where_rays_end(height: float, d: float | None) -> Floats:
    """Return where rays of a lamp meet the sensor: everywhere, or through the hole."""
    if d is None:
        return np.linspace(-SENSOR_REACH, SENSOR_REACH, 7)
    return -height + np.linspace(-d, d, 3)


def _strip(d: float | None, pixels: int = 88) -> Floats:
    """Return the picture (pixels, 3) of the lamps; light falls off as cos θ / r²."""
    from matplotlib.colors import to_rgb

    y = SENSOR_REACH * (np.arange(pixels) + 0.5) / pixels * 2 - SENSOR_REACH
    depth, picture, bare = SENSOR_X - LAMP_X, np.zeros((pixels, 3)), np.zeros((pixels, 3))
    for height, colour in LAMPS:
        through = np.ones_like(y) if d is None else np.abs(y + height) / 2 <= d / 2
        light = (depth**2 + (y - height) ** 2)[:, None] ** -1.5 * to_rgb(colour)
        picture += through[:, None] * light
        bare += light
    return np.asarray(picture / bare.max())  # one exposure for every hole, and for none


@figure(
    "From the side: the light of a point passes a hole of diameter d at the distance Z and "
    "spreads to a spot, wider than the hole, on a sensor at the distance s behind it."
)
def blur_geometry(d: float = 1.0, image_distance: float = 3.0, Z: float = 6.0) -> Figure:
    """Show the spot that one point of light makes through a hole of diameter `d`.

    Parameters
    ----------
    d, image_distance, Z : float
        Diameter of the hole, distance from hole to sensor and from point to hole, one unit.

    Returns
    -------
    Figure
        Side view with the two similar triangles.
    """
    spot = float(pinhole_blur_diameter(d, image_distance, Z))
    fig, ax = panels(1, 1, (FULL_WIDTH, 2.9))
    sketch(ax)
    ax.fill([-Z, image_distance, image_distance], [0, spot / 2, -spot / 2], color=ORANGE, alpha=0.2)
    for side in (-1, 1):
        stroke(ax, [(-Z, 0), (image_distance, side * spot / 2)], "ray")
    hole_in_wall(ax, 0, d, 1.3 * spot, 0.1)
    stroke(ax, [(image_distance, -spot), (image_distance, spot)], "guide", lw=3)
    stroke(ax, [(image_distance, -spot / 2), (image_distance, spot / 2)], "ray", lw=6)
    ax.plot(-Z, 0, "o", color=ROLES["object"], ms=9)
    below = -1.65 * spot
    dimension(ax, (-Z, below), (0, below), "$Z$")
    dimension(ax, (0, below), (image_distance, below), "$s$")
    write(ax, (-0.15, 0), "$d$", ha="right")
    write(ax, (image_distance + 0.2, 0), "spot", ha="left")
    write(ax, (-Z, 0.35), "point", "object", va="bottom")
    write(ax, (image_distance, 1.15 * spot), "sensor")
    fit(ax, -Z - 0.6, image_distance + 1.2, 1.35 * below, 1.5 * spot)
    return fig


@figure(
    "Spot diameter against hole diameter, logarithmic, for s = {image_distance:g} mm: the "
    "shadow of the hole rises, diffraction falls, and their sum has one lowest point."
)
def blur_against_hole(
    image_distance: float = 100.0, wavelength: float = 0.00055, yours: Any = None
) -> Figure:
    """Show how large the spot of a far point is for holes of all sizes.

    Parameters
    ----------
    image_distance, wavelength : float
        Distance from hole to sensor, and wavelength, mm.
    yours : float, optional
        A hole diameter to mark, mm: a student's best one.

    Returns
    -------
    Figure
        Geometric spot, Airy disk and their sum against the hole's diameter. The best hole is
        marked for the lecture's box only: to find it for other boxes is the exercise.
    """
    d = np.geomspace(*HOLES, 200)
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.8))
    airy = airy_diameter(wavelength, image_distance / d)
    ax.loglog(d, d, "--", color=ROLES["ray"], label="geometry: $d$")
    ax.loglog(d, airy, ":", color=ROLES["image"], label=r"diffraction: $2.44\,\lambda s/d$")
    ax.loglog(d, d + airy, color=BLACK, lw=2.5, label="sum")
    if image_distance == LECTURE_DISTANCE:
        best = float(best_pinhole_diameter(image_distance, wavelength))
        _mark_hole(ax, (best, 2 * best), f"smallest spot: d = {best:.2f} mm", 0.07, BLACK)
    marked = same_shape(yours, np.zeros(()))
    if marked is not None and np.isfinite(marked) and marked > 0:
        spot = float(marked + airy_diameter(wavelength, image_distance / marked))
        _mark_answer(ax, float(marked), spot)
    ax.set(xlabel="hole diameter d (mm)", ylabel="spot diameter (mm)")
    ax.set(xlim=(0.04, 4), ylim=(0.04, 30))
    plain_numbers(ax)
    ax.legend(loc="upper center", ncols=2)
    return fig


def _mark_hole(
    ax: Axes, at: tuple[float, float], text: str, height: float, colour: str = BLACK
) -> None:
    """Mark a hole and its spot on the curve, with a line to `text` at a height in mm."""
    ax.plot(*at, "o", color=colour, ms=8)
    line = {"arrowstyle": "-", "color": colour}
    paper = {"facecolor": "white", "edgecolor": "none", "pad": 1.5}
    ax.annotate(text, at, (at[0], height), arrowprops=line, bbox=paper, ha="center")


def _mark_answer(ax: Axes, d: float, spot: float) -> None:
    """Mark a student's hole, or say that it lies outside of the figure."""
    if HOLES[0] <= d <= HOLES[1]:
        _mark_hole(ax, (d, spot), f"your answer: d = {d:.2f} mm", 5.5, ROLES["second"])
    else:
        text = f"your answer, d = {d:.3g} mm, lies outside of this figure"
        write(ax, (0.4, 5.5), text)
