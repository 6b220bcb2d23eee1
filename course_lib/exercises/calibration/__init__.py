"""Chapter 07: the exercises on Zhang's calibration."""

from course_lib.exercises.calibration.closed_form import (
    BOARD_POINTS,
    HOMOGRAPHY_CONSTRAINTS,
    INTRINSICS_FROM_HOMOGRAPHIES,
    POSE_FROM_HOMOGRAPHY,
)
from course_lib.exercises.calibration.distortion import INITIAL_DISTORTION
from course_lib.exercises.calibration.judgement import (
    EXPLAIN_SMALL_RMS,
    PARAMETER_COVARIANCE,
    REJECT_VIEWS,
)
from course_lib.exercises.calibration.refinement import (
    REFINE_CALIBRATION,
    REPROJECTION_RESIDUALS,
    RMS_ERROR,
)

#: In the order of the lesson.
EXERCISES = (
    BOARD_POINTS,
    HOMOGRAPHY_CONSTRAINTS,
    INTRINSICS_FROM_HOMOGRAPHIES,
    POSE_FROM_HOMOGRAPHY,
    INITIAL_DISTORTION,
    REPROJECTION_RESIDUALS,
    RMS_ERROR,
    REFINE_CALIBRATION,
    REJECT_VIEWS,
    PARAMETER_COVARIANCE,
    EXPLAIN_SMALL_RMS,
)
