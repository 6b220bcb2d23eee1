"""What a bundle adjustment takes: ours, SciPy's sparse least squares, and Ceres."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from functools import partial
from importlib.util import find_spec
from typing import Any

from benchmarks.lens import in_turns
from benchmarks.table import Row

ROUNDS = 5
COST = 1e-6  # how much the costs may differ, as a share


def bundling() -> list[Row]:
    """Measure 49 cameras, 7776 points and 31 919 observations by processor time, one thread.

    Ceres is measured if pyceres and pycolmap, which has its cost functions, can be imported; they
    are not among the course's packages.
    """
    code = "import json; from benchmarks import bundle as b; print(json.dumps(b.measured()))"
    # The number of threads of the BLAS can only be set before NumPy is there.
    alone = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    command = [sys.executable, "-c", code]
    output = subprocess.run(command, check=True, env=alone, stdout=subprocess.PIPE)
    return [Row(*cells) for cells in json.loads(output.stdout)]


def measured() -> list[list[Any]]:
    """Return the rows as lists."""
    import numpy as np

    from course_lib.bundle import bundle_adjust
    from data_generators.blocks import large_block

    known = large_block(np.random.default_rng(0))
    start = known.roughly(np.random.default_rng(1), 0.002, 1.0)
    seen = known.observations
    ours = partial(bundle_adjust, start, seen, tolerance=1e-8)
    theirs = partial(by_scipy, start, seen)
    found, (cost, count) = ours(), theirs()
    _check_equal(found.cost, cost)
    mine, peer = in_turns([ours, theirs], ROUNDS)
    ours_count = len(found.costs) - 1
    share = f"costs {abs(cost / found.cost - 1):.0e} apart"
    rows = [
        ["49 cameras, 7776 points", mine, "ms", f"SciPy, sparse, {share}", peer, "≤ 0.35 ×"],
        ["an iteration", mine / ours_count, "ms", "SciPy", peer / count, ""],
    ]
    if find_spec("pyceres") and find_spec("pycolmap"):
        rows += _against_ceres(ours, start, seen, found)
    return rows


def _check_equal(ours: float, theirs: float) -> None:
    if abs(theirs / ours - 1) > COST:
        raise RuntimeError(f"the minima differ: {ours} and {theirs}")


def _against_ceres(ours: Any, start: Any, seen: Any, found: Any) -> list[list[Any]]:
    """Return the row of Ceres, whose problem is built outside of the measured time."""
    import statistics
    import time

    taken, mine, count = [], [], 0
    for _ in range(ROUNDS):
        solve = ceres_problem(start, seen)
        begin = time.process_time()
        cost, count = solve()
        taken.append(1000 * (time.process_time() - begin))
        _check_equal(found.cost, cost)
        begin = time.process_time()
        ours()
        mine.append(1000 * (time.process_time() - begin))
    per_step = statistics.median(mine) / (len(found.costs) - 1)
    return [
        [
            "an iteration",
            per_step,
            "ms",
            "Ceres, autodiff",
            statistics.median(taken) / count,
            "≤ 2 ×",
        ]
    ]


def by_scipy(start: Any, seen: Any) -> tuple[float, int]:
    """Return the cost that SciPy finds with analytic sparse derivatives, and its iterations."""
    import numpy as np
    from scipy.optimize import least_squares
    from scipy.sparse import csr_array

    from course_lib.bundle.derivatives import Position

    first, v, ones = Position.of(start), len(start.R), np.ones(len(seen))
    columns = np.empty((len(seen), 2, 9), np.int32)
    columns[:, :, :6] = (6 * seen.cameras[:, None] + np.arange(6))[:, None]
    columns[:, :, 6:] = (6 * v + 3 * seen.points[:, None] + np.arange(3))[:, None]
    ends = np.arange(0, columns.size + 1, 9)

    def position(x: Any) -> Any:
        return first.moved(x[: 6 * v].reshape(v, 6), x[6 * v :].reshape(-1, 3))

    def residuals(x: Any) -> Any:
        return position(x).image(seen).residuals.T.ravel()

    def jacobian(x: Any) -> Any:
        turns, moves = position(x).image(seen).derivatives(ones)
        turns = np.einsum("akm,mkj->ajm", turns, _turn_slopes(x[: 6 * v].reshape(v, 6), seen))
        rows = np.concatenate([turns, -moves, moves], axis=1).transpose(2, 0, 1)
        return csr_array((rows.ravel(), columns.ravel(), ends), (2 * len(seen), len(x)))

    x = np.zeros(6 * v + 3 * len(start.points))
    fit = least_squares(residuals, x, jacobian, x_scale="jac", ftol=1e-8, xtol=1e-12, gtol=1e-12)
    return 2 * float(fit.cost), int(fit.njev)


def _turn_slopes(cameras: Any, seen: Any) -> Any:
    """Return the left Jacobians of SO(3) of each observation's camera, (m, 3, 3)."""
    import numpy as np

    from course_lib.transforms.exponential import _average_rotation

    return np.array([_average_rotation(turn) for turn in cameras[:, :3]])[seen.cameras]


def ceres_problem(start: Any, seen: Any) -> Any:
    """Return a function that solves the block with Ceres: its cost and iterations.

    A pose is a quaternion and a translation, seven numbers in one; as pyceres has no manifold for
    that, a residual for each camera holds the quaternion's length.
    """
    import numpy as np
    import pyceres
    from pycolmap import CameraModelId, Rotation3d
    from pycolmap.cost_functions import ReprojErrorCost

    # COLMAP's pixels begin at the corner, ours in the middle of the first pixel.
    problem, K, pixels = pyceres.Problem(), start.K[0], seen.pixels + 0.5
    camera = np.array([K[0, 0], K[1, 1], K[0, 2] + 0.5, K[1, 2] + 0.5])
    pairs = zip(start.R, start.t, strict=True)
    poses = [np.concatenate([Rotation3d(R).quat, t]) for R, t in pairs]
    points = [point.copy() for point in start.points]
    for i, j, pixel in zip(seen.cameras, seen.points, pixels, strict=True):
        cost = ReprojErrorCost(CameraModelId.PINHOLE, pixel)
        problem.add_residual_block(cost, None, [points[j], poses[i], camera])
    lengths = [_length_cost(pyceres) for _ in poses]
    for pose, cost in zip(poses, lengths, strict=True):
        problem.add_residual_block(cost, None, [pose])
    problem.set_parameter_block_constant(camera)
    options = pyceres.SolverOptions()
    options.linear_solver_type = pyceres.LinearSolverType.SPARSE_SCHUR
    options.num_threads, options.function_tolerance = 1, 1e-9
    options.minimizer_progress_to_stdout = False

    def solve() -> tuple[float, int]:
        summary = pyceres.SolverSummary()
        pyceres.solve(options, problem, summary)
        steps = summary.num_successful_steps + summary.num_unsuccessful_steps - 1
        return 2 * summary.final_cost / float(seen.sigma[0]) ** 2, steps

    return solve


def _length_cost(pyceres: Any) -> Any:
    """Return a residual that is zero while the quaternion of a pose has length 1."""

    class Length(pyceres.CostFunction):
        def __init__(self) -> None:
            super().__init__()
            self.set_num_residuals(1)
            self.set_parameter_block_sizes([7])

        def Evaluate(self, parameters: Any, residuals: Any, jacobians: Any) -> bool:
            q = parameters[0][:4]
            residuals[0] = 1e7 * (q @ q - 1)
            if jacobians is not None and jacobians[0] is not None:
                jacobians[0][:] = 0
                jacobians[0][:4] = 2e7 * q
            return True

    return Length()
