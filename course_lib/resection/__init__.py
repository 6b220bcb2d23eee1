"""Resection: where a camera stood and how it is made, from points whose place is known.

The camera's DLT is the homography's bigger brother: twelve numbers up to scale, two equations for
each point. The points must not lie in one plane.
"""

from __future__ import annotations

from course_lib.camera.projection import decompose_projection
from course_lib.resection.correction import correction_from_table, correction_table
from course_lib.resection.dlt import CameraFit, camera_dlt, dlt_parameters, fit_camera
from course_lib.resection.learned_correction import (
    HeldOut,
    correction_from_polynomial,
    hold_out,
    polynomial_correction,
)

__all__ = [
    "CameraFit",
    "HeldOut",
    "camera_dlt",
    "correction_from_polynomial",
    "correction_from_table",
    "correction_table",
    "decompose_projection",
    "dlt_parameters",
    "fit_camera",
    "hold_out",
    "polynomial_correction",
]
