"""Cameras: from world points to pixels, and back to rays.

The camera frame has x right, y down, z forward, with the hole (the centre of projection) at the
origin; the world has z up. Pixel ``(0, 0)`` is the centre of the top-left pixel.
"""

from __future__ import annotations

from course_lib.camera.camera import Camera, camera_at
from course_lib.camera.pinhole import (
    dolly_zoom,
    first_guess_intrinsics,
    image_centre,
    pixel_focal_length,
    project_pinhole,
    vanishing_point,
)
from course_lib.camera.projection import camera_matrix, decompose_projection, pixel_ray, project
from course_lib.transforms import camera_centre

__all__ = [
    "Camera",
    "camera_at",
    "camera_centre",
    "camera_matrix",
    "decompose_projection",
    "dolly_zoom",
    "first_guess_intrinsics",
    "image_centre",
    "pixel_focal_length",
    "pixel_ray",
    "project",
    "project_pinhole",
    "vanishing_point",
]
