"""The aperture window: defocus at the ends of a depth range, diffraction, and the best f-number."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot, disc
from course_lib.optics import (
    airy_diameter,
    aperture_diameter,
    aperture_for_depth,
    circle_of_confusion,
    image_distance,
)

if TYPE_CHECKING:
    from data_generators.hole import Spread

Floats = NDArray[np.float64]

WAVELENGTH = 550e-6  # mm: green
STOPS = (1.4, 2, 2.8, 4, 5.6, 8, 11, 16, 22, 32)
APERTURES, BLURS = (1.4, 32.0), (0.3, 60.0)  # axes of the curves: f-number, px

AXES = Plot((46, 346, 26, 250), APERTURES, BLURS, log_x=True, log_y=True)
SIZE = (360, 300)  # px: of the curves
SIDE = 264  # px: width and height of the two other pictures
CELL = 22  # px of the drawing for a pixel of the sensor: 12 of them in the picture
CHART = 88  # px of the sensor for the letter chart, each drawn 3 px wide
FINE = 3  # subpixels of the chart, both ways
NOTES = (np.s_[4:44, 4:92], np.s_[-24:-4, -128:-4])  # light paper under the words
TOO_WIDE = (("the spot of defocus", 190), ("is wider than this picture", 208))  # and where, px
FINEST = 4.0  # periods a pixel: the finest detail of the point's image that is drawn


@dataclass(frozen=True)
class Blur:
    """The light of one point at an end of the range: mm on the sensor.

    Attributes
    ----------
    focus : float
        Distance that the lens is focused on, mm.
    defocus, airy : float
        Diameters of the circle of confusion and of the Airy disk.
    diameter, image_distance : float
        Of the opening, and from it to the sensor.
    """

    focus: float
    defocus: float
    airy: float
    diameter: float
    image_distance: float

    @property
    def total(self) -> float:
        """Both together, by the rule of thumb of chapter 01."""
        return self.defocus + self.airy


def blur_at_ends(N: float, f: float, near: float, depth: float) -> Blur:
    """Return the blur at both ends of a depth range when the lens is focused best between them.

    Parameters
    ----------
    N, f : float
        f-number, and focal length in mm.
    near, depth : float
        Distance of the nearest point from the lens, and from there to the farthest, m.

    Returns
    -------
    Blur
        It is the same at both ends.
    """
    ends = 1000 * near, 1000 * (near + depth)
    _, focus = aperture_for_depth(f, *ends, 0.01)  # the best focus does not depend on c
    behind, d = float(image_distance(f, focus)), float(aperture_diameter(f, N))
    defocus = float(circle_of_confusion(ends[0], focus, f, N))
    return Blur(float(focus), defocus, float(airy_diameter(WAVELENGTH, behind / d)), d, behind)


def best_aperture(f: float, near: float, depth: float) -> float:
    """Return the f-number with the smallest sum of both blurs; arguments as `blur_at_ends`."""
    one = blur_at_ends(1.0, f, near, depth)  # defocus is this over N, diffraction this times N
    return float(np.sqrt(one.defocus / one.airy))


def aperture_window_frame(N: float, f: float, near: float, depth: float, pitch: float) -> Frame:
    """Return the curves of both blurs against the f-number, one point, and a chart.

    Parameters
    ----------
    N, f : float
        f-number, and focal length in mm.
    near, depth : float
        Distance of the nearest point from the lens, and from there to the farthest, m.
    pitch : float
        Of the pixels, µm.

    Returns
    -------
    Frame
        The curves, the image of a point and a chart at an end of the range, and the numbers.
    """
    blur, mm = blur_at_ends(N, f, near, depth), pitch / 1000
    best = best_aperture(f, near, depth)
    least = blur_at_ends(best, f, near, depth).total / mm
    readouts = (
        Readout("Focus at", "", f"{blur.focus / 1000:.2f}", "m"),
        Readout("Defocus at the ends", "", f"{blur.defocus / mm:.2f}", "px"),
        Readout("Airy disk", "", f"{blur.airy / mm:.2f}", "px"),
        Readout("Both together", "", f"{blur.total / mm:.2f}", "px"),
        Readout("Best f-number", "", f"{best:.1f}"),
        Readout("Blur at the best", "", f"{least:.2f}", "px"),
    )
    pictures = (_curves(N, f, near, depth, mm), _point(blur, mm), _chart(blur, mm))
    return Frame(pictures, readouts)


def _curves(N: float, f: float, near: float, depth: float, mm: float) -> Picture:
    """Return both blurs and their sum against the f-number."""
    one, best = blur_at_ends(1.0, f, near, depth), best_aperture(f, near, depth)
    numbers = np.geomspace(*APERTURES, 80)
    defocus, airy = one.defocus / numbers / mm, one.airy * numbers / mm
    here = (one.defocus / N + one.airy * N) / mm
    lines = (
        AXES.frame(),
        Line(AXES.pixels(APERTURES, 1.0), "guide", 1.2, dashed=True),
        Line(AXES.pixels(best, BLURS), "guide", 1.2, dashed=True),
        Line(AXES.pixels(numbers, defocus), "ray", 2.0),
        Line(AXES.pixels(numbers, airy), "image", 2.0),
        Line(AXES.pixels(numbers, defocus + airy), "ink", 2.5),
        Line(AXES.pixels(N, BLURS), "object", 2.0),
        Line(disc(AXES.at(N, here), 5), "object", 2.0, closed=True, fill=1.0),
    )
    labels = (
        *AXES.ticks((1.4, 2.8, 5.6, 11, 22), (1, 10)),
        *AXES.names("f-number N", "blur in px"),
        Label("1 px", AXES.at(APERTURES[0], 1, 4, -9), "guide"),
        *_named(numbers, defocus, "defocus", "ray", "start"),
        *_named(numbers[::-1], airy[::-1], "diffraction", "image", "end"),
        *([Label("best", AXES.at(best, BLURS[1], 4, 8), "guide")] if _shown(best) else []),
    )
    words = f"The sum of both blurs is smallest at f/{best:.1f}; at f/{N:g} it is {here:.1f} px."
    return Picture("Blur against the f-number", words, SIZE, lines=lines, labels=labels)


def _shown(N: float) -> bool:
    """Return whether an f-number lies on the axis."""
    return APERTURES[0] <= N <= APERTURES[1]


def _named(x: Floats, y: Floats, text: str, role: str, anchor: str) -> tuple[Label, ...]:
    """Return the name of a curve beside the first of its points that lies in the picture."""
    low, high = 1.6 * BLURS[0], BLURS[1] / 1.6
    inside = np.flatnonzero((y > low) & (y < high))
    if not inside.size:
        return ()
    at = AXES.at(x[inside[0]], y[inside[0]], *((8, -10) if anchor == "start" else (2, 32)))
    return (Label(text, at, role, anchor),)


def _point(blur: Blur, mm: float) -> Picture:
    """Return the image of one point, as it is before the pixels, with the pixels drawn on it."""
    image = _spot(blur, mm)
    middle = np.array([SIDE / 2 - 0.5] * 2)
    radii = [CELL * size / mm / 2 for size in (blur.defocus, blur.airy)]
    circles = [
        Line(disc(middle, radius), role, 2.0, closed=True)
        for radius, role in zip(radii, ("ray", "image"), strict=True)
        if radius < 0.7 * SIDE
    ]
    wide = [Label(text, (SIDE / 2, v), "ink", "middle") for text, v in TOO_WIDE]
    return Picture(
        "A point at the ends",
        f"The light of one point: a circle of confusion of {blur.defocus / mm:.1f} px and an Airy "
        f"disk of {blur.airy / mm:.1f} px.",
        (SIDE, SIDE),
        image,
        lines=tuple(circles),
        labels=(
            Label("defocus", (10, 14), "ray"),
            Label("diffraction", (10, 32), "image"),
            Label("1 square = 1 pixel", (SIDE - 10, SIDE - 12), "ink", "end"),
            *(wide if radii[0] >= 0.7 * SIDE else ()),
        ),
    )


def _spot(blur: Blur, mm: float) -> NDArray[np.uint8]:
    """Return the light of one point as a screen shows it, with the pixels drawn on it."""
    r, rho, waves, place = _radial()
    profile = (waves * _passed(blur, mm, rho)) @ rho  # Hankel transform of the transfer
    light = np.clip(profile / profile.max(), 0, 1) ** (1 / 2.2)
    grey = np.interp(place, r, light)
    grey = np.maximum(grey, _pixel_grid() * (0.25 + 0.75 * grey))
    for paper in NOTES:  # words on the dark picture could not be read
        grey[paper] = 0.92
    return np.repeat(np.rint(255 * grey).astype(np.uint8)[..., None], 3, axis=2)


def _chart(blur: Blur, mm: float) -> Picture:
    """Return letters at an end of the range, on the pixels of the sensor."""
    from data_generators.hole import Hole

    hole = Hole(blur.diameter, blur.image_distance, WAVELENGTH)
    fine = _letters(mm).through(hole, disk=blur.defocus)
    # A pixel adds up the light on its area.
    pixels = fine.reshape(CHART, FINE, CHART, FINE, 3).mean(axis=(1, 3))
    large = np.rint(np.clip(pixels, 0, 255)).astype(np.uint8).repeat(3, axis=0).repeat(3, axis=1)
    return Picture(
        "Letters at the ends",
        f"An eye chart with letters of 18 px to 6 px, blurred over {blur.total / mm:.1f} px.",
        (SIDE, SIDE),
        np.ascontiguousarray(large),
    )


@lru_cache(maxsize=16)
def _letters(mm: float) -> Spread:
    """Return an eye chart on pixels of a pitch, mm, ready to be blurred; with a white margin."""
    from data_generators.hole import Spread
    from data_generators.targets import letter_chart

    margin = (360 - CHART * FINE) // 2  # 360 transforms fast
    chart = letter_chart(CHART * FINE, 5, rng=np.random.default_rng(5))
    sharp = np.pad(chart, margin, mode="edge")[..., None].repeat(3, axis=2)
    return Spread(sharp, (margin, margin), (mm / FINE, mm / FINE))


@cache
def _radial() -> tuple[Floats, Floats, Floats, Floats]:
    """Return radii, frequencies, the waves between them, and the radius of each drawn pixel.

    Radii are in pixels of the sensor, frequencies in periods a pixel; a row of the waves, times a
    round spot's transfer and frequency, adds up to its light at that radius.

    References
    ----------
    J. W. Goodman, Introduction to Fourier Optics, 3rd ed., section 2.1.5 (Fourier-Bessel).
    """
    from scipy.special import j0

    r, rho = np.linspace(0, 0.75 * SIDE / CELL, 260), np.linspace(0, FINEST, 800)
    across = (np.arange(SIDE) - SIDE / 2 + 0.5) / CELL
    return r, rho, j0(2 * np.pi * np.outer(r, rho)), np.hypot(across[:, None], across)


def _passed(blur: Blur, mm: float, rho: Floats) -> Floats:
    """Return the transfer of defocus and diffraction at frequencies a pixel, with a soft end."""
    from data_generators.hole import Hole, transfer

    hole = Hole(blur.diameter, blur.image_distance, WAVELENGTH)
    return transfer(rho / mm, hole, disk=blur.defocus) * np.exp(-((2 * rho / FINEST) ** 2))


@cache
def _pixel_grid() -> Floats:
    """Return where the edges of the sensor's pixels are drawn; the point falls on a middle."""
    grid, start = np.zeros((SIDE, SIDE)), (SIDE // 2 - CELL // 2) % CELL
    grid[start::CELL] = grid[:, start::CELL] = 1
    return grid
