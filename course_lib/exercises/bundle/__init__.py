"""Chapter 10: the exercises on bundle adjustment and absolute orientation."""

from course_lib.exercises.bundle.adjustment import BUNDLE_ADJUST, SOLVE_NORMAL_BLOCK
from course_lib.exercises.bundle.control import CHECK_POINT_RMSE, PICTURES_FOR_CIRCLE
from course_lib.exercises.bundle.judgement import EXPLAIN_CONTROL_RESIDUALS
from course_lib.exercises.bundle.poses import REPROJECTION_JACOBIAN, RESECT_CAMERA
from course_lib.exercises.bundle.similarity import SIMILARITY_TRANSFORM

#: In the order of the lesson.
EXERCISES = (
    RESECT_CAMERA,
    REPROJECTION_JACOBIAN,
    SOLVE_NORMAL_BLOCK,
    BUNDLE_ADJUST,
    PICTURES_FOR_CIRCLE,
    SIMILARITY_TRANSFORM,
    CHECK_POINT_RMSE,
    EXPLAIN_CONTROL_RESIDUALS,
)
