import shutil
from pathlib import Path
from types import SimpleNamespace

import nbformat
import numpy as np
import pytest
from second_solutions import second_solutions
from small_course import run, write_course

from data_generators.classes import PASTED, Simulation, simulate_class, write_submissions
from data_generators.unusual import unusual_class

#: The student whose submission was put into place by hand.
BY_MAIL = "half-done"
#: Who is graded by nbgrader's own command; the others are by `course grade`.
BY_NBGRADER = (
    "right", "misconception-1", "killed", PASTED, "deleted-cells", "cut-off", "empty-file",
    "renamed",
)  # fmt: skip
#: What other tests may have done with the term that everybody copies.
HANDED_IN = shutil.ignore_patterns("submitted", "autograded", "feedback", "grading")


@pytest.fixture(scope="session")
def make_term(tmp_path_factory):
    """Make a term of a small course with its notebook released into the gradebook."""

    def make(name: str, *options: str) -> Path:
        base = tmp_path_factory.mktemp(name)
        course = write_course(base / "course")
        term = ("term", base / "term", "--course-id", "camera", *options)
        made = run("course", *term, cwd=course)
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
def submissions(released_term):
    """A class, by name."""
    released = nbformat.read(released_term / "release/01_pinhole/01_pinhole.ipynb", as_version=4)
    everybody = simulate_class(released, "pinhole", second_solutions("pinhole"))
    everybody += unusual_class(Simulation(released, "pinhole"), np.random.default_rng(3))
    return {submission.student: submission for submission in everybody}


@pytest.fixture(scope="session")
def new_term(released_term, tmp_path_factory, submissions):
    """Make a copy of the term in which some of the class have handed in."""

    def make(name, students):
        term = tmp_path_factory.mktemp(name) / "term"
        shutil.copytree(released_term, term, ignore=HANDED_IN)
        config = (term / "nbgrader_config.py").read_text()
        (term / "nbgrader_config.py").write_text(config.replace(str(released_term), str(term)))
        write_submissions(term, "01_pinhole", [submissions[student] for student in students])
        return term

    return make


@pytest.fixture(scope="session")
def graded(make_term, submissions):
    """A term in which a class was graded in both ways, up to feedback and the table of grades."""
    term, everybody = make_term("graded"), submissions.values()
    early = [s for s in everybody if s.student in BY_NBGRADER]
    write_submissions(term, "01_pinhole", early)
    autograde = run("nbgrader", "autograde", "01_pinhole", cwd=term)
    write_submissions(term, "01_pinhole", [s for s in everybody if s not in early])
    for name in ("timestamp.txt", "submission_secret.txt"):  # as if it had come by mail
        (term / "submitted" / BY_MAIL / "01_pinhole" / name).unlink()
    course = run("course", "grade", "01_pinhole", cwd=term)
    feedback = run("nbgrader", "generate_feedback", "01_pinhole", cwd=term)
    release = run("nbgrader", "release_feedback", "01_pinhole", cwd=term)
    export = run("nbgrader", "export", "--to", "grades.csv", cwd=term)
    yield SimpleNamespace(
        term=term,
        submissions=submissions,
        autograde=autograde,
        course=course,
        feedback=feedback,
        release=release,
        export=export,
    )
    shutil.rmtree(term)
