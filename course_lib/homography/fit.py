"""The homography with the smallest reprojection error, of one picture or of many at once.

All sums over points are products of matrices: those of a thousand points, or of the same board in
fifty pictures, are taken in one go. Use these functions through `course_lib.homography`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_matrix,
    check_numbers,
)
from course_lib.correspondences import check_correspondences, check_plane_pairs, check_scatter

#: A step that promises to lower the sum of squares by less than this share is the last one.
LAST_GAIN = 1e-8
STEPS = 30
#: A sum of squares, in units in which the points are about 1 wide, that is rounding alone.
ROUNDING = 1e-24
#: A determinant of normalised homographies that is zero but for rounding.
SINGULAR = 1e-12
TOO_FEW = (
    "all points but one, or all targets but one, are on a line: a homography needs four, no three "
    "of them on a line"
)
#: A second direction that solves the equations nearly as well as the best one.
AMBIGUOUS = 1e-13


def fit_homography(points: ArrayLike, targets: ArrayLike) -> Array:
    """Return the homography that brings points nearest to their targets.

    `homography_dlt` makes an error small that has no meaning; this goes on from there until the
    distances in the target's plane are smallest: the best answer if the targets have errors that
    are independent and equally large.

    Parameters
    ----------
    points : array_like, shape (N, 2)
        N ≥ 4 points in rows, known exactly.
    targets : array_like, shape (N, 2)
        Their measured images.

    Returns
    -------
    ndarray, shape (3, 3)
        H with ``H[2, 2] = 1``, or of length 1 if that entry is zero.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or there are fewer than four points.
    DegenerateConfigurationError
        If the points or the targets are on one line, or all but one of them are.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 4.2.2 and algorithm 4.3.

    Examples
    --------
    >>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    >>> fit_homography(square, [[0, 0], [2, 0], [2, 3], [0, 3]]).round(9) + 0.0
    array([[2., 0., 0.],
           [0., 3., 0.],
           [0., 0., 1.]])
    """
    points, targets = check_correspondences(points, targets, (2, 2), ("points", "targets"), least=4)
    return np.asarray(fit_homographies(points, targets[None])[0])


def fit_homographies(points: ArrayLike, targets: ArrayLike) -> Array:
    """Return the homographies of one set of points to many sets of targets, at once.

    Parameters
    ----------
    points : array_like, shape (N, 2) or (B, N, 2)
        N ≥ 4 points in rows: the same for all, as on a calibration target, or a set for each.
    targets : array_like, shape (B, N, 2)
        Their measured images in B pictures.

    Returns
    -------
    ndarray, shape (B, 3, 3)
        For each picture what `fit_homography` returns.

    Raises
    ------
    TypeError, ValueError, DegenerateConfigurationError
        As `fit_homography`; the geometry of every single picture must be good.

    References
    ----------
    As `fit_homography`.
    """
    points, targets = check_numbers(points, "points"), check_numbers(targets, "targets")
    count = targets.shape[-2] if targets.ndim == 3 else 0
    if count < 4 or points.shape not in ((count, 2), targets.shape) or targets.shape[2] != 2:
        raise ValueError(
            "points must have shape (N, 2) or (B, N, 2) and targets (B, N, 2) with N ≥ 4, got "
            f"{points.shape} and {targets.shape}"
        )
    p, T_points = _normalised(points, "points")
    q, T_targets = _normalised(targets, "targets")
    monomials = _monomials(p)
    H = _start(_design_squared(monomials, q[..., :2, :]))
    H = _refined(H, p, q, monomials)
    check_plane_kept(H)
    return with_usual_scale(np.linalg.inv(T_targets) @ H @ T_points)


def refine_homography(H: ArrayLike, points: ArrayLike, targets: ArrayLike) -> Array:
    """Return a homography moved to the nearest minimum of the distances from the targets.

    Parameters
    ----------
    H : array_like, shape (3, 3)
        Where to begin, such as the result of `homography_dlt`.
    points, targets : array_like, shape (N, 2)
        As in `fit_homography`.

    Returns
    -------
    ndarray, shape (3, 3)
        As `fit_homography`.

    Raises
    ------
    TypeError, ValueError
        As `fit_homography`.
    DegenerateConfigurationError
        If the points or the targets are on one line.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 4.5.
    """
    H = check_matrix(H, (3, 3), "H")
    points, targets = check_plane_pairs(points, targets)
    p, T_points = _normalised(points, "points")
    q, T_targets = _normalised(targets, "targets")
    start = (T_targets @ H @ np.linalg.inv(T_points))[None]
    start = start / (np.linalg.norm(start) or 1)
    check_plane_kept(start)
    refined = _refined(start, p, q[None], _monomials(p))
    check_plane_kept(refined)
    return with_usual_scale(np.linalg.inv(T_targets) @ refined[0] @ T_points)


def check_plane_kept(H: Array) -> None:
    """Raise if homographies of normalised points, of length 1, squeeze the plane into a line."""
    if not (np.abs(np.linalg.det(H)) > SINGULAR).all():
        raise DegenerateConfigurationError(TOO_FEW)


def with_usual_scale(H: Array) -> Array:
    """Return homographies, shape (..., 3, 3), with 1 in the corner; of length 1 if that is zero."""
    H = H / np.linalg.norm(H, axis=(-2, -1), keepdims=True)
    corner = H[..., 2:, 2:]
    return np.asarray(H / np.where(np.abs(corner) > 1e-12, corner, 1))


def _start(N: Array) -> Array:
    """Return homographies of length 1 that nearly make the DLT's error smallest, (B, 3, 3).

    The error is a quadratic form of the rows of H. For a given last row the first two follow, and
    an eigenvector of 3 × 3 numbers is left for the last row.
    """
    first, across, last = N[:, :6, :6], N[:, :6, 6:], N[:, 6:, 6:]
    rows = -np.linalg.solve(first, across)  # the first two rows from the last one
    sizes, vectors = np.linalg.eigh(last + across.swapaxes(1, 2) @ rows)
    if (sizes[:, 1] <= AMBIGUOUS * last.trace(axis1=1, axis2=2)).any():
        raise DegenerateConfigurationError(TOO_FEW)
    h = np.concatenate([rows @ vectors[..., :1], vectors[..., :1]], axis=1)
    return np.asarray(h / np.linalg.norm(h, axis=1, keepdims=True)).reshape(-1, 3, 3)


class _Linear(NamedTuple):
    """Distances of images from targets near some homographies: their squares, and the slopes."""

    cost: Array  # (B,)
    normal: Array  # JᵀJ, (B, 9, 9)
    gradient: Array  # Jᵀ residuals, (B, 9)


@np.errstate(divide="ignore", invalid="ignore", over="ignore")  # images may be at infinity
def _refined(H: Array, p: Array, q: Array, monomials: Array) -> Array:
    """Return homographies of length 1, (B, 3, 3), at the minimum: damped Gauss–Newton for all.

    Points and targets are homogeneous, in columns: shape (..., 3, N). An image at infinity makes
    the sum of squares infinite or NaN, which is never better.
    """
    now, damping = _linearised(H, p, q, monomials), np.zeros(len(H))
    for _ in range(STEPS):
        step, promise = _step(H, now, damping)
        trial = H - step
        trial /= np.linalg.norm(trial, axis=(1, 2), keepdims=True)
        if ((promise <= LAST_GAIN * now.cost) | (now.cost < ROUNDING)).all():
            return trial
        new = _linearised(trial, p, q, monomials)
        better = new.cost <= now.cost
        H = _choose(better, trial, H)
        now = _Linear(*(_choose(better, *both) for both in zip(new, now, strict=True)))
        damping = np.where(better, damping / 10, np.maximum(10 * damping, 1e-3))
    return H


def _step(H: Array, linear: _Linear, damping: Array) -> tuple[Array, Array]:
    """Return what to subtract from homographies of length 1, and how much that should gain."""
    h = H.reshape(-1, 9, 1)
    # Along h itself only the scale changes: h hᵀ makes the rank full.
    N = linear.normal + h @ h.swapaxes(1, 2)
    N.reshape(-1, 81)[:, ::10] *= 1 + damping[:, None]  # the diagonals
    try:
        step = np.linalg.solve(N, linear.gradient[..., None])[..., 0]
    except np.linalg.LinAlgError as error:
        raise DegenerateConfigurationError(TOO_FEW) from error
    return np.asarray(step.reshape(-1, 3, 3)), (linear.gradient * step).sum(axis=1)


def _choose(better: NDArray[np.bool_], one: Array, other: Array) -> Array:
    return one if better.all() else np.where(better.reshape(-1, *[1] * (one.ndim - 1)), one, other)


def _linearised(H: Array, p: Array, q: Array, monomials: Array) -> _Linear:
    """Return the linear problem at homographies.

    With ``H p = w (u, v, 1)`` the residual ``u - u'`` has the derivatives ``p/w`` by the first row
    of H and ``-u p/w`` by the last one: rows of the DLT's design, weighted by 1/w.
    """
    image = H @ p
    by_w = 1 / image[..., 2:, :]
    seen = image[..., :2, :] * by_w
    residuals = seen - q[..., :2, :]
    pull = np.empty(image.shape)
    np.multiply(residuals, by_w, out=pull[..., :2, :])
    pull[..., 2, :] = -(pull[..., :2, :] * seen).sum(axis=-2)
    return _Linear(
        (residuals * residuals).sum(axis=(-2, -1)),
        _design_squared(monomials, seen, (by_w * by_w)[..., 0, :]),
        (pull @ p.swapaxes(-1, -2)).reshape(-1, 9),
    )


def _design_squared(monomials: Array, targets: Array, weights: Array | None = None) -> Array:
    """Return ``AᵀA`` of the DLT, (B, 9, 9), from rows ``w (p, 0, -u p)`` and ``w (0, p, -v p)``."""
    u, v = targets[..., 0, :], targets[..., 1, :]
    factors = np.ones((*u.shape[:-1], 4, u.shape[-1]))  # 1, u, v, u² + v²
    factors[..., 1:3, :] = targets
    factors[..., 3, :] = u * u + v * v
    if weights is not None:
        factors *= weights[..., None, :]
    sums = monomials @ factors.swapaxes(-1, -2)
    # From six different sums to the symmetric 3 × 3 matrices Σ p pᵀ, Σ u p pᵀ, …
    S = sums[..., [0, 1, 2, 1, 3, 4, 2, 4, 5], :].reshape(-1, 3, 3, 4)
    out = np.zeros((len(S), 3, 3, 3, 3))  # block row, row, block column, column
    out[:, 0, :, 0] = out[:, 1, :, 1] = S[..., 0]
    out[:, 0, :, 2] = out[:, 2, :, 0] = -S[..., 1]
    out[:, 1, :, 2] = out[:, 2, :, 1] = -S[..., 2]
    out[:, 2, :, 2] = S[..., 3]
    return out.reshape(-1, 9, 9)


def _monomials(p: Array) -> Array:
    """Return x², xy, x, y², y, 1 of homogeneous points in columns, shape (..., 6, N)."""
    x, y = p[..., 0, :], p[..., 1, :]
    return np.stack([x * x, x * y, x, y * y, y, np.ones_like(x)], axis=-2)


def _normalised(points: Array, name: str) -> tuple[Array, Array]:
    """Return homogeneous points in columns, (..., 3, N), about the origin and of size √2, and T."""
    centre, count = points.mean(axis=-2), points.shape[-2]
    columns = np.ones((*points.shape[:-2], 3, count))
    centred = columns[..., :2, :]
    np.subtract(points.swapaxes(-1, -2), centre[..., None], out=centred)
    scatter = centred @ centred.swapaxes(-1, -2) / count
    check_scatter(scatter, centre, 2, name)
    scale = np.sqrt(2 / np.trace(scatter, axis1=-2, axis2=-1))[..., None]
    centred *= scale[..., None]
    T = scale[..., None] * np.eye(3)
    T[..., :2, 2] = -scale * centre
    T[..., 2, 2] = 1
    return columns, T
