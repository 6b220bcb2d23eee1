"""How often a calibration comes to the right minimum, ours and OpenCV's, with the same pixels."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.table import Row
from course_lib.calibration import CameraModel, calibrate
from tests.board_views import SIZE, random_set

MODEL = CameraModel(coefficients=("k1", "k2", "p1", "p2"))
#: OpenCV's limits of steps and change: by default, and until it comes to rest.
PEERS = {
    "cv2.calibrateCamera, 30 steps as by default": (3, 30, float(np.finfo(float).eps)),
    "cv2.calibrateCamera, 300 steps": (3, 300, 1e-15),
}
#: Without a start; and with the true f times 0.3 to 5, the principal point off by 0 or 400 px.
NO_START = (None,)
BAD_STARTS = tuple((factor, shift) for factor in (0.3, 0.5, 2, 3, 5) for shift in (0, 400))
#: A minimum is the right one if its RMS is not larger than the smallest by more, px.
APART = 1e-6

Start = tuple[float, float] | None


def converging() -> list[Row]:
    """Count the right minima; neither chance nor the clock takes part in it."""
    rows = []
    for what, sets, starts in (
        ("400 random sets", 400, NO_START),
        ("40 random sets, 10 bad starts each (ours has its closed form, too)", 40, BAD_STARTS),
    ):
        ours, *theirs = 100 * reached(range(sets), starts).mean(axis=0)
        for peer, share in zip(PEERS, theirs, strict=True):
            rows.append(Row(f"{what}: the right minimum", ours, "%", peer, share, "≥ 1 ×"))
    return rows


def reached(seeds: Iterable[int], starts: Sequence[Start]) -> NDArray[np.bool_]:
    """Return whether ours and each of the peers came to the right minimum.

    Parameters
    ----------
    seeds : iterable of int
        Of the random sets.
    starts : sequence of tuple of float, or None
        What the true focal lengths are multiplied with, and what is added to the principal point.

    Returns
    -------
    ndarray of bool, shape (sets * starts, 1 + peers)
        The right one is the smallest of all that are found, also from the true camera.
    """
    ends = [_ends(seed, starts) for seed in seeds]
    return np.concatenate([rms <= min(truth, rms.min()) + APART for rms, truth in ends])


def _ends(seed: int, starts: Sequence[Start]) -> tuple[NDArray[np.float64], float]:
    """Return the RMS that ours and each peer come to, a row for each start, and from the truth."""
    K, k, seen = random_set(seed)
    pixels = [np.float32(view) for view in seen.pixels]
    rows = []
    for start in starts:
        camera = None if start is None else (_moved(K, *start), np.zeros(5))
        ours = calibrate(seen.points, pixels, SIZE, MODEL, camera).rms
        rows.append([ours, *(_theirs(seen.points, pixels, camera, c) for c in PEERS.values())])
    return np.array(rows), calibrate(seen.points, pixels, SIZE, MODEL, (K, k)).rms


def _moved(K: Any, factor: float, shift: float) -> Any:
    """Return intrinsics with other focal lengths and another principal point."""
    moved = K * [[factor, 1, 1], [1, factor, 1], [1, 1, 1]]
    moved[:2, 2] += shift
    return moved


def _theirs(points: Any, pixels: Any, camera: Any, criteria: tuple[int, int, float]) -> float:
    """Return OpenCV's RMS; infinity where it gives up."""
    import cv2

    flags = cv2.CALIB_FIX_K3 | (0 if camera is None else cv2.CALIB_USE_INTRINSIC_GUESS)
    K, k = (None, None) if camera is None else (part.copy() for part in camera)
    boards = [np.float32(points)] * len(pixels)
    try:
        return float(
            cv2.calibrateCamera(boards, pixels, SIZE, K, k, flags=flags, criteria=criteria)[0]
        )
    except cv2.error:
        return float("inf")
