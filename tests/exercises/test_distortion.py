"""Chapter 05 written out plainly gives what the library gives."""

import numpy as np
import pytest

from course_lib import distortion
from course_lib.exercises.distortion import inputs, plain


@pytest.fixture(params=range(8))
def rng(request):
    return np.random.default_rng(request.param)


def test_distorts_as_the_library(rng):
    posed = inputs.all_five(rng)
    np.testing.assert_allclose(plain.distort(**posed), distortion.distort(**posed), atol=1e-14)


def test_rational_and_prism_terms_as_the_library(rng):
    posed = inputs.all_twelve(rng)
    np.testing.assert_allclose(
        plain.distort_rational_prism(**posed),
        distortion.distort_rational_prism(**posed),
        atol=1e-14,
    )


def test_undistorts_as_the_library(rng):
    posed = inputs.five_at_once(rng).inputs
    ours = distortion.undistort_points(**posed)
    np.testing.assert_allclose(plain.undistort_points(**posed), ours, atol=1e-9)


@pytest.mark.parametrize("draw", [inputs.one_fold, inputs.two_folds, inputs.no_fold])
def test_folds_where_the_library_does(rng, draw):
    posed = draw(rng).inputs
    assert plain.valid_radius(**posed) == pytest.approx(distortion.valid_radius(**posed))


def test_map_as_the_library(rng):
    posed = inputs.oblong_pixels(rng)
    ours = distortion.undistortion_map(**posed, dtype=np.float64)
    np.testing.assert_allclose(plain.undistortion_map(**posed), ours, atol=1e-9)


def test_fisheye_as_the_library(rng):
    posed = inputs.with_coefficients(rng)
    ours = distortion.fisheye_project(**posed)
    np.testing.assert_allclose(plain.fisheye_project(**posed), ours, atol=1e-9)


def test_fisheye_sees_behind_as_the_library(rng):
    posed = inputs.beside_and_behind(rng)
    ours = distortion.fisheye_project(**posed)
    np.testing.assert_allclose(plain.fisheye_project(**posed), ours, atol=1e-9)


def test_inverse_iteration_settles_for_all_lenses_that_are_posed(rng):
    for draw in (inputs.barrel, inputs.pincushion, inputs.five_at_once):
        known = draw(rng)
        error = np.abs(plain.undistort_points(**known.inputs) - known.truth).max()
        assert error < 1e-8  # a tenth of what the exercise allows
