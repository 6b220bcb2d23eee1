"""A simulated class: submissions of every kind, each with the points that it must get.

This is where the generators meet the exercises: what a student types is the source of a reference
or of a misconception, and what it is worth is found on seeds of its own, so that the class knows
nothing of a term's secret.
"""

from __future__ import annotations

import copy
import hashlib
import itertools
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import nbformat
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_notebook

from course_lib.authoring.building import notebook_bytes
from course_lib.authoring.expansion import check_id, grade_id
from course_lib.exercises import all_exercises
from course_lib.judging import (
    Exercise,
    Explain,
    ValuesExercise,
)
from data_generators.mishaps import ENDS, NOISES, TROUBLES
from data_generators.pasting_mishaps import (
    by_label,
    label_oddly,
    label_of,
    paste_at_end,
    paste_below,
)
from data_generators.typed_answers import Typed, right, wrong_answers

Solutions = Mapping[str, Callable[..., Any]]
#: When they were handed in, as nbgrader notes it.
TIMESTAMP = "2026-10-01 12:00:00 UTC"
#: Who pasted copies of cells.
PASTED = "pasted-copies"
WORDS = "A long lens only enlarges; the faces look flat because we stand farther away."


@dataclass(frozen=True)
class Submission:
    """What a student hands in.

    Parameters
    ----------
    student : str
        The name nbgrader knows them by; here it says what is special about the submission.
    content : bytes
        The file.
    points : mapping of str to float, or None
        By exercise, for those that are graded automatically. None if the file cannot be graded.
    hints : sequence of str
        What the feedback must say.
    filename : str
        Its name; empty if it is the assignment's.
    """

    student: str
    content: bytes
    points: Mapping[str, float] | None
    hints: Sequence[str] = ()
    filename: str = ""


@dataclass(frozen=True)
class Simulation:
    """A released notebook and the exercises in it, from which submissions are made."""

    released: NotebookNode
    chapter: str
    rewritten: Solutions = field(default_factory=dict)

    @property
    def exercises(self) -> list[Exercise]:
        """The exercises that are graded automatically."""
        return [e for e in all_exercises(self.chapter) if isinstance(e, Exercise)]

    def hand_in(self, student: str, typed: Mapping[str, Typed], words: str = WORDS) -> Submission:
        """Fill answers into the notebook; exercises without one stay untouched."""
        notebook = copy.deepcopy(self.released)
        cells = {cell.metadata.get("nbgrader", {}).get("grade_id"): cell for cell in notebook.cells}
        for name, one in typed.items():
            cells[grade_id(name)].source = one.source
        for question in all_exercises(self.chapter):
            if isinstance(question, Explain) and words:
                cells[grade_id(question.name)].source = words
        points = {e.name: typed[e.name].points if e.name in typed else 0.0 for e in self.exercises}
        hints = tuple(one.hint for one in typed.values() if one.hint)
        return Submission(student, notebook_bytes(notebook), points, hints)


def simulate_class(released: NotebookNode, chapter: str, rewritten: Solutions) -> list[Submission]:
    """Make a class in which each kind of submission occurs.

    Parameters
    ----------
    released : nbformat.NotebookNode
        The notebook that students got.
    chapter : str
        Its chapter's module of exercises, e.g. ``"pinhole"``.
    rewritten : mapping of str to callable
        A right answer to each exercise, by function name, written differently from the library.

    Returns
    -------
    list of Submission
        Right, rewritten, half done, untouched; the k-th misconception of every exercise (without
        those whose points depend on the numbers that are asked); answers
        that fail, or are right but noisy; files with cells deleted, pasted twice or in a bad
        state.
    """
    simulation = Simulation(released, chapter, rewritten)
    makers = (_good, _misconceived, _troubled, _pasted, _damaged)
    return [submission for maker in makers for submission in maker(simulation)]


def write_submissions(directory: Path, assignment: str, submissions: Sequence[Submission]) -> None:
    """Put submissions where ``nbgrader collect`` would.

    Parameters
    ----------
    directory : pathlib.Path
        A term's course directory.
    assignment : str
        E.g. ``"01_pinhole"``.
    submissions : sequence of Submission
        From `simulate_class`.
    """
    for submission in submissions:
        folder = directory / "submitted" / submission.student / assignment
        folder.mkdir(parents=True)
        name = submission.filename or f"{assignment}.ipynb"
        (folder / name).write_bytes(submission.content)
        (folder / "timestamp.txt").write_text(TIMESTAMP, encoding="utf-8")
        (folder / "submission_secret.txt").write_text(_receipt(submission), encoding="utf-8")


def _receipt(submission: Submission) -> str:
    """Return what nbgrader names a student's feedback by in the exchange; random in its own."""
    return hashlib.sha256(submission.student.encode() + submission.content).hexdigest()


