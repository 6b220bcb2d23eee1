"""Planes of light: a laser line on a thing, which a student's ray and plane measure; many."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera, camera_at
from course_lib.drawing.diagrams import (
    Floats,
    figure,
    fit,
    panels,
    same_shape,
    sketch,
    stroke,
    write,
)
from course_lib.drawing.style import FULL_WIDTH, LIGHT, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

K = np.array([[1200.0, 0, 319.5], [0, 1200, 239.5], [0, 0, 1]])
SIZE = (640, 480)
EYE, TARGET = (0.0, -300.0, 400.0), (0.0, 0.0, 5.0)  # mm: the camera looks down at a table, z up
#: The laser's sheet of light stands upright and crosses the table along the x axis: y = 0.
PLANE = np.array([0.0, 1.0, 0.0, 0.0])
#: The thing: a rail from front to back, 60 mm wide at its foot, 12 mm high, with a groove.
HALF_FOOT, HALF_TOP, HEIGHT = 30.0, 18.0, 12.0
GROOVE, DEPTH = 5.0, 4.0
NOISE = 0.2  # px
#: Structured light from above: a projector and a camera before a wall with a box.
PROJECTOR, OBSERVER = np.array([-1.5, 0.0]), np.array([2.2, 0.0])
SURFACE = np.array([(-3.4, 6.0), (-1.0, 6), (-1.0, 4.4), (1.5, 4.4), (1.5, 6), (3.4, 6)])
PATTERNS, PICKED = 3, 5
PAPER = {"facecolor": "white", "edgecolor": "none", "pad": 1.5}


@dataclass(frozen=True, eq=False)
class LaserLine:
    """What a camera sees of a laser line.

    Attributes
    ----------
    camera : Camera
        Where it is; the world is in mm, z up.
    pixels : ndarray, shape (N, 2)
        The middle of the line in each of N columns or so, with noise, px.
    directions : ndarray, shape (N, 3)
        Directions of their rays.
    plane : ndarray, shape (4,)
        The laser's plane.
    """

    camera: Camera
    pixels: Floats
    directions: Floats
    plane: Floats


def profile(x: Floats) -> Floats:
    """Return the height of the thing at places across it, mm."""
    away = np.abs(x)
    slope = np.clip((HALF_FOOT - away) / (HALF_FOOT - HALF_TOP), 0, 1) * HEIGHT
    return np.asarray(np.where(away < GROOVE, HEIGHT - DEPTH, slope))


@cache
def laser_line() -> LaserLine:
    """Return the picture of a laser line across a rail, as pixels with noise.

    Returns
    -------
    LaserLine
        Camera, pixels, rays and the plane of the laser.
    """
    camera = camera_at(EYE, TARGET, K, SIZE)
    x = np.linspace(-60, 60, 241)
    exact = camera.project(np.column_stack([x, np.zeros_like(x), profile(x)]))
    pixels = exact + NOISE * np.random.default_rng(5).standard_normal(exact.shape)
    return LaserLine(camera, pixels, camera.pixel_ray(pixels), PLANE)


@figure("Camera, laser and rail from the side; the laser line as the camera sees it; the profile.")
def laser_profile(yours: Any = None) -> Figure:
    """Show the arrangement, the laser line in the picture, and the profile with a student's points.

    Parameters
    ----------
    yours : array_like, shape (N, 3), optional
        Where a student's rays meet the laser's plane, mm.

    Returns
    -------
    Figure
        The arrangement, the picture and the profile.
    """
    line = laser_line()
    fig, (plan, seen, cut) = panels(1, 3, (FULL_WIDTH, 3.0), width_ratios=(0.8, 1, 1.15))
    _arrangement(sketch(plan, "from the side"))
    _rail(seen, line.camera)
    seen.plot(*line.pixels.T, ".", color=ROLES["object"], ms=3)
    seen.set(xlim=(170, 470), ylim=(340, 140), aspect="equal", title="picture")
    seen.text(320, 325, "grey: edges of the rail", ha="center", fontsize=9, bbox=PAPER)
    seen.set(xlabel="u (px)", ylabel="v (px)")
    x = np.linspace(-60, 60, 1201)
    cut.fill_between(x, profile(x), -2, color=LIGHT, lw=0)
    cut.plot(x, profile(x), color=ROLES["guide"], lw=1.5)
    points = same_shape(yours, line.directions)
    if points is None:
        cut.text(0, 18, "no answer yet", ha="center")
    else:
        good: NDArray[np.bool_] = _drawable(points)
        cut.plot(*points[good][:, [0, 2]].T, ".", color=ROLES["object"], ms=4)
        text = "not all are here"
        if good.all():
            text = f"{1000 * np.sqrt(np.mean(_off(points) ** 2)):.0f} µm from the rail (RMS)"
        cut.text(0, 18, f"yours: {text}", ha="center")
    cut.set(xlim=(-62, 62), ylim=(-2, 22), title="profile", xlabel="x (mm)", ylabel="z (mm)")
    return fig


def _arrangement(ax: Axes) -> None:
    """Draw camera, laser and rail from the side, to scale, mm."""
    _, y, z = EYE
    stroke(ax, [(y, z), (0, HEIGHT)], "ray", lw=1.5)
    stroke(ax, [(0, 470), (0, HEIGHT)], "object", lw=2.5)
    ax.plot(y, z, "s", color=ROLES["camera"], ms=10)
    ax.plot(0, 470, "v", color=ROLES["object"], ms=11)
    ax.fill([-60, 60, 60, -60], [0, 0, HEIGHT, HEIGHT], color=ROLES["guide"], lw=0)
    stroke(ax, [(-360, 0), (110, 0)], "guide", lw=1.2)
    write(ax, (y + 10, z + 40), "camera", "camera", fontsize=10)
    write(ax, (-5, 515), "laser", "object", fontsize=10)
    write(ax, (0, -40), "rail", "guide", fontsize=10)
    write(ax, (-48, 120), "37°", fontsize=10)
    fit(ax, -390, 130, -70, 550)


def _drawable(points: Floats) -> NDArray[np.bool_]:
    finite = np.asarray(np.isfinite(points).all(axis=1))
    near = np.abs(np.where(finite[:, None], points, 0)).max(axis=1) < 65
    return np.asarray(finite & near)


def _off(points: Floats) -> Floats:
    """Return how far points are from the laser's line on the rail; in height, but for its steps."""
    x, y, z = points.T
    step = np.abs(np.abs(x) - GROOVE) < 0.5
    return np.asarray(np.hypot(np.where(step, 0, z - profile(x)), y))


