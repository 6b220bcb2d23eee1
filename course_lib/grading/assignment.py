"""An assignment of a term, read once: where things are, what was given, who handed in."""

from __future__ import annotations

import os
from collections.abc import Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from nbgrader.api import MissingEntry
from nbgrader.apps import AutogradeApp

from course_lib.grading.gradebooks import open_gradebook
from course_lib.grading.sanitizing import GivenNotebook, read_notebook_given
from course_lib.grading.submissions import given_cells

#: Where what is known of each grading is kept, in a term's directory.
RECORDS = "grading"


@dataclass(frozen=True)
class Assignment:
    """What is needed to grade an assignment.

    Attributes
    ----------
    name : str
        As nbgrader calls it.
    term : pathlib.Path
        The term's directory.
    db_url, course_id : str
        Its gradebook.
    notebooks : mapping of str to GivenNotebook
        By name, without the suffix.
    folders : mapping of str to str
        nbgrader's names of the folders ``submitted``, ``autograded``, ``source``.
    key_file : pathlib.Path
        The term's key.
    isolation : str
        As `nbgrader_config.py` says.
    cell_seconds : float
        As it says.
    config : object
        All that it says.
    """

    name: str
    term: Path
    db_url: str
    course_id: str
    notebooks: Mapping[str, GivenNotebook]
    folders: Mapping[str, str]
    key_file: Path
    isolation: str
    cell_seconds: float
    config: Any

    def submitted(self, student: str) -> Path:
        """Return the folder of what a student handed in."""
        return self.term / self.folders["submitted"] / student / self.name

    def autograded(self, student: str) -> Path:
        """Return the folder where nbgrader looks for a graded submission."""
        return self.term / self.folders["autograded"] / student / self.name

    def source(self) -> Path:
        """Return the folder of the assignment's source."""
        return self.term / self.folders["source"] / self.name

    def record(self, student: str) -> Path:
        """Return the file with what is known of a student's grading."""
        return self.term / RECORDS / self.name / f"{student}.json"

    def students(self) -> list[str]:
        """Return who handed in, by name."""
        folder = self.term / self.folders["submitted"]
        names = sorted(os.listdir(folder)) if folder.is_dir() else []
        return [name for name in names if self.submitted(name).is_dir()]


def read_assignment(term: Path, name: str) -> Assignment:
    """Read an assignment from a term's settings and gradebook.

    Parameters
    ----------
    term : pathlib.Path
        Made by `course term`.
    name : str
        The assignment.

    Returns
    -------
    Assignment
        All that is needed.

    Raises
    ------
    ValueError
        If there is no term, or the assignment is not in its gradebook.
    """
    term = term.expanduser().resolve()
    if not (term / "nbgrader_config.py").is_file():
        raise ValueError(f"{term} is no term's directory: it has no nbgrader_config.py")
    with _inside(term):
        app = AutogradeApp(log_level="ERROR")
        app.initialize([])
        course = app.coursedir
        with open_gradebook(course.db_url, course.course_id) as gradebook:
            notebooks = _read_notebooks(gradebook, term, name)
    options = app.config.get("AnswerOutside", {})
    steps = ("submitted", "autograded", "source")
    return Assignment(
        name=name,
        term=term,
        db_url=course.db_url,
        course_id=course.course_id,
        notebooks=notebooks,
        folders={step: getattr(course, f"{step}_directory") for step in steps},
        key_file=Path(str(options.get("key_file", term / "grading.key"))),
        isolation=str(options.get("isolation", "bubblewrap")),
        cell_seconds=float(options.get("cell_seconds", 30.0)),
        config=app.config,
    )


def _read_notebooks(gradebook: Any, term: Path, name: str) -> dict[str, GivenNotebook]:
    """Return the notebooks of an assignment by name."""
    try:
        found = gradebook.find_assignment(name)
    except MissingEntry:
        raise ValueError(_no_assignment(name, gradebook)) from None
    notebooks = {}
    for notebook in found.notebooks:
        given = given_cells(term / "release" / name / f"{notebook.name}.ipynb")
        notebooks[notebook.name] = read_notebook_given(notebook, given)
    return notebooks


def _no_assignment(name: str, gradebook: Any) -> str:
    names = sorted(assignment.name for assignment in gradebook.assignments)
    known = f"; it has {', '.join(names)}" if names else ""
    return (
        f"there is no assignment {name!r} in the gradebook{known}. Run first: "
        f"nbgrader generate_assignment {name}"
    )


@contextmanager
def _inside(folder: Path):  # type: ignore[no-untyped-def]
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)
