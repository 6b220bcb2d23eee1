"""Chapter 07 written out plainly: what a student writes, for one board and sensible inputs.

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
    >>> homography_constraints(np.array([[2, 0, 5], [0, 3, 7], [0, 0, 1]]))
    array([[ 0,  6,  0,  0,  0,  0],
           [ 4,  0, -9,  0,  0,  0]])
    """

    def v(p, q):
        return np.array(
            [
                p[0] * q[0],
                p[0] * q[1] + p[1] * q[0],
                p[1] * q[1],
                p[0] * q[2] + p[2] * q[0],
                p[1] * q[2] + p[2] * q[1],
                p[2] * q[2],
            ]
        )

    h1, h2 = H[:, 0], H[:, 1]
    return np.array([v(h1, h2), v(h1, h1) - v(h2, h2)])


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
    >>> H1 = np.array([[1.5, 0.4, 2], [0.3, 1.9, 3], [-0.1, 0.3, 1.0]])
    >>> H2 = np.array([[2.1, -0.2, 1], [0.2, 1.8, 2], [0.2, 0.1, 1.0]])
    >>> H3 = np.array([[1.8, 0.1, 4], [-0.3, 2.2, 1], [0.1, -0.2, 1.0]])
    >>> intrinsics_from_homographies(np.array([H1, H2, H3])).shape
    (3, 3)
    """
    V = np.vstack([calibration.homography_constraints(H) for H in Hs])
    b11, b12, b22, b13, b23, b33 = np.linalg.svd(V)[2][-1]
    B = np.array([[b11, b12, b13], [b12, b22, b23], [b13, b23, b33]])
    if b11 < 0:  # the scale of b is free, and so is its sign
        B = -B
    L = np.linalg.cholesky(B)  # B = L Lᵀ, so L is K⁻ᵀ, up to scale
    K = np.linalg.inv(L.T)
    return K / K[2, 2]


def pose_from_homography(K, H):
    """Return where a board is, from the homography of its picture.

    ``K⁻¹ H = λ [r1 r2 t]`` with a number λ that may be negative.

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
    >>> t
    array([0.5, 0. , 5. ])
    """
    M = np.linalg.inv(K) @ H
    M = M / np.mean([np.linalg.norm(M[:, 0]), np.linalg.norm(M[:, 1])])
    if M[2, 2] < 0:
        M = -M
    r1, r2, t = M.T
    U, _, Vt = np.linalg.svd(np.column_stack([r1, r2, np.cross(r1, r2)]))
    return U @ Vt, t


def initial_distortion(ideal, observed, K):
    """Return k1 and k2 from where points should be without distortion, and where they are.

    The lens moves a pixel away from the principal point:
    ``u_observed - u_ideal = (u_ideal - cx) (k1 r² + k2 r⁴)``, and v alike. These equations are
    linear in k1 and k2: solve all of them, of u and of v, by least squares.

    Parameters
    ----------
    ideal : ndarray, shape (N, 2)
        Pixels that the camera without distortion would make.
    observed : ndarray, shape (N, 2)
        The same points as they were seen.
    K : ndarray, shape (3, 3)
        Intrinsics without skew, px. r is the distance of the ideal point from the principal point
        in normalised coordinates, ``((u - cx) / fx, (v - cy) / fy)``.

    Returns
    -------
    ndarray, shape (2,)
        ``k1, k2``.

    Examples
    --------
    >>> K = np.array([[100.0, 0, 0], [0, 100, 0], [0, 0, 1]])
    >>> ideal, observed = np.array([[100.0, 0], [0, 200]]), np.array([[90.0, 0], [0, 120]])
    >>> initial_distortion(ideal, observed, K).round(9) + 0.0
    array([-0.1,  0. ])
    """
    offset = ideal - K[:2, 2]
    x, y = offset[:, 0] / K[0, 0], offset[:, 1] / K[1, 1]
    r2 = (x**2 + y**2)[:, None]
    A = np.column_stack([(offset * r2).ravel(), (offset * r2**2).ravel()])
    return np.linalg.lstsq(A, (observed - ideal).ravel(), rcond=None)[0]


def reprojection_residuals(points, pixels, K, R, t, k):
    """Return by how much a camera misses the pixels of one view: projected minus observed.

    Parameters
    ----------
    points : ndarray, shape (N, 3)
        Points of the board, in its own frame, all of them before the camera.
    pixels : ndarray, shape (N, 2)
        Where they were observed.
    K : ndarray, shape (3, 3)
        Intrinsics in px, without skew.
    R, t : ndarray, shape (3, 3) and (3,)
        Pose, board to camera.
    k : ndarray, shape (2,)
        Radial distortion ``k1, k2``: normalised coordinates are multiplied with
        ``1 + k1 r² + k2 r⁴``.

    Returns
    -------
    ndarray, shape (N, 2)
        Residuals ``(du, dv)`` in px.

    Examples
    --------
    >>> K = np.array([[100.0, 0, 50], [0, 100, 40], [0, 0, 1]])
    >>> points, pixels = np.array([[1.0, 2, 0]]), np.array([[60.0, 59]])
    >>> reprojection_residuals(points, pixels, K, np.eye(3), np.array([0, 0, 10]), np.zeros(2))
    array([[0., 1.]])
    """
    X = points @ R.T + t
    x = X[:, :2] / X[:, 2:]
    r2 = (x**2).sum(axis=1, keepdims=True)
    x_d = x * (1 + k[0] * r2 + k[1] * r2**2)
    projected = x_d * [K[0, 0], K[1, 1]] + K[:2, 2]
    return projected - pixels


def rms_error(residuals):
    """Return the root mean square of residuals, over points: how far a typical point is off.

    Parameters
    ----------
    residuals : ndarray, shape (N, 2)
        Differences ``(du, dv)`` of N points, px.

    Returns
    -------
    float
        Root of the mean of ``du² + dv²`` over the N points, px.

    Examples
    --------
    >>> float(rms_error(np.array([[3.0, 4], [0, 0], [0, 0], [0, 0]])))
    2.5
    """
    return np.sqrt((residuals**2).sum(axis=1).mean())


def refine_calibration(parameters, residuals, J, damping):
    """Return all parameters of a calibration after one step of Levenberg and Marquardt.

    Parameters
    ----------
    parameters : ndarray, shape (n,)
        Where the step begins: camera and poses, all in one row.
    residuals : ndarray, shape (m,)
        Projected minus observed pixels there, all in one row.
    J : ndarray, shape (m, n)
        Derivatives of the residuals by the parameters.
    damping : float
        λ, which keeps the step short where the linear problem is not to be trusted.

    Returns
    -------
    ndarray, shape (n,)
        The parameters plus the step δ that solves ``(JᵀJ + λ D) δ = -Jᵀ residuals``. D is the
        matrix that has the diagonal of JᵀJ, and zeros elsewhere.

    Examples
    --------
    One parameter, and pixels that should move by 6: undamped, and with a step half as long.

    >>> J = np.array([[2.0], [2.0]])
    >>> refine_calibration(np.array([10.0]), np.array([6.0, 6.0]), J, 0)
    array([7.])
    >>> refine_calibration(np.array([10.0]), np.array([6.0, 6.0]), J, 1)
    array([8.5])
    """
    N = J.T @ J
    step = np.linalg.solve(N + damping * np.diag(np.diag(N)), -J.T @ residuals)
    return parameters + step


def reject_views(residuals, limit):
    """Return which views to keep: those whose error is not far above what is usual.

    Parameters
    ----------
    residuals : ndarray, shape (V, N, 2)
        Residuals ``(du, dv)`` of N points in each of V views, px.
    limit : float
        A view goes if its RMS error (over points, as `rms_error`) is more than so many times the
        median of the RMS errors of all views.

    Returns
    -------
    ndarray of bool, shape (V,)
        True for the views to keep.

    Examples
    --------
    >>> reject_views(np.array([[[0.3, 0]], [[0, 0.2]], [[0.9, 0]]]), 2)
    array([ True,  True, False])
    """
    rms = np.sqrt((residuals**2).sum(axis=2).mean(axis=1))
    return rms <= limit * np.median(rms)


def parameter_covariance(J, residuals):
    """Return how uncertain the parameters of a calibration are, judged by what is left over.

    Parameters
    ----------
    J : ndarray, shape (m, n)
        Derivatives of the residuals by the parameters, at the minimum.
    residuals : ndarray, shape (m,)
        What is left over there, px: m numbers, two for each point.

    Returns
    -------
    ndarray, shape (n, n)
        ``σ² (JᵀJ)⁻¹``, where σ² is the sum of the squared residuals, divided by how many more
        residuals than parameters there are. The roots of its diagonal are the standard deviations
        of the parameters.

    Examples
    --------
    The mean of four numbers, and its variance:

    >>> J, residuals = np.array([[1.0], [1], [1], [1]]), np.array([-1.0, 1, -1, 1])
    >>> parameter_covariance(J, residuals).round(4)
    array([[0.3333]])
    """
    m, n = J.shape
    variance = residuals @ residuals / (m - n)
    return variance * np.linalg.inv(J.T @ J)
