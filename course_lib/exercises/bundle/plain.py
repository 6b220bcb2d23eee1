"""Chapter 10 written out plainly: the pose of a camera, derivatives, one step, the adjustment.

The library (`course_lib.orientation`, `course_lib.bundle`) checks what comes in, and takes large
blocks. The tests hold the two against each other.
"""

from __future__ import annotations

import numpy as np

from course_lib import bundle, resection, transforms


def resect_camera(points, pixels, K):
    """Return the pose of a camera with known intrinsics, from points in space and their pixels.

    ``P = resection.camera_dlt(points, pixels)`` of chapter 06 is ``ρ K [R | t]``, with an unknown
    number ρ > 0. So ``K⁻¹ P = ρ [R | t]``. With errors in the pixels, its first three columns are
    not quite a rotation times ρ.

    Parameters
    ----------
    points : ndarray, shape (N, 3)
        N ≥ 6 points of the world, not in one plane.
    pixels : ndarray, shape (N, 2)
        Where the camera sees them, some with errors.
    K : ndarray, shape (3, 3)
        Intrinsics, px.

    Returns
    -------
    R : ndarray, shape (3, 3)
        Rotation, world to camera: with ``U S Vᵀ`` the SVD of the first three columns of K⁻¹ P, the
        nearest rotation ``U Vᵀ``.
    t : ndarray, shape (3,)
        Translation, world to camera: the last column of K⁻¹ P, divided by ρ, for which the mean of
        the three numbers S is taken.

    Examples
    --------
    >>> K = np.diag([100.0, 100, 1])
    >>> points = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    >>> pixels = 100 * points[:, :2] / (points[:, 2:] + 5)
    >>> R, t = resect_camera(points, pixels, K)
    >>> t.round(6) + 0.0
    array([0., 0., 5.])
    """
    P = resection.camera_dlt(points, pixels)
    M = np.linalg.inv(K) @ P
    U, S, Vt = np.linalg.svd(M[:, :3])
    return U @ Vt, M[:, 3] / S.mean()


def reprojection_jacobian(point, K, R, t):
    """Return how the pixel of a point changes with the pose of the camera and with the point.

    In the camera's frame the point is ``q = R point + t = (x, y, z)``. Two links make a chain:

    - the pixel ``u = fx x/z + cx``, ``v = fy y/z + cy`` changes with q by a matrix A of shape
      (2, 3): derivatives of u in the first row, of v in the second, by x, y and z in the columns;
    - q changes by ``-[q]ₓ`` times w, if R is followed by a small turn w of all that the camera
      sees (q goes to ``q + w × q``), by ``-R`` times a move of the camera's centre, and by ``R``
      times a move of the point.

    Parameters
    ----------
    point : ndarray, shape (3,)
        The point in the world.
    K : ndarray, shape (3, 3)
        Intrinsics, px, without skew.
    R, t : ndarray, shape (3, 3) and (3,)
        Pose, world to camera.

    Returns
    -------
    by_pose : ndarray, shape (2, 6)
        Three columns for the turn w, and next to them three for the move of the centre.
    by_point : ndarray, shape (2, 3)
        For the move of the point. (``transforms.skew(q)`` is ``[q]ₓ``, as in chapter 08.)

    Examples
    --------
    >>> by_pose, by_point = reprojection_jacobian(
    ...     np.array([1.0, 0, 2]), np.diag([100.0, 100, 1]), np.eye(3), np.zeros(3)
    ... )
    >>> by_point + 0.0
    array([[ 50.,   0., -25.],
           [  0.,  50.,   0.]])
    >>> by_pose + 0.0
    array([[   0.,  125.,    0.,  -50.,    0.,   25.],
           [-100.,    0.,   50.,    0.,  -50.,    0.]])
    """
    x, y, z = q = R @ point + t
    fx, fy = K[0, 0], K[1, 1]
    A = np.array([[fx / z, 0, -fx * x / z**2], [0, fy / z, -fy * y / z**2]])
    by_pose = np.hstack([-A @ transforms.skew(q), -A @ R])
    return by_pose, A @ R


