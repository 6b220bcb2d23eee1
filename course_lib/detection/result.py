"""What a detection gives back, and the pictures it works on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import Array

Grey = NDArray[np.uint8]
#: In grey levels up to 255, of whatever numbers.
Picture = NDArray[Any]
Problem = Literal[
    "", "no board", "wrong size", "other kind", "cut off", "covered", "glare", "blurred"
]

#: Long sides, px, of the pictures in which a board is looked for, the likeliest first.
LOOKED_AT = (1000, 2000, 500, 250)


@dataclass(frozen=True, eq=False)
class Detection:
    """A board in a picture.

    Attributes
    ----------
    found : bool
        Whether `points` are there; they may still be worse than they should be, see `problem`.
    points : ndarray, shape (N, 2)
        The board's points in px; ``(0, 0)`` is the middle of the first pixel.
    ids : ndarray, shape (N,), int
        Which of the board's points each is: the row of ``board.points()``.
    problem : str
        ``""``, or what is wrong: ``"no board"``, ``"wrong size"``, ``"other kind"`` (a checkerboard
        where dots or squares were looked for), ``"cut off"``, ``"covered"``, ``"glare"`` or
        ``"blurred"``.
    verdict : str
        The same in a sentence, with what to do.
    blur : float
        Standard deviation of the blur, px, in the middle of all corners; of dots roughly; NaN
        unless the board was found, and for separate squares.
    seen : tuple of int
        Columns and rows of what was seen instead of the board, ``(0, 0)`` if there was nothing.
    """

    found: bool
    points: Array
    ids: NDArray[np.intp]
    problem: Problem
    verdict: str
    blur: float = float("nan")
    seen: tuple[int, int] = (0, 0)

    @property
    def good(self) -> bool:
        """Whether the board was found and nothing is wrong with the picture."""
        return self.found and not self.problem


def nothing(problem: Problem, verdict: str, seen: tuple[int, int] = (0, 0)) -> Detection:
    """Return a detection without points."""
    none = np.empty((0, 2)), np.empty(0, np.intp)
    return Detection(False, *none, problem, verdict, seen=seen)


def grey_picture(image: ArrayLike) -> Picture:
    """Return a picture in grey, from 0 to 255.

    Parameters
    ----------
    image : array_like, shape (height, width) or (height, width, 3 or 4)
        `uint8`, `uint16`, or `float` from 0 to 1; RGB.

    Returns
    -------
    ndarray, shape (height, width), uint8 or float32
        Grey levels; of a float picture from 0 to 1, and of 16 bits, the same range of 255.

    Raises
    ------
    TypeError, ValueError
        If it is no such picture.
    """
    import cv2

    array = np.asarray(image)
    if array.dtype.kind not in "uf" or array.ndim not in (2, 3) or array.size == 0:
        raise TypeError(
            "image must be uint8, uint16 or float of shape (height, width) or (height, width, 3), "
            f"got {array.dtype} of shape {array.shape}"
        )
    if array.ndim == 3 and array.shape[2] not in (3, 4):
        raise ValueError(f"image must be grey or have 3 or 4 channels, got {array.shape[2]}")
    if array.dtype.kind == "f" and not np.isfinite(array).all():
        raise ValueError("image must be finite, got NaN or infinity")
    if array.dtype != np.uint8:
        full = 1.0 if array.dtype.kind == "f" else np.iinfo(array.dtype).max
        array = array.astype(np.float32) * np.float32(255 / full)
    if array.ndim == 3:
        array = cv2.cvtColor(np.ascontiguousarray(array[..., :3]), cv2.COLOR_RGB2GRAY)
    return array


def smaller_pictures(grey: Picture) -> Iterator[tuple[Grey, Array]]:
    """Yield the picture at several sizes, and how many of its pixels a new one covers each way."""
    done: set[float] = set()
    for side in LOOKED_AT:
        factor = max(1.0, max(grey.shape) / side)
        if factor in done or min(grey.shape) < 30 * factor:
            continue
        done.add(factor)
        picture, ratio = shrunk(grey, factor)
        yield np.clip(np.rint(picture), 0, 255).astype(np.uint8), ratio


def shrunk(picture: Picture, factor: float) -> tuple[Picture, Array]:
    """Return a picture that is smaller by a factor, and the exact factors across and down.

    Each pixel is the mean of those it covers.
    """
    import cv2

    height, width = picture.shape
    size = max(round(width / factor), 1), max(round(height / factor), 1)
    small = cv2.resize(picture, size, interpolation=cv2.INTER_AREA)
    return np.asarray(small), np.array([width / size[0], height / size[1]])


def in_small_size(points: Array, ratio: Array) -> Array:
    """Return points of a picture in one that is smaller; pixel centres are whole numbers."""
    return np.asarray((points + 0.5) / ratio - 0.5)


def in_full_size(points: Array, ratio: Array) -> Array:
    """Return points of a smaller picture in the original; pixel centres are whole numbers."""
    return np.asarray((points + 0.5) * ratio - 0.5)
