"""The exposure explorer: a moving belt, its histogram, and what each knob costs."""

from __future__ import annotations

from functools import cache, lru_cache

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot
from course_lib.optics import circle_of_confusion, magnification
from course_lib.sensor import (
    SensorModel,
    clipped_fraction,
    expose_with_field,
    exposure_value,
    luminance,
    motion_blur_pixels,
    photons_per_pixel,
    signal_to_noise,
    srgb_encode,
)

Light = NDArray[np.float32]

#: The lens and its distance from the belt; the carton with the label is nearer. All mm.
F, DISTANCE, CARTON = 25.0, 500.0, 45.0
#: The camera at ISO 100.
SENSOR = SensorModel(full_well=20_000, read_noise=6, gain=0.205, offset=64, bits=12)
PAPER = 0.85  # reflectance of the label
WHITE_ON_SCREEN = 0.8  # what brightening makes of the label
SIDE_SIZE = (260, 320)
PLOT = Plot((30.0, 246.0, 30.0, 272.0), (0.0, 4095.0), (0.0, 1.0))
BINS = 63


def exposure_frame(
    t: float, N: float, iso: float, lux: float, speed: float, brightened: bool
) -> Frame:
    """Return a photograph of parts on a moving belt, its histogram, and its qualities.

    Parameters
    ----------
    t : float
        Exposure time, ms.
    N, iso : float
        F-number and ISO speed.
    lux : float
        Light on the belt, lx.
    speed : float
        Of the belt, mm/s.
    brightened : bool
        Whether the numbers are multiplied afterwards until the label is white.

    Returns
    -------
    Frame
        The photograph, the histogram of its numbers, and what they are worth.
    """
    from data_generators.belt import PIXEL, SIZE, smeared

    sensor, seconds = SENSOR.amplified(iso / 100), t / 1000
    white = white_photons(N, seconds, lux)
    blur = float(motion_blur_pixels(speed, seconds, PIXEL))
    photons = white * smeared(_through_lens(N), blur)
    numbers = expose_with_field(photons, sensor, _noise(), seconds)
    snr = float(signal_to_noise(PAPER * white, sensor, seconds))
    clipped = float(clipped_fraction(numbers, 0, sensor.white)[1])
    level = _level(PAPER * white, sensor)
    factor = max(WHITE_ON_SCREEN / level, 1) if brightened else 1
    words = (
        f"Parts on a belt, smeared over {blur:.1f} px; the label is {min(level, 1):.0%} of white "
        f"with a signal-to-noise ratio of {snr:.0f}; {clipped:.0%} of the pixels are clipped."
    )
    image = _on_screen(numbers, sensor, factor)
    photograph = Picture("On the screen", words, SIZE, image, pixels=True)
    readouts = (
        Readout("Exposure value", "EV", f"{float(exposure_value(N, seconds, iso)):.1f}"),
        Readout("Photons from the label", "", f"{PAPER * white:.0f}", "a pixel"),
        Readout("Signal to noise, label", "SNR", f"{snr:.0f}"),
        Readout("Blur by motion", "", f"{blur:.1f}", "px"),
        Readout("Blur by defocus, label", "", f"{defocus_pixels(N):.1f}", "px"),
        Readout("Clipped to white", "", f"{100 * clipped:.1f}", "%"),
    )
    return Frame((photograph, _histogram(numbers, clipped)), readouts)


def _level(photons: float, sensor: SensorModel) -> float:
    """Return the mean number of a surface as a share of white; above 1 where it is clipped."""
    electrons = photons * sensor.quantum_efficiency
    return electrons * sensor.gain / (sensor.white - sensor.offset)


def pitch_um() -> float:
    """Return the pixel pitch that makes a pixel see 0.2 mm of the belt, µm."""
    from data_generators.belt import PIXEL

    return 1000 * PIXEL * float(magnification(F, DISTANCE))


