"""Chapter 09 written out plainly: from two rays to a point.

The library (`course_lib.triangulation`) checks what comes in and takes many points at once. The
tests hold the two against each other.
"""

from __future__ import annotations

import numpy as np

from course_lib import triangulation


def closest_points_on_rays(origin1, direction1, origin2, direction2):
    """Return the points in which two rays come closest to each other.

    With origins o and directions d, the way from one point to the other is perpendicular to both
    rays: ``o1 + λ1 d1 + μ n = o2 + λ2 d2`` with ``n = d1 × d2``. These are three equations for the
    three unknowns λ1, λ2 and μ.

    Parameters
    ----------
    origin1, origin2 : ndarray, shape (3,)
        Where the rays begin.
    direction1, direction2 : ndarray, shape (3,)
        Where they go, with arrows of any length. They are not parallel.

    Returns
    -------
    point1, point2 : ndarray, shape (3,)
        The point of the first ray that is nearest to the second ray, and the point of the second
        ray that is nearest to the first.

    Examples
    --------
    >>> here, there = np.array([0, 0, 0]), np.array([1, 2, 0])
    >>> one, other = closest_points_on_rays(here, np.array([0, 0, 1]), there, np.array([-1, 0, 5]))
    >>> one.round(9) + 0.0, other.round(9) + 0.0
    (array([0., 0., 5.]), array([0., 2., 5.]))
    """
    normal = np.cross(direction1, direction2)
    A = np.column_stack([direction1, -direction2, normal])
    length1, length2, _ = np.linalg.solve(A, origin2 - origin1)
    return origin1 + length1 * direction1, origin2 + length2 * direction2


def triangulate_midpoint(pixel1, pixel2, P1, P2):
    """Return the point halfway between the rays of two pixels.

    A camera matrix is ``P = [M q]`` with M of shape (3, 3). Its centre is ``o = -M⁻¹ q``, and the
    ray of the pixel (u, v) goes from there in the direction ``M⁻¹ (u, v, 1)``.
    `closest_points_on_rays` of `course_lib.triangulation` tells where two rays come closest.

    Parameters
    ----------
    pixel1, pixel2 : ndarray, shape (2,)
        Where the first and the second picture show the point.
    P1, P2 : ndarray, shape (3, 4)
        Camera matrices.

    Returns
    -------
    ndarray, shape (3,)
        The middle of the two points in which the rays come closest.

    Examples
    --------
    >>> P1 = np.array([[800.0, 0, 320, 0], [0, 800, 240, 0], [0, 0, 1, 0]])
    >>> P2 = np.array([[800.0, 0, 320, -800], [0, 800, 240, 0], [0, 0, 1, 0]])
    >>> triangulate_midpoint(np.array([520, 240]), np.array([320, 240]), P1, P2).round(9) + 0.0
    array([1., 0., 4.])
    """
    inverse1, inverse2 = np.linalg.inv(P1[:, :3]), np.linalg.inv(P2[:, :3])
    centre1, centre2 = -inverse1 @ P1[:, 3], -inverse2 @ P2[:, 3]
    ray1, ray2 = inverse1 @ np.append(pixel1, 1), inverse2 @ np.append(pixel2, 1)
    one, other = triangulation.closest_points_on_rays(centre1, ray1, centre2, ray2)
    return (one + other) / 2


def triangulate_linear(pixels, cameras):
    """Return a point from two or more pictures of it, by the linear method (DLT).

    A camera matrix with the rows p1, p2, p3 gives two equations for ``h = (X, Y, Z, 1)``:
    ``(u p3 - p1) h = 0`` and ``(v p3 - p2) h = 0``.

    Parameters
    ----------
    pixels : ndarray, shape (V, 2)
        Where each of V ≥ 2 pictures shows the point, with some noise.
    cameras : ndarray, shape (V, 3, 4)
        Their camera matrices.

    Returns
    -------
    ndarray, shape (3,)
        The point ``(X, Y, Z)`` that fulfils all 2 V equations best: of all h of length 1 the one
        with the smallest errors, divided by its last number.

    Examples
    --------
    >>> P1 = np.array([[800.0, 0, 320, 0], [0, 800, 240, 0], [0, 0, 1, 0]])
    >>> P2 = np.array([[800.0, 0, 320, -800], [0, 800, 240, 0], [0, 0, 1, 0]])
    >>> triangulate_linear(np.array([[520, 240], [320, 240]]), np.array([P1, P2])).round(9) + 0.0
    array([1., 0., 4.])
    """
    rows = []
    for (u, v), (p1, p2, p3) in zip(pixels, cameras, strict=True):
        rows.append(u * p3 - p1)
        rows.append(v * p3 - p2)
    h = np.linalg.svd(np.array(rows))[2][-1]
    return h[:3] / h[3]


