"""F and E of known cameras, their lines and epipoles, and distances from them."""

import numpy as np
import pytest
from two_views import SIZE, K, normalised, same_up_to_sign, scene

from course_lib.camera import camera_at, project
from course_lib.checks import DegenerateConfigurationError
from course_lib.epipolar import (
    epipolar_lines,
    epipole,
    essential_from_fundamental,
    essential_from_pose,
    fundamental_from_cameras,
    fundamental_from_essential,
    line_distance,
    relative_pose,
    sampson_error,
    symmetric_distance,
)
from course_lib.homogeneous import from_homogeneous, to_homogeneous
from course_lib.transforms import compose, rotation_from_vector


def products(F, one, other):
    return np.einsum("ni,ij,nj->n", to_homogeneous(other), F, to_homogeneous(one))


@pytest.mark.parametrize("seed", range(5))
def test_pairs_satisfy_both_matrices(seed):
    s = scene(seed, count=50)
    E, F = essential_from_pose(s.R, s.t), fundamental_from_cameras(s.P1, s.P2)
    one, other = normalised(s.exact1), normalised(s.exact2)
    np.testing.assert_allclose(products(E, one, other), 0, atol=1e-12)
    np.testing.assert_allclose(products(F, s.exact1, s.exact2), 0, atol=1e-9)
    assert np.abs(products(F.T, s.exact1, s.exact2)).max() > 1e-3  # not the other way round
    assert same_up_to_sign(fundamental_from_essential(E, K, K), F)
    sizes = np.linalg.svd(E)[1]
    np.testing.assert_allclose(sizes, [1, 1, 0], atol=1e-12)


def test_essential_comes_back_from_fundamental():
    s = scene(1)
    F = fundamental_from_cameras(s.P1, s.P2)
    E = essential_from_fundamental(7 * F, K, K) / np.sqrt(2)
    assert same_up_to_sign(E, essential_from_pose(s.R, s.t) / np.sqrt(2))


def test_any_world_frame_gives_the_same_matrices():
    s = scene(2)
    turn, shift = rotation_from_vector([0.3, -0.2, 0.5]), np.array([10.0, -20, 5])
    pose1, pose2 = (compose(R, t, turn, shift) for R, t in ((np.eye(3), np.zeros(3)), (s.R, s.t)))
    R, t = relative_pose(*pose1, *pose2)
    np.testing.assert_allclose(R, s.R, atol=1e-12)
    np.testing.assert_allclose(t, s.t, atol=1e-12)
    P1, P2 = (-2 * K @ np.column_stack(pose) for pose in (pose1, pose2))
    F = fundamental_from_cameras(P1, 3 * P2)
    assert same_up_to_sign(F, fundamental_from_cameras(s.P1, s.P2), 1e-9)


def test_epipoles_are_the_images_of_the_cameras():
    one = camera_at([0, -10, 0], [0, 0, 0], K, SIZE)
    other = camera_at([2, -4, 1], [0, 0, 0], K, SIZE)
    F = fundamental_from_cameras(one.P, other.P)
    np.testing.assert_allclose(epipole(F), project(other.centre, one.P), atol=1e-6)
    behind = to_homogeneous(one.centre) @ other.P.T  # no picture shows it, but lines meet there
    np.testing.assert_allclose(epipole(F.T), from_homogeneous(behind), atol=1e-6)


def test_epipole_of_a_shift_to_the_side_is_at_infinity():
    s = scene(3)
    aside = K @ np.column_stack([np.eye(3), [-1.0, 0, 0]])
    F = fundamental_from_cameras(s.P1, aside)
    assert np.isnan(epipole(F)).all()
    assert np.isnan(epipole(F.T)).all()
    nearly = K @ np.column_stack([np.eye(3), [-1.0, 0, 1e-9]])
    assert epipole(fundamental_from_cameras(s.P1, nearly)) @ [1, 0] < -1e11


def test_lines_pass_through_partners_and_epipole():
    s = scene(3, count=40)
    F = fundamental_from_cameras(s.P1, s.P2)
    lines = epipolar_lines(s.exact1, F)
    np.testing.assert_allclose(np.hypot(lines[:, 0], lines[:, 1]), 1, rtol=1e-12)
    np.testing.assert_allclose(line_distance(s.exact2, lines), 0, atol=1e-8)
    np.testing.assert_allclose(lines @ to_homogeneous(epipole(F.T)), 0, atol=1e-6)
    np.testing.assert_allclose(line_distance(s.exact1, epipolar_lines(s.exact2, F.T)), 0, atol=1e-8)
    assert epipolar_lines(s.exact1[0], F).shape == (3,)


def test_distances_of_a_row_apart():
    F = np.array([[0, 0, 0], [0, 0, -1], [0, 1, 0]])  # the same row in both pictures
    one, other = [[10, 30], [5, 5]], [[7, 33], [99, 5]]
    np.testing.assert_allclose(symmetric_distance(one, other, F), [3, 0])
    np.testing.assert_allclose(sampson_error(one, other, F), [3 / np.sqrt(2), 0])
    np.testing.assert_allclose(sampson_error(one, other, -1e-30 * F), [3 / np.sqrt(2), 0])


def test_sampson_error_is_nearly_the_shift_that_is_needed():
    from scipy.optimize import minimize

    s = scene(4, count=6, noise=1)
    F = fundamental_from_cameras(s.P1, s.P2)
    for one, other, told in zip(
        s.points1, s.points2, sampson_error(s.points1, s.points2, F), strict=True
    ):
        fits = {
            "type": "eq",
            "fun": lambda d, one=one, other=other: (
                1e4 * products(F, [one + d[:2]], [other + d[2:]])[0]
            ),
        }
        shift = minimize(lambda d: d @ d, np.full(4, 1e-3), constraints=fits, tol=1e-14)
        assert told == pytest.approx(np.sqrt(shift.fun), rel=0.01, abs=1e-4)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: essential_from_pose(np.eye(3), [0, 0, 0]), "same place"),
        (lambda: fundamental_from_cameras(np.eye(3, 4), 2 * np.eye(3, 4)), "same place"),
        (lambda: epipole(np.diag([1, 0, 0])), "rank 1"),
        (lambda: epipolar_lines([5, 5], [[0, -1, 5], [1, 0, -5], [-5, 5, 0]]), "the epipole"),
    ],
)
def test_degenerate_geometry_is_named(call, words):
    with pytest.raises(DegenerateConfigurationError, match=words):
        call()


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: essential_from_pose(np.diag([1, 1, -1]), [1, 0, 0]), "reflection"),
        (lambda: epipole(np.zeros((3, 3))), "F is zero"),
        (lambda: epipolar_lines([[1, 2, 3]], np.eye(3)), r"points must have shape \(N, 2\)"),
        (lambda: line_distance([[1, 2]] * 3, [[1, 2, 3]] * 2), "each point needs a line"),
        (lambda: line_distance([1, 2], [0, 0, 3]), "infinity"),
        (lambda: sampson_error([[1, 2]], [[1, 2]] * 2, np.eye(3)), "row by row"),
        (lambda: sampson_error([[1, np.nan]], [[1, 2]], np.eye(3)), "NaN"),
        (lambda: fundamental_from_essential(np.eye(3), np.ones((3, 3)), K), "K must be"),
    ],
)
def test_errors(call, words):
    with pytest.raises(ValueError, match=words):
        call()
