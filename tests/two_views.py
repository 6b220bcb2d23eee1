"""Two cameras and points that both see, with known truth."""

from typing import NamedTuple

import numpy as np

from course_lib.camera import camera_matrix, project
from course_lib.transforms import rotation_from_vector

K = np.array([[800.0, 0, 320], [0, 810, 240], [0, 0, 1]])
SIZE = 640, 480


class Scene(NamedTuple):
    """What both cameras see; exact pixels, measured ones, and which pairs are right."""

    R: np.ndarray
    t: np.ndarray
    P1: np.ndarray
    P2: np.ndarray
    points: np.ndarray
    exact1: np.ndarray
    exact2: np.ndarray
    points1: np.ndarray
    points2: np.ndarray
    right: np.ndarray


def scene(seed, count=500, wrong=0.0, noise=0.5, plane=False, t=None):
    """Return a scene: a turn of some degrees, a baseline in any direction, depths of 4 to 12."""
    rng = np.random.default_rng(seed)
    R = rotation_from_vector(0.15 * rng.normal(size=3))
    drawn = rng.normal(size=3)
    t = drawn / np.linalg.norm(drawn) if t is None else np.asarray(t, float)
    P1, P2 = camera_matrix(K, np.eye(3), np.zeros(3)), camera_matrix(K, R, t)
    points, exact1, exact2 = np.empty((0, 3)), np.empty((0, 2)), np.empty((0, 2))
    while len(points) < count:
        uv = rng.uniform((0, 0), SIZE, (count, 2))
        rays = np.column_stack([uv, np.ones(count)]) @ np.linalg.inv(K).T
        Z = 8 / (rays @ [0.2, -0.3, 1]) if plane else rng.uniform(4, 12, count)
        X = rays * Z[:, None]
        seen = project(X, P2)
        inside = ((seen >= 0) & (seen < SIZE)).all(axis=1)  # NaN is not
        points = np.concatenate([points, X[inside]])[:count]
    exact1, exact2 = project(points, P1), project(points, P2)
    points1 = exact1 + noise * rng.normal(size=exact1.shape)
    points2 = exact2 + noise * rng.normal(size=exact2.shape)
    right = rng.permutation(count) >= round(wrong * count)
    points2[~right] = rng.uniform((0, 0), SIZE, ((~right).sum(), 2))
    return Scene(R, t, P1, P2, points, exact1, exact2, points1, points2, right)


def normalised(pixels):
    """Return pixels as normalised coordinates."""
    return (pixels - K[:2, 2]) / np.diag(K)[:2]


def same_up_to_sign(F, G, tolerance=1e-8):
    """Tell whether two matrices of length 1 are the same but for the sign."""
    return min(np.abs(F - G).max(), np.abs(F + G).max()) <= tolerance


def turn_between(R, other):
    """Return the angle between two rotations, degrees."""
    return np.degrees(2 * np.arcsin(min(1, np.linalg.norm(R - other) / np.sqrt(8))))


def angle_between(t, other):
    """Return the angle between two directions, degrees."""
    t, other = t / np.linalg.norm(t), other / np.linalg.norm(other)
    return np.degrees(2 * np.arcsin(min(1, np.linalg.norm(t - other) / 2)))
