"""The measurements of a calibration: points of a board and their pixels, view by view.

Use these functions through `course_lib.calibration`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_length,
    check_number,
    check_points,
)

#: Fewer points of a plane leave the pose of the camera before it open.
LEAST_POINTS = 4


@dataclass(frozen=True, eq=False)
class Views:
    """Points and pixels of all views in one piece, coordinates in rows, so that NumPy is quick.

    Views with fewer points than the longest are filled up; what was filled in weighs nothing.

    Attributes
    ----------
    points : ndarray, shape (V, 3, N) or (1, 3, N)
        Points of the board, in its own frame; once, if they are the same in all views.
    pixels : ndarray, shape (V, 2, N)
        Where they were seen, px.
    weights : ndarray, shape (V, N), or None
        How much each counts; None if all count 1.
    counts : ndarray of int, shape (V,)
        How many points each view has.
    """

    points: Array
    pixels: Array
    weights: Array | None
    counts: NDArray[np.intp]

    @property
    def observations(self) -> int:
        """How many numbers were measured: two for each point that counts."""
        if self.weights is None:
            return 2 * int(self.counts.sum())
        return 2 * int(np.count_nonzero(self.weights))

    def per_view(self, values: Array) -> list[Array]:
        """Return ``(V, 2, N)`` as one array of rows for each view, without what was filled in."""
        return [v[:, :n].T.copy() for v, n in zip(values, self.counts, strict=True)]

    def thinned(self, most: int) -> Views:
        """Return every so many-th point of each view, so that about `most` are left of each."""
        step = self.pixels.shape[-1] // most
        if step < 2 or self.weights is not None:
            return self
        pixels = np.ascontiguousarray(self.pixels[:, :, ::step])
        counts = np.full(len(pixels), pixels.shape[-1])
        return Views(np.ascontiguousarray(self.points[:, :, ::step]), pixels, None, counts)

    def only(self, keep: NDArray[np.bool_]) -> Views:
        """Return some of the views."""
        points = self.points if len(self.points) == 1 else self.points[keep]
        weights = None if self.weights is None else self.weights[keep]
        return Views(points, self.pixels[keep], weights, self.counts[keep])

    def weighted(self, weights: Array) -> Views:
        """Return the same views, each point with another weight, which multiplies its own."""
        own = 1.0 if self.weights is None else self.weights
        return Views(self.points, self.pixels, own * weights, self.counts)


def board_points(columns: int, rows: int, square: float) -> Array:
    """Return the inner corners of a checkerboard, in the board's own frame.

    Parameters
    ----------
    columns, rows : int
        How many inner corners there are in a row, and how many rows of them.
    square : float
        Side of a square, in the unit in which lengths shall come out.

    Returns
    -------
    ndarray, shape (columns · rows, 3)
        Points ``(x, y, 0)``, row by row: x runs from 0 along a row, then y goes on by a square.

    Raises
    ------
    TypeError, ValueError
        If there are less than two columns or rows, or `square` is not positive.

    References
    ----------
    Z. Zhang, "A flexible new technique for camera calibration", IEEE PAMI 22 (2000), section 2.2.

    Examples
    --------
    >>> board_points(3, 2, square=25)
    array([[ 0.,  0.,  0.],
           [25.,  0.,  0.],
           [50.,  0.,  0.],
           [ 0., 25.,  0.],
           [25., 25.,  0.],
           [50., 25.,  0.]])
    """
    _check_count(columns, "columns")
    _check_count(rows, "rows")
    square = check_length(square, "square")
    row, column = np.divmod(np.arange(columns * rows), columns)
    return np.stack([column * square, row * square, np.zeros(columns * rows)], axis=1)


def gather_views(object_points: object, image_points: object) -> Views:
    """Return the measurements in one piece, once each is sure to be points of a flat board.

    Parameters
    ----------
    object_points : array_like, shape (N, 3), or sequence of V of them
        Points of the board in its own frame, z = 0: one board for all views, or one a view.
    image_points : sequence of V array_like, shape (N, 2)
        Their pixels, view by view, in the same order.

    Returns
    -------
    Views
        Arrays with the views in front.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or a view has not as many pixels as points.
    DegenerateConfigurationError
        If there is no view, a board's points lie on a line or coincide, or it is not flat.
    """
    pixels = [_check_view(view, i) for i, view in enumerate(_listed(image_points, "image_points"))]
    if not pixels:
        raise DegenerateConfigurationError(
            "there are no views: was the board found in none of the pictures?"
        )
    boards = _boards(object_points, len(pixels))
    for i, view in enumerate(pixels):
        _check_counts(boards[i if len(boards) > 1 else 0], view, i)
    counts = np.array([len(view) for view in pixels])
    weights = None
    if counts.min() < counts.max():
        weights = (np.arange(counts.max()) < counts[:, None]).astype(float)
    return Views(_stacked(boards), _stacked(pixels), weights, counts)


def each_view(object_points: object, image_points: object) -> list[tuple[ArrayLike, ArrayLike]]:
    """Return the board and the pixels of each view, unchecked, from arguments of `calibrate`."""
    pixels = _listed(image_points, "image_points")
    boards = _listed(object_points, "object_points")
    if boards and np.ndim(boards[0]) == 1:
        boards = [np.asarray(object_points)] * len(pixels)
    return list(zip(boards, pixels, strict=False))


def _boards(object_points: object, count: int) -> list[Array]:
    """Return the board once, or the board of each view if they differ."""
    listed = _listed(object_points, "object_points")
    if listed and np.ndim(listed[0]) == 1:
        return [_check_board(np.asarray(object_points), "the board")]
    if len(listed) != count:
        raise ValueError(
            f"object_points must be one board or one for each view, got {len(listed)} boards and "
            f"{count} views"
        )
    if all(board is listed[0] for board in listed):
        return [_check_board(listed[0], "the board")]
    return [_check_board(board, f"the board of view {i}") for i, board in enumerate(listed)]


def _listed(value: object, name: str) -> list[ArrayLike]:
    if isinstance(value, str) or not isinstance(value, Sequence | np.ndarray):
        raise TypeError(f"{name} must be a sequence of arrays, got {value!r:.60}")
    return list(value)


def _check_view(view: ArrayLike, i: int) -> Array:
    pixels = check_points(_without_middle(view), 2, f"the pixels of view {i}")
    if pixels.ndim != 2:
        raise ValueError(
            f"image_points must be one array (N, 2) for each view, got shape {pixels.shape} for "
            f"view {i}: put a single view into a list"
        )
    return pixels


def _without_middle(points: ArrayLike) -> ArrayLike:
    """Return OpenCV's (N, 1, 2) as (N, 2), and anything else as it is."""
    if isinstance(points, np.ndarray) and points.ndim == 3 and points.shape[1] == 1:
        return np.asarray(points[:, 0])
    return points


