"""`course grade`: grade what was handed in for an assignment, behind walls, and sum up."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from course_lib.grading.assignment import RECORDS, Assignment, read_assignment
from course_lib.grading.cluster import grade_on_cluster
from course_lib.grading.explaining import explain_isolation
from course_lib.grading.gradebooks import only_writer
from course_lib.grading.isolation import Isolation, demand
from course_lib.grading.one import Graded
from course_lib.grading.recording import is_graded, read_record, recording
from course_lib.grading.summary import Progress, Summary
from course_lib.grading.workers import Manner, grade_all
from course_lib.sandbox.limits import allowance_for


def grade(options: argparse.Namespace) -> int:
    """Carry ``course grade`` out; return its exit code."""
    if options.explain_isolation:
        print(explain_isolation())
        return 0
    if not options.assignment:
        raise ValueError("name an assignment, e.g. course grade 01_pinhole")
    assignment = read_assignment(options.term, options.assignment)
    isolation: Isolation = options.isolation or assignment.isolation  # type: ignore[assignment]
    manner = Manner(isolation, allowance_for(assignment.cell_seconds))
    if not options.scheduler:  # the workers of a cluster look for themselves
        demand(manner.isolation)
    if manner.isolation == "none":
        print("Nothing is isolated: students' code runs with your rights.", file=sys.stderr)
    with _alone(assignment):
        todo, done = _choose(assignment, options.student, options.force)
        summary = _grade(assignment, todo, done, manner, options)
    summary.skipped = len(done)
    for student in done:
        summary.count(read_record(assignment, student), new=False)
    print(summary.text(assignment))
    return 1 if summary.troubles else 0


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


def _grade(
    assignment: Assignment,
    todo: list[str],
    done: list[str],
    manner: Manner,
    options: argparse.Namespace,
) -> Summary:
    summary, progress = Summary(), Progress(len(todo), sys.stderr)
    with recording(assignment) as recorder:
        summary.retimed = [student for student in done if recorder.note_time(student)]
        for graded in _graded(assignment, todo, manner, options):
            saved = recorder.save(graded)
            summary.count(vars(saved), new=True)
            progress.step(saved)
    progress.end()
    return summary


def _graded(
    assignment: Assignment, todo: list[str], manner: Manner, options: argparse.Namespace
) -> Iterator[Graded]:
    """Grade here, or on a cluster."""
    if options.scheduler:
        return grade_on_cluster(assignment, todo, manner, options.scheduler, options.workers)
    return grade_all(assignment, todo, manner, options.workers or os.cpu_count() or 1)


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
        with only_writer(assignment.db_url):
            yield
