"""Zhang's method from end to end: closed form, then refinement."""

from __future__ import annotations

from collections.abc import Sequence

from numpy.typing import ArrayLike

from course_lib.calibration.model import CameraModel
from course_lib.calibration.result import (
    Calibration,
    calibration_from_state,
)
from course_lib.calibration.start import minimum
from course_lib.calibration.views import gather_views
from course_lib.checks import check_size


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
        K and distortion to begin with; the closed form is taken instead if it comes closer to the
        pixels. What the model does not free stays as it is here.

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
    >>> from course_lib.calibration import board_points
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
    return calibration_from_state(*minimum(views, size, model, start), views, size)
