"""Chapter 10 written out plainly gives what the library gives."""

import doctest

import numpy as np
import pytest

from course_lib import bundle, orientation
from course_lib.exercises.bundle import inputs, plain


@pytest.fixture(params=range(8))
def rng(request):
    return np.random.default_rng(request.param)


def test_resection_as_the_library(rng):
    posed = inputs.exact_pixels(rng).inputs
    R, t = plain.resect_camera(**posed)
    found = orientation.resect_camera(**posed)
    np.testing.assert_allclose(R, found.R, atol=1e-8)
    np.testing.assert_allclose(t, found.t, atol=1e-8)


def test_resection_with_errors_is_a_start_near_the_best(rng):
    posed = inputs.pixels_with_errors(rng)
    R, t = plain.resect_camera(**posed)
    found = orientation.resect_camera(**posed)
    np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-12)
    assert np.abs(R - found.R).max() < 0.05
    assert np.abs(-R.T @ t - found.centre).max() < 0.5


@pytest.mark.parametrize(
    ("draw", "name"),
    [
        (inputs.camera_at_the_origin, "reprojection_jacobian"),
        (inputs.camera_anywhere, "reprojection_jacobian"),
        (inputs.one_point, "solve_normal_block"),
        (inputs.many_points, "solve_normal_block"),
    ],
)
def test_gives_what_the_library_gives(rng, draw, name):
    posed = draw(rng)
    ours, plainly = getattr(bundle, name)(**posed), getattr(plain, name)(**posed)
    for one, other in zip(ours, plainly, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-9, atol=1e-9)


def test_steps_end_where_the_library_does(rng):
    """The damped steps of a student, repeated, reach the minimum that the library finds."""
    posed = inputs.a_step_that_helps(rng)
    K, pixels = posed["K"], posed["pixels"]
    block = bundle.Block(K, posed["R"], posed["t"], posed["points"])
    i, j = np.indices(pixels.shape[:2]).reshape(2, -1)
    seen = bundle.Observations(i, j, pixels.reshape(-1, 2))
    R, t, points, damping = (posed[name] for name in ("R", "t", "points", "damping"))
    for _ in range(12):
        R, t, points, damping = plain.bundle_adjust(K, R, t, points, pixels, damping)
    best = bundle.bundle_adjust(block, seen)
    assert bundle.squared_error(K, R, t, points, pixels) == pytest.approx(best.cost, rel=1e-6)


def test_a_refused_step_leaves_the_block_and_raises_the_damping(rng):
    posed = inputs.a_step_that_does_not(rng)
    *block, damping = plain.bundle_adjust(**posed)
    for name, value in zip(("R", "t", "points"), block, strict=True):
        np.testing.assert_array_equal(value, posed[name])
    assert damping == pytest.approx(10 * posed["damping"])


def test_examples():
    results = doctest.testmod(plain)
    assert results.attempted >= 15
    assert results.failed == 0
