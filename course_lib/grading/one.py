"""Grade one submission: everything but the gradebook."""

from __future__ import annotations

import json
import time
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

import nbformat
from nbformat import NotebookNode
from nbgrader.utils import compute_checksum, determine_grade, is_grade, is_solution, is_task

from course_lib.grading.marking import REASONS, mark
from course_lib.grading.outside import Judge, Outcome, Submitted
from course_lib.grading.parcels import Parcel, unforeseen
from course_lib.grading.planning import CHECK
from course_lib.grading.sanitizing import GivenNotebook, sanitize
from course_lib.grading.servers import ServerGoneError
from course_lib.grading.submissions import UnreadableError, read_notebook

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
        By exercise: points, possible, kinds of the parts and what caused them, misconceptions,
        hints, seconds.
    seconds : float
        What it took.
    notebooks : mapping of str to bytes
        The graded notebooks, by name.
    """

    student: str
    fingerprint: str
    trouble: str = ""
    notes: tuple[str, ...] = ()
    grades: Mapping[str, Mapping[str, float | None]] = field(default_factory=dict)
    responses: Mapping[str, Mapping[str, bool]] = field(default_factory=dict)
    exercises: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    seconds: float = 0.0
    notebooks: Mapping[str, bytes] = field(default_factory=dict, repr=False)

    def as_json(self) -> str:
        """Return the record that is kept of it, beside the notebooks."""
        record = asdict(self)
        del record["notebooks"]
        return json.dumps(record, indent=1, ensure_ascii=False)


def grade_one(given: Mapping[str, GivenNotebook], parcel: Parcel, judge: Judge) -> Graded:
    """Grade what a student handed in. Whatever one submission does, it costs itself only.

    Parameters
    ----------
    given : mapping of str to GivenNotebook
        The assignment's notebooks, by name.
    parcel : Parcel
        What was handed in.
    judge : Judge
        Where it runs.

    Returns
    -------
    Graded
        For the gradebook; with `trouble` if it cannot be graded.
    """
    start, work = time.perf_counter(), _Work(given, parcel, judge)
    trouble = parcel.trouble
    try:
        if not trouble:
            work.grade_all()
    except UnreadableError as error:
        trouble = str(error)
    except ServerGoneError as error:
        trouble = ENDED
        work.notes.append(str(error)[:300])
    except Exception as error:  # nobody foresaw it
        trouble = unforeseen(error)
        work.notes.append(trouble)
    if trouble:
        return Graded(parcel.student, parcel.fingerprint, trouble, tuple(work.notes))
    return Graded(
        parcel.student,
        parcel.fingerprint,
        notes=tuple(work.notes),
        grades=work.grades,
        responses=work.responses,
        exercises=work.exercises,
        seconds=round(time.perf_counter() - start, 3),
        notebooks=work.notebooks,
    )


class _Work:
    """The notebooks of one submission, one after the other."""

    def __init__(self, given: Mapping[str, GivenNotebook], parcel: Parcel, judge: Judge) -> None:
        self.given, self.parcel, self.judge = given, parcel, judge
        self.notes: list[str] = []
        self.grades: dict[str, dict[str, float | None]] = {}
        self.responses: dict[str, dict[str, bool]] = {}
        self.exercises: dict[str, dict[str, Any]] = {}
        self.notebooks: dict[str, bytes] = {}

    def grade_all(self) -> None:
        """Grade every notebook of the assignment that was handed in."""
        for name, content in self.parcel.notebooks.items():
            self._grade(name, read_notebook(content))
        for name in self.given:
            if name not in self.parcel.notebooks:
                self.notes.append(f"{name}.ipynb was not handed in: 0 points")
                cells = self.given[name].cells
                self.grades[name] = {c: 0.0 for c, g in cells.items() if g.flags["grade"]}

    def _grade(self, name: str, notebook: NotebookNode) -> None:
        given, parcel = self.given[name], self.parcel
        clean = sanitize(notebook, given)
        if clean.copied:
            self.notes.append(
                f"more than one copy of {', '.join(clean.copied)}: one of each counts"
            )
        if clean.restored:
            self.notes.append(f"put back: {', '.join(clean.restored)}")
        submitted = Submitted(clean.notebook, parcel.seed, given.unlabelled, parcel.files)
        outcome = self.judge.judge(submitted)
        if outcome.reason:
            self.notes.append(REASONS.get(outcome.reason, REASONS["crash"]))
        mark(clean.notebook, outcome)
        self._note_grades(name, clean.notebook)
        self._note_exercises(clean.notebook, outcome)
        self.notebooks[name] = f"{nbformat.writes(clean.notebook)}\n".encode()

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
                    possible = float(notebook.cells[index].metadata["nbgrader"]["points"])
                    lost = {"points": 0.0, "possible": possible, "reached": False}
                    self.exercises[match[1]] = lost
                continue
            self.exercises[verdict.exercise] = {
                "points": verdict.points,
                "possible": verdict.possible,
                "attempted": verdict.attempted,
                "parts": {part.name: part.feedback.kind for part in verdict.parts},
                "causes": {p.name: p.feedback.cause for p in verdict.parts if p.feedback.cause},
                "misconceptions": list(verdict.misconceptions),
                "hints": list(verdict.hints),
                "seconds": round(outcome.seconds.get(index, 0.0), 3),
            }
