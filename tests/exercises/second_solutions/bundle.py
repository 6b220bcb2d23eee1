import numpy as np

from course_lib import bundle, resection


def resect_camera(points, pixels, K):
    """The rotation by Newton's polar iteration, ρ from the trace of the symmetric factor."""
    M = np.linalg.solve(K, resection.camera_dlt(points, pixels))
    R = M[:, :3]
    for _ in range(30):
        R = (R + np.linalg.inv(R).T) / 2
    return [R, M[:, 3] * 3 / np.trace(R.T @ M[:, :3])]


def reprojection_jacobian(point, K, R, t):
    """By differences: nudge each of the nine numbers, and look how far the pixel moves."""

    def pixel(nudge):
        (a, b, c), move, shift = nudge[:3], nudge[3:6], nudge[6:]
        turn = np.array([[0, -c, b], [c, 0, -a], [-b, a, 0]])
        q = R @ (point + shift - move) + t
        q = q + turn @ q + turn @ turn @ q / 2
        return (K @ q / q[2])[:2]

    h = 1e-4
    columns = []
    for nudge in h * np.eye(9):
        near, far = pixel(nudge) - pixel(-nudge), pixel(2 * nudge) - pixel(-2 * nudge)
        columns.append((8 * near - far) / (12 * h))
    J = np.array(columns).T
    return J[:, :6], J[:, 6:]


def solve_normal_block(U, W, V, g_c, g_p):
    """All at once: the whole matrix, written out."""
    c, n = len(U), len(V)
    whole = np.zeros((c + 3 * n, c + 3 * n))
    whole[:c, :c] = U
    for j in range(n):
        at = slice(c + 3 * j, c + 3 * j + 3)
        whole[:c, at], whole[at, :c], whole[at, at] = W[j], W[j].T, V[j]
    step = -np.linalg.inv(whole) @ np.concatenate([g_c, g_p.ravel()])
    return step[:c], step[c:].reshape(n, 3)


def bundle_adjust(K, R, t, points, pixels, damping):
    """Entry by entry, with the whole matrix, and all written into one list."""
    U, W, V, g_c, g_p = bundle.normal_blocks(K, R, t, points, pixels)
    for i in range(len(U)):
        U[i, i] += damping * U[i, i]
    for block in V:
        for i in range(3):
            block[i, i] *= 1 + damping
    steps = solve_normal_block(U, W, V, g_c, g_p)
    answers = [[R, t, points, 10 * damping], [*bundle.move_block(R, t, points, *steps)]]
    answers[1].append(0.1 * damping)
    errors = [bundle.squared_error(K, *answer[:3], pixels) for answer in answers]
    return answers[int(np.argmin(errors))]


def pictures_for_circle(step):
    """Picture after picture, until the steps are small enough."""
    count = 1
    while 2 * np.pi / count > step * (1 + 1e-12):
        count += 1
    return count


def similarity_transform(points, targets):
    """The rotation by Horn's quaternion, and the scale from the turned points."""
    x, y = points - np.mean(points, 0), targets - np.mean(targets, 0)
    (a, b, c), (d, e, f), (g, h, i) = x.T @ y
    symmetric = np.array(
        [
            [a + e + i, f - h, g - c, b - d],
            [f - h, a - e - i, b + d, g + c],
            [g - c, b + d, e - a - i, f + h],
            [b - d, g + c, f + h, i - a - e],
        ]
    )
    w, *v = np.linalg.eigh(symmetric)[1][:, 3]
    cross = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    R = np.eye(3) + 2 * w * cross + 2 * cross @ cross
    scale = np.vdot(y, x @ R.T) / np.vdot(x, x)
    return [scale, R, np.mean(targets - scale * points @ R.T, axis=0)]


def check_point_rmse(estimated, surveyed):
    off = np.subtract(estimated, surveyed)
    axes = [np.linalg.norm(one) / len(off) ** 0.5 for one in off.T]
    return [*axes, np.hypot(np.hypot(*axes[:2]), axes[2])]
