import re
import stat
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest
from nbgrader.plugins import FileNameCollectorPlugin
from small_course import write_course
from traitlets.config import PyFileConfigLoader

from course_lib.exercises import CHAPTERS, all_exercises
from course_lib.grading.term import make_term, plan_term


@pytest.fixture
def course(tmp_path):
    return write_course(tmp_path / "course")


@pytest.fixture
def term(tmp_path, course):
    plan = plan_term(tmp_path / "camera 2026", course)
    make_term(plan, course)
    return plan


def test_what_is_in_it(term):
    found = {path.name for path in term.directory.iterdir()}
    assert found == {"README.md", "nbgrader_config.py", "grading.key", "source", "exchange"}
    assert stat.S_IMODE((term.directory / "grading.key").stat().st_mode) == 0o600


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such permissions")
def test_nobody_else_of_the_machine_may_look_into_it(term):
    assert stat.S_IMODE(term.directory.stat().st_mode) == 0o700


def test_practice_is_left_out_unless_asked_for(tmp_path, course, term):
    assert term.chapters == tuple(list(CHAPTERS.values())[1:])
    assert plan_term(tmp_path / "other", course, ["00_welcome"]).chapters == ("00_welcome",)


def test_source_has_solutions_rubrics_and_model_answers(term):
    path = term.directory / "source/01_pinhole/01_pinhole.ipynb"
    text = "\n".join(cell.source for cell in nbformat.read(path, as_version=4).cells)
    for exercise in all_exercises("pinhole"):
        assert f'check("{exercise.name}")' in text or exercise.model_answer in text
    assert "BEGIN SOLUTION" in text
    assert "BEGIN MARK SCHEME" in text


@pytest.mark.parametrize(
    ("file", "student", "name"),
    [
        ("Leo Müller_880012_assignsubmission_file_/01_pinhole.ipynb", "880012", "01_pinhole"),
        ("Leo M_12_b_880013_assignsubmission_file/01_pinhole (1).ipynb", "880013", "01_pinhole"),
        ("Leo Müller_880014_assignsubmission_file_12_lab.ipynb", "880014", "12_lab"),
        ("Leo Müller_880014_assignsubmission_file_lab_report.html", "880014", "lab_report"),
        ("zola_778_91022_01_pinhole.ipynb", "778", "01_pinhole"),
        ("woolfvirginia_LATE_777_91021_01_pinhole-2.ipynb", "777", "01_pinhole"),
        ("orr_779_91023_My homework.ipynb", "779", "My homework"),
    ],
)
def test_archives_of_moodle_and_canvas_can_be_collected(term, file, student, name):
    options = PyFileConfigLoader("nbgrader_config.py", str(term.directory)).load_config()
    found = FileNameCollectorPlugin(config=options).collect(f"/t_1_2_3/extracted/all 5/{file}")
    assert (found["student_id"], found["file_id"]) == (student, name)


def test_readme_names_this_terms_commands(term):
    text = (term.directory / "README.md").read_text(encoding="utf-8")
    assert "$" not in text
    for command in ("generate_assignment", "release_assignment", "collect", "autograde"):
        assert f"nbgrader {command} 01_pinhole" in text


@pytest.mark.skipif(sys.platform == "win32", reason="asks a POSIX shell")
def test_readme_says_how_to_get_at_the_commands(term):
    text = (term.directory / "README.md").read_text(encoding="utf-8")
    command = re.search(r"```\n(.*activate.*)\n```", text)[1]
    if command.startswith("source"):
        shell = ["bash", "-c", f"{command} && command -v nbgrader"]
        found = subprocess.run(shell, capture_output=True, text=True, check=True).stdout
        assert found.strip() == str(Path(sys.executable).with_name("nbgrader"))


def test_course_id_is_made_of_the_directorys_name(term):
    assert term.course_id == "camera-2026"


def test_exchange_elsewhere(tmp_path, course):
    plan = plan_term(tmp_path / "term", course, exchange=tmp_path / "shared")
    make_term(plan, course)
    assert not (tmp_path / "shared").exists()
    config = (tmp_path / "term/nbgrader_config.py").read_text()
    assert str(tmp_path / "shared") in config


@pytest.mark.parametrize("place", ["term", "lessons/term", "."])
def test_not_inside_the_course(course, place):
    with pytest.raises(ValueError, match=r"inside the course's own folder|already in use"):
        plan_term(course / place, course)


def test_not_inside_another_copy_of_the_course(tmp_path, course):
    other = write_course(tmp_path / "other")
    with pytest.raises(ValueError, match="inside the course's own folder"):
        plan_term(other / "term", course)


def test_nothing_is_overwritten(tmp_path, course):
    (tmp_path / "term").mkdir()
    plan_term(tmp_path / "term", course)  # an empty folder is fine
    (tmp_path / "term/file").write_text("")
    for place in ("term", "term/file"):
        with pytest.raises(ValueError, match="already in use"):
            plan_term(tmp_path / place, course)


def test_names(tmp_path, course):
    with pytest.raises(ValueError, match="a course id has letters"):
        plan_term(tmp_path / "term", course, course_id="camera 2026")
    with pytest.raises(ValueError, match="no lesson '02_lens'"):
        plan_term(tmp_path / "term", course, ["02_lens"])


def test_a_bad_lesson_leaves_nothing_behind(tmp_path, course):
    lesson = course / "lessons/01_pinhole.md"
    lesson.write_text(lesson.read_text().replace("pinhole.dolly_zoom", "pinhole.dolly"))
    with pytest.raises(ValueError, match=r"no exercise 'pinhole\.dolly'"):
        make_term(plan_term(tmp_path / "term", course), course)
    assert not (tmp_path / "term").exists()
