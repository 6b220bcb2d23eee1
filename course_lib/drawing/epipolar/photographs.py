"""Real pairs of pictures: a stereo camera before a board, a motorcycle, and a painted wall."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib import data
from course_lib.calibration import StereoCalibration, calibrate_stereo
from course_lib.detection import detect_board
from course_lib.distortion import undistort_pixels
from course_lib.drawing.calibration.photographs import (
    BOARD,
    LENS,
    SIZE,
    K,
    computed_photograph,
    grey_file,
)
from course_lib.drawing.distortion.boards import PHOTOGRAPHS
from course_lib.drawing.triangulation import pair
from course_lib.transforms import rotation_from_vector
from data_generators.board_observations import observe_board

Floats = NDArray[np.float64]
Grey = NDArray[np.uint8]
Colour = NDArray[np.uint8]
#: px: so far from the edge of both computed pictures a whole board must stay.
EDGE = 12


@dataclass(frozen=True, eq=False)
class StereoBoards:
    """Thirteen pairs of photographs of a board by two cameras that are fixed to each other.

    Attributes
    ----------
    left, right : tuple of ndarray, shape (480, 640), uint8
        The photographs.
    left_corners, right_corners : ndarray, shape (13, 54, 2)
        The corners in each, as found, px.
    calibration : StereoCalibration
        Both cameras, and how one stands to the other; mm.
    """

    left: tuple[Grey, ...]
    right: tuple[Grey, ...]
    left_corners: Floats
    right_corners: Floats
    calibration: StereoCalibration

    def straight_corners(self) -> tuple[Floats, Floats]:
        """Return all corners freed from distortion, (702, 2), px: those on the left and right."""
        c = self.calibration
        left = undistort_pixels(self.left_corners.reshape(-1, 2), c.K_left, c.coefficients_left)
        right = undistort_pixels(self.right_corners.reshape(-1, 2), c.K_right, c.coefficients_right)
        return left, right

    def straightened(self, view: int) -> tuple[Grey, Grey]:
        """Return both photographs of a pair without distortion."""
        import cv2

        c = self.calibration
        left = cv2.undistort(self.left[view], c.K_left, c.coefficients_left)
        right = cv2.undistort(self.right[view], c.K_right, c.coefficients_right)
        return np.asarray(left, np.uint8), np.asarray(right, np.uint8)


@cache
def stereo_boards() -> StereoBoards:
    """Return the thirteen pairs with their corners and the calibration.

    Returns
    -------
    StereoBoards
        Photographs, corners and cameras.

    Raises
    ------
    Unavailable
        If one of them is not here and cannot be downloaded.
    """
    names = PHOTOGRAPHS, [name.replace("left", "right") for name in PHOTOGRAPHS]
    left, right = (tuple(grey_file(name) for name in side) for side in names)
    return _calibrated(left, right)


@cache
def computed_boards() -> StereoBoards:
    """Return thirteen computed pairs, which stand in for the photographs where there are none.

    Returns
    -------
    StereoBoards
        Photographs by two equal cameras 100 mm apart, corners and calibration.
    """
    rng = np.random.default_rng(11)
    R, t = rotation_from_vector((0.007, 0.004, -0.003)), np.array([-100.0, 1, 0])
    made: list[tuple[Grey, Grey]] = []
    seen = observe_board(rng, BOARD.points(), K, LENS, SIZE, views=120, tilt=0.35)
    for Q, q in seen.poses:
        poses = (Q, q), (R @ Q, R @ q + t)
        corners = np.array([(BOARD.points() @ A.T + a) @ K.T for A, a in poses])
        pixels = corners[..., :2] / corners[..., 2:]
        if min(pixels.min(), (SIZE - pixels).min()) > EDGE and len(made) < len(PHOTOGRAPHS):
            left, right = (computed_photograph(A, a, rng) for A, a in poses)
            made.append((left, right))
    return _calibrated(*zip(*made, strict=True))


def _calibrated(left: tuple[Grey, ...], right: tuple[Grey, ...]) -> StereoBoards:
    """Find the corners of pairs of photographs, and calibrate both cameras together."""
    ours, theirs = (np.array([detect_board(p, BOARD).points for p in s]) for s in (left, right))
    found = calibrate_stereo(BOARD.points(), list(ours), list(theirs), SIZE)
    return StereoBoards(left, right, ours, theirs, found)


def motorcycle() -> tuple[Colour, Colour]:
    """Return the two pictures of the Middlebury motorcycle, rectified, shape (500, 741, 3)."""
    both = pair.motorcycle()
    return both.left, both.right


@cache
def painted_wall() -> tuple[Colour, Colour]:
    """Return two pictures of a painted wall, from the front and from the side.

    Returns
    -------
    tuple of two ndarray, shape (640, 800, 3), uint8
        RGB.

    Raises
    ------
    Unavailable
        If one of them is not here and cannot be downloaded.
    """
    return _colour_file("opencv_stereo/graf1.png"), _colour_file("opencv_stereo/graf3.png")


@cache
def wall_homography() -> Floats:
    """Return the published homography of the painted wall, picture 1 to picture 2.

    Raises
    ------
    Unavailable
        If it is not here and cannot be downloaded.
    """
    text = data.fetch("opencv_stereo/H1to3p.xml").read_text(encoding="utf-8")
    numbers = text.partition("<data>")[2].partition("</data>")[0].split()
    return np.array(numbers, dtype=float).reshape(3, 3)


def _colour_file(name: str) -> Colour:
    import cv2

    picture = cv2.imdecode(np.fromfile(data.fetch(name), np.uint8), cv2.IMREAD_COLOR)
    return np.asarray(cv2.cvtColor(np.asarray(picture), cv2.COLOR_BGR2RGB), np.uint8)
