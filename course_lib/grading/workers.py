"""Grade many submissions at once on this machine: processes that judge, none of which writes.

A worker that is killed, by the kernel or by a person, costs nothing: what it was at is graded
again by another. Only when that ends a worker again, it is set aside.
"""

from __future__ import annotations

import gc
import os
import signal
import sys
import time
from collections import deque
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from multiprocessing import connection, get_context
from typing import Any

from course_lib.grading.assignment import Assignment
from course_lib.grading.isolation import Isolation
from course_lib.grading.one import Graded, grade_one
from course_lib.grading.outside import Judge
from course_lib.grading.parcels import pack
from course_lib.grading.submissions import fingerprint
from course_lib.sandbox import walls
from course_lib.sandbox.limits import Allowance

#: How often a submission is tried whose grading ended a worker.
TRIES = 2
_CONTEXT = get_context("fork")
SET_ASIDE = "Grading this notebook ended the grader again and again. A person must look at it."


@dataclass(frozen=True)
class Manner:
    """How submissions are graded: behind which walls, and what they may use."""

    isolation: Isolation
    allowance: Allowance


@dataclass
class _Worker:
    process: Any
    line: connection.Connection[Any, Any]
    student: str = ""


def grade_all(
    assignment: Assignment, students: Sequence[str], manner: Manner, workers: int
) -> Iterator[Graded]:
    """Grade submissions, several at a time; yield each as soon as it is done.

    Parameters
    ----------
    assignment : Assignment
        What was asked.
    students : sequence of str
        Whose submissions.
    manner : Manner
        How they are run.
    workers : int
        How many at a time.

    Yields
    ------
    Graded
        In the order in which they are done.
    """
    team = _Team(assignment, manner, students)
    with memory_stays_shared():
        try:
            team.begin(min(workers, len(students)))
            while team.is_busy():
                yield from team.next_done()
        finally:
            team.stop()


@contextmanager
def memory_stays_shared() -> Iterator[None]:
    """Keep the collector from what is there already, here and in processes that are forked.

    It would write to every object, and memory that is written to is no longer shared.
    """
    gc.collect()
    gc.freeze()
    try:
        yield
    finally:
        gc.unfreeze()


class _Team:
    """Workers, what waits for them, and how often each submission was tried."""

    def __init__(self, assignment: Assignment, manner: Manner, students: Sequence[str]) -> None:
        self._assignment, self._manner = assignment, manner
        self._waiting, self._tries = deque(students), dict.fromkeys(students, 0)
        self._workers: list[_Worker] = []
        self._cores: Sequence[int] = ()

    def begin(self, number: int) -> None:
        """Start the workers, each on a core of its own if there are several; give them work."""
        if number > 1 and hasattr(os, "sched_getaffinity"):
            self._cores = sorted(os.sched_getaffinity(0))
        for k in range(number):
            self._workers.append(self._start(k))
        self._give_out()

    def _start(self, number: int) -> _Worker:
        core = self._cores[number % len(self._cores)] if self._cores else None
        return _start(self._assignment, self._manner, number, core)

    def is_busy(self) -> bool:
        """Whether anything is being graded."""
        return any(worker.student for worker in self._workers)

    def next_done(self) -> Iterator[Graded]:
        """Wait for a worker; yield what it has graded, and keep all at work."""
        ready = connection.wait([w.line for w in self._workers if w.student])
        for number, worker in enumerate(self._workers):
            if worker.line not in ready:
                continue
            student, graded = worker.student, _take(worker)
            worker.student = ""
            if graded is None:  # it was killed: go on with a new one
                self._workers[number] = self._start(number)
                graded = self._try_again(student)
            self._give_out()
            if graded is not None:
                yield graded

    def _try_again(self, student: str) -> Graded | None:
        if self._tries[student] < TRIES:
            self._waiting.append(student)
            return None
        return _set_aside(self._assignment, student)

    def _give_out(self) -> None:
        """Give idle workers what waits."""
        for worker in self._workers:
            if not worker.student and self._waiting:
                worker.student = self._waiting.popleft()
                self._tries[worker.student] += 1
                with suppress(OSError):  # if it is gone, waiting for it says so at once
                    worker.line.send(worker.student)

    def stop(self) -> None:
        """End all workers."""
        for worker in self._workers:
            _stop(worker)


def _start(assignment: Assignment, manner: Manner, number: int, core: int | None) -> _Worker:
    mine, its = _CONTEXT.Pipe()
    process = _CONTEXT.Process(
        target=_work, args=(its, mine, assignment, manner, number, core), daemon=True
    )
    process.start()
    its.close()
    return _Worker(process, mine)


def _work(
    line: connection.Connection[Any, Any],
    other_end: connection.Connection[Any, Any],
    assignment: Assignment,
    manner: Manner,
    number: int,
    core: int | None,
) -> None:
    """Grade what comes until nothing more comes, on one core: busy submissions disturb no other."""
    other_end.close()
    if core is not None:
        os.sched_setaffinity(0, {core})
    if sys.platform.startswith("linux"):
        walls.die_with_parent()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the one who asked
    with Judge(manner.isolation, manner.allowance, number) as judge:
        while True:
            try:
                student = line.recv()
            except (EOFError, OSError):
                return
            if not student:
                return
            line.send(grade_one(assignment.notebooks, pack(assignment, student), judge))


def _take(worker: _Worker) -> Graded | None:
    try:
        graded: Graded = worker.line.recv()
    except (EOFError, OSError):
        worker.line.close()
        worker.process.join(5)
        return None
    return graded


def _set_aside(assignment: Assignment, student: str) -> Graded:
    mark = fingerprint(assignment.submitted(student), list(assignment.notebooks))
    return Graded(student, mark, SET_ASIDE)


def _stop(worker: _Worker) -> None:
    with suppress(OSError):
        worker.line.send("")
    worker.line.close()
    deadline = time.monotonic() + 5
    while worker.process.is_alive() and time.monotonic() < deadline:
        worker.process.join(0.05)
    if worker.process.is_alive():
        worker.process.kill()
        worker.process.join()
