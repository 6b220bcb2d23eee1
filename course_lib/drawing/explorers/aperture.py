"""The aperture explorer: a picture through a hole, and the two blurs that limit it."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot, disc
from course_lib.drawing.explorers.street import CHART, WIDTH, renderer, upright_camera
from course_lib.drawing.style import on_screen
from course_lib.optics import airy_diameter, best_pinhole_diameter, pinhole_blur_diameter

if TYPE_CHECKING:
    from data_generators.hole import Spread

EYE = (0.5, -3.5, 1.65)  # m
FILM = (96.0, 64.0)  # mm
PITCH = FILM[0] / WIDTH  # mm
DISTANCE = float(CHART[1]) - EYE[1]  # m: from the hole to the letter chart
WAVELENGTH = 550e-6  # mm: green
USUAL = 1.0  # mm: the hole for which the fixed exposure time is right, at 100 mm
ADJUSTED, FIXED = "adjusted to the hole", "the same for every hole"

SIDE_SIZE = (230, 320)  # px
SPOT_SCALE = 50.0  # px a mm
HOLES, BLURS = (0.05, 2.5), (0.05, 6.0)  # mm: axes of the curves
AXES = Plot((42, 222, 26, 272), HOLES, BLURS, log_x=True, log_y=True)


def aperture_frame(d: float, s: float, exposure: str) -> Frame:
    """Return the picture through a hole, its spot and its place on the curves of blur.

    Parameters
    ----------
    d : float
        Diameter of the hole, mm.
    s : float
        Image distance, mm.
    exposure : str
        `ADJUSTED` or `FIXED`: whether the exposure time makes up for the size of the hole.

    Returns
    -------
    Frame
        The photograph, the spot, the curves, and the numbers.
    """
    from data_generators.hole import Hole

    hole = Hole(d, s, WAVELENGTH)
    brightness = hole.light / Hole(USUAL).light
    linear = _spread(s).through(hole, 1.0 if exposure == ADJUSTED else on_screen(brightness))
    shadow, rings = _blurs(d, s)
    best = float(best_pinhole_diameter(s, WAVELENGTH))
    photograph = Picture(
        "Through the hole",
        f"The street through a hole of {d:g} mm: each point is a spot of about "
        f"{(shadow + rings) / PITCH:.1f} px.",
        (linear.shape[1], linear.shape[0]),
        np.rint(np.clip(linear, 0, 255)).astype(np.uint8),
        pixels=True,
    )
    readouts = (
        Readout("Shadow of the hole", "", f"{shadow:.2f}", "mm"),
        Readout("Diffraction (Airy disk)", "", f"{rings:.2f}", "mm"),
        Readout("Both together", "", f"{shadow + rings:.2f}", "mm"),
        Readout("The same in pixels", "", f"{(shadow + rings) / PITCH:.1f}", "px"),
        Readout("Light, against a 1 mm hole", "", f"{brightness:.3g}", "×"),
        Readout("Best hole", "", f"{best:.2f}", "mm"),
    )
    return Frame((photograph, _spot(shadow, rings), _curves(d, s, best)), readouts)


def _blurs(d: NDArray[np.float64] | float, s: float) -> tuple[Any, Any]:
    """Return the diameters of the geometric spot of the chart and of the Airy disk, mm."""
    shadow = pinhole_blur_diameter(d, s, 1000 * DISTANCE)
    return shadow, airy_diameter(WAVELENGTH, s / np.asarray(d))


@lru_cache(maxsize=12)
def _spread(s: float) -> Spread:
    """Return the sharp street at an image distance, ready to be blurred."""
    from data_generators.hole import Spread, with_margin

    wider, margin = with_margin(upright_camera(EYE, s, FILM))
    return Spread(renderer().picture(wider), margin, (PITCH, PITCH), DISTANCE)


def _spot(shadow: float, rings: float) -> Picture:
    """Return the image of one point, drawn to scale on the pixels of the picture."""
    w, h = SIDE_SIZE
    middle = np.array([w / 2, h / 2])
    bar = np.array([[14, h - 18], [14 + SPOT_SCALE, h - 18]])
    return Picture(
        "The image of one point",
        f"A disk of {shadow:.2f} mm, the shadow of the hole, and an Airy disk of {rings:.2f} mm, "
        f"on pixels of {PITCH:g} mm.",
        SIDE_SIZE,
        lines=(
            Line(_pixel_grid(middle), "guide", 0.4),
            Line(_circle(middle, shadow), "ray", 2.0, closed=True, fill=0.45),
            Line(_circle(middle, rings), "image", 2.0, closed=True, fill=0.2),
            Line(bar, "ink", 3.0),
        ),
        labels=(
            Label("1 mm", (14 + SPOT_SCALE / 2, h - 30), anchor="middle"),
            Label("shadow of the hole", (14, 16), "ray"),
            Label("diffraction", (14, 34), "image"),
            Label("1 square = 1 pixel", (w - 14, h - 18), "guide", "end"),
        ),
    )


def _pixel_grid(middle: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the edges of the picture's pixels, to the scale of the spot diagram."""
    (w, h), cell = SIDE_SIZE, PITCH * SPOT_SCALE
    up = [np.nan, np.nan]
    grid = [[[u, 0], [u, h], up] for u in np.arange(middle[0] % cell, w, cell)]
    grid += [[[0, v], [w, v], up] for v in np.arange(middle[1] % cell, h, cell)]
    return np.array(grid).reshape(-1, 2)


def _circle(middle: NDArray[np.float64], diameter: float) -> NDArray[np.float64]:
    """Return a circle on the spot diagram, its diameter in mm."""
    return disc(middle, diameter / 2 * SPOT_SCALE)


def _curves(d: float, s: float, best: float) -> Picture:
    """Return both blurs and their sum against the hole, on logarithmic axes."""
    holes = np.geomspace(*HOLES, 60)
    shadow, rings = _blurs(holes, s)
    here = AXES.pixels([d, d], [BLURS[0], sum(_blurs(d, s))])
    return Picture(
        "Blur against the hole",
        f"The sum of both blurs is smallest at a hole of {best:.2f} mm; this one is {d:g} mm.",
        SIDE_SIZE,
        lines=(
            AXES.frame(),
            Line(AXES.pixels([best, best], BLURS), "guide", 1.2, dashed=True),
            Line(AXES.pixels(holes, shadow), "ray", 2.0),
            Line(AXES.pixels(holes, rings), "image", 2.0),
            Line(AXES.pixels(holes, shadow + rings), "ink", 2.5),
            Line(here, "object", 2.0),
            Line(disc(here[1], 5), "object", 2.0, closed=True, fill=1.0),
        ),
        labels=(
            *AXES.ticks((0.1, 1), (0.1, 1)),
            *AXES.names("hole d in mm", "blur in mm"),
            Label("best", AXES.at(best, BLURS[1], 5, 22), "guide"),
            Label("shadow", AXES.at(2.3, 0.55), "ray", "end"),
            Label("diffraction", AXES.at(0.054, 0.28), "image"),
        ),
    )
