"""Find an exercise by its name, ``"chapter.function"``."""

from __future__ import annotations

import difflib
import importlib

from course_lib.judging import Exercise, Explain

#: Chapters with exercises, in the order of the course: the module here, and the notebook's name.
CHAPTERS = {
    "welcome": "00_welcome",
    "pinhole": "01_pinhole",
    "homogeneous": "02_homogeneous",
    "lenses": "03_lenses",
    "sensor": "04_sensor",
    "distortion": "05_distortion",
    "estimation": "06_estimation",
    "calibration": "07_calibration",
    "epipolar": "08_epipolar",
    "triangulation": "09_triangulation",
    "bundle": "10_bundle",
    "planning": "11_planning",
    "lab": "12_lab",
}


def all_exercises(chapter: str | None = None) -> list[Exercise | Explain]:
    """Return the exercises of one chapter, or of all, in their order.

    Parameters
    ----------
    chapter : str, optional
        A key of `CHAPTERS`.

    Returns
    -------
    list of Exercise or Explain
        Each chapter module's ``EXERCISES``.

    Raises
    ------
    ValueError
        If there is no such chapter.
    """
    if chapter is not None and chapter not in CHAPTERS:
        raise ValueError(f"no chapter {chapter!r}; there are {', '.join(CHAPTERS)}")
    chapters = [chapter] if chapter else list(CHAPTERS)
    modules = [importlib.import_module(f"course_lib.exercises.{name}") for name in chapters]
    return [exercise for module in modules for exercise in module.EXERCISES]


def find(name: str) -> Exercise | Explain:
    """Return the exercise with a name.

    Parameters
    ----------
    name : str
        Chapter and function, e.g. ``"pinhole.project_pinhole"``.

    Returns
    -------
    Exercise or Explain
        What `course_lib.exercises` holds under that name.

    Raises
    ------
    ValueError
        If there is none; the message names similar ones.
    """
    chapter = name.partition(".")[0]
    pool = all_exercises(chapter) if chapter in CHAPTERS else all_exercises()
    for exercise in pool:
        if exercise.name == name:
            return exercise
    names = [exercise.name for exercise in pool]
    near = difflib.get_close_matches(name, names, n=3, cutoff=0.3) or names
    raise ValueError(f"no exercise {name!r}; did you mean {' or '.join(near)}?")
