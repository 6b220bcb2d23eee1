"""How matrices of two views, lines, and what RANSAC gives are compared with the right ones."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from course_lib.judging import Close, UpToScale, YesOrNo
from course_lib.judging.comparison import Comparison, Mismatch


@dataclass(frozen=True)
class PixelMatrix:
    """Fundamental matrices: equal up to scale and sign, every number counting as much.

    For pixels the last number of F is a million times larger than the first ones, which alone
    tell how lines turn. With the pixel replaced by a unit of 500 px, all are of one size.
    """

    unit: float = 500.0
    tolerance: float = 1e-5
    scale_free = True

    def __call__(self, got: Any, expected: Any) -> Mismatch | None:
        """Return why `got` is not `expected`, or None."""
        same = UpToScale(self.tolerance)
        if not isinstance(got, np.ndarray) or got.shape != (3, 3) or got.dtype.kind not in "iuf":
            miss = same(got, expected)
            if miss and miss.kind != "values":
                return miss
        unit = np.array([self.unit, self.unit, 1])
        sizes = np.outer(unit, unit)
        return same(np.asarray(got) * sizes, np.asarray(expected) * sizes)


@dataclass(frozen=True)
class LinesWithUnitNormal:
    """Lines in rows, ``a² + b² = 1``, each with either sign."""

    def __call__(self, got: Any, expected: Any) -> Mismatch | None:
        """Return why `got` is not `expected`, or None."""
        miss = Close()(got, expected)
        if miss is None or miss.kind != "values":
            return miss
        got, expected = np.asarray(got, dtype=float), np.asarray(expected, dtype=float)
        agree = np.where((got * expected).sum(axis=-1, keepdims=True) < 0, -1, 1)
        miss = Close()(got * agree, expected)
        if miss and UpToScale(rows=True)(got, expected) is None:
            return Mismatch("values", "These are the right lines, but of another scale.")
        return miss


@dataclass(frozen=True)
class MatrixAndFits:
    """What RANSAC gives: a fundamental matrix, and which pairs fit."""

    scale_free = True

    def __call__(self, got: Any, expected: Any) -> Mismatch | None:
        """Return why `got` is not `expected`, or None."""
        if not isinstance(got, tuple | list) or len(got) != 2:
            return Close()(got, expected)
        ways: tuple[tuple[str, Comparison], ...] = (("F", PixelMatrix()), ("fits", YesOrNo()))
        for (name, compare), one, other in zip(ways, got, expected, strict=True):
            if miss := compare(one, other):
                return Mismatch(miss.kind, f"`{name}`: {miss.message}")
        return None


@dataclass(frozen=True)
class TheOtherWayRound:
    """Two values in the wrong order, each compared as in the right one."""

    compare: Comparison

    def __call__(self, got: Any, expected: Any) -> Mismatch | None:
        """Return why `got` is not `expected`, or None."""
        if not isinstance(got, tuple | list) or not isinstance(expected, tuple | list):
            return Mismatch("type", "Two values were expected.")
        return self.compare(got[::-1], expected[::-1])
