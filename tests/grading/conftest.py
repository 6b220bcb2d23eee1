import shutil
from pathlib import Path
from types import SimpleNamespace

import nbformat
import pytest
from second_solutions import second_solutions
from small_course import run, write_course

from data_generators.classes import PASTED, simulate_class, write_submissions

#: The student whose submission was put into place by hand.
BY_MAIL = "half-done"
#: Who is graded by nbgrader's own command; the others are by `course grade`.
BY_NBGRADER = (
    "right", "misconception-1", "killed", PASTED, "deleted-cells", "cut-off", "empty-file",
    "renamed",
)  # fmt: skip


@pytest.fixture(scope="session")
def make_term(tmp_path_factory):
    """Make a term of a small course with its notebook released into the gradebook."""

    def make(name: str) -> Path:
        base = tmp_path_factory.mktemp(name)
        course = write_course(base / "course")
        made = run("course", "term", base / "term", "--course-id", "camera", cwd=course)
        assert made.returncode == 0, made.stderr
        config = base / "term/nbgrader_config.py"
        config.write_text(config.read_text() + "c.AnswerOutside.cell_seconds = 5\n")
        generated = run("nbgrader", "generate_assignment", "01_pinhole", cwd=base / "term")
        assert generated.returncode == 0, generated.stderr
        return base / "term"

    return make


@pytest.fixture(scope="session")
def released_term(make_term):
    """A term whose notebook is ready for students."""
    return make_term("released")


@pytest.fixture(scope="session")
def graded(make_term):
    """A term in which a class was graded in both ways, up to feedback and the table of grades."""
    term = make_term("graded")
    released = nbformat.read(term / "release/01_pinhole/01_pinhole.ipynb", as_version=4)
    submissions = simulate_class(released, "pinhole", second_solutions("pinhole"))
    early = [s for s in submissions if s.student in BY_NBGRADER]
    write_submissions(term, "01_pinhole", early)
    autograde = run("nbgrader", "autograde", "01_pinhole", cwd=term)
    write_submissions(term, "01_pinhole", [s for s in submissions if s not in early])
    for name in ("timestamp.txt", "submission_secret.txt"):  # as if it had come by mail
        (term / "submitted" / BY_MAIL / "01_pinhole" / name).unlink()
    course = run("course", "grade", "01_pinhole", cwd=term)
    feedback = run("nbgrader", "generate_feedback", "01_pinhole", cwd=term)
    release = run("nbgrader", "release_feedback", "01_pinhole", cwd=term)
    export = run("nbgrader", "export", "--to", "grades.csv", cwd=term)
    yield SimpleNamespace(
        term=term,
        submissions={submission.student: submission for submission in submissions},
        autograde=autograde,
        course=course,
        feedback=feedback,
        release=release,
        export=export,
    )
    shutil.rmtree(term)
