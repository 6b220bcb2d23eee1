"""The photographs of the lab: a reader's own, or supplied ones; and the camera that took them.

Nothing here raises for what a reader brings: it is said in a sentence, and the supplied
photographs take the place of those that are missing.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from course_lib.boards import Board
from course_lib.calibrating.finding import find_photos, left_out
from course_lib.calibrating.judgement import Judgement, judge
from course_lib.calibrating.looking import Photo, check_board, look_at_photos
from course_lib.calibrating.solving import Solved, solve
from course_lib.calibration import Calibration, CameraModel
from course_lib.checks import DegenerateConfigurationError
from course_lib.drawing.lab.sheets import SMALL, thumbnail
from course_lib.lab.supplied import SUPPLIED, supplied_photographs
from course_lib.lab.words import in_notebook, say, sentence

#: What a reader can choose.
CHOICES = ("supplied", "mine")
#: Fewer views make no camera.
FEWEST = 3
#: What was seen last: it takes a second or two for each photograph.
LAST: dict[str, Any] = {}


@dataclass(frozen=True, eq=False)
class Work:
    """Photographs with a target in them, and what has been made of them.

    Attributes
    ----------
    photos : tuple of Photo
        All photographs, with their verdicts.
    target : Checkerboard, DotGrid, Charuco or SquareGrid
        What was printed, lengths in mm as they were measured.
    measuring : tuple of str
        Photographs in which lengths are measured; the camera is calibrated without them.
    own : bool
        Whether they are the reader's.
    instead : str
        Why the supplied photographs stand in for the reader's, if they do.
    stand_ins : dict of str to str
        By the name that the reader gave: the supplied photograph that is taken for it.
    solved, judgement : Solved and Judgement, optional
        The camera and what is said of it, once it is calibrated.
    """

    photos: tuple[Photo, ...]
    target: Board
    measuring: tuple[str, ...]
    own: bool = False
    instead: str = ""
    stand_ins: dict[str, str] = field(default_factory=dict)
    solved: Solved | None = None
    judgement: Judgement | None = None

    @property
    def camera(self) -> Calibration:
        """The calibrated camera.

        Raises
        ------
        ValueError
            If it is not calibrated yet.
        """
        if self.solved is None:
            raise ValueError("there is no camera yet: run the cell with `calibrate` first")
        return self.solved.calibration


def look(
    photographs: str, folder: str | Path, target: Board, measuring: Sequence[str] = ()
) -> Work:
    """Look for the target in all photographs, and say what is found, a line for each.

    Parameters
    ----------
    photographs : str
        ``"mine"`` for those in `folder`, ``"supplied"`` for those of the course.
    folder : str or Path
        Where a reader's own ones are.
    target : Checkerboard, DotGrid, Charuco or SquareGrid
        What was printed; the supplied photographs have one of their own.
    measuring : sequence of str
        Names of the photographs that are kept for measuring.

    Returns
    -------
    Work
        The reader's photographs; the supplied ones if there is nothing else to go on with.
    """
    names = tuple(measuring)
    if photographs == "mine":
        try:
            return _own(Path(folder), target, names)
        except ValueError as error:
            return _supplied(names, sentence(error))
    if photographs != "supplied":
        say(f'photographs is "mine" or "supplied", got {photographs!r}: these are supplied.\n')
    return _supplied(names)


def _supplied(names: tuple[str, ...], instead: str = "") -> Work:
    """Return the supplied photographs; those to measure in stand in for the reader's, in order."""
    if instead:
        say(f"{instead} The supplied photographs take their place.\n")
    tell = _nothing if instead else say  # what helps is why they are here
    photos = _looked_at(supplied_photographs(), SUPPLIED.target, tell)
    known = {photo.name for photo in photos}
    stand_ins = dict(zip(names, SUPPLIED.measuring, strict=False))
    if not instead and known.issuperset(names):
        stand_ins = {}
    if any(name != other for name, other in stand_ins.items()):
        told = ", ".join(f"{other} for {name}" for name, other in stand_ins.items())
        say(f"To measure in, there are {told}.")
    return Work(photos, SUPPLIED.target, SUPPLIED.measuring, False, instead, stand_ins)


