"""Chapter 05 written out plainly: what a student writes, for mild lenses and sensible inputs.

The library's functions of the same names (`course_lib.distortion`) take more coefficients, check
what comes in, and answer where these would not. The tests hold the two against each other.
"""

from __future__ import annotations

import numpy as np

from course_lib import distortion


def distort(points, coefficients):
    """Return where a lens with distortion images the rays of an ideal one (Brown and Conrady).

    Parameters
    ----------
    points : ndarray, shape (N, 2)
        Ideal points in normalised coordinates ``(X/Z, Y/Z)``, in rows.
    coefficients : ndarray, shape (5,)
        ``k1 k2 p1 p2 k3``, in this order.

    Returns
    -------
    ndarray, shape (N, 2)
        Distorted points in normalised coordinates.

    Examples
    --------
    >>> distort(np.array([[0.5, 0], [0, 0.5]]), np.array([-0.2, 0, 0.01, 0, 0]))
    array([[0.475 , 0.0025],
           [0.    , 0.4825]])
    """
    k1, k2, p1, p2, k3 = coefficients
    x, y = points[:, 0], points[:, 1]
    r2 = x**2 + y**2
    g = 1 + k1 * r2 + k2 * r2**2 + k3 * r2**3
    x_d = x * g + 2 * p1 * x * y + p2 * (r2 + 2 * x**2)
    y_d = y * g + p1 * (r2 + 2 * y**2) + 2 * p2 * x * y
    return np.stack([x_d, y_d], axis=1)


def distort_rational_prism(points, k, p, s):
    """Return distorted points by the full model, its coefficients grouped by what they do.

    Parameters
    ----------
    points : ndarray, shape (N, 2)
        Ideal points in normalised coordinates, in rows.
    k : ndarray, shape (6,)
        Radial: ``k1 k2 k3`` above the fraction bar, ``k4 k5 k6`` below it.
    p : ndarray, shape (2,)
        Tangential: ``p1 p2``.
    s : ndarray, shape (4,)
        Thin prism: ``s1 s2`` for x, ``s3 s4`` for y.

    Returns
    -------
    ndarray, shape (N, 2)
        Distorted points in normalised coordinates.

    Examples
    --------
    >>> k, p, s = np.array([0, 0, 0, 1, 0, 0]), np.array([0, 0.01]), np.array([0.002, 0, 0, 0])
    >>> distort_rational_prism(np.array([[1, 0]]), k, p, s)
    array([[0.532, 0.   ]])
    """
    p1, p2 = p
    s1, s2, s3, s4 = s
    x, y = points[:, 0], points[:, 1]
    r2 = x**2 + y**2
    above = 1 + k[0] * r2 + k[1] * r2**2 + k[2] * r2**3
    below = 1 + k[3] * r2 + k[4] * r2**2 + k[5] * r2**3
    g = above / below
    x_d = x * g + 2 * p1 * x * y + p2 * (r2 + 2 * x**2) + s1 * r2 + s2 * r2**2
    y_d = y * g + p1 * (r2 + 2 * y**2) + 2 * p2 * x * y + s3 * r2 + s4 * r2**2
    return np.stack([x_d, y_d], axis=1)


def undistort_points(points, coefficients):
    """Return the ideal points of distorted ones, for a mild lens.

    Guess, distort the guess, move it by what it misses, and begin again. For the lenses that are
    tried here, 20 rounds are enough for the 1e-7 that is asked for.

    Parameters
    ----------
    points : ndarray, shape (N, 2)
        Distorted points in normalised coordinates, in rows.
    coefficients : ndarray, shape (5,)
        ``k1 k2 p1 p2 k3``. For the forward direction use ``distortion.distort``.

    Returns
    -------
    ndarray, shape (N, 2)
        Ideal points in normalised coordinates: those that `distort` sends to `points`.

    Examples
    --------
    >>> undistort_points(np.array([[0.475, 0]]), np.array([-0.2, 0, 0, 0, 0])).round(6)
    array([[0.5, 0. ]])
    """
    ideal = points
    for _ in range(20):
        ideal = ideal + (points - distortion.distort(ideal, coefficients))
    return ideal


