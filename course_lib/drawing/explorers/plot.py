"""Axes for the curves of an explorer: numbers to pixels, and the words beside them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.explorers.frame import Label, Line

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Plot:
    """A pair of axes inside a picture.

    Attributes
    ----------
    box : tuple of float
        Left, right, top and bottom of the axes, px.
    x, y : tuple of float
        Ends of both axes, in their own units.
    log_x, log_y : bool
        Whether an axis is logarithmic.
    """

    box: tuple[float, float, float, float]
    x: tuple[float, float]
    y: tuple[float, float]
    log_x: bool = False
    log_y: bool = False

    def pixels(self, x: ArrayLike, y: ArrayLike) -> Floats:
        """Return pixels (N, 2) of points; NaN where they lie outside of the axes.

        Parameters
        ----------
        x, y : array_like
            Coordinates, broadcast to one shape (N,).

        Returns
        -------
        ndarray, shape (N, 2)
            (u, v) in px.
        """
        left, right, top, bottom = self.box
        across, up = np.broadcast_arrays(
            share(np.atleast_1d(x), self.x, self.log_x), share(np.atleast_1d(y), self.y, self.log_y)
        )
        points = np.stack([left + across * (right - left), bottom - up * (bottom - top)], axis=-1)
        outside = (np.abs(across - 0.5) > 0.5 + 1e-9) | (np.abs(up - 0.5) > 0.5 + 1e-9)
        points[outside | np.isnan(points).any(axis=-1)] = np.nan
        return np.asarray(points)

    def at(self, x: float, y: float, right: float = 0, down: float = 0) -> tuple[float, float]:
        """Return the pixel of one point inside the axes, moved to the right and down."""
        u, v = self.pixels(x, y)[0]
        return float(u) + right, float(v) + down

    def within(self, segments: ArrayLike) -> Floats:
        """Return the parts of straight segments that lie inside of linear axes.

        Parameters
        ----------
        segments : array_like, shape (N, 2, 2)
            Both ends of each, in the units of the axes.

        Returns
        -------
        ndarray, shape (M, 2, 2)
            Both ends of the parts, px; M ≤ N.

        References
        ----------
        Y.-D. Liang, B. A. Barsky, "A new concept and method for line clipping", ACM Transactions
        on Graphics 3 (1984).
        """
        (low, high), ends = np.array([self.x, self.y]).T, np.asarray(segments, dtype=float)
        start, way = ends[:, 0], ends[:, 1] - ends[:, 0]
        way = np.where(way == 0, 1e-300, way)
        with np.errstate(over="ignore"):
            sides = np.stack([(low - start) / way, (high - start) / way])
        enter = sides.min(axis=0).max(axis=1, initial=0.0)
        leave = sides.max(axis=0).min(axis=1, initial=1.0)
        some = enter < leave
        shares = np.stack([enter, leave], axis=1)[some, :, None]
        parts = start[some, None] + shares * way[some, None]
        left, right, top, bottom = self.box
        size = np.array([right - left, top - bottom])
        return np.asarray(np.array([left, bottom]) + (parts - low) / (high - low) * size)

    def frame(self) -> Line:
        """Return the two axes."""
        left, right, top, bottom = self.box
        return Line([[left, top], [left, bottom], [right, bottom]], "guide", 1.2)

    def ticks(self, x: Sequence[float], y: Sequence[float]) -> tuple[Label, ...]:
        """Return the numbers at both axes."""
        below = [
            Label(f"{value:g}", self.at(value, self.y[0], 0, 12), "guide", "middle") for value in x
        ]
        beside = [Label(f"{value:g}", self.at(self.x[0], value, -6), "guide", "end") for value in y]
        return (*below, *beside)

    def names(self, x: str, y: str) -> tuple[Label, Label]:
        """Return the names of both axes, with units: below the middle, and above the upright."""
        left, right, top, bottom = self.box
        return (
            Label(x, ((left + right) / 2, bottom + 30), anchor="middle"),
            Label(y, (left - 6, top - 12)),
        )


def share(values: ArrayLike, ends: tuple[float, float], logarithmic: bool) -> Floats:
    """Return where values lie between two ends, 0 to 1."""
    numbers, (low, high) = np.asarray(values, dtype=float), ends
    if not logarithmic:
        return np.asarray((numbers - low) / (high - low))
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(np.log(numbers / low) / np.log(high / low))


def lifted(lines: ArrayLike) -> Floats:
    """Return lines of K points each, (N, K, 2), as one that lifts its pen, (N (K + 1), 2)."""
    points = np.asarray(lines, dtype=float)
    pen = np.full((len(points), 1, 2), np.nan)
    return np.asarray(np.concatenate([points, pen], axis=1).reshape(-1, 2))


def crosses(places: ArrayLike, size: float) -> Floats:
    """Return small upright crosses at pixels, as one line, (6 N, 2)."""
    pen = [np.nan, np.nan]
    steps = size * np.array([[-1, 0], [1, 0], pen, [0, -1], [0, 1], pen])
    return np.asarray((np.asarray(places)[:, None] + steps).reshape(-1, 2))


def disc(at: ArrayLike, radius: float) -> Floats:
    """Return the outline of a disc, (36, 2), px."""
    turn = np.linspace(0, 2 * np.pi, 37)[:-1]
    return np.asarray(at) + radius * np.stack([np.cos(turn), np.sin(turn)], axis=1)
