"""Views that do not determine a camera, or are none: what the message says to do."""

import numpy as np
import pytest
from board_views import BOARD, SIZE, K, observe

from course_lib.calibration import CameraModel, board_points, calibrate
from course_lib.checks import DegenerateConfigurationError


def test_parallel_boards():
    seen = observe(tilt=0, k=[0])
    with pytest.raises(DegenerateConfigurationError, match="all boards are parallel"):
        calibrate(BOARD, seen.pixels, SIZE)


@pytest.mark.parametrize("seed", range(5))
def test_nearly_parallel_boards_with_noise(seed):
    """What noise makes of such views is no camera, and the message says what to do."""
    seen = observe(seed, tilt=0.01, noise=0.3, views=5)
    with pytest.raises(DegenerateConfigurationError, match="tilt the board by 20° to 45°"):
        calibrate(BOARD, seen.pixels, SIZE)


@pytest.mark.parametrize("seed", range(5))
def test_small_tilts_give_a_large_sigma(seed):
    found = calibrate(BOARD, observe(seed, tilt=0.1, noise=0.3, views=5).pixels, SIZE)
    assert found.sigma["fx"] > 5
    assert abs(found.K[0, 0] - K[0, 0]) < 4 * found.sigma["fx"]


def test_the_better_of_two_minima():
    """Small tilts: from the closed form one comes to rest at f = 1659 px, RMS 0.51 px."""
    found = calibrate(BOARD, observe(3, tilt=0.03, noise=0.3, views=5).pixels, SIZE)
    assert found.rms < 0.4
    assert abs(found.K[0, 0] - K[0, 0]) < 4 * found.sigma["fx"]


def test_too_few_views():
    pixels = observe().pixels
    with pytest.raises(DegenerateConfigurationError, match="there are no views"):
        calibrate(BOARD, [], SIZE)
    with pytest.raises(DegenerateConfigurationError, match="2 or more different views, got 1"):
        calibrate(BOARD, pixels[:1], SIZE)
    with pytest.raises(DegenerateConfigurationError, match="but some are the same"):
        calibrate(BOARD, [pixels[0]] * 5, SIZE)
    with pytest.raises(DegenerateConfigurationError, match="3 or more different views, got 2"):
        calibrate(BOARD, pixels[:2], SIZE, CameraModel(skew=True))


def test_too_few_points():
    pixels = observe().pixels
    four = [0, 7, 40, 47]
    with pytest.raises(DegenerateConfigurationError, match="16 equations, but there are 21"):
        calibrate(BOARD[four], [p[four] for p in pixels[:2]], SIZE)
    with pytest.raises(DegenerateConfigurationError, match="the board has 3 points"):
        calibrate(BOARD[[0, 1, 8]], [p[[0, 1, 8]] for p in pixels], SIZE)


def test_board_of_another_size():
    pixels = observe().pixels
    with pytest.raises(ValueError, match="view 0 has 48 pixels, but its board has 54 points"):
        calibrate(board_points(9, 6, 30), pixels, SIZE)
    with pytest.raises(DegenerateConfigurationError, match="columns and rows swapped"):
        calibrate(board_points(6, 8, 30), pixels, SIZE)
    with pytest.raises(ValueError, match="got 2 boards and 8 views"):
        calibrate([BOARD, BOARD], pixels, SIZE)


def test_boards_that_are_none():
    pixels = observe().pixels
    with pytest.raises(DegenerateConfigurationError, match="is the side of a square 0"):
        calibrate(0 * BOARD, pixels, SIZE)
    with pytest.raises(DegenerateConfigurationError, match="lie on one line"):
        calibrate(BOARD * [1, 0, 0], pixels, SIZE)
    with pytest.raises(DegenerateConfigurationError, match="is not flat"):
        calibrate(BOARD + [0, 0, 1] * BOARD[:, :1], pixels, SIZE)


def test_one_shuffled_view_is_named():
    pixels = observe().pixels
    pixels[3] = pixels[3][::-1].copy()  # a half turn is a picture of the board as well
    calibrate(BOARD, pixels, SIZE)
    pixels[3] = np.random.default_rng(0).permutation(pixels[3])
    with pytest.raises(DegenerateConfigurationError, match="pixels of view 3 are no picture"):
        calibrate(BOARD, pixels, SIZE)


def test_a_view_on_a_line_is_named():
    pixels = observe().pixels
    pixels[5] = pixels[5] * [1, 0]
    with pytest.raises(DegenerateConfigurationError, match="view 5 has no homography"):
        calibrate(BOARD, pixels, SIZE)


def test_bad_numbers():
    pixels = observe().pixels
    pixels[2] = pixels[2].copy()
    pixels[2][5] = np.nan
    with pytest.raises(ValueError, match="the pixels of view 2 must be finite, got NaN"):
        calibrate(BOARD, pixels, SIZE)
    with pytest.raises(ValueError, match="put a single view into a list"):
        calibrate(BOARD, pixels[0], SIZE)
    with pytest.raises(TypeError, match="image_points must be a sequence"):
        calibrate(BOARD, 5, SIZE)
    with pytest.raises(ValueError, match="all pixels of view 0 are the same"):
        calibrate(BOARD, [0 * p for p in pixels[:2]], SIZE)
    with pytest.raises(ValueError, match="image_size"):
        calibrate(BOARD, pixels[:2], (0, 480))
