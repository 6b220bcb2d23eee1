"""The explorers of chapter 02."""

from __future__ import annotations

from course_lib.drawing.explorers.join_meet import join_meet_frame
from course_lib.drawing.explorers.whole_camera import FIRST, whole_camera_frame
from course_lib.widgets.controls import Slider
from course_lib.widgets.explorer import Explorer


def join_meet_explorer() -> Explorer:
    """Return the explorer of two lines and the point in which they meet."""
    return Explorer(
        "Where two lines meet",
        [
            Slider("p", "Slope of line l", "p", "", -2, 2, 0.3, step=0.1, digits=1),
            Slider("q", "Height of line l", "q", "", -3, 3, 0.7, step=0.1, digits=1),
            Slider("r", "Slope of line m", "r", "", -2, 2, -0.4, step=0.1, digits=1),
            Slider("s", "Height of line m", "s", "", -3, 3, -0.7, step=0.1, digits=1),
        ],
        join_meet_frame,
    )


def whole_camera_explorer() -> Explorer:
    """Return the explorer of all eleven numbers of a pinhole camera."""
    return Explorer(
        "The whole camera",
        [
            Slider("f", "Focal length", "f", "px", 150, 1200, FIRST["f"], step=10),
            Slider("aspect", "Aspect", "fᵧ / fₓ", "", 0.6, 1.6, FIRST["aspect"], 0.02, digits=2),
            Slider("skew", "Skew", "s", "px", -200, 200, FIRST["skew"], step=10),
            Slider("cx", "Principal column", "cₓ", "px", -0.5, 479.5, FIRST["cx"], 10, 0, 1),
            Slider("cy", "Principal row", "cᵧ", "px", -0.5, 359.5, FIRST["cy"], 10, 0, 1),
            Slider("x", "East", "X", "m", -6, 6, FIRST["x"], step=0.1, digits=1),
            Slider("y", "North", "Y", "m", -7, 8, FIRST["y"], step=0.1, digits=1),
            Slider("z", "Up", "Z", "m", 0.3, 9, FIRST["z"], step=0.1, digits=1),
            Slider("pan", "Pan to the left", "θ", "°", -180, 180, FIRST["pan"], step=1),
            Slider("tilt", "Tilt upwards", "φ", "°", -90, 90, FIRST["tilt"], step=1),
            Slider("roll", "Roll clockwise", "ψ", "°", -180, 180, FIRST["roll"], step=1),
        ],
        whole_camera_frame,
    )
