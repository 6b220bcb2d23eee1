"""A gradebook in a database of PostgreSQL: the same scores, and nbgrader's own commands.

And what is said of a database, of either kind, that is no gradebook or cannot be reached.
"""

import csv
import os
import re
import shutil
import sqlite3
import subprocess
import sys
import time
from contextlib import closing
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
from course_lib.grading.gradebooks import DRIVER, gradebook_url, only_writer, open_gradebook
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
@pytest.mark.parametrize(
    ("found", "put", "sentence"),
    [
        ("teacher@", "nobody@", r'no password supplied|authentication failed for user "nobody"'),
        ("/camera'", "/nowhere'", 'database "nowhere" does not exist'),
        ("@127.0.0.1:", "@127.0.0.1:1", "connection"),  # no such port, or nobody there
    ],
)
def test_a_database_that_cannot_be_reached(both, tmp_path, found, put, sentence, capfd):
    config = (both.postgresql / "nbgrader_config.py").read_text()
    assert config.count(found) == 1
    (tmp_path / "nbgrader_config.py").write_text(config.replace(found, put))
    shutil.copy(both.postgresql / "grading.key", tmp_path)
    for command in ("grade", "report", "export"):
        assert main([command, ASSIGNMENT, "--term", str(tmp_path)]) == 2
        said = capfd.readouterr().err
        assert "course: the gradebook does not do what it should: " in said
        assert re.search(sentence, said)
        assert re.search(r"Look whether the server of postgresql\S+ runs", said)
        assert len(said.splitlines()) == 1


@pytest.mark.slow
@walled
@served
def test_two_copies_of_a_term_do_not_write_into_one_database(both, capsys):
    url = read_assignment(both.waiting, ASSIGNMENT).db_url
    hold = (
        "import sys, time\nfrom course_lib.grading.gradebooks import only_writer\n"
        f"with only_writer({url!r}):\n    print('held', flush=True)\n    time.sleep(600)"
    )
    holder = subprocess.Popen([sys.executable, "-c", hold], stdout=subprocess.PIPE, text=True)
    try:
        assert holder.stdout.readline() == "held\n"
        assert main(["grade", ASSIGNMENT, "--term", str(both.waiting)]) == 2
        assert "another `course grade` is at work with the gradebook" in capsys.readouterr().err
        assert not (both.waiting / "autograded").exists()
        assert main(["report", "--term", str(both.waiting)]) == 0  # reading is free
    finally:
        holder.kill()  # whatever becomes of it, the lock goes with it
        holder.communicate()
    limit = time.monotonic() + 60
    while True:
        try:
            with only_writer(url):
                break
        except RuntimeError:
            assert time.monotonic() < limit
    with only_writer(url):  # given back
        pass


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


@pytest.mark.parametrize(
    ("url", "sentence"),
    [
        ("gradebook.db", "in nbgrader_config.py is no URL of a database that can be used"),
        ("nothing://host/camera", "in nbgrader_config.py is no URL of a database"),
        (
            "mysql://me:secret@host/camera",
            r"mysql://me:\*\*\*@host/camera needs the driver MySQLdb, which is not installed",
        ),
        (
            "postgresql+psycopg2://me@host/camera",
            r"psycopg2, .* begins with postgresql\+psycopg://",
        ),
    ],
)
def test_a_url_written_by_hand_that_cannot_be_used(url, sentence):
    with pytest.raises(ValueError, match=sentence), open_gradebook(url, "camera"):
        pass


def test_a_database_of_something_else_stays_as_it_is(tmp_path):
    path = tmp_path / "places.db"
    with closing(sqlite3.connect(path)) as other:
        other.execute("CREATE TABLE bookmarks (address TEXT)")
    with (
        pytest.raises(ValueError, match=r"places\.db is no gradebook: it holds bookmarks and"),
        open_gradebook(f"sqlite:///{path}", "camera"),
    ):
        pass
    with closing(sqlite3.connect(path)) as other:
        assert other.execute("SELECT name FROM sqlite_master").fetchall() == [("bookmarks",)]


def test_a_file_that_is_no_database(tmp_path):
    path = tmp_path / "gradebook.db"
    path.write_text("Dear diary, " * 100)
    sentence = r"file is not a database\. Put your copy of gradebook\.db into its place"
    with pytest.raises(RuntimeError, match=sentence), open_gradebook(f"sqlite:///{path}", "camera"):
        pass
    with (
        pytest.raises(RuntimeError, match=r"unable to open database file\. Look after .*nowhere"),
        open_gradebook(f"sqlite:///{tmp_path}/nowhere/gradebook.db", "camera"),
    ):
        pass


def test_a_gradebook_that_another_program_locks_or_another_nbgrader_made(tmp_path, capfd):
    path = tmp_path / "gradebook.db"

    def write_while_it_is_locked():
        with (
            open_gradebook(f"sqlite:///{path}?timeout=0.1", "camera") as gradebook,
            closing(sqlite3.connect(path)) as other,
        ):
            other.execute("BEGIN EXCLUSIVE")
            gradebook.update_or_create_student("ada")  # which nbgrader says with a stack trace

    with pytest.raises(RuntimeError, match=r"database is locked\. Another program writes into it"):
        write_while_it_is_locked()
    assert "Traceback" not in capfd.readouterr().err
    with closing(sqlite3.connect(path)) as file:
        file.execute("ALTER TABLE student DROP COLUMN lms_user_id")
        file.commit()
    sentence = "no such column: student.lms_user_id.* then run nbgrader db upgrade"
    with (
        pytest.raises(RuntimeError, match=sentence),
        open_gradebook(f"sqlite:///{path}", "camera") as gradebook,
    ):
        gradebook.find_student("ada")
