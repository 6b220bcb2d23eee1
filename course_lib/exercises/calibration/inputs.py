"""Inputs for the exercises of chapter 07: cameras, boards in different poses, what they make."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from course_lib.calibration import board_points
from course_lib.judging import Known
from course_lib.transforms import rotation_from_vector

Inputs = dict[str, Any]
Floats = NDArray[np.float64]


# --- cameras and boards -----------------------------------------------------------------------


def sign(rng: Generator) -> float:
    return float(rng.choice([-1, 1]))


def intrinsics(rng: Generator, skew: float = 0) -> Floats:
    fx = np.round(rng.uniform(600, 900), 1)
    fy = np.round(fx * rng.uniform(1.05, 1.15), 1)
    cx, cy = rng.uniform(290, 350), rng.uniform(200, 225)
    return np.array([[fx, skew, cx], [0, fy, cy], [0, 0, 1]])


def turned_board(rng: Generator, middle: Floats, tilt_direction: float) -> tuple[Floats, Floats]:
    """Draw a board that is tilted by 20° to 40° towards a direction, and turned a little."""
    tilt = rng.uniform(0.35, 0.7)
    axis = np.array([-np.sin(tilt_direction), np.cos(tilt_direction), 0])
    spin = rotation_from_vector([0, 0, rng.uniform(0.1, 0.4) * sign(rng)])
    R = rotation_from_vector(tilt * axis) @ spin
    aside = rng.uniform(20, 60, 2) * [sign(rng), sign(rng)]
    return R, np.array([*aside, rng.uniform(450, 700)]) - R @ middle


def homography(K: Floats, R: Floats, t: Floats) -> Floats:
    return np.asarray(K @ np.column_stack([R[:, 0], R[:, 1], t]))


def one_view(rng: Generator) -> tuple[Floats, Floats, Floats, Floats]:
    """Draw a camera, the corners of a board, and its pose."""
    board = board_points(5, 4, 30.0)
    R, t = turned_board(rng, board.mean(axis=0), rng.uniform(0, 2 * np.pi))
    return intrinsics(rng), board, R, t


# --- board_points -----------------------------------------------------------------------------


def landscape_board(rng: Generator) -> Inputs:
    rows = int(rng.integers(4, 7))
    square = float(np.round(rng.integers(12, 36) + rng.uniform(0.1, 0.9), 1))  # no whole number
    return {"columns": rows + int(rng.integers(1, 4)), "rows": rows, "square": square}


def portrait_board(rng: Generator) -> Inputs:
    wide = landscape_board(rng)
    return {**wide, "columns": wide["rows"], "rows": wide["columns"]}


# --- closed form ------------------------------------------------------------------------------


def small_homography(rng: Generator) -> Inputs:
    """Draw a matrix of small whole numbers, which can be followed by hand."""
    return {"H": rng.permutation(np.arange(1.0, 10)).reshape(3, 3) * rng.choice([-1, 1], (3, 3))}


def view_of_a_board(rng: Generator) -> Inputs:
    K, _, R, t = one_view(rng)
    H = homography(K, R, t)
    return {"H": H / H[2, 2]}


def several_views(rng: Generator, count: int, skew: float) -> Known:
    K, middle = intrinsics(rng, skew), np.array([60, 45, 0])
    turns = 2 * np.pi * (np.arange(count) + rng.uniform(0, 1)) / count
    Hs = np.array([homography(K, *turned_board(rng, middle, turn)) for turn in turns])
    return Known({"Hs": Hs / Hs[:, 2:, 2:]}, K)


def three_views(rng: Generator) -> Known:
    return several_views(rng, 3, 0)


def many_views_with_skew(rng: Generator) -> Known:
    return several_views(rng, 6, float(np.round(rng.uniform(4, 12), 1)))


def exact_homography(rng: Generator) -> Known:
    K, _, R, t = one_view(rng)
    scale = rng.uniform(0.2, 0.7)
    return Known({"K": K, "H": scale * homography(K, R, t)}, (R, t))


def negative_homography(rng: Generator) -> Known:
    exact = exact_homography(rng)
    return Known({**exact.inputs, "H": -exact.inputs["H"]}, exact.truth)


def noisy_homography(rng: Generator) -> Inputs:
    """Draw one whose r1 and r2 are a few degrees from perpendicular and differ in length."""
    exact = exact_homography(rng).inputs
    K = exact["K"]
    skewed = np.array([[1.05, 0.04 * sign(rng), 0], [0.03, 0.93, 0], [0, 0, 1]])
    M = np.linalg.inv(K) @ exact["H"] @ skewed
    return {"K": K, "H": sign(rng) * K @ M}


# --- distortion -------------------------------------------------------------------------------


def barrel_points(rng: Generator, noise: float) -> tuple[Inputs, Floats]:
    """Draw points all over the picture, moved by exactly the terms that the exercise solves for."""
    K = intrinsics(rng)
    ideal = rng.uniform((20, 20), (620, 460), (12, 2)).round(2)
    k = np.array([rng.uniform(0.15, 0.35) * sign(rng), rng.uniform(0.05, 0.2) * sign(rng)])
    offset = ideal - K[:2, 2]
    r2 = ((offset / [K[0, 0], K[1, 1]]) ** 2).sum(axis=1, keepdims=True)
    moved = ideal + offset * (k[0] * r2 + k[1] * r2**2)
    moved += rng.normal(0, noise, moved.shape)
    return {"ideal": ideal, "observed": moved, "K": K}, k


def exactly_bent(rng: Generator) -> Known:
    return Known(*barrel_points(rng, 0))


def bent_with_noise(rng: Generator) -> Inputs:
    return barrel_points(rng, 0.5)[0]


# --- residuals --------------------------------------------------------------------------------


def view_with(rng: Generator, k: Floats) -> Known:
    """Choose the residuals, and put the observed pixels that far from where the points are."""
    K, board, R, t = one_view(rng)
    x = np.array([(R @ point + t) / (R @ point + t)[2] for point in board])[:, :2]
    r = np.hypot(x[:, 0], x[:, 1])[:, None]
    pixels = (x + x * (k[0] * r**2 + k[1] * r**4)) @ K[:2, :2].T + K[:2, 2]
    chosen = rng.normal(0, 1, pixels.shape).round(2)
    inputs = {"points": board, "pixels": pixels - chosen, "K": K, "R": R, "t": t, "k": k}
    return Known(inputs, chosen)


def without_distortion(rng: Generator) -> Known:
    return view_with(rng, np.zeros(2))


def with_distortion(rng: Generator) -> Known:
    return view_with(rng, np.array([rng.uniform(-0.4, -0.2), rng.uniform(0.05, 0.3)]))


def few_residuals(rng: Generator) -> Inputs:
    return {"residuals": rng.normal(0, 0.3, (5, 2)).round(2)}


def many_residuals(rng: Generator) -> Inputs:
    return {"residuals": rng.normal(0, 0.3, (54, 2))}


# --- refinement and its judgement -------------------------------------------------------------


def linear_problem(rng: Generator, rows: int, unknowns: int) -> tuple[Floats, Floats, Floats]:
    """Draw a start, residuals and derivatives of very different sizes, as f and k1 have them."""
    sizes = np.array([0.5, 1, 2, 40, 300])[:unknowns]
    J = (rng.normal(0, 1, (rows, unknowns)) * sizes).round(3)
    start = np.array([800, 320, 240, -0.2, 0.1])[:unknowns]
    start = start * (1 + 0.1 * rng.uniform(-1, 1, unknowns))
    # Steps that are a good part of the parameters, so that they can be told from none.
    solution = J @ (rng.uniform(15, 30, unknowns) * rng.choice([-1, 1], unknowns) / sizes)
    return start.round(4), solution + rng.normal(0, 0.3, rows).round(3), J


def undamped_step(rng: Generator) -> Inputs:
    start, residuals, J = linear_problem(rng, 12, 3)
    return {"parameters": start, "residuals": residuals, "J": J, "damping": 0.0}


def damped_step(rng: Generator) -> Inputs:
    start, residuals, J = linear_problem(rng, 20, 5)
    damping = float(rng.uniform(0.2, 2))
    return {"parameters": start, "residuals": residuals, "J": J, "damping": damping}


def small_fit(rng: Generator) -> Inputs:
    _, residuals, J = linear_problem(rng, 8, 2)
    return {"J": J, "residuals": residuals}


def larger_fit(rng: Generator) -> Inputs:
    _, residuals, J = linear_problem(rng, 30, 5)
    return {"J": J, "residuals": residuals}


# --- reject_views -----------------------------------------------------------------------------


def views_of_size(rng: Generator, sizes: Floats) -> Floats:
    """Draw residuals of views with given RMS errors."""
    residuals = rng.normal(0, 1, (len(sizes), 20, 2))
    rms = np.sqrt((residuals**2).sum(axis=2).mean(axis=1))
    return np.asarray(residuals * (sizes / rms)[:, None, None])


def with_one_slip(view: Floats, size: float) -> Floats:
    """Move one corner of a view so far that the view's RMS error becomes a given one."""
    squares = (view**2).sum(axis=1)
    slip = np.sqrt(size**2 * len(view) - squares[1:].sum())
    return np.vstack([view[:1] * slip / np.sqrt(squares[0]), view[1:]])


