"""Inputs for the exercises of chapter 05. Signs vary; sizes keep lenses mild and terms apart."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from course_lib.distortion import distort
from course_lib.judging import Known

Inputs = dict[str, Any]
Array = NDArray[np.float64]


def either_sign(rng: Generator, low: float, high: float) -> float:
    """Draw a number of this size, rounded so that it can be read."""
    return float(rng.choice([-1, 1]) * np.round(rng.uniform(low, high), 4))


def tangents(rng: Generator, count: int = 4, farthest: float = 0.8) -> Array:
    """Draw points from 0.3 on away from the centre, none of them near an axis."""
    turn = rng.integers(0, 4, count) * np.pi / 2 + rng.uniform(0.2, np.pi / 2 - 0.2, count)
    r = rng.uniform(0.3, farthest, count)
    return np.asarray([r * np.cos(turn), r * np.sin(turn)]).T.round(3)


def tangential(rng: Generator) -> tuple[float, float]:
    """Draw p1 and p2, never of the same size."""
    sizes = [either_sign(rng, 0.002, 0.005), either_sign(rng, 0.007, 0.012)]
    return tuple(rng.permutation(sizes).tolist())


def lens(rng: Generator) -> Array:
    """Draw ``k1 k2 p1 p2 k3`` of a mild lens."""
    k1, k2, k3 = (either_sign(rng, *size) for size in ((0.12, 0.22), (0.03, 0.08), (0.01, 0.03)))
    return np.array([k1, k2, *tangential(rng), k3])


# --- distort_radial ---------------------------------------------------------------------------


def one_coefficient(rng: Generator) -> Inputs:
    return {"points": tangents(rng), "k": np.array([either_sign(rng, 0.1, 0.3)])}


def several_coefficients(rng: Generator) -> Inputs:
    k = [either_sign(rng, *size) for size in ((0.1, 0.3), (0.05, 0.1), (0.02, 0.04))]
    return {"points": tangents(rng), "k": np.array(k[: int(rng.integers(2, 4))])}


def single_point(rng: Generator) -> Inputs:
    return {"points": tangents(rng)[0], "k": several_coefficients(rng)["k"]}


# --- distort ----------------------------------------------------------------------------------


def radial_alone(rng: Generator) -> Inputs:
    coefficients = lens(rng)
    coefficients[2:4] = 0
    return {"points": tangents(rng), "coefficients": coefficients}


def tangential_alone(rng: Generator) -> Inputs:
    return {"points": tangents(rng), "coefficients": np.array([0, 0, *tangential(rng), 0])}


def all_five(rng: Generator) -> Inputs:
    return {"points": tangents(rng), "coefficients": lens(rng)}


# --- distort_rational_prism -------------------------------------------------------------------


def fraction_alone(rng: Generator) -> Inputs:
    sizes = ((0.1, 0.2), (0.04, 0.08), (0.01, 0.03), (0.2, 0.3), (0.05, 0.1), (0.01, 0.02))
    k = np.array([either_sign(rng, *size) for size in sizes])
    return {"points": tangents(rng), "k": k, "p": np.zeros(2), "s": np.zeros(4)}


def prism_alone(rng: Generator) -> Inputs:
    sizes = rng.permutation([0.002, 0.005, 0.008, 0.011])
    s = sizes * rng.uniform(0.9, 1.1, 4) * rng.choice([-1, 1], 4)
    return {"points": tangents(rng), "k": np.zeros(6), "p": np.zeros(2), "s": np.round(s, 5)}


def all_twelve(rng: Generator) -> Inputs:
    k, s = fraction_alone(rng)["k"], prism_alone(rng)["s"]
    return {"points": tangents(rng), "k": k, "p": np.array(tangential(rng)), "s": s}


# --- undistort_points: the ideal points are chosen, the distorted ones follow --------------------


def sent_through(rng: Generator, coefficients: Array) -> Known:
    ideal = tangents(rng, farthest=0.65)
    points = distort(ideal, coefficients)
    return Known({"points": points, "coefficients": coefficients}, ideal)


def barrel(rng: Generator) -> Known:
    return sent_through(rng, np.array([-np.round(rng.uniform(0.1, 0.25), 3), 0, 0, 0, 0]))


def pincushion(rng: Generator) -> Known:
    return sent_through(rng, np.array([np.round(rng.uniform(0.1, 0.25), 3), 0, 0, 0, 0]))


def five_at_once(rng: Generator) -> Known:
    return sent_through(rng, lens(rng))


# --- valid_radius: the folds are chosen, the coefficients follow ---------------------------------


def folding_at(first: float, second: float) -> Array:
    """Return k1, k2 whose derivative is zero at two given squares of r (one may be negative)."""
    # 1 + 3 k1 q + 5 k2 q² = (1 - q / first) (1 - q / second)
    return np.array([-(1 / first + 1 / second) / 3, 1 / (5 * first * second)])


def first_coefficient_alone(rng: Generator) -> Known:
    r = rng.uniform(0.6, 2)
    return Known({"coefficients": folding_at(r**2, np.inf)}, r)


def one_fold(rng: Generator) -> Known:
    """Draw a k2 that is negative: the other root is too."""
    r = rng.uniform(0.6, 2)
    return Known({"coefficients": folding_at(r**2, -(r**2) * rng.uniform(0.3, 3))}, r)


def two_folds(rng: Generator) -> Known:
    r = rng.uniform(0.6, 2)
    return Known({"coefficients": folding_at(r**2, r**2 * rng.uniform(1.5, 4))}, r)


def no_fold(rng: Generator) -> Known:
    """Draw a derivative without real zeros: its square term is large enough."""
    k1 = -np.round(rng.uniform(0.1, 0.3), 3)
    k2 = np.round(9 * k1**2 / 20 * rng.uniform(1.3, 3), 4)
    return Known({"coefficients": np.array([k1, k2])}, np.inf)


# --- undistortion_map -------------------------------------------------------------------------


def picture(rng: Generator, aspect: float) -> Inputs:
    """Draw a small picture with a camera whose centre is not the picture's."""
    # Large enough that the lens moves some pixels by more than one: rounding does not hide it.
    width, height = (int(n) for n in rng.permutation([30, 20] if aspect == 1 else [28, 22]))
    f = np.round(rng.uniform(21, 26), 1)
    centre = np.round((np.array([width, height]) - 1) / 2 + rng.uniform(0.2, 0.8, 2), 1)
    K = np.array([[f, 0, centre[0]], [0, np.round(f * aspect, 1), centre[1]], [0, 0, 1]])
    return {"K": K, "coefficients": lens(rng), "image_size": (width, height)}


