"""Where a class stands in an assignment: what the gradebook and the records hold, read once."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from course_lib.authoring.expansion import check_id, grade_id
from course_lib.exercises import all_exercises
from course_lib.grading.assignment import Assignment, read_assignment
from course_lib.grading.gradebooks import open_gradebook
from course_lib.grading.recording import read_record
from course_lib.judging import Explain

#: What answers count that wait for a person.
UNREAD = "until then they count 0, or what they had before they changed"


@dataclass(frozen=True)
class Item:
    """Something that gives points.

    Attributes
    ----------
    name : str
        The exercise, e.g. ``"pinhole.dolly_zoom"``; for a cell of another kind, its label.
    notebook, check, answer : str
        Where the points are entered, and the label of the cell with the answer.
    possible : float
        Points of a full answer.
    by_hand : bool
        Whether a person gives them.
    """

    name: str
    notebook: str
    check: str
    answer: str
    possible: float
    by_hand: bool

    @property
    def short_name(self) -> str:
        """The name without its chapter."""
        return self.name.rpartition(".")[2]


@dataclass(frozen=True)
class Standing:
    """What one student has.

    Attributes
    ----------
    student, first_name, last_name, email, lms_id : str
        As the gradebook names them.
    points : mapping of str to float or None
        By item; None where a person must give them first. Empty if nothing was graded.
    waiting : tuple of str
        Items at which a person must look.
    penalty : float
        Points lost for being late.
    seconds_late : float
        How late.
    timestamp : str
        When it was handed in, as nbgrader writes it.
    comments : mapping of str to str
        What a person wrote, by label.
    handed_in : bool
        Whether there is a submission.
    record : mapping
        What `course grade` noted of it; empty if nbgrader's own command graded it.
    """

    student: str
    first_name: str = ""
    last_name: str = ""
    email: str = ""
    lms_id: str = ""
    points: Mapping[str, float | None] = field(default_factory=dict)
    waiting: tuple[str, ...] = ()
    penalty: float = 0.0
    seconds_late: float = 0.0
    timestamp: str = ""
    comments: Mapping[str, str] = field(default_factory=dict)
    handed_in: bool = False
    record: Mapping[str, Any] = field(default_factory=dict)

    @property
    def is_graded(self) -> bool:
        """Whether this version of the submission or one before was graded, but for words."""
        return bool(self.points)

    @property
    def has_points(self) -> bool:
        """Whether anything has points yet; with words only, that takes a person."""
        return any(points is not None for points in self.points.values())

    @property
    def trouble(self) -> str:
        """Why the newest version could not be graded; empty if it was."""
        return str(self.record.get("trouble", ""))

    @property
    def score(self) -> float:
        """Points of all items without the penalty, as nbgrader counts them: never below 0."""
        return max(0.0, self.score_without_penalty - self.penalty)

    @property
    def score_without_penalty(self) -> float:
        """Points of all items."""
        return sum(p or 0.0 for p in self.points.values())

    @property
    def full_name(self) -> str:
        """First and family name, or the id if there are none."""
        return " ".join(part for part in (self.first_name, self.last_name) if part) or self.student


@dataclass(frozen=True)
class Standings:
    """What a class has in an assignment, and when that was due."""

    assignment: Assignment
    items: tuple[Item, ...]
    students: tuple[Standing, ...]
    due: str = ""

    @property
    def possible(self) -> float:
        """Points of a full submission."""
        return sum(item.possible for item in self.items)

    @property
    def graded(self) -> list[Standing]:
        """Those whose submission was graded; see `Standing.is_graded`."""
        return [student for student in self.students if student.is_graded]


def read_standings(assignment: Assignment) -> Standings:
    """Read what a class has in an assignment.

    Parameters
    ----------
    assignment : Assignment
        From `read_assignment`.

    Returns
    -------
    Standings
        All students of the gradebook, and all who handed in.
    """
    with open_gradebook(assignment.db_url, assignment.course_id) as gradebook:
        entry = gradebook.find_assignment(assignment.name)
        items, due = _items(entry, assignment), str(entry.duedate or "")
        found = gradebook.assignment_submissions(assignment.name)
        submissions = {s.student_id: s for s in found}
        people = {person.id: person for person in gradebook.students}
        names = sorted({*people, *submissions, *assignment.students()})
        students = [
            _standing(name, people.get(name), submissions.get(name), items, assignment)
            for name in names
        ]
    return Standings(assignment, items, tuple(students), due)


def read_classes(term: Path, names: Sequence[str] = ()) -> Iterator[Standings]:
    """Read what a class has in some assignments of a term, or in all that students were given.

    Parameters
    ----------
    term : pathlib.Path
        Made by `course term`.
    names : sequence of str, optional
        Which assignments.

    Yields
    ------
    Standings
        One after the other.

    Raises
    ------
    ValueError
        If there is no term, no assignment in it, or not the one that is named.
    """
    release = term.expanduser() / "release"
    folders = release.iterdir() if release.is_dir() else ()
    given = sorted(path.name for path in folders if path.is_dir() and path.name[0] != ".")
    if not (names or given):
        raise ValueError(f"there is no assignment in {release.resolve()}")
    for name in names or given:
        yield read_standings(read_assignment(term, name))


def _items(found: Any, assignment: Assignment) -> tuple[Item, ...]:
    """Return what gives points, in the order of the notebooks."""
    by_check = {check_id(exercise.name): exercise.name for exercise in all_exercises()}
    by_hand = {grade_id(e.name): e.name for e in all_exercises() if isinstance(e, Explain)}
    items = []
    for notebook in found.notebooks:
        cells = {cell.name: cell for cell in notebook.grade_cells}
        answers = {cell.name for cell in notebook.solution_cells}
        for label in assignment.notebooks[notebook.name].cells:
            if label in cells:
                name = by_check.get(label) or by_hand.get(label) or label
                answer = grade_id(name) if label in by_check else label
                points = cells[label].max_score
                items.append(Item(name, notebook.name, label, answer, points, label in answers))
    return tuple(items)


def _standing(
    name: str, person: Any, submission: Any, items: tuple[Item, ...], assignment: Assignment
) -> Standing:
    start = replace(_named(name, person), record=read_record(assignment, name))
    if submission is None:
        return replace(start, handed_in=assignment.submitted(name).is_dir())
    grades = {(n.name, g.name): g for n in submission.notebooks for g in n.grades}
    mine = [(item, grades[key]) for item in items if (key := (item.notebook, item.check)) in grades]
    automatic = [grade for item, grade in mine if not item.by_hand]
    done = any(_given(grade) is not None for grade in automatic or [g for _, g in mine])
    if not automatic:  # words only: they have no points before a person reads them
        done = done or assignment.autograded(name).is_dir()
    return replace(
        start,
        points={item.name: _given(grade) for item, grade in mine} if done else {},
        waiting=tuple(i.name for i, g in mine if done and g.needs_manual_grade),
        penalty=float(submission.late_submission_penalty or 0.0),
        seconds_late=float(submission.total_seconds_late),
        timestamp=str(submission.timestamp or ""),
        comments=_comments(submission),
        handed_in=True,
    )


def _named(name: str, person: Any) -> Standing:
    """Return what the gradebook knows of a person; a folder without an entry has its name only."""
    if person is None:
        return Standing(name)
    first, last, email = person.first_name or "", person.last_name or "", person.email or ""
    return Standing(name, first, last, email, person.lms_user_id or "")


def _given(grade: Any) -> float | None:
    """Return the points that were given, by a person before the machine, with extra credit."""
    base = grade.auto_score if grade.manual_score is None else grade.manual_score
    if base is None and not grade.extra_credit:
        return None
    return float((base or 0.0) + (grade.extra_credit or 0.0))


def _comments(submission: Any) -> dict[str, str]:
    return {
        comment.name: comment.manual_comment
        for notebook in submission.notebooks
        for comment in notebook.comments
        if comment.manual_comment
    }
