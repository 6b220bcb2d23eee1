"""What two views take: triangulation, fundamental matrices among wrong matches, real pairs."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from functools import partial
from typing import Any

from benchmarks.compute import processor_time
from benchmarks.lens import in_turns
from benchmarks.table import Row

SIZE = 640, 480
THRESHOLD, CONFIDENCE = 1.5, 0.99


def epipolar() -> list[Row]:
    """Measure by processor time, with one thread."""
    code = "import json; from benchmarks import epipolar; print(json.dumps(epipolar.measured()))"
    # The number of threads of the BLAS can only be set before NumPy is there.
    alone = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    command = [sys.executable, "-c", code]
    output = subprocess.run(command, check=True, env=alone, capture_output=True)
    return [Row(*cells) for cells in json.loads(output.stdout)]


def measured() -> list[list[Any]]:
    """Return the rows as lists."""
    import cv2

    cv2.setNumThreads(1)
    return [*_triangulation(), *_wrong_matches(0.3), *_wrong_matches(0.6), *_real_pairs()]


def _cameras() -> Any:
    """Return intrinsics and two camera matrices that look at points 4 to 10 away."""
    import numpy as np

    from course_lib.camera import camera_matrix
    from course_lib.transforms import rotation_from_vector

    K = np.array([[800.0, 0, 320], [0, 800, 240], [0, 0, 1]])
    R = rotation_from_vector([0.02, -0.15, 0.05])
    return camera_matrix(K, np.eye(3), np.zeros(3)), camera_matrix(K, R, [-1, 0.1, 0.1])


def _triangulation() -> list[list[Any]]:
    """Measure the time, and the errors of the points in samples of noise."""
    import cv2
    import numpy as np

    from course_lib.camera import project
    from course_lib.triangulation import triangulate

    P1, P2 = _cameras()
    rows = []
    for count, rounds, goal in ((1000, 301, 0.25), (100_000, 31, 0.2), (1_000_000, 7, 0.15)):
        squares = np.zeros(2)
        for seed in range(200_000 // count if count < 1e5 else 2):
            rng = np.random.default_rng(seed)
            points = rng.uniform(-1, 1, (count, 3)) * [2, 1.5, 3] + [0, 0, 7]
            pixels = [project(points, P) + 0.5 * rng.normal(size=(count, 2)) for P in (P1, P2)]
            columns = [p.T.copy() for p in pixels]
            ours = partial(triangulate, *pixels, P1, P2)
            theirs = partial(cv2.triangulatePoints, P1, P2, *columns)
            X = theirs()
            for i, found in enumerate((ours(), (X[:3] / X[3]).T)):
                squares[i] += ((found - points) ** 2).sum() / count
        mine, other = in_turns([ours, theirs], rounds)
        ratio = np.sqrt(squares[0] / squares[1])
        peer = f"cv2.triangulatePoints, our 3-D RMS / theirs {ratio:.6f}"
        rows.append([f"triangulate {count:.0e} points", mine, "ms", peer, other, f"≤ {goal} ×"])
    return rows


def matches(seed: int, wrong: float, count: int = 500, noise: float = 0.5) -> Any:
    """Return measured matches, their true places, and which are right."""
    import numpy as np

    from course_lib.camera import camera_matrix, project
    from course_lib.transforms import rotation_from_vector

    rng = np.random.default_rng(seed)
    K = np.array([[800.0, 0, 320], [0, 800, 240], [0, 0, 1]])
    R, t = rotation_from_vector(0.15 * rng.normal(size=3)), rng.normal(size=3)
    P2, exact = camera_matrix(K, R, t / np.linalg.norm(t)), np.empty((0, 2, 2))
    while len(exact) < count:
        pixels = rng.uniform((0, 0), SIZE, (count, 2))
        rays = np.column_stack([pixels, np.ones(count)]) @ np.linalg.inv(K).T
        seen = project(rays * rng.uniform(4, 12, (count, 1)), P2)
        inside = ((seen >= 0) & (seen < SIZE)).all(axis=1)
        exact = np.concatenate([exact, np.stack([pixels, seen], axis=1)[inside]])[:count]
    right = rng.permutation(count) >= round(wrong * count)
    measured = exact + noise * rng.normal(size=exact.shape)
    measured[~right, 1] = rng.uniform((0, 0), SIZE, ((~right).sum(), 2))
    return measured[:, 0].copy(), measured[:, 1].copy(), exact, right


def _wrong_matches(wrong: float, scenes: int = 60) -> list[list[Any]]:
    """Measure robust fundamental matrices: errors at the true places of right matches, time."""
    import cv2
    import numpy as np

    from course_lib.epipolar import ransac_fundamental, sampson_error

    names = "ours", "USAC_MAGSAC", "FM_RANSAC"
    taken, errors = ({name: [] for name in names} for _ in range(2))
    for seed in range(scenes):
        one, other, exact, right = matches(seed, wrong)
        rng, found = np.random.default_rng(seed), {}

        def solve(name: str, pair: Any = (one, other), rng: Any = rng, found: Any = found) -> None:
            if name == "ours":
                found[name] = ransac_fundamental(*pair, rng, THRESHOLD, CONFIDENCE).F
            else:
                flag = getattr(cv2, name)
                found[name] = cv2.findFundamentalMat(*pair, flag, THRESHOLD, CONFIDENCE)[0]

        for name in names:
            taken[name].append(processor_time(partial(solve, name)))
            off = sampson_error(exact[right, 0], exact[right, 1], found[name])
            errors[name].append(float(np.sqrt(np.mean(off * off))))
    what = f"F, 500 matches, {wrong:.0%} wrong, {scenes} scenes"
    middle = {name: float(np.median(values)) for name, values in errors.items()}
    mean = {name: float(np.mean(values)) for name, values in errors.items()}
    worst = {name: max(values) for name, values in errors.items()}
    times = {name: float(np.median(values)) for name, values in taken.items()}
    return [
        [f"{what}: RMS, median", middle["ours"], "px", "MAGSAC", middle["USAC_MAGSAC"], "≤ 1 ×"],
        [f"{what}: RMS, mean", mean["ours"], "px", "MAGSAC", mean["USAC_MAGSAC"], "≤ 1 ×"],
        [f"{what}: RMS, worst", worst["ours"], "px", "MAGSAC", worst["USAC_MAGSAC"], "≤ 2 px"],
        [f"{what}: time", times["ours"], "ms", "FM_RANSAC", times["FM_RANSAC"], "≤ 1 ×"],
        [f"{what}: time", times["ours"], "ms", "MAGSAC", times["USAC_MAGSAC"]],
    ]


def _real_pairs() -> list[list[Any]]:
    """Measure the relative pose by SIFT's matches in OpenCV's 13 pairs, against calibration."""
    import cv2
    import numpy as np

    from course_lib.calibration import board_points, calibrate_stereo
    from course_lib.data import fetch
    from course_lib.distortion import undistort_pixels
    from course_lib.epipolar import ransac_pose

    numbers = [n for n in range(1, 15) if n != 10]
    pictures = [
        [
            cv2.imread(str(fetch(f"opencv_stereo/{side}{n:02d}.jpg")), cv2.IMREAD_GRAYSCALE)
            for n in numbers
        ]
        for side in ("left", "right")
    ]
    corners = [[_corners(picture) for picture in side] for side in pictures]
    truth = calibrate_stereo(board_points(9, 6, 30), *corners, SIZE)
    pairs = np.concatenate([_sift(*pair) for pair in zip(*pictures, strict=True)])
    one = undistort_pixels(pairs[:, 0], truth.K_left, truth.coefficients_left)
    other = undistort_pixels(pairs[:, 1], truth.K_right, truth.coefficients_right)
    found = ransac_pose(one, other, truth.K_left, truth.K_right, np.random.default_rng(0))
    turn = np.degrees(2 * np.arcsin(np.linalg.norm(found.R - truth.R) / np.sqrt(8)))
    along = truth.t / np.linalg.norm(truth.t)
    aside = np.degrees(2 * np.arcsin(np.linalg.norm(found.t - along) / 2))
    what = f"real pairs, {len(pairs)} matches, {found.fits.mean():.0%} fit"
    return [
        [f"{what}: rotation off", float(turn), "°", "", None, "≤ 0.5°"],
        [f"{what}: baseline off", float(aside), "°", "", None, "≤ 1°"],
    ]


def _corners(picture: Any) -> Any:
    import cv2

    coarse = cv2.findChessboardCorners(picture, (9, 6))[1]
    return cv2.cornerSubPix(picture, coarse, (5, 5), (-1, -1), (3, 100, 1e-6)).reshape(-1, 2)


def _sift(left: Any, right: Any) -> Any:
    """Return matches of SIFT that pass the ratio test, (N, 2, 2)."""
    import cv2
    import numpy as np

    sift = cv2.SIFT_create(4000)
    (one, first), (other, second) = (sift.detectAndCompute(p, None) for p in (left, right))
    found = cv2.BFMatcher().knnMatch(first, second, k=2)
    kept = [best for best, next_ in found if best.distance < 0.8 * next_.distance]
    return np.array([[one[m.queryIdx].pt, other[m.trainIdx].pt] for m in kept])
