"""`course grade`: grade what was handed in for an assignment, behind walls, and sum up."""

from __future__ import annotations

import argparse
import os
import statistics
import sys
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any, TextIO

from course_lib.grading.assignment import RECORDS, Assignment, read_assignment
from course_lib.grading.explaining import explain_isolation
from course_lib.grading.isolation import Isolation, demand
from course_lib.grading.one import Graded
from course_lib.grading.recording import Recorder, is_graded, read_record
from course_lib.grading.workers import Manner, grade_all
from course_lib.judging.text import format_points
from course_lib.sandbox.limits import Allowance


def grade(options: argparse.Namespace) -> int:
    """Carry ``course grade`` out; return its exit code."""
    if options.explain_isolation:
        print(explain_isolation())
        return 0
    if not options.assignment:
        raise ValueError("name an assignment, e.g. course grade 01_pinhole")
    assignment = read_assignment(options.term, options.assignment)
    isolation: Isolation = options.isolation or assignment.isolation  # type: ignore[assignment]
    manner = Manner(isolation, _allowance(assignment))
    demand(manner.isolation)
    if manner.isolation == "none":
        print("Nothing is isolated: students' code runs with your rights.", file=sys.stderr)
    with _alone(assignment):
        todo, done = _choose(assignment, options.student, options.force)
        workers = max(1, options.workers or os.cpu_count() or 1)
        summary = _grade(assignment, todo, manner, workers)
    summary.skipped = len(done)
    for student in done:
        summary.count(read_record(assignment, student), new=False)
    print(summary.text(assignment))
    return 1 if summary.troubles else 0


def _allowance(assignment: Assignment) -> Allowance:
    return Allowance(cell_seconds=assignment.cell_seconds)


def _choose(
    assignment: Assignment, wanted: Sequence[str], force: bool
) -> tuple[list[str], list[str]]:
    """Return whose submissions are to be graded, and whose were already."""
    students = assignment.students()
    unknown = sorted(set(wanted) - set(students))
    if unknown:
        raise ValueError(f"nothing was handed in for {assignment.name} by {', '.join(unknown)}")
    chosen = list(wanted) or students
    if not chosen:
        raise ValueError(
            f"nothing was handed in for {assignment.name}: there is no "
            f"{assignment.submitted('STUDENT')}. Run nbgrader collect {assignment.name} first"
        )
    todo = [name for name in chosen if force or not is_graded(assignment, name)]
    return todo, [name for name in chosen if name not in set(todo)]


def _grade(assignment: Assignment, todo: list[str], manner: Manner, workers: int) -> Summary:
    summary, progress = Summary(), Progress(len(todo), sys.stderr)
    with Recorder(assignment) as recorder:
        for graded in grade_all(assignment, todo, manner, workers):
            recorder.save(graded)
            summary.count(vars(graded), new=True)
            progress.step(graded)
    progress.end()
    return summary


@contextmanager
def _alone(assignment: Assignment) -> Iterator[None]:
    """Make sure that nobody else grades this term: there is one writer."""
    import fcntl  # which Windows has not

    folder = assignment.term / RECORDS
    folder.mkdir(exist_ok=True)
    with (folder / ".lock").open("w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise RuntimeError("another `course grade` is at work in this term") from None
        yield


class Progress:
    """A line that says how far it is and how long it takes yet."""

    def __init__(self, total: int, stream: TextIO) -> None:
        self._total, self._done, self._stream = total, 0, stream
        self._start, self._moves = time.monotonic(), stream.isatty()

    def step(self, graded: Graded) -> None:
        """Note that one more is done."""
        self._done += 1
        passed = time.monotonic() - self._start
        left = passed / self._done * (self._total - self._done)
        text = f"{self._done} of {self._total} graded, about {_clock(left)} left"
        if self._moves:
            print(f"\r{text}   ", end="", file=self._stream, flush=True)
        elif self._done % 25 == 0 and self._done < self._total:
            print(text, file=self._stream, flush=True)
        if graded.trouble and self._moves:
            print(f"\r{graded.student}: not graded" + " " * 30, file=self._stream)

    def end(self) -> None:
        """Leave the line."""
        if self._moves and self._done:
            print(file=self._stream)


def _clock(seconds: float) -> str:
    minutes, rest = divmod(round(seconds), 60)
    return f"{minutes}:{rest:02d} min"


@dataclass
class Summary:
    """What came of all submissions, exercise by exercise."""

    graded: int = 0
    skipped: int = 0
    troubles: dict[str, str] = field(default_factory=dict)
    points: dict[str, list[float]] = field(default_factory=dict)
    possible: dict[str, float] = field(default_factory=dict)
    misconceptions: dict[str, Counter[str]] = field(default_factory=dict)
    totals: list[float] = field(default_factory=list)
    notes: dict[str, list[str]] = field(default_factory=dict)

    def count(self, record: dict[str, Any], new: bool) -> None:
        """Add one submission."""
        student = str(record.get("student", ""))
        if record.get("trouble"):
            self.troubles[student] = str(record["trouble"])
            return
        self.graded += new
        exercises = record.get("exercises", {})
        for name, found in exercises.items():
            self.points.setdefault(name, []).append(found["points"])
            if "possible" in found:
                self.possible[name] = found["possible"]
            self.misconceptions.setdefault(name, Counter()).update(found.get("misconceptions", ()))
        if exercises:
            self.totals.append(sum(found["points"] for found in exercises.values()))
        if new and record.get("notes"):
            self.notes[student] = list(record["notes"])

    def text(self, assignment: Assignment) -> str:
        """Return the summary as a table and sentences."""
        before = f", {self.skipped} were graded before" if self.skipped else ""
        lines = [f"{assignment.name}: {self.graded} graded{before}."]
        if self.points:
            lines += ["", *self._table()]
        if self.totals:
            middle, possible = statistics.median(self.totals), sum(self.possible.values())
            of = format_points(possible)
            lines += ["", f"Half of the class has {format_points(middle)} of {of} points or more."]
        if self.notes:
            lines += ["", "Worth knowing:"]
            lines += [f"  {who}: {'; '.join(notes)}" for who, notes in sorted(self.notes.items())]
        if self.troubles:
            lines += ["", "Not graded; tell them:"]
            lines += [f"  {who}: {why}" for who, why in sorted(self.troubles.items())]
        return "\n".join(lines)

    def _table(self) -> list[str]:
        width = max(len(name) for name in self.points)
        head = f"{'exercise':{width}}   mean   full  most common misconception"
        return [head, *(self._row(name, width) for name in self.points)]

    def _row(self, name: str, width: int) -> str:
        points, possible = self.points[name], self.possible.get(name, 0.0)
        mean = f"{statistics.fmean(points):.1f}/{format_points(possible)}"
        full = sum(p >= possible for p in points) / len(points) if possible else 0.0
        common = self.misconceptions[name].most_common(1)
        said = f"{common[0][0].replace('_', ' ')} ({common[0][1]})" if common else ""
        return f"{name:{width}} {mean:>7} {full:5.0%}  {said}".rstrip()
