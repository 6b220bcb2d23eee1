"""A camera from points in space and their pixels: the direct linear transformation."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, DegenerateConfigurationError
from course_lib.correspondences import check_space_pairs
from course_lib.homography import normalise_points
from course_lib.least_squares.linear import solve_homogeneous, solve_qr
from course_lib.least_squares.marquardt import levenberg_marquardt


class CameraFit(NamedTuple):
    """A camera matrix found from points, and how well it is known.

    Attributes
    ----------
    P : ndarray, shape (3, 4)
        The camera matrix, scaled as `camera_dlt` does.
    residuals : ndarray, shape (N, 2)
        Pixels where the camera sees the points, minus the measured ones.
    centre : ndarray, shape (3,)
        The centre of projection, in the unit of the points.
    centre_covariance : ndarray, shape (3, 3)
        Its covariance, judged by the residuals; the roots of the diagonal are standard deviations.
    """

    P: Array
    residuals: Array
    centre: Array
    centre_covariance: Array


def camera_dlt(points: ArrayLike, pixels: ArrayLike) -> Array:
    """Return the camera matrix that takes points of space to pixels, by the normalised DLT.

    Parameters
    ----------
    points : array_like, shape (N, 3)
        N ≥ 6 points ``(X, Y, Z)`` of the world in rows, not all in one plane.
    pixels : array_like, shape (N, 2)
        Where the camera sees them, ``(u, v)``, with errors: normalise points and pixels first.

    Returns
    -------
    ndarray, shape (3, 4)
        The camera matrix P. Its scale means nothing: any multiple is as good. (Here the third row
        gives the depth.)

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or there are fewer than six points.
    DegenerateConfigurationError
        If the points are in one plane or the pixels on one line, or more than one camera fits.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 7.1.

    Examples
    --------
    >>> from course_lib.camera import camera_matrix, project
    >>> P = camera_matrix(np.diag([800, 800, 1]), np.eye(3), [0, 0, 5])
    >>> cube = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    >>> camera_dlt(cube, project(cube, P)).round(6) + 0.0
    array([[800.,   0.,   0.,   0.],
           [  0., 800.,   0.,   0.],
           [  0.,   0.,   1.,   5.]])
    """
    points, pixels = check_space_pairs(points, pixels)
    near_points, T_points = normalise_points(points)
    near_pixels, T_pixels = normalise_points(pixels)
    X = np.concatenate([near_points, np.ones_like(points[:, :1])], axis=1)
    u, v = near_pixels[:, :1], near_pixels[:, 1:]
    zero = np.zeros_like(X)
    rows_u = np.concatenate([X, zero, -u * X], axis=1)
    rows_v = np.concatenate([zero, X, -v * X], axis=1)
    P = solve_homogeneous(np.concatenate([rows_u, rows_v])).reshape(3, 4)
    return with_depths(np.linalg.inv(T_pixels) @ P @ T_points)


def dlt_parameters(points: ArrayLike, pixels: ArrayLike) -> Array:
    """Return the eleven parameters of the DLT as photogrammetry writes them.

    ``u = (L1 X + L2 Y + L3 Z + L4) / (L9 X + L10 Y + L11 Z + 1)``, and v with L5 to L8. The last
    number of the camera matrix is set to 1, so that the equations have a right-hand side.

    Parameters
    ----------
    points : array_like, shape (N, 3)
        N ≥ 6 points of the world in rows, not all in one plane.
    pixels : array_like, shape (N, 2)
        Where the camera sees them.

    Returns
    -------
    ndarray, shape (11,)
        ``L1`` to ``L11``; ``np.append(L, 1).reshape(3, 4)`` is a camera matrix.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or there are fewer than six points.
    DegenerateConfigurationError
        If the points are in one plane or the pixels on one line, or more than one camera fits. A
        world's origin beside the camera, at depth zero, cannot have a 1 there: the numbers explode.

    References
    ----------
    Y. I. Abdel-Aziz, H. M. Karara, "Direct linear transformation from comparator coordinates into
    object space coordinates in close-range photogrammetry", 1971.

    Examples
    --------
    >>> cube = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (4, 5)])
    >>> dlt_parameters(cube, 100 * cube[:, :2] / (cube[:, 2:] + 1)).round(6) + 0.0
    array([100.,   0.,   0.,   0.,   0., 100.,   0.,   0.,   0.,   0.,   1.])
    """
    points, pixels = check_space_pairs(points, pixels)
    X = np.concatenate([points, np.ones_like(points[:, :1])], axis=1)
    u, v = pixels[:, :1], pixels[:, 1:]
    zero = np.zeros_like(X)
    rows_u = np.concatenate([X, zero, -u * points], axis=1)
    rows_v = np.concatenate([zero, X, -v * points], axis=1)
    return solve_qr(np.concatenate([rows_u, rows_v]), np.concatenate([u, v])[:, 0])


def fit_camera(points: ArrayLike, pixels: ArrayLike) -> CameraFit:
    """Return the camera matrix with the smallest reprojection error, and how sure its centre is.

    Parameters
    ----------
    points : array_like, shape (N, 3)
        N ≥ 6 points of the world in rows, not all in one plane, known exactly.
    pixels : array_like, shape (N, 2)
        Where the camera sees them, with errors.

    Returns
    -------
    CameraFit
        Camera, residuals, centre and the centre's covariance.

    Raises
    ------
    TypeError, ValueError, DegenerateConfigurationError
        As `camera_dlt`.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., algorithm 7.1.
    """
    start = camera_dlt(points, pixels)
    points, pixels = check_space_pairs(points, pixels)
    near_points, T_points = normalise_points(points)
    near_pixels, T_pixels = normalise_points(pixels)
    X = np.concatenate([near_points, np.ones_like(points[:, :1])], axis=1)
    start = T_pixels @ start @ np.linalg.inv(T_points)

    def problem(p: Array) -> tuple[Array, Array]:
        return _reprojection(p.reshape(3, 4), X, near_pixels)

    fit = levenberg_marquardt(problem, start.ravel() / np.linalg.norm(start))
    P = fit.parameters.reshape(3, 4)
    M = P[:, :3]
    centre = np.linalg.solve(M, -P[:, 3])
    # M C + p₄ = 0, so dC = -M⁻¹ dP (C, 1).
    slopes = -np.kron(np.linalg.inv(M), np.append(centre, 1))
    scale = T_points[0, 0]
    return CameraFit(
        with_depths(np.linalg.inv(T_pixels) @ P @ T_points),
        fit.residuals[:-1].reshape(-1, 2) / T_pixels[0, 0],
        (centre - T_points[:3, 3]) / scale,
        slopes @ fit.covariance @ slopes.T / scale**2,
    )


@np.errstate(divide="ignore", invalid="ignore", over="ignore")  # a point may have no image
def _reprojection(P: Array, X: Array, pixels: Array) -> tuple[Array, Array]:
    """Return residuals and their derivatives; a last row keeps the length of P at 1."""
    u, v, w = (X @ P.T).T
    seen = np.stack([u, v], axis=1) / w[:, None]
    ray, zero = X / w[:, None], np.zeros_like(X)
    rows_u = np.concatenate([ray, zero, -seen[:, :1] * ray], axis=1)
    rows_v = np.concatenate([zero, ray, -seen[:, 1:] * ray], axis=1)
    rows = np.stack([rows_u, rows_v], axis=1).reshape(-1, 12)
    residuals = np.append((seen - pixels).ravel(), (P * P).sum() - 1)
    return residuals, np.concatenate([rows, 2 * P.reshape(1, 12)])


def with_depths(P: Array) -> Array:
    """Return a camera matrix whose third row is the depth: ``K [R | t]`` of a finite camera."""
    length = np.linalg.norm(P[2, :3])
    if length <= 1e-12 * np.linalg.norm(P[2]):
        raise DegenerateConfigurationError(
            "the camera sees along parallel rays: its centre is at infinity, and there is no depth"
        )
    return np.asarray(P * (1 if np.linalg.det(P[:, :3]) > 0 else -1) / length)
