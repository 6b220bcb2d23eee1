"""Unit quaternions: four numbers for a rotation, without any place where they break down.

The order is ``(w, x, y, z)``, the real part first; the product of quaternions is Hamilton's. Use
these functions through `course_lib.transforms`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_direction, check_rotation
from course_lib.transforms.rotations import skew


def rotation_from_quaternion(quaternion: ArrayLike) -> Array:
    """Return the rotation that a quaternion stands for.

    Parameters
    ----------
    quaternion : array_like, shape (4,)
        ``(w, x, y, z)``, the real part first, of any length but zero. (SciPy's order has the
        real part last.)

    Returns
    -------
    ndarray, shape (3, 3)
        The rotation matrix; ``q`` and ``-q`` give the same.

    Raises
    ------
    TypeError, ValueError
        If the quaternion is zero or not a finite vector of length 4.

    References
    ----------
    R. Szeliski, Computer Vision, 2nd ed., section 2.1.3 (unit quaternions).

    Examples
    --------
    >>> rotation_from_quaternion([1, 0, 0, 1]).round(12) @ [1, 0, 0]
    array([0., 1., 0.])
    """
    quaternion = check_direction(quaternion, "quaternion", 4)
    w, *xyz = quaternion / np.linalg.norm(quaternion)
    k = skew(xyz)
    return np.asarray(np.eye(3) + 2 * (w * k + k @ k))


def quaternion_from_rotation(R: ArrayLike) -> Array:
    """Return the unit quaternion of a rotation.

    Parameters
    ----------
    R : array_like, shape (3, 3)
        The rotation.

    Returns
    -------
    ndarray, shape (4,)
        ``(w, x, y, z)``, the real part first and not negative. At half a turn two opposite
        quaternions have ``w = 0``; one of them is returned.

    Raises
    ------
    TypeError, ValueError
        If `R` is not a rotation.

    References
    ----------
    S. W. Shepperd, Quaternion from rotation matrix, J. Guidance and Control 1 (1978).

    Examples
    --------
    >>> quaternion_from_rotation(np.diag([-1, -1, 1])).round(12)
    array([0., 0., 0., 1.])
    """
    R = check_rotation(R)
    # The matrix 4 q qᵀ, of which each row is a multiple of q; the longest is the most accurate.
    (a, b, c), (d, e, f), (g, h, i) = R
    rows = np.array(
        [
            [1 + a + e + i, h - f, c - g, d - b],
            [h - f, 1 + a - e - i, b + d, c + g],
            [c - g, b + d, 1 - a + e - i, f + h],
            [d - b, c + g, f + h, 1 - a - e + i],
        ]
    )
    q = rows[np.argmax(np.diag(rows))]
    return np.asarray(np.copysign(1, q[0]) * q / np.linalg.norm(q))
