"""What corner refinement reaches on rendered pictures, whose corners are known, and its time."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from functools import partial
from typing import Any

from benchmarks.lens import in_turns
from benchmarks.table import Row

#: Blur in px and noise in grey levels of 255.
PICTURES = {"sharp": (0.5, 2.0), "usual": (0.8, 2.0), "soft": (1.5, 2.0), "noisy": (0.8, 6.0)}
WINDOWS = (5, 11)
VIEWS = 6


def refining() -> list[Row]:
    """Measure errors in px and the time for a picture of 54 corners, with one thread."""
    code = "import json; from benchmarks import corners; print(json.dumps(corners.measured()))"
    # The number of threads of the BLAS can only be set before NumPy is there.
    alone = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    command = [sys.executable, "-c", code]
    output = subprocess.run(command, check=True, env=alone, capture_output=True)
    return [Row(*cells) for cells in json.loads(output.stdout)]


def measured() -> list[list[Any]]:
    """Return the rows as lists."""
    import cv2
    import numpy as np

    from course_lib.detection.corner_fit import refine_corners
    from data_generators.calibration_sets import calibration_set

    cv2.setNumThreads(1)
    rows = []
    for name, (blur, noise) in PICTURES.items():
        rendered = calibration_set(
            VIEWS, rng=np.random.default_rng(7), blur=blur, noise=noise, samples=4
        )
        rng = np.random.default_rng(0)
        starts = [v.points + rng.uniform(-1, 1, v.points.shape) for v in rendered.views]
        pairs = list(zip(rendered.views, starts, strict=True))
        ours = _rms([refine_corners(v.picture, s) - v.points for v, s in pairs])
        what = f"{name}: blur {blur:g} px, noise {noise:g} of 255: RMS"
        for window in WINDOWS:
            theirs = _rms([_opencv(v.picture, s, window) - v.points for v, s in pairs])
            goal = "≤ 0.5 ×" if window == WINDOWS[0] else ""
            rows.append([what, ours, "px", f"cv2.cornerSubPix, window {window}", theirs, goal])
    view, start = pairs[0]
    contenders = [
        partial(refine_corners, view.picture, start),
        partial(_opencv, view.picture, start, WINDOWS[0]),
    ]
    mine, other = in_turns(contenders, 25)
    rows.append(["54 corners", mine, "ms", f"cv2.cornerSubPix, window {WINDOWS[0]}", other])
    return rows


def _opencv(picture: Any, start: Any, window: int) -> Any:
    import cv2
    import numpy as np

    stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_COUNT, 100, 1e-4)
    corners = start.astype(np.float32)
    return cv2.cornerSubPix(picture, corners, (window, window), (-1, -1), stop).reshape(-1, 2)


def _rms(errors: Any) -> float:
    import numpy as np

    return float(np.sqrt(np.mean(np.sum(np.square(np.concatenate(errors)), axis=1))))
