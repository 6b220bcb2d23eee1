"""Rotation matrices: about the axes of the frame, and about any axis.

A rotation matrix is in SO(3): its rows are perpendicular, of length 1, and right-handed. A
positive angle turns counter-clockwise when the axis points at you. Use these functions through
`course_lib.transforms`.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    check_direction,
    check_number,
    check_vector,
)


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


def skew(v: ArrayLike) -> Array:
    """Return the matrix that multiplies like a cross product, ``skew(v) @ x = v × x``.

    Parameters
    ----------
    v : array_like, shape (3,)
        The left factor.

    Returns
    -------
    ndarray, shape (3, 3)
        Skew-symmetric, often written ``[v]ₓ``.

    Raises
    ------
    TypeError, ValueError
        If `v` is not a finite vector of length 3.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section A4.3.

    Examples
    --------
    >>> skew([1, 0, 0]) @ [0, 1, 0]
    array([0., 0., 1.])
    """
    x, y, z = check_vector(v, 3, "v")
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def rotation_about_axis(axis: ArrayLike, angle: float) -> Array:
    """Return the rotation about an axis through the origin (Rodrigues' formula).

    Parameters
    ----------
    axis : array_like, shape (3,)
        Direction of the axis, of any length but zero.
    angle : float
        Angle in rad; positive counter-clockwise when the axis points at you.

    Returns
    -------
    ndarray, shape (3, 3)
        The rotation matrix.

    Raises
    ------
    TypeError, ValueError
        If the axis is zero or not a vector of length 3, or a number is not finite.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 2.1.3 (axis and angle).

    Examples
    --------
    >>> rotation_about_axis(np.array([0, 0, 2]), np.pi / 2).round() @ np.array([1, 0, 0])
    array([0., 1., 0.])
    """
    axis, angle = check_direction(axis, "axis"), check_number(angle, "angle")
    k = skew(axis / np.linalg.norm(axis))
    return np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * k @ k