def _own(folder: Path, target: Board, measuring: tuple[str, ...]) -> Work:
    """Return a reader's photographs.

    Raises
    ------
    ValueError
        If there is no folder, or too little in it to calibrate a camera.
    """
    if not folder.is_dir():
        raise ValueError(f"there is no folder {folder.as_posix()} with photographs yet")
    paths = find_photos([str(folder)])
    for line in left_out([str(folder)]):
        say(line)
    photos = _looked_at(paths, target)
    work = Work(photos, target, measuring, own=True)
    absent = [name for name in measuring if name not in {photo.name for photo in photos}]
    if absent:
        say(f"There is no {' and no '.join(absent)} among them: is the name written right?")
    check_board(photos, target)
    count = len(_for_the_camera(work))
    if count < FEWEST:
        kept = sum(photo.used for photo in photos) - count
        others = f"; those to measure in ({kept}) are not counted" if kept else ""
        raise ValueError(
            f"{count} photographs can be used to calibrate, {FEWEST} are needed and 10 are good"
            f"{others}"
        )
    return work


def marked(photo: Photo, width: int = SMALL) -> NDArray[np.uint8] | None:
    """Return a photograph made small, with the corners that count; None if it is none.

    Parameters
    ----------
    photo : Photo
        As of `look_at_photos`.
    width : int
        Of the result, px.

    Returns
    -------
    ndarray, shape (height, width, 3), uint8, optional
        RGB.
    """
    if photo.thumbnail is None or photo.header is None:
        return None
    found = photo.detection.points if photo.detection and photo.used else np.empty((0, 2))
    scale = photo.header.size[0] / photo.thumbnail.shape[1]
    return thumbnail(photo.thumbnail, (found + 0.5) / scale - 0.5, width)


def _nothing(line: str) -> None:
    """Say nothing."""


def _looked_at(
    paths: Sequence[Path], target: Board, tell: Callable[[str], None] = say
) -> tuple[Photo, ...]:
    """Look at photographs, or say again what was seen, if files and target are the same."""
    files = [(path, path.stat().st_mtime_ns, path.stat().st_size) for path in paths]
    if LAST.get("key") == (target, files):
        tell("\n".join(LAST["lines"]))
        return tuple(LAST["photos"])
    lines: list[str] = []

    def heard(line: str) -> None:
        lines.append(line)
        tell(line)

    photos = tuple(look_at_photos(paths, target, heard))
    LAST.update(key=(target, files), lines=lines, photos=photos)
    return photos


def _for_the_camera(work: Work) -> list[Photo]:
    """Return the photographs that the camera is calibrated with."""
    return [p for p in work.photos if p.used and p.name not in work.measuring]


def calibrate(work: Work, coefficients: Sequence[str] = ("k1", "k2", "p1", "p2")) -> Work:
    """Calibrate the camera, without the photographs kept for measuring, and judge it in words.

    Parameters
    ----------
    work : Work
        As of `look`.
    coefficients : sequence of str
        Which numbers of distortion are estimated.

    Returns
    -------
    Work
        With camera and judgement; the supplied photographs, with theirs, if there is no camera.
    """
    others = [p for p in work.photos if p.name not in work.measuring]
    try:
        solved = solve(others, work.target, CameraModel(coefficients=tuple(coefficients)))
    except (DegenerateConfigurationError, ValueError) as error:
        if not work.own:
            raise
        return calibrate(_supplied(work.measuring, sentence(error)), coefficients)
    kept = {photo.name: photo for photo in solved.photos}
    photos = tuple(kept.get(photo.name, photo) for photo in work.photos)
    judgement = judge(solved)
    for statement in judgement.statements:
        say(f"{statement.sign} {in_notebook(statement.text)}")
    return replace(work, photos=photos, solved=solved, judgement=judgement)
