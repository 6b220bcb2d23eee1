"""Every lesson runs from top to bottom: with its solutions, and as a student first opens it."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

from course_lib.authoring.building import find_lessons, release
from course_lib.authoring.expansion import expand
from course_lib.authoring.lesson import Lesson, read_lesson
from course_lib.exercises import all_exercises
from course_lib.judging import Exercise, ValuesExercise

ROOT = Path(__file__).parents[2]
LESSONS = find_lessons(ROOT)
WIDGET = "application/vnd.jupyter.widget-view+json"
SECONDS = 60  # for one cell on a slow machine: it must not keep a student waiting
OFFERED = re.compile(r"^```python\n(.*?)^```", re.M | re.S)

pytestmark = pytest.mark.slow


def executed(notebook: nbformat.NotebookNode, folder: Path) -> nbformat.NotebookNode:
    resources = {"metadata": {"path": str(folder)}}
    return NotebookClient(notebook, timeout=SECONDS, resources=resources).execute()


def outputs(notebook: nbformat.NotebookNode) -> list[nbformat.NotebookNode]:
    return [out for cell in notebook.cells if cell.cell_type == "code" for out in cell.outputs]


def pictures(notebook: nbformat.NotebookNode) -> list[str]:
    """Return the pictures of a notebook, but for explorers, as HTML or as PNG without words."""
    shown = [out["data"] for out in outputs(notebook) if WIDGET not in out.get("data", {WIDGET: 0})]
    png = [data["image/png"] for data in shown if "image/png" in data]
    return png + [data["text/html"] for data in shown if "<img" in data.get("text/html", "")]


def points(notebook: nbformat.NotebookNode) -> dict[str, float]:
    """Return the last value of each check cell."""
    earned = {}
    for cell in notebook.cells:
        if cell.source.startswith('check("'):
            values = [out for out in cell.outputs if out.output_type == "execute_result"]
            earned[cell.source.split('"')[1]] = float(values[-1]["data"]["text/plain"])
    return earned


def with_offers_taken(notebook: nbformat.NotebookNode) -> nbformat.NotebookNode:
    """Paste each piece of code that the text offers and that prints into a cell below it."""
    cells = []
    for cell in notebook.cells:
        offered = OFFERED.findall(cell.source) if cell.cell_type == "markdown" else []
        taken = [nbformat.v4.new_code_cell(code) for code in offered if "print(" in code]
        cells += [cell, *taken]
    notebook.cells = cells
    return notebook


def graded(lesson: Lesson) -> dict[str, float]:
    """Return what each exercise of a lesson is worth, but for questions that a person grades."""
    exercises = all_exercises(lesson.chapter)
    return {e.name: e.points for e in exercises if isinstance(e, Exercise)}


GRADED = [path for path in LESSONS if graded(read_lesson(path))]  # else both runs are the same


def test_offers_are_pasted_below_the_text_that_makes_them() -> None:
    text = "Paste this:\n\n```python\nprint(1)\n```\n\nThe beginning is\n\n```python\na = 2\n```"
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_markdown_cell(text)])
    assert [cell.source for cell in with_offers_taken(notebook).cells] == [text, "print(1)\n"]


@pytest.mark.parametrize("path", GRADED, ids=lambda path: path.stem)
def test_runs_with_its_solutions_and_earns_all_points(path: Path, tmp_path: Path) -> None:
    lesson = read_lesson(path)
    notebook = executed(with_offers_taken(expand(lesson)), tmp_path)
    assert not [out for out in outputs(notebook) if out.output_type == "error"]
    assert not [out.text for out in outputs(notebook) if out.get("name") == "stderr"]
    assert points(notebook) == graded(lesson)


@pytest.mark.parametrize("path", LESSONS, ids=lambda path: path.stem)
def test_runs_before_anything_is_answered(path: Path, tmp_path: Path) -> None:
    (student,) = release([read_lesson(path)])
    notebook = executed(student, tmp_path)
    assert not [out for out in outputs(notebook) if out.output_type == "error"]
    assert not [out.text for out in outputs(notebook) if out.get("name") == "stderr"]
    assert points(notebook) == dict.fromkeys(graded(read_lesson(path)), 0.0)
    for picture in pictures(notebook):
        alt = re.match(r'<img alt="([^"]+)"', picture)
        assert alt, "a picture without a text alternative: decorate its function with @figure"
        assert alt[1].endswith("."), alt[1]


def assigned(source: str) -> set[str]:
    """Return the names that a cell gives a value to."""
    names = {node.id for node in ast.walk(ast.parse(source)) if is_target(node)}
    functions = (ast.FunctionDef, ast.ClassDef)
    return names | {
        node.name for node in ast.walk(ast.parse(source)) if isinstance(node, functions)
    }


def is_target(node: ast.AST) -> bool:
    return isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)


@pytest.mark.parametrize("path", LESSONS, ids=lambda path: path.stem)
def test_no_cell_overwrites_an_answer(path: Path) -> None:
    lesson = read_lesson(path)
    answers = set()
    for exercise in all_exercises(lesson.chapter):
        if isinstance(exercise, ValuesExercise):
            answers |= set(exercise.units)
        elif isinstance(exercise, Exercise):
            answers.add(exercise.function_name)
    for cell in lesson.cells:
        if cell.role == "code":
            assert not assigned(cell.source) & answers, f"{path.name}:{cell.line}"


@pytest.mark.parametrize("path", LESSONS[1:], ids=lambda path: path.stem)  # 00 is not graded
def test_says_how_many_points_there_are(path: Path) -> None:
    lesson = read_lesson(path)
    text = " ".join(cell.source for cell in lesson.cells)
    total = sum(exercise.points for exercise in all_exercises(lesson.chapter))
    assert f"**Points:** {total:g}." in text
