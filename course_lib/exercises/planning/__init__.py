"""Chapter 11: the exercises on planning a measurement."""

from course_lib.exercises.planning.aperture import APERTURE_WINDOW
from course_lib.exercises.planning.flight import (
    GROUND_SAMPLE_DISTANCE,
    MAX_SPEED,
    PHOTO_COUNT,
)
from course_lib.exercises.planning.overlaps import BASE_FOR_OVERLAP, OVERLAP
from course_lib.exercises.planning.setup import EXPLAIN_TWICE_AS_HIGH, PLAN_SETUP
from course_lib.exercises.planning.view import BOX_IN_VIEW, OBJECT_RESOLUTION

#: In the order of the lesson.
EXERCISES = (
    BOX_IN_VIEW,
    OBJECT_RESOLUTION,
    APERTURE_WINDOW,
    GROUND_SAMPLE_DISTANCE,
    OVERLAP,
    BASE_FOR_OVERLAP,
    MAX_SPEED,
    PHOTO_COUNT,
    EXPLAIN_TWICE_AS_HIGH,
    PLAN_SETUP,
)