def white_photons(N: float, seconds: float, lux: float) -> float:
    """Return the photons that a perfectly white surface on the belt sends into a pixel."""
    m = float(magnification(F, DISTANCE))
    return float(photons_per_pixel(luminance(lux, 1.0), N, seconds, pitch_um(), magnification=m))


def defocus_pixels(N: float) -> float:
    """Return the blur of the label, which lies nearer to the lens than the belt, px."""
    return float(circle_of_confusion(DISTANCE - CARTON, DISTANCE, F, N)) / (pitch_um() / 1000)


@lru_cache(maxsize=16)
def _through_lens(N: float) -> Light:
    """Return the belt in grey, in focus, with the label on its carton out of focus."""
    import cv2

    from data_generators.belt import LABEL, PIXEL

    picture = _grey_belt()
    left, top, width, height = (round(length / PIXEL) for length in LABEL)
    share = np.zeros_like(picture)
    share[top : top + height, left : left + width] = 1
    disk = _disk(defocus_pixels(N))
    label, share = (cv2.filter2D(part, -1, disk) for part in (picture * share, share))
    # What the carton hides is belt.
    bare = picture.copy()
    bare[top : top + height, left : left + width] = np.median(picture)
    return np.asarray(label + (1 - share) * bare, np.float32)


@cache
def _grey_belt() -> Light:
    from data_generators.belt import belt

    return np.asarray(belt().mean(axis=2), np.float32)


def _disk(diameter: float) -> Light:
    """Return the weights of a disk with soft edges."""
    reach = int(np.ceil(diameter / 2)) + 1
    v, u = np.mgrid[-reach : reach + 1, -reach : reach + 1]
    weights = np.clip(diameter / 2 + 0.5 - np.hypot(u, v), 0, 1)
    return np.asarray(weights / weights.sum(), np.float32)


@cache
def _noise() -> NDArray[np.float64]:
    """Return a standard normal number for each pixel, drawn once."""
    return np.random.default_rng(5).standard_normal(_grey_belt().shape)


def _on_screen(
    numbers: NDArray[np.unsignedinteger], sensor: SensorModel, factor: float
) -> NDArray[np.uint8]:
    """Return numbers as a screen shows them, multiplied by `factor`."""
    levels = (np.arange(sensor.white + 1) - sensor.offset) / (sensor.white - sensor.offset)
    table = np.rint(255 * srgb_encode(np.clip(levels * factor, 0, 1))).astype(np.uint8)
    return np.repeat(table[numbers][..., None], 3, axis=2)


def _histogram(numbers: NDArray[np.unsignedinteger], clipped: float) -> Picture:
    """Return how many pixels have which number; heights go with the root of the counts."""
    counts = np.bincount((numbers >> 6).ravel(), minlength=BINS + 1)[: BINS + 1]
    bars = np.repeat(np.sqrt(counts / counts.max()), 2)
    edges = np.repeat(64.0 * np.arange(BINS + 2), 2)[1:-1]
    outline = PLOT.pixels(np.r_[0, np.minimum(edges, 4095), 4095], np.r_[0, bars, 0])
    labels = [*PLOT.ticks((0, 1000, 2000, 3000, 4000), ())]
    labels += [
        Label("number in DN", (138.0, 302.0), anchor="middle"),
        Label("pixels (root scale)", (30.0, 16.0)),
    ]
    lines = [Line(outline, "camera", 1.0, closed=True, fill=0.5), PLOT.frame()]
    if clipped > 0.0005:
        wall = PLOT.pixels([4095, 4095], [0, min(max(4 * clipped, 0.05), 1)])
        lines.append(Line(wall, "object", 5.0))
        labels.append(Label("clipped", (246.0, 16.0), "object", "end"))
    peak = 64 * int(counts.argmax())
    return Picture(
        "What the camera wrote",
        f"Histogram of the numbers from 0 to 4095; most pixels are near {peak}, and "
        f"{clipped:.1%} are clipped.",
        SIDE_SIZE,
        lines=tuple(lines),
        labels=tuple(labels),
    )
