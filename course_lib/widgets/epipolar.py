"""The explorers of chapter 08."""

from __future__ import annotations

from course_lib.drawing.explorers.epipolar import SIZE, epipolar_frame
from course_lib.drawing.explorers.pairs import EYES, TOWARDS
from course_lib.drawing.explorers.ransac import MOST, ransac_frame
from course_lib.drawing.explorers.rectification import BOARD, STREET, rectification_frame
from course_lib.widgets.controls import Choice, Slider
from course_lib.widgets.explorer import Explorer


def epipolar_explorer() -> Explorer:
    """Return the epipolar explorer: a left point, its ray and its line on the right."""
    return Explorer(
        "The epipolar line of a point",
        [
            Slider("u", "Point on the left", "u", "px", 0, SIZE[0] - 1, 250),
            Slider("v", "Point on the left", "v", "px", 0, SIZE[1] - 1, 126),
            Slider("Z", "Depth of the candidate", "Z", "m", 4, 60, 20, steps=160, digits=3),
            Choice("arrangement", "Cameras", tuple(EYES), TOWARDS),
        ],
        epipolar_frame,
    )


def ransac_stepper() -> Explorer:
    """Return the RANSAC stepper: draw after draw, who agrees, and the best so far."""
    return Explorer(
        "RANSAC, draw by draw",
        [
            Slider("n", "Draw", "", "", 1, MOST, 1),
            Slider("wrong", "Wrong pairs", "", "%", 10, 60, 30, step=10),
            Slider("threshold", "Threshold", "", "px", 0.2, 10, 1, step=0.2, digits=1),
        ],
        ransac_frame,
    )


def rectification_explorer() -> Explorer:
    """Return the rectification slider: two pictures turn until their lines are rows."""
    return Explorer(
        "Rectification",
        [
            Slider("s", "As taken (0) to rectified (1)", "", "", 0, 1, 0, step=0.02, digits=2),
            Choice("pair", "Pictures", (STREET, BOARD), STREET),
        ],
        rectification_frame,
    )
