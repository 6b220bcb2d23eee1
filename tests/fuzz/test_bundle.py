"""Whatever goes in: either a block or a pose, or an error that says what to do."""

from functools import partial

import numpy as np
import pytest
from fuzzing import either, fuzzing, intrinsics, numbers, outcome, rows_of
from hypothesis import given
from hypothesis import strategies as st

from course_lib import bundle, orientation
from course_lib.bundle import Block, Control, Observations, bundle_adjust
from data_generators.blocks import turntable

fuzz = fuzzing(25)
pytestmark = pytest.mark.filterwarnings("error")

space = st.lists(st.tuples(numbers, numbers, numbers), min_size=1, max_size=7)
pixels = st.lists(st.tuples(numbers, numbers), min_size=1, max_size=7)
indices = st.lists(st.integers(-1, 9), max_size=7)
vector = st.tuples(numbers, numbers, numbers)
matrices = st.one_of(st.just(np.eye(3)), st.lists(vector, min_size=3, max_size=3))
turns = st.sampled_from([[np.eye(3)] * 2, [np.diag([-1, -1, 1]), np.eye(3)]])
two, three = rows_of(2, 3), rows_of(3, 3)
table = rows_of(6, 2).map(lambda rows: [rows[:3], rows[3:]])
twelve = rows_of(1, 12).map(lambda rows: rows[0])
K = np.array([[800.0, 0, 320], [0, 800, 240], [0, 0, 1]])
POSES = orientation.poses_from_three_points
rng = partial(np.random.default_rng, 0)
KNOWN = turntable(np.random.default_rng(0), pictures=9, points=25)

CALLS = {
    "similarity_transform": (orientation.similarity_transform, (space, space)),
    "leave_one_out": (orientation.leave_one_out, (space, space)),
    "check_point_rmse": (orientation.check_point_rmse, (space, space)),
    "pictures_for_circle": (orientation.pictures_for_circle, (numbers,)),
    "resect_camera": (orientation.resect_camera, (space, pixels, intrinsics)),
    "poses_from_three_points": (orientation.poses_from_three_points, (space, pixels, intrinsics)),
    "relative_orientation": (orientation.relative_orientation, (pixels, pixels, intrinsics)),
    "pose_from_relative": (orientation.pose_from_relative, (vector, vector)),
    "relative_from_pose": (orientation.relative_from_pose, (matrices, vector)),
    "Observations": (Observations, (indices, indices, pixels, numbers)),
    "Control": (Control, (indices, space, numbers)),
    "Block": (Block, (matrices, st.lists(matrices, max_size=3), space, space)),
    "reprojection_jacobian": (bundle.reprojection_jacobian, (vector, intrinsics, matrices, vector)),
    "solve_normal_block": (bundle.solve_normal_block, (matrices, space, space, vector, space)),
    "connected_parts": (
        lambda *seen: bundle.connected_parts(Observations(*seen), 5),
        (indices, indices, pixels),
    ),
    "normal_blocks": (bundle.normal_blocks, (intrinsics, turns, two, three, table)),
    "squared_error": (
        lambda *block: max(bundle.squared_error(*block), -1) < np.inf,
        (intrinsics, turns, two, three, table),
    ),
    "move_block": (bundle.move_block, (turns, two, three, twelve, three)),
}
#: What is tried below with a whole block, and what the functions return.
WITH_A_BLOCK = {"bundle_adjust", "check_block", "self_calibrate"}
VALUES = {
    "BundleAdjustment",
    "CheckErrors",
    "NormalBlocks",
    "Precision",
    "RelativeOrientation",
    "Resection",
    "SelfCalibration",
    "Similarity",
}


MATCHED = {
    "similarity_transform": (orientation.similarity_transform, (3, 3)),
    "leave_one_out": (orientation.leave_one_out, (3, 3)),
    "resect_camera": (partial(orientation.resect_camera, K=K), (3, 2)),
    "resect_robustly": (lambda X, x: orientation.resect_robustly(X, x, K, rng(), 9.0, 40), (3, 2)),
    "poses_from_three_points": (lambda X, x: POSES(X[:3], x[:3], K), (3, 2)),
    "relative_orientation": (partial(orientation.relative_orientation, K=K), (2, 2)),
}


def finite(result):
    if isinstance(result, tuple | list):
        return all(finite(each) for each in result)
    if isinstance(result, np.ndarray | float):
        return bool(np.isfinite(result).all())
    return True


def test_every_public_function_is_fuzzed():
    public = {*bundle.__all__, *orientation.__all__}
    assert public == {*CALLS, *MATCHED, *WITH_A_BLOCK, *VALUES}


@pytest.mark.parametrize("name", CALLS)
@fuzz
@given(data=st.data())
def test_numbers_come_out_or_a_sentence(name, data):
    function, arguments = CALLS[name]
    drawn = [data.draw(either(each)) for each in arguments]
    assert finite(outcome(function, *drawn))


@pytest.mark.parametrize("name", MATCHED)
@fuzz
@given(count=st.integers(3, 9), flat=st.booleans(), data=st.data())
def test_points_that_fit_together_are_oriented_or_named(name, count, flat, data):
    function, widths = MATCHED[name]
    size = data.draw(st.sampled_from([1e-3, 1, 1e3, 1e6]))
    whole = st.integers(-4, 4).map(float)  # many coincide, or are in line
    number = st.one_of(whole, st.floats(-5, 5)).map(lambda value: size * value)
    rows = [
        np.array(data.draw(st.lists(st.tuples(*[number] * width), min_size=count, max_size=count)))
        for width in widths
    ]
    rows[0][:, -1] *= not flat
    assert finite(outcome(function, *rows))


@fuzz
@given(
    gone=st.lists(st.integers(0, len(KNOWN.observations) - 1), max_size=60, unique=True),
    push=st.floats(0, 1000),
    robust=st.sampled_from([None, 2.5]),
    gauge=st.sampled_from(["inner", "fixed"]),
    seed=st.integers(0, 100),
)
def test_a_damaged_block_is_adjusted_or_named(gone, push, robust, gauge, seed):
    random, seen = np.random.default_rng(seed), KNOWN.observations
    kept = seen.only(np.setdiff1d(np.arange(len(seen)), gone))
    away = push * random.standard_normal(kept.pixels.shape) * (random.random((len(kept), 1)) < 0.2)
    kept = Observations(kept.cameras, kept.points, kept.pixels + away, 0.5)
    fit = outcome(lambda: bundle_adjust(KNOWN.truth, kept, None, gauge, robust, 30))
    if fit:
        assert fit.cost <= fit.costs[0]
        assert finite([fit.residuals, fit.block.points])
        precision = outcome(lambda: fit.precision)
        assert not precision or finite([precision.cameras, precision.points])


@fuzzing(8)
@given(
    gone=st.lists(st.integers(0, len(KNOWN.observations) - 1), max_size=60, unique=True),
    free=st.lists(st.sampled_from(["f", "c", "k1", "k2", "k3"]), max_size=3),
    push=st.sampled_from([0, 1, 100]),
)
def test_the_lens_of_a_damaged_block_is_found_or_named(gone, free, push):
    random, seen = np.random.default_rng(0), KNOWN.observations
    kept = seen.only(np.setdiff1d(np.arange(len(seen)), gone))
    away = push * random.standard_normal(kept.pixels.shape)
    kept = Observations(kept.cameras, kept.points, kept.pixels + away, 0.5)
    found = outcome(lambda: bundle.self_calibrate(KNOWN.truth, kept, None, free, steps=3))
    if found:
        assert finite([*found.corrections.values(), *found.sigma.values(), found.K])
