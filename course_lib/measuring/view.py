"""A picture to measure in: where its camera stood, and how well that is known.

Use these names through `course_lib.measuring`.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike

from course_lib.calibration import Calibration, CameraModel, StereoCalibration
from course_lib.calibration.derivatives import derivative_blocks
from course_lib.calibration.model import COEFFICIENTS, State, camera_numbers
from course_lib.calibration.quality import posed_boards
from course_lib.calibration.refinement import minimised
from course_lib.calibration.views import Views, gather_views
from course_lib.checks import Array, check_not_negative, check_number
from course_lib.transforms import camera_centre


@dataclass(frozen=True, eq=False)
class View:
    """A picture of a calibrated camera whose pose is known, each with its uncertainty.

    The errors have three sources. The numbers θ that were calibrated are common to all pictures:
    views with the same array `covariance` share their error. The target is not quite as it should
    be, in all pictures alike. And the pose has an error of its own, from the noise in this
    picture's corners.

    Attributes
    ----------
    K : ndarray, shape (3, 3)
        Intrinsics, px.
    coefficients : ndarray
        Distortion, as in `distort`.
    R, t : ndarray, shape (3, 3) and (3,)
        Pose, target to camera.
    model : CameraModel
        Which n numbers of the camera were calibrated.
    covariance : ndarray, shape (m, m)
        Of all that was calibrated.
    follows : ndarray, shape (n + 6, m)
        Derivatives of the camera's n numbers and of the pose (turn about the camera's axes, shift)
        by what was calibrated.
    pose_covariance : ndarray, shape (6, 6)
        Of the pose, if the camera were known exactly.
    sigma0 : float
        Standard deviation of a coordinate of a corner in this picture, px; NaN without a target.
    target : ndarray, shape (N, 3)
        The points of the target that the pose comes from.
    by_target : ndarray, shape (6, N, 3)
        Derivatives of the pose by these points.
    unevenness : float
        Standard deviation of these points, in each direction.
    """

    K: Array
    coefficients: Array
    R: Array
    t: Array
    model: CameraModel
    covariance: Array
    follows: Array
    pose_covariance: Array
    sigma0: float
    target: Array = field(default_factory=lambda: np.zeros((0, 3)))
    by_target: Array = field(default_factory=lambda: np.zeros((6, 0, 3)))
    unevenness: float = 0.0

    @property
    def centre(self) -> Array:
        """Where the camera stood, in the frame of the target, shape (3,)."""
        return camera_centre(self.R, self.t)


def view_of_target(
    target_points: ArrayLike,
    pixels: ArrayLike,
    calibration: Calibration,
    unevenness: float = 0.0,
) -> View:
    """Return the picture's pose from the target in it.

    An error δθ of the camera's numbers also moves the pose that fits best,
    ``δp = -(Jₚᵀ Jₚ)⁻¹ Jₚᵀ J_θ δθ``. So errors of camera and pose are not independent, and for
    points near the target they nearly cancel. An error δX of the target's points moves it by
    ``-(Jₚᵀ Jₚ)⁻¹ Jₚᵀ J_X δX``.

    Parameters
    ----------
    target_points : array_like, shape (N, 3)
        N ≥ 4 points of the target, z = 0.
    pixels : array_like, shape (N, 2)
        Where they are in this picture, with distortion.
    calibration : Calibration
        The camera, calibrated with other pictures.
    unevenness : float
        Standard deviation of the target's points from where they should be, in each direction:
        paper is not flat, and printers and glue stretch it here and there. Neighbours share such
        an error, so that more corners do not average it away.

    Returns
    -------
    View
        Pose and uncertainty, judged by the residuals at the target.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite or there are not as many pixels as points.
    DegenerateConfigurationError
        If the points or pixels are on one line, or do not fit each other.

    References
    ----------
    E. M. Mikhail, F. Ackermann, Observations and Least Squares, chapter 4 (propagation of
    covariances); K. Kraus, Photogrammetry, 2nd ed., section 4.2 (spatial resection).
    """
    unevenness = check_number(check_not_negative(unevenness, "unevenness"), "unevenness")
    views = gather_views([target_points], [pixels])
    K, k = calibration.K, calibration.coefficients
    state, normals = minimised(posed_boards(K, k, views), views)
    variance = normals.cost / (views.observations - 6)
    target, nothing = views.points[0].T, np.zeros((6, 6))
    model, n = calibration.model, len(calibration.model.names)
    exact = View(K, k, state.R[0], state.t[0], model, nothing, nothing, nothing, 0.0)
    _, by_state, by_point = pixels_and_slopes(exact, target)
    rows = by_state.reshape(-1, n + 6)
    weights = np.linalg.inv(rows[:, n:].T @ rows[:, n:])
    back = -weights @ rows[:, n:].T
    return replace(
        exact,
        covariance=calibration.covariance,
        follows=np.vstack([np.eye(n), back @ rows[:, :n]]),
        pose_covariance=np.asarray(variance * weights),
        sigma0=float(np.sqrt(variance)),
        target=target,
        by_target=np.einsum("ink,nkj->inj", back.reshape(6, -1, 2), by_point),
        unevenness=unevenness,
    )


def views_of_pair(pair: StereoCalibration) -> tuple[View, View]:
    """Return the pictures of two cameras that are fixed to each other, in the left one's frame.

    No target is needed in them: the pair knows its baseline.

    Parameters
    ----------
    pair : StereoCalibration
        The cameras.

    Returns
    -------
    left, right : View
        The left camera has no error of pose, as all is measured from it.

    References
    ----------
    E. M. Mikhail, F. Ackermann, Observations and Least Squares, chapter 4.
    """
    names = list(pair.sigma)
    left, right = _model_of(names, "left "), _model_of(names, "right ")
    n, m = len(left.names), len(right.names)
    every, still = np.eye(len(names)), np.zeros((6, len(names)))
    covariance = pair.covariance

    def view(K: Array, k: Array, R: Array, t: Array, model: CameraModel, follows: Array) -> View:
        return View(K, k, R, t, model, covariance, follows, np.zeros((6, 6)), float("nan"))

    return (
        view(
            pair.K_left,
            pair.coefficients_left,
            np.eye(3),
            np.zeros(3),
            left,
            np.vstack([every[:n], still]),
        ),
        view(
            pair.K_right,
            pair.coefficients_right,
            pair.R,
            pair.t,
            right,
            every[n : n + m + 6],
        ),
    )


def _model_of(names: list[str], side: str) -> CameraModel:
    """Return which numbers of one camera of a pair were calibrated."""
    mine = [name.removeprefix(side) for name in names if name.startswith(side)]
    return CameraModel(
        focal="fx" in mine,
        square_pixels="fx" in mine and "fy" not in mine,
        skew="s" in mine,
        principal_point="cx" in mine,
        coefficients=tuple(name for name in COEFFICIENTS if name in mine),
    )


def pixels_and_slopes(view: View, points: Array) -> tuple[Array, Array, Array]:
    """Return where points of the target's frame are in the picture, and how that changes.

    Parameters
    ----------
    view : View
        The picture.
    points : ndarray, shape (N, 3)
        Points before the camera.

    Returns
    -------
    pixels : ndarray, shape (N, 2)
        With distortion.
    by_camera : ndarray, shape (N, 2, n + 6)
        Derivatives by the camera's numbers and the pose.
    by_point : ndarray, shape (N, 2, 3)
        Derivatives by the point: ``∂pixel/∂t R``, as a shift of the pose moves it in the camera.
    """
    camera = camera_numbers(view.K, view.coefficients)
    state = State(view.model, camera, view.R[None], view.t[None])
    zero = np.zeros((1, 2, len(points)))
    views = Views(points.T[None], zero, None, np.array([len(points)]))
    block = next(derivative_blocks(state, views))[0].transpose(2, 1, 0).copy()
    slopes = block[..., :-1]
    return block[..., -1], slopes, slopes[..., -3:] @ view.R
