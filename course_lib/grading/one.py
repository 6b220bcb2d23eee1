"""Grade one submission: everything but the gradebook."""

from __future__ import annotations

import json
import os
import shutil
import time
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import nbformat
from nbformat import NotebookNode
from nbgrader.utils import compute_checksum, determine_grade, is_grade, is_solution, is_task

from course_lib.grading.assignment import Assignment, fingerprint
from course_lib.grading.marking import REASONS, mark
from course_lib.grading.outside import Judge, Outcome, Submitted
from course_lib.grading.planning import CHECK
from course_lib.grading.sanitizing import sanitize
from course_lib.grading.seeding import grading_seed, read_key
from course_lib.grading.servers import ServerGoneError
from course_lib.grading.submissions import UnreadableError, files_beside, read_notebook

#: What nbgrader leaves out when it copies a submission.
NOT_COPIED = {"__pycache__", ".ipynb_checkpoints"}
MOST_COPIED = 100_000_000
ENDED = "The notebook ended the Python that grades it, twice. A person must look at it."


@dataclass(frozen=True)
class Graded:
    """What came of one submission.

    Attributes
    ----------
    student : str
        Who.
    fingerprint : str
        Of which version of the submission.
    trouble : str
        Why it could not be graded, as a sentence for the student; empty if it was.
    notes : tuple of str
        What the instructor should know.
    grades : mapping of str to mapping of str to float or None
        By notebook and cell: points, or None where a person must grade.
    responses : mapping of str to mapping of str to bool
        By notebook and cell: whether there is an answer other than the stub.
    exercises : mapping of str to mapping
        By exercise: points, possible, kinds of the parts, misconceptions.
    seconds : float
        What it took.
    """

    student: str
    fingerprint: str
    trouble: str = ""
    notes: tuple[str, ...] = ()
    grades: Mapping[str, Mapping[str, float | None]] = field(default_factory=dict)
    responses: Mapping[str, Mapping[str, bool]] = field(default_factory=dict)
    exercises: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    seconds: float = 0.0

    def as_json(self) -> str:
        """Return the record that is kept of it."""
        return json.dumps(asdict(self), indent=1, ensure_ascii=False)


def growing_folder(assignment: Assignment, student: str) -> Path:
    """Return where a graded submission grows until it is in the gradebook."""
    final = assignment.autograded(student)
    return final.with_name(f".{final.name}.part")


def grade_one(assignment: Assignment, student: str, judge: Judge) -> Graded:
    """Grade what a student handed in, and write the graded notebooks beside their final place.

    Parameters
    ----------
    assignment : Assignment
        What was asked.
    student : str
        Who.
    judge : Judge
        Where it runs.

    Returns
    -------
    Graded
        For the gradebook; with `trouble` if it cannot be graded.
    """
    start, work = time.perf_counter(), _Work(assignment, student, judge)
    trouble = ""
    try:
        work.grade_all()
    except UnreadableError as error:
        trouble = str(error)
    except ServerGoneError as error:
        trouble = ENDED
        work.notes.append(str(error)[:300])
    if trouble:
        shutil.rmtree(work.growing, ignore_errors=True)
        work.grades.clear()
    return Graded(
        student,
        fingerprint(work.folder, list(assignment.notebooks)),
        trouble,
        notes=tuple(work.notes),
        grades=work.grades,
        responses=work.responses,
        exercises={} if trouble else work.exercises,
        seconds=round(time.perf_counter() - start, 3),
    )


