"""Chapter 08: the exercises on epipolar geometry."""

from course_lib.exercises.epipolar.estimation import (
    EIGHT_POINT,
    RANSAC_ITERATIONS,
    SAMPSON_ERROR,
)
from course_lib.exercises.epipolar.lines import EPIPOLAR_LINES, EPIPOLE, LINE_DISTANCE
from course_lib.exercises.epipolar.matrices import (
    ESSENTIAL_FROM_POSE,
    FUNDAMENTAL_FROM_CAMERAS,
    SKEW,
)
from course_lib.exercises.epipolar.search import (
    EXPLAIN_SCALE,
    POSE_FROM_ESSENTIAL,
    RANSAC_FUNDAMENTAL,
)

#: In the order of the lesson.
EXERCISES = (
    SKEW,
    ESSENTIAL_FROM_POSE,
    FUNDAMENTAL_FROM_CAMERAS,
    EPIPOLAR_LINES,
    EPIPOLE,
    LINE_DISTANCE,
    EIGHT_POINT,
    SAMPSON_ERROR,
    RANSAC_ITERATIONS,
    RANSAC_FUNDAMENTAL,
    POSE_FROM_ESSENTIAL,
    EXPLAIN_SCALE,
)
