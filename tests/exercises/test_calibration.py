"""Chapter 07 written out plainly gives what the library gives."""

import numpy as np
import pytest

from course_lib import calibration
from course_lib.exercises.calibration import inputs, plain, plain_refinement


@pytest.fixture(params=range(8))
def rng(request):
    return np.random.default_rng(request.param)


@pytest.mark.parametrize(
    ("draw", "name"),
    [
        (inputs.landscape_board, "board_points"),
        (inputs.small_homography, "homography_constraints"),
        (inputs.view_of_a_board, "homography_constraints"),
        (inputs.three_views, "intrinsics_from_homographies"),
        (inputs.many_views_with_skew, "intrinsics_from_homographies"),
        (inputs.negative_homography, "pose_from_homography"),
        (inputs.noisy_homography, "pose_from_homography"),
        (inputs.bent_with_noise, "initial_distortion"),
        (inputs.many_residuals, "rms_error"),
        (inputs.damped_step, "refine_calibration"),
        (inputs.one_bad_view, "reject_views"),
        (inputs.another_limit, "reject_views"),
        (inputs.larger_fit, "parameter_covariance"),
    ],
)
def test_gives_what_the_library_gives(rng, draw, name):
    posed = getattr(drawn := draw(rng), "inputs", drawn)
    written = getattr(plain, name, None) or getattr(plain_refinement, name)
    ours, plainly = getattr(calibration, name)(**posed), written(**posed)
    for one, other in zip(pair(ours), pair(plainly), strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-9, atol=1e-9)


def pair(answer):
    """Return an answer, or each of its parts."""
    return answer if isinstance(answer, tuple) else (answer,)


def test_residuals_as_the_library(rng):
    posed = inputs.with_distortion(rng).inputs
    k = posed.pop("k")
    ours = calibration.reprojection_residuals(**posed, coefficients=k)
    np.testing.assert_allclose(
        plain_refinement.reprojection_residuals(**posed, k=k), ours, atol=1e-9
    )


def test_the_steps_make_a_calibration():
    """A student's own functions, one after the other, come close to the minimum."""
    rng = np.random.default_rng(1)
    K = inputs.intrinsics(rng)
    board = plain.board_points(5, 4, 30.0)
    held = [inputs.turned_board(rng, board.mean(axis=0), turn) for turn in range(6)]
    Hs = np.array([inputs.homography(K, *pose) for pose in held])
    found = plain.intrinsics_from_homographies(Hs)
    np.testing.assert_allclose(found, K, rtol=1e-6, atol=1e-4)
    for H, (R, t) in zip(Hs, held, strict=True):
        pose = plain.pose_from_homography(found, H)
        np.testing.assert_allclose(pose[0], R, atol=1e-6)
        nothing = np.zeros((20, 2))
        seen = plain_refinement.reprojection_residuals(board, nothing, K, R, t, np.zeros(2))
        left = plain_refinement.reprojection_residuals(board, seen, found, *pose, np.zeros(2))
        assert plain_refinement.rms_error(left) < 1e-3
