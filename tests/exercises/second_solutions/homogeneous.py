import math

import numpy as np


def in_rows(function, *arrays):
    """Apply a function to each row of some arrays, or to single rows."""
    if np.ndim(arrays[0]) == 1:
        return np.array(function(*arrays))
    return np.array([function(*rows) for rows in zip(*arrays, strict=True)])


def to_homogeneous(points):
    return in_rows(lambda point: [*point, 1], points)


def from_homogeneous(points):
    def ordinary(point):
        *xs, w = point
        return [x / w if w else math.nan for x in xs]

    return in_rows(ordinary, points)


def line_through(p, q):
    """Find the vector that both points annul, as the null space of a matrix."""
    return in_rows(lambda a, b: np.linalg.svd(np.array([a, b]))[2][2], p, q)


def meet(l, m):  # noqa: E741
    def determinants(first, second):
        (a, b, c), (d, e, f) = first, second
        return [b * f - c * e, -(a * f - c * d), a * e - b * d]

    return in_rows(determinants, l, m)


def rotation_about_axis(axis, angle):
    """Go through a quaternion, written out."""
    x, y, z = math.sin(angle / 2) * np.array(axis) / math.hypot(*axis)
    w = math.cos(angle / 2)
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]


def matrix(R, t):
    return np.block([[np.array(R), np.reshape(t, (3, 1))], [np.zeros((1, 3)), np.ones((1, 1))]])


def invert_pose(R, t):
    back = np.linalg.inv(matrix(R, t))
    return back[:3, :3], back[:3, 3]


def pose_from_placement(R_camera, centre):
    return invert_pose(R_camera, centre)


def camera_centre(R, t):
    """Find the point that the camera maps to zero."""
    return np.linalg.solve(R, -np.array(t))


def cv_from_graphics_camera(world_from_camera):
    half_turn = rotation_about_axis((1, 0, 0), math.pi)
    cam_from_world = matrix(half_turn, (0, 0, 0)) @ np.linalg.inv(world_from_camera)
    return cam_from_world[:3, :3], cam_from_world[:3, 3]


def gimbal_pose(pan, tilt, mount, offset):
    """Undo one motion after the other, from the world to the camera."""
    R, t = np.eye(3), -np.array(mount)
    for axis, angle in [((0, 0, 1), -pan), ((1, 0, 0), -tilt), ((1, 0, 0), math.pi / 2)]:
        turn = np.array(rotation_about_axis(axis, angle))
        R, t = turn @ R, turn @ t
    return R, t - offset


def camera_matrix(K, R, t):
    centre = camera_centre(R, t)
    return K @ R @ np.column_stack([np.eye(3), -centre])


def project(points, P):
    P = P / np.linalg.norm(P[2, :3]) * np.sign(np.linalg.det(P[:, :3]))

    def pixel(point):
        u, v, depth = P @ [*point, 1]
        return [u / depth, v / depth] if depth > 0 else [math.nan, math.nan]

    return in_rows(pixel, points)


def pixel_ray(pixels, K, R, t):
    def direction(pixel):
        y = (pixel[1] - K[1, 2]) / K[1, 1]
        x = (pixel[0] - K[0, 2] - K[0, 1] * y) / K[0, 0]
        length = math.sqrt(x * x + y * y + 1)
        return sum(a * axis for a, axis in zip((x, y, 1), R, strict=True)) / length

    return camera_centre(R, t), in_rows(direction, pixels)
