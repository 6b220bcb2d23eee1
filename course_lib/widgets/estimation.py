"""The explorers of chapter 06."""

from __future__ import annotations

from course_lib.drawing.explorers.dlt_noise import dlt_noise_frame
from course_lib.drawing.explorers.homography import NAMES, SIZE, START, homography_frame
from course_lib.drawing.explorers.least_squares import (
    INTERCEPTS,
    SLOPES,
    least_squares_frame,
)
from course_lib.widgets.controls import Slider, Switch
from course_lib.widgets.explorer import Explorer


def least_squares_explorer() -> Explorer:
    """Return the explorer of a line that is fitted by hand."""
    return Explorer(
        "Least squares by hand",
        [
            Slider("m", "Slope", "m", "/kN", *SLOPES, 30, step=0.1, digits=1),
            Slider("c", "Height at load zero", "c", "", *INTERCEPTS, 100, step=1),
            Switch("slipped", "One gauge slipped"),
            Switch("best", "Show the line of least squares"),
        ],
        least_squares_frame,
    )


def homography_explorer() -> Explorer:
    """Return the explorer of a homography from four corners."""
    sliders = []
    for k, (name, (u, v)) in enumerate(zip(NAMES, START.tolist(), strict=True), 1):
        label, foot = name.capitalize(), "₁₂₃₄"[k - 1]
        sliders += [
            Slider(f"u{k}", label, f"u{foot}", "px", 0, SIZE[0] - 1, u),
            Slider(f"v{k}", label, f"v{foot}", "px", 0, SIZE[1] - 1, v),
        ]
    return Explorer("A homography from four corners", sliders, homography_frame)


def dlt_noise_explorer() -> Explorer:
    """Return the explorer of the camera's DLT from points with errors."""
    return Explorer(
        "The camera's DLT under noise",
        [
            Slider("n", "Number of points", "N", "", 6, 48, 12),
            Slider("sigma", "Error of a point", "σ", "px", 0, 2, 0.5, step=0.1, digits=1),
            Slider("h", "Tallest pin", "h", "mm", 0, 200, 120, step=5),
            Slider("draw", "Chance", "", "", 1, 20, 1),
        ],
        dlt_noise_frame,
    )
