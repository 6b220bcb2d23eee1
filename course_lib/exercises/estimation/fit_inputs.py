"""Inputs for the first exercises of chapter 06: errors are made perpendicular, so truth is known.

What least squares leaves over is perpendicular to every column of the design. Errors that are so
from the beginning do not move the solution.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from course_lib.judging import Known

Floats = NDArray[np.float64]


def away_from_zero(rng: Generator, least: float, most: float, size: Any = None) -> Any:
    """Draw numbers whose size is between two bounds, of either sign."""
    return rng.uniform(least, most, size) * rng.choice([-1, 1], size)


def errors_beside(rng: Generator, design: Floats, size: float) -> Floats:
    """Draw errors that are perpendicular to the columns of a design, none of them small."""
    while True:
        errors = rng.normal(size=len(design))
        Q = np.linalg.qr(design)[0]
        errors -= Q @ (Q.T @ errors)
        errors *= size / np.sqrt(np.mean(errors**2))
        if np.abs(errors).min() > 0.1 * size:
            return np.asarray(errors)


# --- solve_one_unknown ------------------------------------------------------------------------


def exact_equations(rng: Generator) -> Known:
    a, x = away_from_zero(rng, 1, 9, 3), float(away_from_zero(rng, 0.5, 5))
    return Known({"a": a, "b": a * x}, x)


def one_unknown(rng: Generator, a: Floats) -> Known:
    x = float(away_from_zero(rng, 0.5, 5))
    b = a * x + errors_beside(rng, a[:, None], 0.4 * abs(x) * float(np.abs(a).mean()))
    return Known({"a": a, "b": b}, x)


def equations_with_errors(rng: Generator) -> Known:
    return one_unknown(rng, np.sort(rng.uniform(1, 9, 5)))


def some_negative(rng: Generator) -> Known:
    return one_unknown(rng, rng.permutation([-1, -1, 1, 1, 1]) * rng.uniform(1, 9, 5))


# --- fit_line ---------------------------------------------------------------------------------


def line_of(rng: Generator, x: Floats, share: float) -> Known:
    """Choose a line; the errors are a share of how far it rises."""
    slope, intercept = float(away_from_zero(rng, 0.2, 3)), float(away_from_zero(rng, 2, 9))
    A = np.stack([x, np.ones_like(x)], axis=1)
    y = slope * x + intercept
    if share:
        y = y + errors_beside(rng, A, share * abs(slope) * float(np.ptp(x)))
    return Known({"x": x, "y": y}, (slope, intercept))


def points_on_a_line(rng: Generator) -> Known:
    return line_of(rng, np.sort(rng.choice(np.arange(1.0, 12), 4, replace=False)), 0)


def strain_against_load(rng: Generator) -> Known:
    return line_of(rng, np.linspace(1, rng.uniform(8, 20), 7), 0.1)


def loads_in_any_order(rng: Generator) -> Known:
    return line_of(rng, rng.permutation(np.linspace(-6, rng.uniform(8, 20), 9)), 0.1)


# --- fit_affine -------------------------------------------------------------------------------


def mm_from_pixels(rng: Generator, points: Floats, error: float) -> Known:
    """Choose how a robot's table lies in the picture; the errors are in mm."""
    turn, scale = rng.uniform(0.3, 1.2) * rng.choice([-1, 1]), rng.uniform(0.2, 0.5)
    R = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    linear = scale * R @ [[1, rng.uniform(0.1, 0.3)], [0, rng.uniform(1.1, 1.4)]]
    A = np.column_stack([linear, away_from_zero(rng, 40, 200, 2)])
    X = np.column_stack([points, np.ones(len(points))])
    targets = X @ A.T
    if error:
        targets = targets + np.stack([errors_beside(rng, X, error) for _ in range(2)], axis=1)
    return Known({"points": points, "targets": targets}, A)


def in_the_picture(rng: Generator, count: int) -> Floats:
    """Draw points of which no three are near a line: one on each spoke of a wheel."""
    turns = 2 * np.pi * (np.arange(count) + rng.uniform(-0.2, 0.2, count)) / count
    radii = rng.uniform(0.6, 1, count) * 230
    points = np.stack([320 + radii * np.cos(turns), 240 + radii * np.sin(turns)], axis=1)
    return np.asarray(rng.permutation(points).round(1))


def three_markers(rng: Generator) -> Known:
    return mm_from_pixels(rng, in_the_picture(rng, 3), 0)


def exact_markers(rng: Generator) -> Known:
    return mm_from_pixels(rng, in_the_picture(rng, 6), 0)


def markers_with_errors(rng: Generator) -> Known:
    return mm_from_pixels(rng, in_the_picture(rng, 8), 3)
