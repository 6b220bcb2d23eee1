"""The still figures of chapter 05, one function each."""

from __future__ import annotations

from course_lib.drawing.distortion.boards import bent_lines, doubled_corners
from course_lib.drawing.distortion.fields import displacement_fields
from course_lib.drawing.distortion.fisheye import fisheye_street
from course_lib.drawing.distortion.mapping import (
    before_and_after,
    forward_and_backward,
    iterations,
    moved_points,
)
from course_lib.drawing.distortion.models import barrel_and_pincushion, profiles, where_it_acts
from course_lib.drawing.distortion.real_fisheye import fisheye_photograph
from course_lib.drawing.distortion.straight_edges import rails, straightened_rails

__all__ = [
    "barrel_and_pincushion",
    "before_and_after",
    "bent_lines",
    "displacement_fields",
    "doubled_corners",
    "fisheye_photograph",
    "fisheye_street",
    "forward_and_backward",
    "iterations",
    "moved_points",
    "profiles",
    "rails",
    "straightened_rails",
    "where_it_acts",
]
