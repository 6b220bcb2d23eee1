"""The one writer: puts what came of a submission into nbgrader's gradebook and folders.

Each submission is one transaction. The order makes a kill at any moment harmless: first the graded
notebooks lie beside their place, then the gradebook has the scores, then the record is written,
and only then the notebooks take their place. What is not in its place is graded again.
"""

from __future__ import annotations

import json
import os
import shutil
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from nbgrader.api import BaseCell, Gradebook, MissingEntry
from nbgrader.preprocessors import AssignLatePenalties
from nbgrader.utils import parse_utc
from sqlalchemy import select
from sqlalchemy.exc import SAWarning

from course_lib.grading.assignment import Assignment
from course_lib.grading.gradebooks import open_gradebook
from course_lib.grading.one import Graded
from course_lib.grading.parcels import copy_beside, unforeseen
from course_lib.grading.submissions import fingerprint, handed_in_at

NO_RESPONSE = "No response."


@contextmanager
def recording(assignment: Assignment) -> Iterator[Recorder]:
    """Open the gradebook for writing gradings of one assignment down; `open_gradebook`'s errors."""
    with open_gradebook(assignment.db_url, assignment.course_id) as gradebook:
        yield Recorder(assignment, gradebook)


class Recorder:
    """Writes gradings of one assignment down; made by `recording`."""

    def __init__(self, assignment: Assignment, gradebook: Gradebook) -> None:
        self._assignment, self._gradebook = assignment, gradebook
        with gradebook.engine.connect() as connection:  # nbgrader would ask for them one by one
            cells = connection.execute(select(BaseCell.id, BaseCell.name))
            self._labels = {cell.id: cell.name for cell in cells}
        self._penalties = AssignLatePenalties(config=assignment.config)
        self._penalties.init_plugin()

    def save(self, graded: Graded) -> Graded:
        """Write one grading down, for good.

        Parameters
        ----------
        graded : Graded
            What came of a submission. If it could not be graded, earlier scores stay.

        Returns
        -------
        Graded
            The same; with `trouble` if what lies beside the notebook could not be copied.
        """
        graded = self._lay_beside(graded)
        before = read_record(self._assignment, graded.student)
        same = before.get("fingerprint") == graded.fingerprint
        with _transaction(self._gradebook):
            submission = self._submission(graded.student)
            if not graded.trouble:
                for notebook in submission.notebooks:
                    self._score(notebook, graded, same)
                self._gradebook.db.flush()
                self._penalize(submission)
        _write(self._assignment.record(graded.student), graded.as_json())
        if not graded.trouble:
            self._put_in_place(graded.student)
        return graded

    def note_time(self, student: str) -> bool:
        """Note when a submission that is graded was handed in again, with nothing changed.

        Parameters
        ----------
        student : str
            Whose.

        Returns
        -------
        bool
            Whether the time is another now, and with it perhaps the penalty for late work.
        """
        final = self._assignment.autograded(student)
        stamp = handed_in_at(self._assignment.submitted(student))
        if stamp == handed_in_at(final) or not (stamp or self._has_time(student)):
            return False  # a time that only stands beside the graded notebook is a receipt's
        with _transaction(self._gradebook):
            submission = self._submission(student)
            self._gradebook.db.flush()
            self._penalize(submission)
        if stamp:  # last, so that after a kill it is done again
            _write(final / "timestamp.txt", stamp)
        else:
            (final / "timestamp.txt").unlink()
        return True

    def _has_time(self, student: str) -> bool:
        """Whether the gradebook knows when it was handed in."""
        try:
            found = self._gradebook.find_submission(self._assignment.name, student)
        except MissingEntry:
            return False
        return found.timestamp is not None

    def _lay_beside(self, graded: Graded) -> Graded:
        """Write the graded notebooks, and what goes with them, beside their place."""
        growing = growing_folder(self._assignment, graded.student)
        shutil.rmtree(growing, ignore_errors=True)
        if graded.trouble:
            return graded
        try:
            copy_beside(self._assignment.submitted(graded.student), growing)
            copy_beside(self._assignment.source(), growing)
            for name, content in graded.notebooks.items():
                growing.mkdir(parents=True, exist_ok=True)
                (growing / f"{name}.ipynb").write_bytes(content)
            for path in (*growing.glob("*.ipynb"), growing):
                _sync(path)
        except OSError as error:  # e.g. a file in the place of one of the source's folders
            shutil.rmtree(growing, ignore_errors=True)
            return replace(graded, trouble=unforeseen(error), grades={}, exercises={})
        return graded

    def _submission(self, student: str) -> Any:
        """Return nbgrader's entry of a submission; nbgrader makes it where there is none."""
        self._gradebook.update_or_create_student(student)
        name = self._assignment.name
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", SAWarning)  # nbgrader's own, and harmless
            submission = self._gradebook.update_or_create_submission(name, student)
        stamp = handed_in_at(self._assignment.submitted(student))
        submission.timestamp = parse_utc(stamp) if stamp else None
        return submission

    def _score(self, notebook: Any, graded: Graded, same: bool) -> None:
        """Enter automatic scores; what a person entered stays."""
        scores = graded.grades.get(notebook.name, {})
        for grade in notebook.grades:
            label = self._labels[grade.cell_id]
            if label not in scores:
                continue
            score = scores[label]
            unchanged = same and grade.auto_score == score
            grade.auto_score = score
            if not (unchanged and grade.manual_score is not None):
                grade.needs_manual_grade = grade.manual_score is not None or score is None
        responses = graded.responses.get(notebook.name, {})
        for comment in notebook.comments:
            label = self._labels[comment.cell_id]
            if label in responses:
                comment.auto_comment = None if responses[label] else NO_RESPONSE

    def _penalize(self, submission: Any) -> None:
        """Let nbgrader's plug-in for late submissions set its penalty."""
        late, plugin = submission.total_seconds_late, self._penalties.plugin_inst
        for notebook in submission.notebooks:
            penalty = None
            if late > 0:
                self._gradebook.db.refresh(notebook)
                found = (submission.student_id, notebook.score, late)
                penalty = plugin.late_submission_penalty(*found)
            if penalty is not None:
                penalty = self._penalties._check_late_penalty(notebook, penalty)
            notebook.late_submission_penalty = penalty

    def _put_in_place(self, student: str) -> None:
        final, growing = (
            self._assignment.autograded(student),
            growing_folder(self._assignment, student),
        )
        for path in growing.rglob("*"):
            if path.is_file():
                path.chmod(0o444)
        old = final.with_name(f".{final.name}.old")
        shutil.rmtree(old, ignore_errors=True)
        if final.exists():
            final.rename(old)
        growing.rename(final)
        shutil.rmtree(old, ignore_errors=True)


