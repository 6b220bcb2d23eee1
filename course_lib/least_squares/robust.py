"""Robust least squares: a few wrong measurements must not spoil the many good ones.

Use these functions through `course_lib.least_squares`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_length, check_numbers
from course_lib.least_squares.linear import solve_qr, solve_weighted

#: Beyond so many standard deviations a residual counts less; with good data alone, that costs 5 %
#: of the accuracy.
HUBER = 1.345
#: A normal distribution's standard deviation by the median of its sizes.
SIGMA_BY_MEDIAN = 1.4826


class RobustFit(NamedTuple):
    """A solution in which wrong measurements count less.

    Attributes
    ----------
    x : ndarray, shape (n,)
        The unknowns.
    weights : ndarray, shape (N,)
        How much each equation counted at the end: 1 if its residual is small, less if it is not.
    threshold : float
        The size of a residual from which on it counted less, in the unit of `b`.
    """

    x: Array
    weights: Array
    threshold: float


def huber_weights(residuals: ArrayLike, threshold: ArrayLike) -> Array:
    """Return how much residuals count: fully while they are small, then ever less.

    Parameters
    ----------
    residuals : array_like, any shape
        What is left of measurements.
    threshold : float
        Size of a residual from which on it counts less, in its unit.

    Returns
    -------
    ndarray, shape of `residuals`
        1 up to the threshold, then ``threshold / |residual|``: pulled with the same force, however
        far away.

    Raises
    ------
    TypeError, ValueError
        If a number is not finite or the threshold is not positive.

    References
    ----------
    P. J. Huber, "Robust estimation of a location parameter", Annals of Mathematical Statistics 35
    (1964).

    Examples
    --------
    >>> huber_weights([0, -1, 4], 2)
    array([1. , 1. , 0.5])
    """
    sizes = np.abs(check_numbers(residuals, "residuals"))
    threshold = check_length(threshold, "threshold")
    return threshold / np.maximum(sizes, threshold)


def solve_robust(
    A: ArrayLike, b: ArrayLike, threshold: float | None = None, steps: int = 100
) -> RobustFit:
    """Return a solution that large residuals pull less than least squares would let them.

    Solves, weighs each equation by what is left of it, and solves again, until nothing changes.

    Parameters
    ----------
    A : array_like, shape (N, n)
        Coefficients of N equations in n unknowns, N > n.
    b : array_like, shape (N,)
        Right-hand sides.
    threshold : float, optional
        Size of a residual from which on it counts less; 1.345 σ unless it is given, with σ judged
        by the median size of the residuals that are left when their sum of sizes is smallest.
    steps : int
        How often it solves at most, for each of the two.

    Returns
    -------
    RobustFit
        Unknowns, weights and threshold.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, a threshold is not positive, or there are
        fewer rows than columns.
    DegenerateConfigurationError
        If the columns of `A` are dependent.

    References
    ----------
    P. J. Huber, E. M. Ronchetti, Robust Statistics, 2nd ed., sections 7.7 and 7.8.

    Examples
    --------
    Five measurements of one length; the last is a slip:

    >>> solve_robust(np.ones((5, 1)), [10, 10.1, 9.9, 10, 20], threshold=0.1).x.round(6)
    array([10.033333])
    """
    x = solve_qr(A, b)
    A, b = check_numbers(A, "A"), check_numbers(b, "b")
    if b.ndim != 1:
        raise ValueError(f"b must be one number for each row of A, got shape {b.shape}")
    if threshold is None:
        # Nearly the smallest sum of sizes, which slips hardly move, tells how large errors are.
        tiny = 1e-9 * float(np.abs(b).max()) or 1.0
        x, _ = _reweighted(A, b, x, tiny, steps)
        sigma = SIGMA_BY_MEDIAN * float(np.median(np.abs(A @ x - b)))
        threshold = max(HUBER * sigma, tiny)
    x, weights = _reweighted(A, b, x, threshold, steps)
    return RobustFit(x, weights, threshold)


def _reweighted(A: Array, b: Array, x: Array, threshold: float, steps: int) -> tuple[Array, Array]:
    for _ in range(steps):
        before, weights = x, huber_weights(A @ x - b, threshold)
        x = solve_weighted(A, b, weights)
        if np.abs(A @ (x - before)).max() <= 1e-10 * threshold:
            break
    return x, weights
