"""The fundamental matrix from pairs of points: eight of them, seven, or many.

Use these functions through `course_lib.epipolar`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import Array, DegenerateConfigurationError
from course_lib.correspondences import check_scatter, check_spread
from course_lib.epipolar.lines import check_pairs
from course_lib.epipolar.matrices import unit
from course_lib.epipolar.polynomials import real_roots_of_cubics
from course_lib.homogeneous import to_homogeneous
from course_lib.homography import normalise_points

#: The second smallest singular value, as a share of the largest, that leaves F undetermined.
UNDETERMINED = 1e-10
MANY_FIT = (
    "more than one fundamental matrix fits the pairs: the points are on a plane (or on another "
    "critical surface), or the camera has only turned; take points at different depths, move the "
    "camera, or use a homography"
)


def eight_point(points1: ArrayLike, points2: ArrayLike) -> Array:
    """Return the fundamental matrix of eight or more pairs, by the normalised linear method.

    Points are normalised by `normalise_points`. Each pair gives one row of A. Of all vectors f of
    length 1, the one is taken for which ``A f`` is shortest. Its matrix has rank 3 if the points
    have errors; the nearest one with rank 2 is what is left without its smallest singular value.

    Parameters
    ----------
    points1, points2 : array_like, shape (N, 2)
        N ≥ 8 pixels of picture 1, and their partners in picture 2.

    Returns
    -------
    ndarray, shape (3, 3)
        F of rank 2 and length 1, for which ``x2ᵀ F x1`` is nearly 0; its sign has no meaning.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or there are fewer than eight pairs.
    DegenerateConfigurationError
        If the points of a picture are on a line, or more than one matrix fits: the points are on
        one plane, or the camera has only turned. (Noise hides that: see `find_degeneracy`.)

    References
    ----------
    R. Hartley, "In defense of the eight-point algorithm", IEEE PAMI 19 (1997); Hartley &
    Zisserman, Multiple View Geometry, 2nd ed., algorithm 11.1.

    Examples
    --------
    >>> from course_lib.camera import camera_matrix, project
    >>> K, cube = np.diag([800, 800, 1]), np.array([[x, y, z] for x in (-1, 1)
    ...                                           for y in (-1, 1) for z in (5, 7)])
    >>> cube = np.concatenate([cube, [[0.5, 0.2, 9]]])
    >>> one = project(cube, camera_matrix(K, np.eye(3), [0, 0, 0]))
    >>> other = project(cube, camera_matrix(K, np.eye(3), [-1, 0, 0]))
    >>> F = eight_point(one, other)
    >>> (F / F[2, 1]).round(6) + 0.0
    array([[ 0.,  0.,  0.],
           [ 0.,  0., -1.],
           [ 0.,  1.,  0.]])
    """
    points1, points2 = check_pairs(points1, points2, least=8)
    check_spread(points1, 2, "points1")
    check_spread(points2, 2, "points2")
    near1, T1 = normalise_points(points1)
    near2, T2 = normalise_points(points2)
    A = pair_rows(near1, near2)
    # Of a tall matrix only R matters: it has the same singular values and right vectors.
    _, s, Vt = np.linalg.svd(np.linalg.qr(A, mode="r") if len(A) > 9 else A)
    if s[7] <= UNDETERMINED * s[0]:
        raise DegenerateConfigurationError(MANY_FIT)
    return unit(T2.T @ with_rank_two(Vt[8].reshape(3, 3)) @ T1)


def with_rank_two(F: Array) -> Array:
    """Return the matrix of rank 2 that is nearest to F, by the sum of squares."""
    U, s, Vt = np.linalg.svd(F)
    return np.asarray(U[:, :2] * s[:2] @ Vt[:2])


def pair_rows(points1: Array, points2: Array) -> Array:
    """Return the rows of ``A f = 0``, (..., N, 9): products of the coordinates of each pair."""
    one, other = (
        np.concatenate([p, np.ones_like(p[..., :1])], axis=-1) for p in (points1, points2)
    )
    return np.asarray((other[..., :, None] * one[..., None, :]).reshape(*one.shape[:-1], 9))


def seven_point(points1: ArrayLike, points2: ArrayLike) -> Array:
    """Return the fundamental matrices of seven pairs: one, two or three of them.

    Seven rows leave two matrices, and every mixture ``λ F1 + F2`` of them fits. Rank 2 asks for
    ``det(λ F1 + F2) = 0``, a cubic equation.

    Parameters
    ----------
    points1, points2 : array_like, shape (7, 2)
        Pixels of picture 1, and their partners in picture 2.

    Returns
    -------
    ndarray, shape (1 to 3, 3, 3)
        Matrices of rank 2 and length 1, for each of which ``x2ᵀ F x1 = 0``.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or there are not seven pairs.
    DegenerateConfigurationError
        If the points of a picture are on a line, or more than three matrices fit.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 11.1.2.
    """
    points1, points2 = check_pairs(points1, points2, least=7)
    if len(points1) != 7:
        raise ValueError(f"7 pairs are needed, got {len(points1)}: for more use eight_point")
    check_spread(points1, 2, "points1")
    check_spread(points2, 2, "points2")
    near1, T1 = normalise_points(points1)
    near2, T2 = normalise_points(points2)
    _, s, Vt = np.linalg.svd(pair_rows(near1, near2))
    if s[6] <= UNDETERMINED * s[0]:
        raise DegenerateConfigurationError(MANY_FIT)
    found, _ = rank_two_mixtures(Vt[7:8].reshape(1, 3, 3), Vt[8:9].reshape(1, 3, 3))
    if not len(found):
        raise DegenerateConfigurationError(MANY_FIT)
    return unit(np.asarray(T2.T @ found @ T1))


def rank_two_mixtures(one: Array, other: Array) -> tuple[Array, NDArray[np.intp]]:
    """Return the matrices ``λ F1 + F2`` of rank 2, for many pairs of matrices (B, 3, 3).

    Returns
    -------
    found : ndarray, shape (M, 3, 3)
        Between none and three for each pair.
    origin : ndarray, shape (M,)
        The number of the pair that each belongs to.
    """
    a, b = cofactors(one), cofactors(other)
    cubics = np.stack(
        [
            (one[:, 0] * a[:, 0]).sum(axis=1),
            (a * other).sum(axis=(1, 2)),
            (b * one).sum(axis=(1, 2)),
            (other[:, 0] * b[:, 0]).sum(axis=1),
        ],
        axis=1,
    )
    roots = real_roots_of_cubics(cubics)
    pair, which = np.nonzero(np.isfinite(roots))
    mixed = roots[pair, which, None, None] * one[pair] + other[pair]
    return mixed, pair


def cofactors(M: Array) -> Array:
    """Return the cofactors of matrices (B, 3, 3): the derivatives of the determinant."""
    out = np.empty_like(M)
    for i in range(3):
        p, q = M[:, (i + 1) % 3], M[:, (i + 2) % 3]
        for j in range(3):
            k, l = (j + 1) % 3, (j + 2) % 3  # noqa: E741 (an index)
            out[:, i, j] = p[:, k] * q[:, l] - p[:, l] * q[:, k]
    return out


def seven_point_samples(points1: Array, points2: Array, free: int = 7) -> Array:
    """Return matrices of rank 2 through samples of seven pairs, (B, 7, 2) twice: (M, 3, 3).

    The rows are solved for all numbers of F but the last one and the number `free`, 0 to 7. That
    is quicker than singular values, and good enough for hypotheses; a matrix in which both are
    zero is found with another `free`.
    """
    A, solved_for = pair_rows(points1, points2), [c for c in range(8) if c != free]
    left, right = A[..., solved_for], A[..., [free, 8]]
    try:
        solved = -np.linalg.solve(left, right)
    except np.linalg.LinAlgError:
        solved = -np.linalg.pinv(left) @ right
    basis = np.zeros((2, len(A), 9))
    basis[..., solved_for] = solved.transpose(2, 0, 1)
    basis[0, :, free] = basis[1, :, 8] = 1
    basis /= np.sqrt((basis * basis).sum(axis=2, keepdims=True))
    return rank_two_mixtures(*basis.reshape(2, -1, 3, 3))[0]


def common_scale(points1: Array, points2: Array) -> tuple[Array, Array, Array, Array, float]:
    """Return pairs as homogeneous columns about the origin, with one scale for both pictures.

    With one scale a distance stays a distance, and the errors of both pictures stay comparable.

    Returns
    -------
    x1, x2 : ndarray, shape (3, N)
        Homogeneous columns.
    T1, T2 : ndarray, shape (3, 3)
        What takes pixels there.
    scale : float
        What one pixel has become.
    """
    centres = [p.mean(axis=0) for p in (points1, points2)]
    shifted = [p - c for p, c in zip((points1, points2), centres, strict=True)]
    for moved, centre, name in zip(shifted, centres, ("points1", "points2"), strict=True):
        check_scatter(moved.T @ moved / len(moved), centre, 2, name)
    scale = float(np.sqrt(4 * len(points1) / sum((m * m).sum() for m in shifted)))
    columns = [to_homogeneous(scale * m).T.copy() for m in shifted]
    T = [np.array([[scale, 0, -scale * u], [0, scale, -scale * v], [0, 0, 1]]) for u, v in centres]
    return columns[0], columns[1], T[0], T[1], scale
