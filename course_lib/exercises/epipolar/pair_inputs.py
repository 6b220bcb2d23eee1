"""Inputs for the exercises of chapter 08 on estimation: pairs, wrong ones among them, samples."""

from __future__ import annotations

import math

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from course_lib.epipolar import eight_point, sampson_error
from course_lib.exercises.epipolar.inputs import Inputs, Pair, crossed, fundamental, pair, sign
from course_lib.judging import Known

#: Largest Sampson error of a right pair, px, and that of the nearest wrong one.
THRESHOLD, FAR_OFF = 2.0, 6.0


# --- eight points -----------------------------------------------------------------------------


def exact_pairs(rng: Generator) -> Known:
    p = pair(rng, 10)
    return Known({"points1": p.pixels1, "points2": p.pixels2}, fundamental(p))


def pairs_with_noise(rng: Generator) -> Inputs:
    p = pair(rng, 25)
    one, other = (x + rng.normal(0, 1, x.shape) for x in (p.pixels1, p.pixels2))
    return {"points1": one, "points2": other}


# --- RANSAC -----------------------------------------------------------------------------------


def published_case(_: Generator) -> Known:
    """Give the entry of Hartley & Zisserman's table 4.3 for half of the pairs wrong."""
    return Known({"confidence": 0.99, "size": 8, "wrong_share": 0.5}, 1177)


def other_cases(rng: Generator) -> Inputs:
    """Draw a case whose number of samples, before it is rounded up, would be rounded down."""
    while True:
        confidence = float(rng.choice([0.95, 0.99, 0.999]))
        size, share = int(rng.integers(4, 9)), float(rng.integers(20, 48) / 100)
        exact = math.log(1 - confidence) / math.log(1 - (1 - share) ** size)
        if 0.1 < exact % 1 < 0.4 and exact > 5:
            return {"confidence": confidence, "size": size, "wrong_share": share}


def third_wrong(rng: Generator) -> Known:
    return with_wrong_pairs(rng, right=30, wrong=15)


def half_wrong(rng: Generator) -> Known:
    return with_wrong_pairs(rng, right=30, wrong=30)


def with_wrong_pairs(rng: Generator, right: int, wrong: int) -> Known:
    """Draw pairs of which some are wrong, and samples of which some have only right ones.

    Drawn again until what is right is beyond doubt: with the best sample, and with F of all right
    pairs, exactly the right pairs are within the threshold, and none is near to it.
    """
    while True:
        p = pair(rng, right + wrong)
        is_right = rng.permutation(np.arange(right + wrong) < right)
        one, other = (x + rng.normal(0, 0.1, x.shape) for x in (p.pixels1, p.pixels2))
        other[~is_right] = rng.uniform((0, 0), (640, 480), (wrong, 2))
        samples = draw_samples(rng, is_right)
        if beyond_doubt(one, other, is_right, samples):
            inputs = {"points1": one, "points2": other, "samples": samples, "threshold": THRESHOLD}
            return Known(inputs, (eight_point(one[is_right], other[is_right]), is_right))


def draw_samples(rng: Generator, is_right: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Draw nine samples of which three, neither the first nor the last, have right pairs only."""
    chosen = 1 + rng.choice(7, 3, replace=False)
    every, good = np.arange(len(is_right)), np.flatnonzero(is_right)
    rows = [rng.choice(good if i in chosen else every, 8, replace=False) for i in range(9)]
    return np.array(rows)


def beyond_doubt(
    one: NDArray[np.float64],
    other: NDArray[np.float64],
    is_right: NDArray[np.bool_],
    samples: NDArray[np.intp],
) -> bool:
    """Tell whether only samples of right pairs are the best, and all that fits are right pairs."""

    def errors(chosen: NDArray[np.intp] | NDArray[np.bool_]) -> NDArray[np.float64]:
        return sampson_error(one, other, eight_point(one[chosen], other[chosen]))

    good = [is_right[sample].all() for sample in samples]
    found = [errors(sample) for sample in samples]
    counts = np.array([(e < THRESHOLD).sum() for e in found])
    best = [*(found[i] for i in np.flatnonzero(counts == counts.max())), errors(is_right)]
    clear = all(e[is_right].max() < 0.8 * THRESHOLD and e[~is_right].min() > FAR_OFF for e in best)
    return sum(good) == 3 and clear


# --- pose -------------------------------------------------------------------------------------


def pose_of_pair(rng: Generator) -> Known:
    return posed(rng, pair(rng, 5))


def pose_of_one_point(rng: Generator) -> Known:
    return posed(rng, pair(rng, 1))


def posed(rng: Generator, p: Pair) -> Known:
    length = np.linalg.norm(p.t)
    E = crossed(p.t, p.R) * sign(rng) * rng.uniform(0.5, 3)
    return Known({"E": E, "points1": p.near1, "points2": p.near2}, (p.R, p.t / length))