def growing_folder(assignment: Assignment, student: str) -> Path:
    """Return where a graded submission grows until it is in the gradebook."""
    final = assignment.autograded(student)
    return final.with_name(f".{final.name}.part")


@contextmanager
def _transaction(gradebook: Any) -> Iterator[None]:
    """Make one transaction of what nbgrader's functions would commit one by one."""
    session = gradebook.db()
    session.commit = session.flush
    try:
        yield
    except BaseException:
        del session.commit
        session.rollback()
        raise
    del session.commit
    session.commit()


def _write(path: Path, text: str) -> None:
    """Write a file so that it is there whole, or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f".{path.name}.part")
    part.write_text(text, encoding="utf-8", errors="backslashreplace")  # valid in JSON
    _sync(part)
    os.replace(part, path)
    _sync(path.parent)


def _sync(path: Path) -> None:
    """Wait until the disk has a file or folder: the machine may lose its power next."""
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def read_record(assignment: Assignment, student: str) -> dict[str, Any]:
    """Return what is known of a student's last grading; nothing if it is not to be read."""
    path = assignment.record(student)
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def is_graded(assignment: Assignment, student: str) -> bool:
    """Whether this version of a submission was graded, by this command or by nbgrader's own."""
    record, final = read_record(assignment, student), assignment.autograded(student)
    folder = assignment.submitted(student)
    if growing_folder(assignment, student).exists():  # what was graded did not take its place
        return False
    now = fingerprint(folder, list(assignment.notebooks))
    if record.get("fingerprint") == now:
        return not record.get("trouble") and final.is_dir()
    if record or not final.is_dir():
        return False
    return handed_in_at(folder) == handed_in_at(final)  # graded by nbgrader autograde
