"""Whatever goes in: either the answer is right, or a documented error comes. Nothing else."""

import numpy as np
import pytest
from fuzzing import fuzzing, mischief, often_equal, outcome, rows_of
from hypothesis import HealthCheck, assume, given
from hypothesis import strategies as st

from course_lib import homography, least_squares, resection
from course_lib.homography import apply_homography
from course_lib.least_squares import solve_qr, solve_robust

fuzz = fuzzing(25, HealthCheck.filter_too_much)


def pairs(one, other, least):
    """Return two tables with as many rows."""
    return st.integers(least, least + 4).flatmap(
        lambda count: st.tuples(rows_of(count, one), rows_of(count, other))
    )


def in_row(count):
    return st.lists(often_equal, min_size=count, max_size=count)


systems = st.tuples(st.integers(1, 7), st.integers(1, 4)).flatmap(
    lambda size: st.tuples(rows_of(*size), in_row(size[0]))
)
rows = st.integers(1, 6).flatmap(lambda count: st.tuples(in_row(count), in_row(count)))
size = st.tuples(st.integers(1, 99), st.integers(1, 99))
table = st.tuples(st.integers(1, 4), st.integers(1, 4)).flatmap(
    lambda shape: st.lists(rows_of(shape[1], 2), min_size=shape[0], max_size=shape[0])
)


def dlt(least=4):
    return pairs(2, 2, least)


#: Arguments of every public function; a tuple from one strategy is several arguments.
ARGUMENTS = {
    "solve_one_unknown": rows,
    "fit_line": rows,
    "fit_affine": dlt(2),
    "solve_normal_equations": systems,
    "solve_qr": systems,
    "solve_svd": systems,
    "solve_weighted": systems.flatmap(
        lambda system: st.tuples(*map(st.just, system), in_row(len(system[1])))
    ),
    "solve_robust": systems,
    "solve_homogeneous": systems.map(lambda system: system[:1]),
    "parameter_covariance": systems,
    "huber_weights": st.tuples(in_row(3), often_equal),
    "apply_homography": st.tuples(rows_of(3, 2), rows_of(3, 3)),
    "normalise_points": dlt(1).map(lambda pair: pair[:1]),
    "homography_dlt": dlt(),
    "fit_homography": dlt(),
    "fit_homographies": dlt().map(lambda pair: (pair[0], [pair[1]])),
    "refine_homography": dlt().flatmap(lambda pair: st.tuples(rows_of(3, 3), *map(st.just, pair))),
    "camera_dlt": pairs(3, 2, 5),
    "dlt_parameters": pairs(3, 2, 5),
    "fit_camera": pairs(3, 2, 5),
    "decompose_projection": st.tuples(rows_of(3, 4)),
    "correction_table": st.tuples(dlt(1), size, size).map(lambda a: (*a[0], a[1], a[2])),
    "correction_from_table": st.tuples(rows_of(3, 2), table, size),
    "polynomial_correction": st.tuples(dlt(3), size, st.integers(-1, 4)).map(
        lambda a: (*a[0], a[1], a[2])
    ),
    "correction_from_polynomial": st.tuples(rows_of(3, 2), rows_of(6, 2), size),
}
HOMES = (least_squares, homography, resection)


def found(name):
    return next(getattr(home, name) for home in HOMES if hasattr(home, name))


@pytest.mark.parametrize("name", ARGUMENTS)
@fuzz
@given(data=st.data())
def test_answer_or_documented_error(name, data):
    arguments = list(data.draw(ARGUMENTS[name]))
    if data.draw(st.integers(0, 3)) == 0:
        arguments[data.draw(st.integers(0, len(arguments) - 1))] = data.draw(mischief)
    answer = outcome(found(name), *arguments)
    for value in answer if isinstance(answer, tuple) else [answer]:
        if value is not None and name != "apply_homography":  # rows of NaN: points at infinity
            assert np.isfinite(np.asarray(value, dtype=float)).all()


def test_every_public_function_is_fuzzed():
    elsewhere = {"Fit", "RobustFit", "CameraFit", "HeldOut", "levenberg_marquardt", "hold_out"}
    public = {name for home in HOMES for name in home.__all__}
    assert public == set(ARGUMENTS) | elsewhere


@fuzz
@given(system=systems)
def test_what_is_left_is_perpendicular(system):
    x = outcome(solve_qr, *system)
    assume(x is not None)
    A, b = map(np.array, system)
    lengths = np.linalg.norm(A, axis=0) * np.linalg.norm(np.column_stack([A * x, b]))
    assert (np.abs(A.T @ (A @ x - b)) <= 1e-9 * lengths).all()


@fuzz
@given(pair=dlt())
def test_four_points_are_met_and_fits_are_no_worse(pair):
    points, targets = map(np.array, pair)
    H = outcome(homography.homography_dlt, points, targets)
    best = outcome(homography.fit_homography, points, targets)
    assume(H is not None and best is not None)
    there, better = (outcome(apply_homography, points, each) for each in (H, best))
    assume(there is not None and better is not None)
    assume(np.isfinite(there).all() and np.abs(there).max() < 1e3 * np.abs(targets).max())
    squares, least = (np.sum((each - targets) ** 2) for each in (there, better))
    size = np.sum((targets - targets.mean(axis=0)) ** 2)
    if squares < 0.1 * size:  # else there may be several minima
        assert least <= squares * (1 + 1e-6) + 1e-9 * size
    if len(points) == 4 and np.linalg.cond(H) < 1e6:
        assert squares <= 1e-9 * size


@fuzz
@given(seed=st.integers(0, 10**6), slips=st.integers(0, 4), size=st.floats(-1e6, 1e6))
def test_slips_of_any_size_move_a_robust_line_little(seed, slips, size):
    rng = np.random.default_rng(seed)
    A = np.column_stack([np.linspace(0, 1, 20), np.ones(20)])
    b = A @ [2, -1] + 0.1 * rng.normal(size=20)
    b[rng.permutation(20)[:slips]] += size
    assert np.abs(A @ (solve_robust(A, b).x - [2, -1])).max() < 0.5
