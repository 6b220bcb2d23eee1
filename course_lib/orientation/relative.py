"""Relative orientation as photogrammetry does it: one picture of a pair placed by the other.

Two nearly parallel pictures, taken side by side: the first stays, the second is turned by omega,
phi and kappa and its centre moves across the base, until corresponding rays meet. Five numbers;
the length of the base stays open.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_intrinsics,
    check_rotation,
    check_vector,
)
from course_lib.correspondences import check_correspondences
from course_lib.epipolar.lines import sampson_residuals
from course_lib.homogeneous import to_homogeneous
from course_lib.least_squares import levenberg_marquardt
from course_lib.transforms.euler import (
    CV_FROM_PHOTOGRAMMETRIC,
    omega_phi_kappa_from_rotation,
    rotation_from_omega_phi_kappa,
)

#: A number that changes the residuals by a smaller share than others do is open.
UNFELT = 1e-7


class RelativeOrientation(NamedTuple):
    """The second picture of a pair, placed by the first.

    Attributes
    ----------
    base : ndarray, shape (3,)
        Second centre in the image axes of the first (x right, y up, z backwards), ``(1, by, bz)``.
    angles : ndarray, shape (3,)
        omega, phi, kappa of the second picture in the axes of the first, rad.
    sigma : ndarray, shape (5,)
        Standard deviations of ``by, bz, omega, phi, kappa``, judged by the residuals.
    residuals : ndarray, shape (N,)
        By how much both pixels together have to move until their rays meet (Sampson error), px.
    """

    base: Array
    angles: Array
    sigma: Array
    residuals: Array

    @property
    def pose(self) -> tuple[Array, Array]:
        """R and t of the course, first camera to second, ``X₂ = R X₁ + t``, base along x 1."""
        return pose_from_relative(self.base, self.angles)


def pose_from_relative(base: ArrayLike, angles: ArrayLike) -> tuple[Array, Array]:
    """Return the pose, first camera to second, of a relative orientation.

    Parameters
    ----------
    base : array_like, shape (3,)
        Second centre in the image axes of the first: x right, y up, z backwards.
    angles : array_like, shape (3,)
        omega, phi, kappa of the second in those axes, rad.

    Returns
    -------
    R, t : ndarray, shape (3, 3) and (3,)
        ``X₂ = R X₁ + t`` between the camera frames of the course.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or a number is not finite.

    References
    ----------
    K. Kraus, Photogrammetry, 2nd ed., section 4.3 (relative orientation).

    Examples
    --------
    >>> pose_from_relative([1, 0, 0], [0, 0, 0])[1] + 0.0
    array([-1.,  0.,  0.])
    """
    base, angles = check_vector(base, 3, "base"), check_vector(angles, 3, "angles")
    second = rotation_from_omega_phi_kappa(*angles.tolist())
    return second @ CV_FROM_PHOTOGRAMMETRIC, -second @ base


def relative_from_pose(R: ArrayLike, t: ArrayLike) -> tuple[Array, Array]:
    """Return base and angles of a pose, first camera to second: `pose_from_relative` backwards.

    Parameters
    ----------
    R, t : array_like, shape (3, 3) and (3,)
        ``X₂ = R X₁ + t``.

    Returns
    -------
    base, angles : ndarray, shape (3,)
        As `pose_from_relative` takes them; the base in the unit of `t`.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite or `R` is no rotation.
    DegenerateConfigurationError
        In gimbal lock: phi is ±π/2.
    """
    R, t = check_rotation(R), check_vector(t, 3, "t")
    second = R @ CV_FROM_PHOTOGRAMMETRIC
    return -second.T @ t, omega_phi_kappa_from_rotation(second)


def relative_orientation(
    first: ArrayLike, second: ArrayLike, K: ArrayLike, K_second: ArrayLike | None = None
) -> RelativeOrientation:
    """Return the relative orientation of two nearly parallel pictures taken side by side.

    Parameters
    ----------
    first, second : array_like, shape (N, 2)
        N ≥ 6 pairs of pixels, freed from distortion.
    K, K_second : array_like, shape (3, 3)
        Intrinsics of the first camera, and of the second if they are others.

    Returns
    -------
    RelativeOrientation
        Base, angles, their standard deviations and residuals. The start is two parallel pictures,
        the second to the right.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite or there are fewer than six pairs.
    DegenerateConfigurationError
        If the rays do not fix five numbers, or the search finds no rest: the second centre is not
        beside the first, or the pictures are turned too much.

    References
    ----------
    K. Kraus, Photogrammetry, 2nd ed., section 4.3.
    """
    names = "pixels of the first", "pixels of the second"
    one, other = check_correspondences(first, second, (2, 2), names, least=6)
    K_one = check_intrinsics(K)
    K_other = K_one if K_second is None else check_intrinsics(K_second)
    x1, x2 = to_homogeneous(one).T, to_homogeneous(other).T
    left, right = np.linalg.inv(K_other).T, np.linalg.inv(K_one)

    def problem(p: Array) -> tuple[Array, Array]:
        slopes = [(missed(p + e) - missed(p - e)) / 2e-6 for e in 1e-6 * np.eye(5)]
        return missed(p), np.stack(slopes, axis=1)

    def missed(p: Array) -> Array:
        R, t = pose_from_relative([1, p[0], p[1]], p[2:])
        F = left @ np.cross(t, R.T).T @ right  # the middle is [t]ₓ R
        return sampson_residuals(F, x1, x2)

    fit = levenberg_marquardt(problem, np.zeros(5))
    sizes = np.linalg.norm(fit.jacobian, axis=0)
    unfelt = sizes.min() <= UNFELT * sizes.max()
    if not fit.converged or unfelt or np.linalg.cond(fit.jacobian / sizes) > 1 / UNFELT:
        raise DegenerateConfigurationError(
            "the rays do not fix a relative orientation: the points lie on a surface that leaves "
            "it open, or the second centre is not beside the first; start from the essential matrix"
        )
    return RelativeOrientation(
        np.append(1.0, fit.parameters[:2]), fit.parameters[2:], fit.sigma, fit.residuals
    )
