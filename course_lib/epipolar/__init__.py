"""Epipolar geometry: what two pictures of one scene tell of each other.

A point of picture 1 lies on a ray; picture 2 sees the ray as a line, the epipolar line, on which
the point's partner must be: ``x2ᵀ F x1 = 0`` and ``l2 = F x1``. The relative pose ``(R, t)`` leads
from camera 1 to camera 2, ``X_2 = R X_1 + t``, and ``E = [t]ₓ R``.
"""

from course_lib.epipolar.degeneracy import find_degeneracy
from course_lib.epipolar.essential import (
    pair_depths,
    pose_from_essential,
    poses_from_essential,
    refine_pose,
)
from course_lib.epipolar.five_point import five_point
from course_lib.epipolar.fundamental import eight_point, seven_point
from course_lib.epipolar.lines import (
    epipolar_lines,
    epipole,
    line_distance,
    sampson_error,
    symmetric_distance,
)
from course_lib.epipolar.matrices import (
    essential_from_fundamental,
    essential_from_pose,
    fundamental_from_cameras,
    fundamental_from_essential,
    relative_pose,
)
from course_lib.epipolar.rectification import Rectification, rectify, rectify_uncalibrated
from course_lib.epipolar.robust import (
    RobustFundamental,
    RobustPose,
    ransac_fundamental,
    ransac_pose,
    refine_fundamental,
)
from course_lib.epipolar.search import ransac_iterations
from course_lib.transforms import skew

__all__ = [
    "Rectification",
    "RobustFundamental",
    "RobustPose",
    "eight_point",
    "epipolar_lines",
    "epipole",
    "essential_from_fundamental",
    "essential_from_pose",
    "find_degeneracy",
    "five_point",
    "fundamental_from_cameras",
    "fundamental_from_essential",
    "line_distance",
    "pair_depths",
    "pose_from_essential",
    "poses_from_essential",
    "ransac_fundamental",
    "ransac_iterations",
    "ransac_pose",
    "rectify",
    "rectify_uncalibrated",
    "refine_fundamental",
    "refine_pose",
    "relative_pose",
    "sampson_error",
    "seven_point",
    "skew",
    "symmetric_distance",
]
