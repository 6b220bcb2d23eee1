"""The still figures of chapter 09, one function each, and what they are drawn from."""

from __future__ import annotations

from course_lib.drawing.triangulation.dense import (
    dense_disparity,
    dense_errors,
    dense_result,
    point_cloud,
)
from course_lib.drawing.triangulation.disparity import disparity_and_depth
from course_lib.drawing.triangulation.methods import methods_compared, more_cameras
from course_lib.drawing.triangulation.pair import marked_pair, motorcycle
from course_lib.drawing.triangulation.plane import laser_line, laser_profile, structured_light
from course_lib.drawing.triangulation.rays import two_rays
from course_lib.drawing.triangulation.uncertainty import cloud, depth_curves

__all__ = [
    "cloud",
    "dense_disparity",
    "dense_errors",
    "dense_result",
    "depth_curves",
    "disparity_and_depth",
    "laser_line",
    "laser_profile",
    "marked_pair",
    "methods_compared",
    "more_cameras",
    "motorcycle",
    "point_cloud",
    "structured_light",
    "two_rays",
]
