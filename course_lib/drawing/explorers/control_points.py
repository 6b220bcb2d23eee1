"""The control-point game: where to put a few control points, and how good the heights get."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.bundle.placement import (
    COLUMNS,
    ROWS,
    STEP,
    best_control,
    check_error,
    free_block,
    height_errors,
)
from course_lib.drawing.explorers.frame import Frame, Handle, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot, crosses, share
from course_lib.drawing.style import rgb

Floats = NDArray[np.float64]

#: East and north of the points of the game as they stand at first, m.
START = ((48.0, 48.0), (72.0, 48.0), (72.0, 72.0), (48.0, 72.0), (84.0, 60.0))
SIZE = (620, 430)  # px of the map with its scale
PLAN = Plot((50, 498, 36, 356), (0, (COLUMNS - 1) * STEP), (0, (ROWS - 1) * STEP))
SCALE = Plot((540, 560, 36, 356), (0, 1), (25, 400), log_y=True)
#: Colours of errors of 25 mm and less, 50, 100, 200, 400 mm and more: the lighter, the better.
COLOURS = ("#FFFFFF", "#F6D79A", "#E69F00", "#A45F00", "#4D2C00")


def control_frame(n: float, dome: bool, **at: float) -> Frame:
    """Return the map of height errors for a choice of control points.

    Parameters
    ----------
    n : float
        How many of the points are used, 3 to 5.
    dome : bool
        Whether the lens is off.
    **at : float
        ``x1``, ``y1`` … ``x5``, ``y5``: east and north of the points, m.

    Returns
    -------
    Frame
        The map, the error over all points, and the score against the best choice.
    """
    places = [(at[f"x{i}"], at[f"y{i}"]) for i in range(1, int(n) + 1)]
    control = tuple(numbered(*place) for place in places)
    errors = height_errors(control, dome)
    return Frame((_map(places, errors),), _numbers(control, errors, dome))


def _numbers(control: tuple[int, ...], errors: Floats | None, dome: bool) -> tuple[Readout, ...]:
    """Return what the choice is worth, in numbers."""
    if errors is None:
        words = "These points do not fix the block: they lie on one line, or on each other"
        return (Readout("No height", "", words),)
    mine, best = check_error(control, dome), check_error(best_control(len(control), dome), dome)
    return (
        Readout("Height error, RMS of all points", "", f"{1000 * mine:.0f}", "mm"),
        Readout("Worst point", "", f"{1000 * errors.max():.0f}", "mm"),
        Readout("Best choice found", "", f"{1000 * best:.0f}", "mm"),
        Readout("Score", "", f"{100 * min(best / mine, 1):.0f}", "%"),
    )


def numbered(x: float, y: float) -> int:
    """Return the number of the grid's point at a place, m."""
    return int(round(y / STEP) * COLUMNS + round(x / STEP))


def _map(places: list[tuple[float, float]], errors: Floats | None) -> Picture:
    """Return the plan: errors as colours, the cameras, and the control points as spots."""
    labels = []
    for i, place in enumerate(places, 1):
        u, v = PLAN.at(*place)
        below = v < PLAN.box[2] + 20  # where the axis has its name above the map
        labels.append(Label(f"{i}", (u + 9, v + (13 if below else -11))))
    cameras = crosses(PLAN.pixels(*free_block().block.centres[:, :2].T), 4)
    return Picture(
        "Drag the control points",
        _in_words(places, errors),
        SIZE,
        _picture(errors),
        lines=(PLAN.frame(), Line(cameras, "camera", 1.5)),
        labels=(*_words(), *labels),
        handles=tuple(_handle(i, place) for i, place in enumerate(places, 1)),
    )


def _in_words(places: list[tuple[float, float]], errors: Floats | None) -> str:
    """Return what the map shows."""
    where = "; ".join(f"({x:.0f}, {y:.0f})" for x, y in places)
    if errors is None:
        return f"Control points at {where} m do not fix the block."
    far = int(np.argmax(errors))
    row, column = divmod(far, COLUMNS)
    return (
        f"Map of height errors with control points at {where} m. The largest, "
        f"{1000 * errors[far]:.0f} mm, is at ({STEP * column:.0f}, {STEP * row:.0f}) m."
    )


def _handle(number: int, place: tuple[float, float]) -> Handle:
    """Return the spot of a control point; dragged, it moves its two sliders."""
    left, right, top, bottom = PLAN.box
    east, north = PLAN.x[1] / (right - left), PLAN.y[1] / (bottom - top)
    across = (f"x{number}", -left * east, east, 0.0)
    return Handle(PLAN.at(*place), (across, (f"y{number}", bottom * north, 0.0, -north)))


@cache
def _words() -> tuple[Label, ...]:
    """Return the labels that stay."""
    scale = [
        Label(f"{value:g}{'+' if value == 400 else ''}", SCALE.at(1, value, 6))
        for value in (25, 50, 100, 200, 400)
    ]
    return (
        *PLAN.ticks((0, 48, 96, 144), (0, 48, 96)),
        *PLAN.names("east (m)", "north (m)"),
        Label("mm", SCALE.at(0, 400, 0, -14)),
        Label("blue: cameras, 100 m above", (490, 392), "camera", "end"),
        *scale,
    )


def _picture(errors: Floats | None) -> NDArray[np.uint8]:
    """Return the colours of the errors over the plan, beside their scale, on white."""
    import cv2

    picture = np.array(_paper())
    if errors is None:
        return picture
    left, right, top, bottom = (int(end) for end in PLAN.box)
    shape = right - left, bottom - top
    # Columns and rows of the grid, in pixels; the ends of the axes are the outermost points.
    u = np.linspace(0, COLUMNS - 1, shape[0], dtype=np.float32)
    v = np.linspace(ROWS - 1, 0, shape[1], dtype=np.float32)
    grid = (1000 * errors.reshape(ROWS, COLUMNS)).astype(np.float32)
    fine = cv2.remap(grid, *np.meshgrid(u, v), cv2.INTER_LINEAR)
    picture[top:bottom, left:right] = _coloured(fine)
    return picture


@cache
def _paper() -> NDArray[np.uint8]:
    """Return white paper with the scale of colours on it."""
    paper = np.full((SIZE[1], SIZE[0], 3), 255, np.uint8)
    left, right, top, bottom = (int(end) for end in SCALE.box)
    levels = np.geomspace(*SCALE.y[::-1], bottom - top)[:, None]
    paper[top:bottom, left:right] = _coloured(np.repeat(levels, right - left, axis=1))
    paper[top:bottom, [left, right - 1]] = paper[[top, bottom - 1], left:right] = 118
    return paper


def _coloured(errors: NDArray[np.floating]) -> NDArray[np.uint8]:
    """Return the colours of errors, mm."""
    levels = np.clip(255 * share(errors, SCALE.y, True), 0, 255)
    return np.asarray(_table()[levels.astype(np.uint8)])


@cache
def _table() -> NDArray[np.uint8]:
    known, steps = np.array([rgb(colour) for colour in COLOURS]), np.linspace(0, 255, len(COLOURS))
    channels = [np.interp(np.arange(256), steps, channel) for channel in known.T]
    return np.asarray(np.rint(np.stack(channels, axis=1)), np.uint8)
