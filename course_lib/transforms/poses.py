"""Poses: a rotation and a translation that map one frame to another, composed and inverted.

A pose ``(R, t)`` maps coordinates of one frame into another, ``X_a = R_ab X_b + t_ab``; all poses
together are SE(3). Use these functions through `course_lib.transforms`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    check_matrix,
    check_points,
    check_rotation,
    check_vector,
)


def transform_points(points: ArrayLike, R: ArrayLike, t: ArrayLike) -> Array:
    """Return points in the other frame, ``X_a = R_ab X_b + t_ab``.

    Parameters
    ----------
    points : array_like, shape (N, 3) or (3,)
        Points in frame b, in rows.
    R : array_like, shape (3, 3)
        Rotation, b to a.
    t : array_like, shape (3,)
        Translation, b to a, in the unit of `points`.

    Returns
    -------
    ndarray, shape (N, 3) or (3,)
        The same points in frame a.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or `R` is not a rotation.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 6.1.

    Examples
    --------
    >>> transform_points([[1, 2, 3]], np.eye(3), [10, 0, 0])
    array([[11.,  2.,  3.]])
    """
    return check_points(points, 3, "points") @ check_rotation(R).T + check_vector(t, 3, "t")


def compose(
    R_ab: ArrayLike, t_ab: ArrayLike, R_bc: ArrayLike, t_bc: ArrayLike
) -> tuple[Array, Array]:
    """Return the pose from c to a, given those from b to a and from c to b.

    Parameters
    ----------
    R_ab, R_bc : array_like, shape (3, 3)
        Rotations b to a and c to b.
    t_ab, t_bc : array_like, shape (3,)
        Translations b to a and c to b.

    Returns
    -------
    R_ac, t_ac : ndarray, shape (3, 3) and (3,)
        Pose, c to a.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or a matrix is not a rotation.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 2.1.3.

    Examples
    --------
    >>> compose(np.eye(3), [1, 0, 0], np.eye(3), [0, 2, 0])[1]
    array([1., 2., 0.])
    """
    R_ab, R_bc = check_rotation(R_ab), check_rotation(R_bc)
    t_ab, t_bc = check_vector(t_ab, 3, "t_ab"), check_vector(t_bc, 3, "t_bc")
    return R_ab @ R_bc, R_ab @ t_bc + t_ab


def invert_pose(R: ArrayLike, t: ArrayLike) -> tuple[Array, Array]:
    """Return the pose that leads back: from a to b, given that from b to a.

    Parameters
    ----------
    R, t : array_like, shape (3, 3) and (3,)
        Pose, b to a.

    Returns
    -------
    R, t : ndarray, shape (3, 3) and (3,)
        Pose, a to b.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or `R` is not a rotation.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 2.1.3.

    Examples
    --------
    >>> invert_pose(np.eye(3), np.array([1, 2, 3]))[1]
    array([-1., -2., -3.])
    """
    R, t = check_rotation(R), check_vector(t, 3, "t")
    return R.T, -R.T @ t


def rigid_matrix(R: ArrayLike | None = None, t: ArrayLike = (0, 0, 0)) -> Array:
    """Return a pose as one 4 × 4 matrix, so that composing poses is multiplying matrices.

    Parameters
    ----------
    R : array_like, shape (3, 3), optional
        Rotation, b to a; none unless given.
    t : array_like, shape (3,)
        Translation, b to a; none unless given.

    Returns
    -------
    ndarray, shape (4, 4)
        ``[[R, t], [0, 1]]``, which maps ``(X, Y, Z, 1)`` of frame b to that of frame a.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or `R` is not a rotation.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 2.1.3.

    Examples
    --------
    >>> rigid_matrix(t=(1, 2, 3)) @ [0, 0, 0, 1]
    array([1., 2., 3., 1.])
    """
    matrix = np.eye(4)
    matrix[:3, :3] = np.eye(3) if R is None else check_rotation(R)
    matrix[:3, 3] = check_vector(t, 3, "t")
    return matrix


def pose_from_matrix(matrix: ArrayLike) -> tuple[Array, Array]:
    """Return the rotation and the translation in a 4 × 4 matrix.

    Parameters
    ----------
    matrix : array_like, shape (4, 4)
        ``[[R, t], [0, 1]]``.

    Returns
    -------
    R, t : ndarray, shape (3, 3) and (3,)
        The pose.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong, the last row is not ``(0, 0, 0, 1)`` or the 3 × 3 block is not a
        rotation (some programs keep a scale there: divide it out first).

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 2.1.3.

    Examples
    --------
    >>> pose_from_matrix(rigid_matrix(t=(1, 2, 3)))[1]
    array([1., 2., 3.])
    """
    matrix = check_matrix(matrix, (4, 4), "matrix")
    if (matrix[3] != (0, 0, 0, 1)).any():
        raise ValueError(
            f"the last row of a pose must be 0 0 0 1, got {matrix[3].tolist()}: is it transposed?"
        )
    return check_rotation(matrix[:3, :3]).copy(), matrix[:3, 3].copy()
