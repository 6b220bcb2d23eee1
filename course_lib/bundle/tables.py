"""A small block as plain tables: who sees what in rows of cameras and columns of points.

Where a camera does not see a point, its pixel is NaN. `course_lib.bundle.bundle_adjust` uses lists
of observations instead, which large blocks need; here is what one step of it takes, piece by piece.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from course_lib.bundle.block import Block, Observations
from course_lib.bundle.derivatives import Image, Position
from course_lib.checks import Array, check_matrix, check_numbers, check_real, check_vector


class NormalBlocks(NamedTuple):
    """The normal equations of v cameras and n points, as `solve_normal_block` takes them.

    Attributes
    ----------
    U : ndarray, shape (6 v, 6 v)
        Of the cameras: a 6 × 6 block for each on the diagonal, zero elsewhere.
    W : ndarray, shape (n, 6 v, 3)
        What ties the cameras to each point.
    V : ndarray, shape (n, 3, 3)
        Of each point.
    g_c, g_p : ndarray, shape (6 v,) and (n, 3)
        Gradients ``Jᵀ r``: half of how the sum of squared residuals r grows.
    """

    U: Array
    W: Array
    V: Array
    g_c: Array
    g_p: Array


def normal_blocks(
    K: ArrayLike, R: ArrayLike, t: ArrayLike, points: ArrayLike, pixels: ArrayLike
) -> NormalBlocks:
    """Return the normal equations of a small block.

    Parameters
    ----------
    K : array_like, shape (3, 3) or (v, 3, 3)
        Intrinsics, px; one for all cameras, or one of each.
    R, t : array_like, shape (v, 3, 3) and (v, 3)
        Poses, world to camera.
    points : array_like, shape (n, 3)
        Points of the world.
    pixels : array_like, shape (v, n, 2)
        Where each camera sees each point; NaN where it does not.

    Returns
    -------
    NormalBlocks
        U, W, V and the gradients. A camera's six numbers are those of `reprojection_jacobian`: a
        turn about its own axes, and a move of its centre.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, or a point is seen by a camera that it is behind of.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., appendix A6.3.
    """
    block, table = _checked(K, R, t, points, pixels)
    cameras, numbers = np.nonzero(np.isfinite(table).all(axis=2))
    seen = Observations(cameras, numbers, table[cameras, numbers])
    image = Position.of(block).image(seen)
    _check_in_front(image, seen)
    turns, moves = image.derivatives(np.ones(len(seen)))
    by_camera = np.concatenate([turns, -moves], axis=1).transpose(2, 0, 1)  # (m, 2, 6)
    by_point, residuals = moves.transpose(2, 0, 1), image.residuals.T
    v, n, i, j = len(block.R), len(block.points), seen.cameras, seen.points
    U, W, V = np.zeros((v, 6, v, 6)), np.zeros((n, v, 6, 3)), np.zeros((n, 3, 3))
    g_c, g_p = np.zeros((v, 6)), np.zeros((n, 3))
    own = np.zeros((v, 6, 6))
    np.add.at(own, i, by_camera.swapaxes(1, 2) @ by_camera)
    U[np.arange(v), :, np.arange(v)] = own
    W[j, i] = by_camera.swapaxes(1, 2) @ by_point
    np.add.at(V, j, by_point.swapaxes(1, 2) @ by_point)
    np.add.at(g_c, i, np.einsum("mkc,mk->mc", by_camera, residuals))
    np.add.at(g_p, j, np.einsum("mkc,mk->mc", by_point, residuals))
    return NormalBlocks(U.reshape(6 * v, 6 * v), W.reshape(n, 6 * v, 3), V, g_c.ravel(), g_p)


def squared_error(
    K: ArrayLike, R: ArrayLike, t: ArrayLike, points: ArrayLike, pixels: ArrayLike
) -> float:
    """Return the sum of all squared residuals of a small block.

    Parameters
    ----------
    K, R, t, points, pixels
        As in `normal_blocks`.

    Returns
    -------
    float
        In px²; infinite if a point is seen by a camera that it is behind of.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong.
    """
    block, table = _checked(K, R, t, points, pixels)
    q = np.einsum("vij,nj->vni", block.R, block.points) + block.t[:, None]
    seen = np.isfinite(table).all(axis=2)
    if (q[..., 2][seen] <= 0).any():
        return np.inf
    q = np.einsum("vij,vnj->vni", block.K, q)[seen]
    return float(((q[:, :2] / q[:, 2:] - table[seen]) ** 2).sum())


def move_block(
    R: ArrayLike, t: ArrayLike, points: ArrayLike, cameras: ArrayLike, moves: ArrayLike
) -> tuple[Array, Array, Array]:
    """Return cameras and points after a step.

    Parameters
    ----------
    R, t : array_like, shape (v, 3, 3) and (v, 3)
        Poses, world to camera.
    points : array_like, shape (n, 3)
        Points of the world.
    cameras : array_like, shape (6 v,)
        For each camera a turn w of all that it sees, ``R → exp([w]ₓ) R``, rad (it turns itself by
        -w), and a move of its centre: what `solve_normal_block` gives.
    moves : array_like, shape (n, 3)
        Of the points.

    Returns
    -------
    R, t, points : ndarray, shape (v, 3, 3), (v, 3) and (n, 3)
        Where they are now.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or a number is not finite.
    """
    R, t, points = check_numbers(R, "R"), check_numbers(t, "t"), check_numbers(points, "points")
    start = Block(np.eye(3), R, t, points)
    steps = check_vector(cameras, 6 * len(start.R), "cameras").reshape(-1, 6)
    shifts = check_matrix(moves, (len(start.points), 3), "moves")
    moved = Position.of(start).moved(steps, shifts)
    return moved.R, -np.einsum("vij,vj->vi", moved.R, moved.C), moved.X


def _checked(
    K: ArrayLike, R: ArrayLike, t: ArrayLike, points: ArrayLike, pixels: ArrayLike
) -> tuple[Block, Array]:
    K, R, t = check_numbers(K, "K"), check_numbers(R, "R"), check_numbers(t, "t")
    block = Block(K, R, t, check_numbers(points, "points"))
    table = check_real(pixels, "pixels")
    wanted = len(block.R), len(block.points), 2
    if table.shape != wanted:
        raise ValueError(
            f"pixels must have shape {wanted}, a row of points for each camera, got {table.shape}"
        )
    return block, table


def _check_in_front(image: Image, seen: Observations) -> None:
    behind = np.flatnonzero(np.isnan(image.z))
    if len(behind):
        camera, point = seen.cameras[behind[0]], seen.points[behind[0]]
        raise ValueError(f"camera {camera} sees point {point}, which is behind it: it has no pixel")
