import math

import numpy as np


def board_points(columns, rows, square):
    numbers = np.arange(columns * rows)
    return np.stack([numbers % columns, numbers // columns, 0 * numbers]).T * square


def homography_constraints(H):
    """From the symmetric products: h1ᵀ B h2 as a sum over all nine entries."""
    place = np.array([[0, 1, 3], [1, 2, 4], [3, 4, 5]])

    def row(i, j):
        numbers = [0.0] * 6
        for a in range(3):
            for b in range(3):
                numbers[place[a, b]] += H[a, i] * H[b, j]
        return np.array(numbers)

    return [row(0, 1), row(0, 0) - row(1, 1)]


def intrinsics_from_homographies(Hs):
    """The closed form of Zhang's appendix, from the eigenvector of VᵀV, in units of 400 px."""
    T = np.diag([1 / 400, 1 / 400, 1])
    rows = [row for H in Hs for row in homography_constraints(T @ H / np.linalg.norm(T @ H))]
    b11, b12, b22, b13, b23, b33 = np.linalg.svd(np.array(rows))[2][-1]
    v0 = (b12 * b13 - b11 * b23) / (b11 * b22 - b12**2)
    scale = b33 - (b13**2 + v0 * (b12 * b13 - b11 * b23)) / b11
    alpha = math.sqrt(scale / b11)
    beta = math.sqrt(scale * b11 / (b11 * b22 - b12**2))
    gamma = -b12 * alpha**2 * beta / scale
    u0 = gamma * v0 / beta - b13 * alpha**2 / scale
    return np.linalg.inv(T) @ [[alpha, gamma, u0], [0, beta, v0], [0, 0, 1]]


def pose_from_homography(K, H):
    """The nearest rotation by its polar factor, Newton's way."""
    H = H * np.sign(H[2, 2])
    r1, r2, t = np.linalg.solve(K, H).T
    length = (math.dist(r1, (0, 0, 0)) + math.dist(r2, (0, 0, 0))) / 2
    r1, r2 = r1 / length, r2 / length
    R = np.array([r1, r2, np.cross(r1, r2)]).T
    for _ in range(30):
        R = (R + np.linalg.inv(R).T) / 2
    return [R, t / length]


def initial_distortion(ideal, observed, K):
    """By the normal equations, summed up point by point."""
    N, g = np.zeros((2, 2)), np.zeros(2)
    for (u, v), (u_seen, v_seen) in zip(ideal, observed, strict=True):
        du, dv = u - K[0, 2], v - K[1, 2]
        r2 = (du / K[0, 0]) ** 2 + (dv / K[1, 1]) ** 2
        for moved, offset in ((u_seen - u, du), (v_seen - v, dv)):
            row = offset * np.array([r2, r2**2])
            N += np.outer(row, row)
            g += row * moved
    return np.linalg.solve(N, g)


def reprojection_residuals(points, pixels, K, R, t, k):
    answer = []
    for point, pixel in zip(points, pixels, strict=True):
        X, Y, Z = R @ point + t
        r = math.hypot(X / Z, Y / Z)
        g = 1 + k[0] * r**2 + k[1] * r**4
        u, v, w = K @ [g * X, g * Y, Z]
        answer.append((u / w - pixel[0], v / w - pixel[1]))
    return answer


def rms_error(residuals):
    return np.linalg.norm(residuals) / math.sqrt(len(residuals))


def refine_calibration(parameters, residuals, J, damping):
    """As a least-squares problem with more rows: one for each parameter, that wants no step."""
    extra = np.diag(np.sqrt(damping) * np.linalg.norm(J, axis=0))
    rows = np.vstack([J, extra])
    step = np.linalg.lstsq(rows, -np.concatenate([residuals, 0 * parameters]), rcond=None)[0]
    return step + parameters


def reject_views(residuals, limit):
    errors = [np.sqrt(np.mean(np.hypot(*view.T) ** 2)) for view in residuals]
    usual = sorted(errors)[len(errors) // 2]
    return [bool(error <= limit * usual) for error in errors]


def parameter_covariance(J, residuals):
    R = np.linalg.qr(J)[1]
    spread = np.linalg.norm(residuals) ** 2 / (len(residuals) - len(R))
    inverse = np.linalg.solve(R, np.eye(len(R)))
    return spread * inverse @ inverse.T
