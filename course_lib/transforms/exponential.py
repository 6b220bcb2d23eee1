"""The exponential and the logarithm of rotations, SO(3), and of poses, SE(3).

A vector along the axis of a rotation, as long as its angle, is three numbers without a condition
between them: what an adjustment can change freely. Use these functions through
`course_lib.transforms`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import SMALLEST, Array, check_vector
from course_lib.transforms.quaternions import quaternion_from_rotation
from course_lib.transforms.rotations import rotation_about_axis, skew


def rotation_from_vector(vector: ArrayLike) -> Array:
    """Return the rotation whose axis and angle are the direction and length of a vector.

    It is the exponential of SO(3), ``exp([v]ₓ)``, and OpenCV's ``rvec``.

    Parameters
    ----------
    vector : array_like, shape (3,)
        Along the axis, as long as the angle in rad. Zero means no rotation.

    Returns
    -------
    ndarray, shape (3, 3)
        The rotation matrix.

    Raises
    ------
    TypeError, ValueError
        If `vector` is not a finite vector of length 3.

    References
    ----------
    T. Barfoot, State Estimation for Robotics, section 7.1 (exponential map).

    Examples
    --------
    >>> rotation_from_vector([0, 0, np.pi / 2]).round() @ [1, 0, 0]
    array([0., 1., 0.])
    """
    vector = check_vector(vector, 3, "vector")
    angle = float(np.linalg.norm(vector))
    return rotation_about_axis(vector, angle) if angle > 2 * SMALLEST else np.eye(3)


def vector_from_rotation(R: ArrayLike) -> Array:
    """Return the axis of a rotation, as long as its angle: the logarithm of SO(3).

    Parameters
    ----------
    R : array_like, shape (3, 3)
        The rotation.

    Returns
    -------
    ndarray, shape (3,)
        Along the axis, of length 0 to π rad. At π two opposite vectors are the same rotation;
        one of them is returned.

    Raises
    ------
    TypeError, ValueError
        If `R` is not a rotation.

    References
    ----------
    T. Barfoot, State Estimation for Robotics, section 7.1 (logarithmic map).

    Examples
    --------
    >>> vector_from_rotation(rotation_about_axis((1, 0, 0), 0.25))
    array([0.25, 0.  , 0.  ])
    """
    w, *xyz = quaternion_from_rotation(R)
    s = np.linalg.norm(xyz)  # w = cos(angle / 2), s = sin(angle / 2)
    if s == 0:
        return np.zeros(3)
    return np.asarray(2 * np.arctan2(s, w) / s * np.array(xyz))


def pose_from_twist(vector: ArrayLike, velocity: ArrayLike) -> tuple[Array, Array]:
    """Return the pose that a twist leads to: the exponential of SE(3).

    A body that turns with the angular velocity `vector` while its origin moves with `velocity`,
    both in its own frame, is there after one unit of time: it runs along a screw.

    Parameters
    ----------
    vector : array_like, shape (3,)
        Along the axis, as long as the angle in rad.
    velocity : array_like, shape (3,)
        Velocity of the origin, in units of length.

    Returns
    -------
    R, t : ndarray, shape (3, 3) and (3,)
        The pose; t is not `velocity` unless nothing turns or the motion is along the axis.

    Raises
    ------
    TypeError, ValueError
        If an argument is not a finite vector of length 3.

    References
    ----------
    T. Barfoot, State Estimation for Robotics, section 7.1 (poses).

    Examples
    --------
    >>> pose_from_twist([0, 0, np.pi], [np.pi, 0, 0])[1].round(12)  # half a circle of radius 1
    array([0., 2., 0.])
    """
    vector, velocity = check_vector(vector, 3, "vector"), check_vector(velocity, 3, "velocity")
    return rotation_from_vector(vector), _average_rotation(vector) @ velocity


def twist_from_pose(R: ArrayLike, t: ArrayLike) -> tuple[Array, Array]:
    """Return the twist that leads to a pose: the logarithm of SE(3).

    Parameters
    ----------
    R, t : array_like, shape (3, 3) and (3,)
        The pose.

    Returns
    -------
    vector, velocity : ndarray, shape (3,)
        As `pose_from_twist` takes them; the vector is at most π long.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or `R` is not a rotation.

    References
    ----------
    T. Barfoot, State Estimation for Robotics, section 7.1 (poses).

    Examples
    --------
    >>> twist_from_pose(np.eye(3), [1, 2, 3])
    (array([0., 0., 0.]), array([1., 2., 3.]))
    """
    vector, t = vector_from_rotation(R), check_vector(t, 3, "t")
    return vector, np.asarray(np.linalg.solve(_average_rotation(vector), t))


def _average_rotation(vector: Array) -> Array:
    """Return the mean of exp(s [v]ₓ) for s from 0 to 1, the left Jacobian of SO(3)."""
    angle = np.linalg.norm(vector)
    k = skew(vector)
    # (1 - cos a) / a² without its cancellation, and (a - sin a) / a³ with its limit at 0.
    first = 0.5 * np.sinc(angle / (2 * np.pi)) ** 2
    second = (angle - np.sin(angle)) / angle**3 if angle > 1e-4 else 1 / 6
    return np.asarray(np.eye(3) + first * k + second * k @ k)
