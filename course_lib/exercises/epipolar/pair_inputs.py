"""Inputs for the exercises of chapter 08 on estimation: pairs, wrong ones among them, samples."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from course_lib.epipolar import eight_point, epipolar_lines, pair_depths, sampson_error
from course_lib.exercises.epipolar.inputs import (
    Inputs,
    baseline,
    crossed,
    fundamental,
    pair,
    seen_by_both,
    sign,
    turn,
)
from course_lib.judging import Known

#: Largest Sampson error of a right pair, px. Some wrong ones are not much worse: between these.
THRESHOLD, A_LITTLE_OFF = 2.0, (2.3, 3.7)


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


def exact_but_a_quarter(rng: Generator) -> Known:
    return with_wrong_pairs(int(rng.integers(2**62)), right=30, wrong=10, noise=0)


def noisy_but_nearly_half(rng: Generator) -> Known:
    return with_wrong_pairs(int(rng.integers(2**62)), right=33, wrong=27, noise=0.1)


@lru_cache(maxsize=128)  # the same seeds are posed again and again
def with_wrong_pairs(seed: int, right: int, wrong: int, noise: float) -> Known:
    """Draw pairs of which some are wrong, and samples of which some have only right ones.

    Drawn again until what is right is beyond doubt: with the best sample, and with F of all right
    pairs, exactly the right pairs are within the threshold, and none is near to it.
    """
    rng = np.random.default_rng(seed)
    while True:
        p = pair(rng, right + wrong)
        is_right = rng.permutation(np.arange(right + wrong) < right)
        one, other = (x + rng.normal(0, noise, x.shape) for x in (p.pixels1, p.pixels2))
        normals = epipolar_lines(one, fundamental(p))[:, :2]
        off = np.append(rng.uniform(3.6, 4.6, 3), rng.uniform(20, 200, wrong - 3))[:, None]
        off *= rng.choice([-1, 1], (wrong, 1))
        other[~is_right] += off * normals[~is_right] + rng.normal(0, 60, (wrong, 1)) * np.fliplr(
            normals[~is_right] * [1, -1]
        )
        samples = draw_samples(rng, is_right)
        if not beyond_doubt(one, other, is_right, samples):
            continue
        samples[[0, -1]] = [among_themselves(rng, one, other, is_right) for _ in range(2)]
        if beyond_doubt(one, other, is_right, samples):
            inputs = {"points1": one, "points2": other, "samples": samples, "threshold": THRESHOLD}
            return Known(inputs, (eight_point(one[is_right], other[is_right]), is_right))


def draw_samples(rng: Generator, is_right: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Draw six samples of which two, neither the first nor the last, have right pairs only."""
    chosen = 1 + rng.choice(4, 2, replace=False)
    every, good = np.arange(len(is_right)), np.flatnonzero(is_right)
    rows = [rng.choice(good if i in chosen else every, 8, replace=False) for i in range(6)]
    return np.array(rows)


def among_themselves(
    rng: Generator,
    one: NDArray[np.float64],
    other: NDArray[np.float64],
    is_right: NDArray[np.bool_],
) -> NDArray[np.intp]:
    """Draw a sample with a wrong pair whose eight pairs fit their own F: one in ten or twenty."""
    while True:
        sample = rng.choice(len(is_right), 8, replace=False)
        F = eight_point(one[sample], other[sample])
        if not is_right[sample].all() and agree(one[sample], other[sample], F):
            return sample


def agree(one: NDArray[np.float64], other: NDArray[np.float64], F: NDArray[np.float64]) -> bool:
    """Tell whether all pairs fit."""
    return bool((sampson_error(one, other, F) < THRESHOLD).all())


def beyond_doubt(
    one: NDArray[np.float64],
    other: NDArray[np.float64],
    is_right: NDArray[np.bool_],
    samples: NDArray[np.intp],
) -> bool:
    """Tell whether only samples of right pairs are the best, and all that fits are right pairs.

    The sum of all errors, to which wrong pairs add most, must point to another sample.
    """

    def errors(chosen: NDArray[np.intp] | NDArray[np.bool_]) -> NDArray[np.float64]:
        return sampson_error(one, other, eight_point(one[chosen], other[chosen]))

    good = [is_right[sample].all() for sample in samples]
    found = [errors(sample) for sample in samples]
    counts = np.array([(e < THRESHOLD).sum() for e in found])
    best = [*(found[i] for i in np.flatnonzero(counts == counts.max())), errors(is_right)]
    nearest, limit = A_LITTLE_OFF
    clear = all(
        e[is_right].max() < 0.8 * THRESHOLD and nearest < e[~is_right].min() < limit for e in best
    )
    misled = good[int(np.argmin([e.sum() for e in found]))]
    return sum(good) == 2 and clear and not misled


# --- pose -------------------------------------------------------------------------------------

W = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
#: One in four or eight is as wanted, with the signs that NumPy's factors have here.
MOST_DRAWS = 100


def several_points(rng: Generator) -> Known:
    return second_turn(int(rng.integers(2**62)))


def one_point(rng: Generator) -> Known:
    return first_turn(int(rng.integers(2**62)))


@lru_cache(maxsize=64)
def second_turn(seed: int) -> Known:
    """Draw one with the second turn, as NumPy gives it a mirror image, and the first sign of t.

    For the other turn all points are before one camera and behind the other.
    """
    rng = np.random.default_rng(seed)
    for _ in range(MOST_DRAWS):
        known = posed(rng, 4, (1, 1))
        t = known.truth[1]
        E, *points = known.inputs.values()
        U, _, Vt = np.linalg.svd(E)
        mirrored = np.linalg.det(U @ Vt) < 0
        other = U @ W @ Vt * (-1 if mirrored else 1)
        Z1, Z2 = pair_depths(other, t, *points)
        if mirrored and len({*np.sign(Z1), *-np.sign(Z2)}) == 1:
            break
    return known


@lru_cache(maxsize=64)
def first_turn(seed: int) -> Known:
    """Draw one with the first turn, and the second sign of t."""
    return posed(np.random.default_rng(seed), 1, (0, -1))


def posed(rng: Generator, count: int, wanted: tuple[int, int]) -> Known:
    """Draw until, of the poses that NumPy's factors give, a certain turn and sign are right."""
    for _ in range(MOST_DRAWS):
        R, t = turn(rng), baseline(rng)
        E = crossed(t, R) * sign(rng) * rng.uniform(0.5, 3)
        U, _, Vt = np.linalg.svd(E)
        product = U @ (W, W.T)[wanted[0]] @ Vt
        if abs((product * R).sum()) > 2.99 and wanted[1] * (t @ U[:, 2]) > 0:
            break
    near1, near2 = seen_by_both(rng, R, t, count)
    inputs = {"E": E, "points1": near1, "points2": near2}
    return Known(inputs, (R, t / np.linalg.norm(t)))
