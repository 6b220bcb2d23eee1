"""Inputs for the exercises of chapter 06 on camera matrices and correction tables."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from course_lib.exercises.homogeneous.inputs import any_rotation
from course_lib.judging import Known

Floats = NDArray[np.float64]


def intrinsics(rng: Generator) -> Floats:
    """Draw K with two focal lengths, a skew and a principal point off the middle."""
    fx = rng.uniform(700, 1500)
    return np.array(
        [
            [fx, rng.uniform(4, 30), rng.uniform(280, 340)],
            [0, fx * rng.uniform(1.05, 1.3), rng.uniform(200, 260)],
            [0, 0, 1],
        ]
    )


def matrix_of(K: Floats, R: Floats, centre: Floats) -> Floats:
    return np.asarray(K @ R @ np.column_stack([np.eye(3), -centre]))


# --- camera_dlt -------------------------------------------------------------------------------


def resection(rng: Generator, count: int, unit: float) -> Known:
    """Choose a camera and points before it; no two of them near each other."""
    K, R = intrinsics(rng), any_rotation(rng)
    cells = rng.permutation(27)[:count]
    box = np.stack([cells % 3, cells // 3 % 3, cells // 9], axis=1) - 1
    points = unit * (box + rng.uniform(-0.4, 0.4, (count, 3)) + rng.uniform(0.3, 0.6, 3))
    centre = -R.T @ np.array([*rng.uniform(-0.5, 0.5, 2), rng.uniform(6, 8)]) * unit
    P = matrix_of(K, R, centre)
    x = np.column_stack([points, np.ones(count)]) @ P.T
    pixels = x[:, :2] / x[:, 2:]
    # Six points in general position determine the camera, but some positions hardly do.
    if np.linalg.matrix_rank(points - points.mean(axis=0), tol=0.5 * unit) < 3:
        return resection(rng, count, unit)
    return Known({"points": points, "pixels": pixels}, P)


def six_points(rng: Generator) -> Known:
    return resection(rng, 6, 1)


def twelve_points(rng: Generator) -> Known:
    return resection(rng, 12, 1)


def points_in_millimetres(rng: Generator) -> Known:
    return resection(rng, 9, 40)


def pixels_with_errors(rng: Generator) -> dict[str, Any]:
    """Measure twelve points some pixels off: then it matters in which unit A is made."""
    inputs = resection(rng, 12, 40).inputs
    errors = rng.normal(size=(12, 2))
    pixels = inputs["pixels"] + 2 * errors / np.sqrt(np.mean(errors**2))
    return {"points": inputs["points"].round(2), "pixels": pixels.round(1)}


# --- decompose_projection ---------------------------------------------------------------------


def camera_in_parts(rng: Generator, factor: float) -> Known:
    K, R = intrinsics(rng), any_rotation(rng)
    centre = rng.uniform(2, 9, 3) * rng.choice([-1, 1], 3)
    return Known({"P": factor * matrix_of(K, R, centre)}, (K, R, centre))


def as_it_was_put_together(rng: Generator) -> Known:
    """Choose one whose parts come with signs to mend, by QR of the inverse as by RQ.

    QR makes the last number of K negative, which must not get lost when K is divided by it.
    """
    from scipy.linalg import rq

    while True:
        known = camera_in_parts(rng, 1)
        M = known.inputs["P"][:, :3]
        if np.linalg.qr(np.linalg.inv(M))[1][2, 2] < 0 and min(np.diag(rq(M)[0])) < 0:
            return known


def any_multiple(rng: Generator) -> Known:
    return camera_in_parts(rng, float(rng.uniform(1.5, 4) ** rng.choice([-1, 1])))


def negative_multiple(rng: Generator) -> Known:
    return camera_in_parts(rng, -float(rng.uniform(1.5, 4) ** rng.choice([-1, 1])))


# --- correction_table: cells are filled one by one, so that their means are known ----------------


def filled(rng: Generator, shape: Any, counts: Any, inside: Any) -> Known:
    """Put so many residuals into each cell, at places that `inside` draws between 0 and 1."""
    rows, columns = shape
    cell = rng.integers(40, 60, 2).astype(float)
    pixels, residuals, truth = [], [], np.zeros((rows, columns, 2))
    for place in np.ndindex(rows, columns):
        mean, count = rng.uniform(0.2, 1.5, 2) * rng.choice([-1, 1], 2), counts[place]
        errors = rng.uniform(-0.6, 0.6, (count, 2))
        if count:
            truth[place] = mean
            residuals += list(mean + errors - errors.mean(axis=0))
            pixels += list((np.array(place[::-1]) + inside(rng, count)) * cell - 0.5)
    order = rng.permutation(len(pixels))
    inputs = {
        "pixels": np.array(pixels)[order],
        "residuals": np.array(residuals)[order],
        "image_size": tuple(int(side) for side in cell * (columns, rows)),
        "shape": (rows, columns),
    }
    return Known(inputs, truth)


def well_inside(rng: Generator, count: int) -> Floats:
    return np.asarray(rng.uniform(0.1, 0.9, (count, 2)))


def some_shape(rng: Generator) -> tuple[int, int]:
    return (2, 3) if rng.uniform() < 0.5 else (4, 3)


def every_cell_seen(rng: Generator) -> Known:
    shape = some_shape(rng)
    return filled(rng, shape, rng.integers(2, 6, shape), well_inside)


def some_cells_empty(rng: Generator) -> Known:
    shape = some_shape(rng)
    counts = rng.integers(2, 6, shape)
    empty = rng.permutation(counts.size)[:2]
    counts.flat[empty] = 0
    return filled(rng, shape, counts, well_inside)


def on_the_last_edge(rng: Generator) -> Known:
    """Move one pixel of the last cell to the corner of the picture."""
    known = every_cell_seen(rng)
    end = np.array(known.inputs["image_size"]) - 0.5
    pixels = known.inputs["pixels"]
    pixels[np.argmin(np.linalg.norm(pixels - end, axis=1))] = end
    return known


def at_the_edges(rng: Generator, count: int) -> Floats:
    """Draw places a fraction of a pixel beyond the edge where a cell begins."""
    return np.asarray(rng.uniform(0.001, 0.007, (count, 2)))


def near_the_edges_of_cells(rng: Generator) -> Known:
    shape = some_shape(rng)
    return filled(rng, shape, rng.integers(2, 5, shape), at_the_edges)
