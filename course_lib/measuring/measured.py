"""A measured length with its uncertainty, and where that comes from.

Use these names through `course_lib.measuring`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import check_points

#: Of many measurements with normal errors, 95 % lie within so many standard deviations.
COVERAGE_95 = 1.959964


@dataclass(frozen=True)
class Measured:
    """A length, and how well it is known.

    Attributes
    ----------
    value : float
        The length, in the unit of the target.
    parts : dict of str to float
        Standard deviation that each source alone would cause, in the same unit.

    References
    ----------
    JCGM 100 (GUM), sections 5.1 (combined standard uncertainty) and 6.2 (expanded uncertainty).

    Examples
    --------
    >>> length = Measured(82.31, {"pointing": 0.16, "target": 0.12})
    >>> round(length.sigma, 3)
    0.2
    >>> print(length)
    82.3 mm ± 0.4 mm (95 %)
    """

    value: float
    parts: dict[str, float] = field(default_factory=dict)

    @property
    def sigma(self) -> float:
        """Standard deviation: the root of the sum of the squares of all parts."""
        return math.hypot(*self.parts.values())

    @property
    def plus_minus(self) -> float:
        """Half the width of the interval that holds the true value in 95 % of all cases."""
        return COVERAGE_95 * self.sigma

    def holds(self, truth: float) -> bool:
        """Return whether a length lies within the interval of 95 %."""
        return abs(self.value - truth) <= self.plus_minus

    def text(self, unit: str = "mm") -> str:
        """Return value and interval, rounded to what is known, e.g. 82.3 mm ± 0.4 mm (95 %)."""
        decimals = _decimals(self.plus_minus)
        value, around = (_rounded(x, decimals) for x in (self.value, self.plus_minus))
        return f"{value} {unit} ± {around} {unit} (95 %)"

    def __str__(self) -> str:
        return self.text()


def _decimals(around: float) -> int:
    """Return to how many decimals: one digit of the interval, two if the first one is 1 or 2."""
    if not around > 0:
        return 6
    first, exponent = f"{around:.0e}".split("e")
    return (1 if first in "12" else 0) - int(exponent)


def _rounded(value: float, decimals: int) -> str:
    return f"{round(value, decimals):.{max(decimals, 0)}f}"


def pointing_sigma(clicks: ArrayLike) -> float:
    """Return how well somebody points, from several attempts at the same point.

    Parameters
    ----------
    clicks : array_like, shape (k, 2)
        Pixels of k ≥ 2 attempts.

    Returns
    -------
    float
        Standard deviation of one coordinate of one attempt, px: the scatter around the mean of
        the attempts, ``√(Σ((u - ū)² + (v - v̄)²) / (2 (k - 1)))``.

    Raises
    ------
    TypeError, ValueError
        If the shape is wrong, a number is not finite, or there are fewer than two.

    References
    ----------
    JCGM 100 (GUM), section 4.2 (evaluation from repeated observations).

    Examples
    --------
    >>> pointing_sigma([[100, 50], [101, 50], [102, 50]]).__round__(4)
    0.7071
    """
    attempts = check_points(clicks, 2, "clicks")
    if attempts.ndim != 2 or len(attempts) < 2:
        raise ValueError("clicks must be two or more pixels, shape (k, 2): point again")
    away = attempts - attempts.mean(axis=0)
    return float(np.sqrt((away**2).sum() / (2 * (len(attempts) - 1))))
