"""How good a calibration is: residuals, their size, and which views do not fit.

Use these functions through `course_lib.calibration`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_intrinsics,
    check_matrix,
    check_not_negative,
    check_number,
    check_points,
    check_rotation,
    check_vector,
)
from course_lib.distortion.model import distort


def reprojection_residuals(
    points: ArrayLike,
    pixels: ArrayLike,
    K: ArrayLike,
    R: ArrayLike,
    t: ArrayLike,
    coefficients: ArrayLike,
) -> Array:
    """Return by how much a camera misses the pixels of one view: projected minus observed.

    Parameters
    ----------
    points : array_like, shape (N, 3)
        Points of the board, in its own frame.
    pixels : array_like, shape (N, 2)
        Where they were observed.
    K : array_like, shape (3, 3)
        Intrinsics in px.
    R, t : array_like, shape (3, 3) and (3,)
        Pose, board to camera.
    coefficients : array_like, shape (1,), (2,), (4,), (5,), (8,) or (12,)
        Distortion, as in `distort`.

    Returns
    -------
    ndarray, shape (N, 2)
        Residuals in px; a row of NaN for a point that is not before the camera.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or there are not as many pixels as points.

    References
    ----------
    Z. Zhang, "A flexible new technique for camera calibration", IEEE PAMI 22 (2000), section 3.2.

    Examples
    --------
    >>> K = [[100, 0, 50], [0, 100, 40], [0, 0, 1]]
    >>> reprojection_residuals([[1, 2, 0]], [[60, 59]], K, np.eye(3), [0, 0, 10], [0, 0])
    array([[0., 1.]])
    """
    points, pixels = check_points(points, 3, "points"), check_points(pixels, 2, "pixels")
    if points.ndim != 2 or pixels.shape != (len(points), 2):
        raise ValueError(
            f"points and pixels must be as many rows, got shapes {points.shape} and {pixels.shape}"
        )
    K, R, t = check_intrinsics(K), check_rotation(R), check_vector(t, 3, "t")
    X = points @ R.T + t
    seen = X[:, 2] > 0
    projected = np.full_like(pixels, np.nan)
    ideal = X[seen, :2] / X[seen, 2:]
    projected[seen] = distort(ideal, coefficients) @ K[:2, :2].T + K[:2, 2]
    return projected - pixels


def rms_error(residuals: ArrayLike) -> float:
    """Return the root mean square of residuals, over points: how far a typical point is off.

    Parameters
    ----------
    residuals : array_like, shape (N, 2)
        Differences ``(du, dv)``, px.

    Returns
    -------
    float
        ``√(mean of du² + dv²)``, px: the lengths of the residuals, not their coordinates, which
        would give less by √2. OpenCV counts alike.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong, a number is not finite, or there is no point.

    References
    ----------
    OpenCV, calib3d, calibrateCamera (return value).

    Examples
    --------
    >>> rms_error([[3, 4], [0, 0], [0, 0], [0, 0]])
    2.5
    """
    residuals = np.atleast_2d(check_points(residuals, 2, "residuals"))
    if not len(residuals):
        raise ValueError("residuals are empty: there is no point to judge by")
    return float(np.sqrt((residuals**2).sum(axis=1).mean()))


def refine_calibration(
    parameters: ArrayLike, residuals: ArrayLike, J: ArrayLike, damping: float
) -> Array:
    """Return all parameters of a calibration after one step of Levenberg and Marquardt.

    `calibrate` takes the same steps, but eliminates the poses instead of writing down J.

    Parameters
    ----------
    parameters : array_like, shape (n,)
        Where the step begins.
    residuals : array_like, shape (m,)
        Projected minus observed pixels there, in one row.
    J : array_like, shape (m, n)
        Their derivatives by the parameters, as of `residuals_and_jacobian`.
    damping : float
        λ ≥ 0, which shortens the step.

    Returns
    -------
    ndarray, shape (n,)
        The parameters plus the δ that solves ``(JᵀJ + λ diag(JᵀJ)) δ = -Jᵀ residuals``.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite or the damping is negative.
    DegenerateConfigurationError
        If the system is singular: the residuals do not determine the parameters.

    References
    ----------
    D. Marquardt, "An algorithm for least-squares estimation of nonlinear parameters" (1963).

    Examples
    --------
    >>> refine_calibration([10], [6, 6], [[2], [2]], damping=1)
    array([8.5])
    """
    parameters = check_vector(parameters, np.size(parameters), "parameters")
    residuals = check_vector(residuals, np.size(residuals), "residuals")
    J = check_matrix(J, (residuals.size, parameters.size), "J")
    damping = float(check_not_negative(check_number(damping, "damping"), "damping"))
    N = J.T @ J
    try:
        step = np.linalg.solve(N + damping * np.diag(np.diag(N)), -J.T @ residuals)
    except np.linalg.LinAlgError as error:
        raise DegenerateConfigurationError(
            "the residuals do not determine the parameters: leave some out, or take more views"
        ) from error
    return np.asarray(parameters + step)


def reject_views(residuals: Sequence[ArrayLike], limit: float = 2.0) -> NDArray[np.bool_]:
    """Return which views to keep: those whose error is not far above what is usual.

    Parameters
    ----------
    residuals : sequence of V array_like, shape (N, 2), or array_like, shape (V, N, 2)
        Residuals of each view, px.
    limit : float
        A view goes if its RMS is more than so many times the median of all views' RMS. The median
        and not the mean, which a single bad view pulls up.

    Returns
    -------
    ndarray of bool, shape (V,)
        True for the views to keep.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, there is no view, or the limit is below 1.

    References
    ----------
    P. J. Huber, E. M. Ronchetti, Robust Statistics, 2nd ed., section 1.2 (the median).

    Examples
    --------
    >>> views = [[[0.3, 0]], [[0, 0.2]], [[0.9, 0.0]]]
    >>> reject_views(views)
    array([ True,  True, False])
    """
    if check_number(limit, "limit") < 1:
        raise ValueError(f"limit must be 1 or more, got {limit}: half of the views would go")
    if not len(residuals):
        raise ValueError("there are no views to choose from")
    rms = np.array([rms_error(view) for view in residuals])
    return np.asarray(rms <= limit * np.median(rms))
