"""The still figures of chapter 06, one function each, and what they are drawn from."""

from __future__ import annotations

from course_lib.drawing.estimation.readings import (
    BLOCKS,
    PIXELS,
    bar_in_tension,
    circle_to_ellipse,
    one_unknown,
    shadows,
    slipped_gauge,
    strain_line,
)
from course_lib.drawing.estimation.resection import (
    SHEET,
    calibration_object,
    correction,
    held_out,
)
from course_lib.drawing.estimation.table import (
    GOALS,
    found,
    misses,
    residual_field,
    too_high,
    two_views,
)
from course_lib.drawing.estimation.wall import (
    building,
    outer_four,
    rendered_building,
    straightened,
    through,
)
from course_lib.drawing.explorers.least_squares import LOADS, readings

__all__ = [
    "BLOCKS",
    "GOALS",
    "LOADS",
    "PIXELS",
    "SHEET",
    "bar_in_tension",
    "building",
    "calibration_object",
    "circle_to_ellipse",
    "correction",
    "found",
    "held_out",
    "misses",
    "one_unknown",
    "outer_four",
    "readings",
    "rendered_building",
    "residual_field",
    "shadows",
    "slipped_gauge",
    "straightened",
    "strain_line",
    "through",
    "too_high",
    "two_views",
]
