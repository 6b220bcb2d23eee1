"""Chapter 12: the questions of the lab, answered in words and graded by a person."""

from course_lib.exercises.lab.questions import (
    EXPLAIN_CAMERA,
    EXPLAIN_PLANE,
    EXPLAIN_REPORT,
    EXPLAIN_RULER,
    EXPLAIN_SPACE,
)

#: In the order of the lesson.
EXERCISES = (EXPLAIN_CAMERA, EXPLAIN_PLANE, EXPLAIN_SPACE, EXPLAIN_RULER, EXPLAIN_REPORT)