def valid_radius(coefficients):
    """Return how far from the centre two radial coefficients can be used: where they fold over.

    Parameters
    ----------
    coefficients : ndarray, shape (2,)
        ``k1, k2``; each may be zero.

    Returns
    -------
    float
        The smallest positive ``r`` at which ``r (1 + k1 r² + k2 r⁴)`` stops growing: its derivative
        is zero. ``np.inf`` if it never does. Compared to six digits.

    Examples
    --------
    ``r - 0.1 r³`` grows until ``1 = 0.3 r²``:

    >>> round(valid_radius(np.array([-0.1, 0])), 6)
    1.825742
    >>> valid_radius(np.array([0.1, 0]))
    inf
    """
    k1, k2 = coefficients
    squares = np.roots([5 * k2, 3 * k1, 1])  # the derivative 1 + 3 k1 q + 5 k2 q², with q = r²
    folds = [q.real for q in squares if q.imag == 0 and q.real > 0]
    return float(np.sqrt(min(folds))) if folds else np.inf


def undistortion_map(K, coefficients, image_size):
    """Return, for each pixel of the undistorted picture, where to look in the distorted one.

    Parameters
    ----------
    K : ndarray, shape (3, 3)
        Intrinsics in px of both pictures, ``[[fx, 0, cx], [0, fy, cy], [0, 0, 1]]``.
    coefficients : ndarray, shape (5,)
        ``k1 k2 p1 p2 k3``. ``distortion.distort`` moves normalised points in rows.
    image_size : tuple of int
        Width and height in px.

    Returns
    -------
    map_u, map_v : ndarray, shape (height, width)
        Column and row in the distorted picture, in px, not rounded. The first pixel is (0, 0).

    Examples
    --------
    >>> K = np.array([[100, 0, 50], [0, 100, 50], [0, 0, 1]])
    >>> map_u, map_v = undistortion_map(K, np.array([-0.2, 0, 0, 0, 0]), (101, 81))
    >>> map_u.shape
    (81, 101)
    >>> print(map_u[50, 100].round(6), map_v[50, 100])
    97.5 50.0
    """
    width, height = image_size
    u, v = np.meshgrid(np.arange(width), np.arange(height))
    x, y = (u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1]
    points = np.stack([x.ravel(), y.ravel()], axis=1)
    x_d, y_d = distortion.distort(points, coefficients).T
    map_u, map_v = K[0, 0] * x_d + K[0, 2], K[1, 1] * y_d + K[1, 2]
    return map_u.reshape(height, width), map_v.reshape(height, width)


def fisheye_project(points, K, k):
    """Return the image of points through a fisheye lens.

    Parameters
    ----------
    points : ndarray, shape (N, 3)
        Points in the camera frame, in rows; also beside the camera or behind it, but none on its
        axis.
    K : ndarray, shape (3, 3)
        Intrinsics in px, ``[[fx, 0, cx], [0, fy, cy], [0, 0, 1]]``.
    k : ndarray, shape (4,)
        ``k1 k2 k3 k4``: a ray at the angle θ (rad) from the axis meets the image at the distance
        ``θ (1 + k1 θ² + k2 θ⁴ + k3 θ⁶ + k4 θ⁸)`` from the centre, in focal lengths. All zero is
        the equidistant lens.

    Returns
    -------
    ndarray, shape (N, 2)
        Pixels ``(u, v)``.

    Examples
    --------
    At a right angle from the axis, where a pinhole has no image:

    >>> K = np.array([[200, 0, 320], [0, 200, 240], [0, 0, 1]])
    >>> fisheye_project(np.array([[1, 0, 0]]), K, np.zeros(4)).round(3)
    array([[634.159, 240.   ]])
    """
    X, Y, Z = points.T
    aside = np.hypot(X, Y)
    angle = np.arctan2(aside, Z)
    a2 = angle**2
    distance = angle * (1 + k[0] * a2 + k[1] * a2**2 + k[2] * a2**3 + k[3] * a2**4)
    u = K[0, 0] * distance * X / aside + K[0, 2]
    v = K[1, 1] * distance * Y / aside + K[1, 2]
    return np.stack([u, v], axis=1)
