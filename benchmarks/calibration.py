"""What a calibration takes, ours and OpenCV's, to the same minimum."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from functools import partial
from typing import Any

from benchmarks.lens import in_turns
from benchmarks.table import Row

#: Views, columns and rows of the board, rounds, and the goal.
SETS = ((13, 9, 6, 41, "≤ 0.5 ×"), (50, 11, 8, 25, "≤ 0.25 ×"), (200, 25, 20, 7, "≤ 0.2 ×"))
SIZE = (1280, 960)
K = [[800.0, 0, 650], [0, 810, 470], [0, 0, 1]]
COEFFICIENTS = [-0.25, 0.1, 0.001, -0.0008, -0.02]


def calibrating() -> list[Row]:
    """Measure calibrations by processor time, with one thread."""
    code = "import json; from benchmarks import calibration as c; print(json.dumps(c.measured()))"
    # The number of threads of the BLAS can only be set before NumPy is there.
    alone = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    command = [sys.executable, "-c", code]
    output = subprocess.run(command, check=True, env=alone, capture_output=True)
    return [Row(*cells) for cells in json.loads(output.stdout)]


def measured() -> list[list[Any]]:
    """Return the rows as lists; the pixels are those that OpenCV's single precision can hold."""
    import cv2
    import numpy as np

    from course_lib.calibration import board_points, calibrate
    from data_generators.board_observations import observe_board

    cv2.setNumThreads(1)
    rows = []
    for views, columns, board_rows, rounds, goal in SETS:
        board, rng = board_points(columns, board_rows, 30), np.random.default_rng(0)
        seen = observe_board(rng, board, K, COEFFICIENTS, SIZE, views, noise=0.2)
        pixels = [np.float32(view) for view in seen.pixels]
        ours = partial(calibrate, board, pixels, SIZE)
        boards = [np.float32(board)] * views
        theirs = partial(cv2.calibrateCamera, boards, pixels, SIZE, None, None)
        found, (rms, other, *_) = ours(), theirs()
        apart = f"{abs(found.rms - rms):.0e} px RMS, {np.abs(found.K - other).max():.0e} px apart"
        mine, peer = in_turns([ours, theirs], rounds)
        what = f"calibrate, {views} views × {columns * board_rows} points"
        rows.append([what, mine, "ms", f"cv2.calibrateCamera, {apart}", peer, goal])
    return rows
