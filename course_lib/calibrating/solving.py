"""From the boards that were found to a camera; dots lose the bias of perspective on the way."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from course_lib.boards import Board, DotGrid
from course_lib.calibrating.looking import Photo
from course_lib.calibrating.turned import Views, turned_views
from course_lib.calibration import (
    Calibration,
    CameraModel,
    RobustCalibration,
    calibrate_robustly,
    held_out_rms,
)
from course_lib.checks import Array, DegenerateConfigurationError
from course_lib.detection import Detection
from course_lib.detection.circles import distorted_circle_bias

#: Fewer views cannot do without one in five.
FEWEST_TO_HOLD_OUT = 6


@dataclass(frozen=True, eq=False)
class Solved:
    """A camera and the photographs it comes from.

    Attributes
    ----------
    photos : tuple of Photo
        All of them; those that the calibration rejected are no longer `used`.
    board : Checkerboard, DotGrid, Charuco or SquareGrid
        The board.
    calibration : Calibration
        The camera; its poses and residuals are those of `views`, in their order.
    views : tuple of Photo
        Those that took part.
    pixels : tuple of ndarray
        Their points, px; dots without the bias of perspective.
    kept : tuple of ndarray of bool
        Which of these points were not rejected.
    reasons : tuple of str
        Why others were.
    held_out : ndarray
        RMS of each view by a camera that was calibrated without it, px; empty if they are too few.
    """

    photos: tuple[Photo, ...]
    board: Board
    calibration: Calibration
    views: tuple[Photo, ...]
    pixels: tuple[Array, ...]
    kept: tuple[NDArray[np.bool_], ...]
    reasons: tuple[str, ...]
    held_out: Array


def solve(photos: Sequence[Photo], board: Board, model: CameraModel) -> Solved:
    """Return the camera that took the photographs.

    Parameters
    ----------
    photos : sequence of Photo
        As of `look_at_photos`; three or more of them are used.
    board : Checkerboard, DotGrid, Charuco or SquareGrid
        What is on them.
    model : CameraModel
        What is estimated.

    Returns
    -------
    Solved
        The camera, what was kept of each photograph, and why the rest was not.

    Raises
    ------
    DegenerateConfigurationError, ValueError
        As `course_lib.calibration.calibrate_robustly`.
    """
    photos = _without_turned(photos, board, model)
    used = _used(photos)
    found = [p.detection for p in used if p.detection is not None]
    objects, pixels, size = _views(used, board)
    robust = calibrate_robustly(objects, pixels, size, model)
    if isinstance(board, DotGrid):
        pixels = _without_bias(robust, board, found)
        robust = calibrate_robustly(objects, pixels, size, model)
    numbers = np.flatnonzero(robust.kept_views).tolist()
    told = {int(r.split()[1].strip(":")): _named(r, used) for r in robust.reasons}
    out = {used[i].path: told[i] for i in told if i not in numbers}
    kept = [robust.kept_points[i] for i in numbers]
    clean = [(objects[i][k], pixels[i][k]) for i, k in zip(numbers, kept, strict=True)]
    return Solved(
        tuple(_rejected(p, out[p.path]) if p.path in out else p for p in photos),
        board,
        robust.calibration,
        tuple(used[i] for i in numbers),
        tuple(pixels[i] for i in numbers),
        tuple(kept),
        tuple(told.values()),
        _held_out(clean, size, model),
    )


def _used(photos: Sequence[Photo]) -> list[Photo]:
    return [p for p in photos if p.used and p.detection is not None and p.header is not None]


def _views(used: Sequence[Photo], board: Board) -> Views:
    """Return the points of the boards in photographs that are used."""
    found = [p.detection for p in used if p.detection is not None]
    size = next(p.header.size for p in used if p.header is not None)
    points = board.points()
    return Views([points[f.ids] for f in found], [f.points for f in found], size)


def _without_turned(photos: Sequence[Photo], board: Board, model: CameraModel) -> list[Photo]:
    """Return the photographs; those that a program has turned are no longer used."""
    used = _used(photos)
    told = {used[i].path: said for i, said in turned_views(_views(used, board), model).items()}
    return [
        replace(p, used=False, problem="turned", verdict=told[p.path]) if p.path in told else p
        for p in photos
    ]


def _rejected(photo: Photo, reason: str) -> Photo:
    return replace(photo, used=False, problem="does not fit", verdict=reason)


def _named(reason: str, used: Sequence[Photo]) -> str:
    """Return a reason with the photograph's name instead of the view's number."""
    told = re.sub(r"^view (\d+)", lambda found: used[int(found[1])].name, reason)
    return told if told.endswith("?") else f"{told}."


def _without_bias(
    robust: RobustCalibration, board: DotGrid, found: Sequence[Detection]
) -> list[Array]:
    """Return the centroids where the pictures of the dots' centres are."""
    camera, pixels = robust.calibration, [f.points.copy() for f in found]
    kept, points = np.flatnonzero(robust.kept_views).tolist(), board.points()
    for i, (R, t) in zip(kept, camera.poses, strict=True):
        pixels[i] -= distorted_circle_bias(
            points[found[i].ids], board.diameter / 2, camera.K, R, t, camera.coefficients
        )
    return pixels


def _held_out(
    views: Sequence[tuple[Array, Array]], size: tuple[int, int], model: CameraModel
) -> Array:
    """Return the RMS of each view by a camera calibrated without it."""
    if len(views) < FEWEST_TO_HOLD_OUT:
        return np.empty(0)
    objects, pixels = zip(*views, strict=True)
    try:
        return held_out_rms(objects, pixels, size, model)
    except DegenerateConfigurationError:  # without some, the others do not determine the camera
        return np.empty(0)
