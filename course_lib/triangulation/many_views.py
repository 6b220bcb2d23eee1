"""Points from two or more pictures: the linear answer, the best one, and how certain it is.

Use these functions through `course_lib.triangulation`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera.projection import check_finite_camera
from course_lib.checks import (
    LARGEST,
    Array,
    DegenerateConfigurationError,
    check_length,
    check_numbers,
    check_points,
)
from course_lib.triangulation.rays import check_apart

STEPS = 30
#: A step that lowers the sum of squares by less than this share is the last one.
LAST_GAIN = 1e-12
#: Two singular values of an equation system that are zero but for rounding.
UNDETERMINED = 1e-12
#: How a direction may count, as a share of the best-known one, before it is unknown.
UNKNOWN = 1e-24


def triangulate_linear(pixels: ArrayLike, cameras: ArrayLike) -> Array:
    """Return points from two or more views, by the linear method (DLT).

    A view with the camera matrix of rows p1, p2, p3 gives the equations ``(u p3 - p1) X = 0`` and
    ``(v p3 - p2) X = 0``. Of all homogeneous points X of length 1, the one is taken for which the
    errors are smallest: pixels times depth, so that a far camera counts more than it should. For
    the best answer go on with `refine_point`.

    Parameters
    ----------
    pixels : array_like, shape (V, N, 2) or (V, 2)
        V ≥ 2 views of N points, or of one point, without distortion. NaN where a view does not
        see a point; each must be seen twice.
    cameras : array_like, shape (V, 3, 4)
        Camera matrices.

    Returns
    -------
    ndarray, shape (N, 3) or (3,)
        Points in the world frame of the cameras.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is infinite, or a point is seen less than twice.
    DegenerateConfigurationError
        If all cameras are at the same place, or the rays of a point are parallel or the same.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 12.2.

    Examples
    --------
    >>> P1 = np.array([[800, 0, 320, 0], [0, 800, 240, 0], [0, 0, 1, 0]])
    >>> P2 = P1 - [[0, 0, 0, 800], [0, 0, 0, 0], [0, 0, 0, 0]]
    >>> triangulate_linear([[520, 240], [320, 240]], [P1, P2]).round(9) + 0.0
    array([1., 0., 4.])
    """
    seen, P, single = check_views(pixels, cameras)
    rows = seen.transpose(1, 0, 2)[..., None] * P[:, 2:] - P[:, :2]  # (N, V, 2, 4)
    rows = np.where(np.isnan(rows), 0, rows).reshape(len(rows), -1, 4)
    _, s, Vt = np.linalg.svd(rows)
    X = Vt[:, 3]
    unknown = (s[:, 2] <= UNDETERMINED * s[:, 0]) | (np.abs(X[:, 3]) <= UNDETERMINED)
    _name_unknown(unknown)
    X = X[:, :3] / X[:, 3:]
    return np.asarray(X[0] if single else X)


def refine_point(points: ArrayLike, pixels: ArrayLike, cameras: ArrayLike) -> Array:
    """Return the points whose images are nearest to the measured pixels, near first guesses.

    Gauss–Newton steps, damped where they would miss, until nothing moves: with the residuals r
    (projected minus measured) and their derivatives J each step δ solves ``J δ = -r`` by least
    squares. With ``(a, b, c) = P (X, 1)`` the rows of J are ``(m1 - u m3)/c`` and
    ``(m2 - v m3)/c``; m1, m2, m3 are the rows of P without their last number.

    Parameters
    ----------
    points : array_like, shape (N, 3) or (3,)
        First guesses, such as the result of `triangulate_linear`, in front of all cameras that
        see them.
    pixels, cameras : array_like, shape (V, N, 2) or (V, 2), and (V, 3, 4)
        As in `triangulate_linear`.

    Returns
    -------
    ndarray, shape (N, 3) or (3,)
        For each point the nearest minimum of the sum of squares of the distances in px: the best
        answer if the pixels have errors that are independent and equally large.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is infinite, a point is seen less than twice, or a first
        guess is behind a camera that sees it.
    DegenerateConfigurationError
        If all cameras are at the same place, or the rays of a point are parallel or the same.

    References
    ----------
    R. Hartley & P. Sturm, "Triangulation", CVIU 68 (1997); Hartley & Zisserman, Multiple View
    Geometry, 2nd ed., section 12.3.

    Examples
    --------
    >>> P1 = np.array([[100, 0, 0, 0], [0, 100, 0, 0], [0, 0, 1, 0]])
    >>> P2 = P1 - [[0, 0, 0, 100], [0, 0, 0, 0], [0, 0, 0, 0]]
    >>> refine_point([1, 0, 5], [[25, 0], [0, 0]], [P1, P2]).round(9) + 0.0
    array([1., 0., 4.])
    """
    seen, P, single = check_views(pixels, cameras)
    X = check_guesses(points, seen, P)
    damping = np.zeros(len(X))
    cost, N, g = _normals(X, seen, P)
    for _ in range(STEPS):
        step = _step(N, g, damping)
        trial = X + step
        new_cost, new_N, new_g = _normals(trial, seen, P)
        better = new_cost <= cost  # NaN, behind a camera, compares as False
        done = (-(g * step).sum(axis=1) <= LAST_GAIN * cost + 1e-24) & (damping <= 1)
        X, cost = np.where(better[:, None], trial, X), np.where(better, new_cost, cost)
        N, g = np.where(better[:, None, None], new_N, N), np.where(better[:, None], new_g, g)
        damping = np.where(better, damping / 10, np.maximum(10 * damping, 1e-3))
        if done.all():
            break
    return X[0] if single else X


def point_covariance(points: ArrayLike, cameras: ArrayLike, sigma: float = 1.0) -> Array:
    """Return how uncertain triangulated points are.

    Parameters
    ----------
    points : array_like, shape (N, 3) or (3,)
        Points in front of all cameras.
    cameras : array_like, shape (V, 3, 4)
        Camera matrices of V ≥ 2 views that see all of them.
    sigma : float
        Standard deviation of each coordinate of a pixel, px.

    Returns
    -------
    ndarray, shape (N, 3, 3) or (3, 3)
        ``σ² (JᵀJ)⁻¹`` with J, the derivatives of the pixels by the point. The eigenvectors are the
        axes of an ellipsoid, the roots of the eigenvalues their standard deviations.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, sigma is not positive, or a point is
        behind a camera.
    DegenerateConfigurationError
        If all cameras are at the same place, or the rays of a point are parallel or the same.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 12.6.

    Examples
    --------
    A point 4 m away, a baseline of 1 m: in depth ``√2 σ Z² / (f b)`` = 0.0283 m.

    >>> P1 = np.array([[800, 0, 320, 0], [0, 800, 240, 0], [0, 0, 1, 0]])
    >>> P2 = P1 - [[0, 0, 0, 800], [0, 0, 0, 0], [0, 0, 0, 0]]
    >>> np.sqrt(np.diag(point_covariance([0.5, 0, 4], [P1, P2]))).round(4)
    array([0.0035, 0.0035, 0.0283])
    """
    sigma = check_length(sigma, "sigma")
    X = check_points(points, 3, "points")
    P = check_cameras(cameras)
    many = X.reshape(-1, 3)
    image = _projected(many, P)[0]
    if np.isnan(image).any():
        raise ValueError("a point is behind a camera (or in its plane): no pixel shows it")
    found = sigma**2 * _inverse(_normals(many, image, P)[1])
    return np.asarray(found.reshape(*X.shape[:-1], 3, 3))


def check_cameras(cameras: ArrayLike) -> Array:
    """Return camera matrices, (V, 3, 4), V ≥ 2, that give positive depths, not all in one place."""
    P = check_numbers(cameras, "cameras")
    if P.ndim != 3 or P.shape[1:] != (3, 4) or len(P) < 2:
        raise ValueError(
            f"cameras must be two or more camera matrices, shape (V, 3, 4), got {P.shape}"
        )
    P = np.stack([check_finite_camera(one) for one in P])
    # Third rows of length 1: then w is the depth, and no camera counts for the size of its matrix.
    size = np.sign(np.linalg.det(P[:, :, :3])) * np.linalg.norm(P[:, 2, :3], axis=1)
    P /= size[:, None, None]
    centres = -np.linalg.solve(P[:, :, :3], P[:, :, 3:])[..., 0]
    farthest = int(np.argmax(np.abs(centres - centres[0]).max(axis=1)))
    check_apart(centres[0], centres[farthest])
    return P


def check_views(pixels: ArrayLike, cameras: ArrayLike) -> tuple[Array, Array, bool]:
    """Return pixels, (V, N, 2), with NaN where there are none, cameras, and if it is one point."""
    P = check_cameras(cameras)
    array = np.asarray(pixels)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"pixels must be real numbers, got {pixels!r:.60}")
    seen = array.astype(np.float64)
    if seen.ndim not in (2, 3) or seen.shape[-1] != 2 or len(seen) != len(P):
        raise ValueError(
            f"pixels must have shape (V, N, 2) or (V, 2) for V = {len(P)} cameras, got {seen.shape}"
        )
    single = seen.ndim == 2
    seen = seen[:, None] if single else seen
    seen[np.isnan(seen).any(axis=-1)] = np.nan
    if not np.nanmax(np.abs(seen), initial=0) <= LARGEST:
        raise ValueError(f"pixels hold infinity or a number beyond {LARGEST:g}: check them")
    views = (~np.isnan(seen[..., 0])).sum(axis=0)
    if (views < 2).any():
        raise ValueError(
            f"point {int(np.argmin(views))} (counted from 0) is seen in {views.min()} view: two or "
            "more are needed; leave it out"
        )
    return seen, P, single


def check_guesses(points: ArrayLike, seen: Array, P: Array) -> Array:
    """Return first guesses, (N, 3), once each is in front of the cameras that see it."""
    X = check_points(points, 3, "points").reshape(-1, 3)
    if len(X) != seen.shape[1]:
        raise ValueError(f"there are {len(X)} points but pixels of {seen.shape[1]}")
    depths = X @ P[:, 2, :3].T + P[:, 2, 3]
    behind = ((depths <= 0) & ~np.isnan(seen[..., 0]).T).any(axis=1)
    if behind.any():
        raise ValueError(
            f"point {int(np.argmax(behind))} (counted from 0) is behind a camera that sees it: "
            "the pair is wrong, or the pose; leave it out"
        )
    return X.copy()


def _projected(X: Array, P: Array) -> tuple[Array, Array]:
    """Return images, (V, N, 2), with NaN behind a camera, and depths, (V, N, 1)."""
    image = X @ P[:, :, :3].swapaxes(1, 2) + P[:, None, :, 3]
    depth = np.where(image[..., 2:] > 0, image[..., 2:], np.nan)
    return image[..., :2] / depth, depth


def _normals(X: Array, seen: Array, P: Array) -> tuple[Array, Array, Array]:
    """Return the sum of squares, (N,), JᵀJ, (N, 3, 3), and Jᵀ residuals, (N, 3), of each point."""
    image, depth = _projected(X, P)
    hidden = np.isnan(seen)
    residuals = np.where(hidden, 0, image - seen)
    # u = a / c has the derivative (m1 - u m3) / c.
    J = (P[:, None, :2, :3] - image[..., None] * P[:, None, 2:, :3]) / depth[..., None]
    J = np.where(hidden[..., None], 0, J).transpose(1, 0, 2, 3).reshape(len(X), -1, 3)
    r = residuals.transpose(1, 0, 2).reshape(len(X), -1)
    JT = J.swapaxes(1, 2)
    return (r * r).sum(axis=1), JT @ J, (JT @ r[..., None])[..., 0]


def _step(N: Array, g: Array, damping: Array) -> Array:
    """Return damped Gauss–Newton steps of all points."""
    N = N.copy()
    N[:, range(3), range(3)] *= 1 + damping[:, None]
    return np.asarray(-(_inverse(N) @ g[..., None])[..., 0])


def _inverse(N: Array) -> Array:
    """Return the inverses of the points' JᵀJ, or name the point that has none."""
    sizes, axes = np.linalg.eigh(N)
    _name_unknown(sizes[:, 0] <= UNKNOWN * sizes[:, 2])
    return np.asarray(axes / sizes[:, None, :] @ axes.swapaxes(1, 2))


def _name_unknown(unknown: NDArray[np.bool_]) -> None:
    if unknown.any():
        raise DegenerateConfigurationError(
            f"the rays of point {int(np.argmax(unknown))} (counted from 0) are parallel or the "
            "same: its depth is not determined; leave it out, or use a longer baseline"
        )
