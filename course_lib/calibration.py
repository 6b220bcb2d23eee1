"""Camera calibration from pictures of a flat board: Zhang's method.

Homographies give the camera in closed form; a refinement moves camera, distortion and the pose of
each view until the corners come out where they were seen. The board's frame has z = 0; a pose maps
board to camera.
"""

from __future__ import annotations

from collections.abc import Sequence

from numpy.typing import ArrayLike

from course_lib.calibration_degeneracy import check_enough, check_order, check_tilts
from course_lib.calibration_judgement import reject_views, reprojection_residuals, rms_error
from course_lib.calibration_model import CameraModel
from course_lib.calibration_refinement import minimised
from course_lib.calibration_result import (
    Calibration,
    calibration_from_state,
    residuals_and_jacobian,
)
from course_lib.calibration_start import starting_state, view_homographies
from course_lib.calibration_views import Views, board_points, gather_views
from course_lib.checks import Array, check_size
from course_lib.least_squares import parameter_covariance
from course_lib.zhang import (
    homography_constraints,
    initial_distortion,
    intrinsics_from_homographies,
    pose_from_homography,
)

__all__ = [
    "Calibration",
    "CameraModel",
    "board_points",
    "calibrate",
    "homography_constraints",
    "initial_distortion",
    "intrinsics_from_homographies",
    "parameter_covariance",
    "pose_from_homography",
    "reject_views",
    "reprojection_residuals",
    "residuals_and_jacobian",
    "rms_error",
]

#: With more points in a view than this, a part of them is enough for the first steps.
ENOUGH_POINTS = 60


def calibrate(
    object_points: ArrayLike | Sequence[ArrayLike],
    image_points: Sequence[ArrayLike],
    image_size: tuple[int, int],
    model: CameraModel | None = None,
    start: tuple[ArrayLike, ArrayLike] | None = None,
) -> Calibration:
    """Return the camera whose projections of a board come closest to where it was seen.

    Parameters
    ----------
    object_points : array_like, shape (N, 3), or sequence of V of them
        Points of the board, z = 0: one board for all views, or one a view.
    image_points : sequence of V array_like, shape (N, 2)
        Their pixels in each view, in the same order.
    image_size : tuple of int
        Width and height of the pictures, px.
    model : CameraModel, optional
        What is estimated; fx, fy, cx, cy, k1, k2, p1, p2, k3 unless given.
    start : tuple of array_like, shape (3, 3) and coefficients, optional
        K and distortion to begin with, instead of the closed form. What the model does not free
        stays as it is there.

    Returns
    -------
    Calibration
        Camera, poses, residuals and standard deviations at the minimum of the reprojection error.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or a view has not as many pixels as points.
    DegenerateConfigurationError
        If the measurements do not determine the camera: too few views or points, all boards
        parallel, the same view again and again, points in another order; the message says which.

    References
    ----------
    Z. Zhang, "A flexible new technique for camera calibration", IEEE PAMI 22 (2000).

    Examples
    --------
    >>> from course_lib.camera import camera_matrix, project
    >>> from course_lib.transforms import rotation_x, rotation_y
    >>> board = board_points(7, 5, square=30)
    >>> K = [[800, 0, 320], [0, 780, 240], [0, 0, 1]]
    >>> turns = [rotation_x(0.5), rotation_y(0.5), rotation_x(-0.4) @ rotation_y(-0.4)]
    >>> pixels = [project(board, camera_matrix(K, R, [-90, -60, 500])) for R in turns]
    >>> calibrate(board, pixels, (640, 480)).K.round(6)
    array([[800.,   0., 320.],
           [  0., 780., 240.],
           [  0.,   0.,   1.]])
    """
    model = CameraModel() if model is None else model
    size = check_size(image_size, "image_size")
    views = gather_views(object_points, image_points)
    return calibrate_views(views, size, model, start)


def calibrate_views(
    views: Views,
    size: Array,
    model: CameraModel,
    start: tuple[ArrayLike, ArrayLike] | None,
) -> Calibration:
    """Return the calibration from checked measurements."""
    check_enough(views, model, known=start is not None)
    few = views.thinned(ENOUGH_POINTS)
    Hs = view_homographies(few)
    check_order(few, Hs)
    check_tilts(Hs, size, model)
    state = starting_state(few, Hs, size, model, start)
    if few is not views:
        state, _ = minimised(state, few, last_gain=1e-3)
    return calibration_from_state(*minimised(state, views), views, size)
