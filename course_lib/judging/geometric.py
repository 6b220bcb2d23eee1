"""Ways to compare what has a geometry: scale, rotations, directions, pictures."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from course_lib.judging.comparison import Mismatch, as_numbers


@dataclass(frozen=True)
class UpToScale:
    """Homogeneous arrays: equal after scaling to unit norm, with either sign.

    With `rows`, each row has a scale of its own, as points and lines have.
    """

    tolerance: float = 1e-6
    rows: bool = False
    scale_free = True

    def __call__(self, got: Any, expected: Any) -> Mismatch | None:
        """Return why `got` is not `expected`, or None."""
        truth = np.asarray(expected, dtype=float)
        array = as_numbers(got, truth)
        if isinstance(array, Mismatch):
            return array
        axis = -1 if self.rows else None
        norms = [np.linalg.norm(a, axis=axis, keepdims=True) for a in (array, truth)]
        if not np.isfinite(norms).all() or not np.all(norms):
            return Mismatch("values", "All values are zero, or some are not finite.")
        unit, unit_truth = array / norms[0], truth / norms[1]
        same, opposite = (np.linalg.norm(unit - s * unit_truth, axis=axis) for s in (1, -1))
        if (np.minimum(same, opposite) < self.tolerance).all():
            return None
        return Mismatch("values", "The answer is not a multiple of the right one.")


@dataclass(frozen=True)
class RotationClose:
    """Rotation matrices: orthonormal, determinant +1, within an angle (radians) of the truth."""

    tolerance: float = 1e-6

    def __call__(self, got: Any, expected: Any) -> Mismatch | None:
        """Return why `got` is not `expected`, or None."""
        truth = np.asarray(expected, dtype=float)
        array = as_numbers(got, truth)
        if isinstance(array, Mismatch):
            return array
        if not np.allclose(array.T @ array, np.eye(len(truth)), atol=1e-6):
            return Mismatch("values", "This is not a rotation: its columns are not orthonormal.")
        if np.linalg.det(array) < 0:
            return Mismatch("values", "This is a reflection: its determinant is −1.")
        # ‖R₁ − R₂‖_F = 2 √2 sin(θ/2) for the angle θ between two rotations.
        if np.linalg.norm(array - truth) < 2 * np.sqrt(2) * np.sin(self.tolerance / 2):
            return None
        return Mismatch("values", "This is a rotation, but not the right one.")


@dataclass(frozen=True)
class RaySet:
    """Directions as rows, in any order and of any length; opposite directions differ."""

    tolerance: float = 1e-6

    def __call__(self, got: Any, expected: Any) -> Mismatch | None:
        """Return why `got` is not `expected`, or None."""
        truth = np.asarray(expected, dtype=float)
        array = as_numbers(got, truth)
        if isinstance(array, Mismatch):
            return array
        lengths = np.linalg.norm(array, axis=1)
        if not np.isfinite(lengths).all() or (lengths == 0).any():
            return Mismatch("values", "A direction has no length, or is not finite.")
        unit = array / lengths[:, None]
        unit_truth = truth / np.linalg.norm(truth, axis=1, keepdims=True)
        near = np.linalg.norm(unit[:, None] - unit_truth, axis=2) < self.tolerance
        if near.any(axis=0).all() and near.any(axis=1).all():
            return None
        return Mismatch("values", "The directions are not the right ones.")


@dataclass(frozen=True)
class ImageClose:
    """Pictures whose mean absolute difference stays below a number of grey levels (of 255)."""

    levels: float = 1.0

    def __call__(self, got: Any, expected: Any) -> Mismatch | None:
        """Return why `got` is not `expected`, or None."""
        truth = np.asarray(expected)
        array = as_numbers(got, truth)
        if isinstance(array, Mismatch):
            return array
        if isinstance(got, np.ndarray) and got.dtype != truth.dtype:
            message = f"The picture is {got.dtype}; {truth.dtype} was expected."
            return Mismatch("type", message)
        scale = 1.0 if truth.dtype == np.uint8 else 255.0
        difference = np.abs(array - truth.astype(float)).mean() * scale
        if np.isfinite(difference) and difference <= self.levels:
            return None
        return Mismatch("values", "The picture differs from the right one.")
