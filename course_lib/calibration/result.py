"""What a calibration gives: camera, poses, what is left over, and how certain each number is.

Use these functions through `course_lib.calibration`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from course_lib.calibration.degeneracy import check_determined, vagueness
from course_lib.calibration.derivatives import derivative_blocks, residuals
from course_lib.calibration.judgement import rms_error
from course_lib.calibration.model import CameraModel, State, camera_numbers
from course_lib.calibration.refinement import Normals
from course_lib.calibration.views import Views, gather_views
from course_lib.checks import Array


@dataclass(frozen=True, eq=False)
class Calibration:
    """A calibrated camera, and everything that tells how good it is.

    Attributes
    ----------
    K : ndarray, shape (3, 3)
        Intrinsics, px.
    coefficients : ndarray, shape (1,), (2,), (4,), (5,), (8,) or (12,)
        Distortion, as in `distort`.
    poses : tuple of (R, t)
        Pose of each view, board to camera; t in the unit of the board.
    residuals : tuple of ndarray, shape (N, 2)
        For each view, projected minus observed pixels.
    rms : float
        Root mean square of the residuals' lengths, px, over the points that count.
    sigma : dict of str to float
        Standard deviation of each number of the camera that was estimated, by its name.
    covariance : ndarray, shape (n, n)
        Covariance of the same numbers, in the same order.
    pose_sigma : ndarray, shape (V, 6)
        Standard deviations of each pose: turn about the camera's x, y, z (rad), then t.
    image_size : tuple of int
        Width and height of the pictures, px.
    model : CameraModel
        What was estimated.
    """

    K: Array
    coefficients: Array
    poses: tuple[tuple[Array, Array], ...]
    residuals: tuple[Array, ...]
    rms: float
    sigma: dict[str, float]
    covariance: Array
    pose_sigma: Array
    image_size: tuple[int, int]
    model: CameraModel

    @property
    def view_rms(self) -> Array:
        """Root mean square of each view's residuals, px, shape (V,)."""
        return np.array([rms_error(view) for view in self.residuals])


def calibration_from_state(
    state: State, normals: Normals, views: Views, image_size: Array
) -> Calibration:
    """Return the result at a minimum, with residuals and standard deviations.

    Parameters
    ----------
    state, normals : State, Normals
        As `refined` returns them.
    views : Views
        What was measured.
    image_size : ndarray, shape (2,)
        Width and height, px.

    Returns
    -------
    Calibration
        Standard deviations are from the residuals: ``σ0² = Σ r² / (equations - unknowns)``.

    Raises
    ------
    DegenerateConfigurationError
        If the views leave the focal length open.
    """
    names = state.model.names
    check_determined(state, vagueness(state, normals, views.observations), image_size)
    variance = normals.cost / (views.observations - len(names) - 6 * len(state.R))
    covariance, poses = normals.inverse_blocks
    sigma = np.sqrt(variance * np.diag(covariance))
    return Calibration(
        K=state.K,
        coefficients=state.coefficients,
        poses=tuple(zip(state.R, state.t, strict=True)),
        residuals=tuple(views.per_view(residuals(state, views))),
        rms=float(np.sqrt(2 * normals.cost / views.observations)),
        sigma=dict(zip(names, sigma.tolist(), strict=True)),
        covariance=variance * covariance,
        pose_sigma=np.sqrt(variance * poses),
        image_size=(int(image_size[0]), int(image_size[1])),
        model=state.model,
    )


def residuals_and_jacobian(
    calibration: Calibration, object_points: object, image_points: object
) -> tuple[Array, Array]:
    """Return all residuals of a calibration below each other, and their derivatives.

    The matrix is mostly zeros: a pose only moves the pixels of its own view. `calibrate` never
    writes it down as a whole.

    Parameters
    ----------
    calibration : Calibration
        Where the derivatives are taken.
    object_points, image_points : as in `calibrate`
        The measurements that it was made from.

    Returns
    -------
    residuals : ndarray, shape (2 N,)
        Projected minus observed, view by view, ``du, dv`` of each point; N points in all.
    J : ndarray, shape (2 N, n + 6 V)
        Columns: the n numbers of `calibration.sigma`, then for each view the turn about the axes of
        the camera and the translation.

    Raises
    ------
    TypeError, ValueError
        As `calibrate`.

    References
    ----------
    B. Triggs et al., "Bundle adjustment: a modern synthesis" (2000), section 4.
    """
    views, n = gather_views(object_points, image_points), len(calibration.sigma)
    J = np.zeros((2 * int(views.counts.sum()), n + 6 * len(views.counts)))
    left, row = np.empty(len(J)), 0
    blocks = derivative_blocks(state_of(calibration), views)
    for i, rows in enumerate(rows for block in blocks for rows in block):
        part = rows[:, :, : views.counts[i]].transpose(2, 1, 0).reshape(-1, n + 7)
        some = slice(row, row + len(part))
        J[some, :n], left[some] = part[:, :n], part[:, -1]
        J[some, n + 6 * i : n + 6 * i + 6] = part[:, n:-1]
        row += len(part)
    return left, J


def state_of(calibration: Calibration, model: CameraModel | None = None) -> State:
    """Return the state of the refinement that a calibration is, or with other numbers free."""
    return State(
        calibration.model if model is None else model,
        camera_numbers(calibration.K, calibration.coefficients),
        np.array([R for R, _ in calibration.poses]),
        np.array([t for _, t in calibration.poses]),
    )
