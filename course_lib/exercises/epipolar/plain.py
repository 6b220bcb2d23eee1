"""Chapter 08 written out plainly: matrices of known cameras, lines, epipoles, distances.

The library (`course_lib.epipolar`) checks what comes in and knows more cases. The tests hold the
two against each other.
"""

from __future__ import annotations

import numpy as np

from course_lib import transforms


def skew(v):
    """Return the matrix that multiplies like a cross product: ``skew(v) @ x`` is ``v × x``.

    Parameters
    ----------
    v : ndarray, shape (3,)
        The left factor, ``(x, y, z)``.

    Returns
    -------
    ndarray, shape (3, 3)
        ``[v]ₓ``. Its transpose is its negative.

    Examples
    --------
    >>> skew(np.array([1, 2, 3]))
    array([[ 0, -3,  2],
           [ 3,  0, -1],
           [-2,  1,  0]])
    """
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def essential_from_pose(R, t):
    """Return the essential matrix of two cameras.

    Parameters
    ----------
    R, t : ndarray, shape (3, 3) and (3,)
        Relative pose, camera 1 to camera 2: ``X2 = R X1 + t``.

    Returns
    -------
    ndarray, shape (3, 3)
        E, for which ``x2ᵀ E x1 = 0`` in normalised coordinates. Any multiple of it is as good.

    Examples
    --------
    >>> essential_from_pose(np.eye(3), np.array([-1, 0, 0]))
    array([[ 0.,  0.,  0.],
           [ 0.,  0.,  1.],
           [ 0., -1.,  0.]])
    """
    return transforms.skew(t) @ R


def fundamental_from_cameras(P1, P2):
    """Return the fundamental matrix of two cameras.

    The left three columns of a camera matrix are M, the last one is p: ``P = [M | p]``.

    Parameters
    ----------
    P1, P2 : ndarray, shape (3, 4)
        Camera matrices of picture 1 and picture 2, world to pixels.

    Returns
    -------
    ndarray, shape (3, 3)
        F, for which ``x2ᵀ F x1 = 0`` in pixels. Any multiple of it is as good.

    Examples
    --------
    >>> P1 = np.array([[100, 0, 50, 0], [0, 100, 40, 0], [0, 0, 1, 0]])
    >>> P2 = np.array([[100, 0, 50, -200], [0, 100, 40, 0], [0, 0, 1, 0]])
    >>> F = fundamental_from_cameras(P1, P2)
    >>> F.round(3) + 0.0
    array([[   0.,    0.,    0.],
           [   0.,    0.,  200.],
           [   0., -200.,    0.]])
    """
    M1, M2 = P1[:, :3], P2[:, :3]
    centre = -np.linalg.inv(M1) @ P1[:, 3]
    e2 = M2 @ centre + P2[:, 3]
    return transforms.skew(e2) @ M2 @ np.linalg.inv(M1)


def epipolar_lines(points, F):
    """Return the lines of picture 2 on which the partners of points of picture 1 lie.

    Parameters
    ----------
    points : ndarray, shape (N, 2)
        Pixels of picture 1 in rows.
    F : ndarray, shape (3, 3)
        Fundamental matrix, ``x2ᵀ F x1 = 0``.

    Returns
    -------
    ndarray, shape (N, 3)
        A line ``(a, b, c)`` in each row, with ``a u + b v + c = 0`` for the pixels (u, v) on it.
        It is scaled so that ``a² + b² = 1``; its sign has no meaning.

    Examples
    --------
    >>> F = np.array([[0, 0, 0], [0, 0, -1], [0, 1, 0]])  # the same row in both pictures
    >>> epipolar_lines(np.array([[10, 30], [20, 50]]), F)
    array([[ 0., -1., 30.],
           [ 0., -1., 50.]])
    """
    x1 = np.column_stack([points, np.ones(len(points))])
    lines = x1 @ F.T
    return lines / np.hypot(lines[:, 0], lines[:, 1])[:, None]


def epipole(F):
    """Return the epipole of picture 1: the point that all its epipolar lines share.

    Parameters
    ----------
    F : ndarray, shape (3, 3)
        Fundamental matrix, ``x2ᵀ F x1 = 0``.

    Returns
    -------
    ndarray, shape (2,)
        The pixel (u, v) with ``F (u, v, 1)ᵀ = 0``: where picture 1 would show camera 2. It may be
        far outside of the picture, but is not at infinity here.

    Examples
    --------
    >>> epipole(np.array([[0, -1, 50], [1, 0, -60], [-50, 60, 0]])).round(6)
    array([60., 50.])
    """
    e = np.linalg.svd(F)[2][-1]
    return e[:2] / e[2]


def line_distance(points, lines):
    """Return the distances of points from lines, one line for each point.

    Parameters
    ----------
    points : ndarray, shape (N, 2)
        Pixels in rows.
    lines : ndarray, shape (N, 3)
        A line ``(a, b, c)`` in each row, of any scale: the first is for the first point.

    Returns
    -------
    ndarray, shape (N,)
        Distances in px, never negative.

    Examples
    --------
    >>> line_distance(np.array([[3, 4], [0, 0]]), np.array([[0, 2, -2], [3, 4, -10]]))
    array([3., 2.])
    """
    u, v = points.T
    a, b, c = lines.T
    return np.abs(a * u + b * v + c) / np.sqrt(a**2 + b**2)
