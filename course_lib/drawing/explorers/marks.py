"""Points of a picture that say what they are when the pointer comes near, in the browser alone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Marks:
    """Points with numbers of their own; the one nearest to the pointer is ringed and read.

    Attributes
    ----------
    points : ndarray, shape (N, 2)
        Where they are, px of their picture.
    values : ndarray, shape (N, K)
        K numbers of each.
    names, units : tuple of str, length K
        What the numbers are called, and their units.
    digits : tuple of int, length K
        Decimals shown.

    Raises
    ------
    ValueError
        If the numbers of points, values or names do not agree.
    """

    points: NDArray[np.float64]
    values: NDArray[np.float64]
    names: tuple[str, ...]
    units: tuple[str, ...]
    digits: tuple[int, ...]

    def __post_init__(self) -> None:
        shape = len(self.points), len(self.names)
        if self.values.shape != shape or not shape[1] == len(self.units) == len(self.digits):
            raise ValueError(
                f"{shape[0]} points and {shape[1]} names want values of shape {shape} and as many "
                f"units and digits, got {self.values.shape}, {len(self.units)}, {len(self.digits)}"
            )
