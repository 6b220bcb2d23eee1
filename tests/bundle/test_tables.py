"""A small block as tables: the same equations as those of lists of observations."""

import numpy as np
import pytest

from course_lib import bundle
from course_lib.bundle import Block, Observations, move_block, normal_blocks, squared_error
from course_lib.checks import DegenerateConfigurationError
from data_generators.blocks import turntable

CAMERAS = 8


@pytest.fixture
def block():
    """Return K, R, t, points and a table of pixels that is not full."""
    known = turntable(np.random.default_rng(2), pictures=CAMERAS, points=60)
    true, seen = known.truth, known.observations
    pixels = np.full((CAMERAS, len(true.points), 2), np.nan)
    pixels[seen.cameras, seen.points] = seen.pixels
    return true.K[0], true.R, true.t, true.points, pixels


def derivatives(K, R, t, points, pixels):
    """Return the whole matrix of derivatives and the residuals, from the definition."""
    v, n = pixels.shape[:2]
    rows, residuals = [], []
    for i, j in zip(*np.nonzero(np.isfinite(pixels[..., 0])), strict=True):
        by_pose, by_point = bundle.reprojection_jacobian(points[j], K, R[i], t[i])
        row = np.zeros((2, 6 * v + 3 * n))
        row[:, 6 * i : 6 * i + 6] = by_pose
        row[:, 6 * v + 3 * j : 6 * v + 3 * j + 3] = by_point
        q = K @ (R[i] @ points[j] + t[i])
        rows.append(row)
        residuals.append(q[:2] / q[2] - pixels[i, j])
    return np.concatenate(rows), np.concatenate(residuals)


def test_blocks_are_those_of_the_whole_matrix(block):
    J, r = derivatives(*block)
    U, W, V, g_c, g_p = normal_blocks(*block)
    c, n = len(U), len(V)
    N, g = J.T @ J, J.T @ r
    np.testing.assert_allclose(U, N[:c, :c], rtol=1e-9, atol=1e-6)
    np.testing.assert_allclose(W.transpose(1, 0, 2).reshape(c, -1), N[:c, c:], rtol=1e-9, atol=1e-6)
    for j in range(n):
        at = slice(c + 3 * j, c + 3 * j + 3)
        np.testing.assert_allclose(V[j], N[at, at], rtol=1e-9)
    np.testing.assert_allclose(g_c, g[:c], rtol=1e-7, atol=1e-6)
    np.testing.assert_allclose(g_p.ravel(), g[c:], rtol=1e-7, atol=1e-6)


def test_the_gradient_is_half_the_slope_of_the_error(block):
    K, R, t, points, pixels = block
    _, _, _, g_c, g_p = normal_blocks(*block)
    rng = np.random.default_rng(0)
    step_c, step_p = rng.normal(0, 1e-6, g_c.shape), rng.normal(0, 1e-6, g_p.shape)
    ahead = squared_error(K, *move_block(R, t, points, step_c, step_p), pixels)
    behind = squared_error(K, *move_block(R, t, points, -step_c, -step_p), pixels)
    slope = g_c @ step_c + (g_p * step_p).sum()
    assert (ahead - behind) / 4 == pytest.approx(slope, rel=1e-5)


def test_error_is_that_of_the_residuals(block):
    _, r = derivatives(*block)
    assert squared_error(*block) == pytest.approx(r @ r)


def test_a_step_moves_as_the_adjustment_does(block):
    K, R, t, points, _ = block
    R, t, points = move_block(R, t, points, np.zeros(6 * CAMERAS), np.zeros_like(points))
    np.testing.assert_allclose(R, block[1], atol=1e-15)
    np.testing.assert_allclose(t, block[2], atol=1e-12)
    moves = np.zeros((CAMERAS, 6))
    moves[2, 5] = 0.1  # the third camera goes up
    raised = Block(K, *move_block(R, t, points, moves.ravel(), np.zeros_like(points)))
    change = raised.centres - Block(K, R, t, points).centres
    np.testing.assert_allclose(change, [[0, 0, 0.1 * (i == 2)] for i in range(CAMERAS)], atol=1e-12)


def test_damped_steps_reach_the_minimum(block):
    K, R, t, points, pixels = block
    for _ in range(8):
        U, W, V, *g = normal_blocks(K, R, t, points, pixels)
        U, V = U * (1 + 1e-6 * np.eye(len(U))), V * (1 + 1e-6 * np.eye(3))
        R, t, points = move_block(R, t, points, *bundle.solve_normal_block(U, W, V, *g))
    i, j = np.nonzero(np.isfinite(pixels[..., 0]))
    best = bundle.bundle_adjust(Block(*block[:4]), Observations(i, j, pixels[i, j]))
    assert squared_error(K, R, t, points, pixels) == pytest.approx(best.cost, rel=1e-7)


def test_undamped_equations_are_singular(block):
    """Pictures leave place, turn and scale open; rounding must not hide it."""
    with pytest.raises(DegenerateConfigurationError, match="nothing fixes the gauge"):
        bundle.solve_normal_block(*normal_blocks(*block))


def test_bad_input_is_named(block):
    K, R, t, points, pixels = block
    with pytest.raises(ValueError, match=r"pixels must have shape \(8, 3, 2\)"):
        squared_error(K, R, t, points[:3], pixels)
    with pytest.raises(ValueError, match="cameras must"):
        move_block(R, t, points, np.zeros(6), np.zeros_like(points))
    with pytest.raises(ValueError, match="moves must have shape"):
        move_block(R, t, points, np.zeros(6 * CAMERAS), np.zeros((2, 3)))
    behind = np.add(points, [0, 0, 1e4])
    seen = np.zeros(pixels.shape)
    with pytest.raises(ValueError, match="behind it"):
        normal_blocks(K, R, t, behind, seen)
    assert squared_error(K, R, t, behind, seen) == np.inf
