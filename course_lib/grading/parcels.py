"""What of a submission goes to whoever grades it, and what stays: a parcel needs no shared disk."""

from __future__ import annotations

import os
import shutil
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from course_lib.grading.assignment import Assignment
from course_lib.grading.seeding import grading_seed, read_key
from course_lib.grading.submissions import (
    MOST_BESIDE,
    UnreadableError,
    all_beside,
    files_beside,
    fingerprint,
    read_content,
)

#: Bytes of what lies beside a notebook that are copied.
MOST_COPIED = 100_000_000


@dataclass(frozen=True)
class Parcel:
    """All of one submission that it takes to grade it.

    Attributes
    ----------
    student : str
        Who.
    fingerprint : str
        Of which version of the submission.
    seed : str
        From `grading_seed`; the key itself stays.
    notebooks : mapping of str to bytes
        What was handed in, by the notebook's name.
    files : mapping of str to bytes
        What lies beside, for a program to read.
    trouble : str
        Why it cannot be graded, as a sentence for the student; empty if it can.
    """

    student: str
    fingerprint: str
    seed: str = ""
    notebooks: Mapping[str, bytes] = field(default_factory=dict)
    files: Mapping[str, bytes] = field(default_factory=dict)
    trouble: str = ""


def pack(assignment: Assignment, student: str) -> Parcel:
    """Read what a student handed in.

    Parameters
    ----------
    assignment : Assignment
        What was asked.
    student : str
        Who.

    Returns
    -------
    Parcel
        With `trouble` if it cannot be read.
    """
    folder = assignment.submitted(student)
    # Taken first: a submission that changes while it is read is graded again.
    mark = fingerprint(folder, list(assignment.notebooks))
    try:
        seed = grading_seed(read_key(assignment.key_file), student, assignment.name)
        there = [n for n in assignment.notebooks if os.path.lexists(folder / f"{n}.ipynb")]
        if not there:
            raise UnreadableError(_not_there(folder, list(assignment.notebooks)))
        sizes = [path.stat().st_size for path in all_beside(folder)]
        if len(sizes) > MOST_BESIDE or sum(sizes) > MOST_COPIED:
            raise UnreadableError(TOO_LARGE)
        notebooks = {name: read_content(folder / f"{name}.ipynb") for name in there}
        return Parcel(student, mark, seed, notebooks, files_beside(folder))
    except UnreadableError as error:
        return Parcel(student, mark, trouble=str(error))
    except (OSError, ValueError) as error:
        return Parcel(student, mark, trouble=unforeseen(error))


TOO_LARGE = (
    "The files beside the notebook are too large or too many to be graded. Please hand in only "
    "the notebook and what it needs."
)


def unforeseen(error: Exception) -> str:
    """Return what is said where nobody foresaw that grading would fail."""
    reason = shown(f"{type(error).__name__}: {error}"[:500])
    return f"The notebook could not be graded ({reason}). A person must look at it."


def shown(text: str) -> str:
    """Return a text of a student's own with what a terminal would carry out, or cannot print, as ?.

    Parameters
    ----------
    text : str
        E.g. the name of a file, of any bytes.
    """
    return "".join(letter if letter.isprintable() else "?" for letter in text)


def _not_there(folder: Path, names: list[str]) -> str:
    wanted = " and ".join(f"{name}.ipynb" for name in names)
    others = sorted(path.name for path in folder.glob("*.ipynb"))
    if others:
        there = shown(", ".join(others[:3]))[:300]
        return (
            f"There is no {wanted}, but {there}. Please give the file the name "
            "that it had, and hand it in again."
        )
    return f"There is no {wanted} in what was handed in. Please hand it in again."


def copy_beside(folder: Path, target: Path) -> None:
    """Copy what lies beside notebooks; links are left out, as they could lead anywhere.

    Parameters
    ----------
    folder : pathlib.Path
        A submission's, or the source's.
    target : pathlib.Path
        Where the graded notebooks are.
    """
    for path in all_beside(folder):
        goal = target / path.relative_to(folder)
        goal.parent.mkdir(parents=True, exist_ok=True)
        goal.unlink(missing_ok=True)
        shutil.copyfile(path, goal)
