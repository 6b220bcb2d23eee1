"""Increasing functions of one variable: how far they increase, and back from value to argument."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array


def smallest_positive_root(coefficients: ArrayLike) -> float:
    """Return where a polynomial that begins at 1 first reaches zero.

    Parameters
    ----------
    coefficients : array_like, shape (n,)
        Ascending: ``1 + c1 q + c2 q² + …``; the first is 1.

    Returns
    -------
    float
        The smallest positive root, infinity if there is none. A root at which the polynomial only
        touches zero counts.

    Examples
    --------
    >>> smallest_positive_root([1, -3, 2])
    0.5
    >>> smallest_positive_root([1, 0, 1])
    inf
    """
    # With w = 1/q the highest power has the factor 1, and the root in question is the largest.
    inverse = np.roots(np.asarray(coefficients, dtype=np.float64))
    real = inverse.real[np.abs(inverse.imag) <= 1e-7 * np.abs(inverse)]
    largest = float(real.max(initial=0))
    return 1 / largest if largest > 0 else np.inf


def invert_increasing(
    values: Array,
    function: Callable[[Array], Array],
    slope: Callable[[Array], Array],
    end: float,
    nodes: int = 512,
) -> Array:
    """Return the arguments at which an increasing function has these values.

    Newton's method, from a table; a step that leaves the bracket is replaced by a bisection, so
    that it cannot fail.

    Parameters
    ----------
    values : ndarray, shape (N,)
        Values that are looked for, not negative.
    function, slope : callable
        The function and its derivative, for arrays of arguments from 0 to `end`; increasing there,
        from the value 0.
    end : float
        Largest argument.
    nodes : int
        Entries of the table.

    Returns
    -------
    ndarray, shape (N,)
        Arguments between 0 and `end`; NaN for a value that the function does not reach.

    References
    ----------
    Press et al., Numerical Recipes, 3rd ed., section 9.4 (Newton with bisection).

    Examples
    --------
    >>> invert_increasing(np.array([0.25, 9.0, 99.0]), lambda x: x**2, lambda x: 2 * x, end=4)
    array([0.5, 3. , nan])
    """
    # Equal steps near zero, equal ratios far from it.
    table = np.sinh(np.linspace(0, np.arcsinh(end), nodes))
    table[-1] = end
    place = np.clip(np.searchsorted(function(table), values), 1, nodes - 1)
    low, high = table[place - 1], table[place]
    x = (low + high) / 2
    for _ in range(80):
        excess = function(x) - values
        low, high = np.where(excess <= 0, x, low), np.where(excess >= 0, x, high)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            moved = x - excess / slope(x)
        moved = np.where((moved >= low) & (moved <= high), moved, (low + high) / 2)
        done = np.abs(moved - x) <= 4e-16 * moved
        x = moved
        if done.all():
            break
    return np.where(values <= function(np.array([end])), x, np.nan)
