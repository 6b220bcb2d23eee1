import math

import numpy as np


def solve_one_unknown(a, b):
    """Where the parabola of the squares is lowest, from three of its values."""
    left, middle, right = (np.sum((np.multiply(a, x) - b) ** 2) for x in (-1, 0, 1))
    return (left - right) / (2 * (left - 2 * middle + right))


def fit_line(x, y):
    """From sums over points, as a pocket calculator does it."""
    n, sx, sy = len(x), sum(x), sum(y)
    sxx, sxy = sum(v * v for v in x), sum(v * w for v, w in zip(x, y, strict=True))
    slope = (n * sxy - sx * sy) / (n * sxx - sx * sx)
    return np.array([slope, (sy - slope * sx) / n])


def fit_affine(points, targets):
    """All six unknowns in one system, two rows for each point."""
    rows, right = [], []
    for (x, y), (u, v) in zip(points, targets, strict=True):
        rows += [[x, y, 1, 0, 0, 0], [0, 0, 0, x, y, 1]]
        right += [u, v]
    A = np.array(rows)
    return (np.linalg.inv(A.T @ A) @ A.T @ np.array(right)).reshape(2, 3)


def apply_homography(points, H):
    def image(point):
        u, v, w = H @ [*point, 1]
        return [u / w, v / w] if w else [math.nan, math.nan]

    if np.ndim(points) == 1:
        return image(points)
    return np.array([image(point) for point in points])


def normalise_points(points):
    """As two matrices, a shift and then a scaling, which move the points."""
    d = len(points[0])
    shift, scale = np.eye(d + 1), np.eye(d + 1)
    shift[:d, d] = -np.sum(points, axis=0) / len(points)
    distances = [math.dist(point, -shift[:d, d]) for point in points]
    scale[:d, :d] *= math.sqrt(d) * len(points) / sum(distances)
    T = scale @ shift
    return np.array([(T @ [*point, 1])[:d] for point in points]), T


def homography_dlt(points, targets):
    """From the smallest eigenvector of AᵀA, with the rows as a cross product."""
    (p, T_p), (q, T_q) = normalise_points(points), normalise_points(targets)
    N = np.zeros((9, 9))
    for (x, y), (u, v) in zip(p, q, strict=True):
        for row in (np.kron([0, -1, v], [x, y, 1]), np.kron([1, 0, -u], [x, y, 1])):
            N += np.outer(row, row)
    H = np.linalg.eigh(N)[1][:, 0].reshape(3, 3)
    return -5 * np.linalg.solve(T_q, H @ T_p)


def camera_dlt(points, pixels):
    """From the smallest eigenvector of AᵀA, with the rows as a cross product."""
    (p, T_p), (q, T_q) = normalise_points(points), normalise_points(pixels)
    N = np.zeros((12, 12))
    for (x, y, z), (u, v) in zip(p, q, strict=True):
        for row in (np.kron([0, -1, v], [x, y, z, 1]), np.kron([1, 0, -u], [x, y, z, 1])):
            N += np.outer(row, row)
    P = np.linalg.eigh(N)[1][:, 0].reshape(3, 4)
    return -5 * np.linalg.solve(T_q, P @ T_p)


def decompose_projection(P):
    """K from the triangle of Cholesky: M Mᵀ = K Kᵀ."""
    M = P[:, :3] / np.linalg.norm(P[2, :3])
    flip = np.eye(3)[::-1]
    K = flip @ np.linalg.cholesky(flip @ M @ M.T @ flip) @ flip
    R = np.linalg.solve(K, M)
    null = np.linalg.svd(P)[2][-1]
    return [K, R * round(np.linalg.det(R)), null[:3] / null[3]]


def correction_table(pixels, residuals, image_size, shape):
    """Sort the residuals into bins, one by one."""
    (width, height), (rows, columns) = image_size, shape
    sums, counts = np.zeros((rows, columns, 2)), np.zeros((rows, columns, 1))
    for (u, v), residual in zip(pixels, residuals, strict=True):
        row, column = int((v + 0.5) // (height / rows)), int((u + 0.5) // (width / columns))
        cell = min(row, rows - 1), min(column, columns - 1)
        sums[cell] += residual
        counts[cell] += 1
    return sums / np.maximum(counts, 1)
