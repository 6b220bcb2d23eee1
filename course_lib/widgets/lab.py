"""What chapter 12 is worked with: a box for photographs, and marks to point with."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.boards import Board
from course_lib.calibrating.looking import Photo, look_at_photo
from course_lib.drawing.explorers.frame import Frame, Readout
from course_lib.drawing.explorers.pointing import FINE, REACH, Pointed, marks, pointing_frame
from course_lib.lab.marks import FILE, keep_marks, kept_marks
from course_lib.lab.photographs import marked
from course_lib.lab.shots import Shot
from course_lib.lab.words import say
from course_lib.measuring import Measured
from course_lib.widgets.controls import Control, Slider
from course_lib.widgets.explorer import Explorer
from course_lib.widgets.upload import UploadBox, Verdict

#: A slider has about so many positions.
POSITIONS = 1000


class Pointer(Explorer):
    """Two marks in a photograph, which are dragged or moved by sliders.

    Parameters
    ----------
    title, controls, frame
        As of `Explorer`.
    keep : callable
        Is told where both marks are, shape (2, 2), px, whenever they are moved.
    """

    def __init__(
        self,
        title: str,
        controls: Sequence[Control],
        frame: Callable[..., Frame],
        keep: Callable[[NDArray[np.float64]], None],
    ) -> None:
        self._keep = keep
        super().__init__(title, controls, frame)

    @property
    def ends(self) -> NDArray[np.float64]:
        """Where the marks are, shape (2, 2), px of the photograph."""
        return marks(self.state)

    @property
    def start(self) -> NDArray[np.float64]:
        """Where the marks were at first, shape (2, 2), px of the photograph."""
        return marks({name: control.default for name, control in self._controls.items()})

    def _move(self, changes: Mapping[str, Any]) -> None:
        before = self.state
        super()._move(changes)
        if self.state != before:
            self._keep(self.ends)


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
    return UploadBox("Your photographs", Path(folder), partial(_verdict, target, {}))


def _verdict(target: Board, before: dict[Path, Photo], path: Path) -> Verdict:
    """Return the verdict on a photograph among those that came before, and add it to them."""
    before.pop(path, None)
    photo = look_at_photo(path, target, list(before.values()))
    if photo.thumbnail is not None:
        before[path] = photo
    return Verdict(photo.name, photo.verdict, photo.used, marked(photo))


def pointer(
    shot: Shot,
    names: tuple[str, str] = ("end 1", "end 2"),
    start: ArrayLike | None = None,
    measure: Callable[[NDArray[np.float64]], Measured] | None = None,
    folder: str | Path = ".",
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
    folder : str or Path
        Where a small file keeps the marks: next time they are where they were left.

    Returns
    -------
    Pointer
        Its `ends` are the pixels of the marks.
    """
    height, width = shot.photograph.shape[:2]
    places = np.asarray(shot.corners[[0, -1]] if start is None or shot.own else start, float)
    value = None if measure is None else partial(_readouts, measure)
    pointed = Pointed(shot.photograph, names, value)
    frame = partial(pointing_frame, pointed, pointed.shown)
    keep = partial(keep_marks, shot, names, folder=Path(folder).resolve())
    controls = _controls(names, places, (width, height))
    pointer = Pointer(f"Point at {names[0]} and {names[1]}", controls, frame, keep)
    left = kept_marks(shot, names, folder)
    if left is not None:
        pointer.set(**{c.name: c.default for c in _controls(names, left, (width, height))})
        say(f"The marks are where you left them (kept in {FILE}).")
    elif shot.own:
        say(f"In {shot.name}, nobody has moved the marks yet: drag them to {' and '.join(names)}.")
    return pointer


def measured(
    measure: Callable[..., Measured], *pointers: Pointer
) -> tuple[Measured, *tuple[NDArray[np.float64], ...]]:
    """Return a length between marks, and the marks; if they show none, between those at first.

    Parameters
    ----------
    measure : callable
        From the pixels of both marks in each photograph, shape (2, 2), to a length.
    *pointers : Pointer
        The marks in each photograph.

    Returns
    -------
    tuple of Measured and ndarray
        The length, and for each photograph the pixels that it comes from, shape (2, 2). If those
        are not the reader's, a sentence says so.
    """
    ends = [pointer.ends for pointer in pointers]
    try:
        return measure(*ends), *ends
    except ValueError as error:
        say(
            f"There is no length between these marks ({error}). Are they at two different places, "
            "and at the same two in each picture? The places at which they began are taken "
            "instead: do not use what is measured there."
        )
    ends = [pointer.start for pointer in pointers]
    return measure(*ends), *ends


def _controls(
    names: tuple[str, str], places: NDArray[np.float64], size: tuple[int, int]
) -> list[Slider]:
    """Return the sliders of both marks, which stand at their places."""
    return [
        slider
        for i, (name, place) in enumerate(zip(names, places, strict=True), 1)
        for slider in _sliders(i, name, place, size)
    ]


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
