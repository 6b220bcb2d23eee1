"""Chapter 08: the exercises on epipolar geometry."""

from course_lib.exercises.epipolar.lines import EPIPOLAR_LINES, EPIPOLE, LINE_DISTANCE
from course_lib.exercises.epipolar.matrices import (
    ESSENTIAL_FROM_POSE,
    FUNDAMENTAL_FROM_CAMERAS,
    SKEW,
)

#: In the order of the lesson.
EXERCISES = (
    SKEW,
    ESSENTIAL_FROM_POSE,
    FUNDAMENTAL_FROM_CAMERAS,
    EPIPOLAR_LINES,
    EPIPOLE,
    LINE_DISTANCE,
)
