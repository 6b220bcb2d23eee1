"""Chapter 07 written out plainly: distortion, residuals, refinement and its judgement.

The library's functions (`course_lib.calibration`) take more coefficients and check what comes in.
The tests hold the two against each other.
"""

from __future__ import annotations

import numpy as np


def initial_distortion(ideal, observed, K):
    """Return k1 and k2 from where points should be without distortion, and where they are.

    The lens moves a pixel away from the principal point:
    ``u_observed - u_ideal = (u_ideal - cx) (k1 r² + k2 r⁴)``, and v alike. These equations are
    linear in k1 and k2: solve all of them, of u and of v, by least squares.

    Parameters
    ----------
    ideal : ndarray, shape (N, 2)
        Pixels that the camera without distortion would make.
    observed : ndarray, shape (N, 2)
        The same points as they were seen.
    K : ndarray, shape (3, 3)
        Intrinsics without skew, px. r is the distance of the ideal point from the principal point
        in normalised coordinates, ``((u - cx) / fx, (v - cy) / fy)``.

    Returns
    -------
    ndarray, shape (2,)
        ``k1, k2``.

    Examples
    --------
    >>> K = np.array([[100.0, 0, 0], [0, 100, 0], [0, 0, 1]])
    >>> ideal, observed = np.array([[100.0, 0], [0, 200]]), np.array([[90.0, 0], [0, 120]])
    >>> initial_distortion(ideal, observed, K).round(9) + 0.0
    array([-0.1,  0. ])
    """
    offset = ideal - K[:2, 2]
    x, y = offset[:, 0] / K[0, 0], offset[:, 1] / K[1, 1]
    r2 = (x**2 + y**2)[:, None]
    A = np.column_stack([(offset * r2).ravel(), (offset * r2**2).ravel()])
    return np.linalg.lstsq(A, (observed - ideal).ravel(), rcond=None)[0]


def reprojection_residuals(points, pixels, K, R, t, k):
    """Return by how much a camera misses the pixels of one view: projected minus observed.

    Parameters
    ----------
    points : ndarray, shape (N, 3)
        Points of the board, in its own frame, all of them before the camera.
    pixels : ndarray, shape (N, 2)
        Where they were observed.
    K : ndarray, shape (3, 3)
        Intrinsics in px, without skew.
    R, t : ndarray, shape (3, 3) and (3,)
        Pose, board to camera.
    k : ndarray, shape (2,)
        Radial distortion ``k1, k2``: normalised coordinates are multiplied with
        ``1 + k1 r² + k2 r⁴``.

    Returns
    -------
    ndarray, shape (N, 2)
        Residuals ``(du, dv)`` in px.

    Examples
    --------
    >>> K = np.array([[100.0, 0, 50], [0, 100, 40], [0, 0, 1]])
    >>> points, pixels = np.array([[1.0, 2, 0]]), np.array([[60.0, 59]])
    >>> reprojection_residuals(points, pixels, K, np.eye(3), np.array([0, 0, 10]), np.zeros(2))
    array([[0., 1.]])
    """
    X = points @ R.T + t
    x = X[:, :2] / X[:, 2:]
    r2 = (x**2).sum(axis=1, keepdims=True)
    x_d = x * (1 + k[0] * r2 + k[1] * r2**2)
    projected = x_d * [K[0, 0], K[1, 1]] + K[:2, 2]
    return projected - pixels


def rms_error(residuals):
    """Return the root mean square of residuals, over points: how far a typical point is off.

    Parameters
    ----------
    residuals : ndarray, shape (N, 2)
        Differences ``(du, dv)`` of N points, px.

    Returns
    -------
    float
        Root of the mean of ``du² + dv²`` over the N points, px.

    Examples
    --------
    >>> float(rms_error(np.array([[3.0, 4], [0, 0], [0, 0], [0, 0]])))
    2.5
    """
    return np.sqrt((residuals**2).sum(axis=1).mean())


def refine_calibration(parameters, residuals, J, damping):
    """Return all parameters of a calibration after one step of Levenberg and Marquardt.

    Parameters
    ----------
    parameters : ndarray, shape (n,)
        Where the step begins: camera and poses, all in one row.
    residuals : ndarray, shape (m,)
        Projected minus observed pixels there, all in one row.
    J : ndarray, shape (m, n)
        Derivatives of the residuals by the parameters.
    damping : float
        λ, which keeps the step short where the linear problem is not to be trusted.

    Returns
    -------
    ndarray, shape (n,)
        The parameters plus the step δ that solves ``(JᵀJ + λ D) δ = -Jᵀ residuals``. D is the
        matrix that has the diagonal of JᵀJ, and zeros elsewhere.

    Examples
    --------
    One parameter, and pixels that should move by 6: undamped, and with a step half as long.

    >>> J = np.array([[2.0], [2.0]])
    >>> refine_calibration(np.array([10.0]), np.array([6.0, 6.0]), J, 0)
    array([7.])
    >>> refine_calibration(np.array([10.0]), np.array([6.0, 6.0]), J, 1)
    array([8.5])
    """
    N = J.T @ J
    step = np.linalg.solve(N + damping * np.diag(np.diag(N)), -J.T @ residuals)
    return parameters + step


def reject_views(residuals, limit):
    """Return which views to keep: those whose error is not far above what is usual.

    Parameters
    ----------
    residuals : ndarray, shape (V, N, 2)
        Residuals ``(du, dv)`` of N points in each of V views, px.
    limit : float
        A view goes if its RMS error (over points, as `rms_error`) is more than so many times the
        median of the RMS errors of all views.

    Returns
    -------
    ndarray of bool, shape (V,)
        True for the views to keep.

    Examples
    --------
    >>> reject_views(np.array([[[0.3, 0]], [[0, 0.2]], [[0.9, 0]]]), 2)
    array([ True,  True, False])
    """
    rms = np.sqrt((residuals**2).sum(axis=2).mean(axis=1))
    return rms <= limit * np.median(rms)


def parameter_covariance(J, residuals):
    """Return how uncertain the parameters of a calibration are, judged by what is left over.

    Parameters
    ----------
    J : ndarray, shape (m, n)
        Derivatives of the residuals by the parameters, at the minimum.
    residuals : ndarray, shape (m,)
        What is left over there, px: m numbers, two for each point.

    Returns
    -------
    ndarray, shape (n, n)
        ``σ² (JᵀJ)⁻¹``, where σ² is the sum of the squared residuals, divided by how many more
        residuals than parameters there are. The roots of its diagonal are the standard deviations
        of the parameters.

    Examples
    --------
    The mean of four numbers, and its variance:

    >>> J, residuals = np.array([[1.0], [1], [1], [1]]), np.array([-1.0, 1, -1, 1])
    >>> parameter_covariance(J, residuals).round(4)
    array([[0.3333]])
    """
    m, n = J.shape
    variance = residuals @ residuals / (m - n)
    return variance * np.linalg.inv(J.T @ J)
