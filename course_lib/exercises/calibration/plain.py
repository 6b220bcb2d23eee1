"""Chapter 07 written out plainly: from the board to its pose.

The library (`course_lib.calibration`) checks what comes in, takes all views at once and knows more
of distortion. The tests hold the two against each other.
"""

from __future__ import annotations

import numpy as np

from course_lib import calibration


def board_points(columns, rows, square):
    """Return the inner corners of a checkerboard, in the board's own frame.

    Parameters
    ----------
    columns, rows : int
        How many inner corners there are in a row, and how many rows of them.
    square : float
        Side of a square, mm.

    Returns
    -------
    ndarray, shape (columns * rows, 3)
        Points ``(x, y, 0)`` in mm. The first is ``(0, 0, 0)``; x grows along the first row to its
        end, then the next row begins, one square further in y.

    Examples
    --------
    >>> board_points(3, 2, 25)
    array([[ 0.,  0.,  0.],
           [25.,  0.,  0.],
           [50.,  0.,  0.],
           [ 0., 25.,  0.],
           [25., 25.,  0.],
           [50., 25.,  0.]])
    """
    points = [
        (column * square, row * square, 0) for row in range(rows) for column in range(columns)
    ]
    return np.array(points, dtype=float)


def homography_constraints(H):
    """Return the two equations that one view of a board gives for ``B = K⁻ᵀ K⁻¹``.

    B is symmetric: the six numbers ``b = (B11, B12, B22, B13, B23, B33)`` are all of it. With the
    columns h1, h2, h3 of H, ``hiᵀ B hj`` is the scalar product of b with a row v_ij of six numbers.

    Parameters
    ----------
    H : ndarray, shape (3, 3)
        Homography from the board's x and y to pixels.

    Returns
    -------
    ndarray, shape (2, 6)
        First the row ``v12``, then the row ``v11 - v22``. Times b, each is zero.

    Examples
    --------
    >>> homography_constraints(np.array([[1, 4, 7], [2, 0, 6], [3, 5, 1]]))
    array([[  4,   8,   0,  17,  10,  15],
           [-15,   4,   4, -34,  12, -16]])
    """
    (g1, g2, g3), (q1, q2, q3) = H[:, 0], H[:, 1]
    v12 = [g1 * q1, g1 * q2 + g2 * q1, g2 * q2, g1 * q3 + g3 * q1, g2 * q3 + g3 * q2, g3 * q3]
    v11 = [g1 * g1, 2 * g1 * g2, g2 * g2, 2 * g1 * g3, 2 * g2 * g3, g3 * g3]
    v22 = [q1 * q1, 2 * q1 * q2, q2 * q2, 2 * q1 * q3, 2 * q2 * q3, q3 * q3]
    return np.array([v12, np.subtract(v11, v22)])


def intrinsics_from_homographies(Hs):
    """Return the intrinsics from three or more views of a board.

    `homography_constraints` of `course_lib.calibration` gives the two rows of a view. All rows
    below each other, times b, are zero; from b comes B, and from ``B = K⁻ᵀ K⁻¹`` comes K.

    Parameters
    ----------
    Hs : ndarray, shape (N, 3, 3)
        Homographies of N ≥ 3 views, from the board's x and y to pixels.

    Returns
    -------
    ndarray, shape (3, 3)
        ``K = [[fx, s, cx], [0, fy, cy], [0, 0, 1]]``, px.

    Examples
    --------
    >>> H1 = np.array([[800, 192, 3200], [0, 784, 2400], [0, 0.6, 10]])
    >>> H2 = np.array([[448, 0, 3200], [-144, 800, 2400], [-0.6, 0, 10]])
    >>> H3 = np.array([[736, 0, 3200], [192, 800, 2400], [0.8, 0, 10]])
    >>> intrinsics_from_homographies(np.array([H1, H2, H3])).round(3) + 0.0
    array([[800.,   0., 320.],
           [  0., 800., 240.],
           [  0.,   0.,   1.]])
    """
    A = np.vstack([calibration.homography_constraints(H) for H in Hs])
    b11, b12, b22, b13, b23, b33 = np.linalg.svd(A)[2][-1]
    B = np.array([[b11, b12, b13], [b12, b22, b23], [b13, b23, b33]])
    if b11 < 0:  # the scale of b is free, and so is its sign
        B = -B
    L = np.linalg.cholesky(B)  # B = L Lᵀ, so L is K⁻ᵀ, up to scale
    K = np.linalg.inv(L.T)
    return K / K[2, 2]


def pose_from_homography(K, H):
    """Return where a board is, from the homography of its picture.

    ``K⁻¹ H = ρ [r1 r2 t]`` with a number ρ that may be negative.

    Parameters
    ----------
    K : ndarray, shape (3, 3)
        Intrinsics in px.
    H : ndarray, shape (3, 3)
        Homography from the board's x and y to pixels, with some noise.

    Returns
    -------
    R : ndarray, shape (3, 3)
        Rotation, board to camera: the nearest to ``[r1 r2 r1 × r2]``, which noise has made skew.
    t : ndarray, shape (3,)
        Translation, board to camera, scaled so that r1 and r2 have the mean length 1; the board's
        origin is before the camera.

    Examples
    --------
    >>> H = np.array([[-1600.0, 0, -800], [0, -1600, 0], [0, 0, -10]])
    >>> R, t = pose_from_homography(np.diag([800.0, 800, 1]), H)
    >>> t + 0.0
    array([0.5, 0. , 5. ])
    """
    M = np.linalg.inv(K) @ H
    M = M / np.mean([np.linalg.norm(M[:, 0]), np.linalg.norm(M[:, 1])])
    if M[2, 2] < 0:
        M = -M
    r1, r2, t = M.T
    U, _, Vt = np.linalg.svd(np.column_stack([r1, r2, np.cross(r1, r2)]))
    return U @ Vt, t
