"""Orientation: where a camera, a pair or a model stands, from points that are known."""

from course_lib.orientation.control import (
    CheckErrors,
    check_point_rmse,
    leave_one_out,
    pictures_for_circle,
)
from course_lib.orientation.relative import (
    RelativeOrientation,
    pose_from_relative,
    relative_from_pose,
    relative_orientation,
)
from course_lib.orientation.space_resection import Resection, resect_camera, resect_robustly
from course_lib.orientation.three_points import poses_from_three_points
from course_lib.similarity import Similarity, similarity_transform

__all__ = [
    "CheckErrors",
    "RelativeOrientation",
    "Resection",
    "Similarity",
    "check_point_rmse",
    "leave_one_out",
    "pictures_for_circle",
    "pose_from_relative",
    "poses_from_three_points",
    "relative_from_pose",
    "relative_orientation",
    "resect_camera",
    "resect_robustly",
    "similarity_transform",
]
