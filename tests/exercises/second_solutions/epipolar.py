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


def eight_point(points1, points2):
    """By the eigenvectors of AᵀA, with an own normalisation."""

    def about_the_mean(points):
        centre = sum(points) / len(points)
        k = math.sqrt(2) / np.mean([math.dist(p, centre) for p in points])
        return np.array([[k, 0, -k * centre[0]], [0, k, -k * centre[1]], [0, 0, 1]])

    T1, T2 = about_the_mean(points1), about_the_mean(points2)
    N = np.zeros((9, 9))
    for p, q in zip(points1, points2, strict=True):
        row = np.kron(T2 @ [*q, 1], T1 @ [*p, 1])
        N += np.outer(row, row)
    F = np.linalg.eigh(N)[1][:, 0].reshape(3, 3)
    null = np.linalg.eigh(F.T @ F)[1][:, 0]
    return -3 * T2.T @ (F - np.outer(F @ null, null)) @ T1


def sampson_error(points1, points2, F):
    errors = []
    for p, q in zip(points1, points2, strict=True):
        x1, x2 = np.array([*p, 1]), np.array([*q, 1])
        gradient = [*(F @ x1)[:2], *(F.T @ x2)[:2]]
        errors.append(abs(x2 @ F @ x1) / np.linalg.norm(gradient))
    return errors


def ransac_iterations(confidence, size, wrong_share):
    """By counting until the chance of bad samples alone is small enough."""
    bad, samples, chance = 1 - (1 - wrong_share) ** size, 0, 1.0
    while chance > 1 - confidence:
        chance *= bad
        samples += 1
    return float(samples)


def ransac_fundamental(points1, points2, samples, threshold):
    """The last of the best samples, and fits after the refinement."""
    best, most = None, 0
    for row in range(len(samples)):
        F = eight_point(points1[samples[row]], points2[samples[row]])
        good = [error <= threshold for error in sampson_error(points1, points2, F)]
        if sum(good) >= most:
            best, most = good, sum(good)
    F = eight_point(points1[best], points2[best])
    return [F, [error <= threshold for error in sampson_error(points1, points2, F)]]


def pose_from_essential(E, points1, points2):
    """Horn's way: t from a null vector, R from cofactors, depths by least squares."""
    E = E * math.sqrt(2) / np.linalg.norm(E)
    t = np.linalg.eigh(E @ E.T)[1][:, 0]
    cofactors = np.array([np.cross(E[1], E[2]), np.cross(E[2], E[0]), np.cross(E[0], E[1])])
    best, most = None, -1
    for s in (1, -1):
        R = cofactors - np.cross(s * t, E, axis=0)
        for sign in (1, -1):
            count = 0
            for p, q in zip(points1, points2, strict=True):
                A = np.column_stack([R @ [*p, 1], [-q[0], -q[1], -1]])
                count += sum(np.linalg.lstsq(A, -sign * t, rcond=None)[0] > 0)
            if count > most:
                best, most = (R, sign * t), count
    return best
