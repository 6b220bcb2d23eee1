import cmath
import math

import numpy as np

from course_lib import distortion
from course_lib.distortion import distortion_jacobian


def distort_radial(points, k):
    """Walk from point to point, by Horner's rule."""

    def moved(x, y):
        r2, factor = x * x + y * y, 0.0
        for coefficient in reversed(list(k)):
            factor = (factor + coefficient) * r2
        return x + x * factor, y + y * factor

    points = np.asarray(points)
    return np.array(moved(*points) if points.ndim == 1 else [moved(*p) for p in points])


def distort(points, coefficients):
    """With vectors: the tangential part is 2 (p' · x) x + r² p', p' being (p2, p1)."""
    k1, k2, p1, p2, k3 = coefficients
    side = np.array([p2, p1])
    rows = []
    for point in points:
        r2 = point @ point
        g = np.polynomial.polynomial.polyval(r2, [1, k1, k2, k3])
        rows.append(g * point + 2 * (side @ point) * point + r2 * side)
    return np.array(rows)


def distort_rational_prism(points, k, p, s):
    r2 = np.sum(points**2, axis=1)[:, None]
    powers = np.hstack([r2, r2**2, r2**3])
    g = (1 + powers @ k[:3]) / (1 + powers @ k[3:])
    side = p[::-1]
    tangential = 2 * (points @ side)[:, None] * points + r2 * side
    return g[:, None] * points + tangential + powers[:, :2] @ np.reshape(s, (2, 2)).T


def undistort_points(points, coefficients):
    """Newton's method."""
    ideal = points.copy()
    for _ in range(8):
        excess = distortion.distort(ideal, coefficients) - points
        ideal -= np.linalg.solve(distortion_jacobian(ideal, coefficients), excess[..., None])[
            ..., 0
        ]
    return ideal


def valid_radius(coefficients):
    """The formula for a quadratic equation in 1 / r²."""
    k1, k2 = (float(k) for k in coefficients)
    root = cmath.sqrt(9 * k1 * k1 - 20 * k2)
    inverse = [(-3 * k1 + sign * root) / 2 for sign in (1, -1)]
    real = [w.real for w in inverse if w.imag == 0 and w.real > 0]
    return 1 / math.sqrt(max(real)) if real else math.inf


def undistortion_map(K, coefficients, image_size):
    """Row by row, with matrices."""
    width, height = image_size
    maps = np.empty((2, height, width))
    for row in range(height):
        pixels = np.array([np.arange(width), np.full(width, row), np.ones(width)])
        rays = (np.linalg.inv(K) @ pixels)[:2].T
        bent = distortion.distort(rays, coefficients)
        maps[:, row] = (K @ np.vstack([bent.T, np.ones(width)]))[:2]
    return list(maps)


def straightness(points):
    """By the smaller root of the covariance's characteristic equation."""
    x, y = points[:, 0], points[:, 1]
    a, b, c = np.var(x), np.mean(x * y) - np.mean(x) * np.mean(y), np.var(y)
    largest = (a + c) / 2 + math.hypot((a - c) / 2, b)
    return math.sqrt((a * c - b * b) / largest)


def fisheye_project(points, K, k):
    """Point by point, with the direction as an angle."""
    pixels = []
    for X, Y, Z in points:
        angle = math.acos(Z / math.sqrt(X * X + Y * Y + Z * Z))
        distance = angle + sum(c * angle ** (3 + 2 * i) for i, c in enumerate(k))
        turn = math.atan2(Y, X)
        plane = [distance * math.cos(turn), distance * math.sin(turn), 1]
        pixels.append((K @ plane)[:2])
    return pixels
