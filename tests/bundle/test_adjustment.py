import numpy as np
import pytest

from course_lib.bundle import (
    Control,
    Observations,
    bundle_adjust,
    reprojection_jacobian,
    solve_normal_block,
)
from course_lib.bundle.derivatives import Position
from course_lib.bundle.gauge import free_numbers, gauge_directions
from course_lib.bundle.structure import Structure
from course_lib.checks import DegenerateConfigurationError
from course_lib.orientation import check_point_rmse
from course_lib.transforms.exponential import rotation_from_vector
from data_generators.blocks import flight, turntable


@pytest.fixture(scope="module")
def small():
    """Return a block that is small enough for dense matrices."""
    return flight(np.random.default_rng(3), strips=2, pictures=3, points=60, oblique=2)


def dense(block, observations):
    """Return the whole matrix of derivatives, cameras first, straight from the definition."""
    v = len(block.R)
    J = np.zeros((2 * len(observations), 6 * v + 3 * len(block.points)))
    for row, (i, j) in enumerate(zip(observations.cameras, observations.points, strict=True)):
        by_pose, by_point = reprojection_jacobian(
            block.points[j], block.K[i], block.R[i], block.t[i]
        )
        J[2 * row : 2 * row + 2, 6 * i : 6 * i + 6] = by_pose / observations.sigma[row]
        first = 6 * v + 3 * j
        J[2 * row : 2 * row + 2, first : first + 3] = by_point / observations.sigma[row]
    return J


def test_derivatives_are_those_of_the_projection():
    K = np.array([[900, 3, 300], [0, 950, 200], [0, 0, 1]])
    R, centre, X = rotation_from_vector([0.2, -0.3, 0.5]), np.array([1, 2, 3.0]), np.zeros(3)
    centre = -R.T @ np.array([0.4, -0.2, 5])

    def pixel(step):
        turned = rotation_from_vector(step[:3]) @ R
        q = turned @ (X + step[6:] - centre - step[3:6])
        return (K @ (q / q[2]))[:2]

    by_pose, by_point = reprojection_jacobian(X, K, R, -R @ centre)
    steps = 1e-6 * np.eye(9)
    wanted = np.stack([(pixel(s) - pixel(-s)) / 2e-6 for s in steps], axis=1)
    np.testing.assert_allclose(np.concatenate([by_pose, by_point], axis=1), wanted, atol=1e-5)


@pytest.mark.parametrize("kind", [turntable, flight])
def test_without_noise_the_truth_comes_back(kind):
    known = kind(np.random.default_rng(5), points=150, pictures=6, noise=0)
    size = np.ptp(known.truth.points, axis=0).max()
    start = known.roughly(np.random.default_rng(6), 0.005, 0.005 * size)
    fit = bundle_adjust(start, known.observations, gauge="inner")
    assert fit.converged
    assert fit.rms < 1e-6
    control = Control(np.arange(10), known.truth.points[:10])
    fit = bundle_adjust(start, known.observations, control)
    np.testing.assert_allclose(fit.block.points, known.truth.points, rtol=0, atol=1e-7 * size)
    np.testing.assert_allclose(fit.block.centres, known.truth.centres, rtol=0, atol=1e-7 * size)
    np.testing.assert_allclose(fit.block.R, known.truth.R, rtol=0, atol=1e-8)


def test_the_minimum_is_one(small):
    fit = bundle_adjust(small.truth, small.observations)
    J = dense(fit.block, small.observations)
    residuals = (fit.residuals / small.observations.sigma[:, None]).ravel()
    scale = np.linalg.norm(J, axis=0) * np.linalg.norm(residuals)
    assert np.abs(J.T @ residuals / scale).max() < 1e-6
    assert fit.cost == pytest.approx(residuals @ residuals)
    assert fit.redundancy == J.shape[0] - J.shape[1] + 7


