"""Rectification: turning both pictures so that partners lie in the same row.

Use these functions through `course_lib.epipolar`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_intrinsics,
    check_rotation,
    check_size,
    check_vector,
)
from course_lib.epipolar.lines import check_pairs, homogeneous_epipole
from course_lib.epipolar.matrices import SAME_PLACE, check_two_view, unit
from course_lib.homogeneous import apply_homography, to_homogeneous
from course_lib.least_squares.linear import solve_qr
from course_lib.transforms.rotations import skew

INSIDE = (
    "an epipole is in the picture (one camera is in front of the other): no turn makes all "
    "epipolar lines parallel; move the camera sideways, or use polar rectification"
)


@dataclass(frozen=True, eq=False)
class Rectification:
    """Two cameras turned about their centres until they look the same way, square to the baseline.

    Attributes
    ----------
    H1, H2 : ndarray, shape (3, 3)
        Homographies that take the pixels of each picture (without distortion) to the rectified one.
    K : ndarray, shape (3, 3)
        Intrinsics of both rectified cameras in px.
    R1, R2 : ndarray, shape (3, 3)
        Rotations from each camera to its rectified one.
    t : ndarray, shape (3,)
        From the first rectified camera to the second one: ``(∓b, 0, 0)`` with the baseline b.
    """

    H1: Array
    H2: Array
    K: Array
    R1: Array
    R2: Array
    t: Array

    @property
    def baseline(self) -> float:
        """The distance of the cameras, in the unit of t."""
        return float(np.abs(self.t[0]))

    @property
    def cameras(self) -> tuple[Array, Array]:
        """Camera matrices of both rectified cameras, in the frame of the first one, (3, 4)."""
        P1 = self.K @ np.eye(3, 4)
        P2 = P1.copy()
        P2[:, 3] = self.K @ self.t
        return P1, P2


def rectify(
    K1: ArrayLike, K2: ArrayLike, R: ArrayLike, t: ArrayLike, K: ArrayLike | None = None
) -> Rectification:
    """Return how to rectify the pictures of two calibrated cameras.

    The x axis of the rectified cameras is the baseline, the way that keeps x pointing to the right
    in camera 1; z is as near as that allows to the mean of both viewing directions.

    Parameters
    ----------
    K1, K2 : array_like, shape (3, 3)
        Intrinsics in px.
    R, t : array_like, shape (3, 3) and (3,)
        Relative pose, camera 1 to camera 2; t not zero.
    K : array_like, shape (3, 3), optional
        Intrinsics of both rectified cameras; the mean of K1 and K2, without skew, unless given.

    Returns
    -------
    Rectification
        Homographies and cameras. A point in the row v of one rectified picture is in the row v of
        the other one.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, `R` is not a rotation or intrinsics are none.
    DegenerateConfigurationError
        If t is zero, or the baseline lies along the viewing direction.

    References
    ----------
    A. Fusiello, E. Trucco & A. Verri, "A compact algorithm for rectification of stereo pairs",
    Machine Vision and Applications 12 (2000).

    Examples
    --------
    >>> pair = rectify(np.diag([800, 800, 1]), np.diag([800, 800, 1]), np.eye(3), [-1, 0, 0])
    >>> pair.H1 + 0.0
    array([[1., 0., 0.],
           [0., 1., 0.],
           [0., 0., 1.]])
    """
    K1, K2 = check_intrinsics(K1), check_intrinsics(K2)
    R, t = check_rotation(R), check_vector(t, 3, "t")
    new = _mean_intrinsics(K1, K2) if K is None else check_intrinsics(K)
    length = np.abs(t).max()
    if not length > 0:
        raise DegenerateConfigurationError(SAME_PLACE)
    R1 = _towards_baseline(R.T @ (t / length), np.array([0, 0, 1.0]) + R[2])
    R2 = R1 @ R.T
    return Rectification(
        _scaled(new @ R1 @ np.linalg.inv(K1)),
        _scaled(new @ R2 @ np.linalg.inv(K2)),
        new,
        R1,
        R2,
        R2 @ t,
    )


def _mean_intrinsics(K1: Array, K2: Array) -> Array:
    """Return the mean of both, without skew."""
    K = (K1 + K2) / 2
    K[0, 1] = 0
    return np.asarray(K)


def _towards_baseline(towards: Array, forward: Array) -> Array:
    """Return the rotation to a frame with x along the baseline and z nearly forward."""
    x = towards / np.linalg.norm(towards)
    x = -x if x[0] < 0 else x
    y = np.cross(forward, x)
    if np.linalg.norm(y) <= 1e-6 * np.linalg.norm(forward):
        raise DegenerateConfigurationError(INSIDE)
    y /= np.linalg.norm(y)
    return np.stack([x, y, np.cross(x, y)])


def _scaled(H: Array) -> Array:
    """Return a homography with a positive determinant, and 1 in the corner if it can be."""
    return np.asarray(H / (H[2, 2] if abs(H[2, 2]) > 1e-12 * np.abs(H).max() else np.abs(H).max()))


def rectify_uncalibrated(
    F: ArrayLike, points1: ArrayLike, points2: ArrayLike, image_size: tuple[int, int]
) -> tuple[Array, Array]:
    """Return homographies that rectify two pictures without intrinsics.

    Picture 2 is turned and bent until its epipole is infinitely far to the side; of all
    homographies of picture 1 that fit, the one is taken that leaves the least disparities. Right
    angles and relative depths are lost.

    Parameters
    ----------
    F : array_like, shape (3, 3)
        Fundamental matrix, of rank 2.
    points1, points2 : array_like, shape (N, 2)
        N ≥ 3 pixels of picture 1, and their partners in picture 2; all of them right pairs.
    image_size : tuple of int
        Width and height of both pictures in px.

    Returns
    -------
    H1, H2 : ndarray, shape (3, 3)
        Homographies to the rectified pictures: partners get the same row.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, F is zero, or there are too few pairs.
    DegenerateConfigurationError
        If an epipole is in the picture, F has rank 1, or the points are on a line.

    References
    ----------
    R. Hartley, "Theory and practice of projective rectification", IJCV 35 (1999); Hartley &
    Zisserman, Multiple View Geometry, 2nd ed., section 11.12.
    """
    points1, points2 = check_pairs(points1, points2, least=3)
    F = unit(check_two_view(F))
    size = check_size(image_size, "image_size")
    e1, e2 = homogeneous_epipole(F), homogeneous_epipole(F.T)
    for e in (e1, e2):
        u, v = e[:2] + 0.5 * e[2]
        if 0 <= u <= size[0] * e[2] and 0 <= v <= size[1] * e[2]:
            raise DegenerateConfigurationError(INSIDE)
    H2 = _epipole_to_side(e2, (size - 1) / 2)
    # All homographies that fit are H2 M and what shifts and stretches rows: M = [e]ₓ F + e vᵀ.
    M = skew(e2) @ F + np.outer(e2, np.ones(3))
    H0 = H2 @ M
    near1, near2 = apply_homography(points1, H0), apply_homography(points2, H2)
    stretch = np.eye(3)
    stretch[0] = solve_qr(to_homogeneous(near1), near2[:, 0])
    return _scaled(stretch @ H0), _scaled(H2)


def _epipole_to_side(e: Array, centre: Array) -> Array:
    """Return the homography that takes an epipole to ``(1, 0, 0)`` and hardly moves the centre."""
    shift = np.eye(3)
    shift[:2, 2] = -centre
    u, v, w = shift @ e
    r = np.hypot(u, v) * (1 if u >= 0 else -1)
    turn = np.array([[u / r, v / r, 0], [-v / r, u / r, 0], [0, 0, 1]])
    bend = np.eye(3)
    bend[2, 0] = -w / r
    return np.asarray(np.linalg.inv(shift) @ bend @ turn @ shift)
