"""Self-calibration: what is wrong with the lens, told by the block itself.

A measured pixel p is corrected, as photogrammetry does it, by a sum of known fields b times unknown
numbers a that all cameras share, ``p + Σ a_k b_k(p)``. So the residuals are linear in a. With the
block adjusted for some a, its own unknowns are eliminated: what a field looks like after cameras
and points have swallowed all of it that they can, ``b + J δ`` with ``δ = -(JᵀJ)⁻¹ Jᵀ b``, gives the
normal equations of a alone (variable projection).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from course_lib.bundle.adjustment import BundleAdjustment, Survey, bundle_adjust
from course_lib.bundle.block import Block, Observations
from course_lib.bundle.control import Control
from course_lib.bundle.derivatives import Position
from course_lib.bundle.gauge import free_numbers
from course_lib.bundle.normals import normal_equations
from course_lib.bundle.structure import Structure
from course_lib.checks import Array, DegenerateConfigurationError

Lens = Literal["f", "c", "k1", "k2"]
#: The numbers that each name stands for.
NUMBERS = {"f": ("f",), "c": ("cx", "cy"), "k1": ("k1",), "k2": ("k2",)}
#: Below this share, what is left of a field is nothing that pixels could show.
LEAST = 1e-9
#: A step of the lens that moves no pixel by more is the last, px.
SETTLED = 1e-5


@dataclass(frozen=True, eq=False)
class SelfCalibration:
    """A block adjusted together with the lens that its cameras share.

    Attributes
    ----------
    adjustment : BundleAdjustment
        The block, with the intrinsics of the start, and `observations`.
    observations : Observations
        The corrected pixels.
    K : ndarray, shape (v, 3, 3)
        Intrinsics of each camera with the focal length and principal point that were found, px.
    corrections : dict of str to float
        What was found: ``f`` is the share by which pixels move away from the principal point,
        ``cx`` and ``cy`` are moves in px; ``k1`` and ``k2`` move a pixel at the normalised distance
        r by ``r (k1 r² + k2 r⁴)``, from where it was seen to where it belongs.
    sigma : dict of str to float
        Standard deviation of each, judged by the residuals.
    """

    adjustment: BundleAdjustment
    observations: Observations
    K: Array
    corrections: dict[str, float]
    sigma: dict[str, float]


def self_calibrate(
    start: Block,
    observations: Observations,
    control: Control | None = None,
    free: Sequence[Lens] = ("k1",),
    robust: float | None = None,
    steps: int = 20,
) -> SelfCalibration:
    """Return the cameras, the points and the lens that fit all observations best.

    Parameters
    ----------
    start : Block
        Where cameras and points are, roughly, and the intrinsics to begin with.
    observations : Observations
        What was seen, freed from the distortion that is known.
    control : Control, optional
        Surveyed points.
    free : sequence of "f", "c", "k1", "k2"
        What of the lens is unknown, the same for all cameras: focal length, principal point,
        radial distortion.
    robust : float, optional
        As in `bundle_adjust`.
    steps : int
        How many steps are made at most.

    Returns
    -------
    SelfCalibration
        Block, lens and how well the lens is known.

    Raises
    ------
    ValueError
        If `free` is empty or names something else, or as `bundle_adjust`.
    DegenerateConfigurationError
        As `bundle_adjust`, or if the pictures cannot tell a part of the lens: all look straight
        down at flat ground, say, and the focal length is free.

    References
    ----------
    D. C. Brown, "The bundle adjustment: progress and prospects" (1976); G. H. Golub, V. Pereyra,
    SIAM J. Numer. Anal. 10 (1973), for the elimination.
    """
    names = _names(free)
    a, block = np.zeros(len(names)), start
    for _ in range(steps):
        seen = _corrected(start, observations, names, a)
        fit = bundle_adjust(block, seen, control, "inner", robust)
        inverse, step = _lens_step(fit, start, observations, control, names)
        if np.abs(_fields(start, observations, names) @ step).max() <= SETTLED:
            break
        a, block = a + step, fit.block
    if fit.redundancy <= len(names):
        raise DegenerateConfigurationError(
            "as many unknowns as measured numbers: nothing is left to judge the lens by; measure "
            "more, or free less of it"
        )
    spread = fit.cost / (fit.redundancy - len(names))
    sigma = np.sqrt(spread * np.diag(inverse)).tolist()
    found = dict(zip(names, a.tolist(), strict=True))
    K = _intrinsics(start.K, found)
    return SelfCalibration(fit, seen, K, found, dict(zip(names, sigma, strict=True)))


def _names(free: Sequence[Lens]) -> list[str]:
    if not free or isinstance(free, str) or not set(free) <= set(NUMBERS):
        raise ValueError(
            f'free must list some of {", ".join(NUMBERS)}, as in ("k1",), got {free!r}'
        )
    return [number for name in NUMBERS if name in free for number in NUMBERS[name]]


def _fields(block: Block, seen: Observations, names: Sequence[str]) -> Array:
    """Return by how much each number moves each pixel, px, shape (m, 2, k)."""
    K = block.K[seen.cameras]
    away = seen.pixels - K[:, :2, 2]
    r2 = ((away / K[:, [0, 1], [0, 1]]) ** 2).sum(axis=1)[:, None]
    one = np.ones(len(seen))
    fields = {
        "f": away,
        "cx": np.stack([one, 0 * one], axis=1),
        "cy": np.stack([0 * one, one], axis=1),
        "k1": away * r2,
        "k2": away * r2**2,
    }
    return np.stack([fields[name] for name in names], axis=2)


def _corrected(block: Block, seen: Observations, names: Sequence[str], a: Array) -> Observations:
    return replace(seen, pixels=seen.pixels + _fields(block, seen, names) @ a)


def _lens_step(
    fit: BundleAdjustment,
    start: Block,
    seen: Observations,
    control: Control | None,
    names: Sequence[str],
) -> tuple[Array, Array]:
    """Return the inverse of the normal equations of the lens alone, and the step that they give."""
    structure = Structure.of(seen, len(start.R), len(start.points))
    survey, position = Survey.of(control, start.points), Position.of(fit.block)
    scale = np.sqrt(fit.weights[structure.order])
    weight = scale / np.asarray(structure.seen.sigma)
    turns, moves = position.image(structure.seen).derivatives(scale)
    fields = _fields(start, structure.seen, names).transpose(2, 1, 0) * weight  # (k, 2, m)
    free, nothing = free_numbers(position, control is None), np.zeros_like(position.X)
    left = np.empty_like(fields)
    for k, field in enumerate(fields):
        seen_as = turns, moves, field
        normals = normal_equations(seen_as, structure, survey.held, survey.weights, nothing)
        cameras, points = normals.eliminated(structure).solve(structure, free)
        turn, move = cameras[structure.seen.cameras].T.reshape(2, 3, -1)
        shift = points[structure.seen.points].T - move
        left[k] = field + (turns * turn).sum(axis=1) + (moves * shift).sum(axis=1)
    N = np.einsum("ikm,jkm->ij", fields, left)
    _check_told(N, (fields**2).sum(axis=(1, 2)), names)
    inverse = np.linalg.inv(N)
    residuals = (fit.residuals[structure.order] * weight[:, None]).T
    return inverse, inverse @ np.einsum("ikm,km->i", fields, residuals)


def _check_told(N: Array, whole: Array, names: Sequence[str]) -> None:
    """Raise if cameras and points can swallow a field, or a sum of fields, as a whole."""
    size = np.sqrt(whole)
    shares, ways = np.linalg.eigh(N / np.outer(size, size))
    if shares[0] < LEAST:
        hidden = [name for name, part in zip(names, ways[:, 0], strict=True) if abs(part) > 0.1]
        raise DegenerateConfigurationError(
            f"the pictures cannot tell {' and '.join(hidden)}: cameras and points that move change "
            "them just as well; hold it, add oblique pictures or ground of different heights, or "
            "control points"
        )


def _intrinsics(K: Array, found: dict[str, float]) -> Array:
    """Return the intrinsics that see uncorrected pixels, but for their distortion."""
    K = K.copy()
    grown = 1 + found.get("f", 0.0)
    K[:, :2, 2] -= np.array([found.get("cx", 0.0), found.get("cy", 0.0)]) / grown
    K[:, :2, :2] /= grown
    return K
