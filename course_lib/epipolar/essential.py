"""From the essential matrix to the relative pose: four answers, and the one with points in front.

Use these functions through `course_lib.epipolar`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_intrinsics,
    check_rotation,
    check_vector,
)
from course_lib.epipolar.fundamental import common_scale
from course_lib.epipolar.lines import check_pairs
from course_lib.epipolar.matrices import (
    SAME_PLACE,
    check_two_view,
    unit,
)
from course_lib.epipolar.refinement import PosedPair, refined
from course_lib.homogeneous import to_homogeneous

#: How far from 1 the quotient of the two singular values of an essential matrix may be.
UNEQUAL = 1e-3


def poses_from_essential(E: ArrayLike) -> list[tuple[Array, Array]]:
    """Return the four relative poses that an essential matrix allows.

    Parameters
    ----------
    E : array_like, shape (3, 3)
        Essential matrix, of any scale and sign.

    Returns
    -------
    list of 4 tuples (R, t), shape (3, 3) and (3,)
        Relative poses, camera 1 to camera 2: two rotations, each with t and -t. The length of t
        is 1, as E does not know it.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong, a number is not finite, or E is no essential matrix: its singular
        values are not ``s, s, 0`` to three digits.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., result 9.19.
    """
    U, s, Vt = np.linalg.svd(unit(check_two_view(E, "E")))
    if s[0] - s[1] > UNEQUAL * s[0] or s[2] > UNEQUAL * s[0]:
        raise ValueError(
            f"E is no essential matrix: its singular values are {s.round(4).tolist()}, not "
            "s, s, 0; use essential_from_fundamental, which takes the nearest one"
        )
    U, Vt = U * np.linalg.det(U), Vt * np.linalg.det(Vt)
    W = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    t = U[:, 2]
    return [(R, s * t) for R in (U @ W @ Vt, U @ W.T @ Vt) for s in (1, -1)]


def pair_depths(
    R: ArrayLike, t: ArrayLike, points1: ArrayLike, points2: ArrayLike
) -> tuple[Array, Array]:
    """Return how far in front of both cameras pairs are, for a relative pose.

    Parameters
    ----------
    R, t : array_like, shape (3, 3) and (3,)
        Relative pose, camera 1 to camera 2, t not zero.
    points1, points2 : array_like, shape (N, 2)
        Normalised coordinates in picture 1, and of the partners in picture 2.

    Returns
    -------
    Z1, Z2 : ndarray, shape (N,)
        Depths in the unit of t; negative behind a camera, infinite where the rays are parallel.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, or `R` is not a rotation.
    DegenerateConfigurationError
        If t is zero.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 9.6.3.
    """
    R, t = check_rotation(R), check_vector(t, 3, "t")
    points1, points2 = check_pairs(points1, points2, least=1)
    if not np.abs(t).max() > 0:
        raise DegenerateConfigurationError(SAME_PLACE)
    return _depths(R, t, points1, points2)


def _depths(R: Array, t: Array, points1: Array, points2: Array) -> tuple[Array, Array]:
    # x2 ~ Z1 R x1 + t gives two equations for Z1: (a - x2 a₃) Z1 = x2 t₃ - t.
    a = to_homogeneous(points1) @ R.T
    left = a[:, :2] - points2 * a[:, 2:]
    right = points2 * t[2] - t[:2]
    with np.errstate(divide="ignore", invalid="ignore"):
        Z1 = (left * right).sum(axis=1) / (left * left).sum(axis=1)
    Z1 = np.where(np.isnan(Z1), np.inf, Z1)
    with np.errstate(invalid="ignore"):
        Z2 = Z1 * a[:, 2] + t[2]
    return Z1, np.where(np.isnan(Z2), np.inf, Z2)


def pose_from_essential(
    E: ArrayLike, points1: ArrayLike, points2: ArrayLike
) -> tuple[Array, Array]:
    """Return the relative pose that an essential matrix allows and that puts points in front.

    Parameters
    ----------
    E : array_like, shape (3, 3)
        Essential matrix, of any scale and sign.
    points1, points2 : array_like, shape (N, 2)
        Normalised coordinates in picture 1, and of the partners in picture 2. One right pair is
        enough; of many, some may be wrong.

    Returns
    -------
    R, t : ndarray, shape (3, 3) and (3,)
        Relative pose, camera 1 to camera 2, for which most points are in front of both cameras.
        The length of t is 1: pictures do not tell how large the scene is.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, or E is no essential matrix.
    DegenerateConfigurationError
        If no pose has points in front of both cameras, or two have equally many.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 9.6.3.

    Examples
    --------
    A camera that moved to the right sees a point 4 m away:

    >>> E = np.array([[0, 0, 0], [0, 0, 1], [0, -1, 0]])
    >>> R, t = pose_from_essential(E, [[0.25, 0]], [[0, 0]])
    >>> t.round(9) + 0.0
    array([-1.,  0.,  0.])
    """
    points1, points2 = check_pairs(points1, points2, least=1)
    poses = poses_from_essential(E)
    depths = [_depths(R, t, points1, points2) for R, t in poses]
    counts = [int(((Z1 > 0) & (Z2 > 0)).sum()) for Z1, Z2 in depths]
    best, second = np.argsort(counts)[::-1][:2]
    if counts[best] == counts[second]:
        raise DegenerateConfigurationError(
            f"the points do not tell which of the four poses is right: {counts[best]} of "
            f"{len(points1)} are in front of both cameras for two of them; check the pairs"
        )
    return poses[int(best)]


def refine_pose(
    R: ArrayLike,
    t: ArrayLike,
    points1: ArrayLike,
    points2: ArrayLike,
    K1: ArrayLike,
    K2: ArrayLike,
) -> tuple[Array, Array]:
    """Return the relative pose with the smallest Sampson errors, near a first guess.

    Five unknowns, as in the relative orientation of photogrammetry: the turn, and the direction
    of the baseline.

    Parameters
    ----------
    R, t : array_like, shape (3, 3) and (3,)
        First guess of the relative pose, camera 1 to camera 2, t not zero.
    points1, points2 : array_like, shape (N, 2)
        N ≥ 5 pixels of picture 1, and their partners in picture 2; all of them right pairs.
    K1, K2 : array_like, shape (3, 3)
        Intrinsics in px. Distortion must have been removed from the pixels.

    Returns
    -------
    R, t : ndarray, shape (3, 3) and (3,)
        Relative pose; the length of t is 1.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, `R` is not a rotation, intrinsics are
        none, or there are fewer than five pairs.
    DegenerateConfigurationError
        If t is zero, or the points of a picture are on a line.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 11.4.3.
    """
    R, t = check_rotation(R), check_vector(t, 3, "t")
    K1, K2 = check_intrinsics(K1), check_intrinsics(K2)
    points1, points2 = check_pairs(points1, points2, least=5)
    if not np.abs(t).max() > 0:
        raise DegenerateConfigurationError(SAME_PLACE)
    x1, x2, T1, T2, _ = common_scale(points1, points2)
    left, right = np.linalg.inv(T2 @ K2).T, np.linalg.inv(T1 @ K1)
    direction = t / np.abs(t).max()
    direction /= np.linalg.norm(direction)
    pair = refined(PosedPair(R, direction, np.asarray(left), np.asarray(right)), x1, x2)
    return pair.R, pair.t
