"""The search among samples: RANSAC with local optimisation, for many hypotheses at once.

A sample of as few pairs as will do gives hypotheses. A hypothesis is judged by the errors of all
pairs, each no worse than the threshold (MSAC). The best ones of each batch are refined with all
pairs before they are judged again: then one good sample is enough, even if it is not very good.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Generic

import numpy as np
from numpy.typing import NDArray

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_count,
    check_generator,
    check_number,
)
from course_lib.epipolar.lines import sampson_residuals
from course_lib.epipolar.refinement import G, refined_robustly

Single = NDArray[np.floating[Any]]

#: How many pairs judge all hypotheses of a batch, and how many of the best all pairs judge.
FEW, BEST = 100, 8
#: How many of those are refined.
REFINED = 1
#: Only hypotheses are refined that are not much worse than the best one, which is refined.
HOPEFUL = 1.05
#: Steps of the refinement of a hypothesis; a last one goes to the end.
FIRST_STEPS = 3
BATCH = 64, 256  # the first one, and those after it
AGAIN = 100  # those from pairs that fit
AT_ONCE = 2**17  # errors that are computed at once: more do not fit into a processor's cache


def ransac_iterations(confidence: float, size: int, wrong_share: float) -> int:
    """Return how many samples it takes until one without a wrong pair is likely among them.

    Parameters
    ----------
    confidence : float
        How likely that shall be, between 0 and 1, both excluded.
    size : int
        Pairs in a sample.
    wrong_share : float
        Share of pairs that are wrong, from 0 to less than 1.

    Returns
    -------
    int
        ``log(1 - confidence) / log(1 - (1 - wrong_share)^size)``, rounded up, at least 1.

    Raises
    ------
    TypeError, ValueError
        If a number is not what is said above.

    References
    ----------
    M. Fischler & R. Bolles, Communications of the ACM 24 (1981); Hartley & Zisserman, Multiple
    View Geometry, 2nd ed., table 4.3.

    Examples
    --------
    >>> ransac_iterations(0.99, 8, 0.5)
    1177
    """
    confidence = check_confidence(confidence)
    share, pairs = check_number(wrong_share, "wrong_share"), check_number(size, "size")
    if not 0 <= share < 1:
        raise ValueError(f"wrong_share must be from 0 to less than 1, got {share:g}")
    if pairs < 1 or pairs % 1:
        raise ValueError(f"size must be a whole number of pairs, got {size}")
    samples = samples_needed(confidence, (1 - share) ** pairs)
    if math.isinf(samples):
        raise ValueError(f"no number of samples helps with {100 * share:g} % wrong pairs")
    return math.ceil(samples)


def samples_needed(confidence: float, good: float) -> float:
    """Return how many samples make it likely that one is good, if a share of them is."""
    if good >= 1:
        return 1.0
    missed = math.log1p(-good)  # of 1 - good, exact for tiny shares
    return max(1.0, math.log(1 - confidence) / missed) if missed < 0 else math.inf


def check_confidence(value: float) -> float:
    """Return a probability that is neither 0 nor 1."""
    confidence = check_number(value, "confidence")
    if not 0 < confidence < 1:
        raise ValueError(f"confidence must be between 0 and 1, got {confidence:g}: 0.99 is usual")
    return confidence


@dataclass(frozen=True, eq=False)
class Found(Generic[G]):
    """A geometry, what the errors cost, and which pairs fit: within the threshold, or twice it."""

    geometry: G
    costs: Array
    fits: NDArray[np.bool_]
    near: NDArray[np.bool_]

    @property
    def loss(self) -> float:
        """What all errors cost."""
        return float(self.costs.sum())


@dataclass(frozen=True, eq=False)
class Problem(Generic[G]):
    """Pairs as columns in one scale, and how samples of them become hypotheses.

    Attributes
    ----------
    x1, x2 : ndarray, shape (3, N)
        Homogeneous columns.
    threshold : float
        Errors beyond it belong to wrong pairs.
    size : int
        Pairs in a sample.
    hypotheses : callable
        Takes numbers of pairs, shape (B, size), and the number of the batch; returns fundamental
        matrices, shape (M, 3, 3).
    geometry : callable
        Takes one of them; returns what `refined_robustly` takes, or None.
    """

    x1: Array
    x2: Array
    threshold: float
    size: int
    hypotheses: Callable[[NDArray[np.intp], int], Array]
    geometry: Callable[[Array], G | None]

    @np.errstate(over="ignore", invalid="ignore")
    def losses(self, F: Array, which: NDArray[np.intp] | slice) -> Array:
        """Return what the errors of some pairs cost, for many matrices, (M, 3, 3) to (M,).

        It is their squares, at most 1 each (MSAC); in single precision, good enough for an order.
        What single precision cannot hold fits nothing.
        """
        x1, x2 = (x[:, which].astype(np.float32) for x in (self.x1, self.x2))
        products = (x2[:, None] * x1[None]).reshape(9, -1)
        parts = np.array_split(F.astype(np.float32), 1 + len(F) * x1.shape[1] // AT_ONCE)
        return np.concatenate([self._losses(part, x1, x2, products) for part in parts])

    def _losses(self, F: Single, x1: Single, x2: Single, products: Single) -> Array:
        """Return what errors cost, for matrices in single precision."""
        e = F.reshape(-1, 9) @ products
        l2 = (F[:, :2].reshape(-1, 3) @ x1).reshape(len(F), 2, -1)
        l1 = (F[:, :, :2].swapaxes(1, 2).reshape(-1, 3) @ x2).reshape(len(F), 2, -1)
        square = l2[:, 0] ** 2
        for part in (l2[:, 1], l1[:, 0], l1[:, 1]):
            part *= part
            square += part
        square *= np.float32(self.threshold**2)
        e *= e
        return np.asarray(np.fmin(e / (square + np.float32(1e-30)), 1).sum(axis=1))

    def improved(self, geometry: G) -> G:
        """Return a hypothesis after a few steps with all pairs."""
        return refined_robustly(geometry, self.x1, self.x2, self.threshold, FIRST_STEPS)[0]

    def found(self, geometry: G) -> Found[G]:
        """Return a geometry, what the errors cost, and which pairs fit."""
        scaled = np.abs(sampson_residuals(geometry.matrix, self.x1, self.x2)) / self.threshold
        return Found(geometry, np.minimum(scaled * scaled, 1), scaled <= 1, scaled <= 2)


def search(problem: Problem[G], confidence: float, most: int, rng: np.random.Generator) -> Found[G]:
    """Return the best geometry of samples, refined with all pairs.

    Each batch of samples from all pairs is followed by one from the pairs that fit the best
    geometry so far, of which more are right ones.

    Raises
    ------
    DegenerateConfigurationError
        If no sample gives a geometry that fits more pairs than a sample has.
    """
    rng, most = check_generator(rng), check_count(most, "most_samples")
    everyone = np.arange(problem.x1.shape[1])
    turn, drawn, needed = 0, 0, math.inf
    best: Found[G] | None = None
    while drawn < min(needed, most):
        samples = draw(rng, everyone, problem.size, BATCH[turn > 0])
        best = _best_of(problem, samples, turn, best, rng)
        drawn, turn = drawn + len(samples), turn + 1
        if best is None:
            continue
        needed = samples_needed(confidence, best.fits.mean() ** problem.size)
        near = np.flatnonzero(best.near)
        if needed > drawn and len(near) > 2 * problem.size:
            samples = draw(rng, near, problem.size, AGAIN)
            best = _best_of(problem, samples, turn, best, rng)
    if best is None or best.fits.sum() <= problem.size:
        raise DegenerateConfigurationError(
            f"no geometry fits more than {problem.size} of the {len(everyone)} pairs within the "
            "threshold: match the pictures anew, or allow larger errors"
        )
    geometry, _ = refined_robustly(best.geometry, problem.x1, problem.x2, problem.threshold)
    return problem.found(geometry)


def draw(
    rng: np.random.Generator, numbers: NDArray[np.intp], size: int, batch: int
) -> NDArray[np.intp]:
    """Return samples of different ones of the numbers, shape (about batch, size)."""
    count = len(numbers)
    if count < size * size:
        return np.asarray(numbers[np.argsort(rng.random((batch, count)), axis=1)[:, :size]])
    drawn = rng.integers(count, size=(batch, size))
    ordered = np.sort(drawn, axis=1)
    return np.asarray(numbers[drawn[(ordered[:, 1:] != ordered[:, :-1]).all(axis=1)]])


def _best_of(
    problem: Problem[G],
    samples: NDArray[np.intp],
    turn: int,
    best: Found[G] | None,
    rng: np.random.Generator,
) -> Found[G] | None:
    """Return the best so far, or a better one from samples."""
    found = problem.hypotheses(samples, turn)
    if len(found) > BEST:
        few = rng.integers(problem.x1.shape[1], size=FEW)
        found = found[np.argpartition(problem.losses(found, few), BEST)[:BEST]]
    if not len(found):
        return best
    losses = problem.losses(found, slice(None))
    for i in np.argsort(losses)[:REFINED]:
        geometry = problem.geometry(found[i])
        if geometry is not None and (best is None or losses[i] < HOPEFUL * best.loss):
            candidate = problem.found(problem.improved(geometry))
            best = candidate if best is None or candidate.loss < best.loss else best
    return best
