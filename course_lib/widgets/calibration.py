"""The explorers of chapter 07."""

from __future__ import annotations

from course_lib.drawing.explorers.detection import detection_frame
from course_lib.drawing.explorers.poses import VIEWS, poses_frame
from course_lib.drawing.explorers.reprojection import WAYS, reprojection_frame
from course_lib.widgets.controls import Choice, Slider, Switch
from course_lib.widgets.explorer import Explorer


def detection_explorer() -> Explorer:
    """Return the detection viewer: a corner, the window of a search, and what it finds."""
    return Explorer(
        "Finding a corner",
        [
            Slider("corner", "Corner", "", "", 0, 53, 33),
            Slider("reach", "Window, to each side", "", "px", 2, 14, 5),
            Slider("blur", "Blur", "σ", "px", 0, 3, 0.8, step=0.1, digits=1),
            Slider("noise", "Noise", "", "grey levels", 0, 20, 2),
        ],
        detection_frame,
    )


def pose_explorer() -> Explorer:
    """Return the pose explorer: which views determine which numbers of a camera."""
    controls: list[Slider | Switch] = [
        Slider("noise", "Error of a corner", "σ", "px", 0.02, 1, 0.1, step=0.02, digits=2)
    ]
    controls += [
        Switch(f"view{n}", f"{n}: {name}", n <= 2) for n, name in enumerate(VIEWS, start=1)
    ]
    return Explorer("Which views tell what", controls, poses_frame)


def reprojection_inspector() -> Explorer:
    """Return the reprojection inspector: a residual, its photograph and its corner."""
    *_, wide = WAYS
    return Explorer(
        "Inspect the residuals",
        [
            Slider("du", "Look at", "du", "px", -4.2, 4.2, 2.66, step=0.01, digits=2),
            Slider("dv", "Look at", "dv", "px", -4.2, 4.2, -4.0, step=0.01, digits=2),
            Choice("way", "Corners", tuple(WAYS), wide),
        ],
        reprojection_frame,
    )
