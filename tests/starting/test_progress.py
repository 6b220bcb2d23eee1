import io

import pytest

from course_lib.starting.progress import Line, Stage, stage_of

GETTING = """\
Ignoring appnope: markers 'sys_platform == "darwin"' don't match your environment
Collecting alembic==1.20.1 (from -r requirements.lock (line 1))
  Using cached alembic-1.20.1-py3-none-any.whl
Collecting argon2-cffi==25.1.0 (from -r requirements.lock (line 7))
"""
INSTALLING = GETTING + "Installing collected packages: alembic, argon2-cffi\n"


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(
    ("log", "unpacked", "line"),
    [
        (GETTING, 0, "Getting package 2 of 9: argon2-cffi"),
        (INSTALLING, 0, "Installing package 0 of 2"),
        (INSTALLING, 1, "Installing package 1 of 2"),
        (INSTALLING, 99, "Installing package 2 of 2"),
    ],
)
def test_stage_is_read_from_what_pip_prints(log, unpacked, line):
    assert str(stage_of(log, 10, unpacked)) == line


@pytest.mark.parametrize("log", ["", GETTING.split("Collecting")[0]])
def test_no_total_is_told_that_would_fall(log):
    assert stage_of(log, 10, 0) is None
    Line(stream := io.StringIO()).show(None)
    assert stream.getvalue() == ""


def test_packages_that_are_there_count_as_got():
    log = "Requirement already satisfied: numpy==2.4.6 in ./lib (from -r lock (line 1))\n" + GETTING
    assert (stage_of(log, 10, 0).done, stage_of(log, 10, 0).total) == (3, 9)


def test_a_file_gets_a_line_each_quarter():
    line = Line(stream := io.StringIO())
    for done in range(101):
        line.show(Stage("Getting package", done, 100))
    line.clear()
    assert stream.getvalue().splitlines() == [
        f"  Getting package {done} of 100" for done in (0, 25, 50, 75, 100)
    ]


def test_a_terminal_gets_one_line_redrawn_and_cleared(monkeypatch):
    monkeypatch.setenv("COLUMNS", "30")
    line = Line(stream := Terminal())
    line.show(Stage("Getting package", 1, 2, "a-very-long-name-of-a-package"))
    line.show(Stage("Getting package", 2, 2, "six"))
    line.clear()
    first, second = "Getting package 1 of 2: a-ver", "Getting package 2 of 2: six"
    assert stream.getvalue().split("\r")[1:] == [first, second + "  ", " " * 29, ""]
