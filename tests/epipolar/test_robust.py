"""Matches of which many are wrong."""

import tracemalloc

import numpy as np
import pytest
from two_views import K, angle_between, scene, turn_between

from course_lib.checks import DegenerateConfigurationError
from course_lib.epipolar import (
    ransac_fundamental,
    ransac_iterations,
    ransac_pose,
    sampson_error,
)
from course_lib.homogeneous import from_homogeneous
from course_lib.transforms import rotation_about_axis


def rng(seed=0):
    return np.random.default_rng(seed)


@pytest.mark.parametrize("wrong", [0.0, 0.3, 0.6])
@pytest.mark.parametrize("seed", range(3))
def test_wrong_matches_are_found(seed, wrong):
    s = scene(seed, wrong=wrong)
    F, fits = ransac_fundamental(s.points1, s.points2, rng(seed))
    assert np.sqrt(np.mean(sampson_error(s.exact1, s.exact2, F)[s.right] ** 2)) < 0.25
    assert np.linalg.svd(F)[1][2] < 1e-15
    assert fits[s.right].mean() > 0.97  # three standard deviations
    assert fits[~s.right].sum() <= 0.05 * len(fits)  # chance brings some near their line
    np.testing.assert_array_equal(fits, sampson_error(s.points1, s.points2, F) <= 1.5)


@pytest.mark.parametrize("wrong", [0.0, 0.3, 0.6])
def test_pose_among_wrong_matches(wrong):
    s = scene(4, wrong=wrong)
    R, t, fits, *_ = ransac_pose(s.points1, s.points2, K, K, rng())
    assert turn_between(R, s.R) < 0.3
    assert angle_between(t, s.t) < 1
    assert fits[s.right].mean() > 0.97


def test_a_plane_can_do_for_calibrated_cameras():
    s = scene(2, plane=True, wrong=0.2)
    R, t, *_ = ransac_pose(s.points1, s.points2, K, K, rng())
    assert turn_between(R, s.R) < 1
    assert angle_between(t, s.t) < 3
    with pytest.raises(DegenerateConfigurationError, match="on a plane"):
        ransac_fundamental(s.points1, s.points2, rng())


def off(found, s):
    return turn_between(found.R, s.R), angle_between(found.t, s.t)


@pytest.mark.parametrize("seed", [0, 2, 4, 6])
def test_a_sound_pose_is_not_doubted(seed):
    s = scene(seed, count=200, wrong=0.3)
    found = ransac_pose(s.points1, s.points2, K, K, rng(seed))
    assert found.doubt == ""
    turn, direction = off(found, s)
    assert turn < 3 * found.turn_sigma < 0.6
    assert direction < 3 * found.direction_sigma < 1.5


@pytest.mark.parametrize("seed", range(4))
def test_two_poses_of_a_plane_are_named(seed):
    s = scene(seed, count=100, plane=True, wrong=0.2)
    found = ransac_pose(s.points1, s.points2, K, K, rng(seed))
    assert "another pose fits nearly as well" in found.doubt
    assert "the points are nearly on a plane" in found.doubt
    assert "spread over the picture and in depth" in found.doubt


def test_five_pairs_tell_nothing_of_their_errors():
    """One of six is wrong, and the five others determine a pose, whatever their errors are."""
    points = rng(4).uniform((-2, -2, 4), (2, 2, 9), (6, 3))
    R, t = rotation_about_axis((0, 1, 0), 0.1), np.array([1, 0.1, 0])
    one, other = (from_homogeneous(seen @ K.T) for seen in (points, points @ R.T + t))
    other[5] += (60, 90)
    found = ransac_pose(one, other, K, K, rng())
    assert found.fits.sum() == 5
    assert (found.turn_sigma, found.direction_sigma) == (180, 180)
    assert "only known to 180.0 degrees" in found.doubt


def test_a_pose_is_doubted_whose_tie_points_are_near_together():
    s = scene(1, count=3000, t=[0.3, 0.02, -0.01])
    near = (np.abs(s.exact1 - [150, 120]) < 60).all(axis=1)
    found = ransac_pose(s.points1[near], s.points2[near], K, K, rng())
    assert off(found, s)[1] > 3
    assert found.direction_sigma > 3
    assert "only known to" in found.doubt


def test_two_sets_of_matches_that_contradict_each_other_are_named():
    one, other = scene(0, count=110), scene(4, count=90)
    points = [
        np.concatenate(pair)
        for pair in ((one.points1, other.points1), (one.points2, other.points2))
    ]
    found = ransac_pose(*points, K, K, rng())
    assert max(off(found, one)) < 1  # most pairs are of this one
    assert "another pose fits nearly as well" in found.doubt


def test_without_a_look_for_rivals_the_generator_is_used_as_with_it():
    s = scene(5, count=100, wrong=0.3)
    quick, used = rng(3), rng(3)
    fits = ransac_pose(s.points1, s.points2, K, K, quick, rivals=False).fits
    assert (fits == ransac_pose(s.points1, s.points2, K, K, used).fits).mean() > 0.97
    assert quick.random() == used.random()


