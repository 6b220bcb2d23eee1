"""Inputs for the exercises of chapter 10 on circles of pictures and on orientation."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from course_lib.judging import Known
from course_lib.transforms import rotation_from_vector

Inputs = dict[str, Any]
Floats = NDArray[np.float64]

#: So many pictures around a circle that nobody can have recorded the answers to all steps.
COUNTS = range(14, 720)
#: Shares of a circle as one may compute them, in ways that round differently.
STEPS = [
    (n, float(step))
    for n in COUNTS
    for step in (np.radians(360 / n), 2 * np.pi * (1 / n), 1 / (n / (2 * np.pi)))
]
#: Those into which 2π goes exactly so often, and a hair more often.
EXACT = tuple((n, step) for n, step in STEPS if 2 * np.pi / step == n)
ROUNDED_UP = tuple((n, step) for n, step in STEPS if 2 * np.pi / step > n)


# --- pictures_for_circle ----------------------------------------------------------------------


def steps_that_fill_the_circle(rng: Generator) -> Known:
    count, step = EXACT[rng.integers(len(EXACT))]
    return Known({"step": step}, count)


def steps_with_a_rest(rng: Generator, low: float, high: float) -> Known:
    """Draw a step that goes into the circle a number of times, and a share of once more."""
    whole = int(rng.choice(COUNTS))
    return Known({"step": float(2 * np.pi / (whole + rng.uniform(low, high)))}, whole + 1)


def small_rest(rng: Generator) -> Known:
    return steps_with_a_rest(rng, 0.1, 0.4)


def large_rest(rng: Generator) -> Known:
    return steps_with_a_rest(rng, 0.6, 0.9)


def rounded_up(rng: Generator) -> Known:
    count, step = ROUNDED_UP[rng.integers(len(ROUNDED_UP))]
    return Known({"step": step}, count)


# --- similarity_transform ---------------------------------------------------------------------


def laid_over(rng: Generator, points: Floats, moved: Floats) -> Inputs:
    """Draw a turn, a scale and a move for points, and lay moved ones over the world."""
    axis = rng.normal(size=3)
    R = rotation_from_vector(rng.uniform(0.6, 2) * axis / np.linalg.norm(axis))
    t = rng.uniform(20, 60, 3) * rng.choice([-1, 1], 3)
    return {"points": points, "targets": rng.uniform(2, 5) * moved @ R.T + t}


def model(rng: Generator, count: int) -> Floats:
    """Draw points that lie far from zero, and differently far along each axis."""
    spread = rng.permutation([1, 2, 3])
    return np.asarray(rng.uniform(-1, 1, (count, 3)) * spread + rng.uniform(2, 4, 3))


def exact_targets(rng: Generator) -> Inputs:
    points = model(rng, 6)
    return laid_over(rng, points, points)


def targets_with_errors(rng: Generator) -> Inputs:
    points = model(rng, 6)
    return laid_over(rng, points, points + rng.uniform(0.1, 0.25, (6, 3)) * signs(rng, (6, 3)))


def nearly_flat(rng: Generator) -> Inputs:
    """Draw flat ground whose small heights were measured with errors as large as they are."""
    points = rng.uniform(-3, 3, (6, 3)) * [1, 0.6, 0] + rng.uniform(2, 4, 3)
    heights = rng.uniform(0.1, 0.2, 6) * rng.permutation([-1, -1, -1, 1, 1, 1])
    up = np.outer(heights, [0, 0, 1])
    return laid_over(rng, points + up, points - 0.8 * up)


def signs(rng: Generator, shape: tuple[int, ...]) -> Floats:
    return np.asarray(rng.choice([-1.0, 1.0], shape))


# --- check_point_rmse -------------------------------------------------------------------------


def few_check_points(rng: Generator) -> Inputs:
    """Draw small whole errors, which can be followed by hand."""
    surveyed = rng.integers(0, 50, (4, 3)).astype(float)
    errors = rng.integers(1, 6, (4, 3)) * signs(rng, (4, 3)) * [1, 2, 4]
    return {"estimated": surveyed + errors, "surveyed": surveyed}


def heights_too_low(rng: Generator) -> Inputs:
    """Draw errors that do not cancel: all heights are too low."""
    surveyed = rng.uniform(0, 100, (12, 3)).round(2)
    errors = rng.normal(0, 0.03, (12, 3)) - [0, 0.01, 0.15]
    return {"estimated": surveyed + errors.round(3), "surveyed": surveyed}
