"""Grading a class: `course grade`, behind walls and judged outside, beside nbgrader and otter."""

from __future__ import annotations

import json
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import replace
from itertools import cycle, islice
from pathlib import Path

import nbformat
from nbformat import NotebookNode

from benchmarks import otter
from benchmarks.memory import watched
from benchmarks.processes import clean_environment, program
from benchmarks.table import Row

ROOT = Path(__file__).resolve().parents[1]
ASSIGNMENT, CHAPTER = "01_pinhole", "pinhole"
#: nbgrader as it comes: it runs every cell in a kernel and takes the points that are in it.
STOCK = """c = get_config()
c.CourseDirectory.course_id = "camera"
c.Execute.timeout = 60
"""
#: Kinds of submissions that every grader can bear.
HONEST = ("right", "rewritten", "half-done", "untouched", "misconception")


def grading(rounds: int = 1, submissions: int = 60, otters: int = 4, many: int = 600) -> list[Row]:
    """Measure a class of honest submissions to the real notebook of chapter 01.

    Ours and nbgrader grade the same class in turns; so does otter a few of it, one by one, as
    each costs it the same. One larger class shows whether time and memory grow with the class.
    """
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        released = make_term(folder / "class", submissions)
        archive, student = otter.assign(released, CHAPTER, _new(folder / "otter"))
        handed_in = _spread(folder / "class", otters)
        ours, theirs, otters_own = [], [], []
        for number in range(rounds):
            ours.append(_ours(folder / "class", folder / f"ours-{number}"))
            theirs.append(_stock(folder / "class", folder / f"stock-{number}"))
            otters_own += [_otter(archive, student, path, folder / "otter") for path in handed_in]
            if _scores(folder / f"ours-{number}") != _scores(folder / f"stock-{number}"):
                raise RuntimeError("the two graders do not agree on honest submissions")
        make_term(folder / "many", many)
        large = _ours(folder / "many", folder / "ours-many")
    seconds = statistics.median(one for one, _ in ours) / submissions
    peak = statistics.median(megabytes for _, megabytes in ours)
    stock = statistics.median(theirs) / submissions
    slow = statistics.median(otters_own)
    what = f"course grade, {submissions} submissions: each"
    return [
        Row(what, seconds, "s", "nbgrader autograde, the same", stock, "≤ 0.1 ×"),
        Row(what, seconds, "s", f"otter run, {otters} of them", slow, "≤ 0.033 ×"),
        Row(f"course grade, {many}: each", large[0] / many, "s", what, seconds, "≤ 1.1 ×"),
        Row(f"course grade, {many}: peak memory", large[1], "MB", what, peak, "≤ 1.1 ×"),
    ]


def _new(folder: Path) -> Path:
    folder.mkdir()
    return folder


def make_term(term: Path, number: int) -> NotebookNode:
    """Make a term with a class; return the notebook that it was given."""
    sys.path[:0] = [str(ROOT / "tests/exercises")]
    from second_solutions import second_solutions

    from data_generators.classes import simulate_class, write_submissions

    _run(["course", "term", str(term), "--chapters", ASSIGNMENT, "--course-id", "camera"], ROOT)
    _run(["nbgrader", "generate_assignment", ASSIGNMENT], term)
    released = nbformat.read(term / "release" / ASSIGNMENT / f"{ASSIGNMENT}.ipynb", as_version=4)
    everybody = simulate_class(released, CHAPTER, second_solutions(CHAPTER))
    honest = [s for s in everybody if s.student.startswith(HONEST)]
    chosen = enumerate(islice(cycle(honest), number))
    handed_in = [replace(one, student=f"{one.student}-{k}") for k, one in chosen]
    write_submissions(term, ASSIGNMENT, handed_in)
    return released


def _spread(term: Path, number: int) -> Sequence[Path]:
    """Return the notebooks of some of a class, from its beginning to its end."""
    found = sorted(term.glob(f"submitted/*/{ASSIGNMENT}/{ASSIGNMENT}.ipynb"))
    return found[:: max(1, len(found) // number)][:number]


def _ours(pristine: Path, term: Path) -> tuple[float, float]:
    """Return seconds and peak megabytes of grading a class that nobody has graded."""
    shutil.copytree(pristine, term)
    start = time.perf_counter()
    command = [program("course"), "grade", ASSIGNMENT]
    process = subprocess.Popen(
        command, cwd=term, env=clean_environment(), stdout=subprocess.DEVNULL
    )
    with watched(process.pid) as peak:
        if process.wait():
            raise RuntimeError(f"course grade ended with {process.returncode}")
    return time.perf_counter() - start, peak.megabytes


def _stock(pristine: Path, term: Path) -> float:
    shutil.copytree(pristine, term)
    (term / "nbgrader_config.py").write_text(STOCK, encoding="utf-8")
    start = time.perf_counter()
    _run(["nbgrader", "autograde", ASSIGNMENT], term)
    return time.perf_counter() - start


def _otter(archive: Path, student: NotebookNode, submission: Path, folder: Path) -> float:
    """Return the seconds that otter takes for one submission; right answers must be right."""
    notebook = otter.filled_in(student, nbformat.read(submission, as_version=4))
    nbformat.write(notebook, folder / "submission.ipynb")
    start = time.perf_counter()
    otter.grade(archive, folder / "submission.ipynb")
    seconds = time.perf_counter() - start
    tests = json.loads((folder / "results.json").read_text("utf-8"))["tests"]
    share = sum(t.get("score") or 0 for t in tests) / sum(t.get("max_score") or 0 for t in tests)
    who = submission.parents[1].name
    must = 1.0 if who.startswith(("right", "rewritten")) else share
    if share != (0.0 if who.startswith("untouched") else must):
        raise RuntimeError(f"otter gives {who} {share:.0%} of the points")
    return seconds


def _scores(term: Path) -> dict[str, float]:
    from nbgrader.api import Gradebook

    with Gradebook(f"sqlite:///{term}/gradebook.db") as gradebook:
        return {s.student.id: s.score for s in gradebook.assignment_submissions(ASSIGNMENT)}


def _run(command: list[str], folder: Path) -> None:
    whole = [program(command[0]), *command[1:]]
    subprocess.run(whole, cwd=folder, env=clean_environment(), check=True, capture_output=True)
