"""Three angles for a rotation: Euler angles, and photogrammetry's omega, phi, kappa.

Three angles always fail somewhere: where the second turns the third axis onto the first (gimbal
lock), one rotation has many triples of angles. Use these functions through
`course_lib.transforms`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_number,
    check_rotation,
    check_vector,
)
from course_lib.transforms.rotations import rotation_x, rotation_y, rotation_z

ROTATIONS = {"x": rotation_x, "y": rotation_y, "z": rotation_z}
#: Orders of three different axes, and the sign of the permutation.
ORDERS = {"xyz": 1, "yzx": 1, "zxy": 1, "xzy": -1, "yxz": -1, "zyx": -1}
#: The image axes of photogrammetry (x right, y up, looking along -z), seen from the course's.
CV_FROM_PHOTOGRAMMETRIC = np.diag([1.0, -1.0, -1.0])


def rotation_from_euler(angles: ArrayLike, order: str = "zyx") -> Array:
    """Return the rotation by three angles about three axes of the turning frame, one after another.

    ``order="zyx"`` is ``rotation_z(a) @ rotation_y(b) @ rotation_x(c)``: yaw, pitch and roll. Each
    turn is about an axis that the turns before it have moved; read from right to left, the same
    product turns about the axes that stay.

    Parameters
    ----------
    angles : array_like, shape (3,)
        Angles in rad, in the order of `order`.
    order : str
        Three different axes out of ``"xyz"``.

    Returns
    -------
    ndarray, shape (3, 3)
        The rotation matrix.

    Raises
    ------
    TypeError, ValueError
        If `angles` is not a finite vector of length 3, or there is no such order.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 2.1.3 (Euler angles).

    Examples
    --------
    >>> rotation_from_euler([np.pi / 2, 0, 0]).round() @ [1, 0, 0]
    array([0., 1., 0.])
    """
    first, second, third = list(_check_order(order))
    a, b, c = check_vector(angles, 3, "angles")
    return np.asarray(ROTATIONS[first](a) @ ROTATIONS[second](b) @ ROTATIONS[third](c))


def euler_from_rotation(R: ArrayLike, order: str = "zyx") -> Array:
    """Return three angles for a rotation.

    Parameters
    ----------
    R : array_like, shape (3, 3)
        The rotation.
    order : str
        As in `rotation_from_euler`.

    Returns
    -------
    ndarray, shape (3,)
        Angles in rad; the second is from -π/2 to π/2, the others from -π to π.

    Raises
    ------
    TypeError, ValueError
        If `R` is not a rotation, or there is no such order.
    DegenerateConfigurationError
        In gimbal lock: the second angle is ±π/2 (to 1e-9), and only the sum or the difference of
        the other two is determined.

    References
    ----------
    M. D. Shuster and F. L. Markley, General formula for extracting the Euler angles, J. Guidance,
    Control, and Dynamics 29 (2006).

    Examples
    --------
    >>> euler_from_rotation(rotation_from_euler([0.1, 0.2, 0.3]))
    array([0.1, 0.2, 0.3])
    """
    i, j, k = ("xyz".index(axis) for axis in _check_order(order))
    R, sign = check_rotation(R), ORDERS[order]
    if np.hypot(R[i, i], R[i, j]) < 1e-9:
        raise DegenerateConfigurationError(
            f"gimbal lock: the turn about {order[1]} is a quarter turn, so the turns about "
            f"{order[0]} and {order[2]} cannot be told apart: use vector_from_rotation or "
            "another order"
        )
    a = np.arctan2(-sign * R[j, k], R[k, k])
    rest = ROTATIONS[order[0]](a).T @ R  # taking the first turn back keeps the others accurate
    b = np.arctan2(sign * rest[i, k], rest[k, k])
    c = np.arctan2(sign * rest[j, i], rest[j, j])
    return np.array([a, b, c])


def rotation_from_omega_phi_kappa(omega: float, phi: float, kappa: float) -> Array:
    """Return a camera's rotation, given its three angles of photogrammetry.

    Photogrammetry has image axes x right, y up, z towards the photographer, and turns them out of
    the world's axes: first omega about x, then phi about the new y, then kappa about the newest
    z. With three zeros the camera looks straight down and north (world y) is up in the picture.

    Parameters
    ----------
    omega, phi, kappa : float
        Angles in rad about x, y and z.

    Returns
    -------
    ndarray, shape (3, 3)
        Rotation, world to camera, in the course's camera frame (x right, y down, z forward).

    Raises
    ------
    TypeError, ValueError
        If an angle is not one finite number.

    References
    ----------
    K. Kraus, Photogrammetry, 2nd ed., section 2.1 (rotation of the image, world from image).

    Examples
    --------
    >>> rotation_from_omega_phi_kappa(0, 0, 0) @ [0, 0, -1]  # down in the world is ahead
    array([0., 0., 1.])
    """
    angles = (omega, "omega"), (phi, "phi"), (kappa, "kappa")
    world_from_image = rotation_from_euler([check_number(a, name) for a, name in angles], "xyz")
    return CV_FROM_PHOTOGRAMMETRIC @ world_from_image.T


def omega_phi_kappa_from_rotation(R: ArrayLike) -> Array:
    """Return the three angles of photogrammetry of a camera.

    Parameters
    ----------
    R : array_like, shape (3, 3)
        Rotation, world to camera, in the course's camera frame.

    Returns
    -------
    ndarray, shape (3,)
        omega, phi and kappa in rad; phi is from -π/2 to π/2, the others from -π to π.

    Raises
    ------
    TypeError, ValueError
        If `R` is not a rotation.
    DegenerateConfigurationError
        In gimbal lock: phi is ±π/2, the camera looks along the world's x axis.

    References
    ----------
    K. Kraus, Photogrammetry, 2nd ed., section 2.1.

    Examples
    --------
    >>> omega_phi_kappa_from_rotation(rotation_from_omega_phi_kappa(0.1, 0.2, 0.3))
    array([0.1, 0.2, 0.3])
    """
    world_from_image = (CV_FROM_PHOTOGRAMMETRIC @ check_rotation(R)).T
    return euler_from_rotation(world_from_image, "xyz")


def _check_order(order: str) -> str:
    if order not in ORDERS:
        raise ValueError(f"order must be one of {', '.join(ORDERS)}, got {order!r}")
    return order
