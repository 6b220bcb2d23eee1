"""What lens distortion takes: undoing it for points, and for pictures with a map that is kept."""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from typing import Any

from benchmarks.compute import processor_time
from benchmarks.table import Row

#: Coefficients, and the field by half its width and height (tangents).
LENSES = {
    "Brown, 53°": ([-0.25349, 0.11868, -0.00028, 0.00005, 0], (0.5, 0.37)),
    "Brown, strong, 69°": ([-0.3, 0.12, 0.001, -0.0008, -0.02], (0.69, 0.52)),
    "rational and prism, 69°": (
        [-0.3, 0.12, 0.001, -0.0008, -0.02, 0.1, 0.02, 0.01, 0.001, 0.002, -0.001, 0.0005],
        (0.69, 0.52),
    ),
}
#: f in px: what errors are given by.
FOCAL = 800.0


def distorting() -> list[Row]:
    """Measure the inverse and the maps by processor time, with one thread."""
    code = "import json; from benchmarks import lens; print(json.dumps(lens.measured()))"
    # The number of threads of the BLAS can only be set before NumPy is there.
    alone = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    command = [sys.executable, "-c", code]
    output = subprocess.run(command, check=True, env=alone, capture_output=True)
    return [Row(*cells) for cells in json.loads(output.stdout)]


def measured() -> list[list[Any]]:
    """Return the rows as lists."""
    import cv2

    cv2.setNumThreads(1)
    return [*_failures(), *_inverse(), *_pictures()]


def _failures(count: int = 400) -> list[list[Any]]:
    """Count strong lenses, none of which folds over, in whose field some point goes astray."""
    import numpy as np

    from course_lib.distortion import distort, undistort_points
    from tests.strong_lenses import strong_lenses

    contenders = {
        "ours": undistort_points,
        "cv2.undistortPoints, as by default": _by_opencv,
        "cv2.undistortPoints, 100 steps": partial(_by_opencv, steps=100),
    }
    lenses = [(distort(field, k), k, field) for k, field in strong_lenses(count)]
    rows = []
    for most in (1e-6, 0.01):
        ours, *theirs = (
            # A point that comes back as NaN is astray, too.
            100 * np.mean([not FOCAL * np.abs(way(b, k) - p).max() <= most for b, k, p in lenses])
            for way in contenders.values()
        )
        what = f"inverse, {count} strong lenses: more than {most:g} px off at f = {FOCAL:g} px"
        for peer, share in zip(list(contenders)[1:], theirs, strict=True):
            rows.append([what, ours, "%", peer, share, "0 %"])
    return rows


def _by_opencv(bent: Any, k: Any, steps: int | None = None) -> Any:
    """Return what OpenCV makes of distorted points, after its own number of steps or another."""
    import cv2
    import numpy as np

    how = {} if steps is None else {"criteria": (cv2.TERM_CRITERIA_COUNT, steps, 0.0)}
    return cv2.undistortPoints(bent[:, None], np.eye(3), k, **how)[:, 0]


def _inverse(rounds: int = 25) -> list[list[Any]]:
    """Measure 100 000 points: OpenCV by default is fast but off, so it gets the steps it needs."""
    import numpy as np

    from course_lib.distortion import distort, undistort_points

    rows = []
    for name, (coefficients, reach) in LENSES.items():
        k = np.array(coefficients)
        points = np.random.default_rng(0).uniform(-1, 1, (100_000, 2)) * reach
        bent = distort(points, k)

        theirs = partial(_by_opencv, bent, k)

        def error(found: Any, points: Any = points) -> float:
            return FOCAL * float(np.abs(found - points).max())

        ours = partial(undistort_points, bent, k)
        steps = {
            "1e-6 px": next(n for n in range(5, 300) if error(theirs(n)) <= 1e-6),
            "our error": next(n for n in range(5, 300) if error(theirs(n)) <= 2 * error(ours())),
        }
        contenders = [ours, *(partial(theirs, n) for n in steps.values())]
        mine, *others = in_turns(contenders, rounds)
        what = f"inverse, 1e5 points, {name}: to {error(ours()):.0e} px"
        for (goal, n), other in zip(steps.items(), others, strict=True):
            peer = f"cv2.undistortPoints, {n} steps, to {goal}"
            rows.append([what, mine, "ms", peer, other, "≤ 0.4 ×" if goal == "our error" else ""])
    return rows


def _pictures(rounds: int = 41) -> list[list[Any]]:
    """Measure pictures in colour and grey, and the map that is computed once."""
    import cv2
    import numpy as np
    from skimage.data import astronaut

    from course_lib.distortion import undistortion_map
    from course_lib.remapping import undistort_picture

    k, rows = np.array(LENSES["Brown, strong, 69°"][0]), []
    for size in ((640, 480), (1280, 960), (4000, 3000)):
        K = np.array(
            [[0.72 * size[0], 0, size[0] / 2], [0, 0.72 * size[0], size[1] / 2], [0, 0, 1]]
        )
        colour = cv2.resize(astronaut(), size, interpolation=cv2.INTER_CUBIC)
        for image in (colour, np.ascontiguousarray(colour[..., 1])):
            ours = partial(undistort_picture, image, K, k)
            peer = partial(cv2.undistort, image, K, k)
            apart = np.abs(ours().astype(int) - peer()).max()
            what = f"undistort {size[0]} × {size[1]} × {image.ndim * 2 - 3}, kept map"
            mine, theirs = in_turns([ours, peer], rounds if size[0] < 2000 else rounds // 4)
            told = f"cv2.undistort, {apart} grey levels apart"
            rows.append([what, mine, "ms", told, theirs, "≤ 0.6 ×"])
        ours = partial(undistortion_map, K, k, size)
        peer = partial(cv2.initUndistortRectifyMap, K, k, None, K, size, cv2.CV_32FC1)
        mine, theirs = in_turns([ours, peer], rounds // 4)
        name = "cv2.initUndistortRectifyMap"
        rows.append([f"its map, {size[0]} × {size[1]}", mine, "ms", name, theirs])
    return rows


def in_turns(functions: list[Callable[[], object]], rounds: int) -> list[float]:
    """Return the median processor times of functions that take turns, ms; after one round."""
    times = [[processor_time(function) for function in functions] for _ in range(rounds + 1)]
    return [statistics.median(taken) for taken in zip(*times[1:], strict=True)]
