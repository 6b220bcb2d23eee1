"""A class list that Canvas or Moodle wrote, and whose line in it is whose."""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from course_lib.grading.standings import Standing

Kind = Literal["canvas", "moodle worksheet", "moodle"]
#: Columns that tell who somebody is. Canvas's are in its lib/gradebook_exporter.rb; Moodle's in the
#: grading worksheet of an assignment, and in the export of grades.
KEYS: Mapping[Kind, tuple[str, ...]] = {
    "canvas": ("ID", "SIS User ID", "SIS Login ID", "Integration ID"),
    "moodle worksheet": ("Identifier", "Email address", "Username", "ID number"),
    "moodle": ("Email address", "Username", "ID number"),
}
NAMES: Mapping[Kind, tuple[str, ...]] = {
    "canvas": ("Student",),
    "moodle worksheet": ("Full name",),
    "moodle": ("First name", "Last name"),
}
#: Before the number in Moodle's worksheet.
PARTICIPANT = "participant "


@dataclass(frozen=True)
class Roster:
    """A class list.

    Attributes
    ----------
    kind : str
        Which program wrote it, and for what.
    header : tuple of str
        Its columns.
    rows : tuple of mapping of str to str
        The students.
    """

    kind: Kind
    header: tuple[str, ...]
    rows: tuple[Mapping[str, str], ...]

    def name_of(self, row: Mapping[str, str]) -> str:
        """Return a student's name as the list has it."""
        return " ".join(row.get(column, "") for column in NAMES[self.kind]).strip()


@dataclass(frozen=True)
class Matched:
    """Whose line is whose: by the line's number, and who has none or more than one."""

    students: Mapping[int, Standing]
    missing: tuple[Standing, ...]


def read_roster(path: Path) -> Roster:
    """Read a class list.

    Parameters
    ----------
    path : pathlib.Path
        A CSV file: Canvas's export of its gradebook, Moodle's grading worksheet of an assignment,
        or Moodle's export of grades or participants.

    Returns
    -------
    Roster
        Its students.

    Raises
    ------
    ValueError
        If it is none of these.
    """
    try:
        text = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise ValueError(f"{path} is no text in UTF-8; export it again as CSV") from None
    first = text.partition("\n")[0]
    separator = max(",;\t", key=first.count)
    try:
        lines = [line for line in csv.reader(io.StringIO(text), delimiter=separator) if any(line)]
    except csv.Error as error:  # e.g. a quotation mark that opens and never closes
        raise ValueError(f"{path} cannot be read as CSV ({error}); export it again") from None
    header = tuple(cell.strip() for cell in lines[0]) if lines else ()
    kind = _kind(header)
    if kind is None:
        raise ValueError(
            f"{path} begins with {first[:80]!r}, and so is neither Canvas's export of its "
            "gradebook (Student, ID, Section), nor Moodle's grading worksheet (Identifier, Grade) "
            "or list of grades (Email address or Username), in English"
        )
    rows = [dict(zip(header, line, strict=False)) for line in lines[1:]]
    return Roster(kind, header, tuple(row for row in rows if _is_student(kind, row)))


def _kind(header: Sequence[str]) -> Kind | None:
    columns = set(header)
    if {"Student", "ID", "Section"} <= columns:
        return "canvas"
    if {"Identifier", "Grade"} <= columns:
        return "moodle worksheet"
    return "moodle" if columns & {"Email address", "Username"} else None


def _is_student(kind: Kind, row: Mapping[str, str]) -> bool:
    """Whether a line is a student: Canvas has lines for points and for what is hidden."""
    if kind != "canvas":
        return True
    name = row.get("Student", "").strip()
    return bool(name) and not name.startswith("Points Possible") and name != "Student, Test"


def match(roster: Roster, students: Iterable[Standing]) -> Matched:
    """Find each student's line in a class list.

    Parameters
    ----------
    roster : Roster
        The list.
    students : iterable of Standing
        Who is looked for: by id, address or the id of the learning platform in any column that
        tells who somebody is; else by a name that occurs once.

    Returns
    -------
    Matched
        A line that would be two students', and a student who would have two lines, are left out.
    """
    by_key: dict[str, set[int]] = {}
    for number, row in enumerate(roster.rows):
        for column in KEYS[roster.kind]:
            for key in _spellings(row.get(column, "")):
                by_key.setdefault(key, set()).add(number)
    by_name: dict[str, set[int]] = {}
    for number, row in enumerate(roster.rows):
        by_name.setdefault(_plain(roster.name_of(row)), set()).add(number)
    found: dict[str, int] = {}
    wanted = list(students)
    namesakes = Counter(_plain(student.full_name) for student in wanted)
    for student in wanted:
        keys = [student.student, student.email, student.lms_id]
        lines = set().union(*(by_key.get(key.strip().casefold(), set()) for key in keys if key))
        name = _plain(student.full_name)
        if not lines and namesakes[name] == 1:
            lines = by_name.get(name, set())
        if len(lines) == 1:
            found[student.student] = min(lines)
    often = Counter(found.values())
    own = {s.student: s for s in wanted if often.get(found.get(s.student, -1)) == 1}
    missing = tuple(student for student in wanted if student.student not in own)
    return Matched({found[name]: student for name, student in own.items()}, missing)


def _spellings(value: str) -> set[str]:
    """Return the ways in which a folder may be named after a cell of the list."""
    text = value.strip().casefold()
    return {s for s in (text, text.partition("@")[0], text.removeprefix(PARTICIPANT)) if s}


def _plain(name: str) -> str:
    """Return a name's words in order, whether it is written "First Last" or "Last, First"."""
    return " ".join(sorted(name.replace(",", " ").casefold().split()))
