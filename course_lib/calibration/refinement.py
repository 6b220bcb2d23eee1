"""The minimum of the reprojection error, by Levenberg–Marquardt with the poses eliminated.

A pose only acts on its own view, so the normal equations have the shape of an arrow: one small
block for each view, and one for the camera that all of them touch,

    | U_i      W_i | | pose_i |     | g_i |
    | W_iᵀ     V   | | camera | = - | g_c |

Solving the blocks for their poses leaves ``(V - Σ W_iᵀ U_i⁻¹ W_i) camera = …``, a system as small
as the camera, whatever the number of views. Use these functions through `course_lib.calibration`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Protocol, Self, TypeVar

import numpy as np

from course_lib.calibration.derivatives import derivative_blocks
from course_lib.calibration.model import State
from course_lib.calibration.views import Views
from course_lib.checks import SMALLEST, Array, DegenerateConfigurationError

#: A step that promises to lower the sum of squares by less, relative to itself, is the last one.
LAST_GAIN = 1e-11
STEPS = 300
FIRST_DAMPING = 1e-6
#: With more damping a step is too short to change anything.
TOO_STIFF = 1e12
#: Residuals of so many px are rounding.
ROUNDING = 1e-11


@dataclass(frozen=True, eq=False)
class Normals:
    """The normal equations of all views, in their blocks, and the sum of squared residuals.

    Attributes
    ----------
    V, g_c : ndarray, shape (n, n) and (n,)
        Block and gradient of the camera's free numbers.
    U, g_p : ndarray, shape (v, 6, 6) and (v, 6)
        Blocks and gradients of the poses.
    W : ndarray, shape (v, 6, n)
        What ties them together.
    cost : float
        Sum of squared residuals, px²; infinite where a point is not before the camera.
    """

    V: Array
    g_c: Array
    U: Array
    g_p: Array
    W: Array
    cost: float

    def solve(self, damping: float) -> tuple[Array, Array]:
        """Return the steps of the camera and of the poses, by Marquardt's damped equations."""
        U = self.U + damping * self.U * np.eye(6)
        solved = np.linalg.solve(U, np.concatenate([self.W, self.g_p[..., None]], axis=2))
        by_camera, alone = solved[..., :-1], solved[..., -1]  # U⁻¹ W and U⁻¹ g
        V = self.V + damping * np.diag(np.diag(self.V)) - _summed(self.W, by_camera)
        camera = np.linalg.solve(V, _summed(self.W, alone[..., None])[:, 0] - self.g_c)
        return np.asarray(camera), np.asarray(-alone - by_camera @ camera)

    @cached_property
    def inverse_blocks(self) -> tuple[Array, Array]:
        """The inverse's block of the camera, (n, n), and its diagonal of the poses, (v, 6).

        The camera's is the inverse of what is left of V after the poses are eliminated, S⁻¹; a
        pose's is ``U⁻¹ + U⁻¹ W S⁻¹ Wᵀ U⁻¹``: its own uncertainty, and what the camera's adds.
        """
        inverse = np.linalg.inv(self.U)
        ties = inverse @ self.W
        camera = _inverse(self.V - _summed(self.W, ties))
        poses = np.einsum("vii->vi", inverse) + np.einsum("vij,jk,vik->vi", ties, camera, ties)
        return camera, poses


def _inverse(N: Array) -> Array:
    """Return the inverse of a symmetric matrix; what rounding leaves open is very uncertain."""
    scale = np.sqrt(np.diag(N).clip(SMALLEST))
    sizes, directions = np.linalg.eigh(N / np.outer(scale, scale))
    directions = directions / scale[:, None]
    return np.asarray(directions / sizes.clip(np.finfo(float).eps) @ directions.T)


def _summed(left: Array, right: Array) -> Array:
    """Return ``Σ left_iᵀ right_i``: one product, with the views below each other."""
    rows = left.shape[0] * left.shape[1]
    return np.asarray(left.reshape(rows, left.shape[2]).T @ right.reshape(rows, right.shape[2]))


def arrow(products: Array) -> Normals:
    """Return normal equations from their products, (v, n + 7, n + 7): camera, pose, residual."""
    shared, n = products.sum(axis=0), products.shape[1] - 7
    cost = float(shared[-1, -1])
    return Normals(
        V=shared[:n, :n],
        g_c=shared[:n, -1],
        U=products[:, n:-1, n:-1],
        g_p=products[:, n:-1, -1],
        W=products[:, n:-1, :n],
        cost=cost if np.isfinite(cost) else np.inf,
    )


def view_products(state: State, views: Views) -> Array:
    """Return all products of derivatives and residuals, summed over each view's points."""
    products = []
    for block in derivative_blocks(state, views):
        rows = block.reshape(*block.shape[:2], -1)
        products.append(rows @ rows.transpose(0, 2, 1))
    return np.concatenate(products)


def minimised(state: State, views: Views, last_gain: float = LAST_GAIN) -> tuple[State, Normals]:
    """Return the state of one camera with the smallest reprojection error, as `refined`."""
    return refined(state, partial(view_products, views=views), views.observations, last_gain)


class Movable(Protocol):
    """A camera or several, and the poses of a board: something that can take a step."""

    @property
    def is_camera(self) -> bool:
        """Whether the numbers are those of a camera; a step can lead too far."""

    def moved(self, camera_step: Array, pose_steps: Array) -> Self:
        """Return what it is after a step."""


S = TypeVar("S", bound=Movable)


def refined(
    start: S,
    products: Callable[[S], Array],
    observations: int,
    last_gain: float = LAST_GAIN,
) -> tuple[S, Normals]:
    """Return the state with the smallest sum of squared residuals near a start.

    Parameters
    ----------
    start : State, or another that can be moved
        Camera and poses to begin with; every point before the camera.
    products : callable
        Takes a state; returns the products that `arrow` takes.
    observations : int
        How many residuals there are.
    last_gain : float
        A step that promises to lower the sum of squares by less, relative to itself, is the last.

    Returns
    -------
    state, Normals
        The minimum, and the normal equations before the last step, which was that small.

    Raises
    ------
    DegenerateConfigurationError
        If the equations are singular.

    References
    ----------
    D. Marquardt, "An algorithm for least-squares estimation of nonlinear parameters" (1963); B.
    Triggs et al., "Bundle adjustment: a modern synthesis" (2000), section 6.1 (Schur complement).
    """
    state, normals, damping = start, arrow(products(start)), FIRST_DAMPING
    for _ in range(STEPS):
        if normals.cost <= observations * ROUNDING**2 or damping > TOO_STIFF:
            break
        camera_step, pose_steps = _solved(normals, damping)
        trial = state.moved(camera_step, pose_steps)
        gain = -(normals.g_c @ camera_step + (normals.g_p * pose_steps).sum())
        if gain <= last_gain * normals.cost and damping <= 1:
            return trial, normals
        ahead = arrow(products(trial)) if trial.is_camera else None
        kept = (normals.cost - ahead.cost) / gain if ahead else -np.inf
        damping *= 0.1 if kept > 0.7 else 1 if kept > 0.3 else 10
        if ahead and kept > 0:
            state, normals = trial, ahead
    return state, normals


def _solved(normals: Normals, damping: float) -> tuple[Array, Array]:
    try:
        return normals.solve(damping)
    except np.linalg.LinAlgError as error:
        raise DegenerateConfigurationError(
            "the views do not determine the camera: tilt the board in different directions, and "
            "leave fewer numbers free"
        ) from error