def _check_counts(board: Array, pixels: Array, i: int) -> None:
    if len(pixels) != len(board):
        raise ValueError(
            f"view {i} has {len(pixels)} pixels, but its board has {len(board)} points: is the "
            "number of columns and rows right, and were all corners found?"
        )
    if len(pixels) < LEAST_POINTS:
        raise DegenerateConfigurationError(
            f"view {i} has {len(pixels)} points, and the pose of a board needs {LEAST_POINTS}: "
            "leave this view out"
        )
    if (pixels == pixels[0]).all():
        raise DegenerateConfigurationError(f"all pixels of view {i} are the same: leave it out")


def _check_board(points: ArrayLike, name: str) -> Array:
    board = check_points(_without_middle(points), 3, f"the points of {name}")
    if board.ndim != 2 or len(board) < LEAST_POINTS:
        raise DegenerateConfigurationError(
            f"{name} has {len(np.atleast_2d(board))} points, and the pose of a board needs "
            f"{LEAST_POINTS}: leave such views out"
        )
    centred = board - board.mean(axis=0)
    sizes = np.linalg.svd(centred, compute_uv=False)
    if sizes[0] == 0:
        raise DegenerateConfigurationError(
            f"the points of {name} are all the same: is the side of a square 0?"
        )
    if sizes[1] < 1e-6 * sizes[0]:
        raise DegenerateConfigurationError(
            f"the points of {name} lie on one line: a board needs columns and rows"
        )
    if np.abs(board[:, 2]).max() > 0.05 * np.ptp(board[:, :2], axis=0).max():
        raise DegenerateConfigurationError(
            f"{name} is not flat: Zhang's method wants z = 0 (for a solid use camera_dlt)"
        )
    return board


def _stacked(parts: list[Array]) -> Array:
    """Return rows of points as ``(V, d, N)``, short ones filled up with their first point."""
    longest = max(map(len, parts))
    stacked = np.empty((len(parts), parts[0].shape[1], longest))
    for place, part in zip(stacked, parts, strict=True):
        place[:, : len(part)] = part.T
        place[:, len(part) :] = part[:1].T
    return stacked


def _check_count(value: int, name: str) -> None:
    if check_number(value, name) != int(value) or value < 2:
        raise ValueError(f"{name} must be a whole number of inner corners from 2, got {value}")
