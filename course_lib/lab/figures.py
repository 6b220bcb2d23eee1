"""The figures of the lab, for photographs that were looked at."""

from __future__ import annotations

from collections.abc import Sequence
from operator import itemgetter
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.distortion import straightness, undistort_pixels
from course_lib.drawing import lab as draw
from course_lib.lab.photographs import Work, marked
from course_lib.lab.results import Result, rays_angle_deg
from course_lib.lab.shots import Shot
from course_lib.lab.words import say
from course_lib.measuring import point_in_space, point_on_plane
from course_lib.remapping import undistort_picture

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MARGIN = 60.0  # mm around the target in the view from above


def contact_sheet(work: Work) -> Figure:
    """Show all photographs, and which of them can be used."""
    names, used = [p.name for p in work.photos], [p.used for p in work.photos]
    return draw.contact_sheet([marked(photo) for photo in work.photos], names, used)


def coverage(work: Work) -> Figure:
    """Show where in the picture the target was."""
    camera = work.camera
    assert work.solved is not None
    columns, rows = work.target.columns, work.target.rows
    corners = (0, columns - 1, columns * rows - 1, columns * (rows - 1))
    return draw.covered(work.solved.pixels, camera.image_size, corners)


def lens_bend(work: Work) -> Figure:
    """Show by how much the lens moves what a pinhole would show."""
    camera = work.camera
    return draw.lens_bend(camera.K, camera.coefficients, camera.image_size)


def straightened(work: Work) -> Figure | None:
    """Show a photograph before and after undistorting: that with the most bent row of corners."""
    camera, columns, count = work.camera, work.target.columns, len(work.target.points())
    whole = [
        (photo, photo.detection.points.reshape(-1, columns, 2))
        for photo in work.photos
        if photo.used and photo.detection is not None and len(photo.detection.points) == count
    ]
    if not whole:
        say("In no photograph all corners of the target were found, so there is no figure here.")
        return None
    every = [(straightness(row), photo, row) for photo, rows in whole for row in rows]
    _, photo, row = max(every, key=itemgetter(0))
    assert photo.thumbnail is not None
    scale = photo.thumbnail.shape[1] / camera.image_size[0]
    K = camera.K * [[scale], [scale], [1]]
    K[:2, 2] += (scale - 1) / 2  # corners of pixels stay corners: they are at -0.5
    straight = undistort_picture(photo.thumbnail, K, camera.coefficients)
    after = undistort_pixels(row, camera.K, camera.coefficients)
    return draw.straightened((photo.thumbnail, straight), (row, after), camera.image_size)


def from_above(work: Work, shot: Shot, ends: ArrayLike | None = None, text: str = "") -> Figure:
    """Show the plane of the target as seen from straight above, and a length on it.

    Parameters
    ----------
    work : Work
        With its camera.
    shot : Shot
        The photograph.
    ends : array_like, shape (2, 2), optional
        Pixels of both ends.
    text : str
        Written at the length.
    """
    view, points = shot.view, work.target.points()[:, :2]
    if ends is not None:
        ends = point_on_plane(ends, view)[:, :2]
        points = np.vstack([points, ends[np.isfinite(ends).all(axis=1)]])
    low, high = points.min(axis=0) - MARGIN, points.max(axis=0) + MARGIN
    size = np.ptp(work.target.points()[:, :2], axis=0).max()
    low, high = np.maximum(low, -2 * size), np.minimum(high, 3 * size)
    camera = (view.K, view.coefficients, view.R, view.t)
    extent = (float(low[0]), float(high[0]), float(low[1]), float(high[1]))
    return draw.from_above(shot.photograph, camera, extent, ends, text)


def rays(work: Work, shots: Sequence[Shot], pointed: Sequence[ArrayLike]) -> Figure:
    """Show from where both ends of a length in space were seen.

    Parameters
    ----------
    work : Work
        With its camera.
    shots : sequence of Shot
        Two photographs.
    pointed : sequence of array_like, shape (2, 2)
        Pixels of both ends in each.
    """
    views = [shot.view for shot in shots]
    pixels = np.stack([np.asarray(p, float) for p in pointed])
    ends = point_in_space(pixels, views)
    angle = rays_angle_deg(shots, pixels)
    return draw.rays_from_above(work.target.points(), [v.centre for v in views], ends, angle)


def contributions(results: Sequence[Result]) -> Figure:
    """Show what each length is uncertain by."""
    return draw.contributions({r.name: r.length.parts for r in results})


def comparison(results: Sequence[Result]) -> Figure | None:
    """Show how camera and ruler agree, where there is a ruler's value."""
    compared = [r for r in results if r.ruler is not None]
    if not compared:
        say("There is no ruler's value to compare with.")
        return None
    return draw.ruler_and_camera(
        [r.name for r in compared],
        [r.difference for r in compared],
        [r.length.plus_minus for r in compared],
        [r.ruler[1] for r in compared if r.ruler is not None],
    )