def square_pixels(rng: Generator) -> Inputs:
    return picture(rng, 1)


def oblong_pixels(rng: Generator) -> Inputs:
    return picture(rng, float(rng.choice([0.8, 1.25])))


# --- straightness -----------------------------------------------------------------------------


def along(rng: Generator, slant: float) -> Inputs:
    """Draw points along a line, which scatter across it by some pixels."""
    t = np.sort(rng.uniform(-200, 200, int(rng.integers(6, 10))))
    across = 3 * rng.standard_normal(t.size)
    direction = np.array([np.cos(slant), np.sin(slant)])
    normal = np.array([-direction[1], direction[0]])
    middle = rng.uniform(200, 400, 2)
    return {"points": np.round(middle + t[:, None] * direction + across[:, None] * normal, 2)}


def gentle_line(rng: Generator) -> Inputs:
    return along(rng, float(rng.choice([-1, 1]) * rng.uniform(0.2, 0.6)))


def steep_line(rng: Generator) -> Inputs:
    return along(rng, float(np.pi / 2 + rng.choice([-1, 1]) * rng.uniform(0.02, 0.1)))


# --- fisheye_project --------------------------------------------------------------------------


def seen(rng: Generator, low: float, high: float, k: Any) -> Inputs:
    """Draw points at these angles from the axis, as multiples of a right angle."""
    angle = rng.uniform(low, high, 4) * np.pi / 2
    turn = rng.integers(0, 4, 4) * np.pi / 2 + rng.uniform(0.2, np.pi / 2 - 0.2, 4)
    rays = np.stack(
        [np.sin(angle) * np.cos(turn), np.sin(angle) * np.sin(turn), np.cos(angle)], axis=1
    )
    fx = np.round(rng.uniform(200, 400), 1)
    K = np.array([[fx, 0, 320], [0, np.round(fx * 1.1, 1), 240], [0, 0, 1]])
    return {"points": np.round(rays * rng.uniform(1, 5, (4, 1)), 3), "K": K, "k": np.asarray(k)}


def angular(rng: Generator) -> Array:
    sizes = ((0.02, 0.05), (0.006, 0.012), (0.001, 0.003), (0.0002, 0.0005))
    return np.array([either_sign(rng, *size) for size in sizes])


def equidistant_ahead(rng: Generator) -> Inputs:
    return seen(rng, 0.3, 0.85, np.zeros(4))


def with_coefficients(rng: Generator) -> Inputs:
    return seen(rng, 0.3, 0.85, angular(rng))


def beside_and_behind(rng: Generator) -> Inputs:
    return seen(rng, 1.1, 1.4, np.zeros(4))
