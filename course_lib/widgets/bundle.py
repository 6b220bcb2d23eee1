"""The explorers of chapter 10."""

from __future__ import annotations

from course_lib.drawing.bundle.growing import PICTURES, WAYS
from course_lib.drawing.bundle.placement import COLUMNS, ROWS, STEP
from course_lib.drawing.explorers.control_points import START, control_frame
from course_lib.drawing.explorers.growing import growing_frame
from course_lib.widgets.controls import Choice, Slider, Switch
from course_lib.widgets.explorer import Explorer

#: Control points that fix a block.
LEAST = 3


def growing_explorer() -> Explorer:
    """Return the reconstruction stepper: a block that grows camera by camera."""
    first, *_ = WAYS
    return Explorer(
        "A block grows",
        [
            Slider("picture", "Newest picture", "", "", 1, PICTURES, 1),
            Choice("way", "Cameras are", tuple(WAYS), first),
            Slider("turn", "Look from", "", "°", -180, 180, 20, step=5),
        ],
        growing_frame,
    )


def control_point_game() -> Explorer:
    """Return the control-point game: place a few control points, and see the height errors."""
    controls: list[Slider | Switch] = [
        Slider("n", "Control points", "", "", LEAST, len(START), LEAST + 1),
        Switch("dome", "The lens is 2.4 px off in the corners"),
    ]
    for i, place in enumerate(START, 1):
        for name, label, cells, value in (
            ("x", "east", COLUMNS, place[0]),
            ("y", "north", ROWS, place[1]),
        ):
            last = (cells - 1) * STEP
            controls.append(
                Slider(
                    f"{name}{i}",
                    f"Point {i} {label}" + (", if used" if i > LEAST else ""),
                    "",
                    "m",
                    0,
                    last,
                    value,
                    step=STEP,
                )
            )
    return Explorer("Place the control points", controls, control_frame)