def test_both_gauges_fit_equally_and_hold_what_they_say(small):
    start = small.roughly(np.random.default_rng(1), 0.002, 0.5)
    inner = bundle_adjust(start, small.observations)
    fixed = bundle_adjust(start, small.observations, gauge="fixed")
    assert inner.cost == pytest.approx(fixed.cost, rel=1e-9)
    np.testing.assert_allclose(inner.residuals, fixed.residuals, rtol=0, atol=1e-4)
    np.testing.assert_allclose(fixed.block.R[0], start.R[0], rtol=0, atol=1e-12)
    np.testing.assert_allclose(fixed.block.centres[0], start.centres[0], rtol=0, atol=1e-9)
    middle = inner.block.points.mean(axis=0)
    np.testing.assert_allclose(middle, start.points.mean(axis=0), rtol=0, atol=1e-9)
    moved = inner.block.points - start.points
    turn = np.cross(start.points - start.points.mean(axis=0), moved).sum(axis=0)
    assert np.abs(turn).max() < 1e-6 * np.abs(start.points).max() ** 2


def test_the_whole_block_moves_without_changing_a_pixel(small):
    J = dense(small.truth, small.observations)
    cameras, points = gauge_directions(Position.of(small.truth))
    G = np.concatenate([cameras, points.reshape(-1, 7)])
    assert np.abs(J @ G).max() < 1e-8 * np.abs(J).max()
    assert np.linalg.matrix_rank(G) == 7


@pytest.mark.parametrize("gauge", ["fixed", "inner"])
def test_covariances_are_those_of_the_whole_inverse(small, gauge):
    fit = bundle_adjust(small.truth, small.observations, gauge=gauge)
    J, v = dense(fit.block, small.observations), len(fit.block.R)
    N = J.T @ J
    if gauge == "fixed":
        free = free_numbers(Position.of(fit.block), True)
        free = np.append(free, np.arange(6 * v, len(N)))
        whole = np.zeros_like(N)
        whole[np.ix_(free, free)] = np.linalg.inv(N[np.ix_(free, free)])
    else:
        _, points = gauge_directions(Position.of(fit.block))
        H = np.concatenate([np.zeros((6 * v, 7)), points.reshape(-1, 7)])
        scale = np.sqrt(np.diag(N))
        H = H / scale[:, None] * np.median(scale)
        bordered = np.block([[N / np.outer(scale, scale), H], [H.T, np.zeros((7, 7))]])
        whole = np.linalg.inv(bordered)[: len(N), : len(N)] / np.outer(scale, scale)
    whole *= fit.sigma0**2
    sigma = np.sqrt(np.diag(whole)).clip(1e-12)
    for i in range(v):
        part = slice(6 * i, 6 * i + 6)
        apart = (fit.precision.cameras[i] - whole[part, part]) / np.outer(sigma[part], sigma[part])
        assert np.abs(apart).max() < 1e-4
    for j in range(len(fit.block.points)):
        part = slice(6 * v + 3 * j, 6 * v + 3 * j + 3)
        apart = (fit.precision.points[j] - whole[part, part]) / np.outer(sigma[part], sigma[part])
        assert np.abs(apart).max() < 1e-4


def test_sigma0_tells_by_how_much_sigma_was_too_small():
    known = flight(np.random.default_rng(4))
    seen = known.observations
    doubtful = Observations(seen.cameras, seen.points, seen.pixels, 0.25)
    assert bundle_adjust(known.truth, seen).sigma0 == pytest.approx(1, abs=0.05)
    fit = bundle_adjust(known.truth, doubtful)
    assert fit.sigma0 == pytest.approx(2, abs=0.1)
    sure = bundle_adjust(known.truth, seen).precision.point_sigma
    np.testing.assert_allclose(fit.precision.point_sigma, sure, rtol=1e-4)


