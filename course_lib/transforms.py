"""Rotations and poses: where a camera is, and which way it looks.

A pose ``(R, t)`` maps coordinates of one frame into another, ``X_a = R_ab X_b + t_ab``. A camera's
pose maps world to camera. Camera frame: x right, y down, z forward. World: z up.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_number,
    check_points,
    check_vector,
)
from course_lib.checks import check_rotation as check_rotation


def rotation_x(angle: float) -> Array:
    """Return the rotation about the x axis, which turns y towards z.

    Parameters
    ----------
    angle : float
        Angle in rad.

    Returns
    -------
    ndarray, shape (3, 3)
        The rotation matrix.

    Raises
    ------
    TypeError, ValueError
        If the angle is not one finite number.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 2.1.3.

    Examples
    --------
    >>> rotation_x(np.pi / 2).round() @ [0, 1, 0]
    array([0., 0., 1.])
    """
    angle = check_number(angle, "angle")
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def rotation_y(angle: float) -> Array:
    """Return the rotation about the y axis, which turns z towards x.

    Parameters
    ----------
    angle : float
        Angle in rad.

    Returns
    -------
    ndarray, shape (3, 3)
        The rotation matrix.

    Raises
    ------
    TypeError, ValueError
        If the angle is not one finite number.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 2.1.3.

    Examples
    --------
    >>> rotation_y(np.pi / 2).round() @ [0, 0, 1]
    array([1., 0., 0.])
    """
    angle = check_number(angle, "angle")
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def rotation_z(angle: float) -> Array:
    """Return the rotation about the z axis, which turns x towards y.

    Parameters
    ----------
    angle : float
        Angle in rad.

    Returns
    -------
    ndarray, shape (3, 3)
        The rotation matrix.

    Raises
    ------
    TypeError, ValueError
        If the angle is not one finite number.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 2.1.3.

    Examples
    --------
    >>> rotation_z(np.pi / 2).round() @ [1, 0, 0]
    array([0., 1., 0.])
    """
    angle = check_number(angle, "angle")
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def look_at(eye: ArrayLike, target: ArrayLike, up: ArrayLike = (0, 0, 1)) -> tuple[Array, Array]:
    """Return the pose of a camera at `eye` that looks at `target` and is held upright.

    Parameters
    ----------
    eye : array_like, shape (3,)
        Where the camera is, world frame.
    target : array_like, shape (3,)
        The point that appears in the principal point, world frame.
    up : array_like, shape (3,)
        The world direction that points up in the picture.

    Returns
    -------
    R, t : ndarray, shape (3, 3) and (3,)
        Pose, world to camera; t in the unit of `eye`.

    Raises
    ------
    TypeError, ValueError
        If an argument is not a finite vector of length 3.
    DegenerateConfigurationError
        If eye and target coincide, or the camera looks along `up`.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 2.1.4.

    Examples
    --------
    >>> R, t = look_at(eye=(0, -5, 0), target=(0, 0, 0))
    >>> transform_points((0, 0, 0), R, t)
    array([0., 0., 5.])
    """
    eye, target, up = (
        check_vector(v, 3, name) for v, name in ((eye, "eye"), (target, "target"), (up, "up"))
    )
    distance = np.linalg.norm(target - eye)
    if distance == 0:
        raise DegenerateConfigurationError("eye and target coincide: move one of them")
    forward = (target - eye) / distance
    right = np.cross(forward, up)
    if np.linalg.norm(right) <= 1e-9 * np.linalg.norm(up):
        raise DegenerateConfigurationError(
            "the camera looks along up, so its roll is undetermined: choose another up"
        )
    right /= np.linalg.norm(right)
    R = np.stack([right, np.cross(forward, right), forward])
    return R, -R @ eye


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
    >>> invert_pose(np.eye(3), [1, 2, 3])[1]
    array([-1., -2., -3.])
    """
    R, t = check_rotation(R), check_vector(t, 3, "t")
    return R.T, -R.T @ t


def camera_centre(R: ArrayLike, t: ArrayLike) -> Array:
    """Return where a camera is, given its pose.

    Parameters
    ----------
    R : array_like, shape (3, 3)
        Rotation, world to camera.
    t : array_like, shape (3,)
        Translation, world to camera.

    Returns
    -------
    ndarray, shape (3,)
        The centre of projection in the world frame, in the unit of `t`.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or `R` is not a rotation.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 6.1.

    Examples
    --------
    >>> camera_centre(*look_at(eye=(1, 2, 3), target=(0, 0, 0))).round(12)
    array([1., 2., 3.])
    """
    R, t = check_rotation(R), check_vector(t, 3, "t")
    return -R.T @ t
