"""Photographs for readers without a camera: the desk, computed once for each run of Python."""

from __future__ import annotations

import atexit
import shutil
import tempfile
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from course_lib.boards import Checkerboard
from data_generators import desk
from data_generators.desk import Aim
from data_generators.phone import CUT_OFF, write_photograph

SIZE = (1200, 900)
#: The camera is calibrated with these.
TARGET_AIMS: tuple[Aim, ...] = (
    ((100, 62), 4, 20, 330, 0),
    ((100, 62), 30, 0, 340, 3),
    ((95, 62), 32, 90, 350, -4),
    ((100, 62), 34, 270, 440, 90),
    ((100, 62), 36, 180, 360, 180),
    ((236, 136), 20, 59, 330, -2),
    ((245, 71), 22, 125, 310, -5),
    ((12, 161), 36, 57, 420, -2),
    ((-31, 67), 26, 226, 300, 5),
    ((196, -13), 40, 12, 430, -5),
    ((258, -57), 26, 142, 340, -8),
    ((-46, -23), 36, 319, 430, 6),
)
#: In these, lengths are measured: one for the plane, two for space.
MEASURING_AIMS: tuple[Aim, ...] = (
    ((180, 50), 24, -8, 500, 0),
    ((190, 45), 42, -42, 520, -4),
    ((190, 45), 42, 40, 520, 6),
)
#: Two more cannot be used: one is blurred, in one the target is cut off.
SHARP, BLURRED = 0.8, 7.0  # px
NOISE, QUALITY = 5.0, 88


@dataclass(frozen=True)
class Supplied:
    """What is known of the supplied photographs.

    Attributes
    ----------
    target : Checkerboard
        What is on the desk, mm.
    measuring : tuple of str
        Photographs to measure in: for the plane, then two for space.
    card, box_height : float
        The truth: width of the card and height of the box, mm.
    """

    target: Checkerboard
    measuring: tuple[str, ...]
    card: float
    box_height: float


def _name(number: int) -> str:
    return f"desk_{number:02}.jpg"


SUPPLIED = Supplied(
    desk.TARGET,
    tuple(_name(len(TARGET_AIMS) + 3 + k) for k in range(3)),
    desk.CARD[0],
    desk.BOX[2],
)


@cache
def supplied_photographs() -> tuple[Path, ...]:
    """Return the photographs of the desk as files, which go when Python ends.

    Returns
    -------
    tuple of Path
        Twelve for the camera, two that cannot be used, three to measure in.
    """
    folder = Path(tempfile.mkdtemp(prefix="camera-course-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    aims = [*TARGET_AIMS, TARGET_AIMS[1], CUT_OFF, *MEASURING_AIMS]
    blurs = [BLURRED if k == len(TARGET_AIMS) else SHARP for k in range(len(aims))]
    return tuple(
        _written(folder, number, *what)
        for number, what in enumerate(zip(aims, blurs, strict=True), 1)
    )


def _written(folder: Path, number: int, aim: Aim, blur: float) -> Path:
    """Write one photograph as a JPEG; return its file."""
    path, rng = folder / _name(number), np.random.default_rng(number)
    write_photograph(path, aim, SIZE, rng, blur, NOISE, quality=QUALITY)
    return path
