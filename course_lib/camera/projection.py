"""The camera matrix: world points to pixels, pixels to rays, and a matrix back to its parts.

``P = K [R | t]`` is the whole camera in twelve numbers, of which the scale means nothing. The pose
``(R, t)`` maps world to camera. Use these functions through `course_lib.camera`.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    SMALLEST,
    Array,
    DegenerateConfigurationError,
    check_intrinsics,
    check_matrix,
    check_points,
    check_rotation,
    check_vector,
)


def camera_matrix(K: ArrayLike, R: ArrayLike, t: ArrayLike) -> Array:
    """Return the camera matrix, ``P = K [R | t]``.

    Parameters
    ----------
    K : array_like, shape (3, 3)
        Intrinsics in px.
    R : array_like, shape (3, 3)
        Rotation, world to camera.
    t : array_like, shape (3,)
        Translation, world to camera.

    Returns
    -------
    ndarray, shape (3, 4)
        The camera matrix ``P``; it maps ``(X, Y, Z, 1)`` to ``w (u, v, 1)``, where ``w`` is the
        depth in front of the camera.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, `K` is not upper triangular with positive
        focal lengths, or `R` is not a rotation.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., equation 6.8.

    Examples
    --------
    >>> camera_matrix(np.diag([800, 800, 1]), np.eye(3), np.array([0, 0, 5]))
    array([[800.,   0.,   0.,   0.],
           [  0., 800.,   0.,   0.],
           [  0.,   0.,   1.,   5.]])
    """
    K, R, t = check_intrinsics(K), check_rotation(R), check_vector(t, 3, "t")
    return K @ np.column_stack([R, t])


def project(points: ArrayLike, P: ArrayLike) -> Array:
    """Return the image of world points.

    Parameters
    ----------
    points : array_like, shape (N, 3) or (3,)
        Points in the world frame, in rows, in the unit of the camera's pose.
    P : array_like, shape (3, 4)
        Camera matrix. Any multiple of it, also a negative one, is the same camera.

    Returns
    -------
    ndarray, shape (N, 2) or (2,)
        Pixels ``(u, v)``; a row of NaN for a point that is not in front of the camera.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or a number is not finite.
    DegenerateConfigurationError
        If the left 3 × 3 block of `P` is singular: the camera's centre is at infinity.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., sections 6.1 and 6.2.3 (depth).

    Examples
    --------
    >>> P = np.array([[800, 0, 0, 0], [0, 800, 0, 0], [0, 0, 1, 5]])
    >>> project(np.array([[1, 0, 5], [0, 0, -9]]), P)
    array([[80.,  0.],
           [nan, nan]])
    """
    points, P = check_points(points, 3, "points"), check_finite_camera(P)
    P = P if np.linalg.det(P[:, :3]) > 0 else -P  # so that depths in front are positive
    # One row for each coordinate of all points: whole rows are quick to divide.
    x = P[:, :3] @ points.reshape(-1, 3).T
    x += P[:, 3:]
    x[2, x[2] <= 0] = np.nan
    pixels = np.empty((x.shape[1], 2))
    np.divide(x[:2], x[2], out=pixels.T)
    return pixels.reshape(*points.shape[:-1], 2)


def pixel_ray(pixels: ArrayLike, K: ArrayLike, R: ArrayLike, t: ArrayLike) -> tuple[Array, Array]:
    """Return the rays of light that reach pixels: where they all meet, and their directions.

    Parameters
    ----------
    pixels : array_like, shape (N, 2) or (2,)
        Pixels ``(u, v)``, in rows.
    K : array_like, shape (3, 3)
        Intrinsics in px; the skew need not be zero.
    R : array_like, shape (3, 3)
        Rotation, world to camera.
    t : array_like, shape (3,)
        Translation, world to camera.

    Returns
    -------
    centre : ndarray, shape (3,)
        The centre of projection in the world frame, where every ray begins.
    directions : ndarray, shape (N, 3) or (3,)
        Unit vectors in the world frame that point from the centre to what the pixels see.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, `K` is not upper triangular with positive
        focal lengths, or `R` is not a rotation.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 6.2.2.

    Examples
    --------
    >>> K, R, t = np.diag([800, 800, 1]), np.eye(3), np.array([0, 0, 5])
    >>> centre, directions = pixel_ray(np.array([0, 0]), K, R, t)
    >>> centre, directions
    (array([ 0.,  0., -5.]), array([0., 0., 1.]))
    """
    pixels, K = check_points(pixels, 2, "pixels"), check_intrinsics(K)
    R, t = check_rotation(R), check_vector(t, 3, "t")
    homogeneous = np.concatenate([pixels, np.ones_like(pixels[..., :1])], axis=-1)
    directions = homogeneous @ np.linalg.inv(K).T @ R  # Rᵀ K⁻¹ (u, v, 1), in rows
    return -R.T @ t, directions / np.linalg.norm(directions, axis=-1, keepdims=True)


def decompose_projection(P: ArrayLike) -> tuple[Array, Array, Array]:
    """Take a camera matrix apart.

    Parameters
    ----------
    P : array_like, shape (3, 4)
        Camera matrix, of any scale and sign.

    Returns
    -------
    K : ndarray, shape (3, 3)
        Intrinsics in px, with positive focal lengths and ``K[2, 2] = 1``.
    R : ndarray, shape (3, 3)
        Rotation, world to camera.
    centre : ndarray, shape (3,)
        The centre of projection in the world frame; ``t = -R @ centre``.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong or a number is not finite.
    DegenerateConfigurationError
        If the left 3 × 3 block is singular: the camera's centre is at infinity.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 6.2.4 (example 6.2).

    Examples
    --------
    >>> from course_lib.camera import camera_matrix
    >>> P = camera_matrix(np.diag([800, 800, 1]), np.eye(3), [1, 2, 5])
    >>> K, R, centre = decompose_projection(-3 * P)
    >>> centre
    array([-1., -2., -5.])
    """
    P = check_finite_camera(P)
    M = P[:, :3] * np.sign(np.linalg.det(P[:, :3]))  # so that R does not mirror
    # RQ by QR: turn the rows and columns of M upside down, so that "lower" becomes "upper".
    Q, U = np.linalg.qr(M[::-1].T)
    K, R = U.T[::-1, ::-1], Q.T[::-1]
    signs = np.sign(np.diag(K))
    K, R = K * signs, signs[:, None] * R
    return np.asarray(K / K[2, 2]), R, np.asarray(np.linalg.solve(P[:, :3], -P[:, 3]))


def check_finite_camera(P: ArrayLike) -> Array:
    """Return `P`, once the centre of its camera is sure to be finite.

    Parameters
    ----------
    P : array_like, shape (3, 4)
        The matrix in question.

    Returns
    -------
    ndarray, shape (3, 4)
        The same camera, scaled so that the largest number is about 1.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong or a number is not finite.
    DegenerateConfigurationError
        If the left 3 × 3 block is singular.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 6.2.3.
    """
    P = check_matrix(P, (3, 4), "P")
    # By a power of two, so that no digit changes.
    P = np.asarray(np.ldexp(P, -np.frexp(np.abs(P).max())[1]))
    # The determinant of unit rows: 1 where they are perpendicular, 0 where they lie in a plane.
    # Nine plain numbers are quicker than arrays of them.
    (a, b, c), (d, e, f), (g, h, i) = P[:, :3].tolist()
    lengths = math.hypot(a, b, c), math.hypot(d, e, f), math.hypot(g, h, i)
    determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    if min(lengths) <= SMALLEST or abs(determinant) < 1e-12 * math.prod(lengths):
        raise DegenerateConfigurationError(
            "the left 3 × 3 block of P is singular, so the camera's centre is at infinity: "
            "check the rows of P, or use a parallel projection"
        )
    return P
