"""Absolute orientation: seven numbers that lay a model over the world, ``X_w = λ R X + t``."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, DegenerateConfigurationError, check_numbers, check_points
from course_lib.correspondences import check_correspondences, check_spread

#: Targets whose mirror image fits so many times better are a mirror image.
MIRRORED = 10.0


class Similarity(NamedTuple):
    """A turn, a move and a scale: ``X' = scale · R X + t``.

    Attributes
    ----------
    scale : float
        Length there by length here.
    R : ndarray, shape (3, 3)
        Rotation.
    t : ndarray, shape (3,)
        Where the origin goes, in the unit there.
    """

    scale: float
    R: Array
    t: Array

    def apply(self, points: ArrayLike) -> Array:
        """Return where points go, shape (N, 3) or (3,)."""
        return self.scale * check_points(points, 3, "points") @ self.R.T + self.t

    def inverse(self) -> Similarity:
        """Return the way back."""
        return Similarity(1 / self.scale, self.R.T, -self.R.T @ self.t / self.scale)


def similarity_transform(
    points: ArrayLike,
    targets: ArrayLike,
    weights: ArrayLike | None = None,
    scaled: bool = True,
) -> Similarity:
    """Return the turn, move and scale that bring points nearest to their targets.

    The sum of squared distances is smallest, in one step and without a start.

    Parameters
    ----------
    points : array_like, shape (N, 3)
        N ≥ 3 points, not all on one line.
    targets : array_like, shape (N, 3)
        Where each should go.
    weights : array_like, shape (N,), optional
        How much each counts, ``1 / σ²``; all the same if not given.
    scaled : bool
        Whether the scale is free; else it is 1.

    Returns
    -------
    Similarity
        Scale, rotation (never a reflection) and translation.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or a weight not positive.
    DegenerateConfigurationError
        If the points or targets are all on one line, or if the targets are a mirror image of the
        points: no turn leads there.

    References
    ----------
    S. Umeyama, "Least-squares estimation of transformation parameters between two point patterns",
    IEEE Trans. PAMI 13 (1991); B. K. P. Horn, J. Opt. Soc. Am. A 4 (1987).

    Examples
    --------
    >>> points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    >>> found = similarity_transform(points, 2 * points + [5, 0, 0])
    >>> float(round(found.scale, 9)), found.t.round(9) + 0.0
    (2.0, array([5., 0., 0.]))
    """
    names = "points", "targets"
    one, other = check_correspondences(points, targets, (3, 3), names, least=3)
    share = _shares(weights, len(one))
    check_spread(one, 2, names[0])
    check_spread(other, 2, names[1])
    middle, goal = share @ one, share @ other
    one, other = one - middle, other - goal
    U, sizes, Vt = np.linalg.svd((other * share[:, None]).T @ one)
    upright = np.sign(np.linalg.det(U @ Vt))
    signs = np.array([1, 1, upright])
    R = (U * signs) @ Vt
    spread = float(share @ (one * one).sum(axis=1))
    scale = float(sizes @ signs / spread) if scaled else 1.0
    if upright < 0:
        whole = float(share @ (other * other).sum(axis=1))
        _check_not_mirrored(whole, sizes, signs, spread)
    return Similarity(scale, R, goal - scale * R @ middle)


def _shares(weights: ArrayLike | None, count: int) -> Array:
    """Return weights as shares of 1."""
    if weights is None:
        return np.full(count, 1 / count)
    array = check_numbers(weights, "weights")
    if array.shape != (count,) or (array <= 0).any():
        raise ValueError(
            f"weights must be {count} positive numbers, one for each point, got {array!r:.80}"
        )
    return np.asarray(array / array.sum())


def _check_not_mirrored(whole: float, sizes: Array, signs: Array, spread: float) -> None:
    """Raise if a reflection leaves far less than the best rotation does."""
    rounding = 1e-12 * whole
    turned = whole - (sizes @ signs) ** 2 / spread
    mirrored = max(whole - sizes.sum() ** 2 / spread, rounding)
    if turned > MIRRORED**2 * mirrored:
        raise DegenerateConfigurationError(
            "the targets are a mirror image of the points, and no turn leads there: check whether "
            "two axes are swapped (north and east), or a sign is wrong (depth instead of height)"
        )
