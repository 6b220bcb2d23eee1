"""Inputs for the exercises of chapter 10: cameras around a few points, blocks, damped equations."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from course_lib import bundle
from course_lib.judging import Known
from course_lib.transforms import look_at, rotation_from_vector

Inputs = dict[str, Any]
Floats = NDArray[np.float64]


# --- cameras ----------------------------------------------------------------------------------


def intrinsics(rng: Generator) -> Floats:
    """Draw the intrinsics of a camera with square pixels."""
    f = np.round(rng.uniform(700, 1100), 1)
    cx, cy = rng.uniform((300, 220), (340, 260)).round(1)
    return np.array([[f, 0, cx], [0, f, cy], [0, 0, 1]])


def camera_around(rng: Generator, angle: float) -> tuple[Floats, Floats]:
    """Draw a camera that looks at the middle of the scene, held a little askew."""
    eye = [5 * np.cos(angle), 5 * np.sin(angle), rng.uniform(1, 3)]
    R, t = look_at(eye, rng.uniform(-0.2, 0.2, 3))
    askew = rotation_from_vector([0, 0, rng.uniform(0.1, 0.3)])
    return askew @ R, askew @ t


def seen_by(K: Floats, R: Floats, t: Floats, points: Floats) -> Floats:
    """Return the pixels of points, one after the other."""
    q = np.array([K @ (R @ point + t) for point in points])
    return np.asarray(q[:, :2] / q[:, 2:])


# --- resect_camera ----------------------------------------------------------------------------


def scene_of_one(rng: Generator, count: int) -> tuple[Inputs, tuple[Floats, Floats]]:
    K, (R, t) = intrinsics(rng), camera_around(rng, rng.uniform(0, 2 * np.pi))
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    points = np.vstack([corners, rng.uniform(-1, 1, (count - 8, 3))]) + rng.uniform(0, 0.2, 3)
    points = points.round(2)
    return {"points": points, "pixels": seen_by(K, R, t, points), "K": K}, (R, t)


def exact_pixels(rng: Generator) -> Known:
    return Known(*scene_of_one(rng, 9))


def pixels_with_errors(rng: Generator) -> Inputs:
    inputs, _ = scene_of_one(rng, 10)
    return {**inputs, "pixels": inputs["pixels"] + rng.normal(0, 4, (10, 2))}


# --- reprojection_jacobian --------------------------------------------------------------------


def anisotropic(rng: Generator) -> Floats:
    """Draw intrinsics with two different focal lengths."""
    K = intrinsics(rng)
    K[1, 1] = np.round(K[0, 0] * rng.uniform(1.1, 1.3), 1)
    return K


def camera_at_the_origin(rng: Generator) -> Inputs:
    """Draw a point before a camera that defines the world's frame."""
    point = np.array([*rng.choice([-1, 1], 2) * rng.uniform(0.5, 1.5, 2), rng.uniform(2, 5)])
    return {"point": point.round(2), "K": anisotropic(rng), "R": np.eye(3), "t": np.zeros(3)}


def camera_anywhere(rng: Generator) -> Inputs:
    R, t = camera_around(rng, rng.uniform(0, 2 * np.pi))
    point = (rng.choice([-1, 1], 3) * rng.uniform(0.4, 1, 3)).round(2)
    return {"point": point, "K": anisotropic(rng), "R": R, "t": t}


# --- solve_normal_block -----------------------------------------------------------------------


def equations(rng: Generator, numbers: int, count: int) -> Inputs:
    """Draw the normal equations of random derivatives: every point is seen three times."""
    by_cameras = rng.normal(0, 1, (count, 6, numbers))
    by_point = rng.normal(0, 1, (count, 6, 3))
    residuals = rng.normal(0, 3, (count, 6))
    return {
        "U": np.einsum("nki,nkj->ij", by_cameras, by_cameras) + np.eye(numbers),
        "W": np.einsum("nki,nkj->nij", by_cameras, by_point),
        "V": np.einsum("nki,nkj->nij", by_point, by_point) + 0.5 * np.eye(3),
        "g_c": np.einsum("nki,nk->i", by_cameras, residuals),
        "g_p": np.einsum("nki,nk->ni", by_point, residuals),
    }


