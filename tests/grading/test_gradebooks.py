"""A gradebook in a database of PostgreSQL: the same scores, and nbgrader's own commands."""

import csv
import os
import re
import shutil
from types import SimpleNamespace

import pytest
from nbgrader.apps import NbGraderAPI
from small_course import run, write_course
from sqlalchemy.engine import make_url
from walls import walled

from benchmarks.kills import torment
from benchmarks.postgres import NoServerError, _program, postgres_server
from benchmarks.scenes import ASSIGNMENT, Scene, database_of
from benchmarks.snapshots import snapshot
from course_lib.cli import main
from course_lib.grading.assignment import read_assignment
from course_lib.grading.gradebooks import DRIVER, gradebook_url
from course_lib.grading.term import make_term as write_term
from course_lib.grading.term import plan_term
from data_generators.classes import write_submissions

CLASS = ("right", "half-done", "untouched", "misconception-1", "misconception-2", "pasted-copies")


def has_server():
    try:
        return bool(_program("initdb"))
    except NoServerError:
        return False


#: Where there is no PostgreSQL these tests skip; in CI they must run, and fail.
served = pytest.mark.skipif(
    not has_server() and not os.environ.get("CI"), reason="PostgreSQL is not installed"
)


@pytest.fixture(scope="module")
def server():
    with postgres_server() as running:
        yield running


@pytest.fixture(scope="module")
def both(server, make_term, submissions, tmp_path_factory):
    """Grade the same class twice, with the same key: on SQLite and on PostgreSQL."""
    with pytest.MonkeyPatch.context() as patch:
        for name, value in server.environment.items():
            patch.setenv(name, value)
        terms = {
            "sqlite": make_term("on-sqlite"),
            "postgresql": make_term("on-postgresql", "--gradebook", server.make_database("camera")),
        }
        shutil.copy(terms["sqlite"] / "grading.key", terms["postgresql"])
        for term in terms.values():
            write_submissions(term, ASSIGNMENT, [submissions[name] for name in CLASS])
        folder = tmp_path_factory.mktemp("waiting")
        waiting = Scene(terms["postgresql"], folder, server).copy("waiting")
        for term in terms.values():
            done = run("course", "grade", ASSIGNMENT, cwd=term)
            assert done.returncode == 0, done.stderr
        yield SimpleNamespace(**terms, waiting=waiting)


def everything(term):
    return snapshot(term, Scene(term, term.parent))


@pytest.mark.slow
@walled
@served
def test_the_gradebook_is_the_same(both):
    assert database_of(both.postgresql) == "camera"
    assert not (both.postgresql / "gradebook.db").exists()
    assert everything(both.postgresql) == everything(both.sqlite)


@pytest.mark.slow
@walled
@served
def test_nbgraders_own_commands_work_on_it(both):
    tables = []
    assert run("nbgrader", "db", "upgrade", cwd=both.postgresql).returncode == 0
    for term in (both.sqlite, both.postgresql):
        commands = (
            ("autograde", ASSIGNMENT, "--force", "--student", "half-done"),
            ("generate_feedback", ASSIGNMENT, "--student", "half-done"),
            ("export", "--to", "grades.csv"),
        )
        for command in commands:
            done = run("nbgrader", *command, cwd=term)
            assert done.returncode == 0, done.stderr
        with (term / "grades.csv").open(newline="") as file:
            tables.append(sorted(tuple(row.items()) for row in csv.DictReader(file)))
    assert tables[0] == tables[1]
    assert everything(both.postgresql) == everything(both.sqlite)


@pytest.mark.slow
@walled
@served
def test_reports_and_tables_are_the_same(both, monkeypatch):
    seen = []
    for term in (both.sqlite, both.postgresql):
        monkeypatch.chdir(term)
        assert main(["report"]) == main(["export"]) == 0
        files = sorted(path for kind in ("report", "export") for path in (term / kind).rglob("*.*"))
        texts = {p.relative_to(term): p.read_text(encoding="utf-8") for p in files}
        clocks = r"<p class='run'>2.*?</p>|<td class='number'>[\d.]+</td></tr>"
        seen.append({p: re.sub(clocks, "", text) for p, text in texts.items()})
    assert len(seen[0]) == len(CLASS) + 4
    assert seen[0] == seen[1]


@pytest.mark.slow
@walled
@served
def test_formgrader_sees_the_same(both, monkeypatch):
    seen = []
    for term in (both.sqlite, both.postgresql):
        monkeypatch.chdir(term)
        api = NbGraderAPI(config=read_assignment(term, ASSIGNMENT).config)
        tables = (
            api.get_assignments(),
            api.get_students(),
            api.get_submissions(ASSIGNMENT),
            api.get_notebooks(ASSIGNMENT),
            api.get_notebook_submissions(ASSIGNMENT, ASSIGNMENT),
            api.get_student_submissions("half-done"),
            api.get_student_notebook_submissions("half-done", ASSIGNMENT),
        )
        seen.append([sorted(map(comparable, table)) for table in tables])
        assert all(seen[-1])
    assert seen[0] == seen[1]


def comparable(row):
    """Return a row as words, without the numbers that a database gives out."""
    given = ("id", "index", "source_path", "path")  # the index is the rank of a random id
    own = {k: v for k, v in row.items() if k not in given}
    return str(sorted(own.items()))


@pytest.mark.slow
@walled
@served
def test_a_wrong_password_is_said_in_a_sentence(both, server, tmp_path, monkeypatch):
    wrong = tmp_path / "pgpass"
    wrong.write_text(f"127.0.0.1:{server.port}:*:*:guessed\n")
    wrong.chmod(0o600)
    monkeypatch.setenv("PGPASSFILE", str(wrong))
    done = run("course", "grade", ASSIGNMENT, cwd=both.postgresql)
    assert done.returncode == 2
    assert "the gradebook does not do what it should" in done.stderr
    assert "password authentication failed" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.slow
@walled
@served
def test_killed_at_random_moments_it_ends_as_if_nothing_had_been(both, server, tmp_path):
    report = torment(Scene(both.waiting, tmp_path, server), kills=2, seed=1)
    assert report.kills.total() == 2
    assert report.differences == []


def test_a_term_names_its_database_without_a_password(tmp_path):
    course = write_course(tmp_path / "course")
    url = "postgresql://teacher@db.example.org:5433/camera_2026"
    write_term(plan_term(tmp_path / "term", course, gradebook=url), course)
    config = (tmp_path / "term/nbgrader_config.py").read_text()
    expected = "postgresql+psycopg://teacher@db.example.org:5433/camera_2026"
    assert f"c.CourseDirectory.db_url = '{expected}'\n" in config
    assert make_url(expected).drivername == DRIVER
    assert f"the database `{expected}`" in (tmp_path / "term/README.md").read_text()


@pytest.mark.parametrize(
    ("typed", "sentence"),
    [
        ("postgresql://me:secret@host/camera", "leave the password out of the URL"),
        ("postgresql://me@host/camera?password=secret", "leave the password out of the URL"),
        ("postgresql://me@host", "names no database"),
        ("mysql://me:secret@host/camera", r"mysql://me:\*\*\*@host/camera"),
        ("camera", "a gradebook's URL is like postgresql://USER@HOST/DATABASE"),
    ],
)
def test_a_url_that_cannot_be_used(typed, sentence):
    with pytest.raises(ValueError, match=sentence) as caught:
        gradebook_url(typed)
    assert "secret" not in str(caught.value)
