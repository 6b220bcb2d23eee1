"""A photograph of the lab to measure in, and where the camera stood."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from course_lib.calibrating.pictures import SetAside, read_rgb
from course_lib.lab.photographs import Work
from course_lib.lab.words import say, sentence
from course_lib.measuring import View, view_of_target


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


def shot(work: Work, name: str, unevenness: float = 0.0, besides: Shot | None = None) -> Shot:
    """Return a photograph to measure in, and where the camera stood.

    Parameters
    ----------
    work : Work
        With its camera.
    name : str
        Of a photograph in which the target was found.
    unevenness : float
        Standard deviation of the target's points from where they should be, mm.
    besides : Shot, optional
        The first of two photographs for a length in space: the second must be another one.

    Returns
    -------
    Shot
        That photograph. If it cannot be used, a sentence says why, and another one is returned.

    Raises
    ------
    ValueError
        If there is no camera yet, or no photograph any more.
    """
    camera = work.camera
    good = {photo.name: photo for photo in work.photos if photo.used}
    chosen, before = work.stand_ins.get(name, name), besides.name if besides else ""
    if chosen not in good or chosen == before:
        why = _why_not(work, name, chosen == before)
        name_here = name if chosen == name else f"{name} (here {chosen})"
        chosen = _another(work, list(good), name, before)
        say(
            f"{name_here} cannot be measured in. {why} {chosen} is taken in its place: do not use "
            f"what is measured there. The target was found in {', '.join(good)}."
        )
    photo = good[chosen]
    try:
        photograph = read_rgb(photo.path)
    except SetAside as reason:
        gone = replace(photo, used=False, verdict=sentence(reason))
        photos = tuple(gone if other is photo else other for other in work.photos)
        return shot(replace(work, photos=photos), name, unevenness, besides)
    assert photo.detection is not None
    corners = np.asarray(photo.detection.points, float)
    points = work.target.points()[photo.detection.ids]
    view = view_of_target(points, corners, camera, unevenness)
    return Shot(chosen, photograph, corners, view, work.own)


def _why_not(work: Work, name: str, twice: bool) -> str:
    """Return why a photograph cannot be measured in, as a sentence."""
    if twice:
        return "It is the first picture already, and a length in space needs two different ones."
    verdict = next((photo.verdict for photo in work.photos if photo.name == name), "")
    if verdict:
        return verdict
    alike = _named_alike(name, (photo.name for photo in work.photos))
    return "There is no such file." + (f" Do you mean {alike}?" if alike else "")


def _named_alike(name: str, others: Iterable[str]) -> str:
    """Return a name that differs in capitals or in the ending only."""
    plain = Path(name).stem.lower()
    return next((other for other in others if Path(other).stem.lower() == plain), "")


def _another(work: Work, good: list[str], name: str, before: str) -> str:
    """Return a photograph in the place of one: for three names, three different ones."""
    kept = [n for n in work.measuring if n in good and n != before]
    others = kept or [n for n in good if n != before]
    if not others:
        raise ValueError("no photograph is left: run the cell with `look` again")
    place = work.measuring.index(name) if name in work.measuring else 0
    return others[place % len(others)]
