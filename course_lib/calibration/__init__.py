"""Camera calibration from pictures of a flat board: Zhang's method.

Homographies give the camera in closed form; a refinement moves camera, distortion and the pose of
each view until the corners come out where they were seen. The board's frame has z = 0; a pose maps
board to camera.
"""

from __future__ import annotations

from course_lib.calibration.judgement import (
    refine_calibration,
    reject_views,
    reprojection_residuals,
    rms_error,
)
from course_lib.calibration.model import CameraModel
from course_lib.calibration.procedure import calibrate
from course_lib.calibration.quality import (
    Coverage,
    board_tilts,
    coverage,
    held_out_rms,
    view_residuals,
)
from course_lib.calibration.result import Calibration, residuals_and_jacobian
from course_lib.calibration.robust import RobustCalibration, calibrate_robustly
from course_lib.calibration.stereo import StereoCalibration, calibrate_stereo
from course_lib.calibration.views import board_points
from course_lib.calibration.zhang import (
    homography_constraints,
    initial_distortion,
    intrinsics_from_homographies,
    pose_from_homography,
)
from course_lib.least_squares import parameter_covariance

__all__ = [
    "Calibration",
    "CameraModel",
    "Coverage",
    "RobustCalibration",
    "StereoCalibration",
    "board_points",
    "board_tilts",
    "calibrate",
    "calibrate_robustly",
    "calibrate_stereo",
    "coverage",
    "held_out_rms",
    "homography_constraints",
    "initial_distortion",
    "intrinsics_from_homographies",
    "parameter_covariance",
    "pose_from_homography",
    "refine_calibration",
    "reject_views",
    "reprojection_residuals",
    "residuals_and_jacobian",
    "rms_error",
    "view_residuals",
]
