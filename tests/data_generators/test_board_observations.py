import numpy as np
import pytest

from course_lib.calibration import board_points, board_tilts, reprojection_residuals
from data_generators.board_observations import observe_board

SIZE = (640, 480)
K = np.array([[700.0, 0, 330], [0, 720, 250], [0, 0, 1]])
k = np.array([-0.25, 0.1, 0.001, -0.0008, 0.02])
BOARD = board_points(8, 6, 30)


def observe(seed=0, views=5, **how):
    return observe_board(np.random.default_rng(seed), BOARD, K, k, SIZE, views, **how)


def test_pixels_are_those_of_the_poses():
    seen = observe()
    assert len(seen.pixels) == len(seen.poses) == 5
    for pixels, pose in zip(seen.pixels, seen.poses, strict=True):
        np.testing.assert_allclose(reprojection_residuals(BOARD, pixels, K, *pose, k), 0, atol=1e-9)
        assert (pixels >= 0).all()
        assert (pixels <= np.array(SIZE) - 1).all()


def test_noise_is_as_large_as_asked():
    seen = observe(views=40, noise=0.3)
    left = [
        reprojection_residuals(BOARD, pixels, K, *pose, k)
        for pixels, pose in zip(seen.pixels, seen.poses, strict=True)
    ]
    assert np.std(left) == pytest.approx(0.3, rel=0.05)


def test_tilt():
    assert board_tilts(observe(tilt=0).poses)[0].max() < 1e-6
    assert np.degrees(board_tilts(observe(views=30).poses)[0]).mean() > 15


def test_same_generator_same_views():
    np.testing.assert_array_equal(observe(3, noise=1).pixels, observe(3, noise=1).pixels)


def test_errors():
    with pytest.raises(ValueError, match="noise must not be negative"):
        observe(noise=-1)
    with pytest.raises(ValueError, match="does not come wholly into the picture"):
        observe_board(np.random.default_rng(0), BOARD, K, k, (640, 20), views=1)
