"""Lens distortion: what bends straight lines, and how to straighten them.

Distortion acts between the pinhole and the pixels, on normalised coordinates ``X/Z, Y/Z``; a camera
is ``K · distort(project(points))``. Coefficients are in OpenCV's order,
``k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4``.
"""

from __future__ import annotations

from course_lib.distortion.division_model import distort_division, undistort_division
from course_lib.distortion.fisheye import fisheye_project, fisheye_ray, fisheye_valid_angle
from course_lib.distortion.forms import (
    Bouguet,
    Photogrammetric,
    bouguet_from_opencv,
    opencv_from_bouguet,
    opencv_from_photogrammetric,
    photogrammetric_from_opencv,
)
from course_lib.distortion.inverse import undistort_points, valid_radius
from course_lib.distortion.model import (
    distort,
    distort_radial,
    distort_rational_prism,
    distortion_jacobian,
)
from course_lib.distortion.pictures import displacement_field, pixel_grid, undistortion_map
from course_lib.distortion.pixels import (
    distort_pixels,
    normalised_from_pixels,
    pixels_from_normalised,
    undistort_pixels,
)
from course_lib.distortion.plumb_line import PlumbLines, distortion_from_lines, straightness
from course_lib.distortion.series import distort_photogrammetric, ebner, radial_correction

__all__ = [
    "Bouguet",
    "Photogrammetric",
    "PlumbLines",
    "bouguet_from_opencv",
    "displacement_field",
    "distort",
    "distort_division",
    "distort_photogrammetric",
    "distort_pixels",
    "distort_radial",
    "distort_rational_prism",
    "distortion_from_lines",
    "distortion_jacobian",
    "ebner",
    "fisheye_project",
    "fisheye_ray",
    "fisheye_valid_angle",
    "normalised_from_pixels",
    "opencv_from_bouguet",
    "opencv_from_photogrammetric",
    "photogrammetric_from_opencv",
    "pixel_grid",
    "pixels_from_normalised",
    "radial_correction",
    "straightness",
    "undistort_division",
    "undistort_pixels",
    "undistort_points",
    "undistortion_map",
    "valid_radius",
]
