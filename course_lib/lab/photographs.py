"""The photographs of the lab: a reader's own, or supplied ones; and the camera that took them.

Nothing here raises for what a reader brings: it is said in a sentence, and the supplied
photographs take the place of those that are missing.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from course_lib.boards import Board
from course_lib.calibrating.judgement import Judgement, judge
from course_lib.calibrating.looking import Photo, look_at_photos
from course_lib.calibrating.pictures import SetAside, find_photos, left_out
from course_lib.calibrating.solving import Solved, solve
from course_lib.calibration import Calibration, CameraModel
from course_lib.checks import DegenerateConfigurationError
from course_lib.lab.supplied import SUPPLIED, supplied_photographs
from course_lib.measuring import View, view_of_target

#: What a reader can choose.
CHOICES = ("supplied", "mine")
#: Fewer views make no camera.
FEWEST = 3


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
    solved, judgement : Solved and Judgement, optional
        The camera and what is said of it, once it is calibrated.
    """

    photos: tuple[Photo, ...]
    target: Board
    measuring: tuple[str, ...]
    own: bool = False
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


@dataclass(frozen=True, eq=False)
class Shot:
    """A photograph to measure in.

    Attributes
    ----------
    name : str
        Its file.
    photograph : ndarray, shape (h, w, 3), uint8
        RGB, as the sensor had it: not turned upright.
    corners : ndarray, shape (N, 2)
        The target's points in it, px.
    view : View
        Where the camera stood, and how well that is known.
    own : bool
        Whether it is the reader's.
    """

    name: str
    photograph: NDArray[np.uint8]
    corners: NDArray[np.float64]
    view: View
    own: bool = False


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
    if photographs == "mine":
        try:
            return _own(Path(folder), target, tuple(measuring))
        except ValueError as error:
            print(f"{_sentence(error)} The supplied photographs take their place.\n")
    elif photographs != "supplied":
        print(f'photographs is "mine" or "supplied", got {photographs!r}: these are supplied.\n')
    paths = supplied_photographs()
    photos = look_at_photos(paths, SUPPLIED.target, print)
    return Work(tuple(photos), SUPPLIED.target, SUPPLIED.measuring)


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
        print(line)
    photos = look_at_photos(paths, target, print)
    work = Work(tuple(photos), target, measuring, own=True)
    absent = [name for name in measuring if name not in {photo.name for photo in photos}]
    if absent:
        print(f"There is no {' and no '.join(absent)} among them: is the name written right?")
    count = len(_for_the_camera(work))
    if count < FEWEST:
        raise ValueError(
            f"{count} photographs can be used to calibrate, {FEWEST} are needed and 10 are good"
        )
    return work


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
        print(f"{_sentence(error)} The supplied photographs take their place.\n")
        return calibrate(look("supplied", "", work.target), coefficients)
    kept = {photo.name: photo for photo in solved.photos}
    photos = tuple(kept.get(photo.name, photo) for photo in work.photos)
    judgement = judge(solved)
    for statement in judgement.statements:
        print(f"{statement.sign} {statement.text}")
    return replace(work, photos=photos, solved=solved, judgement=judgement)


def shot(work: Work, name: str, unevenness: float = 0.0) -> Shot:
    """Return a photograph to measure in, and where the camera stood.

    Parameters
    ----------
    work : Work
        With its camera.
    name : str
        Of a photograph in which the target was found.
    unevenness : float
        Standard deviation of the target's points from where they should be, mm.

    Returns
    -------
    Shot
        That photograph. If it cannot be used, a sentence says why, and another one is returned.

    Raises
    ------
    ValueError
        If there is no camera yet.
    """
    camera = work.camera
    good = {photo.name: photo for photo in work.photos if photo.used}
    if name not in good:
        kept = [n for n in work.measuring if n in good]
        other = (kept or list(good))[0]
        why = next((p.verdict for p in work.photos if p.name == name), "There is no such file.")
        print(f"{name} cannot be measured in. {why} This is {other}.")
        print(f"The target was found in {', '.join(good)}.")
        name = other
    photo = good[name]
    assert photo.detection is not None
    corners = np.asarray(photo.detection.points, float)
    points = work.target.points()[photo.detection.ids]
    view = view_of_target(points, corners, camera, unevenness)
    return Shot(name, read_rgb(photo.path), corners, view, work.own)


def read_rgb(path: Path) -> NDArray[np.uint8]:
    """Return a photograph in colour, as the sensor had it.

    Raises
    ------
    SetAside
        If it cannot be read any more.
    """
    from PIL import Image

    try:
        with Image.open(path) as picture:
            return np.asarray(picture.convert("RGB"), np.uint8)
    except OSError as error:
        raise SetAside(f"{path.name} cannot be read any more ({error})") from None


def _sentence(reason: object) -> str:
    text = str(reason).rstrip(".")
    return text[0].upper() + text[1:] + "."