def test_wrong_matches_do_not_bend_a_robust_block():
    known = flight(np.random.default_rng(7), wrong=0.05)
    start = known.roughly(np.random.default_rng(8), 0.002, 0.5)
    control = known.surveyed(np.random.default_rng(9), 0.02)
    plain = bundle_adjust(start, known.observations, control)
    robust = bundle_adjust(start, known.observations, control, robust=2.5)
    true = known.truth.points[known.check]
    assert known.wrong.sum() > 50
    errors = [check_point_rmse(fit.block.points[known.check], true) for fit in (plain, robust)]
    centres = [np.abs(fit.block.centres - known.truth.centres).mean() for fit in (plain, robust)]
    assert centres[1] < 0.25 * centres[0]
    assert errors[1].total < 0.5 * errors[0].total
    assert np.median(robust.weights[known.wrong]) < 0.1
    assert np.median(robust.weights[~known.wrong]) == 1
    sizes = np.linalg.norm(robust.residuals, axis=1) / 0.5
    huber = np.where(sizes > 2.5, 5 * sizes - 2.5**2, sizes**2).sum()
    survey = ((robust.control_residuals / 0.02) ** 2).sum()
    assert robust.converged
    assert robust.cost == pytest.approx(huber + survey)


def test_control_orients_and_check_points_judge():
    known = flight(np.random.default_rng(10))
    start = known.roughly(np.random.default_rng(11), 0.002, 0.5)
    control = known.surveyed(np.random.default_rng(12), 0.02)
    fit = bundle_adjust(start, known.observations, control)
    error = check_point_rmse(fit.block.points[known.check], known.truth.points[known.check])
    reported = np.sqrt((fit.precision.point_sigma[known.check] ** 2).sum(axis=1).mean())
    assert error.total == pytest.approx(reported, rel=0.5)
    # Adjusted control points stay within a few standard deviations of the survey.
    assert 0 < np.abs(fit.control_residuals).max() < 0.08
    held = bundle_adjust(start, known.observations, Control(control.points, control.coordinates))
    assert np.abs(held.control_residuals).max() == 0
    assert held.precision.points[control.points].max() == pytest.approx(0, abs=1e-12)


def test_the_order_of_the_observations_does_not_matter(small):
    seen = small.observations
    order = np.random.default_rng(0).permutation(len(seen))
    one, other = bundle_adjust(small.truth, seen), bundle_adjust(small.truth, seen.only(order))
    np.testing.assert_allclose(other.residuals, one.residuals[order], rtol=0, atol=1e-7)


def test_the_schur_complement_solves_the_whole_system():
    rng = np.random.default_rng(2)
    J = rng.standard_normal((90, 12 + 15))
    for row in range(90):  # each row sees one of five points
        keep = 12 + 3 * (row % 5)
        J[row, 12:keep] = J[row, keep + 3 :] = 0
    N, g = J.T @ J, rng.standard_normal(27)
    V = np.stack([N[a : a + 3, a : a + 3] for a in range(12, 27, 3)])
    W = np.stack([N[:12, a : a + 3] for a in range(12, 27, 3)])
    cameras, points = solve_normal_block(N[:12, :12], W, V, g[:12], g[12:].reshape(5, 3))
    step = np.concatenate([cameras, points.ravel()])
    np.testing.assert_allclose(step, np.linalg.solve(N, -g), rtol=1e-9)
    with pytest.raises(DegenerateConfigurationError, match="singular"):
        solve_normal_block(N[:12, :12], W, 0 * V, g[:12], g[12:].reshape(5, 3))
    with pytest.raises(ValueError, match="must have shapes"):
        solve_normal_block(N[:12, :12], W[:, :3], V, g[:12], g[12:].reshape(5, 3))


def test_pairs_are_all_that_share_a_point(small):
    structure = Structure.of(small.observations, len(small.truth.R), len(small.truth.points))
    seen = structure.seen
    assert (seen.points[structure.left] == seen.points[structure.right]).all()
    assert (seen.cameras[structure.left] < seen.cameras[structure.right]).all()
    rays = np.bincount(seen.points)
    assert len(structure.left) == (rays * (rays - 1) // 2).sum()
