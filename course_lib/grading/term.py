"""Make a term's course directory, in which nbgrader's own commands work."""

from __future__ import annotations

import re
import sys
import sysconfig
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from string import Template

from course_lib.authoring.building import copy_pictures, find_lessons, write_notebook
from course_lib.authoring.expansion import expand
from course_lib.authoring.lesson import read_lesson
from course_lib.exercises import CHAPTERS
from course_lib.grading.gradebooks import gradebook_url
from course_lib.grading.seeding import write_key

KEY_NAME = "grading.key"
#: Chapters that are practice, and in a term's directory only on request.
NOT_GRADED = ("00_welcome",)


@dataclass(frozen=True)
class Term:
    """Where a term lives and what it is called."""

    directory: Path
    course_id: str
    exchange: Path
    chapters: tuple[str, ...]
    gradebook: str = ""


def plan_term(
    directory: Path,
    root: Path,
    chapters: Sequence[str] = (),
    course_id: str = "",
    exchange: Path | None = None,
    gradebook: str = "",
) -> Term:
    """Decide what a term's directory is like, or say why it cannot be made.

    Parameters
    ----------
    directory : pathlib.Path
        A folder that does not exist yet, or is empty; not in the course's own folder.
    root : pathlib.Path
        The course's folder.
    chapters : sequence of str, optional
        Names of lessons; all that are graded unless told otherwise.
    course_id : str, optional
        nbgrader's name for the course; the directory's name unless told otherwise.
    exchange : pathlib.Path, optional
        The folder through which notebooks come and go; one in the directory unless told otherwise.
    gradebook : str, optional
        The URL of a database; a file of SQLite in the directory unless told otherwise.

    Returns
    -------
    Term
        For `make_term`.

    Raises
    ------
    ValueError
        If the directory is in use or in the course's folder, or a name or URL cannot be used.
    """
    directory = directory.expanduser().resolve()
    if any((folder / "lessons").is_dir() for folder in directory.parents):
        raise ValueError(
            f"{directory} is inside the course's own folder; submissions and grades "
            f"do not belong there, so choose another place, e.g. {root.resolve().parent / 'term'}"
        )
    if directory.exists() and (not directory.is_dir() or any(directory.iterdir())):
        raise ValueError(f"{directory} is already in use; choose a new folder")
    course_id = course_id or re.sub(r"[^\w-]+", "-", directory.name)
    if re.search(r"[^\w-]", course_id):
        raise ValueError(f"a course id has letters, digits, - and _ only, not {course_id!r}")
    graded = [name for name in CHAPTERS.values() if name not in NOT_GRADED]
    found = [path.stem for path in find_lessons(root, list(chapters) or graded)]
    exchange = (exchange or directory / "exchange").expanduser().resolve()
    url = gradebook_url(gradebook) if gradebook else ""
    return Term(directory, course_id, exchange, tuple(found), url)


def make_term(term: Term, root: Path) -> None:
    """Write a term's directory: sources with solutions, settings, key, instructions.

    Parameters
    ----------
    term : Term
        From `plan_term`.
    root : pathlib.Path
        The course's folder.

    Raises
    ------
    LessonError
        If a lesson cannot be expanded; nothing is written then.
    """
    lessons = [read_lesson(path) for path in find_lessons(root, term.chapters)]
    notebooks = [expand(lesson) for lesson in lessons]
    term.directory.mkdir(parents=True, exist_ok=True)
    term.directory.chmod(0o700)  # solutions, the key, grades: for nobody else of the machine
    for lesson, notebook in zip(lessons, notebooks, strict=True):
        folder = term.directory / "source" / lesson.name
        write_notebook(notebook, folder / f"{lesson.name}.ipynb")
        copy_pictures(lesson, folder)
    words = {
        "course_id": term.course_id,
        "exchange": str(term.exchange),
        "key_name": KEY_NAME,
        "scores": f"the database `{term.gradebook}`" if term.gradebook else "`gradebook.db`",
        "database": f"c.CourseDirectory.db_url = {term.gradebook!r}\n" if term.gradebook else "",
        "chapters": ", ".join(f"`{name}`" for name in term.chapters),
        "first": next((c for c in term.chapters if c not in NOT_GRADED), term.chapters[0]),
        "activate": _activation(Path(sysconfig.get_path("scripts"))),
    }
    for template, name in (("term_config", "nbgrader_config.py"), ("term_readme", "README.md")):
        text = Path(__file__).with_name(f"{template}.txt").read_text(encoding="utf-8")
        (term.directory / name).write_text(Template(text).substitute(words), encoding="utf-8")
    if term.exchange.is_relative_to(term.directory):
        term.exchange.mkdir()
    write_key(term.directory / KEY_NAME)


def _activation(scripts: Path) -> str:
    """Return the command that puts this environment's programs on the path."""
    if not (scripts / "activate").exists():
        return f"conda activate {sys.prefix}"
    return f'"{scripts}\\activate"' if sys.platform == "win32" else f"source '{scripts}/activate'"
