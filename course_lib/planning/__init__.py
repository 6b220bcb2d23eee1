"""Planning a measurement: what will be seen, how sharp and how fine, and how an area is flown.

Lengths are metres; f_mm, pitch_um and the like say their unit.
"""

from course_lib.planning.catalogue import CameraModel, LensModel, read_cameras, read_lenses
from course_lib.planning.depth import ApertureWindow, aperture_window
from course_lib.planning.flight import (
    base_for_overlap,
    ground_sample_distance,
    height_for_resolution,
    max_speed,
    overlap,
    photo_count,
)
from course_lib.planning.setup import judge_setup
from course_lib.planning.strips import FlightPlan, plan_flight, views_of_ground
from course_lib.planning.task import Setup, Task, Verdict
from course_lib.planning.view import Box, BoxInView, box_in_view, depth_range, object_resolution

__all__ = [
    "ApertureWindow",
    "Box",
    "BoxInView",
    "CameraModel",
    "FlightPlan",
    "LensModel",
    "Setup",
    "Task",
    "Verdict",
    "aperture_window",
    "base_for_overlap",
    "box_in_view",
    "depth_range",
    "ground_sample_distance",
    "height_for_resolution",
    "judge_setup",
    "max_speed",
    "object_resolution",
    "overlap",
    "photo_count",
    "plan_flight",
    "read_cameras",
    "read_lenses",
    "views_of_ground",
]
