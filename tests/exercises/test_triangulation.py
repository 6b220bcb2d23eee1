"""Chapter 09 written out plainly gives what the library gives."""

import numpy as np
import pytest

from course_lib import triangulation
from course_lib.exercises.triangulation import inputs, plain


@pytest.fixture(params=range(8))
def rng(request):
    return np.random.default_rng(request.param)


@pytest.mark.parametrize(
    ("draw", "name"),
    [
        (inputs.unit_rays, "closest_points_on_rays"),
        (inputs.rays_of_any_length, "closest_points_on_rays"),
        (inputs.rays_miss, "triangulate_midpoint"),
        (inputs.two_cameras, "triangulate_linear"),
        (inputs.five_cameras, "triangulate_linear"),
        (inputs.with_offset, "depth_from_disparity"),
        (inputs.negative_disparity, "depth_from_disparity"),
        (inputs.one_depth, "depth_uncertainty"),
        (inputs.many_depths, "depth_uncertainty"),
        (inputs.some_rays_go_away, "intersect_ray_plane"),
        (inputs.uncertain_from_two, "point_covariance"),
        (inputs.uncertain_from_five, "point_covariance"),
    ],
)
def test_gives_what_the_library_gives(rng, draw, name):
    posed = getattr(drawn := draw(rng), "inputs", drawn).values()
    ours, plainly = getattr(triangulation, name)(*posed), getattr(plain, name)(*posed)
    np.testing.assert_allclose(plainly, ours, rtol=1e-8, atol=1e-9)


@pytest.mark.parametrize("draw", [inputs.infinitely_far, inputs.wrong_match])
def test_refuses_what_the_library_refuses(rng, draw):
    posed = draw(rng).inputs
    for function in (triangulation.depth_from_disparity, plain.depth_from_disparity):
        with pytest.raises(ValueError, match="must be positive"):
            function(**posed)


@pytest.mark.parametrize("draw", [inputs.guess_from_two, inputs.guess_from_four])
def test_step_after_step_leads_to_the_refined_point(rng, draw):
    posed = draw(rng)
    X, pixels, cameras = posed.values()
    refined = triangulation.refine_point(X, pixels, cameras)
    ways = [np.linalg.norm(X - refined)]
    for _ in range(6):
        X = plain.refine_point(X, pixels, cameras)
        ways.append(np.linalg.norm(X - refined))
    assert ways[1] < 0.2 * ways[0]  # one step is most of the way
    assert ways[6] < 1e-7


def test_depths_of_the_published_pair():
    """Middlebury's Motorcycle, and the rule of thumb from its numbers."""
    disparity, f, baseline, offset = np.array([20.0, 60]), 994.978, 193.001, 31.086
    Z = plain.depth_from_disparity(disparity, f, baseline, offset)
    np.testing.assert_allclose(Z, [3759.0, 2108.2], atol=0.05)
    nearby = plain.depth_from_disparity(disparity - 1e-3, f, baseline, offset) - Z
    np.testing.assert_allclose(plain.depth_uncertainty(Z, f, baseline, 1e-3), nearby, rtol=1e-4)
