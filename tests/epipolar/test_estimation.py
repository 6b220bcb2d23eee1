"""F and E from pairs: exact ones, measured ones, too few, and pairs that tell too little."""

import numpy as np
import pytest
from two_views import K, angle_between, normalised, same_up_to_sign, scene, turn_between

from course_lib.checks import DegenerateConfigurationError
from course_lib.epipolar import (
    eight_point,
    essential_from_pose,
    find_degeneracy,
    five_point,
    fundamental_from_cameras,
    pair_depths,
    pose_from_essential,
    poses_from_essential,
    refine_fundamental,
    refine_pose,
    sampson_error,
    seven_point,
)
from course_lib.epipolar.fundamental import common_scale, seven_point_samples
from course_lib.epipolar.matrices import unit
from course_lib.epipolar.polynomials import real_roots_of_cubics
from course_lib.epipolar.refinement import PosedPair, RankTwo, linearised
from course_lib.transforms import rotation_z, skew


def rms(F, s):
    return np.sqrt(np.mean(sampson_error(s.exact1, s.exact2, F) ** 2))


@pytest.mark.parametrize("seed", range(5))
def test_exact_pairs_give_the_truth_back(seed):
    s = scene(seed, count=30, noise=0)
    F = fundamental_from_cameras(s.P1, s.P2)
    assert same_up_to_sign(eight_point(s.points1, s.points2), F, 1e-7)
    assert same_up_to_sign(eight_point(s.points1[:8], s.points2[:8]), F, 1e-5)
    seven = seven_point(s.points1[:7], s.points2[:7])
    assert any(same_up_to_sign(one, F, 1e-5) for one in seven)
    five = five_point(normalised(s.points1[:5]), normalised(s.points2[:5]))
    E = unit(essential_from_pose(s.R, s.t))
    assert any(same_up_to_sign(one, E, 1e-7) for one in five)


@pytest.mark.parametrize("seed", range(3))
def test_solutions_of_few_pairs_satisfy_their_equations(seed):
    s = scene(seed, count=7, noise=2)
    for F in seven_point(s.points1, s.points2):
        assert sampson_error(s.points1, s.points2, F).max() < 1e-7
        assert np.linalg.svd(F)[1][2] < 1e-12
    one, other = normalised(s.points1[:5]), normalised(s.points2[:5])
    found = five_point(one, other)
    assert 0 < len(found) <= 10
    for E in found:
        assert sampson_error(one, other, E).max() < 1e-9
        np.testing.assert_allclose(np.linalg.svd(E)[1] * np.sqrt(2), [1, 1, 0], atol=1e-6)


@pytest.mark.parametrize("free", [1, 3, 5, 7])
def test_quick_samples_agree_with_seven_point(free):
    s = scene(7, count=7, noise=1)
    x1, x2, T1, T2, _ = common_scale(s.points1, s.points2)
    quick = seven_point_samples(x1[:2].T[None], x2[:2].T[None], free)
    quick = unit(T2.T @ quick @ T1)
    careful = seven_point(s.points1, s.points2)
    assert len(quick) == len(careful)
    for F in careful:
        assert any(same_up_to_sign(F, other, 1e-7) for other in quick)


def test_rank_is_two_and_noise_is_averaged():
    few, many = (scene(8, count=count) for count in (30, 3000))
    for s in (few, many):
        assert np.linalg.svd(eight_point(s.points1, s.points2))[1][2] < 1e-15
    assert rms(eight_point(many.points1, many.points2), many) < 0.05
    assert rms(eight_point(few.points1, few.points2), few) > 0.1


@pytest.mark.parametrize("seed", range(5))
def test_refining_lowers_the_errors(seed):
    s = scene(seed, count=100)
    start = eight_point(s.points1, s.points2)
    F = refine_fundamental(start, s.points1, s.points2)
    errors = [(sampson_error(s.points1, s.points2, G) ** 2).sum() for G in (F, start)]
    assert errors[0] <= errors[1] * (1 + 1e-12)
    # Nowhere near is a matrix of rank 2 with smaller errors.
    rng = np.random.default_rng(seed)
    for _ in range(20):
        near = RankTwo.near(F).moved(1e-5 * rng.normal(size=7)).matrix
        assert (sampson_error(s.points1, s.points2, near) ** 2).sum() >= errors[0] * (1 - 1e-7)


def test_slopes_are_the_differences():
    s = scene(1, count=9)
    x1, x2, T1, T2, _ = common_scale(s.points1, s.points2)
    left, right = np.linalg.inv(T2 @ K).T, np.linalg.inv(T1 @ K)
    rank_two = RankTwo.near(eight_point(x1[:2].T, x2[:2].T))
    for geometry in (rank_two, PosedPair(s.R, s.t, left, right)):
        slopes = linearised(geometry, x1, x2)[1]
        for i, slope in enumerate(slopes):
            step = 1e-6 * np.eye(len(slopes))[i]
            ahead, back = (linearised(geometry.moved(d), x1, x2)[0] for d in (step, -step))
            np.testing.assert_allclose(
                slope, (ahead - back) / 2e-6, atol=1e-6 * np.abs(slopes).max()
            )


