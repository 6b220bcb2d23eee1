"""Chapter 06: the exercises on least squares, homographies and the camera's DLT."""

from course_lib.exercises.estimation.cameras import CAMERA_DLT, DECOMPOSE_PROJECTION
from course_lib.exercises.estimation.fits import FIT_AFFINE, FIT_LINE, SOLVE_ONE_UNKNOWN
from course_lib.exercises.estimation.homographies import HOMOGRAPHY_DLT
from course_lib.exercises.estimation.planes import APPLY_HOMOGRAPHY, NORMALISE_POINTS
from course_lib.exercises.estimation.tables import CORRECTION_TABLE, EXPLAIN_RESIDUALS

#: In the order of the lesson.
EXERCISES = (
    SOLVE_ONE_UNKNOWN,
    FIT_LINE,
    FIT_AFFINE,
    APPLY_HOMOGRAPHY,
    NORMALISE_POINTS,
    HOMOGRAPHY_DLT,
    CAMERA_DLT,
    DECOMPOSE_PROJECTION,
    CORRECTION_TABLE,
    EXPLAIN_RESIDUALS,
)
