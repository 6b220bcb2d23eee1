"""Chapter 08 written out plainly: F from pairs, RANSAC, and the pose from E.

The library (`course_lib.epipolar`) checks what comes in, and searches better among wrong pairs.
The tests hold the two against each other.
"""

from __future__ import annotations

import math

import numpy as np

from course_lib import epipolar, homography


def eight_point(points1, points2):
    """Return the fundamental matrix of eight or more pairs, by the normalised linear method.

    Normalise the points of each picture with `normalise_points` of `course_lib.homography`, solve
    ``A f = 0`` for the normalised points, make the rank 2, and only then go back to pixels:
    ``F = T2ᵀ F' T1``.

    Parameters
    ----------
    points1, points2 : ndarray, shape (N, 2)
        N ≥ 8 pixels of picture 1, and their partners in picture 2.

    Returns
    -------
    ndarray, shape (3, 3)
        F of rank 2, for which ``x2ᵀ F x1`` is nearly 0. Any multiple of it is as good.

    Examples
    --------
    >>> one = np.array([[0, 0], [8, 0], [0, 8], [8, 8], [2, 3], [5, 1], [3, 6], [7, 4], [1, 7]])
    >>> other = one - [[1, 0], [2, 0], [4, 0], [1, 0], [3, 0], [2, 0], [5, 0], [4, 0], [1, 0]]
    >>> F = eight_point(one, other)
    >>> (F / F[2, 1]).round(6) + 0.0
    array([[ 0.,  0.,  0.],
           [ 0.,  0., -1.],
           [ 0.,  1.,  0.]])
    """
    near1, T1 = homography.normalise_points(points1)
    near2, T2 = homography.normalise_points(points2)
    rows = []
    for (u1, v1), (u2, v2) in zip(near1, near2, strict=True):
        rows.append([u2 * u1, u2 * v1, u2, v2 * u1, v2 * v1, v2, u1, v1, 1])
    f = np.linalg.svd(np.array(rows))[2][-1]
    U, s, Vt = np.linalg.svd(f.reshape(3, 3))
    s[2] = 0  # what is left has rank 2
    return T2.T @ (U @ np.diag(s) @ Vt) @ T1


def sampson_error(points1, points2, F):
    """Return how far pairs would have to move, both points together, to satisfy F: nearly.

    Parameters
    ----------
    points1, points2 : ndarray, shape (N, 2)
        Pixels of picture 1, and their partners in picture 2.
    F : ndarray, shape (3, 3)
        Fundamental matrix, of any scale.

    Returns
    -------
    ndarray, shape (N,)
        ``|x2ᵀ F x1| / √(a2² + b2² + a1² + b1²)`` in px, with the lines ``(a2, b2, c2) = F x1`` and
        ``(a1, b1, c1) = Fᵀ x2``.

    Examples
    --------
    >>> F = np.array([[0, 0, 0], [0, 0, -1], [0, 1, 0]])
    >>> sampson_error(np.array([[10, 30]]), np.array([[5, 32]]), F).round(4)
    array([1.4142])
    """
    x1 = np.column_stack([points1, np.ones(len(points1))])
    x2 = np.column_stack([points2, np.ones(len(points2))])
    lines2, lines1 = x1 @ F.T, x2 @ F
    products = np.sum(x2 * lines2, axis=1)
    squares = lines2[:, 0] ** 2 + lines2[:, 1] ** 2 + lines1[:, 0] ** 2 + lines1[:, 1] ** 2
    return np.abs(products) / np.sqrt(squares)


def ransac_iterations(confidence, size, wrong_share):
    """Return how many samples it takes until one without a wrong pair is likely among them.

    Parameters
    ----------
    confidence : float
        How likely that shall be, between 0 and 1: 0.99 for 99 %.
    size : int
        Pairs in a sample.
    wrong_share : float
        Share of the pairs that are wrong, between 0 and 1: 0.5 for half of them.

    Returns
    -------
    int
        The smallest number of samples that is enough.

    Examples
    --------
    >>> ransac_iterations(0.99, 5, 0.3)
    26
    """
    all_right = (1 - wrong_share) ** size
    return math.ceil(math.log(1 - confidence) / math.log(1 - all_right))


def ransac_fundamental(points1, points2, samples, threshold):
    """Return the fundamental matrix that most pairs agree on, although some pairs are wrong.

    For each sample: F from its eight pairs, then the errors of all pairs. The best sample is the
    one with which most pairs have an error below the threshold. Those pairs, all together, give
    the final F. `eight_point` and `sampson_error` of `course_lib.epipolar` are at hand.

    Parameters
    ----------
    points1, points2 : ndarray, shape (N, 2)
        Pixels of picture 1, and their supposed partners in picture 2.
    samples : ndarray of int, shape (M, 8)
        Numbers of eight pairs in each row: what chance has drawn.
    threshold : float
        Largest Sampson error of a right pair, px.

    Returns
    -------
    F : ndarray, shape (3, 3)
        From all pairs that fit the best sample. Any multiple of it is as good.
    fits : ndarray of bool, shape (N,)
        Which pairs these are.
    """
    best = np.zeros(len(points1), dtype=bool)
    for sample in samples:
        F = epipolar.eight_point(points1[sample], points2[sample])
        fits = epipolar.sampson_error(points1, points2, F) < threshold
        if fits.sum() > best.sum():
            best = fits
    return epipolar.eight_point(points1[best], points2[best]), best


def pose_from_essential(E, points1, points2):
    """Return the relative pose that an essential matrix allows and that puts points in front.

    ``U, _, Vt = np.linalg.svd(E)`` gives the four poses: R is ``U W Vt`` or ``U Wᵀ Vt``, times −1
    where that has the determinant −1; t is the last column of U, or its negative. Here
    ``W = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]``. `pair_depths` of `course_lib.epipolar` tells the
    depths of the points for a pose, before camera 1 and before camera 2: ``pair_depths(R, t,
    points1, points2)``. Write the four poses yourself.

    Parameters
    ----------
    E : ndarray, shape (3, 3)
        Essential matrix, of any scale and sign.
    points1, points2 : ndarray, shape (N, 2)
        Normalised coordinates in picture 1, and of the partners in picture 2.

    Returns
    -------
    R, t : ndarray, shape (3, 3) and (3,)
        Relative pose, camera 1 to camera 2, for which all points are in front of both cameras. The
        length of t is 1.

    Examples
    --------
    >>> E = np.array([[0, 0, 0], [0, 0, 1], [0, -1, 0]])
    >>> R, t = pose_from_essential(E, np.array([[0.25, 0]]), np.array([[0.0, 0]]))
    >>> t.round(6) + 0.0
    array([-1.,  0.,  0.])
    """
    U, _, Vt = np.linalg.svd(E)
    W = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    for turn in (U @ W @ Vt, U @ W.T @ Vt):
        R = turn * np.linalg.det(turn)
        for t in (U[:, 2], -U[:, 2]):
            Z1, Z2 = epipolar.pair_depths(R, t, points1, points2)
            if np.all(Z1 > 0) and np.all(Z2 > 0):
                return R, t
    return None
