"""`course demo`: a term from start to end with a simulated class, by the commands one types."""

from __future__ import annotations

import argparse
import shlex
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import nbformat
import numpy as np

from course_lib.exercises import CHAPTERS
from course_lib.grading.export import EXPORTS
from course_lib.grading.report import REPORTS
from data_generators.everyday_class import Member, everyday_class, students_table
from data_generators.everyday_class import write_everyday_class as hand_in

#: The class is the same in every demonstration.
SEED = 2026
DUE = "2026-10-02 12:00:00 UTC"
QUIET = "--log-level=ERROR"
WALLS = "the simulated class does no harm, so here `course demo --isolation none` will do"


def demo(options: argparse.Namespace) -> int:
    """Carry ``course demo`` out; return its exit code."""
    chapter, start = options.chapter, time.monotonic()
    if chapter not in CHAPTERS.values():
        raise ValueError(f"no chapter {chapter!r}; there are {', '.join(CHAPTERS.values())}")
    term = _place(options.directory)
    _run(None, "course", "term", str(term), "--chapters", chapter)
    _run(term, "nbgrader", "generate_assignment", chapter, QUIET)
    _run(term, "nbgrader", "db", "assignment", "add", chapter, "--duedate", DUE, QUIET)
    members = _simulate(term, chapter, options.students)
    _run(term, "nbgrader", "db", "student", "import", "students.csv", QUIET)
    walls = ["--isolation", options.isolation] if options.isolation else []
    _run(term, "course", "grade", chapter, *walls, fine=(0, 1))  # 1: a file cannot be read
    _run(term, "course", "report", chapter)
    _run(term, "course", "export", chapter)
    print(_where_to_look(term, chapter, members))
    made = term if options.directory else term.parent
    print(f"\nAll of this took {time.monotonic() - start:.0f} s. To remove it: rm -r {made}")
    return 0


def _place(directory: Path | None) -> Path:
    """Return where the term is made; `course term` says what is wrong with a place."""
    if directory is not None:
        return directory.expanduser().resolve()
    return Path(tempfile.mkdtemp(prefix="course-demo-")) / "term"


def _run(term: Path | None, *command: str, fine: tuple[int, ...] = (0,)) -> None:
    """Run a command as one would type it, and show it."""
    shown = [word for word in command if word != QUIET]
    print(f"\n$ {shlex.join(shown)}", flush=True)
    program = str(Path(sys.executable).with_name(command[0]))
    if not Path(program).exists():  # installed without a virtual environment
        program = command[0]
    done = subprocess.run([program, *command[1:]], cwd=term, check=False)
    if done.returncode not in fine:
        hint = f"; {WALLS}" if "grade" in command else ""
        raise RuntimeError(f"`{shlex.join(shown)}` ended with exit code {done.returncode}{hint}")


def _simulate(term: Path, chapter: str, size: int) -> list[Member]:
    """Let a class hand in, as if ``nbgrader collect`` had been run."""
    print(f"\n# {size} simulated students hand in", flush=True)
    released = nbformat.read(term / "release" / chapter / f"{chapter}.ipynb", as_version=4)
    module = next(module for module, name in CHAPTERS.items() if name == chapter)
    members = everyday_class(released, module, size, np.random.default_rng(SEED))
    hand_in(term, chapter, members)
    (term / "students.csv").write_text(students_table(members), encoding="utf-8")
    return members


def _where_to_look(term: Path, chapter: str, members: list[Member]) -> str:
    """Return which pages to open, and what is to be seen there."""
    page = term / REPORTS / chapter / "index.html"
    (copy,) = [m for m in members if m.copied_from]
    late = [m.id for m in members if m.is_late]
    broken = [m.id for m in members if m.submission and m.submission.points is None]
    absent = [m.id for m in members if m.submission is None]
    return f"""
Look at:
  {page}
      the class: scores, exercises, what to say in the next lecture, who looks alike
      ({copy.id} copied from {copy.copied_from} and changed all names)
  {page.parent / "students" / f"{members[0].id}.html"}
      what one student gets to read: points and hints, no hidden inputs
  {term / EXPORTS}
      tables for Canvas, Moodle and nbgrader
  {term / "README.md"}
      how to go on: answers in words wait in formgrader (jupyter lab in {term})
Among the students, {", ".join(late)} came late, {", ".join(broken)} handed in a damaged file and
{", ".join(absent)} nothing."""
