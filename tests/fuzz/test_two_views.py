"""Whatever goes in: either the answer is right, or a documented error comes. Nothing else."""

import numpy as np
import pytest
from fuzzing import fuzzing, mischief, often_equal, outcome, rows_of
from hypothesis import HealthCheck, given
from hypothesis import strategies as st

from course_lib import epipolar, triangulation

fuzz = fuzzing(25, HealthCheck.filter_too_much)


def pairs(least, most=None):
    """Return two tables of pixels with as many rows."""
    return st.integers(least, most or least + 4).flatmap(
        lambda count: st.tuples(rows_of(count, 2), rows_of(count, 2))
    )


def joined(*strategies):
    """Return one tuple of all arguments; a tuple from one strategy is several arguments."""
    return st.tuples(*strategies).map(
        lambda parts: tuple(
            value for part in parts for value in (part if isinstance(part, tuple) else (part,))
        )
    )


def vector(count):
    return st.lists(often_equal, min_size=count, max_size=count)


def turn(quarters):
    """Return a rotation by quarters of a turn."""
    c, s = [(1, 0), (0, 1), (-1, 0), (0, -1)][quarters]
    return [[c, -s, 0], [s, c, 0], [0, 0, 1]]


rotation = st.one_of(st.integers(0, 3).map(turn), rows_of(3, 3))
intrinsics = st.one_of(
    st.floats(1, 2000).map(lambda f: [[f, 0, 5], [0, f, -5], [0, 0, 1]]), rows_of(3, 3)
)
camera = rows_of(3, 4)
cameras = st.lists(camera, min_size=1, max_size=3)
matrix = rows_of(3, 3)
generator = st.integers(0, 99).map(np.random.default_rng)

#: Arguments of every public function; a tuple from one strategy is several arguments.
ARGUMENTS = {
    "relative_pose": joined(rotation, vector(3), rotation, vector(3)),
    "essential_from_pose": joined(rotation, vector(3)),
    "fundamental_from_cameras": joined(camera, camera),
    "fundamental_from_essential": joined(matrix, intrinsics, intrinsics),
    "essential_from_fundamental": joined(matrix, intrinsics, intrinsics),
    "epipolar_lines": joined(rows_of(3, 2), matrix),
    "epipole": joined(matrix),
    "skew": joined(vector(3)),
    "line_distance": joined(rows_of(3, 2), rows_of(3, 3)),
    "symmetric_distance": joined(pairs(1), matrix),
    "sampson_error": joined(pairs(1), matrix),
    "eight_point": pairs(7),
    "seven_point": pairs(7, 7),
    "five_point": pairs(5, 5),
    "poses_from_essential": joined(st.one_of(matrix, st.just([[0, 0, 0], [0, 0, 1], [0, -1, 0]]))),
    "pose_from_essential": joined(st.just([[0, 0, 0], [0, 0, 1], [0, -1, 0]]), pairs(1)),
    "pair_depths": joined(rotation, vector(3), pairs(1)),
    "refine_pose": joined(rotation, vector(3), pairs(5), intrinsics, intrinsics),
    "refine_fundamental": joined(matrix, pairs(7)),
    "ransac_fundamental": joined(pairs(8, 12), generator),
    "ransac_pose": joined(pairs(6, 9), intrinsics, intrinsics, generator),
    "ransac_iterations": joined(st.floats(), st.integers(-1, 30), st.floats(-0.1, 1.1)),
    "find_degeneracy": joined(pairs(5), st.floats(0.1, 5), intrinsics, intrinsics),
    "rectify": joined(intrinsics, intrinsics, rotation, vector(3)),
    "rectify_uncalibrated": joined(matrix, pairs(3), st.just(((640, 480),))),
    "triangulate": joined(pairs(1), camera, camera),
    "triangulate_midpoint": joined(pairs(1), camera, camera),
    "triangulate_linear": joined(st.lists(rows_of(3, 2), min_size=2, max_size=3), cameras),
    "refine_point": joined(rows_of(3, 3), st.lists(rows_of(3, 2), min_size=2, max_size=3), cameras),
    "point_covariance": joined(rows_of(3, 3), cameras),
    "closest_points_on_rays": joined(vector(3), rows_of(3, 3), vector(3), rows_of(3, 3)),
    "intersect_ray_plane": joined(vector(3), rows_of(3, 3), vector(4)),
    "depth_from_disparity": joined(vector(3), st.floats(), st.floats(), st.floats()),
    "depth_uncertainty": joined(vector(3), st.floats(), st.floats(), st.floats()),
}
HOMES = epipolar, triangulation
#: Answers that may hold NaN or infinity, as their docstrings say.
OPEN_ENDED = {"pair_depths", "epipole", "intersect_ray_plane"}


def found(name):
    return next(getattr(home, name) for home in HOMES if hasattr(home, name))


def parts(answer):
    """Return the arrays of an answer."""
    if isinstance(answer, epipolar.Rectification):
        return list(vars(answer).values())
    if isinstance(answer, (tuple, list)):
        return [part for one in answer for part in parts(one)]
    return [] if answer is None or isinstance(answer, str) else [answer]


@pytest.mark.parametrize("name", ARGUMENTS)
@fuzz
@given(data=st.data())
def test_answer_or_documented_error(name, data):
    arguments = list(data.draw(ARGUMENTS[name]))
    if data.draw(st.integers(0, 3)) == 0:
        arguments[data.draw(st.integers(0, len(arguments) - 1))] = data.draw(mischief)
    answer = outcome(found(name), *arguments)
    if name not in OPEN_ENDED:
        assert all(np.isfinite(np.asarray(part, dtype=float)).all() for part in parts(answer))


def test_every_public_function_is_fuzzed():
    public = {name for home in HOMES for name in home.__all__}
    assert public == set(ARGUMENTS) | {"Rectification", "RobustFundamental", "RobustPose"}
