"""Chapter 05: the exercises on lens distortion."""

from course_lib.exercises.distortion.fisheye import FISHEYE_PROJECT
from course_lib.exercises.distortion.full_model import DISTORT_RATIONAL_PRISM
from course_lib.exercises.distortion.inverses import (
    EXPLAIN_FOLDED_CORNERS,
    UNDISTORT_POINTS,
    VALID_RADIUS,
)
from course_lib.exercises.distortion.models import DISTORT, DISTORT_RADIAL
from course_lib.exercises.distortion.pictures import STRAIGHTNESS, UNDISTORTION_MAP

#: In the order of the lesson.
EXERCISES = (
    DISTORT_RADIAL,
    DISTORT,
    UNDISTORT_POINTS,
    UNDISTORTION_MAP,
    STRAIGHTNESS,
    EXPLAIN_FOLDED_CORNERS,
    VALID_RADIUS,
    FISHEYE_PROJECT,
    DISTORT_RATIONAL_PRISM,
)
