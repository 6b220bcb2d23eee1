"""Who comes back another day runs the cells before section 1, then the second sitting."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import Any

import matplotlib as mpl
import pytest

mpl.use("Agg")  # as a test has no screen

from course_lib.authoring.building import find_lessons
from course_lib.authoring.expansion import expand
from course_lib.authoring.lesson import read_lesson
from course_lib.exercises import CHAPTERS

#: Where the second sitting begins in lessons that have no heading for it.
FIRST_SECTIONS = {"01_pinhole": "## 7 ", "02_homogeneous": "## 7 ", "06_estimation": "## 4 "}
LESSONS = {
    path.stem: path
    for path in find_lessons(Path(__file__).parents[2])
    if path.stem in CHAPTERS.values()
    and re.search("second sitting|two sittings", path.read_text(encoding="utf-8"), re.IGNORECASE)
}


def before_section_1_and_second_sitting(path: Path) -> tuple[list[str], list[str]]:
    """Return the code of a lesson with its solutions: its setup, and its second sitting."""
    begins = FIRST_SECTIONS.get(path.stem, "## Second sitting")
    setup: list[str] = []
    second: list[str] = []
    part: list[str] | None = setup
    for cell in expand(read_lesson(path)).cells:
        if cell.cell_type == "code":
            if part is not None:
                part.append(cell.source)
        elif re.search(f"^{begins}", cell.source, re.MULTILINE):
            part = second
        elif part is setup and re.search("^## 1 ", cell.source, re.MULTILINE):
            part = None
    return setup, second


def run(cell: str, scope: dict[str, Any]) -> None:
    """Run a cell, and draw its figure as Jupyter would."""
    tree = ast.parse(cell)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), scope)
    shown = eval(compile(ast.Expression(last.value), "cell", "eval"), scope) if last else None
    if hasattr(shown, "canvas"):
        shown.draw_without_rendering()


def test_lessons_are_found() -> None:
    assert set(FIRST_SECTIONS) < set(LESSONS)


@pytest.mark.parametrize("path", LESSONS.values(), ids=lambda path: path.stem)
def test_second_sitting_runs_by_itself(path: Path) -> None:
    setup, second = before_section_1_and_second_sitting(path)
    assert setup
    assert len(second) > 5
    scope: dict[str, Any] = {"__name__": "__main__"}
    for cell in [*setup, *second]:
        run(cell, scope)
