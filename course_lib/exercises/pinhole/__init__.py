"""Chapter 01: the exercises on the pinhole camera."""

from course_lib.exercises.pinhole.data_sheet import DATA_SHEET
from course_lib.exercises.pinhole.perspective import (
    DOLLY_ZOOM,
    EXPLAIN_FLAT_FACES,
    PROJECT_PINHOLE,
    VANISHING_POINT,
)
from course_lib.exercises.pinhole.sensor import (
    BEST_PINHOLE_DIAMETER,
    EQUIVALENT_FOCAL_LENGTH,
    FIELD_OF_VIEW,
    FIRST_GUESS_INTRINSICS,
    PIXEL_FOCAL_LENGTH,
)

#: In the order of the lesson.
EXERCISES = (
    BEST_PINHOLE_DIAMETER,
    PIXEL_FOCAL_LENGTH,
    FIELD_OF_VIEW,
    EQUIVALENT_FOCAL_LENGTH,
    FIRST_GUESS_INTRINSICS,
    DATA_SHEET,
    PROJECT_PINHOLE,
    VANISHING_POINT,
    DOLLY_ZOOM,
    EXPLAIN_FLAT_FACES,
)
