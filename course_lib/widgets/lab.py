"""What chapter 12 is worked with: a box for photographs, and marks to point with."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.boards import Board
from course_lib.calibrating.looking import Photo, look_at_photos
from course_lib.drawing.explorers.frame import Readout
from course_lib.drawing.explorers.pointing import FINE, REACH, Pointed, marks, pointing_frame
from course_lib.drawing.lab.sheets import thumbnail
from course_lib.lab.photographs import Shot
from course_lib.measuring import Measured
from course_lib.widgets.controls import Slider
from course_lib.widgets.explorer import Explorer
from course_lib.widgets.upload import UploadBox, Verdict

#: A slider has about so many positions.
POSITIONS = 1000


class Pointer(Explorer):
    """Two marks in a photograph, which are dragged or moved by sliders."""

    @property
    def ends(self) -> NDArray[np.float64]:
        """Where the marks are, shape (2, 2), px of the photograph."""
        return marks(self.state)


def upload_box(folder: str | Path, target: Board) -> UploadBox:
    """Return a box on which photographs of a target are dropped.

    Parameters
    ----------
    folder : str or Path
        Where they are put.
    target : Checkerboard, DotGrid, Charuco or SquareGrid
        What is looked for in each, at once.

    Returns
    -------
    UploadBox
        To be shown as the last line of a cell.
    """
    return UploadBox("Your photographs", Path(folder), partial(_verdict, target))


def _verdict(target: Board, path: Path) -> Verdict:
    (photo,) = look_at_photos([path], target, lambda _: None)
    return Verdict(photo.name, photo.verdict, photo.used, marked(photo))


def marked(photo: Photo) -> NDArray[np.uint8] | None:
    """Return a photograph's thumbnail with the points that were found; None if it is none."""
    if photo.thumbnail is None or photo.header is None:
        return None
    found = photo.detection.points if photo.detection else np.empty((0, 2))
    return thumbnail(photo.thumbnail, found / (photo.header.size[0] / photo.thumbnail.shape[1]))


def pointer(
    shot: Shot,
    names: tuple[str, str] = ("end 1", "end 2"),
    start: ArrayLike | None = None,
    measure: Callable[[NDArray[np.float64]], Measured] | None = None,
    guides: Sequence[ArrayLike] = (),
) -> Pointer:
    """Return a photograph in which two places are pointed at.

    Parameters
    ----------
    shot : Shot
        The photograph.
    names : tuple of str
        What the two places are.
    start : array_like, shape (2, 2), optional
        Where the marks are at first in a supplied photograph, px. In a reader's own they begin at
        the first and the last corner of the target: a length that is known, until they are moved.
    measure : callable, optional
        From the pixels of both marks, shape (2, 2), to a length, which is shown.
    guides : sequence of array_like, shape (N, 2)
        Lines that are drawn, px: where a mark must be.

    Returns
    -------
    Pointer
        Its `ends` are the pixels of the marks.
    """
    height, width = shot.photograph.shape[:2]
    places = np.asarray(shot.corners[[0, -1]] if start is None or shot.own else start, float)
    value = None if measure is None else partial(_readouts, measure)
    pointed = Pointed(shot.photograph, names, value, tuple(guides))
    controls = [
        slider
        for i, (name, place) in enumerate(zip(names, places, strict=True), 1)
        for slider in _sliders(i, name, place, (width, height))
    ]
    frame = partial(pointing_frame, pointed, pointed.shown)
    return Pointer(f"Point at {names[0]} and {names[1]}", controls, frame)


def _sliders(
    number: int, name: str, place: NDArray[np.float64], size: tuple[int, int]
) -> list[Slider]:
    """Return the sliders of a mark: roughly over the picture, then finely around there."""
    said = name[0].upper() + name[1:]
    rough, fine = [], []
    for axis, length, at in zip("uv", size, place.tolist(), strict=True):
        step = max(1, round(length / POSITIONS))
        last = (length - 1) // step * step
        near = min(max(step * round(at / step), 0), last)
        label, finely = f"{said}, {axis}", f"{said}, {axis} finely"
        rough.append(Slider(f"{axis}{number}", label, "", "px", 0, last, near, step=step))
        rest = min(max(at - near, -REACH), REACH)
        fine.append(
            Slider(f"d{axis}{number}", finely, "", "px", -REACH, REACH, rest, step=FINE, digits=1)
        )
    return rough + fine


def _readouts(
    measure: Callable[[NDArray[np.float64]], Measured], places: NDArray[np.float64]
) -> tuple[Readout, ...]:
    """Return a length, or why there is none, as a number beside the photograph."""
    try:
        length = measure(places)
    except ValueError as error:
        return (Readout("No length", "", str(error).partition(":")[0]),)
    return (Readout("Length (95 %)", "", f"{length.value:.2f} ± {length.plus_minus:.2f}", "mm"),)