def solve_normal_block(U, W, V, g_c, g_p):
    """Return the step of cameras and points, from small systems instead of one large one.

    The equations are, with a block ``W_j``, ``V_j`` and a gradient ``g_j`` for each point j,

    - ``U cameras + Σ W_j point_j = -g_c``, for the cameras,
    - ``W_jᵀ cameras + V_j point_j = -g_j``, for each point.

    Solve the second for ``point_j`` and put it into the first: only the cameras are left,
    ``(U - Σ W_j V_j⁻¹ W_jᵀ) cameras = -g_c + Σ W_j V_j⁻¹ g_j``. Then each point follows.

    Parameters
    ----------
    U : ndarray, shape (c, c)
        Block of the c numbers of all cameras.
    W : ndarray, shape (n, c, 3)
        For each of n points, what ties the cameras to it.
    V : ndarray, shape (n, 3, 3)
        Block of each point.
    g_c, g_p : ndarray, shape (c,) and (n, 3)
        Gradients of the cameras, and of each point in a row.

    Returns
    -------
    cameras : ndarray, shape (c,)
        Step of the cameras.
    points : ndarray, shape (n, 3)
        Step of each point.

    Examples
    --------
    One camera number, one point:

    >>> U, W, V = np.array([[4.0]]), np.array([[[1.0, 0, 0]]]), 0.5 * np.eye(3)[None]
    >>> cameras, points = solve_normal_block(U, W, V, np.array([2.0]), np.array([[0, 1.0, 0]]))
    >>> cameras
    array([-1.])
    >>> points + 0.0
    array([[ 2., -2.,  0.]])
    """
    S, right = U, -g_c
    for j in range(len(V)):
        Y = W[j] @ np.linalg.inv(V[j])
        S = S - Y @ W[j].T
        right = right + Y @ g_p[j]
    cameras = np.linalg.solve(S, right)
    points = np.empty_like(g_p)
    for j in range(len(V)):
        points[j] = np.linalg.solve(V[j], -g_p[j] - W[j].T @ cameras)
    return cameras, points


def bundle_adjust(K, R, t, points, pixels, damping):
    """Return cameras and points after one damped step, if it helps, and the next damping.

    1. ``U, W, V, g_c, g_p = bundle.normal_blocks(K, R, t, points, pixels)`` are the blocks where we
       are. Damp them: multiply the diagonal of U, and that of each block of V, by ``1 + damping``.
    2. ``bundle.solve_normal_block(U, W, V, g_c, g_p)`` gives the steps of cameras and points, and
       ``bundle.move_block(R, t, points, cameras, moves)`` gives R, t and points after these steps.
    3. ``bundle.squared_error(K, R, t, points, pixels)`` says how large the error is. If it is
       smaller there, return where we are then, and a tenth of the damping. If not, return where we
       were, and ten times the damping.

    Parameters
    ----------
    K : ndarray, shape (3, 3)
        Intrinsics of all cameras, px.
    R, t : ndarray, shape (v, 3, 3) and (v, 3)
        Poses of v cameras, world to camera.
    points : ndarray, shape (n, 3)
        Points of the world.
    pixels : ndarray, shape (v, n, 2)
        Where each camera sees each point; NaN where it does not.
    damping : float
        λ, the damping of this step.

    Returns
    -------
    R, t, points : ndarray, shape (v, 3, 3), (v, 3) and (n, 3)
        Where cameras and points are now.
    damping : float
        That of the next step.

    Examples
    --------
    Two cameras see six points. At the start the first point is 1 too near.

    >>> K, R = np.diag([100.0, 100, 1]), np.array([np.eye(3), np.eye(3)])
    >>> t = np.array([[0.0, 0, 0], [-1, 0, 0]])
    >>> true = np.array([[0, 0, 4], [1, 0, 4], [0, 1, 5], [1, 1, 5], [0.5, 0.5, 3], [0, 0.5, 4]])
    >>> pixels = np.array([100 * (true + move)[:, :2] / true[:, 2:] for move in t])
    >>> points, damping = np.vstack([[[0, 0, 3]], true[1:]]), 0.001
    >>> for _ in range(3):
    ...     print(round(bundle.squared_error(K, R, t, points, pixels), 3), "px²")
    ...     R, t, points, damping = bundle_adjust(K, R, t, points, pixels, damping)
    69.444 px²
    2.593 px²
    0.008 px²
    """
    U, W, V, g_c, g_p = bundle.normal_blocks(K, R, t, points, pixels)
    U = U * (1 + damping * np.eye(len(U)))
    V = V * (1 + damping * np.eye(3))
    cameras, moves = bundle.solve_normal_block(U, W, V, g_c, g_p)
    there = bundle.move_block(R, t, points, cameras, moves)
    here = bundle.squared_error(K, R, t, points, pixels)
    if bundle.squared_error(K, *there, pixels) < here:
        return *there, damping / 10
    return R, t, points, damping * 10
