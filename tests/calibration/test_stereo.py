"""Two cameras at once: what comes back, and what is refused."""

import numpy as np
import pytest

from course_lib.calibration import CameraModel, board_points, calibrate, calibrate_stereo
from course_lib.calibration.judgement import reprojection_residuals, rms_error
from course_lib.transforms import compose, rotation_from_vector
from data_generators.board_observations import observe_board

SIZE = (640, 480)
LEFT = np.array([[700.0, 0, 330], [0, 720, 250], [0, 0, 1]])
RIGHT = np.array([[680.0, 0, 310], [0, 690, 240], [0, 0, 1]])
k_LEFT, k_RIGHT = np.array([-0.25, 0.1, 0.001, -8e-4, 0]), np.array([-0.2, 0.05, -0.001, 5e-4, 0])
BOARD = board_points(8, 6, 30)
R, t = rotation_from_vector([0.02, -0.15, 0.01]), np.array([-80.0, 3, 12])


def observe(noise=0.0, views=8):
    rng = np.random.default_rng(0)
    left = observe_board(rng, BOARD, LEFT, k_LEFT, SIZE, views, noise)
    nothing = np.zeros((len(BOARD), 2))
    right = [
        reprojection_residuals(BOARD, nothing, RIGHT, *compose(R, t, *pose), k_RIGHT)
        + rng.normal(0, noise, nothing.shape)
        for pose in left.poses
    ]
    return left, right


def test_truth_comes_back():
    left, right = observe()
    found = calibrate_stereo(BOARD, left.pixels, right, SIZE)
    assert found.rms < 1e-6
    np.testing.assert_allclose(found.R, R, atol=1e-7)
    np.testing.assert_allclose(found.t, t, atol=1e-4)
    np.testing.assert_allclose(found.K_left, LEFT, atol=1e-4)
    np.testing.assert_allclose(found.K_right, RIGHT, atol=1e-4)
    np.testing.assert_allclose(found.coefficients_right, k_RIGHT, atol=1e-4)
    np.testing.assert_allclose(found.poses[3][1], left.poses[3][1], atol=1e-3)


def test_together_is_more_certain_than_alone():
    left, right = observe(noise=0.3)
    found = calibrate_stereo(BOARD, left.pixels, right, SIZE)
    alone = calibrate(BOARD, left.pixels, SIZE)
    assert found.sigma["left fx"] < alone.sigma["fx"]
    assert rms_error(np.concatenate(found.residuals_left)) > alone.rms  # fewer poses to fit with
    both = np.concatenate([*found.residuals_left, *found.residuals_right])
    assert found.rms == pytest.approx(rms_error(both), rel=1e-9)
    assert found.rms == pytest.approx(0.3 * np.sqrt(2), rel=0.05)


def numbers(K, k):
    return [*K[[0, 1, 0, 1], [0, 1, 2, 2]], *k[:4]]


def test_sigma_is_honest():
    """Over many calibrations the error of each number is as large as its sigma says."""
    clean, clean_right = observe(views=5)
    rng, pulls = np.random.default_rng(1), []
    model = CameraModel(coefficients=("k1", "k2", "p1", "p2"))
    truth = np.array([*numbers(LEFT, k_LEFT), *numbers(RIGHT, k_RIGHT), *t])
    for _ in range(200):
        left, right = (
            [p + rng.normal(0, 0.3, p.shape) for p in side] for side in (clean.pixels, clean_right)
        )
        found = calibrate_stereo(BOARD, left, right, SIZE, model)
        two = numbers(found.K_left, found.coefficients_left)
        two += numbers(found.K_right, found.coefficients_right)
        sigma = [value for name, value in found.sigma.items() if not name.startswith("turn")]
        pulls.append((np.array([*two, *found.t]) - truth) / sigma)
    squares = np.square(pulls).mean(axis=0)
    # 200 runs tell a scatter to 5 % (one standard deviation).
    np.testing.assert_allclose(np.sqrt(squares), 1, atol=0.15)
    assert np.sqrt(squares.mean()) == pytest.approx(1, abs=0.05)


def test_different_models_and_errors():
    left, right = observe(noise=0.1)
    found = calibrate_stereo(BOARD, left.pixels, right, SIZE, CameraModel(coefficients=("k1",)))
    assert len(found.sigma) == len(found.covariance) == 5 + 5 + 6
    with pytest.raises(ValueError, match="8 left and 7 right views"):
        calibrate_stereo(BOARD, left.pixels, right[:7], SIZE)
