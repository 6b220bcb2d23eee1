"""Lengths on a real board, in pictures that the cameras were not calibrated with."""

from functools import cache
from itertools import combinations
from types import SimpleNamespace

import cv2
import numpy as np
import pytest
from real_data import fetched

from course_lib.boards import Checkerboard
from course_lib.calibration import calibrate, calibrate_stereo
from course_lib.detection import detect_board
from course_lib.measuring import (
    distance_in_space,
    distance_on_plane,
    rays_miss,
    target_offsets,
    view_of_target,
    views_of_pair,
)

BOARD = Checkerboard(9, 6, 30.0)
POINTS, SIZE = BOARD.points(), (640, 480)
NUMBERS = [n for n in range(1, 15) if n != 10]
COLUMN, ROW = np.arange(54) % 9, np.arange(54) // 9
#: On the plane, the left columns of the board are the target, the others the object.
TARGET, OBJECT = np.flatnonzero(COLUMN < 5), np.flatnonzero(COLUMN >= 5)
LONG = 100.0  # mm


def truth(i, j):
    return float(np.linalg.norm(POINTS[i] - POINTS[j]))


def squares(points):
    return [(i, j) for i, j in combinations(points, 2) if truth(i, j) < 31]


def far_apart(points):
    return [(i, j) for i, j in combinations(points, 2) if truth(i, j) > LONG]


@cache
def corners(side, number):
    path = str(fetched(f"opencv_stereo/{side}{number:02d}.jpg"))
    found = detect_board(cv2.imread(path, cv2.IMREAD_GRAYSCALE), BOARD)
    assert found.good
    return found.points


def others(side, *left_out):
    return [corners(side, n) for n in NUMBERS if n not in left_out]


@cache
def in_space(number):
    """Measure the board in one pair by cameras that were calibrated with the other twelve."""
    pair = calibrate_stereo(POINTS, others("left", number), others("right", number), SIZE)
    views, pixels = (
        views_of_pair(pair),
        np.stack([corners("left", number), corners("right", number)]),
    )
    # What is left over at the corners of a calibration is how well they are pointed at.
    pointing = pair.rms / np.sqrt(2)
    lengths = {
        (i, j): distance_in_space(pixels[:, i], pixels[:, j], views, pointing)
        for i, j in squares(range(54))[::2] + far_apart(range(54))[::20]
    }
    return SimpleNamespace(lengths=lengths, miss=rays_miss(pixels, views), pointing=pointing)


@cache
def on_plane(number, evenly=False, side="left"):
    """Measure the right columns of the board beside the left ones, in one picture."""
    camera = calibrate(POINTS, others(side, number), SIZE)
    uneven = float(np.sqrt(np.mean(target_offsets(camera, POINTS, others(side, number)) ** 2)))
    pixels = corners(side, number)
    view = view_of_target(POINTS[TARGET], pixels[TARGET], camera, 0.0 if evenly else uneven)
    pointing = camera.rms / np.sqrt(2)
    lengths = {
        (i, j): distance_on_plane(pixels[i], pixels[j], view, pointing)
        for i, j in squares(OBJECT) + far_apart(OBJECT)[::2]
    }
    return SimpleNamespace(lengths=lengths, uneven=uneven)


def share(lengths, least=0.0, most=np.inf):
    """Return how many of the true values the reported intervals hold."""
    chosen = {ends: length for ends, length in lengths.items() if least < truth(*ends) < most}
    return np.mean([length.holds(truth(*ends)) for ends, length in chosen.items()])


@pytest.fixture(scope="module", autouse=True)
def _photographs():
    for number in NUMBERS:
        corners("left", number), corners("right", number)


class TestInSpace:
    def test_the_true_value_is_within_the_interval_in_nine_pairs_of_ten(self):
        held = {n: share(in_space(n).lengths) for n in NUMBERS}
        assert np.mean([value >= 0.9 for value in held.values()]) >= 0.9
        assert np.mean([share(in_space(n).lengths, most=31) for n in NUMBERS]) >= 0.95
        assert np.mean([share(in_space(n).lengths, least=LONG) for n in NUMBERS]) >= 0.9

    def test_the_pair_that_is_off_says_so_itself(self):
        """The board was held by hand, and moved between the two exposures of pair 8."""
        off = [n for n in NUMBERS if share(in_space(n).lengths) < 0.9]
        assert off == [8]
        misses = {n: in_space(n).miss for n in NUMBERS}
        assert max(misses, key=misses.__getitem__) == 8
        assert misses[8] > 2.5 * np.median(list(misses.values()))

    def test_how_far_off(self):
        errors = [
            length.value - truth(*ends)
            for n in NUMBERS
            for ends, length in in_space(n).lengths.items()
            if n != 8 and truth(*ends) < 31
        ]
        assert np.sqrt(np.mean(np.square(errors))) < 0.15  # mm of 30
        assert abs(np.mean(errors)) < 0.05


class TestOnThePlane:
    def test_the_true_value_is_within_the_interval_in_nine_pictures_of_ten(self):
        assert np.mean([share(on_plane(n).lengths) >= 0.9 for n in NUMBERS]) >= 0.9
        assert np.mean([share(on_plane(n).lengths, most=31) for n in NUMBERS]) >= 0.95
        assert np.mean([share(on_plane(n).lengths, least=LONG) for n in NUMBERS]) >= 0.9

    def test_because_the_target_is_known_to_be_uneven(self):
        """Paper on a clipboard: 0.08 mm in each direction; without it the interval is too small."""
        assert 0.07 < np.mean([on_plane(n).uneven for n in NUMBERS]) < 0.09
        assert np.mean([share(on_plane(n, True).lengths, least=LONG) for n in NUMBERS]) < 0.8

    def test_picture_4_is_off_as_one_in_thirteen_may_be_and_the_other_camera_agrees(self):
        """Long lengths of one picture share its pose and its board, and are off together.

        So of 13 pictures one is expected to be off by about two σ with most of its long lengths:
        it is picture 4, where half of them are 0.4 mm too long. Both cameras see that, so it is
        the board, which is bent a little differently in each picture, and not its corners.
        """

        def off(number, side):
            found = on_plane(number, side=side).lengths.items()
            far = [(length, truth(*ends)) for ends, length in found if truth(*ends) > LONG]
            return np.mean([(length.value - true) / length.sigma for length, true in far])

        left, right = (np.array([off(n, side) for n in NUMBERS]) for side in ("left", "right"))
        for by_sigma in (left, right):
            assert np.sqrt(np.mean(by_sigma**2)) == pytest.approx(1, abs=0.2)
            assert abs(by_sigma).max() < 2.1
        assert NUMBERS[left.argmax()] == 4
        assert 0.4 < share(on_plane(4).lengths, least=LONG) < 0.6
        assert np.corrcoef(left, right)[0, 1] > 0.7

    def test_both_cameras_see_the_same_unevenness(self):
        seen = []
        for side in ("left", "right"):
            camera = calibrate(POINTS, others(side), SIZE)
            seen.append(target_offsets(camera, POINTS, others(side)))
        for one, other in zip(*(offsets.T for offsets in seen), strict=True):
            assert np.corrcoef(one, other)[0, 1] > 0.85
