"""Levenberg–Marquardt: least squares when the unknowns do not enter linearly.

Near a guess every smooth function is nearly linear. A step solves that linear problem; damping
keeps the step short where the line is not to be trusted. Use it through
`course_lib.least_squares`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, DegenerateConfigurationError, check_rows
from course_lib.least_squares.linear import parameter_covariance

#: How trusting the first step is: 0 would trust the linear problem wholly.
FIRST_DAMPING = 1e-3
LEAST_DAMPING = 1e-12
#: With more damping the step is too short to tell whether it still improves anything.
TRUSTED = 1.0


@dataclass(frozen=True, eq=False)
class Fit:
    """Where Levenberg–Marquardt ended.

    Attributes
    ----------
    parameters : ndarray, shape (n,)
        The unknowns.
    residuals : ndarray, shape (N,)
        What is left.
    jacobian : ndarray, shape (N, n)
        The derivatives of the residuals by the parameters.
    converged : bool
        Whether no better parameters are near; else the steps ran out.
    steps : int
        How many steps were tried.
    """

    parameters: Array
    residuals: Array
    jacobian: Array
    converged: bool
    steps: int

    @cached_property
    def covariance(self) -> Array:
        """As `parameter_covariance`, shape (n, n)."""
        return parameter_covariance(self.jacobian, self.residuals)

    @property
    def sigma(self) -> Array:
        """The standard deviations of the parameters, shape (n,)."""
        return np.asarray(np.sqrt(np.diag(self.covariance)))


def levenberg_marquardt(
    residuals_and_jacobian: Callable[[Array], tuple[Array, Array]],
    start: ArrayLike,
    steps: int = 100,
    tolerance: float = 1e-12,
) -> Fit:
    """Return the parameters near a start for which the sum of squared residuals is smallest.

    Parameters
    ----------
    residuals_and_jacobian : callable
        Takes parameters, shape (n,); returns the residuals, shape (N,), and their derivatives,
        shape (N, n), N ≥ n. A residual of NaN forbids the parameters.
    start : array_like, shape (n,)
        First guess.
    steps : int
        How many steps are tried at most.
    tolerance : float
        It ends when the linear problem promises to lower the sum of squares by less than this
        share, or to change the parameters by less than this share.

    Returns
    -------
    Fit
        Parameters, residuals, covariance, and whether it converged.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, or a residual or derivative at the start is not finite.
    DegenerateConfigurationError
        If a parameter changes no residual.

    References
    ----------
    D. W. Marquardt, "An algorithm for least-squares estimation of nonlinear parameters", Journal
    of the SIAM 11 (1963); Hartley & Zisserman, Multiple View Geometry, 2nd ed., appendix A6.2.

    Examples
    --------
    The rate of a decay, from three measurements:

    >>> time, seen = np.array([0.0, 1, 2]), np.array([1, 0.5, 0.25])
    >>> def decay(x):
    ...     model = np.exp(-x[0] * time)
    ...     return model - seen, (-time * model)[:, None]
    >>> levenberg_marquardt(decay, [0.1]).parameters.round(9)  # the logarithm of 2
    array([0.69314718])
    """
    x = check_rows(start, "start")
    if x.ndim != 1:
        raise ValueError(f"start must be one row of parameters, got shape {x.shape}")
    residuals, jacobian = _check_problem(*residuals_and_jacobian(x), x)
    cost, damping, settled, tried = residuals @ residuals, FIRST_DAMPING, False, 0
    nothing = 1e-28 * cost  # rounding is all that is left
    while tried < steps and not settled:
        step, promise, length = _damped_step(residuals, jacobian, damping, x)
        tiny = promise <= tolerance * cost or length <= tolerance or cost <= nothing
        settled = bool(tiny and damping <= TRUSTED)
        with np.errstate(all="ignore"):
            new_residuals, new_jacobian = residuals_and_jacobian(x + step)
            new_cost = new_residuals @ new_residuals
        tried += 1
        damping *= 10
        if new_cost <= cost:  # NaN compares as False
            x, residuals, jacobian, cost = x + step, new_residuals, new_jacobian, new_cost
            damping = max(damping / 100, LEAST_DAMPING)
    return Fit(x, residuals, jacobian, settled, tried)


def _damped_step(
    residuals: Array, J: Array, damping: float, x: Array
) -> tuple[Array, float, float]:
    """Return the step that solves ``(JᵀJ + damping · diag(JᵀJ)) step = -Jᵀ residuals``.

    With it comes what the linear problem promises: by how much the sum of squares gets smaller;
    and the step's length by that of `x`, both measured by what they change in the residuals.
    """
    sizes = np.linalg.norm(J, axis=0)
    if not sizes.all():
        raise DegenerateConfigurationError(
            f"parameter {int(np.argmin(sizes))} (counted from 0) changes no residual: leave it out"
        )
    # In units in which each parameter changes the residuals equally, damping is a number.
    J = J / sizes
    g = J.T @ residuals
    step = np.linalg.solve(J.T @ J + damping * np.eye(len(x)), -g)
    promise = float(step @ (damping * step - g))
    return step / sizes, promise, float(np.linalg.norm(step) / (np.linalg.norm(sizes * x) or 1))


def _check_problem(residuals: Array, jacobian: Array, start: Array) -> tuple[Array, Array]:
    """Return both, once they are what the docstring asks for."""
    residuals, jacobian = np.asarray(residuals), np.asarray(jacobian)
    shape = residuals.shape[0] if residuals.ndim == 1 else 0, len(start)
    if jacobian.shape != shape or shape[0] < shape[1]:
        raise ValueError(
            f"{len(start)} parameters need residuals of shape (N,), N ≥ {len(start)}, and "
            f"derivatives of shape (N, {len(start)}), got {residuals.shape} and {jacobian.shape}"
        )
    if not (np.isfinite(residuals).all() and np.isfinite(jacobian).all()):
        raise ValueError("a residual or derivative at the start is not finite: start elsewhere")
    return residuals, jacobian
