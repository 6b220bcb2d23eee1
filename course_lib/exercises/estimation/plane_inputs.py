"""Inputs for the exercises of chapter 06 on homographies."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from course_lib.exercises.estimation.fit_inputs import away_from_zero
from course_lib.judging import Known

Inputs = dict[str, Any]
Floats = NDArray[np.float64]

#: The corners of a square, in order around it.
SQUARE = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])


# --- normalise_points -------------------------------------------------------------------------


def cloud(rng: Generator, centre: Any, widths: Any, count: int) -> Known:
    """Spread points differently along each axis, and put them somewhere."""
    points = np.asarray(centre) + rng.uniform(-1, 1, (count, len(centre))) * widths
    d = points.shape[1]
    middle = points.sum(axis=0) / count
    distances = np.sqrt(((points - middle) ** 2).sum(axis=1))
    scale = count * np.sqrt(d) / distances.sum()
    T = np.block([[scale * np.eye(d), -scale * middle[:, None]], [np.eye(d + 1)[d:]]])
    return Known({"points": points}, (scale * (points - middle), T))


def pixels_of_a_picture(rng: Generator) -> Known:
    return cloud(rng, rng.uniform(200, 900, 2), rng.uniform((150, 60), (300, 110)), 7)


def points_of_a_facade(rng: Generator) -> Known:
    return cloud(rng, rng.uniform(3, 9, 2), rng.uniform((0.2, 0.6), (0.4, 0.9)), 5)


def points_of_space(rng: Generator) -> Known:
    return cloud(rng, away_from_zero(rng, 5, 30, 3), rng.uniform((1, 2, 4), (2, 4, 8)), 8)


# --- homographies -----------------------------------------------------------------------------


def seen_at_a_slant(rng: Generator) -> Floats:
    """Draw a homography from a wall, 12 m × 8 m, to a picture of about 1000 × 700 px."""
    turn = rng.uniform(0.1, 0.4) * rng.choice([-1, 1])
    c, s = np.cos(turn), np.sin(turn)
    shift = np.array([[1.0, 0, -6], [0, 1, -4], [0, 0, 1]])
    tilt = np.array([[c, -s, 0], [s, c, 0], [*away_from_zero(rng, 0.02, 0.05, 2), 1]])
    stretch = np.diag([rng.uniform(60, 80), rng.uniform(80, 100), 1.0])
    picture = np.array([[1, 0, rng.uniform(480, 640)], [0, 1, rng.uniform(300, 420)], [0, 0, 1]])
    return np.asarray(picture @ stretch @ tilt @ shift)


def mapped(points: Floats, H: Floats) -> Floats:
    x = np.column_stack([points, np.ones(len(points))]) @ H.T
    return np.asarray(x[:, :2] / x[:, 2:])


def corners_of_a_window(rng: Generator) -> Floats:
    """Draw four corners, none of them exactly above or beside another."""
    return (SQUARE * rng.uniform(3, 5, 2) + rng.uniform(-0.6, 0.6, (4, 2)) + [4, 2]).round(2)


def points_on_the_wall(rng: Generator, count: int) -> Floats:
    """Draw points all over the wall, none at its edge."""
    cells = rng.permutation(12)[:count]
    inside = rng.uniform(0.15, 0.85, (count, 2))
    return np.asarray((np.stack([cells % 4, cells // 4], axis=1) + inside) * [3, 2.7]).round(2)


def four_corners(rng: Generator) -> Known:
    points, H = corners_of_a_window(rng), seen_at_a_slant(rng)
    return Known({"points": points, "targets": mapped(points, H)}, H / H[2, 2])


def many_corners(rng: Generator) -> Known:
    points, H = points_on_the_wall(rng, 9), seen_at_a_slant(rng)
    return Known({"points": points, "targets": mapped(points, H)}, H / H[2, 2])


def corners_with_errors(rng: Generator) -> Inputs:
    """Measure them by hand, some pixels off."""
    points, H = points_on_the_wall(rng, 9), seen_at_a_slant(rng)
    errors = rng.normal(size=(9, 2))
    targets = mapped(points, H) + 4 * errors / np.sqrt(np.mean(errors**2))
    return {"points": points, "targets": targets.round(1)}


# --- apply_homography: from homogeneous points that we choose -----------------------------------


def affine_matrix(rng: Generator) -> Known:
    points = rng.uniform(1, 9, (4, 2)).round(1)
    A, t = away_from_zero(rng, 0.5, 2, (2, 2)), away_from_zero(rng, 3, 9, 2)
    while abs(np.linalg.det(A)) < 0.3 or abs(A[0, 1] - A[1, 0]) < 0.2:
        A = away_from_zero(rng, 0.5, 2, (2, 2))
    return Known(
        {"points": points, "H": np.block([[A, t[:, None]], [np.zeros((1, 2)), np.ones((1, 1))]])},
        np.array([A @ point + t for point in points]),
    )


def projective(rng: Generator, points: Floats) -> Known:
    H = seen_at_a_slant(rng) * rng.uniform(0.3, 0.8)
    truth = [[H[i] @ [*p, 1] / (H[2] @ [*p, 1]) for i in range(2)] for p in points]
    return Known({"points": points, "H": H}, np.array(truth))


def wall_in_a_picture(rng: Generator) -> Known:
    return projective(rng, points_on_the_wall(rng, 5))


def one_point(rng: Generator) -> Known:
    many = projective(rng, points_on_the_wall(rng, 1))
    return Known({"points": many.inputs["points"][0], "H": many.inputs["H"]}, many.truth[0])


def some_to_infinity(rng: Generator) -> Known:
    """Take small whole numbers, so that w is exactly zero for two of the points."""
    line = rng.integers(2, 6)
    H = np.array([[*rng.integers(1, 5, 2), 3], [1, *rng.integers(4, 8, 2)], [1, 1, -2 * line]])
    x = np.array([0, line, 1, line + 1, 2])
    y = np.array([3, line, 2 * line - 1, 1, 2 * line + 1])
    points = np.column_stack([x, y]).astype(float)
    images = np.column_stack([points, np.ones(5)]) @ H.T
    w = np.where(images[:, 2:] == 0, np.nan, images[:, 2:])
    return Known({"points": points, "H": H.astype(float)}, images[:, :2] / w)
