"""A last look for the relative pose that fits best, and for another one that fits nearly as well.

The search refines few hypotheses, so it may end on a lower summit than the highest. Where tie
points are few, near together or nearly on a plane, several summits are nearly as high, and the
highest need not be the right one. A pair whose rays meet behind a camera fits no pose.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from course_lib.checks import Array, DegenerateConfigurationError
from course_lib.epipolar.essential import pair_depths, pose_from_essential
from course_lib.epipolar.matrices import essential_from_pose
from course_lib.epipolar.refinement import PosedPair, linearised, refined_robustly
from course_lib.epipolar.search import Found, Problem, draw, samples_needed
from course_lib.homogeneous import to_homogeneous

#: Samples that are drawn of all pairs, at least and at most; so many, that one of pairs of a rival
#: with as many is among them with this probability. The least number of those that nearly fit.
SAMPLES, CONFIDENCE = (128, 1500), 0.95
#: How many hypotheses are refined, with how many steps; and how many of those once more.
FIRST, FIRST_STEPS = 12, 4
SECOND, SECOND_STEPS = 4, 10
#: So often is looked, at most: again if a better pose was found, or another one comes near to it.
LOOKS = 4
#: Matrices of length 1 with a larger product are alike: about 6 degrees between their directions.
ALIKE = 0.995
#: Degrees of the rotation and of the direction: poses that differ by less are the same, and with a
#: larger standard deviation a pose is uncertain.
SAME = 0.5, 1.0
#: A pose is a rival if so many pairs, more or less, could decide, or if so large a share of the
#: pairs that decide speak for it.
MARGIN, SPEAKING = 4.0, 1 / 3


class Pairs(NamedTuple):
    """Pairs for two calibrated cameras.

    Attributes
    ----------
    problem : Problem
        For the search.
    near1, near2 : ndarray, shape (N, 2)
        Normalised coordinates.
    far : float
        Where a partner is nearer to its place for a point at infinity, its depth has no sign.
    """

    problem: Problem[PosedPair]
    near1: Array
    near2: Array
    far: float


class Standing(NamedTuple):
    """A relative pose with points in front, which pairs fit it, and what each error costs."""

    found: Found[PosedPair]
    R: Array
    t: Array
    costs: Array

    @property
    def loss(self) -> float:
        """What all errors cost."""
        return float(self.costs.sum())


def standing(pairs: Pairs, found: Found[PosedPair]) -> Standing:
    """Return the one of the four poses of a geometry that has points in front.

    Raises
    ------
    DegenerateConfigurationError
        If the pairs that fit do not tell which.
    """
    E = essential_from_pose(found.geometry.R, found.geometry.t)
    R, t = pose_from_essential(E, pairs.near1[found.fits], pairs.near2[found.fits])
    Z1, Z2 = pair_depths(R, t, pairs.near1, pairs.near2)
    at_infinity = to_homogeneous(pairs.near1) @ R.T
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        moved = np.linalg.norm(at_infinity[:, :2] / at_infinity[:, 2:] - pairs.near2, axis=1)
    behind = ((Z1 < 0) | (Z2 < 0)) & ~(moved < pairs.far)
    return Standing(found, R, t, np.where(behind, 1.0, found.costs))


def last_look(pairs: Pairs, best: Found[PosedPair]) -> tuple[Standing, Standing | None]:
    """Return the best pose near any of many hypotheses, and its rival, if there is one.

    The samples are always the same: a caller's generator is left alone.
    """
    rng = np.random.default_rng(0)
    found = [standing(pairs, best)]
    rival = None
    for _ in range(LOOKS):
        before = found[0].loss
        found += _summits(pairs, found[0].found, rng)
        found.sort(key=lambda one: one.loss)
        rival = _rival(found)
        if rival is None and found[0].loss > before - MARGIN:
            break
    problem, geometry = pairs.problem, found[0].found.geometry
    geometry, _ = refined_robustly(geometry, problem.x1, problem.x2, problem.threshold)
    return standing(pairs, problem.found(geometry)), rival


def _rival(found: list[Standing]) -> Standing | None:
    """Return the pose farthest from the first, of those between which few pairs decide."""
    best, rivals = found[0], []
    for one in found[1:]:
        turn, direction = degrees_between((best.R, best.t), (one.R, one.t))
        gains = best.costs - one.costs
        for_it, against = gains.clip(0).sum(), -gains.clip(None, 0).sum()
        close = against - for_it < MARGIN or for_it > SPEAKING * (for_it + against)
        if close and (turn > SAME[0] or direction > SAME[1]):
            rivals.append((turn + direction, one))
    return max(rivals, key=lambda pair: pair[0])[1] if rivals else None


def degrees_between(one: tuple[Array, Array], other: tuple[Array, Array]) -> tuple[float, float]:
    """Return the angle between two rotations, and that between two directions of length 1."""
    turn = np.linalg.norm(one[0] - other[0]) / np.sqrt(8)
    apart = np.linalg.norm(one[1] - other[1]) / 2
    halves = np.arcsin(np.minimum([turn, apart], 1.0))
    return float(np.degrees(2 * halves[0])), float(np.degrees(2 * halves[1]))


def _summits(pairs: Pairs, best: Found[PosedPair], rng: np.random.Generator) -> list[Standing]:
    """Return poses, each the best one near a hypothesis from new samples."""
    problem = pairs.problem
    needed = samples_needed(CONFIDENCE, best.fits.mean() ** problem.size)
    count = round(min(max(needed, SAMPLES[0]), SAMPLES[1]))
    everyone, near = np.arange(problem.x1.shape[1]), np.flatnonzero(best.near)
    pools = draw(rng, everyone, problem.size, count), draw(rng, near, problem.size, SAMPLES[0])
    samples = np.concatenate(pools)
    hypotheses = problem.hypotheses(samples, 0)
    order = np.argsort(problem.losses(hypotheses, slice(None)))
    first = _refined(pairs, hypotheses[order], FIRST, FIRST_STEPS)
    if not first:
        return []
    matrices = np.array([one.found.geometry.matrix for one in first])
    return _refined(pairs, matrices, SECOND, SECOND_STEPS)


def _refined(pairs: Pairs, matrices: Array, count: int, steps: int) -> list[Standing]:
    """Return the first few geometries that are not alike after some steps, the best one first."""
    problem, kept = pairs.problem, []
    for F in _unlike(matrices, count):
        start = problem.geometry(F)
        assert start is not None
        args = problem.x1, problem.x2, problem.threshold, steps
        try:
            kept.append(standing(pairs, problem.found(refined_robustly(start, *args)[0])))
        except DegenerateConfigurationError:
            continue  # as many points before as behind: no pose of a camera
    return sorted(kept, key=lambda one: one.loss)


def _unlike(matrices: Array, count: int) -> Array:
    """Return the first few matrices that are not alike."""
    rows = matrices.reshape(-1, 9)
    rows = rows / np.linalg.norm(rows, axis=1, keepdims=True)
    which: list[int] = []
    for i, row in enumerate(rows):
        if len(which) < count and np.abs(rows[which] @ row).max(initial=0.0) < ALIKE:
            which.append(i)
    return matrices[which]


def pose_sigma(pairs: Pairs, best: Standing) -> tuple[float, float]:
    """Return the standard deviations of a pose, judged by the errors of the pairs that fit.

    Returns
    -------
    turn, direction : float
        Of the rotation, and of the direction of the baseline, degrees: the root of the sum of the
        variances about their axes; at most 180, and 180 if no more pairs fit than a sample has.
    """
    fits, geometry = best.found.fits, best.found.geometry
    pose = PosedPair(best.R, best.t, geometry.left, geometry.right)
    errors, slopes = linearised(pose, pairs.problem.x1[:, fits], pairs.problem.x2[:, fits])
    left_over = int(fits.sum()) - len(slopes)
    if left_over <= 0:
        return 180.0, 180.0  # as many pairs as unknowns: no errors are left to judge by
    N = slopes @ slopes.T
    N.flat[:: len(N) + 1] += 1e-14 * np.trace(N) + 1e-300
    C = (errors @ errors) / left_over * np.linalg.inv(N)
    turn, direction = np.sqrt([np.trace(C[:3, :3]), np.trace(C[3:, 3:])])
    return min(float(np.degrees(turn)), 180.0), min(float(np.degrees(direction)), 180.0)


def doubt_about(
    best: Standing, rival: Standing | None, sigma: tuple[float, float], flat: bool
) -> str:
    """Return why a pose may be wrong, and what to do; nothing if nothing says so."""
    reasons = []
    if rival is not None:
        turn, direction = degrees_between((best.R, best.t), (rival.R, rival.t))
        reasons.append(
            f"another pose fits nearly as well ({rival.found.fits.sum()} pairs, this one "
            f"{best.found.fits.sum()}), turned by {turn:.1f} degrees, its baseline by "
            f"{direction:.1f}"
        )
    if flat:
        reasons.append("the points are nearly on a plane, which two poses may fit")
    if sigma[0] > SAME[0] or sigma[1] > SAME[1]:
        reasons.append(
            f"the rotation is only known to {sigma[0]:.1f} degrees, the direction of the baseline "
            f"to {sigma[1]:.1f}"
        )
    advice = ["take more tie points, spread over the picture and in depth"]
    return "; ".join(reasons + advice) if reasons else ""
