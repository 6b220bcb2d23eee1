"""Chapter 11: the exercises on planning a measurement."""

from course_lib.exercises.planning.view import BOX_IN_VIEW, OBJECT_RESOLUTION

#: In the order of the lesson.
EXERCISES = (
    BOX_IN_VIEW,
    OBJECT_RESOLUTION,
)
