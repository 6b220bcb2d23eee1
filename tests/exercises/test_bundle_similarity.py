"""Absolute orientation written out plainly gives what the library gives."""

import numpy as np
import pytest

from course_lib import orientation
from course_lib.exercises.bundle import similarity_inputs as inputs
from course_lib.exercises.bundle import similarity_plain as plain


@pytest.fixture(params=range(8))
def rng(request):
    return np.random.default_rng(request.param)


@pytest.mark.parametrize(
    "draw", [inputs.exact_targets, inputs.targets_with_errors, inputs.nearly_flat]
)
def test_similarity_as_the_library(rng, draw):
    posed = draw(rng)
    ours, plainly = orientation.similarity_transform(**posed), plain.similarity_transform(**posed)
    for one, other in zip(ours, plainly, strict=True):
        np.testing.assert_allclose(other, one, rtol=1e-9, atol=1e-9)


def test_on_flat_ground_the_best_matrix_is_a_reflection(rng):
    posed = inputs.nearly_flat(rng)
    x, y = (one - one.mean(axis=0) for one in posed.values())
    U, S, Vt = np.linalg.svd(y.T @ x)
    assert np.linalg.det(U @ Vt) < 0
    assert S[2] > 1e-3 * S[0]  # not by chance


@pytest.mark.parametrize("draw", [inputs.few_check_points, inputs.heights_too_low])
def test_errors_as_the_library(rng, draw):
    posed = draw(rng)
    ours, plainly = orientation.check_point_rmse(**posed), plain.check_point_rmse(**posed)
    np.testing.assert_allclose(plainly, [ours.x, ours.y, ours.z, ours.total], rtol=1e-12)


@pytest.mark.parametrize(
    "draw",
    [
        inputs.steps_that_fill_the_circle,
        inputs.small_rest,
        inputs.large_rest,
        inputs.rounded_up,
    ],
)
def test_pictures_as_the_library(rng, draw):
    posed = draw(rng).inputs
    assert plain.pictures_for_circle(**posed) == orientation.pictures_for_circle(**posed)


def test_there_are_steps_that_rounding_spoils():
    assert {83, 95, 105} <= {count for count, _ in inputs.ROUNDED_UP}
    assert (83, np.radians(360 / 83)) in inputs.ROUNDED_UP
    assert (36, np.radians(360 / 36)) in inputs.EXACT
