"""The undistort explorer: a real photograph, and two coefficients that straighten its lines."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib.distortion import straightness, undistort_pixels
from course_lib.drawing.distortion.boards import (
    PHOTOGRAPHS,
    board_lines,
    board_photograph,
    most_bent,
)
from course_lib.drawing.distortion.pictures import looked_up, straight_map
from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot
from data_generators.rails import SIZE, K

Floats = NDArray[np.float64]

#: By their names in the explorer: a board near the right edge, and a large one that is tilted.
BOARDS = {"board on the right": PHOTOGRAPHS[5], "large board": PHOTOGRAPHS[2]}
PLOT_SIZE = (250, 480)
#: Across: deviation magnified, px; down: along the line from its first corner to its last.
AWAY = Plot((34, 236, 40, 420), (-6.0, 6.0), (0.0, 1.0))
#: The same for lines that lie farther away, and the numbers at both.
FAR_AWAY = Plot(AWAY.box, (-25.0, 25.0), AWAY.y)
TICKS = {AWAY: (-5, 0, 5), FAR_AWAY: (-20, 0, 20)}


def undistort_frame(photograph: str, k1: float, k2: float) -> Frame:
    """Return a photograph of a board, straightened by two coefficients, and how straight it got.

    Parameters
    ----------
    photograph : str
        A key of `BOARDS`.
    k1, k2 : float
        Radial coefficients, no unit.

    Returns
    -------
    Frame
        The straightened photograph with its most bent line, how far that line is from straight,
        and the straightness of all.
    """
    picture, lines, worst, real = _board(photograph)
    lens = [k1, k2]
    straight = _undone(lines, lens)
    each = [straightness(line) for line in straight if np.isfinite(line).all()]
    lost = len(each) < len(lines)
    rms = float(np.sqrt(np.mean(np.square(each)))) if not lost else np.nan
    before = float(np.sqrt(np.mean([straightness(line) ** 2 for line in lines])))
    readouts = (
        Readout("From straight, all lines, RMS", "", "–" if lost else f"{rms:.3f}", _px(lost)),
        Readout("in the photograph", "", f"{before:.3f}", "px"),
        Readout("The line in the plot", "", _straightness(straight[worst]), _px(lost)),
    )
    shown = _photograph(picture, straight[worst], lens, real)
    return Frame((shown, _deviation(lines[worst], straight[worst])), readouts)


def _px(lost: bool) -> str:
    return "" if lost else "px"


def _straightness(line: Floats) -> str:
    return f"{straightness(line):.2f}" if np.isfinite(line).all() else "–"


@cache
def _board(name: str) -> tuple[NDArray[np.uint8], list[Floats], int, bool]:
    """Return a photograph in RGB, the lines on its board, the most bent one, and if it is real."""
    grey, real = board_photograph(BOARDS[name])
    lines = board_lines(grey)
    return np.repeat(grey[..., None], 3, axis=2), lines, most_bent(lines), real


def _undone(lines: list[Floats], lens: list[float]) -> list[Floats]:
    """Return the lines without the distortion of a lens, in one go; NaN beyond its reach."""
    ends = np.cumsum([len(line) for line in lines])[:-1]
    return np.split(undistort_pixels(np.concatenate(lines), K, lens), ends)


def _photograph(picture: NDArray[np.uint8], line: Floats, lens: list[float], real: bool) -> Picture:
    """Return the straightened photograph, the corners of one line, and a straight edge."""
    made = "A photograph" if real else "A computed photograph (the real one is not here)"
    bend = f"{np.abs(_away(line)[1]).max():.1f} px" if np.isfinite(line).all() else "out of reach"
    return Picture(
        "Straightened" if real else "Straightened (computed: no network)",
        f"{made} of a checkerboard, straightened with k1 = {lens[0]:.2f}, k2 = {lens[1]:.2f}. "
        f"Largest distance of the marked line from a straight edge: {bend}.",
        SIZE,
        looked_up(picture, straight_map(K, lens, SIZE)),
        lines=(
            Line(line[[0, -1]], "ray", 2.0),
            Line(line, "object", 2.0, dashed=True),
        ),
        pixels=True,
    )


def _away(line: Floats) -> tuple[Floats, Floats]:
    """Return where points are along the chord of a line, 0 to 1, and how far from it, px."""
    along = line[-1] - line[0]
    length = np.hypot(*along)
    x, y = (line - line[0]).T
    share = (x * along[0] + y * along[1]) / length**2
    return share, (along[0] * y - along[1] * x) / length


def _deviation(before: Floats, after: Floats) -> Picture:
    """Return the distances of one line from a straight edge, before and after."""
    largest = _away(after)[1]
    plot = FAR_AWAY if np.abs(largest).max(initial=0, where=np.isfinite(largest)) > 6 else AWAY
    lines = [plot.frame(), Line(plot.pixels(0, plot.y), "guide", 1.2)]
    labels = [*plot.ticks(TICKS[plot], ()), *plot.names("px", "distance from the straight edge")]
    for points, role, dashed in ((before, "guide", True), (after, "object", False)):
        if np.isfinite(points).all():
            share, away = _away(points)
            drawn = plot.pixels(np.clip(away, *plot.x), 1 - np.clip(share, 0, 1))
            lines.append(Line(drawn, role, 2.5, dashed=dashed))
    labels.append(Label("dashed: as photographed", (36, 466), "guide"))
    said = f"{np.abs(largest).max():.1f} px" if np.isfinite(largest).all() else "out of reach"
    return Picture(
        "The marked line",
        f"Distance of the marked line from a straight edge, largest {said}.",
        PLOT_SIZE,
        lines=tuple(lines),
        labels=tuple(labels),
    )
