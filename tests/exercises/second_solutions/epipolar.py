import math

import numpy as np


def skew(v):
    """Column by column: what v × makes of each axis."""
    return np.array([np.cross(v, axis) for axis in np.eye(3)]).T


def essential_from_pose(R, t):
    """Entry by entry, from t × (R x1); with another sign and scale."""
    x, y, z = t
    first, second, third = R
    return [
        -7 * (y * third - z * second),
        -7 * (z * first - x * third),
        -7 * (x * second - y * first),
    ]


def fundamental_from_cameras(P1, P2):
    """Hartley & Zisserman, equation 17.3: each entry is a determinant of four rows."""
    F = np.empty((3, 3))
    for i in range(3):
        for j in range(3):
            rows = [P1[k] for k in range(3) if k != j] + [P2[k] for k in range(3) if k != i]
            F[i, j] = (-1) ** (i + j) * np.linalg.det(np.array(rows))
    return F


def epipolar_lines(points, F):
    """Point by point, with the other sign."""
    lines = []
    for u, v in points:
        a, b, c = F @ [u, v, 1]
        length = -math.hypot(a, b)
        lines.append((a / length, b / length, c / length))
    return lines


def epipole(F):
    """The cross product of two rows of F, the pair that is least parallel."""
    crossed = [np.cross(F[i], F[j]) for i, j in ((0, 1), (0, 2), (1, 2))]
    u, v, w = max(crossed, key=np.linalg.norm)
    return [u / w, v / w]


def line_distance(points, lines):
    """From each point to its foot on the line."""
    answer = []
    for (u, v), (a, b, c) in zip(points, lines, strict=True):
        k = -(a * u + b * v + c) / (a * a + b * b)
        answer.append(math.dist((u, v), (u + k * a, v + k * b)))
    return answer
