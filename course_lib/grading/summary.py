"""What `course grade` says: how far it is while it works, and what came of the class."""

from __future__ import annotations

import statistics
import time
from collections import Counter
from dataclasses import dataclass, field
from typing import Any, TextIO

from course_lib.grading.assignment import Assignment
from course_lib.grading.one import Graded
from course_lib.grading.states import State, state_of
from course_lib.judging.text import format_points

#: On a stream that is no terminal, a line comes so often at most.
QUIET_SECONDS = 15.0


class Progress:
    """A line that says how far it is and how long it takes yet."""

    def __init__(self, total: int, stream: TextIO) -> None:
        self._total, self._done, self._stream = total, 0, stream
        self._start = self._said = time.monotonic()
        self._moves = stream.isatty()

    def step(self, graded: Graded) -> None:
        """Note that one more is done."""
        self._done += 1
        now = time.monotonic()
        left = (now - self._start) / self._done * (self._total - self._done)
        text = f"{self._done} of {self._total} graded, about {_clock(left)} left"
        if self._moves:
            print(f"\r{text}   ", end="", file=self._stream, flush=True)
        elif now - self._said > QUIET_SECONDS and self._done < self._total:
            print(text, file=self._stream, flush=True)
            self._said = now
        if graded.trouble and self._moves:
            print(f"\r{graded.student}: not graded" + " " * 30, file=self._stream)

    def end(self) -> None:
        """Leave the line, and say how long all took."""
        if self._moves and self._done:
            passed = time.monotonic() - self._start
            text = f"{self._done} graded in {_clock(passed)}, {passed / self._done:.2f} s each"
            print(f"\r{text}" + " " * 20, file=self._stream)


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
    states: dict[str, Counter[State]] = field(default_factory=dict)
    misconceptions: dict[str, Counter[str]] = field(default_factory=dict)
    totals: list[float] = field(default_factory=list)
    notes: dict[str, list[str]] = field(default_factory=dict)
    retimed: list[str] = field(default_factory=list)

    def count(self, record: dict[str, Any], new: bool) -> None:
        """Add one submission."""
        student = str(record.get("student", ""))
        if record.get("trouble"):
            self.troubles[student] = str(record["trouble"])
            return
        self.graded += new
        exercises = record.get("exercises", {})
        for name, found in exercises.items():
            self._count_one(name, found)
        if exercises:
            self.totals.append(sum(found["points"] for found in exercises.values()))
        if new and record.get("notes"):
            self.notes[student] = list(record["notes"])

    def _count_one(self, name: str, found: dict[str, Any]) -> None:
        self.points.setdefault(name, []).append(found["points"])
        if "possible" in found:
            self.possible[name] = found["possible"]
        self.states.setdefault(name, Counter())[state_of(found)] += 1
        self.misconceptions.setdefault(name, Counter()).update(found.get("misconceptions", ()))

    def text(self, assignment: Assignment) -> str:
        """Return the summary as a table and sentences."""
        before = f", {self.skipped} were graded before" if self.skipped else ""
        lines = [f"{assignment.name}: {self.graded} graded{before}."]
        if self.points:
            lines += ["", *self._table()]
        elif self.graded:
            lines += ["", "Its answers are read by a person: see formgrader, Manual Grading."]
        if self.totals:
            middle, possible = statistics.median(self.totals), sum(self.possible.values())
            of = format_points(possible)
            lines += ["", f"Half of the class has {format_points(middle)} of {of} points or more."]
        if self.retimed:
            who = ", ".join(self.retimed)
            lines += ["", f"Handed in again, unchanged, so that only the new time counts: {who}."]
        if self.notes:
            lines += ["", "Worth knowing:"]
            lines += [f"  {who}: {'; '.join(notes)}" for who, notes in sorted(self.notes.items())]
        if self.troubles:
            lines += ["", "Not graded; tell them:"]
            lines += [f"  {who}: {why}" for who, why in sorted(self.troubles.items())]
        return "\n".join(lines)

    def _table(self) -> list[str]:
        width = max(len(name) for name in self.points)
        head = f"{'exercise':{width}}   mean   full  error  not tried  most common misconception"
        return [head, *(self._row(name, width) for name in self.points)]

    def _row(self, name: str, width: int) -> str:
        points, possible, states = (
            self.points[name],
            self.possible.get(name, 0.0),
            self.states[name],
        )
        mean = f"{statistics.fmean(points):.1f}/{format_points(possible)}"
        full = states["full points"] / len(points)
        untried = states["not tried"] + states["not reached"]
        common = self.misconceptions[name].most_common(1)
        said = f"{common[0][0].replace('_', ' ')} ({common[0][1]})" if common else ""
        row = f"{name:{width}} {mean:>7} {full:5.0%}  {states['error']:5}  {untried:9}  {said}"
        return row.rstrip()
