"""`course report`: pages on a class and on each student, in the term's directory only."""

from __future__ import annotations

import argparse
import json
import shutil
from collections.abc import Mapping
from datetime import datetime
from pathlib import Path
from typing import Any

from course_lib.exercises import find
from course_lib.grading.alike import AlikePair, find_alike
from course_lib.grading.assignment import Assignment
from course_lib.grading.class_page import class_page
from course_lib.grading.standings import Standings, read_classes
from course_lib.grading.student_page import student_page
from course_lib.judging import ValuesExercise

#: Where reports are, in a term's directory.
REPORTS = "report"


def report(options: argparse.Namespace) -> int:
    """Carry ``course report`` out; return its exit code."""
    written = 0
    for standings in read_classes(options.term, options.assignments):
        name = standings.assignment.name
        if not any(student.handed_in for student in standings.students):
            print(f"{name}: nothing was handed in.")
            continue
        page = write_report(standings)
        written += 1
        print(f"{name}: {page} and {len(standings.graded)} pages of students in students/.")
    return 0 if written else 1


def write_report(standings: Standings) -> Path:
    """Write the pages on an assignment; those of an earlier report go.

    Parameters
    ----------
    standings : Standings
        What the class has.

    Returns
    -------
    pathlib.Path
        The page on the class.
    """
    assignment = standings.assignment
    final = assignment.term / REPORTS / assignment.name
    draft = final.with_name(f".{final.name}.part")
    shutil.rmtree(draft, ignore_errors=True)
    (draft / "students").mkdir(parents=True)
    cells = {s.student: graded_cells(assignment, s.student) for s in standings.graded}
    pairs, others = compare(standings, cells)
    when = f"{datetime.now().astimezone():%Y-%m-%d %H:%M}"
    page = class_page(standings, pairs, others, when)
    (draft / "index.html").write_text(page, encoding="utf-8")
    for student in standings.graded:
        own = student_page(standings, student, cells[student.student])
        (draft / "students" / f"{student.student}.html").write_text(own, encoding="utf-8")
    shutil.rmtree(final, ignore_errors=True)
    draft.rename(final)
    return final / "index.html"


def graded_cells(assignment: Assignment, student: str) -> dict[str, Any]:
    """Return the labelled cells of a student's graded notebooks, as the files have them.

    Parameters
    ----------
    assignment : Assignment
        Which.
    student : str
        Whose.

    Returns
    -------
    dict of str to dict
        By label; none of a notebook that is not there.
    """
    found = {}
    for name in assignment.notebooks:
        path = assignment.autograded(student) / f"{name}.ipynb"
        if path.is_file():
            for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
                if label := cell.get("metadata", {}).get("nbgrader", {}).get("grade_id"):
                    found[label] = cell
    return found


def compare(
    standings: Standings, cells: Mapping[str, Mapping[str, Any]]
) -> tuple[list[AlikePair], float]:
    """Compare the answers of all students; numbers worked out from given data must be alike."""
    items = [item for item in standings.items if not _has_one_answer(item.name)]
    notebooks = standings.assignment.notebooks
    given = {item.answer: notebooks[item.notebook].cells[item.answer].source for item in items}
    answers = {
        student: {label: "".join(own[label]["source"]) for label in given if label in own}
        for student, own in cells.items()
    }
    return find_alike(given, answers, prose=[item.answer for item in items if item.by_hand])


def _has_one_answer(name: str) -> bool:
    try:
        return isinstance(find(name), ValuesExercise)
    except ValueError:  # a cell of the instructor's own
        return False
