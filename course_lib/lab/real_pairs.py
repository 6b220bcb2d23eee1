"""Is the ± honest? Lengths on a real board and between boards, in photographs held out."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from course_lib.boards import Checkerboard
from course_lib.calibration import (
    Calibration,
    CameraModel,
    StereoCalibration,
    calibrate,
    calibrate_stereo,
)
from course_lib.data import fetch
from course_lib.detection import detect_board
from course_lib.drawing import lab as draw
from course_lib.measuring import (
    Measured,
    View,
    cameras_apart,
    distance_in_space,
    target_offsets,
    target_shift,
    view_of_target,
    views_of_pair,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Floats = NDArray[np.float64]

#: The board of OpenCV's pairs, squares of 30 mm; there is no pair 10.
BOARD = Checkerboard(9, 6, 30.0)
NUMBERS = (*range(1, 10), *range(11, 15))
SIZE = (640, 480)
#: Corners at both ends of the board's diagonals.
DIAGONALS = ((0, 53), (8, 45))
SIDES = ("left", "right")
MODEL = CameraModel(coefficients=("k1", "k2", "p1", "p2"))


@dataclass(frozen=True)
class Checked:
    """A length whose truth is known.

    Attributes
    ----------
    pair : int
        Number of the pair; the cameras were calibrated with all others.
    length : Measured
        By the cameras, mm.
    truth : float
        By the squares of the board, mm.
    """

    pair: int
    length: Measured
    truth: float

    @property
    def off(self) -> float:
        """Measured minus true, mm."""
        return self.length.value - self.truth

    @property
    def holds(self) -> bool:
        """Whether the truth lies within the interval of 95 %."""
        return self.length.holds(self.truth)


@dataclass(frozen=True)
class Compared:
    """A length that was measured twice, with nothing in common, and whose truth nobody knows.

    Attributes
    ----------
    pairs : tuple of int
        Numbers of the pairs; the cameras were calibrated with all others.
    one, other : Measured
        Both results, mm.
    """

    pairs: tuple[int, ...]
    one: Measured
    other: Measured

    @property
    def ratio(self) -> float:
        """How far both are apart, by what both ± make together; below 1 they agree."""
        apart = abs(self.one.value - self.other.value)
        return float(apart / np.hypot(self.one.plus_minus, self.other.plus_minus))


def measure_real_pairs() -> list[Checked]:
    """Measure both diagonals of a real board with each pair of photographs.

    Returns
    -------
    list of Checked
        Two for each of 13 pairs, measured by cameras that were calibrated with the other 12.

    Raises
    ------
    Unavailable
        If a photograph is not here and cannot be downloaded.
    """
    points = BOARD.points()
    checked = []
    for number in NUMBERS:
        left, right = (_others(side, number) for side in SIDES)
        rig = calibrate_stereo(points, left, right, SIZE, MODEL)
        seen = np.stack([corners(side)[NUMBERS.index(number)] for side in SIDES])
        for one, other in DIAGONALS:
            truth = float(np.linalg.norm(points[one] - points[other]))
            checked.append(Checked(number, _length(rig, seen[:, one], seen[:, other]), truth))
    return checked


def measure_shifts() -> list[Compared]:
    """Measure how far the board moved from each pair to each other one, by either camera alone.

    Returns
    -------
    list of Compared
        The way of the board's middle by the left camera and by the right one, each calibrated
        without the two pictures that it measures in; 78 times.

    Raises
    ------
    Unavailable
        If a photograph is not here and cannot be downloaded.
    """
    found = []
    for two in combinations(NUMBERS, 2):
        ways = []
        for side in SIDES:
            camera = calibrate(BOARD.points(), _others(side, *two), SIZE, MODEL)
            before, after = (_view(side, number, camera) for number in two)
            ways.append(target_shift(before, after))
        found.append(Compared(two, ways[0], ways[1]))
    return found


def measure_baselines() -> list[Compared]:
    """Measure how far apart both cameras stand, from each pair of pictures and from all others.

    Returns
    -------
    list of Compared
        By the board in both pictures of a pair, each camera calibrated by itself with the other
        12; and by both cameras calibrated together with these 12.

    Raises
    ------
    Unavailable
        If a photograph is not here and cannot be downloaded.
    """
    found, points = [], BOARD.points()
    for number in NUMBERS:
        left, right = (_others(side, number) for side in SIDES)
        one, other = (
            _view(side, number, calibrate(points, pixels, SIZE, MODEL))
            for side, pixels in zip(SIDES, (left, right), strict=True)
        )
        rig = calibrate_stereo(points, left, right, SIZE, MODEL)
        found.append(Compared((number,), cameras_apart(one, other), _baseline(rig)))
    return found


def _others(side: str, *left_out: int) -> list[Floats]:
    """Return the corners in all pictures of a camera but some."""
    return [p for p, n in zip(corners(side), NUMBERS, strict=True) if n not in left_out]


def _view(side: str, number: int, camera: Calibration) -> View:
    """Return a picture of the board by a camera that was calibrated with others."""
    seen = corners(side)[NUMBERS.index(number)]
    return view_of_target(BOARD.points(), seen, camera, _unevenness(side))


@cache
def _unevenness(side: str) -> float:
    """Return how far the board's corners are from where they should be, as a camera sees it, mm."""
    points, seen = BOARD.points(), corners(side)
    offsets = target_offsets(calibrate(points, seen, SIZE, MODEL), points, seen)
    return float(np.sqrt(np.mean(offsets**2)))


def _baseline(rig: StereoCalibration) -> Measured:
    """Return how far apart the cameras of a pair stand; its shift is the last of its numbers."""
    value = float(np.linalg.norm(rig.t))
    along = rig.t / value
    variance = along @ rig.covariance[-3:, -3:] @ along
    return Measured(value, {"camera": float(np.sqrt(variance))})


def _length(rig: StereoCalibration, one: Floats, other: Floats) -> Measured:
    """Return a distance; corners are pointed at as well as those that the rig comes from."""
    return distance_in_space(one, other, views_of_pair(rig), pointing=rig.rms / np.sqrt(2))


@cache
def corners(side: str) -> tuple[Floats, ...]:
    """Return the corners of the board in all pictures of one camera."""
    import cv2

    found = []
    for number in NUMBERS:
        file = np.fromfile(fetch(f"opencv_stereo/{side}{number:02}.jpg"), np.uint8)
        picture = np.asarray(cv2.imdecode(file, cv2.IMREAD_GRAYSCALE), np.uint8)
        found.append(detect_board(picture, BOARD).points)
    return tuple(found)


def honest(checked: list[Checked]) -> Figure:
    """Show how far all lengths are off, and their intervals."""
    return draw.off_by(
        [f"{c.pair}" for c in checked],
        [c.off for c in checked],
        [c.length.plus_minus for c in checked],
    )
