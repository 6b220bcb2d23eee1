import numpy as np
import pytest

from course_lib.camera import camera_matrix, project
from course_lib.checks import DegenerateConfigurationError
from course_lib.orientation import poses_from_three_points, resect_camera, resect_robustly
from course_lib.transforms.exponential import rotation_from_vector

K = np.array([[800, 2, 320], [0, 810, 240], [0, 0, 1.0]])


@pytest.fixture
def rng():
    return np.random.default_rng(12)


def scene(rng, count, flat=False):
    """Return a pose, points in front of it, and their pixels."""
    R = rotation_from_vector(rng.standard_normal(3))
    t = np.array([0, 0, 4]) + rng.uniform(-0.5, 0.5, 3)
    X = rng.uniform(-1, 1, (count, 3)) * [1, 1, not flat]
    return R, t, X, project(X, camera_matrix(K, R, t))


def test_three_points_give_every_pose_that_sees_them_so(rng):
    counts = []
    for _ in range(300):
        R, t, X, pixels = scene(rng, 3)
        poses = poses_from_three_points(X, pixels, K)
        counts.append(len(poses))
        assert min(np.abs(R - a).max() + np.abs(t - b).max() for a, b in poses) < 1e-5
        for a, b in poses:
            np.testing.assert_allclose(project(X, camera_matrix(K, a, b)), pixels, atol=1e-3)
    assert set(counts) >= {2, 3, 4}
    with pytest.raises(ValueError, match="use resect_camera"):
        poses_from_three_points(np.eye(4, 3), np.eye(4, 2), K)
    with pytest.raises(DegenerateConfigurationError, match="collinear"):
        poses_from_three_points(np.outer(range(3), [1, 1, 1]), pixels, K)


@pytest.mark.parametrize("flat", [False, True])
@pytest.mark.parametrize("count", [4, 5, 6, 30])
def test_without_noise_the_pose_comes_back(rng, count, flat):
    for _ in range(5):
        R, t, X, pixels = scene(rng, count, flat)
        found = resect_camera(X, pixels, K)
        np.testing.assert_allclose(found.R, R, rtol=0, atol=1e-6)
        np.testing.assert_allclose(found.centre, -R.T @ t, rtol=0, atol=1e-6)


@pytest.mark.parametrize("flat", [False, True])
def test_with_noise_the_fit_is_better_than_the_truth(rng, flat):
    for count in (4, 5, 6, 12):
        for _ in range(10):
            _, _, X, pixels = scene(rng, count, flat)
            noise = 0.3 * rng.standard_normal(pixels.shape)
            found = resect_camera(X, pixels + noise, K)
            assert (found.residuals**2).sum() <= (noise**2).sum()


def test_the_covariance_is_the_scatter(rng):
    R, t, X, pixels = scene(rng, 20)
    centres, reported = [], []
    for _ in range(150):
        found = resect_camera(X, pixels + 0.3 * rng.standard_normal(pixels.shape), K)
        centres.append(found.centre + R.T @ t)
        reported.append(np.diag(found.covariance)[3:])
    found = np.sqrt(np.mean(np.square(centres)))
    assert np.sqrt(np.mean(reported)) == pytest.approx(found, rel=0.1)


def test_wrong_pairs_are_left_out(rng):
    R, _, X, pixels = scene(rng, 60)
    pixels = pixels + 0.3 * rng.standard_normal(pixels.shape)
    wrong = np.arange(60) < 24
    pixels[wrong] = rng.uniform(0, 480, (24, 2))
    found = resect_robustly(X, pixels, K, np.random.default_rng(0), threshold=3)
    assert found.used[~wrong].mean() > 0.95
    assert found.used[wrong].sum() <= 1
    assert found.residuals.shape == (60, 2)
    np.testing.assert_allclose(found.R, R, rtol=0, atol=0.01)
    with pytest.raises(DegenerateConfigurationError, match="agreed on by four"):
        resect_robustly(X[:12], rng.uniform(0, 480, (12, 2)), K, rng, threshold=0.01)


def test_bad_input_is_named(rng):
    _, _, X, pixels = scene(rng, 8)
    with pytest.raises(ValueError, match="4 points or more"):
        resect_camera(X[:3], pixels[:3], K)
    with pytest.raises(DegenerateConfigurationError, match="points are collinear"):
        resect_camera(np.outer(range(8), [1, 2, 3]), pixels, K)
    with pytest.raises(DegenerateConfigurationError, match="pixels are collinear"):
        resect_camera(X, np.outer(range(8), [1, 2]), K)
    with pytest.raises(ValueError, match="K must be"):
        resect_camera(X, pixels, np.zeros((3, 3)))