def test_a_look_for_rivals_among_many_pairs_takes_little_memory():
    s = scene(1, count=10_000, wrong=0.7)
    tracemalloc.start()
    try:
        ransac_pose(s.points1, s.points2, K, K, rng())
        assert tracemalloc.get_traced_memory()[1] < 100e6  # all errors at once: 1.8 GB
    finally:
        tracemalloc.stop()


def test_sigma_of_a_pose_is_its_scatter():
    s, noise = scene(4, count=60, noise=0.0), rng(1)
    errors, reported = [], []
    for _ in range(200):
        points = [p + 0.5 * noise.standard_normal(p.shape) for p in (s.exact1, s.exact2)]
        found = ransac_pose(*points, K, K, rng(), rivals=False)
        errors.append(off(found, s))
        reported.append([found.turn_sigma, found.direction_sigma])
    scatter, sigma = (np.sqrt(np.mean(np.square(x), axis=0)) for x in (errors, reported))
    np.testing.assert_allclose(sigma, scatter, rtol=0.1)


def test_a_turn_alone_is_named():
    s = scene(2, t=[0, 0, 0])
    with pytest.raises(DegenerateConfigurationError, match="only turned"):
        ransac_pose(s.points1, s.points2, K, K, rng())
    with pytest.raises(DegenerateConfigurationError, match="only turned"):
        ransac_fundamental(s.points1, s.points2, rng())


@pytest.mark.parametrize("seed", range(8))
def test_pairs_beyond_single_precision_do_no_harm(seed):
    points1, points2 = np.zeros((2, 10, 2))
    points1[7], points1[9] = [0, 1], [1, -1]
    points2[8], points2[9] = [0, 3515659678.0], [16262, 58327]
    F, fits = ransac_fundamental(points1, points2, rng(seed), threshold=1.0)
    assert np.isfinite(F).all()
    assert fits[:7].all()


def test_exact_pairs_are_fitted_exactly():
    s = scene(3, count=60, noise=0)
    F, fits = ransac_fundamental(s.points1, s.points2, rng())
    assert fits.all()
    assert sampson_error(s.exact1, s.exact2, F).max() < 1e-6


def test_the_same_generator_gives_the_same_answer():
    s = scene(5, wrong=0.5)
    one, other = (ransac_fundamental(s.points1, s.points2, rng(7)) for _ in range(2))
    np.testing.assert_array_equal(one.F, other.F)


def test_number_of_samples():
    assert ransac_iterations(0.99, 7, 0) == 1
    assert ransac_iterations(0.99, 5, 0.3) == 26  # log 0.01 / log(1 - 0.7⁵) = 25.1


def test_published_numbers_of_samples():
    """Hartley & Zisserman, table 4.3: 5, 10, 20, 25, 30, 40 and 50 % wrong, confidence 0.99."""
    table = {
        2: (2, 3, 5, 6, 7, 11, 17),
        3: (3, 4, 7, 9, 11, 19, 35),
        4: (3, 5, 9, 13, 17, 34, 72),
        5: (4, 6, 12, 17, 26, 57, 146),
        6: (4, 7, 16, 24, 37, 97, 293),
        7: (4, 8, 20, 33, 54, 163, 588),
        8: (5, 9, 26, 44, 78, 272, 1177),
    }
    for size, row in table.items():
        shares = 0.05, 0.1, 0.2, 0.25, 0.3, 0.4, 0.5
        assert tuple(ransac_iterations(0.99, size, share) for share in shares) == row


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda s: ransac_fundamental(s.points1[:7], s.points2[:7], rng()), "8 points or more"),
        (lambda s: ransac_pose(s.points1[:5], s.points2[:5], K, K, rng()), "6 points or more"),
        (lambda s: ransac_fundamental(s.points1, s.points2, rng(), threshold=-1), "positive"),
        (lambda s: ransac_fundamental(s.points1, s.points2, rng(), confidence=1), "between 0"),
        (lambda s: ransac_fundamental(s.points1, s.points2, rng(), most_samples=0), "most_samples"),
        (lambda s: ransac_iterations(0.99, 8, 1), "less than 1"),
        (lambda s: ransac_iterations(0.99, 2.5, 0.5), "whole number"),
        (lambda s: ransac_iterations(0.99, 300, 0.99), "no number of samples"),
    ],
)
def test_errors(call, words):
    with pytest.raises(ValueError, match=words):
        call(scene(1))


def test_random_matches_have_no_geometry():
    one, other = rng(1).uniform(0, 500, (2, 9, 2))
    with pytest.raises(DegenerateConfigurationError, match="no geometry fits"):
        ransac_fundamental(one, other, rng(), threshold=1e-4, most_samples=100)
