"""The essential matrix of five pairs: the least that a relative orientation needs.

Five rows leave four matrices; every mixture ``x E1 + y E2 + z E3 + E4`` of them fits. An essential
matrix has ``det E = 0`` and ``2 E Eᵀ E - tr(E Eᵀ) E = 0``: ten cubic equations in x, y, z. Use
`five_point` through `course_lib.epipolar`.
"""

from __future__ import annotations

from itertools import combinations_with_replacement, product

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, DegenerateConfigurationError
from course_lib.epipolar.fundamental import UNDETERMINED, pair_rows
from course_lib.epipolar.lines import check_pairs
from course_lib.epipolar.matrices import unit

#: Products of three of x, y, z and 1 (numbered 0 to 3): first the ten without a 1.
MONOMIALS = sorted(combinations_with_replacement(range(4), 3), key=lambda m: (3 in m, m))
#: Adds up the 64 products of three of (x, y, z, 1) that are the same monomial, (64, 20).
COLLECT = np.zeros((64, 20))
for _row, _factors in enumerate(product(range(4), repeat=3)):
    COLLECT[_row, MONOMIALS.index(tuple(sorted(_factors)))] = 1  # type: ignore[arg-type]
#: The lower monomials xx, xy, xz, x, yy, yz, y, zz, z, 1 times x: their places among all.
LOWER = MONOMIALS[10:]
TIMES_X = [MONOMIALS.index(tuple(sorted((0, *_m[:2])))) for _m in LOWER]  # type: ignore[arg-type]
#: Where x, y, z and 1 are among the lower monomials.
PLACES = [LOWER.index((i, 3, 3)) for i in range(4)]
#: An imaginary part that is rounding, as a share of the eigenvalue.
REAL = 1e-6
#: The parity of permutations, for determinants.
EPSILON = np.zeros((3, 3, 3))
EPSILON[[0, 1, 2], [1, 2, 0], [2, 0, 1]], EPSILON[[0, 2, 1], [2, 1, 0], [1, 0, 2]] = 1, -1


def five_point(points1: ArrayLike, points2: ArrayLike) -> Array:
    """Return the essential matrices of five pairs: up to ten of them.

    Parameters
    ----------
    points1, points2 : array_like, shape (5, 2)
        Normalised coordinates ``K⁻¹ x`` in picture 1, and of their partners in picture 2.

    Returns
    -------
    ndarray, shape (0 to 10, 3, 3)
        Matrices of length 1, for each of which ``x2ᵀ E x1 = 0``. Two singular values are the
        same, the third is zero.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or there are not five pairs.
    DegenerateConfigurationError
        If the rows of the pairs are dependent, or infinitely many matrices fit.

    References
    ----------
    H. Stewénius, C. Engels & D. Nistér, "Recent developments on direct relative orientation",
    ISPRS Journal 60 (2006).
    """
    points1, points2 = check_pairs(points1, points2, least=5)
    if len(points1) != 5:
        raise ValueError(f"5 pairs are needed, got {len(points1)}: for more use ransac_pose")
    s = np.linalg.svd(_rows(points1[None], points2[None])[0], compute_uv=False)
    if s[4] <= UNDETERMINED * s[0]:
        raise DegenerateConfigurationError(
            "the five pairs are dependent: take points that differ, and not all on one line"
        )
    try:
        return five_point_samples(points1[None], points2[None])
    except np.linalg.LinAlgError as error:
        raise DegenerateConfigurationError(
            "infinitely many essential matrices fit: take other points, or move the camera"
        ) from error


def _rows(points1: Array, points2: Array) -> Array:
    """Return rows of the pairs of samples, each scaled to length 1, (B, 5, 9)."""
    A = pair_rows(points1, points2)
    return np.asarray(A / np.linalg.norm(A, axis=-1, keepdims=True))


def five_point_samples(points1: Array, points2: Array) -> Array:
    """Return the essential matrices of samples of five pairs, (B, 5, 2) twice: (M, 3, 3)."""
    Q = np.linalg.qr(_rows(points1, points2).swapaxes(1, 2), mode="complete")[0]
    basis = Q[:, :, 5:].swapaxes(1, 2).reshape(-1, 4, 3, 3)
    M = _equations(basis)
    # The ten monomials of degree three follow from the lower ones.
    upper = -np.linalg.solve(M[..., :10], M[..., 10:])
    action = np.zeros((len(M), 10, 10))
    for row, place in enumerate(TIMES_X):
        if place < 10:
            action[:, row] = upper[:, place]
        else:
            action[:, row, place - 10] = 1
    values, vectors = np.linalg.eig(action)
    real = np.abs(values.imag) <= REAL * np.maximum(1, np.abs(values.real))
    sample, which = np.nonzero(real)
    mixing = vectors[sample, :, which].real[:, PLACES]
    E = np.einsum("mi,mijk->mjk", mixing, basis[sample])
    return unit(E[np.isfinite(E).all(axis=(1, 2)) & (np.abs(E).max(axis=(1, 2)) > 0)])


def _equations(basis: Array) -> Array:
    """Return the coefficients of ten cubic equations by monomials, (B, 10, 20)."""
    squares = np.einsum("bixy,bjzy->bijxz", basis, basis)
    traces = np.einsum("bijxx->bij", squares)
    cubes = 2 * np.einsum("bijxz,bkzy->bxyijk", squares, basis, optimize=True)
    cubes -= np.einsum("bij,bkxy->bxyijk", traces, basis)
    crossed = np.einsum("xyz,bjx,bky->bjkz", EPSILON, basis[:, :, 0], basis[:, :, 1], optimize=True)
    determinants = np.einsum("bjkz,biz->bijk", crossed, basis[:, :, 2])
    products = np.concatenate([cubes.reshape(-1, 9, 64), determinants.reshape(-1, 1, 64)], axis=1)
    return np.asarray(products @ COLLECT)
