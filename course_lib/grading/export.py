"""`course export`: points as Canvas, Moodle and nbgrader read them."""

from __future__ import annotations

import argparse
import csv
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from course_lib.grading.roster import Matched, Roster, match, read_roster
from course_lib.grading.standings import UNREAD, Standing, Standings, read_classes
from course_lib.judging.text import format_points

#: Where tables are, in a term's directory.
EXPORTS = "export"
CANVAS = ("Student", "ID", "SIS User ID", "SIS Login ID", "Section")
MOODLE = ("Username", "First name", "Last name", "Email address")
NBGRADER = (
    "assignment", "duedate", "timestamp", "student_id", "last_name", "first_name", "email",
    "raw_score", "late_submission_penalty", "score", "max_score",
)  # fmt: skip
#: What makes a spreadsheet calculate instead of showing a text.
FORMULA = ("=", "+", "-", "@", "\t", "\r")
DECIMAL = re.compile(r"\d+(\.\d*)?")
NUMBER = re.compile(r"-?\d*[.,]?\d*%?")
Row = Sequence[Any]


@dataclass(frozen=True)
class Points:
    """Points of all students in some assignments.

    Attributes
    ----------
    classes : tuple of Standings
        By assignment.
    missing : float or None
        What who handed nothing in gets, where others did; None leaves the cell empty.
    """

    classes: tuple[Standings, ...]
    missing: float | None = None

    @property
    def students(self) -> list[Standing]:
        """Everybody, once."""
        everybody = {s.student: s for standings in self.classes for s in standings.students}
        return [everybody[name] for name in sorted(everybody)]

    def of(self, student: Standing, standings: Standings) -> float | None:
        """Return a student's points in an assignment, penalty taken off; None if there are none."""
        own = next((s for s in standings.students if s.student == student.student), None)
        if own is None or not (own.handed_in or own.is_graded):
            return self.missing_in(standings)
        return own.score if own.has_points else None

    def missing_in(self, standings: Standings) -> float | None:
        """Return what who handed nothing in gets; before anybody did, students may not have it."""
        return self.missing if any(s.handed_in or s.is_graded for s in standings.students) else None

    def cells(self, student: Standing, standings: Iterable[Standings]) -> list[str]:
        """Return a student's points as they are written."""
        points = (self.of(student, one) for one in standings)
        return ["" if value is None else format_points(value) for value in points]


def export(options: argparse.Namespace) -> int:
    """Carry ``course export`` out; return its exit code."""
    classes = tuple(read_classes(options.term, options.assignments))
    points = Points(classes, options.missing)
    folder = classes[0].assignment.term / EXPORTS
    folder.mkdir(exist_ok=True)
    if options.roster:
        lost = _for_roster(points, read_roster(options.roster), options.roster, folder)
    else:
        lost = 0
        _write(folder / "canvas.csv", canvas_table(points))
        _write(folder / "moodle.csv", moodle_table(points))
        _write(folder / "nbgrader.csv", nbgrader_table(points))
    for line in remarks(points):
        print(line)
    return 1 if lost else 0


def _for_roster(points: Points, roster: Roster, path: Path, folder: Path) -> int:
    """Write the table for a class list; say who is in one of both only, and return how many."""
    matched = match(roster, points.students)
    if roster.kind == "canvas":
        _write(folder / "canvas.csv", canvas_table(points, roster, matched))
    elif roster.kind == "moodle":
        _write(folder / "moodle.csv", moodle_table(points, roster, matched))
    else:
        _write(folder / "moodle.csv", worksheet_table(points, roster, matched))
    if matched.missing:
        names = _names(matched.missing)
        print(f"Not found in {path}, or not for certain, and so not written: {names}.")
    alone = [row for k, row in enumerate(roster.rows) if k not in matched.students]
    if alone:
        names = ", ".join(roster.name_of(row) for row in alone)
        print(f"In {path}, but not in the gradebook: {names}.")
    return len(matched.missing)


def remarks(points: Points) -> list[str]:
    """Return what one should know of the points before they go anywhere."""
    return [
        line
        for standings in points.classes
        for line in _remarks(standings, points.missing_in(standings))
    ]


def _remarks(standings: Standings, missing: float | None) -> Iterator[str]:
    name, graded = standings.assignment.name, standings.graded
    others = [s for s in standings.students if not s.is_graded]
    waiting = [s for s in graded if s.waiting and s.has_points]
    old = "the newest version cannot be graded, so the points are those of an earlier one"
    value = "empty" if missing is None else format_points(missing)
    for who, said in (
        ([s for s in others if s.handed_in], "not graded, so the cell is empty"),
        ([s for s in graded if not s.has_points], "not read yet, so the cell is empty"),
        ([s for s in graded if s.trouble], old),
        ([s for s in others if not s.handed_in], f"nothing handed in, so the cell is {value}"),
    ):
        if who:
            names = _names(who) if len(who) < len(standings.students) else "everybody"
            yield f"{name}: {said}: {names}."
    if waiting:
        share = f"{len(waiting)} of {len(graded)} students"
        yield f"{name}: {share} have answers that wait for a person; {UNREAD}."
    if late := [s for s in graded if s.penalty]:
        yield f"{name}: points were taken off for being late: {_names(late)}."


