"""Expand a lesson into nbgrader's source notebook: stubs with solutions, checks, questions."""

from __future__ import annotations

import hashlib
import re
from collections import Counter
from typing import Any

import nbformat
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from course_lib.authoring.lesson import Lesson, LessonCell, LessonError
from course_lib.exercises import find
from course_lib.exercises.pasting import BEGIN, END, call, paste
from course_lib.judging import Exercise, Explain, ValuesExercise
from course_lib.judging.text import format_points

#: Tag of a solution cell that holds variables, not a function.
VALUES = "values"
#: nbgrader's id of the cell with the imports.
SETUP = "setup"
#: Tag and nbgrader's id of a cell that shows a report to the person who grades.
REPORT = "report"
#: The same whatever Python builds the notebooks.
METADATA = {
    "kernelspec": {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}


def expand(lesson: Lesson) -> NotebookNode:
    """Make the notebook with solutions that nbgrader calls the source.

    Parameters
    ----------
    lesson : Lesson
        From `read_lesson`.

    Returns
    -------
    nbformat.NotebookNode
        Each exercise as a solution cell and a check, each question with its rubric and a model
        answer; cell ids follow from the content, so that the same lesson gives the same bytes.

    Raises
    ------
    LessonError
        If a cell names an exercise that does not exist, or not one of its kind.
    """
    cells = [new for cell in lesson.cells for new in _expand_cell(lesson, cell)]
    _number(cells)
    notebook = new_notebook(cells=cells, metadata=METADATA)
    nbformat.validate(notebook)
    return notebook


def grade_id(name: str) -> str:
    """Return nbgrader's id of an exercise's cell: its name with a dash for the dot."""
    return name.replace(".", "-")


def check_id(name: str) -> str:
    """Return nbgrader's id of the cell that checks an exercise."""
    return f"{grade_id(name)}-check"


def function_cell(exercise: Exercise) -> str:
    """Return the source of a function exercise's solution cell."""
    return paste(exercise.reference).as_solution()


def values_cell(exercise: ValuesExercise) -> str:
    """Return the source of a values exercise's solution cell: None first, then the values."""
    stub = [f"{name} = None  # {unit}" for name, unit in exercise.units.items()]
    return "\n".join([*stub, BEGIN, values_answer(exercise), END])


def values_answer(exercise: ValuesExercise, function: Any = None, name: str = "") -> str:
    """Return statements that work the values out as a function (the reference) does."""
    function = function or exercise.reference
    name = name or function.__name__
    steps = paste(function, name, alone=True).without_docstring().as_function()
    named = [f'{variable} = answers["{variable}"]' for variable in exercise.units]
    return "\n".join([steps, "", "", f"answers = {call(name, exercise.given)}", *named])


def rubric(question: Explain) -> str:
    """Return the mark scheme of a question: what earns points, and a model answer."""
    earned = [f"> - **{format_points(points)}** · {what}" for points, what in question.rubric]
    quoted = ["> **Rubric** (points · for what)", ">", *earned, ">"]
    answer = f"> **Model answer.** {' '.join(question.model_answer.split())}"
    return "\n".join(["<!-- BEGIN MARK SCHEME -->", *quoted, answer, "<!-- END MARK SCHEME -->"])


def _expand_cell(lesson: Lesson, cell: LessonCell) -> list[NotebookNode]:
    if cell.role == "text":
        return [new_markdown_cell(cell.source, metadata=cell.metadata)]
    if cell.role == "code":
        metadata = dict(cell.metadata)
        if cell is _setup(lesson):
            metadata["nbgrader"] = _flags(SETUP, locked=True)
        elif REPORT in metadata.get("tags", []):
            metadata["nbgrader"] = _flags(REPORT, locked=True)
        return [new_code_cell(cell.source, metadata=metadata)]
    try:
        exercise = find(cell.exercise)
    except ValueError as error:
        raise LessonError(lesson.path, cell.line, str(error)) from error
    if cell.role == "explain" and isinstance(exercise, Explain):
        return _question(exercise, cell.source)
    if cell.role == "exercise" and isinstance(exercise, Exercise):
        return _exercise(exercise)
    other = "a Markdown cell tagged `explain`" if cell.role == "exercise" else "a code cell"
    raise LessonError(lesson.path, cell.line, f"{cell.exercise} belongs in {other}")


def _setup(lesson: Lesson) -> LessonCell | None:
    """Return the cell that imports `check`; it is read-only, as every exercise needs it."""
    imports = re.compile(r"^from course_lib\.notebook import .*\bcheck\b", re.MULTILINE)
    code = (cell for cell in lesson.cells if cell.role == "code")
    return next((cell for cell in code if imports.search(cell.source)), None)


def _exercise(exercise: Exercise) -> list[NotebookNode]:
    values = isinstance(exercise, ValuesExercise)
    source = values_cell(exercise) if isinstance(exercise, ValuesExercise) else ""
    solution = new_code_cell(
        source or function_cell(exercise),
        metadata={
            "nbgrader": _flags(grade_id(exercise.name), solution=True),
            **({"tags": [VALUES]} if values else {}),
        },
    )
    flags = _flags(check_id(exercise.name), grade=True, locked=True, points=exercise.points)
    check = new_code_cell(f'check("{exercise.name}")', metadata={"nbgrader": flags})
    return [solution, check]


def _question(question: Explain, text: str) -> list[NotebookNode]:
    name = grade_id(question.name)
    asked = new_markdown_cell(
        f"{text}\n{rubric(question)}",
        metadata={"nbgrader": _flags(f"{name}-question", locked=True)},
    )
    flags = _flags(name, grade=True, solution=True, points=question.points)
    return [asked, new_markdown_cell(question.model_answer, metadata={"nbgrader": flags})]


def _flags(
    name: str,
    *,
    grade: bool = False,
    solution: bool = False,
    locked: bool = False,
    points: float | None = None,
) -> dict[str, Any]:
    worth = {} if points is None else {"points": int(points) if points == int(points) else points}
    return {
        "grade": grade,
        "grade_id": name,
        "locked": locked,
        "schema_version": 3,
        "solution": solution,
        "task": False,
        **worth,
    }


def _number(cells: list[NotebookNode]) -> None:
    """Give each cell an id that depends on what it is, and on nothing else."""
    seen = Counter[str]()
    for cell in cells:
        digest = hashlib.sha256(f"{cell.cell_type}\n{cell.source}".encode()).hexdigest()[:12]
        name = cell.metadata.get("nbgrader", {}).get("grade_id", digest)[:56]
        seen[name] += 1
        cell.id = name if seen[name] == 1 else f"{name}-{seen[name]}"