def _rail(ax: Axes, camera: Camera) -> None:
    """Draw the edges of the rail as the camera sees them."""
    for x in (-HALF_FOOT, -HALF_TOP, -GROOVE, GROOVE, HALF_TOP, HALF_FOOT):
        z = 0.0 if abs(x) == HALF_FOOT else HEIGHT
        ax.plot(*camera.project([[x, -60, z], [x, 60, z]]).T, color=ROLES["guide"], lw=1)


def lit_by() -> NDArray[np.bool_]:
    """Return which planes each pattern lights, (patterns, planes): the digits of their numbers."""
    numbers = np.arange(2**PATTERNS)
    return np.asarray(numbers >> np.arange(PATTERNS)[::-1, None] & 1, dtype=bool)


def places_of_planes() -> Floats:
    """Return where the projector's planes first meet the surface, seen from above, shape (8, 2)."""
    aims = np.linspace(-3.2, 3.2, 2 ** (PATTERNS + 1) + 1)[1::2]
    directions = np.column_stack([aims, np.full_like(aims, 6.0)]) - PROJECTOR
    away, edges = SURFACE[:-1] - PROJECTOR, np.diff(SURFACE, axis=0)
    # PROJECTOR + λ d = corner + μ edge: crossed with the edge λ is left, crossed with d μ.
    across = _cross(directions[:, None], edges)
    reach, along = _cross(away, edges) / across, _cross(away, directions[:, None]) / across
    first = np.where((along >= 0) & (along <= 1) & (reach > 0), reach, np.inf).min(axis=1)
    return np.asarray(PROJECTOR + first[:, None] * directions)


def _cross(a: Floats, b: Floats) -> Floats:
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])


@figure(
    "Left, from above: a projector sends eight numbered planes of light to a wall with a box "
    "before it; a camera's ray ends where plane 5 meets the box. Right: three striped patterns; "
    "plane 5 is light, dark, light."
)
def structured_light() -> Figure:
    """Show how patterns number the planes of light, and which one a pixel sees.

    Returns
    -------
    Figure
        Projector, camera and planes from above, and the patterns.
    """
    fig, (plan, patterns) = panels(1, 2, (FULL_WIDTH, 3.4), width_ratios=(1.1, 1))
    _planes(sketch(plan, "from above"))
    _patterns(sketch(patterns, "what the projector shows"))
    return fig


def _planes(ax: Axes) -> None:
    stroke(ax, SURFACE, "guide", lw=3)
    for number, place in enumerate(places_of_planes()):
        picked = number == PICKED
        stroke(ax, [PROJECTOR, place], "object", lw=2.5 if picked else 0.8)
        beyond = 0.35 * (place - PROJECTOR) / np.linalg.norm(place - PROJECTOR)
        write(ax, place + beyond, f"{number}", "object", fontsize=10)
    stroke(ax, [OBSERVER, places_of_planes()[PICKED]], "ray", lw=1.8)
    ax.plot(*PROJECTOR, "v", color=ROLES["object"], ms=11)
    ax.plot(*OBSERVER, "s", color=ROLES["camera"], ms=10)
    write(ax, PROJECTOR - (0, 0.55), "projector", "object", fontsize=10)
    write(ax, OBSERVER - (0, 0.55), "camera", "camera", fontsize=10)
    fit(ax, -3.6, 3.6, -0.9, 6.7)


def _patterns(ax: Axes) -> None:
    for row, lights in enumerate(lit_by()):
        low = PATTERNS - 1 - row
        ax.pcolormesh(
            np.arange(len(lights) + 1),
            [low, low + 0.75],
            [lights],
            cmap="gray",
            vmin=-0.4,
            vmax=1,
            edgecolors=ROLES["guide"],
            lw=0.5,
        )
        write(ax, (-1.3, low + 0.37), f"pattern {row + 1}", fontsize=10)
        write(ax, (8.5, low + 0.37), f"{lights[PICKED]:d}", "object", fontsize=12)
    for number in range(2**PATTERNS):
        write(ax, (number + 0.5, -0.3), f"{number}", "object", fontsize=10)
    u, v = np.array([0, 1, 1, 0, 0]) + PICKED, np.array([-0.55, -0.55, 2.85, 2.85, -0.55])
    stroke(ax, np.column_stack([u, v]), "object", lw=2.5)
    write(ax, (4, -0.85), "number of the plane", fontsize=10)
    ax.set_aspect("auto")
    fit(ax, -2.5, 9, -1.1, 3.0)
