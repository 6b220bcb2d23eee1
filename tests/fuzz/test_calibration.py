"""Whatever goes in: either a camera that the data determine, or an error that says what to do."""

import numpy as np
import pytest
from fuzzing import either, fuzzing, intrinsics, numbers, outcome
from hypothesis import given
from hypothesis import strategies as st

from course_lib import calibration
from course_lib.calibration import CameraModel, board_points, calibrate
from course_lib.checks import DegenerateConfigurationError
from data_generators.board_observations import observe_board

fuzz = fuzzing(40)

pixels = st.lists(st.tuples(numbers, numbers), min_size=1, max_size=6)
views = st.lists(pixels, max_size=4)
space = st.lists(st.tuples(numbers, numbers, numbers), min_size=1, max_size=6)
matrix = st.lists(st.tuples(numbers, numbers, numbers), min_size=3, max_size=3)
row = st.lists(numbers, min_size=1, max_size=4)
rows = st.lists(st.tuples(numbers, numbers), min_size=1, max_size=5)
size = st.tuples(st.integers(-1, 2000), st.integers(0, 2000))
pose = st.tuples(st.just(np.eye(3)), st.tuples(numbers, numbers, numbers))
FOUND = calibrate(
    board_points(5, 4, 30),
    observe_board(
        np.random.default_rng(0),
        board_points(5, 4, 30),
        [[700, 0, 320], [0, 700, 240], [0, 0, 1]],
        [0],
        (640, 480),
        5,
        noise=0.1,
    ).pixels,
    (640, 480),
)


#: Arguments of every public function.
ARGUMENTS = {
    "board_points": (st.integers(-2, 9), st.integers(-2, 9), numbers),
    "board_tilts": (st.lists(pose, min_size=1, max_size=3),),
    "calibrate": (space, views, size),
    "calibrate_robustly": (space, views, size),
    "calibrate_stereo": (space, views, views, size),
    "coverage": (views, size, st.tuples(st.integers(-1, 9), st.integers(1, 9))),
    "held_out_rms": (space, views, size),
    "homography_constraints": (matrix,),
    "initial_distortion": (pixels, pixels, intrinsics),
    "intrinsics_from_homographies": (st.lists(matrix, max_size=4),),
    "parameter_covariance": (rows, row),
    "pose_from_homography": (intrinsics, matrix),
    "refine_calibration": (row, row, rows, numbers),
    "reject_views": (views, numbers),
    "reprojection_residuals": (space, pixels, intrinsics, st.just(np.eye(3)), row, row),
    "residuals_and_jacobian": (st.just(FOUND), space, views),
    "rms_error": (pixels,),
    "view_residuals": (st.just(FOUND), space, views),
}


@pytest.mark.parametrize("name", ARGUMENTS)
@fuzz
@given(data=st.data())
def test_answer_or_documented_error(name, data):
    arguments = [data.draw(either(argument)) for argument in ARGUMENTS[name]]
    outcome(getattr(calibration, name), *arguments)


def test_every_public_function_is_fuzzed():
    results = {name for name in calibration.__all__ if name[0].isupper()}
    assert set(calibration.__all__) == set(ARGUMENTS) | results


@fuzz
@given(
    seed=st.integers(0, 10_000),
    count=st.integers(1, 6),
    noise=st.sampled_from([0, 1e-9, 0.2, 2]),
    tilt=st.sampled_from([0, 0.001, 0.05, 0.3, 0.8]),
    coefficients=st.sampled_from([(), ("k1",), ("k1", "k2"), ("k1", "k2", "p1", "p2", "k3")]),
    square=st.booleans(),
)
def test_plausible_views(seed, count, noise, tilt, coefficients, square):
    """A camera comes with finite numbers, or the reason why none does."""
    board, K = board_points(5, 4, 30), np.array([[700.0, 0, 320], [0, 700, 240], [0, 0, 1]])
    rng = np.random.default_rng(seed)
    seen = observe_board(rng, board, K, [-0.2], (640, 480), count, noise, tilt)
    model = CameraModel(square_pixels=square, coefficients=coefficients)
    try:
        found = calibrate(board, seen.pixels, (640, 480), model)
    except DegenerateConfigurationError:
        return
    for value in (found.K, found.coefficients, found.covariance, found.pose_sigma, found.rms):
        assert np.isfinite(value).all()
    assert all(sigma >= 0 for sigma in found.sigma.values())
