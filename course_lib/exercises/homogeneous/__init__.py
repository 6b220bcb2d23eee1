"""Chapter 02: the exercises on homogeneous coordinates and the camera matrix."""

from course_lib.exercises.homogeneous.cameras import (
    CAMERA_MATRIX,
    EXPLAIN_TRANSLATION,
    PIXEL_RAY,
    PROJECT,
)
from course_lib.exercises.homogeneous.plane import (
    FROM_HOMOGENEOUS,
    LINE_THROUGH,
    MEET,
    TO_HOMOGENEOUS,
)
from course_lib.exercises.homogeneous.poses import (
    CAMERA_CENTRE,
    CV_FROM_GRAPHICS_CAMERA,
    INVERT_POSE,
    POSE_FROM_PLACEMENT,
)
from course_lib.exercises.homogeneous.turns import GIMBAL_POSE, ROTATION_ABOUT_AXIS

#: In the order of the lesson.
EXERCISES = (
    TO_HOMOGENEOUS,
    FROM_HOMOGENEOUS,
    LINE_THROUGH,
    MEET,
    INVERT_POSE,
    CAMERA_CENTRE,
    POSE_FROM_PLACEMENT,
    CV_FROM_GRAPHICS_CAMERA,
    CAMERA_MATRIX,
    PROJECT,
    PIXEL_RAY,
    EXPLAIN_TRANSLATION,
    ROTATION_ABOUT_AXIS,
    GIMBAL_POSE,
)
