"""Fundamental and essential matrices of cameras that are known.

For a point seen at ``x1`` in picture 1 and at ``x2`` in picture 2, ``x2ᵀ F x1 = 0`` with pixels,
and ``x2ᵀ E x1 = 0`` with normalised coordinates ``K⁻¹ x``. The relative pose ``(R, t)`` leads from
camera 1 to camera 2. Use these functions through `course_lib.epipolar`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.camera.projection import check_finite_camera
from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_intrinsics,
    check_matrix,
    check_rotation,
    check_vector,
)
from course_lib.transforms.poses import compose, invert_pose
from course_lib.transforms.rotations import skew

#: A baseline that is rounding, as a share of the numbers it is the difference of.
NO_BASELINE = 1e-12
SAME_PLACE = (
    "the cameras are at the same place (zero baseline): pictures that differ by a rotation have no "
    "epipolar geometry; move the camera"
)


def relative_pose(
    R1: ArrayLike, t1: ArrayLike, R2: ArrayLike, t2: ArrayLike
) -> tuple[Array, Array]:
    """Return the pose that leads from camera 1 to camera 2, ``X_2 = R X_1 + t``.

    Parameters
    ----------
    R1, t1 : array_like, shape (3, 3) and (3,)
        Pose of camera 1, world to camera.
    R2, t2 : array_like, shape (3, 3) and (3,)
        Pose of camera 2, world to camera.

    Returns
    -------
    R, t : ndarray, shape (3, 3) and (3,)
        ``R = R2 R1ᵀ`` and ``t = t2 - R t1``.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or a matrix is not a rotation.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 9.6.

    Examples
    --------
    >>> relative_pose(np.eye(3), [0, 0, 5], np.eye(3), [-1, 0, 5])[1]
    array([-1.,  0.,  0.])
    """
    return compose(R2, t2, *invert_pose(R1, t1))


def essential_from_pose(R: ArrayLike, t: ArrayLike) -> Array:
    """Return the essential matrix of two cameras, ``E = [t]ₓ R``.

    Parameters
    ----------
    R, t : array_like, shape (3, 3) and (3,)
        Relative pose, camera 1 to camera 2: ``X_2 = R X_1 + t``; t not zero.

    Returns
    -------
    ndarray, shape (3, 3)
        E, for which ``x2ᵀ E x1 = 0`` in normalised coordinates. Two of its singular values are
        the length of t, the third is zero.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or `R` is not a rotation.
    DegenerateConfigurationError
        If t is zero.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 9.6.

    Examples
    --------
    A camera to the right of the other one: the same row in both pictures.

    >>> E = essential_from_pose(np.eye(3), [-1, 0, 0])
    >>> np.array([0.2, 0.3, 1]) @ E @ [0.4, 0.3, 1]
    np.float64(0.0)
    """
    R, t = check_rotation(R), check_vector(t, 3, "t")
    if not np.abs(t).max() > 0:
        raise DegenerateConfigurationError(SAME_PLACE)
    return skew(t) @ R


def transfer_and_epipole(P1: ArrayLike, P2: ArrayLike) -> tuple[Array, Array, Array, Array]:
    """Return what two camera matrices say of a ray of picture 1 seen in picture 2.

    Points on the ray of the pixel ``x1`` have the images ``λ A x1 + e`` for λ > 0, if the left
    3 × 3 blocks of the camera matrices have positive determinants.

    Parameters
    ----------
    P1, P2 : array_like, shape (3, 4)
        Camera matrices.

    Returns
    -------
    A : ndarray, shape (3, 3)
        The homography of the plane at infinity, picture 1 to picture 2.
    e : ndarray, shape (3,)
        The image of camera 1 in picture 2, homogeneous: the epipole.
    centre : ndarray, shape (3,)
        The centre of camera 1.
    back : ndarray, shape (3, 3)
        What takes ``x1`` to the direction of its ray.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or a number is not finite.
    DegenerateConfigurationError
        If a camera's centre is at infinity, or both centres are the same.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 9.2.2.
    """
    P1, P2 = check_finite_camera(P1), check_finite_camera(P2)
    inverse = np.linalg.inv(P1[:, :3])
    centre = -inverse @ P1[:, 3]
    e = P2[:, :3] @ centre + P2[:, 3]
    size = np.abs(P2[:, :3]) @ np.abs(centre) + np.abs(P2[:, 3])
    if not (np.abs(e) > NO_BASELINE * size).any():
        raise DegenerateConfigurationError(SAME_PLACE)
    return P2[:, :3] @ inverse, e, centre, np.asarray(inverse)


def fundamental_from_cameras(P1: ArrayLike, P2: ArrayLike) -> Array:
    """Return the fundamental matrix of two cameras, ``F = [e]ₓ M2 M1⁻¹`` with ``P = [M | p]``.

    Parameters
    ----------
    P1, P2 : array_like, shape (3, 4)
        Camera matrices of picture 1 and picture 2.

    Returns
    -------
    ndarray, shape (3, 3)
        F of length 1, for which ``x2ᵀ F x1 = 0``; its sign has no meaning.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or a number is not finite.
    DegenerateConfigurationError
        If a camera's centre is at infinity, or both centres are the same.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., equation 9.1.

    Examples
    --------
    >>> P1 = np.array([[800, 0, 320, 0], [0, 800, 240, 0], [0, 0, 1, 0]])
    >>> P2 = P1 - [[0, 0, 0, 800], [0, 0, 0, 0], [0, 0, 0, 0]]
    >>> F = fundamental_from_cameras(P1, P2)
    >>> abs(np.array([100, 50, 1]) @ F @ [180, 50, 1]).round(12)
    np.float64(0.0)
    """
    A, e, _, _ = transfer_and_epipole(P1, P2)
    return unit(skew(e / np.abs(e).max()) @ A)


def fundamental_from_essential(E: ArrayLike, K1: ArrayLike, K2: ArrayLike) -> Array:
    """Return the fundamental matrix for pixels, ``F = K2⁻ᵀ E K1⁻¹``.

    Parameters
    ----------
    E : array_like, shape (3, 3)
        Essential matrix, not zero.
    K1, K2 : array_like, shape (3, 3)
        Intrinsics of camera 1 and camera 2 in px.

    Returns
    -------
    ndarray, shape (3, 3)
        F of length 1.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, E is zero, or intrinsics are none.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., equation 9.12.
    """
    E, K1, K2 = check_two_view(E, "E"), check_intrinsics(K1), check_intrinsics(K2)
    return unit(np.linalg.inv(K2).T @ E @ np.linalg.inv(K1))


def essential_from_fundamental(F: ArrayLike, K1: ArrayLike, K2: ArrayLike) -> Array:
    """Return the essential matrix that is nearest to ``K2ᵀ F K1``.

    Parameters
    ----------
    F : array_like, shape (3, 3)
        Fundamental matrix, not zero.
    K1, K2 : array_like, shape (3, 3)
        Intrinsics of camera 1 and camera 2 in px.

    Returns
    -------
    ndarray, shape (3, 3)
        E with singular values 1, 1 and 0.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, F is zero, or intrinsics are none.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., equation 9.12 and section 9.6.1.
    """
    F, K1, K2 = check_two_view(F, "F"), check_intrinsics(K1), check_intrinsics(K2)
    U, _, Vt = np.linalg.svd(K2.T @ F @ K1)
    return np.asarray(U[:, :2] @ Vt[:2])


def check_two_view(F: ArrayLike, name: str = "F") -> Array:
    """Return a fundamental or essential matrix, once it is a 3 × 3 matrix that is not zero."""
    F = check_matrix(F, (3, 3), name)
    if not np.abs(F).max() > 0:
        raise ValueError(f"{name} is zero: every pair of points would satisfy it")
    return F


def unit(F: Array) -> Array:
    """Return matrices, shape (..., 3, 3), scaled so that the sum of the squares is 1."""
    F = F / np.abs(F).max(axis=(-2, -1), keepdims=True)  # squares of tiny numbers get lost
    return np.asarray(F / np.linalg.norm(F, axis=(-2, -1), keepdims=True))
