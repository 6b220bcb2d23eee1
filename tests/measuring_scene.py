"""A camera that we chose, a pair of it, a target, and an object whose size is known."""

import numpy as np

from course_lib.calibration import board_points, calibrate, calibrate_stereo
from course_lib.camera import camera_matrix, project
from course_lib.distortion import distort_pixels
from course_lib.measuring import view_of_target
from course_lib.transforms import compose, rotation_x, rotation_y, rotation_z
from data_generators.board_observations import observe_board

K = np.array([[800, 0, 330], [0, 805, 235], [0, 0, 1.0]])
COEFFICIENTS = np.array([-0.2, 0.05, 0.001, -0.001, 0])
SIZE = (640, 480)
BOARD = board_points(9, 6, 30.0)
#: The target lies to the left of what is measured.
TARGET = board_points(5, 6, 20.0)
POSES = (
    (rotation_x(0.5) @ rotation_y(0.2), np.array([-110.0, -50, 450])),
    (rotation_y(-0.5) @ rotation_z(0.1), np.array([-60.0, -60, 480])),
)
FLAT = np.array([[130.0, 10, 0], [135, 95, 0]])
RAISED = np.array([[130.0, 10, -20], [110, 80, -60]])
#: From the left camera of a pair to the right one.
TURNED = rotation_y(-0.15) @ rotation_x(0.02)
SHIFT = np.array([-100.0, 2, 5])


def image(points, pose):
    """Return where the real lens images points of the target's frame."""
    return distort_pixels(project(points, camera_matrix(K, *pose)), K, COEFFICIENTS)


def calibrated(noise=0.2, rng=None, views=12):
    """Return a camera calibrated from the same poses, with new noise."""
    seen = observe_board(np.random.default_rng(1), BOARD, K, COEFFICIENTS, SIZE, views)
    rng = rng or np.random.default_rng(2)
    return calibrate(BOARD, [p + rng.normal(0, noise, p.shape) for p in seen.pixels], SIZE)


def targeted(calibration, noise=0.2, rng=None, poses=POSES):
    """Return the pictures of the target, by their poses."""
    rng = rng or np.random.default_rng(3)
    size = (len(TARGET), 2)
    return [
        view_of_target(TARGET, image(TARGET, pose) + rng.normal(0, noise, size), calibration)
        for pose in poses
    ]


def stereo(noise, rng, pairs=10):
    """Return a pair of equal cameras, calibrated from the same pairs of pictures with new noise."""
    seen = observe_board(np.random.default_rng(4), BOARD, K, COEFFICIENTS, SIZE, pairs)
    right = [image(BOARD, compose(TURNED, SHIFT, R, t)) for R, t in seen.poses]
    noisy = [[p + rng.normal(0, noise, p.shape) for p in side] for side in (seen.pixels, right)]
    return calibrate_stereo(BOARD, *noisy, SIZE)


def in_pair(points):
    """Return the exact pixels of points of the left camera's frame in both pictures."""
    return np.stack([image(points, (np.eye(3), np.zeros(3))), image(points, (TURNED, SHIFT))])


def larger(K, coefficients, name, step):
    """Return a camera's matrix and coefficients, one of its numbers larger by a step."""
    K, k = K.copy(), coefficients.copy()
    if name in ("fx", "fy", "cx", "cy"):
        K["xy".index(name[1]), "xy".index(name[1]) if name[0] == "f" else 2] += step
    else:
        k[("k1", "k2", "p1", "p2", "k3").index(name)] += step
    return K, k


def spread(count, shape, sigma, rng):
    """Return noise whose covariance is exact in this sample, not only on average."""
    white = np.linalg.qr(rng.normal(size=(count, int(np.prod(shape)))))[0] * np.sqrt(count)
    return sigma * white.reshape(count, *shape)
