"""Is the ± honest? Lengths on a real board, by pairs of photographs that were held out."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from course_lib.boards import Checkerboard
from course_lib.calibration import CameraModel, StereoCalibration, calibrate_stereo
from course_lib.data import fetch
from course_lib.detection import detect_board
from course_lib.drawing import lab as draw
from course_lib.measuring import Measured, distance_in_space, views_of_pair

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Floats = NDArray[np.float64]

#: The board of OpenCV's pairs, squares of 30 mm; there is no pair 10.
BOARD = Checkerboard(9, 6, 30.0)
NUMBERS = (*range(1, 10), *range(11, 15))
SIZE = (640, 480)
#: Corners at both ends of the board's diagonals.
DIAGONALS = ((0, 53), (8, 45))
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
    left, right = (corners(side) for side in ("left", "right"))
    points = BOARD.points()
    checked = []
    for held_out, number in enumerate(NUMBERS):
        others = [k for k in range(len(NUMBERS)) if k != held_out]
        rig = calibrate_stereo(
            points, [left[k] for k in others], [right[k] for k in others], SIZE, MODEL
        )
        seen = np.stack([left[held_out], right[held_out]])
        for one, other in DIAGONALS:
            truth = float(np.linalg.norm(points[one] - points[other]))
            checked.append(Checked(number, _length(rig, seen[:, one], seen[:, other]), truth))
    return checked


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
