"""Two cameras that are fixed to each other: calibrated together, from pictures of one board.

The pose of the board before the left camera is free in each pair; that of the right camera against
the left is one for all pairs. Use these functions through `course_lib.calibration`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from course_lib.calibration.derivatives import residuals
from course_lib.calibration.model import CameraModel, State, rotations_from_vectors
from course_lib.calibration.refinement import Normals, refined, view_products
from course_lib.calibration.start import minimum
from course_lib.calibration.views import Views, gather_views
from course_lib.checks import Array, DegenerateConfigurationError, check_size

#: Names of the turn (rad, about the right camera's axes) and the shift from left to right.
RELATIVE = ("turn x", "turn y", "turn z", "shift x", "shift y", "shift z")


@dataclass(frozen=True, eq=False)
class StereoCalibration:
    """A pair of cameras, and how one stands to the other.

    Attributes
    ----------
    K_left, K_right : ndarray, shape (3, 3)
        Intrinsics, px.
    coefficients_left, coefficients_right : ndarray
        Distortion, as in `distort`.
    R, t : ndarray, shape (3, 3) and (3,)
        Left camera to right camera, ``X_right = R X_left + t``; t in the unit of the board. Its
        length is the baseline.
    poses : tuple of (R, t)
        Board to left camera, for each pair.
    residuals_left, residuals_right : tuple of ndarray, shape (N, 2)
        Projected minus observed pixels of each pair.
    rms : float
        Root mean square of the residuals' lengths, px, over the points of both cameras.
    sigma : dict of str to float
        Standard deviations: ``left fx`` …, ``right fx`` …, ``turn x`` … (rad), ``shift x`` ….
    covariance : ndarray, shape (n, n)
        Covariance of the same numbers, in the same order.
    """

    K_left: Array
    K_right: Array
    coefficients_left: Array
    coefficients_right: Array
    R: Array
    t: Array
    poses: tuple[tuple[Array, Array], ...]
    residuals_left: tuple[Array, ...]
    residuals_right: tuple[Array, ...]
    rms: float
    sigma: dict[str, float]
    covariance: Array


@dataclass(frozen=True, eq=False)
class _Pair:
    """Two cameras, the pose of the right one against the left, and the board before the left."""

    left: State
    right: State
    R: Array
    t: Array

    @property
    def is_camera(self) -> bool:
        return self.left.is_camera and self.right.is_camera

    def moved(self, camera_step: Array, pose_steps: Array) -> _Pair:
        """Return the pair after a step of the left camera, the right one, and their pose."""
        n, m = len(self.left.model.names), len(self.right.model.names)
        left = self.left.moved(camera_step[:n], pose_steps)
        turn, shift = camera_step[None, n + m : n + m + 3], camera_step[n + m + 3 :]
        R, t = rotations_from_vectors(turn)[0] @ self.R, self.t + shift
        camera = self.right.model.moved(self.right.camera, camera_step[n : n + m])
        return _joined(left, camera, self.right.model, R, t)


def _joined(left: State, camera: Array, model: CameraModel, R: Array, t: Array) -> _Pair:
    """Return the pair in which the right camera sees the board where the left one has it."""
    return _Pair(left, State(model, camera, R @ left.R, left.t @ R.T + t), R, t)


def calibrate_stereo(
    object_points: ArrayLike | Sequence[ArrayLike],
    left_points: Sequence[ArrayLike],
    right_points: Sequence[ArrayLike],
    image_size: tuple[int, int],
    model: CameraModel | None = None,
) -> StereoCalibration:
    """Return two cameras and their relative pose from pairs of pictures of a board.

    Parameters
    ----------
    object_points : array_like, shape (N, 3), or sequence of V of them
        As in `calibrate`.
    left_points, right_points : sequence of V array_like, shape (N, 2)
        Pixels in the left and the right picture of each pair.
    image_size : tuple of int
        Width and height of the pictures of both cameras, px.
    model : CameraModel, optional
        What is estimated of each camera.

    Returns
    -------
    StereoCalibration
        The pair with the smallest reprojection error in all pictures.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or a number is not finite, or there are not as many left as right.
    DegenerateConfigurationError
        As `calibrate`, for either camera.

    References
    ----------
    J.-Y. Bouguet, Camera Calibration Toolbox for Matlab (stereo); Hartley & Zisserman, Multiple
    View Geometry, 2nd ed., section A6.3 (sparse normal equations).
    """
    model = CameraModel() if model is None else model
    size = check_size(image_size, "image_size")
    left, right = (gather_views(object_points, points) for points in (left_points, right_points))
    if len(left.counts) != len(right.counts):
        raise ValueError(
            f"there are {len(left.counts)} left and {len(right.counts)} right views: leave out "
            "pairs in which the board was not found twice"
        )
    start = _first_pair(minimum(left, size, model)[0], minimum(right, size, model)[0])
    observations = left.observations + right.observations
    products = partial(_pair_products, left=left, right=right)
    pair, normals = refined(start, products, observations)
    return _judged(pair, normals, left, right)


def _first_pair(left: State, right: State) -> _Pair:
    """Return the pair with the mean of what each pair of pictures says of the relative pose."""
    each = right.R @ left.R.swapaxes(1, 2)
    U, _, Vt = np.linalg.svd(each.sum(axis=0))  # the rotation nearest to all of them
    R = U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt
    turned = np.einsum("ij,vj->vi", R, left.t)
    return _joined(left, right.camera, right.model, R, np.median(right.t - turned, axis=0))


def _pair_products(pair: _Pair, left: Views, right: Views) -> Array:
    """Return products by left camera, right camera, relative pose, pose of the board, residual.

    A turn w and a shift d of the board before the left camera are R w and R d before the right
    one. A turn w and a shift d of the right camera's pose turn the board by w and shift it by
    ``w × R t_i + d``.
    """
    n, m = len(pair.left.model.names), len(pair.right.model.names)
    views, size = len(left.counts), n + m + 13
    board, residual = slice(n + m + 6, size - 1), size - 1
    by_left = np.zeros((n + 7, size))
    by_left[:n, :n], by_left[n : n + 6, board], by_left[-1, residual] = np.eye(n), np.eye(6), 1
    by_right = np.zeros((views, m + 7, size))
    by_right[:, :m, n : n + m], by_right[:, -1, residual] = np.eye(m), 1
    by_right[:, m : m + 6, n + m : n + m + 6] = np.eye(6)
    # w × q as a matrix on w has the columns e_i × q.
    lever = np.cross(np.eye(3), (pair.left.t @ pair.R.T)[:, None]).swapaxes(1, 2)
    by_right[:, m + 3 : m + 6, n + m : n + m + 3] = lever
    by_right[:, m : m + 3, n + m + 6 : n + m + 9] = pair.R
    by_right[:, m + 3 : m + 6, n + m + 9 : n + m + 12] = pair.R
    products = by_left.T @ view_products(pair.left, left) @ by_left
    return np.asarray(
        products + by_right.swapaxes(1, 2) @ view_products(pair.right, right) @ by_right
    )


def _judged(pair: _Pair, normals: Normals, left: Views, right: Views) -> StereoCalibration:
    """Return the result with residuals and standard deviations."""
    names = [f"left {name}" for name in pair.left.model.names]
    names += [f"right {name}" for name in pair.right.model.names] + list(RELATIVE)
    observations = left.observations + right.observations
    variance = normals.cost / (observations - len(names) - 6 * len(left.counts))
    try:
        covariance = variance * normals.inverse_blocks[0]
    except np.linalg.LinAlgError as error:
        raise DegenerateConfigurationError("the pairs do not determine the cameras") from error
    sigma = np.sqrt(np.diag(covariance)).tolist()
    return StereoCalibration(
        K_left=pair.left.K,
        K_right=pair.right.K,
        coefficients_left=pair.left.coefficients,
        coefficients_right=pair.right.coefficients,
        R=pair.R,
        t=pair.t,
        poses=tuple(zip(pair.left.R, pair.left.t, strict=True)),
        residuals_left=tuple(left.per_view(residuals(pair.left, left))),
        residuals_right=tuple(right.per_view(residuals(pair.right, right))),
        rms=float(np.sqrt(2 * normals.cost / observations)),
        sigma=dict(zip(names, sigma, strict=True)),
        covariance=covariance,
    )
