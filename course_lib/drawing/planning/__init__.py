"""The still figures of chapter 11, one function each, and what they are drawn from."""

from __future__ import annotations

from course_lib.drawing.planning.choosing import compared, limits, room_for_aperture, verdicts
from course_lib.drawing.planning.panel import BOX, TASK, pair, stand
from course_lib.drawing.planning.rig import box_in_picture, chosen, failures, rig

__all__ = [
    "BOX",
    "TASK",
    "box_in_picture",
    "chosen",
    "compared",
    "failures",
    "limits",
    "pair",
    "rig",
    "room_for_aperture",
    "stand",
    "verdicts",
]
