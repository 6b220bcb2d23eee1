"""The explorers of chapter 09."""

from __future__ import annotations

from course_lib.drawing.explorers.bench import bench_frame
from course_lib.drawing.explorers.disparity import FREE, PLACES, REACH, disparity_frame
from course_lib.drawing.triangulation.pair import SIZE
from course_lib.widgets.controls import Choice, Slider, Switch
from course_lib.widgets.explorer import Explorer


def bench_explorer() -> Explorer:
    """Return the triangulation bench: cameras, a point, noise, and the cloud of answers."""
    return Explorer(
        "Triangulation bench",
        [
            Slider("b", "Baseline", "b", "m", 0.2, 4, 1, step=0.1, digits=1),
            Slider("Z", "Distance of the point", "Z", "m", 1, 5, 4, step=0.1, digits=1),
            Slider("X", "Sideways", "X", "m", -2, 2, 0, step=0.1, digits=1),
            Slider("turn_deg", "Cameras turned inwards", "", "°", 0, 60, 0),
            Slider("sigma", "Error of a pixel", "σ", "px", 0.05, 1, 0.5, step=0.05, digits=2),
            Switch("third", "A third camera in the middle"),
        ],
        bench_frame,
    )


def disparity_explorer() -> Explorer:
    """Return the disparity explorer: a window, its partner in the other picture, the depth."""
    edge = REACH + 1
    return Explorer(
        "Disparity of a real pair",
        [
            Choice("place", "Go to", (*PLACES, FREE), FREE),
            Slider("u", "Column", "u", "px", edge, SIZE[0] - 1 - edge, 97),
            Slider("v", "Row", "v", "px", edge, SIZE[1] - 1 - edge, 208),
            Slider("reach", "Window, to each side", "", "px", 1, REACH, 4),
        ],
        disparity_frame,
    )