class _Work:
    """The notebooks of one submission, one after the other."""

    def __init__(self, assignment: Assignment, student: str, judge: Judge) -> None:
        self.assignment, self.student, self.judge = assignment, student, judge
        self.folder = assignment.submitted(student)
        self.growing = growing_folder(assignment, student)
        self.notes: list[str] = []
        self.grades: dict[str, dict[str, float | None]] = {}
        self.responses: dict[str, dict[str, bool]] = {}
        self.exercises: dict[str, dict[str, Any]] = {}

    def grade_all(self) -> None:
        """Grade every notebook of the assignment that was handed in."""
        folder = self.folder
        shutil.rmtree(self.growing, ignore_errors=True)
        _copy_beside(folder, self.growing)
        _copy_beside(self.assignment.source(), self.growing)
        there = [n for n in self.assignment.notebooks if os.path.lexists(folder / f"{n}.ipynb")]
        if not there:
            raise UnreadableError(_not_there(folder, list(self.assignment.notebooks)))
        for name in there:
            self._grade(name, read_notebook(folder / f"{name}.ipynb"), folder)
        for name in self.assignment.notebooks:
            if name not in there:
                self.notes.append(f"{name}.ipynb was not handed in: 0 points")
                cells = self.assignment.notebooks[name].cells
                self.grades[name] = {c: 0.0 for c, g in cells.items() if g.flags["grade"]}

    def _grade(self, name: str, notebook: NotebookNode, folder: Path) -> None:
        given = self.assignment.notebooks[name]
        clean = sanitize(notebook, given)
        if clean.copied:
            self.notes.append(
                f"more than one copy of {', '.join(clean.copied)}: one of each counts"
            )
        if clean.restored:
            self.notes.append(f"put back: {', '.join(clean.restored)}")
        key = read_key(self.assignment.key_file)
        seed = grading_seed(key, self.student, self.assignment.name)
        files = files_beside(folder)
        outcome = self.judge.judge(Submitted(clean.notebook, seed, given.unlabelled, files))
        if outcome.reason:
            self.notes.append(REASONS.get(outcome.reason, REASONS["crash"]))
        mark(clean.notebook, outcome)
        self._note_grades(name, clean.notebook)
        self._note_exercises(clean.notebook, outcome)
        self.growing.mkdir(parents=True, exist_ok=True)
        nbformat.write(clean.notebook, self.growing / f"{name}.ipynb")

    def _note_grades(self, name: str, notebook: NotebookNode) -> None:
        grades, responses = self.grades.setdefault(name, {}), self.responses.setdefault(name, {})
        for cell in notebook.cells:
            label = cell.metadata.get("nbgrader", {})
            if is_grade(cell):
                score, _ = determine_grade(cell)
                grades[label["grade_id"]] = None if score is None else float(score)
            if is_solution(cell) or is_task(cell):
                untouched = label.get("checksum") == compute_checksum(cell) and not is_task(cell)
                responses[label["grade_id"]] = not untouched

    def _note_exercises(self, notebook: NotebookNode, outcome: Outcome) -> None:
        for index, verdict in outcome.verdicts.items():
            match = CHECK.fullmatch(notebook.cells[index].source)
            if verdict is None:
                if match:
                    self.exercises[match[1]] = {"points": 0.0, "reached": False}
                continue
            self.exercises[verdict.exercise] = {
                "points": verdict.points,
                "possible": verdict.possible,
                "attempted": verdict.attempted,
                "parts": {part.name: part.feedback.kind for part in verdict.parts},
                "misconceptions": list(verdict.misconceptions),
                "hints": list(verdict.hints),
            }


def _not_there(folder: Path, names: list[str]) -> str:
    wanted = " and ".join(f"{name}.ipynb" for name in names)
    others = sorted(path.name for path in folder.glob("*.ipynb"))
    if others:
        return (
            f"There is no {wanted}, but {', '.join(others[:3])}. Please give the file the name "
            "that it had, and hand it in again."
        )
    return f"There is no {wanted} in what was handed in. Please hand it in again."


def _copy_beside(folder: Path, target: Path) -> None:
    """Copy what lies beside notebooks; links are left out, as they could lead anywhere."""
    left = MOST_COPIED
    for place, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if name not in NOT_COPIED]
        for name in names:
            path = Path(place, name)
            if path.suffix == ".ipynb" or path.is_symlink() or not path.is_file():
                continue
            left -= path.stat().st_size
            if left < 0:
                raise UnreadableError(
                    "The files beside the notebook are too large to be graded. Please hand in only "
                    "the notebook and what it needs."
                )
            goal = target / path.relative_to(folder)
            goal.parent.mkdir(parents=True, exist_ok=True)
            goal.unlink(missing_ok=True)
            shutil.copyfile(path, goal)
