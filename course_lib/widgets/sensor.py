"""The explorers of chapter 04."""

from __future__ import annotations

from course_lib.drawing.explorers.bayer import (
    FILTERS,
    GREEN,
    GREY,
    LABEL,
    STAR,
    STREET,
    bayer_frame,
)
from course_lib.drawing.explorers.exposure import exposure_frame
from course_lib.drawing.explorers.rolling_shutter import (
    GLOBAL,
    ROLLING,
    rolling_shutter_frame,
)
from course_lib.drawing.explorers.structured_light import MANY, ONE, structured_light_frame
from course_lib.widgets.controls import Choice, Slider, Switch
from course_lib.widgets.explorer import Explorer
from data_generators.relief import SHAPES

F_NUMBERS = (1.4, 2, 2.8, 4, 5.6, 8, 11, 16, 22)
SPEEDS = (100, 200, 400, 800, 1600, 3200, 6400)
LIGHTS = (200, 500, 1000, 2000, 5000, 10_000, 20_000, 50_000)


def exposure_explorer() -> Explorer:
    """Return the explorer of exposure: time, aperture, ISO, light and motion."""
    times = (0.125, 0.25, 0.5, 1, 2, 5, 10, 20)
    return Explorer(
        "Exposure: time, aperture, ISO, light and motion",
        [
            Slider(
                "t", "Exposure time", "t", "ms", 0.1, 50, 10, steps=40, landmarks=times, digits=3
            ),
            Slider("N", "f-number", "N", "", 1.4, 22, 4, steps=2, landmarks=F_NUMBERS),
            Slider("iso", "ISO", "", "", 100, 6400, 100, steps=2, landmarks=SPEEDS),
            Slider("lux", "Light", "E", "lx", 200, 50e3, 500, steps=2, landmarks=LIGHTS),
            Slider("speed", "Speed of the belt", "V", "mm/s", 0, 1000, 800, step=20),
            Switch("brightened", "Brighten the numbers afterwards"),
        ],
        exposure_frame,
    )


def rolling_shutter_explorer() -> Explorer:
    """Return the explorer of the rolling shutter, on a propeller that turns."""
    return Explorer(
        "Rolling shutter",
        [
            Slider("turns", "Turns a second", "", "1/s", 0, 60, 20, step=1),
            Slider("readout_ms", "Read-out of all rows", "", "ms", 0, 30, 20, step=0.5, digits=1),
            Slider("exposure_ms", "Exposure of a row", "t", "ms", 0.1, 10, 0.5, steps=30),
            Slider("blades", "Blades", "", "", 2, 6, 3, step=1),
            Choice("shutter", "Shutter", (ROLLING, GLOBAL), ROLLING),
        ],
        rolling_shutter_frame,
    )


def bayer_explorer() -> Explorer:
    """Return the explorer of the colour mosaic and of what demosaicing makes of it."""
    return Explorer(
        "The Bayer mosaic",
        [
            Choice("subject", "Subject", (STAR, LABEL, STREET), LABEL),
            Choice("view", "Show the mosaic as", (FILTERS, GREY, GREEN), FILTERS),
            Slider("pixels", "Side of the part", "", "px", 8, 240, 30, step=2),
            Slider("across", "Across", "", "", 0, 1, 0.74, step=0.01, digits=2),
            Slider("down", "Down", "", "", 0, 1, 0.86, step=0.01, digits=2),
            Slider("softness", "Blur of the lens", "σ", "px", 0, 2, 0, step=0.25, digits=2),
        ],
        bayer_frame,
    )


def structured_light_explorer() -> Explorer:
    """Return the explorer of structured light: the shift of a stripe and the height."""
    return Explorer(
        "Structured light: height from the shift of a stripe",
        [
            Choice("shape", "Thing on the table", tuple(SHAPES), "dome"),
            Slider("height", "Its height", "", "mm", 0, 8, 5, step=0.5, digits=1),
            Slider("angle_deg", "Light from the vertical", "θ", "°", 5, 70, 40, step=1),
            Choice("pattern", "Pattern", (ONE, MANY), MANY),
            Slider("place", "Place of the stripe", "", "mm", -15, 15, 5, step=0.5, digits=1),
        ],
        structured_light_frame,
    )
