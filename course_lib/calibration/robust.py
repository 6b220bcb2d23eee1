"""Calibration that wrong corners and bad pictures do not spoil, and that says which they were.

Use these functions through `course_lib.calibration`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.calibration.degeneracy import DISORDER, disorder
from course_lib.calibration.derivatives import residuals
from course_lib.calibration.model import CameraModel, State
from course_lib.calibration.refinement import Normals, minimised
from course_lib.calibration.result import Calibration, calibration_from_state
from course_lib.calibration.start import minimum, view_homographies
from course_lib.calibration.views import LEAST_POINTS, Views, each_view, gather_views
from course_lib.checks import Array, DegenerateConfigurationError, check_size

Kept = NDArray[np.bool_]
Counts = NDArray[np.intp]
#: So many standard deviations from where it should be a corner is wrong: chance alone does that
#: to one in 70 000.
POINT_LIMIT = 5.0
#: A view whose error is so many times the usual one is bad as a whole.
VIEW_LIMIT = 3.0
#: A view that loses more of its points is bad as a whole.
POINT_SHARE = 0.3
ROUNDS = 8
#: No corner is found better, px: what is off by a small part of a pixel is not wrong.
FINEST = 0.02
#: Half of all residuals are shorter than so many standard deviations of a coordinate: √(2 ln 2).
MEDIAN_LENGTH = 1.1774


@dataclass(frozen=True, eq=False)
class RobustCalibration:
    """A calibration from what fits together, and what was left out of it.

    Attributes
    ----------
    calibration : Calibration
        From the views that were kept; its poses and residuals are theirs, in their order. The
        residuals hold rejected points too, the RMS does not.
    kept_views : ndarray of bool, shape (V,)
        Which views were used.
    kept_points : tuple of ndarray of bool, shape (N,)
        For each of all views, which points were used.
    reasons : tuple of str
        A sentence for every view of which something was left out; it begins with "view" and the
        number.
    """

    calibration: Calibration
    kept_views: Kept
    kept_points: tuple[Kept, ...]
    reasons: tuple[str, ...]


def calibrate_robustly(
    object_points: ArrayLike | Sequence[ArrayLike],
    image_points: Sequence[ArrayLike],
    image_size: tuple[int, int],
    model: CameraModel | None = None,
) -> RobustCalibration:
    """Return a calibration without the points and views that do not fit the others.

    First points count the less, the farther off they are, so that wrong ones cannot pull the
    camera; then those that are far off the others' camera are left out, and it is computed again.

    Parameters
    ----------
    object_points, image_points, image_size, model
        As in `calibrate`.

    Returns
    -------
    RobustCalibration
        Camera, what was kept, and a reason for everything that was not.

    Raises
    ------
    TypeError, ValueError, DegenerateConfigurationError
        As `calibrate`, also if too few views remain.

    References
    ----------
    P. J. Huber, E. M. Ronchetti, Robust Statistics, 2nd ed., chapter 7; B. Triggs et al., "Bundle
    adjustment: a modern synthesis" (2000), section 3.2.
    """
    model = CameraModel() if model is None else model
    size, reasons = check_size(image_size, "image_size"), dict[int, str]()
    each = each_view(object_points, image_points)
    numbers = _usable(object_points, image_points, reasons)
    views = gather_views([each[i][0] for i in numbers], [each[i][1] for i in numbers])
    points = np.arange(views.pixels.shape[2]) < views.counts[:, None]
    kept = _in_order(views, numbers, reasons)
    state, _ = minimum(views.only(kept), size, model)
    state, used, normals = _agreed(
        _settled(state, views.only(kept)), views, points, kept, reasons, numbers
    )
    calibration = calibration_from_state(state, normals, used, size)
    _tell_points(calibration, points[kept], numbers[kept], reasons)
    kept_views = np.zeros(len(each), dtype=bool)
    kept_views[numbers[kept]] = True
    kept_points = [np.zeros(len(np.asarray(view)), dtype=np.bool_) for _, view in each]
    for i in np.flatnonzero(kept):
        kept_points[numbers[i]] = points[i, : views.counts[i]]
    told = tuple(reasons[view] for view in sorted(reasons))
    return RobustCalibration(calibration, kept_views, tuple(kept_points), told)


def _usable(object_points: object, image_points: object, reasons: dict[int, str]) -> Counts:
    """Return the numbers of the views that have a homography: not too few points, not on a line."""
    try:
        return np.arange(len(view_homographies(gather_views(object_points, image_points))))
    except DegenerateConfigurationError:
        each = each_view(object_points, image_points)
    for i, (board, pixels) in enumerate(each):
        try:
            view_homographies(gather_views([board], [pixels]))
        except DegenerateConfigurationError as error:
            reasons[i] = f"view {i} was left out: {str(error).replace('view 0', 'it')}"
    return np.array([i for i in range(len(each)) if i not in reasons], dtype=np.intp)


def _in_order(views: Views, numbers: Counts, reasons: dict[int, str]) -> Kept:
    """Return which views are pictures of the board at all."""
    apart = disorder(views, view_homographies(views))
    for view in numbers[apart > DISORDER]:
        reasons[int(view)] = (
            f"view {view} was left out: its pixels are no picture of this board; are columns and "
            "rows swapped, or the corners in another order?"
        )
    return np.asarray(apart <= DISORDER)


def _agreed(
    state: State, views: Views, points: Kept, kept: Kept, reasons: dict[int, str], numbers: Counts
) -> tuple[State, Views, Normals]:
    """Return the minimum of what fits together; strike the rest from `points` and `kept`."""
    for _ in range(ROUNDS):
        used, here = views.only(kept), np.flatnonzero(kept)
        good, scales = _good_points(state, used, points[kept])
        stay = _good_views(scales, good, used.counts, numbers[here], reasons)
        settled = stay.all() and (good == points[kept]).all()
        points[kept], kept[here] = good, stay
        used = views.only(kept).weighted(points[kept].astype(float))
        moved = State(state.model, state.camera, state.R[stay], state.t[stay])
        state, normals = minimised(moved, used)
        if settled:
            break
    return state, used, normals


def _settled(state: State, views: Views) -> State:
    """Return the state after points that are far off have lost their pull (Cauchy's weights)."""
    for _ in range(ROUNDS):
        lengths = np.linalg.norm(residuals(state, views), axis=1)
        scale = np.median(_scales(lengths, views.counts))
        weights = 1 / (1 + (lengths / (2.385 * scale)) ** 2)
        state, _ = minimised(state, views.weighted(weights), last_gain=1e-4)
    return state


def _good_points(state: State, views: Views, points: Kept) -> tuple[Kept, Array]:
    """Return which points are not far off by what is usual in their view, and what that is."""
    lengths = np.linalg.norm(residuals(state, views), axis=1)
    scales = _scales(lengths, views.counts)
    limits = POINT_LIMIT * np.maximum(scales, np.median(scales))
    return points & (lengths <= limits[:, None]), scales


def _scales(lengths: Array, counts: Counts) -> Array:
    """Return the standard deviation of each view's pixels, from the median of the lengths."""
    rows = zip(lengths, counts, strict=True)
    return np.maximum([np.median(row[:n]) / MEDIAN_LENGTH for row, n in rows], FINEST)


def _good_views(
    scales: Array, good: Kept, counts: Counts, numbers: Counts, reasons: dict[int, str]
) -> Kept:
    """Return which views are not bad as a whole; say why others are."""
    times = scales / np.median(scales)
    lost = counts - good.sum(axis=1)
    bad = (times > VIEW_LIMIT) | (lost > POINT_SHARE * counts) | (counts - lost < LEAST_POINTS)
    for i in np.flatnonzero(bad):
        told = [f"{lost[i]} of {counts[i]} points are far off"] if lost[i] else []
        if times[i] > VIEW_LIMIT:
            told.append(f"its typical error is {times[i]:.1f} times the usual one")
        why = " and ".join(told) or "it has too few points"
        reasons[int(numbers[i])] = (
            f"view {numbers[i]} was left out: {why}; was it blurred, or the board moved or cut off?"
        )
    return np.asarray(~bad)


def _tell_points(
    calibration: Calibration, points: Kept, numbers: Counts, reasons: dict[int, str]
) -> None:
    """Say how far off the points are that were left out of views that were kept."""
    for view, good, left in zip(numbers, points, calibration.residuals, strict=True):
        lengths = np.linalg.norm(left[~good[: len(left)]], axis=1)
        if len(lengths):
            reasons[int(view)] = (
                f"view {view}: {len(lengths)} of {len(left)} points left out, up to "
                f"{lengths.max():.1f} px off"
            )
