"""The explorers of chapter 01."""

from __future__ import annotations

from course_lib.drawing.explorers.aperture import ADJUSTED, FIXED, aperture_frame
from course_lib.drawing.explorers.dolly import FIRST_F, FIRST_Z, dolly_zoom_frame
from course_lib.drawing.explorers.focal import focal_length_frame
from course_lib.drawing.sensors import FULL_FRAME, SENSORS
from course_lib.widgets.controls import Choice, Slider, Switch
from course_lib.widgets.explorer import Explorer


def aperture_explorer() -> Explorer:
    """Return the explorer of the hole: its size, blur and light."""
    series = (2, 1, 0.6, 0.35, 0.15, 0.07)
    return Explorer(
        "The hole of a pinhole camera",
        [
            Slider("d", "Hole diameter", "d", "mm", 0.05, 2.5, 1, steps=110, landmarks=series),
            Slider("s", "Image distance", "s", "mm", 60, 150, 100, step=5),
            Choice("exposure", "Exposure time", (ADJUSTED, FIXED), ADJUSTED),
        ],
        aperture_frame,
    )


def focal_length_explorer() -> Explorer:
    """Return the explorer of focal length, sensor and field of view."""
    landmarks = (12, 24, 28, 35, 50, 85, 105, 135, 200)
    return Explorer(
        "Focal length, sensor and field of view",
        [
            Slider("f", "Focal length", "f", "mm", 4, 300, 28, steps=160, landmarks=landmarks),
            Choice("sensor", "Sensor", tuple(SENSORS), FULL_FRAME),
        ],
        focal_length_frame,
    )


def dolly_zoom_explorer() -> Explorer:
    """Return the dolly zoom: distance and focal length, coupled or not."""
    return Explorer(
        "Dolly zoom",
        [
            Slider("Z", "Distance", "Z", "m", 2, 16, FIRST_Z, step=0.1, digits=1),
            Switch("coupled", "The focal length keeps the chart's size", True),
            Slider("f", "Focal length", "f", "mm", 14, 200, FIRST_F, step=0.5, digits=1),
        ],
        dolly_zoom_frame,
    )
