"""What estimating takes: homographies of one and of many pictures, cameras, least squares."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from functools import partial
from typing import Any

from benchmarks.lens import in_turns
from benchmarks.table import Row


def estimating() -> list[Row]:
    """Measure homographies and least squares by processor time, with one thread."""
    code = "import json; from benchmarks import estimate; print(json.dumps(estimate.measured()))"
    # The number of threads of the BLAS can only be set before NumPy is there.
    alone = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    command = [sys.executable, "-c", code]
    output = subprocess.run(command, check=True, env=alone, capture_output=True)
    return [Row(*cells) for cells in json.loads(output.stdout)]


def measured() -> list[list[Any]]:
    """Return the rows as lists."""
    import cv2

    cv2.setNumThreads(1)
    return [*_homographies(), *_curve()]


def _views(count: int, pictures: int, noise: float = 0.3) -> tuple[Any, Any]:
    """Return points of a plane, and their measured pixels in tilted views."""
    import numpy as np

    from course_lib.homography import apply_homography

    rng = np.random.default_rng(0)
    if count == 54:
        points = np.stack(np.meshgrid(np.arange(9), np.arange(6)), -1).reshape(-1, 2) * 30.0
    else:
        points = rng.uniform(0, 300, (count, 2))
    pixels = []
    for _ in range(pictures):
        H = np.array([[1.5, 0.2, 100], [-0.1, 1.4, 80], [4e-4, -3e-4, 1]])
        H += rng.normal(size=(3, 3)) * [[0.1, 0.1, 10], [0.1, 0.1, 10], [2e-4, 2e-4, 0]]
        pixels.append(apply_homography(points, H) + noise * rng.normal(size=points.shape))
    return points, np.array(pixels)


def _excess(points: Any, pixels: Any, ours: Any, theirs: Any) -> float:
    """Return by how much our root mean square is larger than theirs, px; in the worst picture."""
    import numpy as np

    from course_lib.homography import apply_homography

    def rms(H: Any, seen: Any) -> float:
        return float(np.sqrt(np.mean(((apply_homography(points, H) - seen) ** 2).sum(axis=1))))

    return max(rms(a, p) - rms(b, p) for a, b, p in zip(ours, theirs, pixels, strict=True))


def _homographies(rounds: int = 101) -> list[list[Any]]:
    """Measure the smallest reprojection error, of both to the same minimum."""
    import cv2

    from course_lib.homography import fit_homographies, fit_homography

    rows = []
    for count, pictures, goal in ((54, 50, "≤ 0.3 ×"), (54, 1, ""), (10_000, 1, "≤ 0.8 ×")):
        points, pixels = _views(count, pictures)

        def theirs(points: Any = points, pixels: Any = pixels) -> Any:
            return [cv2.findHomography(points, seen)[0] for seen in pixels]

        ours: Any = partial(fit_homographies, points, pixels)
        if pictures == 1:
            ours = partial(fit_homography, points, pixels[0])
        found = ours() if pictures > 1 else [ours()]
        mine, other = in_turns([ours, theirs], rounds)
        excess = _excess(points, pixels, found, theirs())
        peer = f"cv2.findHomography, our RMS − theirs ≤ {excess:.0e} px"
        rows.append([f"homographies, {pictures} × {count} points", mine, "ms", peer, other, goal])
    return rows


def _curve(rounds: int = 101) -> list[list[Any]]:
    """Measure Levenberg–Marquardt on a curve with three unknowns."""
    import numpy as np
    from scipy.optimize import least_squares

    from course_lib.least_squares import levenberg_marquardt

    t = np.linspace(0, 3, 200)
    seen = 2 * np.exp(-1.3 * t) + 0.5 + 0.02 * np.random.default_rng(0).normal(size=200)

    def residuals(x: Any) -> Any:
        return x[0] * np.exp(-x[1] * t) + x[2] - seen

    def jacobian(x: Any) -> Any:
        decay = np.exp(-x[1] * t)
        return np.stack([decay, -x[0] * t * decay, np.ones(200)], axis=1)

    ours = partial(levenberg_marquardt, lambda x: (residuals(x), jacobian(x)), np.ones(3))
    theirs = partial(least_squares, residuals, np.ones(3), jacobian, method="lm", xtol=1e-12)
    apart = float(np.abs(ours().parameters - theirs().x).max())
    mine, other = in_turns([ours, theirs], rounds)
    peer = f"scipy.optimize.least_squares (MINPACK), {apart:.0e} apart"
    return [["Levenberg–Marquardt, a decay seen 200 times", mine, "ms", peer, other]]
