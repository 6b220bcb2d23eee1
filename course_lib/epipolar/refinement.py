"""The two-view geometry with the smallest Sampson errors: of all pairs, or of those that fit.

Pairs are homogeneous columns, both pictures in one scale (`common_scale`).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple, Protocol, Self, TypeVar

import numpy as np

from course_lib.checks import Array
from course_lib.transforms.rotations import skew

#: The matrices that multiply like cross products with the axes, shape (3, 3, 3). Without `skew`:
#: no function that an exercise asks for may be called while modules are loaded; it can be hidden.
AXES = np.array([np.cross(axis, np.eye(3)).T for axis in np.eye(3)])
#: How dense errors of wrong pairs are about zero, in units in which a picture is about 3 wide.
WRONG_DENSITY = 0.5
#: No measured pixel has a smaller error (in units in which a picture is about 3 wide).
LEAST_SIGMA = 1e-10
LAST_GAIN = 1e-5
MOST_DAMPING = 1e3


def _turn(vector: Array) -> Array:
    """Return a rotation, nearly by a small rotation vector: exactly by (1, w/2) as a quaternion."""
    x, y, z = (0.5 * vector).tolist()
    n = 1 / (1 + x * x + y * y + z * z)
    return np.asarray(
        n
        * np.array(
            [
                [1 + x * x - y * y - z * z, 2 * (x * y - z), 2 * (x * z + y)],
                [2 * (x * y + z), 1 - x * x + y * y - z * z, 2 * (y * z - x)],
                [2 * (x * z - y), 2 * (y * z + x), 1 - x * x - y * y + z * z],
            ]
        )
    )


class Geometry(Protocol):
    """Something that has a fundamental matrix, and can be moved."""

    @property
    def matrix(self) -> Array:
        """The fundamental matrix, shape (3, 3)."""

    @property
    def directions(self) -> Array:
        """Its derivatives by each unknown, shape (n, 3, 3)."""

    def moved(self, step: Array) -> Self:
        """Return the geometry after a step of all unknowns, shape (n,)."""


@dataclass(frozen=True, eq=False)
class RankTwo:
    """A matrix of rank 2, ``U diag(cos a, sin a, 0) Vᵀ``: seven unknowns, turns of U and V and a.

    References
    ----------
    A. Bartoli & P. Sturm, "Nonlinear estimation of the fundamental matrix with minimal
    parameters", IEEE PAMI 26 (2004).
    """

    U: Array
    angle: float
    Vt: Array

    @classmethod
    def near(cls, F: Array) -> RankTwo:
        """Return the geometry that is nearest to a matrix."""
        U, s, Vt = np.linalg.svd(F)
        return cls(U, float(np.arctan2(s[1], s[0])), Vt)

    @property
    def matrix(self) -> Array:
        """The fundamental matrix, shape (3, 3)."""
        return np.asarray(self.U[:, :2] * [np.cos(self.angle), np.sin(self.angle)] @ self.Vt[:2])

    @property
    def directions(self) -> Array:
        """Its derivatives by each unknown, shape (7, 3, 3)."""
        c, s = np.cos(self.angle), np.sin(self.angle)
        inner = np.empty((7, 3, 3))
        inner[:3], inner[3:6] = AXES * [c, s, 0], np.array([[c], [s], [0]]) * AXES
        inner[6] = np.diag([-s, c, 0])
        return np.asarray(self.U @ inner @ self.Vt)

    def moved(self, step: Array) -> RankTwo:
        """Return the geometry after a step of all unknowns, shape (7,)."""
        U = self.U @ _turn(step[:3])
        Vt = _turn(step[3:6]) @ self.Vt
        return RankTwo(U, self.angle + step[6], Vt)


@dataclass(frozen=True, eq=False)
class PosedPair:
    """Two calibrated cameras: five unknowns, the turn and the direction of the baseline.

    Its matrix is ``left [t]ₓ R right``, where `left` and `right` hold the intrinsics.
    """

    R: Array
    t: Array
    left: Array
    right: Array

    @property
    def matrix(self) -> Array:
        """The fundamental matrix, shape (3, 3)."""
        return np.asarray(self.left @ skew(self.t) @ self.R @ self.right)

    @property
    def directions(self) -> Array:
        """Its derivatives by each unknown, shape (5, 3, 3)."""
        turns = skew(self.t) @ AXES @ self.R
        shifts = np.tensordot(self._tangents, AXES, 1) @ self.R
        return np.asarray(self.left @ np.concatenate([turns, shifts]) @ self.right)

    @cached_property
    def _tangents(self) -> Array:
        """Two directions perpendicular to t and to each other, shape (2, 3)."""
        return np.asarray(np.linalg.svd(self.t[None])[2][1:])

    def moved(self, step: Array) -> PosedPair:
        """Return the geometry after a step of all unknowns, shape (5,)."""
        t = self.t + step[3:] @ self._tangents
        R = _turn(step[:3]) @ self.R
        return PosedPair(R, t / np.linalg.norm(t), self.left, self.right)


class Mixture(NamedTuple):
    """What errors look like: normal ones with σ, and a share of pairs that are wrong."""

    sigma: float
    right_share: float
    wrong_density: float

    def likelihood(self, errors: Array) -> tuple[Array, float]:
        """Return how likely each pair is a right one, and the logarithm of the likelihood."""
        scaled = errors / self.sigma
        right = np.exp(-0.5 * scaled * scaled) * (self.right_share / (2.5066282746 * self.sigma))
        both = right + (1 - self.right_share) * self.wrong_density
        both += 1e-300
        return right / both, float(np.log(both).sum())

    def updated(self, errors: Array, weights: Array, most_sigma: float) -> Mixture:
        """Return the mixture that the errors ask for."""
        total = float(weights.sum()) + 1e-12
        sigma = float(np.sqrt((weights * errors) @ errors / total))
        share = min(max(total / (len(errors) + 1), 0.01), 0.999)
        return Mixture(min(max(sigma, LEAST_SIGMA), most_sigma), share, self.wrong_density)


G = TypeVar("G", bound=Geometry)


def linearised(geometry: Geometry, x1: Array, x2: Array) -> tuple[Array, Array]:
    """Return the Sampson errors with their signs, (N,), and their derivatives, (n, N).

    With ``e = x2ᵀ F x1`` and D, the sum of the four squares, the error is ``e / √D``. F changes
    both.
    """
    F, directions = geometry.matrix, geometry.directions
    l2, l1 = F @ x1, F.T @ x2
    D = l2[0] * l2[0] + l2[1] * l2[1] + l1[0] * l1[0] + l1[1] * l1[1]
    by_root = 1 / np.sqrt(np.maximum(D, 1e-300))
    errors = (x2 * l2).sum(axis=0) * by_root
    pull = errors * by_root
    slopes = x2[:, None] * x1[None, :]  # the derivatives of e, (3, 3, N)
    slopes[:2] -= (pull * l2[:2])[:, None] * x1
    slopes[:, :2] -= (pull * l1[:2])[None] * x2[:, None]
    slopes *= by_root
    return errors, directions.reshape(-1, 9) @ slopes.reshape(9, -1)


def refined(geometry: G, x1: Array, x2: Array, steps: int = 50) -> G:
    """Return the geometry with the smallest sum of squares of the Sampson errors of all pairs."""
    return _climbed(geometry, x1, x2, None, 0.0, steps)[0]


def refined_robustly(
    geometry: G, x1: Array, x2: Array, threshold: float, steps: int = 50
) -> tuple[G, Mixture]:
    """Return the most likely geometry if errors are normal and some pairs are wrong.

    A right pair's error has a standard deviation that is estimated, at most half the threshold; a
    wrong one's could be anything. Each pair counts by how likely it is a right one.
    """
    start = Mixture(threshold / 3, 0.5, WRONG_DENSITY)
    geometry, mixture = _climbed(geometry, x1, x2, start, threshold / 2, steps)
    assert mixture is not None
    return geometry, mixture


def _climbed(
    geometry: G, x1: Array, x2: Array, mixture: Mixture | None, most_sigma: float, steps: int
) -> tuple[G, Mixture | None]:
    """Go where the likelihood is larger: damped Gauss–Newton steps, with the weights of each."""
    errors, slopes = linearised(geometry, x1, x2)
    weights, now = _weighed(errors, mixture)
    damping = 1e-6
    for _ in range(steps):
        if mixture is not None:
            mixture = mixture.updated(errors, weights, most_sigma)
            weights, now = mixture.likelihood(errors)
        step, promise = _step(errors, slopes, weights, damping)
        trial = geometry.moved(step)
        new = linearised(trial, x1, x2)
        new_weights, value = _weighed(new[0], mixture)
        if value >= now:
            geometry, (errors, slopes), weights, now = trial, new, new_weights, value
            damping /= 10
            if promise <= LAST_GAIN * (1 if mixture is None else mixture.sigma**2):
                break
        elif damping > MOST_DAMPING:
            break
        else:
            damping = max(10 * damping, 1e-3)
    return geometry, mixture


def _step(errors: Array, slopes: Array, weights: Any, damping: float) -> tuple[Array, float]:
    """Return a damped Gauss–Newton step, and by how much it should lower the sum of squares."""
    weighted = slopes * weights
    N, g = weighted @ slopes.T, weighted @ errors
    size = 1e-14 * np.trace(N) + 1e-300  # an unknown that changes nothing stays where it is
    N.flat[:: len(N) + 1] += damping * N.diagonal() + size
    step = -np.linalg.solve(N, g)
    return step, -float(step @ g)


def _weighed(errors: Array, mixture: Mixture | None) -> tuple[Any, float]:
    """Return the weights of all pairs, and what is to become large."""
    return (1.0, -float(errors @ errors)) if mixture is None else mixture.likelihood(errors)
