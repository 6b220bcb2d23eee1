"""Chapter 09: the exercises on triangulation."""

from course_lib.exercises.triangulation.covariance import POINT_COVARIANCE
from course_lib.exercises.triangulation.depth import (
    DEPTH_FROM_DISPARITY,
    DEPTH_UNCERTAINTY,
    EXPLAIN_TWICE_AS_FAR,
)
from course_lib.exercises.triangulation.planes import INTERSECT_RAY_PLANE
from course_lib.exercises.triangulation.points import REFINE_POINT, TRIANGULATE_LINEAR
from course_lib.exercises.triangulation.rays import (
    CLOSEST_POINTS_ON_RAYS,
    TRIANGULATE_MIDPOINT,
)

#: In the order of the lesson.
EXERCISES = (
    CLOSEST_POINTS_ON_RAYS,
    TRIANGULATE_MIDPOINT,
    TRIANGULATE_LINEAR,
    REFINE_POINT,
    DEPTH_FROM_DISPARITY,
    DEPTH_UNCERTAINTY,
    POINT_COVARIANCE,
    INTERSECT_RAY_PLANE,
    EXPLAIN_TWICE_AS_FAR,
)
