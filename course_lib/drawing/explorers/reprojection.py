"""The reprojection inspector: every residual, the photograph that it comes from, and its corner."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib import data
from course_lib.calibration import calibrate
from course_lib.detection import detect_board
from course_lib.drawing.calibration.photographs import (
    BOARD,
    SIZE,
    computed_photographs,
    left_photographs,
    opencv_corners,
)
from course_lib.drawing.explorers.frame import Frame, Handle, Label, Line, Picture, Readout
from course_lib.drawing.explorers.marks import Marks
from course_lib.drawing.explorers.plot import Plot, crosses, disc

Floats = NDArray[np.float64]

#: How the corners were found, and how far the plot reaches, px.
WAYS = {"corners fitted": 0.5, "OpenCV, window of 11 px": 4.2}
CLOUD_SIZE, SHOWN_SIZE, NEAR_SIZE = (300, 310), (320, 240), (240, 240)
NEAR = 24  # px that are enlarged
TIMES = NEAR_SIZE[0] / NEAR


@dataclass(frozen=True, eq=False)
class Inspected:
    """Photographs with their corners and what a calibration leaves over.

    Attributes
    ----------
    real : bool
        Whether they are photographs; computed ones without a network.
    photographs : tuple of ndarray
        Grey values.
    pixels, residuals : ndarray, shape (V, 54, 2)
        Corners, and projected minus observed, px.
    """

    real: bool
    photographs: tuple[NDArray[np.uint8], ...]
    pixels: Floats
    residuals: Floats


@cache
def _photographs() -> tuple[bool, tuple[NDArray[np.uint8], ...]]:
    try:
        return True, tuple(left_photographs())
    except data.Unavailable:
        return False, tuple(computed_photographs())


@cache
def inspected(way: str) -> Inspected:
    """Return photographs, corners and residuals for one of the `WAYS`."""
    real, photographs = _photographs()
    if way == "corners fitted":
        pixels = [detect_board(photograph, BOARD).points for photograph in photographs]
    else:
        pixels = opencv_corners(photographs, 11)
    found = calibrate(BOARD.points(), pixels, SIZE)
    return Inspected(real, photographs, np.array(pixels), np.array(found.residuals))


def reprojection_frame(way: str, du: float, dv: float) -> Frame:
    """Return all residuals of a calibration, and where the chosen one comes from.

    Parameters
    ----------
    way : str
        A key of `WAYS`.
    du, dv : float
        Where to look among the residuals, px; the nearest one is chosen.

    Returns
    -------
    Frame
        The residuals, the photograph of the chosen one, and its corner enlarged.
    """
    seen, plot = inspected(way), _plot(way)
    view, corner = chosen(seen, du, dv)
    residual = seen.residuals[view, corner]
    rms = np.sqrt((seen.residuals**2).sum(axis=2).mean(axis=1))
    readouts = (
        Readout("View", "", f"{view}"),
        Readout("Corner", "", f"{corner}"),
        Readout("Length of the residual", "", f"{np.linalg.norm(residual):.2f}", "px"),
        Readout("RMS of this view", "", f"{rms[view]:.2f}", "px"),
        Readout("RMS of all", "", f"{np.sqrt((rms**2).mean()):.3f}", "px"),
    )
    cloud = _cloud(way, plot, seen, view, (du, dv), residual)
    pictures = (cloud, _photograph(way, seen, view, corner), _near(seen, view, corner))
    return Frame(pictures, readouts)


def chosen(seen: Inspected, du: float, dv: float) -> tuple[int, int]:
    """Return view and corner of the residual that is nearest to (du, dv), px."""
    apart = ((seen.residuals - (du, dv)) ** 2).sum(axis=2)
    view, corner = np.unravel_index(np.argmin(apart), apart.shape)
    return int(view), int(corner)


def _plot(way: str) -> Plot:
    reach = WAYS[way]
    return Plot((44, 290, 22, 268), (-reach, reach), (reach, -reach))  # dv grows downwards


@cache
def _crosses(way: str, view: int) -> tuple[Floats, Floats]:
    """Return all residuals as marks of the plot, and larger ones of one view."""
    seen, plot = inspected(way), _plot(way)
    every = plot.pixels(*seen.residuals.reshape(-1, 2).T)
    own = plot.pixels(*seen.residuals[view].T)
    return crosses(every, 1.6), crosses(own, 3.2)


def _cloud(
    way: str, plot: Plot, seen: Inspected, view: int, at: tuple[float, float], residual: Floats
) -> Picture:
    """Return the residuals around zero, those of the chosen view in colour."""
    reach = WAYS[way]
    every, own = _crosses(way, view)
    lines = (
        plot.frame(),
        Line(plot.pixels([-reach, reach], 0), "guide", 0.8),
        Line(plot.pixels(0, [-reach, reach]), "guide", 0.8),
        Line(every, "guide", 1.0),
        Line(own, "object", 1.6),
        Line(disc(plot.pixels(*residual)[0], 7), "camera", 2.5, closed=True),
    )
    tick = float(f"{0.95 * reach:.1g}")
    return Picture(
        f"All {seen.residuals.shape[0] * seen.residuals.shape[1]} residuals, view {view} in red",
        f"All residuals around zero, at most {np.abs(seen.residuals).max():.2f} px along u or v. "
        f"Those of view {view} are marked; the chosen one is ({residual[0]:.2f}, "
        f"{residual[1]:.2f}) px.",
        CLOUD_SIZE,
        lines=lines,
        labels=(*plot.ticks((-tick, 0, tick), (-tick, 0, tick)), *plot.names("du (px)", "dv (px)")),
        handles=(_pointer(plot, reach, at),),
        marks=_every_mark(way),
    )


NAMES = ("view", "corner", "du", "dv", "residual")
UNITS, DIGITS = ("", "", "px", "px", "px"), (0, 0, 2, 2, 2)


@cache
def _every_mark(way: str) -> Marks:
    """Return all residuals as points of the plot that say where they come from."""
    residuals = inspected(way).residuals
    places = _plot(way).pixels(*residuals.reshape(-1, 2).T)
    said = [_numbers(view, left) for view, left in enumerate(residuals)]
    return Marks(places, np.vstack(said), NAMES, UNITS, DIGITS)


def _numbers(view: int, residuals: Floats) -> Floats:
    """Return view, corner, du, dv and length of the residuals of a view, (N, 5)."""
    count = len(residuals)
    lengths = np.linalg.norm(residuals, axis=1)
    return np.column_stack([np.full(count, view), np.arange(count), residuals, lengths])


def _pointer(plot: Plot, reach: float, at: tuple[float, float]) -> Handle:
    """Return the spot that is dragged over the residuals."""
    du, dv = np.clip(at, -reach, reach).tolist()
    left, right, top, _ = plot.box
    slope = 2 * reach / (right - left)
    along = ("du", -reach - slope * left, slope, 0.0)
    across = ("dv", -reach - slope * top, 0.0, slope)
    return Handle(plot.at(du, dv), (along, across), "ray")


@cache
def _small(way: str, view: int) -> NDArray[np.uint8]:
    import cv2

    picture = inspected(way).photographs[view]
    small = cv2.resize(picture, SHOWN_SIZE, interpolation=cv2.INTER_AREA)
    return np.repeat(np.asarray(small, np.uint8)[..., None], 3, axis=2)


def _photograph(way: str, seen: Inspected, view: int, corner: int) -> Picture:
    """Return the photograph with all its residuals as lines, and a ring at the chosen corner."""
    times = 20 / WAYS[way]
    scale = SHOWN_SIZE[0] / SIZE[0]
    at = scale * (seen.pixels[view] + 0.5) - 0.5
    ends = at + times * seen.residuals[view]
    gap = np.full_like(at, np.nan)
    arrows = np.stack([at, ends, gap], axis=1).reshape(-1, 2)
    made = "photograph" if seen.real else "computed picture (no network)"
    return Picture(
        f"View {view}, residuals × {times / scale:.0f}",
        f"The {made} of view {view} with its residuals as lines, {times / scale:.0f} times too "
        f"long, and a ring around corner {corner}.",
        SHOWN_SIZE,
        _small(way, view),
        lines=(
            Line(arrows, "object", 1.5),
            Line(disc(at[corner], 9), "camera", 2.5, closed=True),
        ),
        marks=Marks(at, _numbers(view, seen.residuals[view]), NAMES, UNITS, DIGITS),
    )


def _near(seen: Inspected, view: int, corner: int) -> Picture:
    """Return the chosen corner enlarged, with where it was seen and where it is projected."""
    import cv2

    observed = seen.pixels[view, corner]
    projected = observed + seen.residuals[view, corner]
    middle = np.clip(np.rint(observed).astype(int), NEAR // 2, np.array(SIZE) - NEAR // 2)
    left, top = middle - NEAR // 2
    part = seen.photographs[view][top : top + NEAR, left : left + NEAR]
    shown = cv2.resize(part, NEAR_SIZE, interpolation=cv2.INTER_NEAREST)
    at, to = (TIMES * (place - (left, top) + 0.5) - 0.5 for place in (observed, projected))
    upright = crosses(np.asarray(at)[None], 9.0)
    return Picture(
        f"Corner {corner}",
        f"Corner {corner} enlarged: seen at the cross, projected to the ring.",
        NEAR_SIZE,
        np.repeat(np.asarray(shown, np.uint8)[..., None], 3, axis=2),
        lines=(
            Line(upright, "object", 2.5),
            Line(disc(np.asarray(to), 6), "camera", 2.5, closed=True),
        ),
        labels=(
            Label("cross: seen", (6, 12), "object"),
            Label("ring: projected", (6, 28), "camera"),
        ),
    )
