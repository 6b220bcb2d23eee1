"""A block that grows camera by camera around a vase, with and without adjustment."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from course_lib.bundle import Block, Observations, bundle_adjust
from course_lib.bundle.block import Indices
from course_lib.drawing.diagrams import Floats
from course_lib.epipolar import ransac_pose
from course_lib.orientation import resect_camera
from course_lib.triangulation import refine_point, triangulate_linear
from data_generators.blocks import KnownBlock, turntable

#: Pictures all around the vase, 15 degrees apart.
PICTURES = 24
#: Whether all is adjusted after each camera.
WAYS = {"only chained": False, "adjusted each time": True}


@dataclass(frozen=True, eq=False)
class Stage:
    """A block after one more camera.

    Attributes
    ----------
    block : Block
        Cameras in the order they came, and all points; a point that is not known yet is NaN in
        `points`, and at the origin in the block.
    points : ndarray, shape (n, 3)
        The points, NaN where not known yet.
    seen, added : int
        Known points that the new camera saw, and points that it added.
    before, after : float
        RMS of the reprojection error before and after the adjustment, px; the same without one.
    adjusted : bool
        Whether there was an adjustment.
    """

    block: Block
    points: Floats
    seen: int
    added: int
    before: float
    after: float
    adjusted: bool = False


@cache
def vase() -> KnownBlock:
    """Return the pictures of the vase: 24 cameras on a circle of 1 m, 200 points, 0.5 px."""
    return turntable(np.random.default_rng(1), PICTURES, points=200, noise=0.5)


def unrolled(seen: Observations, pictures: int) -> Observations:
    """Return a circle of pictures as a chain, with the first picture once more at its end.

    A point that goes out of sight and comes again counts as a new one: nobody recognises it.

    Parameters
    ----------
    seen : Observations
        Of the circle.
    pictures : int
        How many pictures the circle has.

    Returns
    -------
    Observations
        Of ``pictures + 1`` cameras, points seen by two or more of them.
    """
    first = seen.cameras == 0
    cameras = np.concatenate([seen.cameras, np.full(first.sum(), pictures)])
    points = np.concatenate([seen.points, seen.points[first]])
    pixels = np.concatenate([seen.pixels, seen.pixels[first]])
    table = np.zeros((points.max() + 1, pictures + 1), dtype=bool)
    table[points, cameras] = True
    begins = table & ~np.pad(table, ((0, 0), (1, 0)))[:, :-1]
    visit = begins.cumsum(axis=1)[points, cameras]
    return _renumbered(cameras, visit * (points.max() + 1) + points, pixels, seen.sigma)


def _renumbered(
    cameras: Indices, names: Indices, pixels: Floats, sigma: Floats | float
) -> Observations:
    """Return observations of the points that two or more cameras see, numbered from 0."""
    _, numbers, counts = np.unique(names, return_inverse=True, return_counts=True)
    keep = counts[numbers] > 1
    _, numbers = np.unique(numbers[keep], return_inverse=True)
    return Observations(cameras[keep], numbers, pixels[keep], np.asarray(sigma).flat[0])


@cache
def grown(way: str) -> tuple[Stage, ...]:
    """Return the block of the vase after two cameras, after three, and so on.

    Parameters
    ----------
    way : str
        A key of `WAYS`.

    Returns
    -------
    tuple of Stage
        The first camera and the first base (its length was measured) are the true ones.
    """
    known, seen = vase(), chain()
    stages = [_pair(known, seen)]
    for _ in range(2, PICTURES + 1):
        stage = _next_camera(stages[-1], seen)
        stages.append(_adjusted(stage, seen) if WAYS[way] else stage)
    return tuple(stages)


@cache
def chain() -> Observations:
    """Return what the 25 pictures of the chain see: those of the vase, and the first once more."""
    return unrolled(vase().observations, PICTURES)


def observed(seen: Observations, camera: int) -> tuple[Indices, Floats]:
    """Return the numbers of the points that a camera sees, and their pixels."""
    mine = seen.cameras == camera
    return seen.points[mine], seen.pixels[mine]


def shared(seen: Observations, one: int, other: int) -> tuple[Indices, Floats]:
    """Return the points that two cameras share, and their pixels, shape (2, N, 2)."""
    points1, pixels1 = observed(seen, one)
    points2, pixels2 = observed(seen, other)
    both, i, j = np.intersect1d(points1, points2, return_indices=True)
    return both, np.array([pixels1[i], pixels2[j]])


def _pair(known: KnownBlock, seen: Observations) -> Stage:
    """Return the first two cameras, and the points that both see."""
    true = known.truth
    K, (_, pixels) = true.K[0], shared(seen, 0, 1)
    found = ransac_pose(pixels[0], pixels[1], K, K, rng=np.random.default_rng(0))
    base = np.linalg.norm(true.centres[1] - true.centres[0])
    t = found.R @ true.t[0] + base * found.t / np.linalg.norm(found.t)
    R = np.array([true.R[0], found.R @ true.R[0]])
    nothing = np.full((seen.points.max() + 1, 3), np.nan)
    block = Block(K, R, np.array([true.t[0], t]), np.zeros_like(nothing))
    return _with_new_points(Stage(block, nothing, 0, 0, 0.0, 0.0), seen)


def _next_camera(last: Stage, seen: Observations) -> Stage:
    """Return the block with the next camera: placed by known points, then it adds new ones."""
    numbers, pixels = observed(seen, len(last.block.R))
    known = np.isfinite(last.points[numbers, 0])
    found = resect_camera(last.points[numbers[known]], pixels[known], last.block.K[0])
    R, t = np.append(last.block.R, found.R[None], 0), np.append(last.block.t, found.t[None], 0)
    block = Block(last.block.K[0], R, t, last.block.points)
    stage = replace(last, block=block, seen=int(known.sum()))
    return _with_new_points(stage, seen)


def _with_new_points(stage: Stage, seen: Observations) -> Stage:
    """Return the block with the points that its last camera shares with the one before."""
    block, last = stage.block, len(stage.block.R) - 1
    both, pixels = shared(seen, last - 1, last)
    new = np.isnan(stage.points[both, 0])
    points = stage.points.copy()
    if new.any():
        P = block.K[-2:] @ np.concatenate([block.R[-2:], block.t[-2:, :, None]], axis=2)
        first = triangulate_linear(pixels[:, new], P)
        points[both[new]] = refine_point(first, pixels[:, new], P)
    block = block.moved_to(np.nan_to_num(points))
    rms = _rms(block, points, seen)
    grew = replace(stage, block=block, points=points, added=int(new.sum()))
    return replace(grew, before=rms, after=rms, adjusted=False)


def in_sight(stage: Stage, seen: Observations) -> Observations:
    """Return what the cameras of a stage observe of its points."""
    return seen.only(
        (seen.cameras < len(stage.block.R)) & np.isfinite(stage.points[seen.points, 0])
    )


def _rms(block: Block, points: Floats, seen: Observations) -> float:
    mine = in_sight(Stage(block, points, 0, 0, 0.0, 0.0), seen)
    left = block.project(mine.cameras, mine.points) - mine.pixels
    return float(np.sqrt((left**2).sum(axis=1).mean()))


def _adjusted(stage: Stage, seen: Observations) -> Stage:
    """Return the block with all cameras and points adjusted; the first camera and base stay."""
    mine = in_sight(stage, seen)
    known = np.flatnonzero(np.isfinite(stage.points[:, 0]))
    numbers = np.cumsum(np.isfinite(stage.points[:, 0])) - 1
    start = stage.block.moved_to(stage.points[known])
    mine = Observations(mine.cameras, numbers[mine.points], mine.pixels, mine.sigma)
    fit = bundle_adjust(start, mine, gauge="fixed")
    base = np.linalg.norm(np.diff(stage.block.centres[:2], axis=0))
    found = _scaled(fit.block, float(base))
    points = stage.points.copy()
    points[known] = found.points
    moved = found.moved_to(np.nan_to_num(points))
    return replace(stage, block=moved, points=points, after=fit.rms, adjusted=True)


def _scaled(block: Block, base: float) -> Block:
    """Return a block with the given length of its first base; the first centre stays."""
    C = block.centres
    factor = base / np.linalg.norm(C[1] - C[0])
    C, X = C[0] + factor * (C - C[0]), C[0] + factor * (block.points - C[0])
    return Block(block.K, block.R, -np.einsum("vij,vj->vi", block.R, C), X)


def true_centres(count: int) -> Floats:
    """Return where the first cameras of the chain truly were, shape (count, 3), m."""
    return np.asarray(vase().truth.centres[np.arange(count) % PICTURES])


def drift(stage: Stage) -> Floats:
    """Return how far each camera is from where it truly was, shape (v,), m."""
    apart = stage.block.centres - true_centres(len(stage.block.R))
    return np.asarray(np.linalg.norm(apart, axis=1))
