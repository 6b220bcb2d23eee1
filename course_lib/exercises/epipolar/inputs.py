"""Inputs for the exercises of chapter 08: two cameras, what both see, and lines between them."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from course_lib.judging import Known
from course_lib.transforms import rotation_from_vector

Inputs = dict[str, Any]
Floats = NDArray[np.float64]


# --- two cameras ------------------------------------------------------------------------------


class Pair(NamedTuple):
    """Two cameras, and what both see of some points: pixels, and normalised coordinates."""

    K1: Floats
    K2: Floats
    R: Floats
    t: Floats
    pixels1: Floats
    pixels2: Floats
    near1: Floats
    near2: Floats


def sign(rng: Generator) -> float:
    return float(rng.choice([-1, 1]))


def intrinsics(rng: Generator) -> Floats:
    fx = np.round(rng.uniform(600, 900), 1)
    fy = np.round(fx * rng.uniform(1.05, 1.15), 1)
    cx, cy = rng.uniform([290, 200], [350, 250]).round(1)
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])


def turn(rng: Generator) -> Floats:
    """Draw a rotation by 5° to 12°, about every axis by a good part of that."""
    return rotation_from_vector(rng.uniform(0.05, 0.12, 3) * [sign(rng), sign(rng), sign(rng)])


def baseline(rng: Generator) -> Floats:
    """Draw a shift in m with no small component; mostly aside, so that both see the same."""
    return np.asarray(rng.uniform([0.6, 0.2, 0.15], [1.2, 0.5, 0.4]) * rng.choice([-1, 1], 3))


def pair(rng: Generator, count: int) -> Pair:
    """Draw two cameras and points in front of both."""
    K1, K2, R, t = intrinsics(rng), intrinsics(rng), turn(rng), baseline(rng)
    near1, near2 = seen_by_both(rng, R, t, count)
    pixels1, pixels2 = (x @ K[:2, :2].T + K[:2, 2] for x, K in ((near1, K1), (near2, K2)))
    return Pair(K1, K2, R, t, pixels1, pixels2, near1, near2)


def seen_by_both(rng: Generator, R: Floats, t: Floats, count: int) -> tuple[Floats, Floats]:
    """Draw normalised coordinates of points that are 4 to 12 m before camera 1."""
    near1 = rng.uniform([-0.3, -0.22], [0.3, 0.22], (count, 2))
    X1 = np.column_stack([near1, np.ones(count)]) * rng.uniform(4, 12, (count, 1))
    X2 = X1 @ R.T + t
    return near1, X2[:, :2] / X2[:, 2:]


def crossed(t: Floats, M: Floats) -> Floats:
    """Return ``[t]ₓ M``, column by column."""
    return np.column_stack([np.cross(t, column) for column in M.T])


def fundamental(p: Pair) -> Floats:
    """Return F of a pair, from the relative pose."""
    return np.asarray(np.linalg.inv(p.K2).T @ crossed(p.t, p.R) @ np.linalg.inv(p.K1))


# --- known cameras ----------------------------------------------------------------------------


def small_vector(rng: Generator) -> Inputs:
    """Draw three different whole numbers, none of them zero."""
    return {"v": rng.permutation(np.arange(2, 10))[:3] * rng.choice([-1, 1], 3)}


def any_vector(rng: Generator) -> Inputs:
    return {"v": baseline(rng).round(3)}


def shifted_camera(rng: Generator) -> Known:
    t = np.asarray(small_vector(rng)["v"] / 10)
    return Known({"R": np.eye(3), "t": t}, crossed(t, np.eye(3)))


def turned_camera(rng: Generator) -> Known:
    R, t = turn(rng), baseline(rng)
    return Known({"R": R, "t": t}, crossed(t, R))


def first_at_the_origin(rng: Generator) -> Known:
    p = pair(rng, 1)
    P1 = p.K1 @ np.eye(3, 4)
    return Known({"P1": P1, "P2": p.K2 @ np.column_stack([p.R, p.t])}, fundamental(p))


def anywhere_in_the_world(rng: Generator) -> Known:
    p = pair(rng, 1)
    R1, t1 = turn(rng), rng.uniform(2, 5, 3) * rng.choice([-1, 1], 3)
    P1 = p.K1 @ np.column_stack([R1, t1])
    P2 = p.K2 @ np.column_stack([p.R @ R1, p.R @ t1 + p.t])
    return Known({"P1": P1, "P2": P2}, fundamental(p))


# --- lines, epipoles, distances ---------------------------------------------------------------


def small_matrix(rng: Generator) -> Floats:
    """Draw whole numbers, no two alike in size, for a matrix of rank 3."""
    while True:
        A = rng.permutation(np.arange(1.0, 10)).reshape(3, 3) * rng.choice([-1, 1], (3, 3))
        if abs(np.linalg.det(A)) > 20:
            return np.asarray(A)


def small_lines(rng: Generator) -> Inputs:
    """Draw pixels and a matrix that can be followed by hand; no number of a line is zero."""
    while True:
        points = rng.permutation(np.arange(1.0, 9))[:4].reshape(2, 2)
        F = small_matrix(rng)
        if np.all(np.column_stack([points, [1, 1]]) @ F.T):
            return {"points": points, "F": F}


def lines_of_pixels(rng: Generator) -> Inputs:
    p = pair(rng, 5)
    F = fundamental(p)
    return {"points": p.pixels1, "F": sign(rng) * F / np.linalg.norm(F)}


def small_epipole(rng: Generator) -> Known:
    """Draw F = A [e]ₓ of whole numbers: it takes e = (u, v, 1) to zero."""
    u, v = rng.permutation(np.arange(2.0, 10))[:2] * rng.choice([-1, 1], 2)
    S = crossed(np.array([u, v, 1]), np.eye(3))
    return Known({"F": small_matrix(rng) @ S}, np.array([u, v]))


def aside(rng: Generator) -> Known:
    return epipole_of(rng, baseline(rng))


def forward(rng: Generator) -> Known:
    """Draw a camera that went forward: the epipole is in the picture."""
    return epipole_of(rng, np.append(rng.uniform(0.05, 0.2, 2) * [sign(rng), sign(rng)], -1))


def epipole_of(rng: Generator, t: Floats) -> Known:
    p = pair(rng, 1)._replace(t=t)
    F = fundamental(p)
    e = p.K1 @ -p.R.T @ t  # picture 1 sees the centre of camera 2 there
    return Known({"F": F / np.linalg.norm(F)}, e[:2] / e[2])


def small_distances(rng: Generator) -> Known:
    """Draw lines with a² + b² a square number, and how far from them the points are."""
    normals = rng.permutation(np.array([[3.0, 4], [5, 12], [8, 6], [15, 8], [4, 3]]))[:4]
    normals = normals * rng.choice([-1, 1], (4, 2))
    lengths = np.hypot(*normals.T)
    points = rng.permutation(np.arange(1.0, 10))[:8].reshape(4, 2)
    away = rng.permutation(np.arange(1.0, 7))[:4] * rng.permutation([1, 1, -1, -1])
    c = away * lengths - (normals * points).sum(axis=1)
    return Known({"points": points, "lines": np.column_stack([normals, c])}, np.abs(away))


def pixels_and_lines(rng: Generator) -> Inputs:
    p = pair(rng, 6)
    lines = np.column_stack([p.pixels1, np.ones(6)]) @ fundamental(p).T
    lines = lines / np.abs(lines).max(axis=1, keepdims=True) * rng.uniform(50, 900, (6, 1))
    return {"points": p.pixels2 + rng.normal(0, 6, (6, 2)), "lines": lines}


def small_errors(rng: Generator) -> Inputs:
    """Draw pairs and a matrix that can be followed by hand; no number of a line is zero."""
    while True:
        points1, points2 = rng.permutation(np.arange(1.0, 9)).reshape(2, 2, 2)
        x1, x2 = (np.column_stack([points, [1, 1]]) for points in (points1, points2))
        F = small_matrix(rng)
        if np.all(x1 @ F.T) and np.all(x2 @ F) and np.all(((x2 @ F) * x1).sum(axis=1)):
            return {"points1": points1, "points2": points2, "F": F}


def errors_of_pixels(rng: Generator) -> Inputs:
    """Draw pairs a few pixels off, and a second camera that magnifies more than the first."""
    p = pair(rng, 6)
    zoom = np.array([[2.5, 0, -200], [0, 2.5, -150], [0, 0, 1]])
    moved = [x + rng.normal(0, 3, (6, 2)) for x in (p.pixels1, p.pixels2 * 2.5 - [200, 150])]
    F = fundamental(p._replace(K2=zoom @ p.K2))
    return {"points1": moved[0], "points2": moved[1], "F": F / np.linalg.norm(F)}
