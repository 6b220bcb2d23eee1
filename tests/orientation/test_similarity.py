import numpy as np
import pytest

from course_lib.checks import DegenerateConfigurationError
from course_lib.orientation import (
    check_point_rmse,
    leave_one_out,
    pictures_for_circle,
    similarity_transform,
)
from course_lib.transforms.exponential import rotation_from_vector


@pytest.fixture
def rng():
    return np.random.default_rng(11)


@pytest.mark.parametrize("count", [3, 4, 50])
@pytest.mark.parametrize("flat", [False, True])
def test_a_similarity_comes_back(rng, count, flat):
    points = rng.uniform(-5, 5, (count, 3)) * [1, 1, not flat] + [1e5, -2e5, 300]
    R, t = rotation_from_vector(rng.standard_normal(3)), np.array([3, 4, -5e5])
    found = similarity_transform(points, 2.5 * points @ R.T + t)
    assert found.scale == pytest.approx(2.5, rel=1e-9)
    np.testing.assert_allclose(found.R, R, rtol=0, atol=1e-8)
    np.testing.assert_allclose(found.apply(points), 2.5 * points @ R.T + t, rtol=0, atol=1e-6)
    np.testing.assert_allclose(found.inverse().apply(found.apply(points)), points, atol=1e-6)


def test_it_has_the_smallest_sum_of_squares(rng):
    points, noise = rng.uniform(-5, 5, (8, 3)), rng.standard_normal((8, 3))
    weights = rng.uniform(0.2, 5, 8)
    targets = 1.7 * points + [1, 2, 3] + noise
    best = similarity_transform(points, targets, weights)

    def cost(turn, move, scale):
        R = rotation_from_vector(turn) @ best.R
        away = best.scale * scale * points @ R.T + best.t + move - targets
        return float(weights @ (away**2).sum(axis=1))

    least = cost(np.zeros(3), np.zeros(3), 1)
    for _ in range(50):
        turn, move = 1e-3 * rng.standard_normal((2, 3))
        assert cost(turn, move, 1 + 1e-3 * rng.standard_normal()) > least


def test_without_a_scale_lengths_stay(rng):
    points = rng.uniform(-5, 5, (8, 3))
    found = similarity_transform(points, 3 * points, scaled=False)
    assert found.scale == 1
    np.testing.assert_allclose(found.R, np.eye(3), rtol=0, atol=1e-12)


def test_noise_never_makes_a_reflection(rng):
    flat = rng.uniform(-5, 5, (5, 3)) * [1, 1, 1e-3]
    for _ in range(200):
        targets = flat + 0.05 * rng.standard_normal(flat.shape)
        assert np.linalg.det(similarity_transform(flat, targets).R) == pytest.approx(1)


def test_mirrored_control_points_are_named(rng):
    points = rng.uniform(0, 50, (6, 3))
    swapped = points[:, [1, 0, 2]] + 0.02 * rng.standard_normal(points.shape)
    with pytest.raises(DegenerateConfigurationError, match="mirror image"):
        similarity_transform(points, swapped)
    with pytest.raises(DegenerateConfigurationError, match="collinear"):
        similarity_transform(np.outer(range(4), [1, 2, 3]), points[:4])
    with pytest.raises(ValueError, match="3 points or more"):
        similarity_transform(points[:2], points[:2])
    with pytest.raises(ValueError, match="weights must be 6 positive"):
        similarity_transform(points, points, np.zeros(6))


def test_control_points_flatter_and_others_do_not(rng):
    plan = rng.uniform(0, 100, (4, 3)) * [1, 1, 0.1]
    checks = rng.uniform(0, 100, (100, 3)) * [1, 1, 0.1]
    ratio, alone = [], []
    for _ in range(40):
        model = 0.1 * rng.standard_normal(plan.shape) + plan
        found = similarity_transform(model, plan)
        control = check_point_rmse(found.apply(model), plan).total
        check = check_point_rmse(
            found.apply(checks + 0.1 * rng.standard_normal(checks.shape)), checks
        )
        ratio.append(check.total / control)
        alone.append(np.sqrt((leave_one_out(model, plan) ** 2).sum(axis=1).mean()) / control)
    assert np.median(ratio) > 1.3
    assert np.median(alone) > 1.3


def test_rmse_by_hand():
    found = check_point_rmse([[1, 0, 0], [0, 2, 4]], np.zeros((2, 3)))
    wanted = np.sqrt(np.array([1, 4, 16, 5, 21]) / 2)
    np.testing.assert_allclose(found, wanted)
    with pytest.raises(ValueError, match="belong together"):
        check_point_rmse(np.zeros((2, 3)), np.zeros((3, 3)))


@pytest.mark.parametrize(("degrees", "count"), [(10, 36), (360, 1), (11, 33), (7.2, 50), (1, 360)])
def test_pictures_all_around(degrees, count):
    assert pictures_for_circle(np.deg2rad(degrees)) == count


def test_degrees_are_noticed():
    with pytest.raises(ValueError, match="is it in degrees"):
        pictures_for_circle(10)