def test_cubic_roots():
    rng = np.random.default_rng(0)
    roots = np.sort(rng.normal(size=(200, 3)), axis=1)
    cubics = np.array([rng.normal() * np.poly(r) for r in roots])
    np.testing.assert_allclose(np.sort(real_roots_of_cubics(cubics), axis=1), roots, atol=1e-5)
    only = real_roots_of_cubics(np.array([[1.0, 0, 1, -2], [0, 0, 0, 1]]))  # (x - 1)(x² + x + 2)
    np.testing.assert_allclose(only, [[1, np.nan, np.nan], [np.nan] * 3])


def test_one_of_four_poses_has_points_in_front():
    s = scene(3, count=20, noise=0)
    one, other = normalised(s.points1), normalised(s.points2)
    E = -5 * essential_from_pose(s.R, s.t)
    found = poses_from_essential(E)
    assert sum(np.allclose(R, s.R, atol=1e-9) for R, _ in found) == 2
    R, t = pose_from_essential(E, one, other)
    np.testing.assert_allclose(R, s.R, atol=1e-9)
    np.testing.assert_allclose(t, s.t, atol=1e-9)
    Z1, Z2 = pair_depths(R, t, one, other)
    np.testing.assert_allclose(Z1, s.points[:, 2], rtol=1e-7)
    np.testing.assert_allclose(Z2, (s.points @ s.R.T + s.t)[:, 2], rtol=1e-7)
    assert (pair_depths(R, -t, one, other)[0] < 0).all()


def test_refined_pose():
    s = scene(4)
    start = s.R @ rotation_z(0.02)
    R, t = refine_pose(start, s.t + np.array([0.05, 0.02, -0.05]), s.points1, s.points2, K, K)
    assert turn_between(R, s.R) < 0.15
    assert angle_between(t, s.t) < 0.5
    assert np.linalg.norm(t) == pytest.approx(1)
    assert turn_between(start, s.R) > 1


@pytest.mark.parametrize("noise", [0, 0.5])
def test_degeneracies_are_found(noise):
    general, plane = scene(5, noise=noise), scene(5, noise=noise, plane=True)
    turned = scene(5, noise=noise, t=[0, 0, 0])
    names = {"none": general, "plane": plane, "rotation": turned}
    for name, s in names.items():
        pairs = s.points1, s.points2, 1.5
        assert find_degeneracy(*pairs, K, K) == name
        assert find_degeneracy(*pairs) == ("none" if name == "none" else "plane or rotation")


def test_a_few_wrong_pairs_do_not_hide_a_plane():
    s = scene(6, plane=True, wrong=0.08)
    assert find_degeneracy(s.points1, s.points2, 1.5, K, K) == "plane"


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda s, p: eight_point(p.exact1, p.exact2), "on a plane"),
        (lambda s, p: seven_point(p.exact1[:7], p.exact2[:7]), "on a plane"),
        (lambda s, p: eight_point(s.points1 * [1, 0], s.points2), "points1 are collinear"),
        (lambda s, p: five_point(s.points1[[0] * 5], s.points2[[0] * 5]), "dependent"),
        (
            lambda s, p: pose_from_essential(skew([1, 0, 0]), [[0, 0]], [[0, 0]]),
            "do not tell",
        ),
    ],
)
def test_degenerate_geometry_is_named(call, words):
    with pytest.raises(DegenerateConfigurationError, match=words):
        call(scene(1, noise=0), scene(1, noise=0, plane=True))


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda s: eight_point(s.points1[:7], s.points2[:7]), "8 points or more"),
        (lambda s: seven_point(s.points1[:6], s.points2[:6]), "7 points or more"),
        (lambda s: seven_point(s.points1, s.points2), "use eight_point"),
        (lambda s: five_point(s.points1[:4], s.points2[:4]), "5 points or more"),
        (lambda s: five_point(s.points1, s.points2), "use ransac_pose"),
        (lambda s: poses_from_essential(np.eye(3)), "no essential matrix"),
        (lambda s: find_degeneracy(s.points1, s.points2, 1, K), "of neither"),
        (lambda s: find_degeneracy(s.points1, s.points2, 0), "threshold must be positive"),
        (lambda s: eight_point(s.points1, s.points2 * np.nan), "NaN"),
    ],
)
def test_errors(call, words):
    with pytest.raises(ValueError, match=words):
        call(scene(1))