def some_bad_views(rng: Generator, sizes: Floats, slipped: Floats) -> Floats:
    """Draw views of given RMS errors, and more in which a single corner is to blame.

    The last of the sizes is so large that it pulls the mean up, and the other bad views would
    pass. Of the views with a slip one is to go and one may stay: the mean length would keep both,
    the worst corner neither.
    """
    slips = [with_one_slip(views_of_size(rng, sizes[:1])[0], size) for size in slipped]
    return rng.permutation(np.concatenate([views_of_size(rng, sizes), slips]))


def one_bad_view(rng: Generator) -> Inputs:
    """Draw a very bad view, two that are bad enough, and some just good enough."""
    sizes = 1.5 * np.array([0.85, 0.95, 1, 1, 1, 1, 1, 1, 1.05, 1.38, 1.75, 2.5, 14])
    return {"residuals": some_bad_views(rng, sizes, 1.5 * np.array([1.6, 2.4])), "limit": 2.0}


def another_limit(rng: Generator) -> Inputs:
    sizes = 2.0 * np.array([0.85, 1, 1, 1, 1, 1, 1.1, 1.6, 1.8, 4, 20])
    return {"residuals": some_bad_views(rng, sizes, 2.0 * np.array([2.6, 3.5])), "limit": 3.0}
