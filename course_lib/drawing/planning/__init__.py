"""The still figures of chapter 11, one function each, and what they are drawn from."""

from __future__ import annotations

from course_lib.drawing.planning.choosing import (
    compared,
    limits,
    panel_task,
    room_for_aperture,
    verdicts,
)
from course_lib.drawing.planning.flying import flight_map, hidden, overlaps, smallest_object
from course_lib.drawing.planning.panel import BOX, TASK, pair, stand
from course_lib.drawing.planning.shaker import box_in_picture, chosen, failures, rig
from course_lib.drawing.planning.site import AREA, counts, drone, flight, ground, in_area

__all__ = [
    "AREA",
    "BOX",
    "TASK",
    "box_in_picture",
    "chosen",
    "compared",
    "counts",
    "drone",
    "failures",
    "flight",
    "flight_map",
    "ground",
    "hidden",
    "in_area",
    "limits",
    "overlaps",
    "pair",
    "panel_task",
    "rig",
    "room_for_aperture",
    "smallest_object",
    "stand",
    "verdicts",
]
