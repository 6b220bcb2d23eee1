"""The normal equations of a block, and their solution with the points eliminated.

Each observation ties one camera to one point, so the equations are mostly zeros: a 6 × 6 block U
for each camera, a 3 × 3 block V for each point, and a 6 × 3 block W for each observation,

    | U    W | | cameras |     | g_c |
    | Wᵀ   V | | points  | = - | g_p |

With ``V = L Lᵀ`` for each point and ``Y = W L⁻ᵀ``, what is left for the cameras alone is the Schur
complement ``(U - Y Yᵀ) cameras = Y L⁻¹ g_p - g_c``: two cameras meet in it only where they see a
point in common.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from course_lib.bundle.block import Indices
from course_lib.bundle.derivatives import Weighted
from course_lib.bundle.structure import Structure
from course_lib.checks import Array, DegenerateConfigurationError, check_numbers

#: What is left of equations, as a share of what they began with, where rounding is all there is.
ROUNDING = 1e-13
#: Rows and columns of the six different numbers of a symmetric 3 × 3 matrix.
LOWER = ((0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2))


@dataclass(frozen=True, eq=False)
class Normals:
    """The blocks of the normal equations.

    Attributes
    ----------
    U, g_c : ndarray, shape (v, 6, 6) and (v, 6)
        Blocks and gradients of the cameras.
    V, g_p : ndarray, shape (6, n) and (3, n)
        Lower halves of the blocks of the points, in the order of `LOWER`, and their gradients.
    W : ndarray, shape (3, 6, m)
        What ties a camera to a point, transposed, for each observation.
    """

    U: Array
    g_c: Array
    V: Array
    g_p: Array
    W: Array

    def eliminated(self, structure: Structure, damping: float = 0.0) -> Eliminated:
        """Return the equations of the cameras alone, damped as Marquardt does."""
        L = _cholesky(self.V, damping)
        h = forward(L, self.g_p)
        Y = forward(np.take(L, structure.seen.points, axis=1), self.W)
        rows = np.ascontiguousarray(Y.transpose(2, 0, 1))  # (m, 3, 6)
        known = np.take(h.T, structure.seen.points, axis=0)
        v = structure.cameras
        S, right = np.zeros((v, 6, v, 6)), -self.g_c
        diagonal = damping * self.U * np.eye(6)
        for i, (first, last) in enumerate(pairwise(structure.bounds)):
            own = rows[first:last].reshape(-1, 6)
            S[i, :, i] = self.U[i] + diagonal[i] - own.T @ own
            right[i] += known[first:last].ravel() @ own
        left = np.take(rows, structure.left, axis=0).reshape(-1, 6)
        other = np.take(rows, structure.right, axis=0).reshape(-1, 6)
        for i, j, first, last in structure.pairs:
            block = left[3 * first : 3 * last].T @ other[3 * first : 3 * last]
            S[i, :, j], S[j, :, i] = -block, -block.T
        return Eliminated(S.reshape(6 * v, 6 * v), right.ravel(), L, rows, h)


@dataclass(frozen=True, eq=False)
class Eliminated:
    """The equations of the cameras, and what the points need to follow them.

    Attributes
    ----------
    S, right : ndarray, shape (6v, 6v) and (6v,)
        Schur complement and right-hand side.
    L : ndarray, shape (6, n)
        Cholesky factors of the points' blocks.
    Y : ndarray, shape (m, 3, 6)
        ``L⁻¹ Wᵀ`` of each observation.
    h : ndarray, shape (3, n)
        ``L⁻¹ g_p``.
    """

    S: Array
    right: Array
    L: Array
    Y: Array
    h: Array

    def solve(self, structure: Structure, free: Indices) -> tuple[Array, Array]:
        """Return the steps of cameras, (v, 6), and points, (n, 3); what is not free stays."""
        cameras = np.zeros(len(self.right))
        cameras[free] = np.linalg.solve(self.S[np.ix_(free, free)], self.right[free])
        return cameras.reshape(-1, 6), self.followed(structure, cameras.reshape(-1, 6))

    def followed(self, structure: Structure, cameras: Array) -> Array:
        """Return the steps of the points, (n, 3), for those of the cameras, (v, 6)."""
        moved = np.empty((len(structure.seen), 3))
        for i, (first, last) in enumerate(pairwise(structure.bounds)):
            moved[first:last] = (self.Y[first:last].reshape(-1, 6) @ cameras[i]).reshape(-1, 3)
        return np.asarray(-backward(self.L, self.h + structure.by_point(moved.T)).T)


def normal_equations(
    seen: Weighted, structure: Structure, held: Array, weights: Array, gap: Array
) -> Normals:
    """Return the normal equations at a position.

    Parameters
    ----------
    seen : Weighted
        Derivatives and residuals of all observations.
    structure : Structure
        What was seen.
    held : ndarray, shape (n, 3)
        1 for coordinates of points that do not move, else 0.
    weights, gap : ndarray, shape (n, 3)
        ``1 / σ²`` of surveyed coordinates, 0 for the others, and how far they are from the survey.

    Returns
    -------
    Normals
        The blocks.
    """
    turns, moves, residuals = seen
    count = residuals.shape[1]
    rows = np.empty((count, 2, 7))
    rows[:, :, :3], rows[:, :, 3:6] = turns.transpose(2, 0, 1), -moves.transpose(2, 0, 1)
    rows[:, :, 6] = residuals.T
    parts = [rows[a:b].reshape(-1, 7) for a, b in pairwise(structure.bounds)]
    products = np.stack([part.T @ part for part in parts])
    W = np.empty((3, 6, count))
    W[:, :3] = moves[0][:, None] * turns[0]
    W[:, :3] += moves[1][:, None] * turns[1]
    for i, j in LOWER:
        np.negative(moves[0, i] * moves[0, j] + moves[1, i] * moves[1, j], out=W[i, 3 + j])
        W[j, 3 + i] = W[i, 3 + j]
    V = -structure.by_point(np.stack([W[i, 3 + j] for i, j in LOWER]))
    g_p = structure.by_point(moves[0] * residuals[0] + moves[1] * residuals[1])
    if held.any():  # what is held has no derivatives
        free = 1 - held.T
        V *= np.stack([free[i] * free[j] for i, j in LOWER])
        g_p *= free
        W *= free[:, None, structure.seen.points]
    V[[0, 2, 5]] += (weights + held).T
    return Normals(products[:, :6, :6], products[:, :6, 6], V, g_p + (weights * gap).T, W)


def _cholesky(V: Array, damping: float) -> Array:
    """Return the factors L of many symmetric matrices ``L Lᵀ``, all of shape (6, n)."""
    a, b, c, d, e, f = V
    more = 1 + damping
    with np.errstate(invalid="ignore", divide="ignore"):
        l00 = np.sqrt(more * a)
        l10, l20 = b / l00, d / l00
        l11 = np.sqrt(more * c - l10 * l10)
        l21 = (e - l20 * l10) / l11
        l22 = np.sqrt(more * f - l20 * l20 - l21 * l21)
    # Rounding leaves about 1e-16 of a diagonal: a point known ten million times worse in depth.
    loose = ~(l22 * l22 > 1e-14 * f)
    if loose.any():
        raise DegenerateConfigurationError(
            f"the rays of point {int(np.argmax(loose))} are parallel, or all from one place "
            f"({int(loose.sum())} such points in all): leave it out, or take pictures from "
            "further apart"
        )
    return np.stack([l00, l10, l11, l20, l21, l22])


def forward(L: Array, b: Array) -> Array:
    """Return ``L⁻¹ b`` for many, L of shape (6, k), b of shape (3, …, k)."""
    out = np.empty_like(b)
    out[0] = b[0] / L[0]
    out[1] = (b[1] - L[1] * out[0]) / L[2]
    out[2] = (b[2] - L[3] * out[0] - L[4] * out[1]) / L[5]
    return out


def backward(L: Array, b: Array) -> Array:
    """Return ``L⁻ᵀ b`` for many, as `forward`."""
    out = np.empty_like(b)
    out[2] = b[2] / L[5]
    out[1] = (b[1] - L[4] * out[2]) / L[2]
    out[0] = (b[0] - L[1] * out[1] - L[3] * out[2]) / L[0]
    return out


def solve_normal_block(
    U: ArrayLike, W: ArrayLike, V: ArrayLike, g_c: ArrayLike, g_p: ArrayLike
) -> tuple[Array, Array]:
    """Return the step of cameras and points that solves normal equations in the shape of an arrow.

    Parameters
    ----------
    U : array_like, shape (c, c)
        Block of the cameras' numbers.
    W : array_like, shape (n, c, 3)
        What ties the cameras to each point.
    V : array_like, shape (n, 3, 3)
        Block of each point.
    g_c, g_p : array_like, shape (c,) and (n, 3)
        Gradients.

    Returns
    -------
    cameras, points : ndarray, shape (c,) and (n, 3)
        ``U cameras + Σ W points = -g_c`` and, for each point, ``Wᵀ cameras + V point = -g_p``.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong or a number is not finite.
    DegenerateConfigurationError
        If a block, or what is left for the cameras, is singular: nothing fixes a point or the
        gauge.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., appendix A6.3.

    Examples
    --------
    >>> one = np.eye(3)[None]
    >>> solve_normal_block(2 * np.eye(3), one, one, [1, 0, 3], [[0, 1, 1]])
    (array([-1.,  1., -2.]), array([[ 1., -2.,  1.]]))
    """
    U, W, V = check_numbers(U, "U"), check_numbers(W, "W"), check_numbers(V, "V")
    g_c, g_p = check_numbers(g_c, "g_c"), check_numbers(g_p, "g_p")
    shapes = [array.shape for array in (U, W, V, g_c, g_p)]
    c, n = len(np.atleast_1d(g_c)), len(np.atleast_1d(g_p))
    wanted = [(c, c), (n, c, 3), (n, 3, 3), (c,), (n, 3)]
    if shapes != wanted:
        raise ValueError(f"U, W, V, g_c and g_p must have shapes {wanted}, got {shapes}")
    try:
        solved = np.linalg.solve(V, np.concatenate([W.transpose(0, 2, 1), g_p[..., None]], axis=2))
        by_camera, alone = solved[..., :-1], solved[..., -1]  # V⁻¹ Wᵀ and V⁻¹ g_p
        S = U - np.einsum("nck,nkd->cd", W, by_camera)
        _check_regular(S, U)
        cameras = np.linalg.solve(S, np.einsum("nck,nk->c", W, alone) - g_c)
    except np.linalg.LinAlgError as error:
        raise DegenerateConfigurationError(
            "a block is singular: a point has too few rays, or nothing fixes the gauge"
        ) from error
    return cameras, -alone - by_camera @ cameras


def _check_regular(S: Array, U: Array) -> None:
    """Raise if what is left for the cameras is nothing but rounding in some direction."""
    diagonal = np.diag(U)
    size = np.sqrt(np.where(diagonal > 0, diagonal, 1))
    if np.linalg.svd(S / np.outer(size, size), compute_uv=False).min() < ROUNDING:
        raise np.linalg.LinAlgError("singular up to rounding")