def canvas_table(
    points: Points, roster: Roster | None = None, matched: Matched | None = None
) -> list[Row]:
    """Return the table that Canvas imports into its gradebook.

    Parameters
    ----------
    points : Points
        Who has how many.
    roster, matched : Roster and Matched, optional
        Canvas's own export. Without it, nbgrader's id is taken for the login.

    Returns
    -------
    list of sequence
        The header, the line with the points of a full submission, the students. A column of an
        assignment that Canvas has is named as there, with its number.
    """
    titles = [_title(one.assignment.name, roster) for one in points.classes]
    possible = [format_points(one.possible) for one in points.classes]
    table: list[Row] = [[*CANVAS, *titles], ["    Points Possible", "", "", "", "", *possible]]
    if roster is None or matched is None:
        for s in points.students:
            name = ", ".join(part for part in (s.last_name, s.first_name) if part)
            table.append(
                [name or s.student, "", "", s.student, "", *points.cells(s, points.classes)]
            )
        return table
    for number, row in enumerate(roster.rows):
        if student := matched.students.get(number):
            known = [row.get(column, "") for column in CANVAS]
            table.append([*known, *points.cells(student, points.classes)])
    return table


def _title(name: str, roster: Roster | None) -> str:
    """Return the name of an assignment's column: Canvas's own, if it has one."""
    named = re.compile(rf"{re.escape(name)}( \(\d+\))?")
    return next((c for c in (roster.header if roster else ()) if named.fullmatch(c)), name)


def moodle_table(
    points: Points, roster: Roster | None = None, matched: Matched | None = None
) -> list[Row]:
    """Return a table for Moodle's import of grades: who, and a column for each assignment."""
    names = [one.assignment.name for one in points.classes]
    table: list[Row] = [[*MOODLE, *names]]
    if roster is None or matched is None:
        for s in points.students:
            known = [s.student, s.first_name, s.last_name, s.email]
            table.append([*known, *points.cells(s, points.classes)])
        return table
    columns = [c for c in (*MOODLE, "ID number") if c in roster.header]
    table = [[*columns, *names]]
    for number, student in sorted(matched.students.items()):
        known = [roster.rows[number].get(column, "") for column in columns]
        table.append([*known, *points.cells(student, points.classes)])
    return table


def worksheet_table(points: Points, roster: Roster, matched: Matched) -> list[Row]:
    """Return Moodle's grading worksheet of one assignment with its column Grade filled in.

    Raises
    ------
    ValueError
        If there are points of several assignments, or Moodle counts to another number: what is
        given there in one scale must not be read in another.
    """
    if len(points.classes) != 1:
        raise ValueError("a grading worksheet is of one assignment: name it, as 01_pinhole")
    (standings,) = points.classes
    table: list[Row] = [list(roster.header)]
    for number, row in enumerate(roster.rows):
        most = row.get("Maximum Grade", "").replace(",", ".")
        if DECIMAL.fullmatch(most) and abs(float(most) - standings.possible) > 1e-6:
            raise ValueError(
                f"in Moodle the assignment has {format_points(float(most))} points, here "
                f"{format_points(standings.possible)}: change its maximum grade in Moodle, and "
                "download the worksheet again"
            )
        student = matched.students.get(number)
        grade = points.cells(student, [standings])[0] if student else ""
        cells = {**row, "Grade": grade or row.get("Grade", "")}
        table.append([cells.get(column, "") for column in roster.header])
    return table


def nbgrader_table(points: Points) -> list[Row]:
    """Return the table of ``nbgrader export``, in which here a name with a comma stays one cell."""
    table: list[Row] = [NBGRADER]
    for standings in points.classes:
        for s in standings.students:
            raw = s.score_without_penalty
            end = [raw, s.penalty, s.score, standings.possible]
            who = [s.student, s.last_name, s.first_name, s.email]
            due = standings.due
            table.append([standings.assignment.name, due, s.timestamp, *who, *end])
    return table


def _write(path: Path, table: Iterable[Row]) -> None:
    """Write a table in which no cell is taken for a formula."""
    rows = [[safe(cell) for cell in row] for row in table]
    with path.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows(rows)
    print(f"wrote {path}")


def safe(cell: Any) -> Any:
    """Return a cell that a spreadsheet shows and does not carry out.

    Parameters
    ----------
    cell : object
        A number or a text.

    Returns
    -------
    object
        The same; a text that would be a formula with an apostrophe before it, as OWASP advises.
    """
    if not isinstance(cell, str) or NUMBER.fullmatch(cell):
        return cell
    return f"'{cell}" if cell.startswith(FORMULA) else cell


def _names(students: Iterable[Standing]) -> str:
    return ", ".join(s.student for s in students)
