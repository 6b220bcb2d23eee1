"""Chapter 03: the exercises on lenses."""

from course_lib.exercises.lenses.diffraction import (
    AIRY_DIAMETER,
    EXPLAIN_STOPPED_DOWN,
    IS_DIFFRACTION_LIMITED,
)
from course_lib.exercises.lenses.imaging import (
    F_NUMBER,
    IMAGE_DISTANCE,
    LENS_SYSTEM,
    OBJECT_DISTANCE,
)
from course_lib.exercises.lenses.names import PARSE_LENS_NAME
from course_lib.exercises.lenses.sharpness import (
    APERTURE_FOR_DEPTH,
    CLOSEUP_DEPTH_OF_FIELD,
    DEPTH_OF_FIELD,
    HYPERFOCAL_DISTANCE,
)

#: In the order of the lesson.
EXERCISES = (
    IMAGE_DISTANCE,
    OBJECT_DISTANCE,
    F_NUMBER,
    HYPERFOCAL_DISTANCE,
    DEPTH_OF_FIELD,
    APERTURE_FOR_DEPTH,
    AIRY_DIAMETER,
    IS_DIFFRACTION_LIMITED,
    EXPLAIN_STOPPED_DOWN,
    PARSE_LENS_NAME,
    CLOSEUP_DEPTH_OF_FIELD,
    LENS_SYSTEM,
)
