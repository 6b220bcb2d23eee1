"""Placing a camera: its pose from where it stands and which way it looks.

A camera's pose ``(R, t)`` maps world to camera. A placement says the opposite: where the camera's
axes and its centre are in the world. Use these functions through `course_lib.transforms`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    SMALLEST,
    Array,
    DegenerateConfigurationError,
    check_rotation,
    check_vector,
)
from course_lib.transforms.poses import invert_pose, pose_from_matrix, rigid_matrix
from course_lib.transforms.rotations import rotation_x, rotation_z


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
    >>> R = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    >>> camera_centre(R, np.array([1.0, 2, 3]))
    array([-2.,  1., -3.])
    """
    R, t = check_rotation(R), check_vector(t, 3, "t")
    return -R.T @ t


def pose_from_placement(R_camera: ArrayLike, centre: ArrayLike) -> tuple[Array, Array]:
    """Return the pose of a camera that was placed in the world.

    Parameters
    ----------
    R_camera : array_like, shape (3, 3)
        Rotation, camera to world: its columns are the camera's axes in the world.
    centre : array_like, shape (3,)
        Where the centre of projection is, world frame.

    Returns
    -------
    R, t : ndarray, shape (3, 3) and (3,)
        Pose, world to camera; t in the unit of `centre`.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or `R_camera` is not a rotation.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 6.1.

    Examples
    --------
    >>> pose_from_placement(np.eye(3), np.array([0, 0, -5]))[1]
    array([0., 0., 5.])
    """
    R, centre = check_rotation(R_camera).T, check_vector(centre, 3, "centre")
    return R, R @ -centre


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
    >>> R @ (0, 0, 0) + t
    array([0., 0., 5.])
    """
    eye, target, up = (
        check_vector(v, 3, name) for v, name in ((eye, "eye"), (target, "target"), (up, "up"))
    )
    distance = np.linalg.norm(target - eye)
    if distance < SMALLEST:
        raise DegenerateConfigurationError("eye and target coincide: move one of them")
    forward = (target - eye) / distance
    right = np.cross(forward, up)
    if np.linalg.norm(right) <= 1e-9 * np.linalg.norm(up) + SMALLEST:
        raise DegenerateConfigurationError(
            "the camera looks along up, so its roll is undetermined: choose another up"
        )
    right /= np.linalg.norm(right)
    R = np.stack([right, np.cross(forward, right), forward])
    return R, -R @ eye


def cv_from_graphics_camera(world_from_camera: ArrayLike) -> tuple[Array, Array]:
    """Return the pose of a camera that a graphics program placed.

    Blender and OpenGL have cameras with x right, y *up* and z *backwards*: they look along -z.

    Parameters
    ----------
    world_from_camera : array_like, shape (4, 4)
        The graphics camera's placement, ``[[R_camera, centre], [0, 1]]``, without scale.

    Returns
    -------
    R, t : ndarray, shape (3, 3) and (3,)
        Pose, world to camera, of the same camera with our axes (x right, y down, z forward).

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong, the last row is not ``(0, 0, 0, 1)`` or the 3 × 3 block is not a
        rotation.

    References
    ----------
    The OpenGL specification's eye coordinates; OpenCV's camera frame.

    Examples
    --------
    >>> R, t = cv_from_graphics_camera(np.eye(4))
    >>> R @ np.array([0, 0, -1])  # what the graphics camera looks at is ahead of ours
    array([0., 0., 1.])
    """
    R_graphics, centre = pose_from_matrix(world_from_camera)
    graphics_from_cv = np.diag([1, -1, -1])
    R = (R_graphics @ graphics_from_cv).T
    return R, R @ -centre


def gimbal_pose(
    pan: float, tilt: float, mount: ArrayLike, offset: ArrayLike
) -> tuple[Array, Array]:
    """Return the pose of a camera on a gimbal, which pans about the vertical and then tilts.

    At pan = tilt = 0 the camera is upright and level and looks along the world's y axis, its x
    axis along the world's x.

    Parameters
    ----------
    pan : float
        Angle about the world's z axis in rad; positive to the left (counter-clockwise from above).
    tilt : float
        Angle about the camera's x axis in rad; positive looks up.
    mount : array_like, shape (3,)
        Where the two axes cross, world frame.
    offset : array_like, shape (3,)
        The centre of projection seen from there, along the camera's axes (right, down, forward).

    Returns
    -------
    R, t : ndarray, shape (3, 3) and (3,)
        Pose, world to camera.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or a number is not finite.

    References
    ----------
    R. Gonzalez and R. Woods, Digital Image Processing (1992), section 2.5 (camera model).

    Examples
    --------
    >>> R, t = gimbal_pose(0, np.pi / 2, mount=np.zeros(3), offset=np.zeros(3))
    >>> R.T[:, 2].round()  # its z axis points to the zenith
    array([0., 0., 1.])
    """
    level = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])  # the camera's axes at rest, as columns
    world_from_camera = (
        rigid_matrix(t=mount)
        @ rigid_matrix(rotation_z(pan))
        @ rigid_matrix(rotation_x(tilt))
        @ rigid_matrix(level)
        @ rigid_matrix(t=offset)
    )
    return invert_pose(*pose_from_matrix(world_from_camera))
