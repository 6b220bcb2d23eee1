"""The pose of a camera from three points: the smallest number that determines it, up to four ways.

The rays to the points enclose known angles, the points have known distances from each other, and
each side of their triangle gives one equation for the three distances from the camera.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import Array, check_intrinsics
from course_lib.correspondences import check_correspondences, check_spread

#: Pairs of the three points: the sides of the triangle opposite to each.
SIDES = ((1, 2), (0, 2), (0, 1))
#: A solution whose sides are wrong by a larger share is none.
CLOSED = 1e-6


def poses_from_three_points(
    points: ArrayLike, pixels: ArrayLike, K: ArrayLike
) -> list[tuple[Array, Array]]:
    """Return all poses of a camera that sees three points where it does.

    Parameters
    ----------
    points : array_like, shape (3, 3)
        Three points of the world in rows, not on one line.
    pixels : array_like, shape (3, 2)
        Where the camera sees them, freed from distortion.
    K : array_like, shape (3, 3)
        Intrinsics, px.

    Returns
    -------
    list of (R, t)
        None to four poses, world to camera, with the points in front; the nearest first.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or a number is not finite.
    DegenerateConfigurationError
        If the points are on one line, or the pixels the same.

    References
    ----------
    R. M. Haralick et al., "Review and analysis of solutions of the three point perspective pose
    estimation problem", IJCV 13 (1994), section 3.1 (Grunert's solution of 1841).
    """
    X, seen = check_correspondences(points, pixels, (3, 2), ("points", "pixels"), least=3)
    if len(X) != 3:
        raise ValueError(f"three points are needed, got {len(X)}: use resect_camera for more")
    check_spread(X, 2, "points")
    check_spread(seen, 1, "pixels")
    R, t, found = three_point_poses(X[None], unit_rays(seen, check_intrinsics(K))[None])
    nearest = np.argsort(np.linalg.norm(t[0], axis=1))
    poses: list[tuple[Array, Array]] = []
    for i in nearest[found[0][nearest]]:
        if not any(np.allclose(R[0, i], other, rtol=0, atol=1e-7) for other, _ in poses):
            poses.append((R[0, i], t[0, i]))
    return poses


def unit_rays(pixels: Array, K: Array) -> Array:
    """Return the directions of pixels in the camera's frame, of length 1, shape (N, 3)."""
    rays = np.column_stack([pixels, np.ones(len(pixels))]) @ np.linalg.inv(K).T
    return np.asarray(rays / np.linalg.norm(rays, axis=1, keepdims=True))


@np.errstate(all="ignore")  # what is no solution may be anything
def three_point_poses(X: Array, rays: Array) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Return poses for many triples at once.

    Parameters
    ----------
    X, rays : ndarray, shape (M, 3, 3)
        Points in rows, and unit vectors in the camera's frame that lead to them.

    Returns
    -------
    R, t, found : ndarray, shape (M, 4, 3, 3), (M, 4, 3) and (M, 4)
        Poses, and which of them are solutions.
    """
    squares = np.stack([((X[:, i] - X[:, j]) ** 2).sum(axis=1) for i, j in SIDES], axis=1)
    cosines = np.stack([(rays[:, i] * rays[:, j]).sum(axis=1) for i, j in SIDES], axis=1)
    v = _ratios(squares, cosines)
    distances = _distances(v, squares[:, None], cosines[:, None])
    gaps = np.abs(_gaps(distances, squares[:, None], cosines[:, None]))
    found = np.asarray((distances > 0).all(axis=2))
    found &= (gaps <= CLOSED * squares[:, None]).all(axis=2)
    seen = distances[..., None] * rays[:, None]
    R = _triads(seen) @ _triads(X)[:, None].swapaxes(-1, -2)
    t = seen[:, :, 0] - np.einsum("mkij,mj->mki", R, X[:, 0])
    return R, np.asarray(t), found


def _ratios(squares: Array, cosines: Array) -> Array:
    """Return the real parts of the roots v = s₃/s₁ of Grunert's equation, (M, 4)."""
    a, b, c = squares.T
    ca, cb, cg = cosines.T
    p, q, r = (a - c) / b, (a + c) / b, c / b
    A4 = (p - 1) ** 2 - 4 * r * ca**2
    A3 = 4 * (p * (1 - p) * cb - (1 - q) * ca * cg + 2 * r * ca**2 * cb)
    A2 = 2 * (p**2 - 1 + 2 * p**2 * cb**2 + 2 * (1 - r) * ca**2)
    A2 += 4 * (1 - a / b) * cg**2 - 8 * q * ca * cb * cg
    A1 = 4 * (2 * a / b * cg**2 * cb - p * (1 + p) * cb - (1 - q) * ca * cg)
    A0 = (1 + p) ** 2 - 4 * a / b * cg**2
    quartic = np.stack([A4, A3, A2, A1, A0], axis=1)
    largest = np.abs(quartic).max(axis=1, keepdims=True)
    first = np.where(np.abs(quartic[:, :1]) > 1e-14 * largest, quartic[:, :1], 1e-14 * largest)
    companion = np.zeros((len(a), 4, 4))
    companion[:, 1:, :3] = np.eye(3)
    companion[:, 0] = -quartic[:, 1:] / first
    companion[~np.isfinite(companion).all(axis=(1, 2))] = 0
    return np.asarray(np.linalg.eigvals(companion).real)


def _distances(v: Array, squares: Array, cosines: Array) -> Array:
    """Return the distances of the three points for each ratio, (M, 4, 3), made exact."""
    a, b, c = (squares[..., i] for i in range(3))
    ca, cb, cg = (cosines[..., i] for i in range(3))
    s1 = np.sqrt(b / (1 + v * v - 2 * v * cb))
    root = np.sqrt(np.maximum(cg * cg - 1 + c / s1**2, 0))
    both = np.stack([cg - root, cg + root])
    error = np.abs(s1**2 * (both**2 + v * v - 2 * both * v * ca) - a)
    u = np.where(error[0] < error[1], both[0], both[1])
    s = np.stack([s1, u * s1, v * s1], axis=-1)
    for _ in range(4):  # Newton's steps: the roots have lost digits
        J = np.zeros((*s.shape, 3))
        for row, (i, j) in enumerate(SIDES):
            J[..., row, i] = 2 * (s[..., i] - s[..., j] * cosines[..., row])
            J[..., row, j] = 2 * (s[..., j] - s[..., i] * cosines[..., row])
        usable = np.abs(np.linalg.det(np.nan_to_num(J))) > 0
        J[~usable] = np.eye(3)
        step = np.linalg.solve(J, _gaps(s, squares, cosines)[..., None])[..., 0]
        s = np.where(usable[..., None], s - step, s)
    return np.asarray(s)


def _gaps(s: Array, squares: Array, cosines: Array) -> Array:
    """Return by how much the squares of the sides are wrong, (M, 4, 3)."""
    sides = [
        s[..., i] ** 2 + s[..., j] ** 2 - 2 * s[..., i] * s[..., j] * cosines[..., row]
        for row, (i, j) in enumerate(SIDES)
    ]
    return np.asarray(np.stack(sides, axis=-1) - squares)


def _triads(points: Array) -> Array:
    """Return three perpendicular unit vectors, in columns, that ride on three points."""
    first = points[..., 1, :] - points[..., 0, :]
    normal = np.cross(first, points[..., 2, :] - points[..., 0, :])
    first = first / np.linalg.norm(first, axis=-1, keepdims=True)
    normal = normal / np.linalg.norm(normal, axis=-1, keepdims=True)
    return np.stack([first, np.cross(normal, first), normal], axis=-1)
