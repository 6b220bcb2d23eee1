import os
import subprocess
import sys

import pytest
from small_course import write_course

from course_lib import cli
from course_lib.exercises import CHAPTERS


@pytest.fixture
def course(tmp_path, monkeypatch):
    root = write_course(tmp_path / "course")
    monkeypatch.chdir(root)
    return root


def run(capsys, *arguments):
    code = cli.main(arguments)
    shown = capsys.readouterr()
    return code, shown.out, shown.err


def test_help_reads_well(capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "100")
    with pytest.raises(SystemExit) as ended:
        cli.main(["--help"])
    assert ended.value.code == 0
    text = capsys.readouterr().out
    assert "make the student notebooks from the lessons" in text
    assert "make a course directory in which nbgrader works" in text


@pytest.mark.parametrize(
    "arguments",
    [
        [], ["bild"], ["build", "--chek"], ["term"],
        *(["export", "--missing", typed] for typed in ("nan", "inf", "1e9", "-1", "two")),
    ],
)  # fmt: skip
def test_misuse_ends_with_2(capsys, arguments):
    with pytest.raises(SystemExit) as ended:
        cli.main(arguments)
    assert ended.value.code == 2
    assert "usage: course" in capsys.readouterr().err


def test_build(capsys, course):
    assert run(capsys, "build", "01_pinhole") == (
        0, "wrote notebooks/01_pinhole/01_pinhole.ipynb\n", ""
    )  # fmt: skip
    others = [name for name in CHAPTERS.values() if name != "01_pinhole"]
    wrote = "".join(f"wrote notebooks/{name}/{name}.ipynb\n" for name in others)
    assert run(capsys, "build") == (0, wrote, "")
    nothing = f"Nothing to do: {len(CHAPTERS)} fresh notebooks.\n"
    assert run(capsys, "build") == (0, nothing, "")


def test_build_check(capsys, course):
    code, out, err = run(capsys, "build", "--check")
    assert (code, err) == (1, "")
    assert out.splitlines() == [
        f"notebooks/{name}/{name}.ipynb is missing; run: course build {name}"
        for name in CHAPTERS.values()
    ]
    run(capsys, "build")
    assert run(capsys, "build", "--check")[0] == 0
    assert not list(course.glob("**/gradebook.db"))


def test_a_lessons_error_is_one_line(capsys, course):
    lesson = course / "lessons/00_welcome.md"
    lesson.write_text(lesson.read_text().replace("welcome.image_centre\n", "welcome.nothing\n"))
    code, out, err = run(capsys, "build")
    assert (code, out) == (2, "")
    assert err.startswith("course: lessons/00_welcome.md:")
    assert len(err.splitlines()) == 1


def test_unknown_lesson(capsys, course):
    code, _, err = run(capsys, "build", "07_x")
    assert code == 2
    assert err == f"course: no lesson '07_x'; there are {', '.join(CHAPTERS.values())}\n"


def test_term(capsys, course, tmp_path):
    code, out, err = run(capsys, "term", str(tmp_path / "autumn"), "--course-id", "camera")
    assert (code, err) == (0, "")
    assert "nbgrader generate_assignment 01_pinhole" in out
    assert 'course_id = "camera"' in (tmp_path / "autumn/nbgrader_config.py").read_text()
    assert run(capsys, "term", str(tmp_path / "autumn"))[0] == 2
    assert run(capsys, "term", str(course / "autumn"))[0] == 2


def test_the_working_directory_decides_which_course(course, tmp_path):
    assert cli.course_folder() == course
    assert cli.course_folder(course / "lessons") == course
    (tmp_path / "elsewhere").mkdir()
    own = cli.course_folder(tmp_path / "elsewhere")
    assert (own / "course_lib").is_dir()


def test_without_lessons_anywhere(monkeypatch, capsys, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(cli.course_lib, "__file__", str(tmp_path / "lib/course_lib/__init__.py"))
    code, _, err = run(capsys, "build")
    assert code == 2
    assert err == "course: there is no folder `lessons` here; run this in the course's folder\n"


def test_the_parser_alone_loads_nothing_of_jupyter():
    code = (
        "import sys; from course_lib.cli import main\n"
        "try: main(['--help'])\nexcept SystemExit: pass\n"
        "print([m for m in ('nbgrader', 'jupytext', 'matplotlib') if m in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env=dict(os.environ)
    )
    assert done.stdout.splitlines()[-1] == "[]"