def one_point(rng: Generator) -> Inputs:
    """Draw the equations of a camera that can only move, and of one point."""
    return equations(rng, 3, 1)


def many_points(rng: Generator) -> Inputs:
    """Draw the equations of two cameras and a few points."""
    return equations(rng, 12, 5)


# --- bundle_adjust ----------------------------------------------------------------------------


def small_block(rng: Generator) -> Inputs:
    """Draw three cameras and seven points, as they are; pixels have errors of half a pixel."""
    K, first = intrinsics(rng), rng.uniform(0, 2 * np.pi)
    poses = [camera_around(rng, first + 0.6 * i) for i in range(3)]
    points = rng.uniform(-1, 1, (7, 3))
    pixels = np.array([seen_by(K, R, t, points) for R, t in poses])
    return {
        "K": K,
        "R": np.array([R for R, _ in poses]),
        "t": np.array([t for _, t in poses]),
        "points": points,
        "pixels": pixels + rng.normal(0, 0.5, pixels.shape),
    }


def some_pixels_wrong(rng: Generator, damping: float) -> Inputs:
    """Draw a block whose start is some pixels wrong."""
    block = small_block(rng)
    moved = block["points"] + rng.normal(0, 0.1, (7, 3))
    shifted = block["t"] + rng.normal(0, 0.05, (3, 3))
    return {**block, "t": shifted, "points": moved, "damping": damping}


def a_step_that_helps(rng: Generator) -> Inputs:
    return some_pixels_wrong(rng, float(np.round(rng.uniform(0.02, 0.08), 3)))


def a_step_that_does_not(rng: Generator) -> Inputs:
    """Draw one of a hundred blocks whose next step is too long; to find one takes its time."""
    return dict(overstepping(int(rng.integers(100))))


@cache
def overstepping(number: int) -> Inputs:
    """Return a block whose first picture was held upright, which its start does not know.

    A first step is made here. The one after it is too long, and its R with the old t and points
    fits even worse than all of it: where the old error is meant, that one tells.
    """
    rng = np.random.default_rng([10, number])
    while True:
        block = some_pixels_wrong(rng, 0.002)
        turn = rotation_from_vector([0, 0, rng.uniform(1.8, 2.1)])
        block["R"] = np.concatenate([[turn @ block["R"][0]], block["R"][1:]])
        block["t"] = np.concatenate([[turn @ block["t"][0]], block["t"][1:]])
        after, gain = stepped(block)
        if gain > 0 and refused(after):
            return after


def refused(block: Inputs) -> bool:
    """Say whether a step makes the error larger, and its R alone makes it larger still."""
    place = {name: value for name, value in block.items() if name != "damping"}
    there, gain = stepped(block)
    return gain < 0 and gain > bundle.squared_error(**place) - bundle.squared_error(
        **{**place, "R": there["R"]}
    )


def stepped(block: Inputs) -> tuple[Inputs, float]:
    """Return a block after a damped step, helpful or not, and by how much its error falls."""
    damping = block["damping"]
    place = {name: value for name, value in block.items() if name != "damping"}
    U, W, V, g_c, g_p = bundle.normal_blocks(**place)
    U[np.diag_indices(len(U))] *= 1 + damping
    V[:, range(3), range(3)] *= 1 + damping
    step = bundle.solve_normal_block(U, W, V, g_c, g_p)
    moved = bundle.move_block(block["R"], block["t"], block["points"], *step)
    there = {**place, **dict(zip(("R", "t", "points"), moved, strict=True))}
    gain = bundle.squared_error(**place) - bundle.squared_error(**there)
    return {**there, "damping": damping}, gain
