"""Control points: points of a block whose place in the world was measured by other means."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from course_lib.bundle.block import Indices, check_numbers_of
from course_lib.checks import Array, check_not_negative, check_points


@dataclass(frozen=True, eq=False)
class Control:
    """Points that were surveyed, and how well.

    Attributes
    ----------
    points : ndarray of int, shape (k,)
        Their numbers in the block.
    coordinates : ndarray, shape (k, 3)
        Their places in the world.
    sigma : ndarray, shape (k, 3)
        Standard deviations in the unit of the coordinates; one number or a row of three is given to
        all. Zero holds a coordinate where it was measured.

    Raises
    ------
    TypeError, ValueError
        If the rows do not belong together, a number is not finite, a sigma is negative or a point
        is named twice.
    """

    points: Indices
    coordinates: Array
    sigma: Array | float = 0.0

    def __post_init__(self) -> None:
        points = check_numbers_of(self.points, None, "points")
        coordinates = check_points(self.coordinates, 3, "coordinates")
        if coordinates.shape != (len(points), 3):
            raise ValueError(
                "points and coordinates belong together row by row, got shapes "
                f"{points.shape} and {coordinates.shape}"
            )
        if len(np.unique(points)) < len(points):
            raise ValueError("a control point is named twice: keep one row of each")
        sigma = check_not_negative(self.sigma, "sigma")
        if sigma.shape not in ((), (3,), coordinates.shape):
            raise ValueError(
                f"sigma must be one number, three or {coordinates.shape}, got shape {sigma.shape}"
            )
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "coordinates", coordinates)
        object.__setattr__(self, "sigma", np.broadcast_to(sigma, coordinates.shape))

    @property
    def held(self) -> Array:
        """1 where a coordinate is held, 0 where it is weighted, shape (k, 3)."""
        return np.asarray(np.asarray(self.sigma) == 0, dtype=float)

    @property
    def weights(self) -> Array:
        """``1 / σ²``, and 0 for what is held, shape (k, 3)."""
        held = self.held
        return np.asarray((1 - held) / (np.asarray(self.sigma) + held) ** 2)