def refine_point(point, pixels, cameras):
    """Return a point after one Gauss–Newton step towards the smallest reprojection error.

    With ``(x, y, w) = P (X, Y, Z, 1)`` the camera's pixel is ``u = x/w``, ``v = y/w``. Its
    derivatives by X, Y, Z are the rows ``(m1 - u m3)/w`` and ``(m2 - v m3)/w``: m1, m2, m3 are the
    rows of P without their last number.

    Parameters
    ----------
    point : ndarray, shape (3,)
        A guess ``(X, Y, Z)``, in front of all cameras.
    pixels : ndarray, shape (V, 2)
        Where V ≥ 2 pictures show the point, with some noise.
    cameras : ndarray, shape (V, 3, 4)
        Their camera matrices.

    Returns
    -------
    ndarray, shape (3,)
        The point plus the step δ that solves ``J δ = -r`` by least squares. J has the two rows of
        each camera, taken at the guess; r are the residuals, projected minus measured pixel, in
        the same order.

    Examples
    --------
    >>> P1 = np.array([[100.0, 0, 0, 0], [0, 100, 0, 0], [0, 0, 1, 0]])
    >>> P2 = np.array([[100.0, 0, 0, -100], [0, 100, 0, 0], [0, 0, 1, 0]])
    >>> guess, pixels = np.array([0.0, 0, 5]), np.array([[0.0, 2], [-20, 2]])
    >>> refine_point(guess, pixels, np.array([P1, P2])).round(9) + 0.0
    array([0. , 0.1, 5. ])
    """
    J, r = [], []
    for pixel, P in zip(pixels, cameras, strict=True):
        x, y, w = P @ np.append(point, 1)
        u, v = x / w, y / w
        J.append((P[0, :3] - u * P[2, :3]) / w)
        J.append((P[1, :3] - v * P[2, :3]) / w)
        r.append(u - pixel[0])
        r.append(v - pixel[1])
    step = np.linalg.lstsq(np.array(J), -np.array(r), rcond=None)[0]
    return point + step


def depth_from_disparity(disparity, f, baseline, offset):
    """Return how far away points are that a rectified pair shows apart, ``Z = f b / (d + Δc)``.

    Parameters
    ----------
    disparity : ndarray, shape (N,)
        ``d = u_left - u_right`` in px.
    f : float
        Focal length of both pictures, px.
    baseline : float
        Distance b of the cameras, mm.
    offset : float
        ``Δc = cx_right - cx_left`` in px: by how much the principal points differ.

    Returns
    -------
    ndarray, shape (N,)
        Depths, mm. If ``d + Δc`` is zero or negative for any of the points, the function raises a
        ValueError instead: such a match is wrong, or its point infinitely far away.

    Examples
    --------
    >>> depth_from_disparity(np.array([100, 50]), 1000, 200, 0)
    array([2000., 4000.])
    >>> depth_from_disparity(np.array([70, 20]), 1000, 200, 30)
    array([2000., 4000.])
    """
    apart = disparity + offset
    if (apart <= 0).any():
        raise ValueError("disparity + offset must be positive")
    return f * baseline / apart


def depth_uncertainty(Z, f, baseline, sigma):
    """Return the standard deviation of depths from a rectified pair.

    It is the derivative of ``Z = f b / d`` by the disparity d, without its sign, times the standard
    deviation of d; and written with Z instead of d.

    Parameters
    ----------
    Z : float or ndarray
        Depth, or depths, mm.
    f : float
        Focal length, px.
    baseline : float
        Distance b of the cameras, mm.
    sigma : float
        Standard deviation of the disparity, px.

    Returns
    -------
    float or ndarray, as Z
        Standard deviation of each depth, mm.

    Examples
    --------
    >>> depth_uncertainty(np.array([2000, 4000]), 1000, 200, 0.5)
    array([10., 40.])
    """
    return Z**2 * sigma / (f * baseline)


def intersect_ray_plane(origin, directions, plane):
    """Return where the rays of a camera meet a plane, such as a laser's sheet of light.

    Parameters
    ----------
    origin : ndarray, shape (3,)
        Where all rays begin: the centre of the camera.
    directions : ndarray, shape (N, 3)
        Where they go, with arrows of any length. None is parallel to the plane.
    plane : ndarray, shape (4,)
        ``(a, b, c, d)``: the points of the plane have ``a X + b Y + c Z + d = 0``. The normal
        ``(a, b, c)`` can have any length.

    Returns
    -------
    ndarray, shape (N, 3)
        The points. A ray that goes away from the plane gives a row of three NaN (`np.nan`).

    Examples
    --------
    >>> directions = np.array([[1.0, 0, -1], [0, 0, 1]])
    >>> intersect_ray_plane(np.array([0, 0, 2]), directions, np.array([0, 0, 1, 0])) + 0.0
    array([[ 2.,  0.,  0.],
           [nan, nan, nan]])
    """
    normal = plane[:3]
    lengths = -(normal @ origin + plane[3]) / (directions @ normal)
    points = origin + lengths[:, None] * directions
    points[lengths < 0] = np.nan
    return points


def point_covariance(point, cameras, sigma):
    """Return how uncertain a triangulated point is: ``σ² (JᵀJ)⁻¹``.

    Parameters
    ----------
    point : ndarray, shape (3,)
        The point ``(X, Y, Z)``, in front of all cameras, in any unit of length.
    cameras : ndarray, shape (V, 3, 4)
        Matrices of V ≥ 2 cameras.
    sigma : float
        Standard deviation of each measured u and v, px.

    Returns
    -------
    ndarray, shape (3, 3)
        Covariance of X, Y and Z, in the square of that unit. J has two rows for each camera, as in
        `refine_point`: the derivatives ``(m1 - u m3)/w`` and ``(m2 - v m3)/w`` of the pixel that
        shows the point.

    Examples
    --------
    >>> P1 = np.array([[100.0, 0, 0, 0], [0, 100, 0, 0], [0, 0, 1, 0]])
    >>> P2 = np.array([[100.0, 0, 0, -100], [0, 100, 0, 0], [0, 0, 1, 0]])
    >>> covariance = point_covariance(np.array([0.5, 0, 5]), np.array([P1, P2]), 0.2)
    >>> np.sqrt(np.diag(covariance)).round(4)
    array([0.0071, 0.0071, 0.0707])
    """
    rows = []
    for P in cameras:
        x, y, w = P @ np.append(point, 1)
        rows.append((P[0, :3] - x / w * P[2, :3]) / w)
        rows.append((P[1, :3] - y / w * P[2, :3]) / w)
    J = np.array(rows)
    return sigma**2 * np.linalg.inv(J.T @ J)
