"""Grading a class: `course grade`, behind walls and judged outside, beside stock nbgrader."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
import time
from dataclasses import replace
from itertools import cycle, islice
from pathlib import Path

import nbformat

from benchmarks.compute import clean_environment
from benchmarks.table import Row

ROOT = Path(__file__).resolve().parents[1]
ASSIGNMENT = "01_pinhole"
#: nbgrader as it comes: it runs every cell in a kernel and takes the points that are in it.
STOCK = """c = get_config()
c.CourseDirectory.course_id = "camera"
c.Execute.timeout = 60
"""


def grading(rounds: int = 1, submissions: int = 60) -> list[Row]:
    """Measure a class of honest submissions to the real notebook of chapter 01."""
    with tempfile.TemporaryDirectory() as folder:
        term, stock = Path(folder) / "term", Path(folder) / "stock"
        make_term(term, submissions)
        shutil.copytree(term, stock)
        (stock / "nbgrader_config.py").write_text(STOCK, encoding="utf-8")
        ours, theirs = [], []
        for _ in range(rounds):
            ours.append(_seconds(["course", "grade", ASSIGNMENT, "--force"], term))
            theirs.append(_seconds(["nbgrader", "autograde", ASSIGNMENT, "--force"], stock))
        if _scores(term) != _scores(stock):
            raise RuntimeError("the two graders do not agree on honest submissions")
    a, b = min(ours) / submissions, min(theirs) / submissions
    return [Row("course grade, a submission", a, "s", "nbgrader autograde", b, "≤ 0.1 ×")]


def make_term(term: Path, number: int) -> None:
    """Make a term with a class that only handed in what every grader can bear."""
    sys.path[:0] = [str(ROOT / "tests/exercises")]
    from second_solutions import second_solutions

    from data_generators.classes import simulate_class, write_submissions

    _run(["course", "term", str(term), "--chapters", ASSIGNMENT, "--course-id", "camera"], ROOT)
    _run(["nbgrader", "generate_assignment", ASSIGNMENT], term)
    released = nbformat.read(term / "release" / ASSIGNMENT / f"{ASSIGNMENT}.ipynb", as_version=4)
    everybody = simulate_class(released, "pinhole", second_solutions("pinhole"))
    kinds = ("right", "rewritten", "half-done", "untouched", "misconception")
    honest = [s for s in everybody if s.student.startswith(kinds)]
    chosen = [
        replace(s, student=f"{s.student}-{k}") for k, s in enumerate(cycle_of(honest, number))
    ]
    write_submissions(term, ASSIGNMENT, chosen)


def cycle_of(items: list, number: int) -> list:
    return list(islice(cycle(items), number))


def _scores(term: Path) -> dict[str, float]:
    from nbgrader.api import Gradebook

    with Gradebook(f"sqlite:///{term}/gradebook.db") as gradebook:
        return {s.student.id: s.score for s in gradebook.assignment_submissions(ASSIGNMENT)}


def _seconds(command: list[str], folder: Path) -> float:
    start = time.perf_counter()
    _run(command, folder)
    return time.perf_counter() - start


def _run(command: list[str], folder: Path) -> None:
    program = [str(Path(sys.executable).with_name(command[0])), *command[1:]]
    subprocess.run(program, cwd=folder, env=clean_environment(), check=True, capture_output=True)
