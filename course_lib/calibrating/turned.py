"""Photographs that a program has turned by half a turn or mirrored: their pixels fit turned back.

Half a turn and a mirror leave the size of a picture alone, but move the principal point to the
other side of the middle: such a photograph is one of another camera.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from course_lib.calibration import (
    Calibration,
    CameraModel,
    calibrate_robustly,
    view_residuals,
)
from course_lib.checks import Array

#: The error of a view must shrink by this when it is turned back, and be so large before, px.
BETTER, NOTICED = 1.3, 0.05
#: Where the principal point is tried first, from where all views together put it, by the width.
STARTS = ((0.0, 0.0), (0.03, 0.0), (0.0, 0.03))
ROUNDS = 6
#: A photograph is mirrored rather than turned if its error is smaller by this.
CLEARLY = 1.1
#: Nothing was changed if so many views fit clearly worse changed, and none better.
MOST = 0.6

Flags = NDArray[np.bool_]


class Change(NamedTuple):
    """What a program may have done to a picture."""

    across: bool
    down: bool
    said: str


CHANGES = (
    Change(True, True, "is upside down against the others"),
    Change(True, False, "is mirrored, left for right, against the others"),
    Change(False, True, "is mirrored, top for bottom, against the others"),
)
ADVICE = "a program has changed it. Take the original from the camera"


class Views(NamedTuple):
    """Points of boards and their pixels, and the picture's size."""

    objects: Sequence[Array]
    pixels: Sequence[Array]
    size: tuple[int, int]

    def changed(self, which: Flags, change: Change) -> Views:
        """Return the views, some of them with the change undone."""
        both = [
            _undone(points, pixels, self.size, change) if turned else (points, pixels)
            for points, pixels, turned in zip(self.objects, self.pixels, which, strict=True)
        ]
        return Views([points for points, _ in both], [pixels for _, pixels in both], self.size)

    def only(self, which: Flags) -> Views:
        """Return some of the views."""
        chosen = np.flatnonzero(which).tolist()
        return Views([self.objects[i] for i in chosen], [self.pixels[i] for i in chosen], self.size)


def turned_views(views: Views, model: CameraModel) -> dict[int, str]:
    """Return the numbers of views that were turned or mirrored against most others, and how.

    Parameters
    ----------
    views : Views
        Points in the board's frame, shape (N, 3), and their pixels, shape (N, 2), of each view.
    model : CameraModel
        What is estimated.

    Returns
    -------
    dict of int to str
        A sentence for each. Of lenses without distortion that look straight through the middle of
        the picture, it cannot be told, and does no harm.

    Raises
    ------
    DegenerateConfigurationError, ValueError
        As `course_lib.calibration.calibrate_robustly`.
    """
    for change in CHANGES:
        flags = _changed(views, change, model)
        if flags.any():
            others = calibrate_robustly(*views.only(~flags), model).calibration
            mine = views.only(flags)
            lengths = [float(_errors(others, mine, each)[1].mean()) for each in CHANGES]
            lengths[0] /= CLEARLY
            said = CHANGES[int(np.argmin(lengths))].said
            return {int(i): f"This photograph {said}: {ADVICE}." for i in np.flatnonzero(flags)}
    return {}


def _changed(views: Views, change: Change, model: CameraModel) -> Flags:
    """Return which views fit the camera of the others after the change is undone only."""
    best, least = np.zeros(len(views.pixels), dtype=np.bool_), np.inf
    for start in STARTS:
        flags, usual, clear = _sorted(views, change, model, start)
        if usual < least:
            best, least = flags, usual
        if clear:
            break
    flags, half = best, len(best) / 2
    if flags.sum() > half or (flags.sum() == half and flags[0]):
        flags = ~flags
    if not flags.any() or (~flags).sum() < 2:
        return np.zeros_like(flags)
    camera = calibrate_robustly(*views.only(~flags), model).calibration
    as_is, undone = _errors(camera, views, change)
    return np.asarray(flags & (as_is > NOTICED) & (as_is > BETTER * undone))


def _sorted(
    views: Views, change: Change, model: CameraModel, start: tuple[float, float]
) -> tuple[Flags, float, bool]:
    """Return which views fit better changed, the usual error of all then, and if it is clear."""
    flags = np.zeros(len(views.pixels), dtype=np.bool_)
    camera = calibrate_robustly(*views, model).calibration
    K = camera.K.copy()
    K[:2, 2] += np.array(start) * views.size[0]
    as_is, undone = _errors(replace(camera, K=K), views, change)
    for _ in range(ROUNDS):
        before, flags = flags, undone < as_is
        camera = calibrate_robustly(*views.changed(flags, change), model).calibration
        as_is, undone = _errors(camera, views, change)
        if (before == flags).all():
            break
    clear = np.mean(np.maximum(as_is, undone) > BETTER * np.minimum(as_is, undone)) > MOST
    return flags, float(np.median(np.minimum(as_is, undone))), bool(clear)


def _errors(camera: Calibration, views: Views, change: Change) -> tuple[Array, Array]:
    """Return the usual length of each view's residuals as it is, and with the change undone."""
    undone = views.changed(np.ones(len(views.pixels), dtype=np.bool_), change)
    return _lengths(camera, views), _lengths(camera, undone)


def _lengths(camera: Calibration, views: Views) -> Array:
    """Return the median length of each view's residuals, px; infinity if it is no such board."""
    try:
        left = view_residuals(camera, views.objects, views.pixels)
        return np.array([np.median(np.linalg.norm(r, axis=1)) for r in left])
    except ValueError:  # one of them is no such board, so one after the other
        pass
    lengths = np.full(len(views.pixels), np.inf)
    for i, (points, pixels) in enumerate(zip(views.objects, views.pixels, strict=True)):
        try:
            mine = view_residuals(camera, [points], [pixels])[0]
        except ValueError:  # points in disorder, or too few: said elsewhere
            continue
        lengths[i] = np.median(np.linalg.norm(mine, axis=1))
    return lengths


def _undone(
    points: Array, pixels: Array, size: tuple[int, int], change: Change
) -> tuple[Array, Array]:
    """Return a view with the change undone; a mirror also makes a mirrored board of the board."""
    far = np.array(size) - 1
    pixels = np.where([change.across, change.down], far - pixels, pixels)
    if change.across != change.down:
        points = points * (-1, 1, 1)
    return points, pixels
