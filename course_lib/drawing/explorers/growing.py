"""The reconstruction stepper: a block of pictures that grows camera by camera."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib.bundle import Block
from course_lib.camera import Camera
from course_lib.drawing.bundle.growing import (
    PICTURES,
    Stage,
    chain,
    drift,
    grown,
    observed,
    true_centres,
    vase,
)
from course_lib.drawing.bundle.space import pyramid
from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot, crosses
from course_lib.drawing.space import onlooker

Floats = NDArray[np.float64]

SPACE_SIZE, ABOVE_SIZE, CURVE_SIZE = (400, 300), (290, 300), (290, 300)
#: How much longer than true deviations are drawn from above.
TIMES = 5
ABOVE = Plot((20, 270, 16, 266), (-1.2, 1.2), (-1.2, 1.2))
CURVE = Plot((40, 280, 40, 262), (1, PICTURES), (0, 4))


def growing_frame(picture: float, way: str, turn: float) -> Frame:
    """Return the block of the vase when a picture has come to those before it.

    Parameters
    ----------
    picture : float
        Number of the newest picture, 1 to 24, where 24 is number 0 once more.
    way : str
        A key of `course_lib.drawing.bundle.growing.WAYS`.
    turn : float
        Direction from which the block is seen, degrees.

    Returns
    -------
    Frame
        The block in space and from above, the RMS so far, and what the newest camera brought.
    """
    stages = grown(way)[: int(picture)]
    stage, off = stages[-1], 1000 * drift(stages[-1])
    readouts = [
        Readout("Newest picture", "", _name(len(stage.block.R) - 1)),
        Readout("Known points it sees", "", f"{stage.seen}" if len(stages) > 1 else "none"),
        Readout("Points it adds", "", f"{stage.added}"),
        Readout("RMS before the adjustment", "", f"{stage.before:.2f}", "px"),
        Readout(
            "RMS after it",
            "",
            f"{stage.after:.2f}" if stage.adjusted else "none made",
            "px" if stage.adjusted else "",
        ),
        Readout("Newest camera is off by", "", f"{off[-1]:.1f}", "mm"),
    ]
    pictures = (_space(stages, float(turn)), _above(stage, off), _curve(stages))
    return Frame(pictures, tuple(readouts))


def _name(camera: int) -> str:
    return str(camera) if camera < PICTURES else f"{camera} (number 0 once more)"


def _onlooker(turn: float) -> Camera:
    a = np.deg2rad(turn)
    eye = (2.9 * np.sin(a), -2.9 * np.cos(a), 1.9)
    return onlooker(eye, (0, 0, 0.16), 580, SPACE_SIZE)


def _space(stages: tuple[Stage, ...], turn: float) -> Picture:
    """Return the block as an onlooker sees it: cameras, points, and what the newest one saw."""
    stage, view = stages[-1], _onlooker(turn)
    last = len(stage.block.R) - 1
    before = stages[-2].points if last > 1 else np.full_like(stage.points, np.nan)
    new = np.isnan(before[:, 0]) & np.isfinite(stage.points[:, 0])
    old = np.isfinite(before[:, 0])
    numbers, _ = observed(chain(), last)
    used = numbers[np.isfinite(stage.points[numbers, 0])]
    rays = np.full((3 * len(used), 3), np.nan)
    rays[::3], rays[1::3] = stage.block.centres[last], stage.points[used]
    lines = [
        Line(_seen(view, rays), "ray", 0.5),
        Line(_seen(view, _pyramids(stage.block, range(last))), "camera", 1.2),
        Line(_seen(view, _pyramids(stage.block, [last])), "object", 2.0),
        Line(crosses(view.project(stage.points[old]), 1.3), "ink", 1.2),
        Line(crosses(view.project(stage.points[new]), 2.2), "object", 1.5),
    ]
    labels = (
        Label("newest camera, its new points", (6, 12), "object"),
        Label("cameras before it", (6, 28), "camera"),
    )
    words = (
        f"A vase of {int(np.isfinite(stage.points[:, 0]).sum())} points and {last + 1} cameras "
        f"around it, seen from {turn:.0f}°. The newest one added {stage.added} points."
    )
    return Picture("The block", words, SPACE_SIZE, lines=tuple(lines), labels=labels)


def _pyramids(block: Block, cameras: range | list[int]) -> Floats:
    """Return cameras as one line in space; a NaN row lifts the pen."""
    size, pen = vase().image_size, np.full((1, 3), np.nan)
    return np.vstack([np.vstack([pyramid(block, i, 0.28, size), pen]) for i in cameras])


def _seen(view: Camera, points: Floats) -> Floats:
    """Return the pixels of a line in space, NaN rows left as they are."""
    pixels, drawn = np.full((len(points), 2), np.nan), np.isfinite(points[:, 0])
    pixels[drawn] = view.project(points[drawn])
    return pixels


def _above(stage: Stage, off: Floats) -> Picture:
    """Return the cameras from above, their deviations enlarged."""
    true = true_centres(PICTURES + 1)
    count = len(stage.block.R)
    shown = true[:count] + TIMES * (stage.block.centres - true[:count])
    lines = (
        Line(ABOVE.pixels(*true[:, :2].T), "guide", 1.0, dashed=True),
        Line(ABOVE.pixels(*shown[:, :2].T), "camera", 1.2),
        Line(crosses(ABOVE.pixels(*shown[:, :2].T), 3), "camera", 2.0),
        Line(crosses(ABOVE.pixels(*shown[-1:, :2].T), 5), "object", 3.0),
    )
    labels = [Label("dashed: truth", (6, 284), "guide")]
    if count > PICTURES:
        first, last = stage.block.centres[[0, -1]]
        gap = 1000 * float(np.linalg.norm(last - first))
        labels.append(Label(f"gap {gap:.1f} mm", (145, 141), "object", "middle"))
    words = (
        f"{count} cameras from above, their deviations {TIMES} times too long. The newest one is "
        f"{off[-1]:.1f} mm off, the worst one {off.max():.1f} mm."
    )
    return Picture(
        f"From above (deviations × {TIMES})", words, ABOVE_SIZE, lines=lines, labels=tuple(labels)
    )


@cache
def _curve_frame() -> tuple[tuple[Line, ...], tuple[Label, ...]]:
    labels = (*CURVE.ticks((1, 12, 24), (0, 1, 2, 3)), *CURVE.names("picture", "RMS (px)"))
    return (CURVE.frame(),), labels


def _curve(stages: tuple[Stage, ...]) -> Picture:
    """Return the RMS before and after each adjustment, camera by camera."""
    numbers = np.arange(1, len(stages) + 1)
    before = CURVE.pixels(numbers, [s.before for s in stages])
    after = CURVE.pixels(numbers, [s.after for s in stages])
    lines, labels = _curve_frame()
    lines += (
        Line(crosses(before, 3), "object", 1.8),
        Line(after, "camera", 1.6),
    )
    labels += (
        Label("before", (276, 30), "object", "end"),
        Label("after", (276, 46), "camera", "end"),
    )
    last = stages[-1]
    words = (
        f"RMS of the reprojection error with picture {len(stages)}: {last.before:.2f} px "
        f"before, {last.after:.2f} px after."
    )
    return Picture("Reprojection error", words, CURVE_SIZE, lines=lines, labels=labels)
