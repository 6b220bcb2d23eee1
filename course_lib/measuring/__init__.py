"""Measuring in pictures of a calibrated camera: lengths with what they are uncertain by.

A target in the picture (a printed board) says where the camera stood. Lengths are in the unit of
the target, its plane is z = 0 of its frame: x along its rows, y down its columns, z away from the
viewer. Pixels are those of the real picture, with distortion.
"""

from course_lib.measuring.measured import Measured, pointing_sigma
from course_lib.measuring.moved import cameras_apart, target_shift
from course_lib.measuring.plane import distance_on_plane, point_on_plane
from course_lib.measuring.space import distance_in_space, point_in_space, rays_miss
from course_lib.measuring.target import target_offsets
from course_lib.measuring.view import View, view_of_target, views_of_pair

__all__ = [
    "Measured",
    "View",
    "cameras_apart",
    "distance_in_space",
    "distance_on_plane",
    "point_in_space",
    "point_on_plane",
    "pointing_sigma",
    "rays_miss",
    "target_offsets",
    "target_shift",
    "view_of_target",
    "views_of_pair",
]