def _good(simulation: Simulation) -> Iterator[Submission]:
    exercises, rewritten = simulation.exercises, simulation.rewritten
    done = {e.name: right(e) for e in exercises}
    yield simulation.hand_in("right", done)
    other = {e.name: right(e, rewritten[e.function_name]) for e in exercises}
    yield simulation.hand_in("rewritten", other)
    half = {e.name: done[e.name] for e in exercises[::2]}
    yield simulation.hand_in("half-done", half, words="")
    yield simulation.hand_in("untouched", {}, words="")


def _misconceived(simulation: Simulation) -> Iterator[Submission]:
    wrong = {e.name: [*wrong_answers(e)] for e in simulation.exercises}
    done = {e.name: right(e) for e in simulation.exercises}
    for k in range(max(map(len, wrong.values()))):
        typed = done | {name: answers[k] for name, answers in wrong.items() if k < len(answers)}
        yield simulation.hand_in(f"misconception-{k + 1}", typed)


def _troubled(simulation: Simulation) -> Iterator[Submission]:
    functions = [e for e in simulation.exercises if not isinstance(e, ValuesExercise)]
    for student, mishaps, kept in (("troubled", TROUBLES, 0.0), ("noisy", NOISES, 1.0)):
        happens = itertools.cycle(mishaps.values())
        typed = {e.name: Typed(next(happens)(e), kept * e.points) for e in functions}
        yield simulation.hand_in(student, typed)
    for student, ends in ENDS.items():
        typed = {e.name: right(e) for e in simulation.exercises}
        last = functions[2]
        typed[last.name] = Typed(ends(last), 0.0)
        after = simulation.exercises[simulation.exercises.index(last) :]
        lost = {e.name: Typed(typed[e.name].source, 0.0) for e in after}
        yield simulation.hand_in(student, typed | lost)


def _pasted(simulation: Simulation) -> Iterator[Submission]:
    """Hand in copies of cells: what a check met on the way from top to bottom counts."""
    first, second, third, fourth = simulation.exercises[:4]
    done = {e.name: right(e) for e in simulation.exercises}
    bad = {e.name: next(wrong_answers(e)) for e in (first, second)}
    notebook = _read(simulation.hand_in("", {**done, second.name: bad[second.name]}))
    cells, given = by_label(notebook), by_label(simulation.released)
    paste_below(notebook, cells["setup"], cells["setup"].source)
    # A wrong copy below a right answer, before the check.
    paste_below(notebook, cells[grade_id(first.name)], bad[first.name].source)
    # A wrong answer with its check, and a right pair at the end; then the other way round.
    for one, source in (
        (second, done[second.name].source),
        (third, given[grade_id(third.name)].source),
    ):
        paste_at_end(notebook, cells[grade_id(one.name)], source)
        paste_at_end(notebook, cells[check_id(one.name)], cells[check_id(one.name)].source)
    # The answer typed into a copy below the stub.
    paste_below(notebook, cells[grade_id(fourth.name)], done[fourth.name].source)
    cells[grade_id(fourth.name)].source = given[grade_id(fourth.name)].source
    points = {e.name: e.points for e in simulation.exercises}
    points[first.name] = bad[first.name].points
    yield Submission(PASTED, notebook_bytes(notebook), points, (bad[first.name].hint,))


def _damaged(simulation: Simulation) -> Iterator[Submission]:
    exercises = simulation.exercises
    whole = simulation.hand_in("whole", {e.name: right(e) for e in exercises})
    first, second = exercises[0].name, exercises[1].name

    notebook = _read(whole)
    gone = {check_id(first), grade_id(second), check_id(second), "setup"}
    notebook.cells = [c for c in notebook.cells if label_of(c) not in gone]
    notebook.cells.insert(0, new_code_cell("import numpy as np"))
    points = {**(whole.points or {}), second: 0.0}
    yield Submission("deleted-cells", notebook_bytes(notebook), points)

    bare = new_notebook(cells=[new_code_cell(c.source) for c in _code(_read(whole))])
    yield Submission("copied-out", notebook_bytes(bare), whole.points)

    notebook = _read(whole)
    notebook.metadata.kernelspec = {"name": "matlab", "display_name": "M", "language": "matlab"}
    label_oddly(notebook)
    yield Submission("other-tool", notebook_bytes(notebook), whole.points)

    yield Submission("cut-off", whole.content[: len(whole.content) // 2], None)
    yield Submission("empty-file", b"", None)
    yield Submission("renamed", whole.content, None, filename="my homework (final).ipynb")


def _read(submission: Submission) -> NotebookNode:
    return nbformat.reads(submission.content.decode("utf-8"), as_version=4)


def _code(notebook: NotebookNode) -> list[NotebookNode]:
    return [cell for cell in notebook.cells if cell.cell_type == "code"]
