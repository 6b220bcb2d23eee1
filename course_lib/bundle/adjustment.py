"""The adjustment itself: Levenberg–Marquardt steps until nothing gets better."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np

from course_lib.bundle.block import Block, Indices, Observations
from course_lib.bundle.connections import check_block
from course_lib.bundle.control import Control
from course_lib.bundle.covariance import Precision, precision
from course_lib.bundle.derivatives import Image, Position
from course_lib.bundle.gauge import free_numbers, laid_over
from course_lib.bundle.normals import Normals, normal_equations
from course_lib.bundle.structure import Structure
from course_lib.checks import Array, DegenerateConfigurationError, check_length

Gauge = Literal["inner", "fixed"]
FIRST_DAMPING, LEAST_DAMPING = 1e-4, 1e-10
#: A step that gains less, as a share of the cost, is near the minimum.
NEAR = 0.005
#: With more damping a step is too short to change anything.
TOO_STIFF = 1e12
#: Residuals of so many standard deviations are rounding.
ROUNDING = 1e-10


class Survey(NamedTuple):
    """Control points, spread over all points of a block: ``1/σ²``, held or not, and places."""

    weights: Array
    held: Array
    places: Array

    @classmethod
    def of(cls, control: Control | None, points: Array) -> Survey:
        """Return what is known of each point of a block, shape (n, 3) each."""
        weights, held, places = np.zeros_like(points), np.zeros_like(points), points.copy()
        if control is not None:
            weights[control.points], held[control.points] = control.weights, control.held
            places[control.points] = control.coordinates
        return cls(weights, held, places)


@dataclass(frozen=True, eq=False)
class BundleAdjustment:
    """An adjusted block, and how well it is known.

    Attributes
    ----------
    block : Block
        Cameras and points.
    residuals : ndarray, shape (m, 2)
        Where the block puts each observation, minus what was measured, px.
    weights : ndarray, shape (m,)
        How much each observation counted at the end: 1 unless a robust adjustment doubts it.
    control_residuals : ndarray, shape (k, 3)
        Adjusted minus surveyed control points.
    costs : tuple of float
        What was made smallest, before and after each step: the sum of squared residuals by their
        standard deviations; larger residuals than `robust` count as Huber has it.
    redundancy : int
        Measured numbers minus unknowns that they determine.
    converged : bool
        Whether it came to rest; else the steps ran out.
    """

    block: Block
    residuals: Array
    weights: Array
    control_residuals: Array
    costs: tuple[float, ...]
    redundancy: int
    converged: bool
    _parts: tuple[Position, Structure, Survey, Array, Gauge | None]

    @property
    def cost(self) -> float:
        """What was made smallest."""
        return self.costs[-1]

    @property
    def sigma0(self) -> float:
        """By how much all standard deviations were too small: the root of cost by redundancy."""
        if self.redundancy < 1:
            raise DegenerateConfigurationError(
                "as many unknowns as measured numbers: they fit exactly, and nothing is left to "
                "judge them by; measure more"
            )
        return float(np.sqrt(self.cost / self.redundancy))

    @property
    def rms(self) -> float:
        """Root mean square of the lengths of the residuals, px."""
        return float(np.sqrt((self.residuals**2).sum(axis=1).mean()))

    @cached_property
    def precision(self) -> Precision:
        """The covariances of cameras and points, scaled by `sigma0`."""
        position, structure, survey, weights, gauge = self._parts
        gap = position.X - survey.places
        seen = position.image(structure.seen).weighted(np.sqrt(weights))
        normals = normal_equations(seen, structure, survey.held, survey.weights, gap)
        free = free_numbers(position, gauge is not None)
        found = precision(normals, position, structure, free, gauge == "inner", self.sigma0**2)
        free_coordinates = 1 - survey.held
        known = found.points * free_coordinates[:, None] * free_coordinates[:, :, None]
        return Precision(found.cameras, known)


def bundle_adjust(
    start: Block,
    observations: Observations,
    control: Control | None = None,
    gauge: Gauge = "inner",
    robust: float | None = None,
    steps: int = 100,
    tolerance: float = 1e-10,
) -> BundleAdjustment:
    """Return the cameras and points that fit all observations best.

    Parameters
    ----------
    start : Block
        Where cameras and points are, roughly; every observed point before its camera.
    observations : Observations
        What was seen.
    control : Control, optional
        Surveyed points; three or more. They fix where in the world the block is.
    gauge : "inner" or "fixed"
        What fixes it without control points. "inner" lays the adjusted points over those of the
        start as well as they fit, and spreads the uncertainty evenly; "fixed" holds the first
        camera, and one coordinate of the camera that is furthest from it.
    robust : float, optional
        From how many standard deviations on a residual (its length) counts less, as Huber has it;
        2.5 is usual.
    steps : int
        How many steps are tried at most.
    tolerance : float
        It ends when a step promises to lower the cost by less than this share.

    Returns
    -------
    BundleAdjustment
        Block, residuals, and on demand the covariances.

    Raises
    ------
    ValueError, DegenerateConfigurationError
        As `check_block`; or if the rays of a point are parallel, or the equations are singular.

    References
    ----------
    B. Triggs et al., "Bundle adjustment: a modern synthesis" (2000); Hartley & Zisserman, Multiple
    View Geometry, 2nd ed., appendix A6.3; P. J. Huber, "Robust estimation of a location parameter"
    (1964).
    """
    if gauge not in ("inner", "fixed"):
        raise ValueError(f'gauge must be "inner" or "fixed", got {gauge!r}')
    check_block(start, observations, control)
    limit = np.inf if robust is None else check_length(robust, "robust")
    structure = Structure.of(observations, len(start.R), len(start.points))
    survey, position = Survey.of(control, start.points), Position.of(start)
    position = Position(
        position.K, position.R, position.C, np.where(survey.held, survey.places, position.X)
    )
    loose = None if control is not None else gauge
    search = _Search(structure, survey, limit, free_numbers(position, loose == "fixed"))
    position, costs, converged = search.run(position, steps, tolerance)
    if loose == "inner":
        position = laid_over(position, start.points)
    return _adjusted(position, search, control, loose, (costs, converged))


def _adjusted(
    position: Position,
    search: _Search,
    control: Control | None,
    gauge: Gauge | None,
    ended: tuple[tuple[float, ...], bool],
) -> BundleAdjustment:
    structure = search.structure
    own = position.image(structure.seen).residuals
    weights = search.scale(own) ** 2
    residuals, sorted_weights = np.empty((len(structure.seen), 2)), np.empty(len(structure.seen))
    residuals[structure.order] = (own * structure.seen.sigma).T
    sorted_weights[structure.order] = weights
    surveyed = int((search.survey.weights > 0).sum())
    unknowns = 6 * structure.cameras + int((search.survey.held == 0).sum())
    measured = 2 * len(structure.seen) + surveyed + (7 if gauge else 0)
    gaps = np.zeros((0, 3)) if control is None else position.X[control.points] - control.coordinates
    parts = position, structure, search.survey, weights, gauge
    return BundleAdjustment(
        position.block,
        residuals,
        sorted_weights,
        gaps,
        ended[0],
        measured - unknowns,
        ended[1],
        parts,
    )


class _Search(NamedTuple):
    """What stays the same while the search for the smallest cost goes on."""

    structure: Structure
    survey: Survey
    limit: float
    free: Indices

    def scale(self, residuals: Array) -> Array:
        """Return the roots of the robust weights of residuals, (2, m)."""
        if np.isinf(self.limit):
            return np.ones(residuals.shape[1])
        sizes = np.sqrt((residuals**2).sum(axis=0))
        return np.asarray(np.sqrt(self.limit / np.maximum(sizes, self.limit)))

    def cost(self, residuals: Array, position: Position) -> float:
        """Return the cost; infinite where a point is not before its camera."""
        squares = (residuals**2).sum(axis=0)
        if not np.isinf(self.limit):
            far = 2 * self.limit * np.sqrt(squares) - self.limit**2
            squares = np.where(squares > self.limit**2, far, squares)
        gap = position.X - self.survey.places
        cost = float(squares.sum() + (self.survey.weights * gap * gap).sum())
        return cost if np.isfinite(cost) else np.inf

    def normals(self, position: Position, image: Image, bent: bool = False) -> Normals:
        """Return the normal equations at a position; bent as in `Image.weighted`."""
        survey, gap = self.survey, position.X - self.survey.places
        seen = image.weighted(self.scale(image.residuals), bent)
        return normal_equations(seen, self.structure, survey.held, survey.weights, gap)

    def run(
        self, position: Position, steps: int, tolerance: float
    ) -> tuple[Position, tuple[float, ...], bool]:
        """Return where the cost is smallest, the costs on the way, and whether it came to rest."""
        image = position.image(self.structure.seen)
        costs, damping = [self.cost(image.residuals, position)], FIRST_DAMPING
        normals = self.normals(position, image)
        nothing = image.residuals.size * ROUNDING**2
        for _ in range(steps):
            cameras, points = self.step(normals, damping)
            gain = -float((normals.g_c * cameras).sum() + (normals.g_p.T * points).sum())
            trial = position.moved(cameras, points)
            image = trial.image(self.structure.seen)
            cost = self.cost(image.residuals, trial)
            settled = gain <= tolerance * costs[-1] or costs[-1] <= nothing
            kept = (costs[-1] - cost) / gain if gain > 0 else -np.inf
            if cost <= costs[-1]:
                position, costs = trial, [*costs, cost]
            if (settled and damping <= 1) or damping > TOO_STIFF:
                return position, tuple(costs), settled
            damping = max(damping * (0.1 if kept > 0.7 else 1 if kept > 0.3 else 10), LEAST_DAMPING)
            if kept > 0:
                # Far away, curvature misleads; near the minimum it saves many steps.
                bent = costs[-2] - costs[-1] < NEAR * costs[-2]
                normals = self.normals(position, image, bent)
        return position, tuple(costs), False

    def step(self, normals: Normals, damping: float) -> tuple[Array, Array]:
        """Return damped steps of cameras and points."""
        try:
            return normals.eliminated(self.structure, damping).solve(self.structure, self.free)
        except np.linalg.LinAlgError as error:
            raise DegenerateConfigurationError(
                "the equations of the cameras are singular: a camera's points lie on one line, or "
                "too few tie it to the others; add tie points, well spread over its picture"
            ) from error
