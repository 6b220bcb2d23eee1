"""What a notebook calls: checks that explain, cells that run whatever a student wrote."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from IPython.core.interactiveshell import InteractiveShell
from traitlets.config import Config

import course_lib
from course_lib.camera import project_pinhole as course_project
from course_lib.notebook import _student, attempt, attempt_each, check, solution

POINTS = [[0.0, 0.0, 2.0], [0.5, -0.25, 2.0]]


def named(function: Any, name: str = "project_pinhole") -> Any:
    function.__name__ = name
    return function


def answer(result: Any) -> Any:
    """Return a student's `project_pinhole` that gives always the same."""
    return named(lambda points, f, c: result)


def test_a_right_answer_comes_back_as_numbers() -> None:
    student = named(lambda points, f, c: course_project(points, f, c).tolist())
    np.testing.assert_array_equal(
        attempt(student, POINTS, f=800, c=(320, 240)), course_project(POINTS, 800, (320, 240))
    )


def test_a_number_comes_back_as_a_plain_float() -> None:
    student = named(lambda f, Z, Z_new: np.array(7), "dolly_zoom")
    assert type(attempt(student, 50, 2, 6)) is float


@pytest.mark.parametrize(
    ("result", "said"),
    [
        (None, "project_pinhole returns None instead of an array of shape (2, 2)"),
        (3.0, "project_pinhole returns a number instead of an array of shape (2, 2)"),
        (np.ones((2, 3)), "project_pinhole returns an array of shape (2, 3)"),
        (np.array(["left"]), "project_pinhole returns an array of texts of shape (1,) instead"),
        ("left", "project_pinhole returns a text instead of an array of shape (2, 2)"),
        ([[1, 2], [3]], "project_pinhole returns a list"),
        ({"u": 1}, "project_pinhole returns a dict"),
    ],
)
def test_what_cannot_be_drawn_is_none_and_says_why(
    result: Any, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert attempt(answer(result), POINTS, 800, (320, 240)) is None
    assert said in capsys.readouterr().out


def test_several_results_come_back_each_as_it_should_be() -> None:
    R, t = np.diag([1.0, -1, -1]), np.array([1.0, 2, 3])
    answer = named(lambda R, t: [R.T.tolist(), (-R.T @ t).tolist()], "invert_pose")
    rotation, translation = attempt(answer, R, t)
    np.testing.assert_array_equal(rotation, R)
    np.testing.assert_array_equal(translation, [-1, 2, 3])


@pytest.mark.parametrize(
    ("result", "said"),
    [
        (None, "invert_pose returns None instead of 2 results"),
        (np.eye(3), "invert_pose returns an array of shape (3, 3) instead of 2 results"),
        ((np.eye(3),), "invert_pose returns a tuple of 1 value instead of 2 results"),
        (5.0, "invert_pose returns a number instead of 2 results"),
        ((np.eye(3), np.eye(3)), "invert_pose returns an array of shape (3, 3) instead of an"),
    ],
)
def test_too_few_or_wrong_results_are_none_and_say_why(
    result: Any, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert attempt(named(lambda R, t: result, "invert_pose"), np.eye(3), np.zeros(3)) is None
    assert said in capsys.readouterr().out


def test_a_dictionary_comes_back_as_it_is(capsys: pytest.CaptureFixture[str]) -> None:
    parts = {"focal_length": (50.0, 50.0)}
    assert attempt(named(lambda name: parts, "parse_lens_name"), "50mm f/1.8") == parts
    assert attempt(named(lambda name: (50.0, 50.0), "parse_lens_name"), "50mm f/1.8") is None
    assert "parse_lens_name returns a tuple of 2 values instead of a dictionary" in (
        capsys.readouterr().out
    )


def test_the_untouched_stub_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    def project_pinhole(points: Any, f: Any, c: Any) -> Any:
        raise NotImplementedError

    assert attempt(project_pinhole, POINTS, 800, (320, 240)) is None
    assert "not written yet" in capsys.readouterr().out


def test_an_exception_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    assert attempt(named(lambda points, f, c: points[9]), POINTS, 800, (320, 240)) is None
    assert "IndexError" in capsys.readouterr().out


def test_an_endless_loop_ends(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def project_pinhole(points: Any, f: Any, c: Any) -> Any:
        while True:
            pass

    monkeypatch.setattr("course_lib.notebook.PATIENCE", 0.05)
    assert attempt(project_pinhole, POINTS, 800, (320, 240)) is None
    assert "takes too long" in capsys.readouterr().out


def test_inputs_are_not_changed() -> None:
    def project_pinhole(points: Any, f: Any, c: Any) -> Any:
        points[:] = 0
        return points[:, :2]

    points = np.array(POINTS)
    attempt(project_pinhole, points, 800, (320, 240))
    np.testing.assert_array_equal(points, POINTS)


def test_each_gives_a_result_for_each_or_none_for_all() -> None:
    cases = [(50, 2, 6), (50, 2, 2)]
    assert attempt_each(named(lambda f, Z, Z_new: f * Z_new / Z, "dolly_zoom"), cases) == [150, 50]
    assert attempt_each(named(lambda f, Z, Z_new: f / (Z - Z_new), "dolly_zoom"), cases) == [
        None,
        None,
    ]


def test_a_function_that_is_no_exercise_is_taken_as_it_is() -> None:
    assert attempt(named(lambda text: text, "shout"), "hello") == "hello"


def test_the_package_offers_it() -> None:
    assert course_lib.attempt is attempt


def test_check_shows_the_verdict_and_returns_a_number_that_is_not_repeated(shell, capsys):
    def half(image_size):
        return np.array(image_size) / 2

    points = check("welcome.image_centre", {"image_centre": half})
    assert points == 0.0
    found, _ = shell.display_formatter.format(points)
    assert found == {"text/plain": "0.0", "text/html": ""}  # nbgrader reads the first
    text = capsys.readouterr().out
    assert "0 of 2 points" in text
    assert "Hint: A picture 3 pixels wide" in text


def test_check_finds_the_answer_among_the_caller_s_variables(capsys):
    source = "def image_centre(size): return [(n - 1) / 2 for n in size]\npoints = check(name)"
    cell = {"check": check, "name": "welcome.image_centre"}
    exec(source, cell)
    assert cell["points"] == 2
    assert "2 of 2 points" in capsys.readouterr().out


def test_check_of_a_question_in_words_says_who_grades_it():
    with pytest.raises(ValueError, match="a person reads and grades it"):
        check("pinhole.explain_flat_faces")


def test_check_of_an_unknown_exercise_names_similar_ones():
    with pytest.raises(ValueError, match=r"did you mean pinhole\.dolly_zoom"):
        check("pinhole.doly_zoom")


def test_solution_shows_the_course_s_own_source(capsys):
    solution("pinhole.dolly_zoom")
    assert "return f * Z_new / Z" in capsys.readouterr().out
    solution("pinhole.explain_flat_faces")
    assert "one factor" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("namespace", "words"),
    [
        ({}, "no function `image_centre` yet"),
        ({"image_centre": 0.37}, "`image_centre` is a number, not a function"),
    ],
)
def test_check_says_what_is_missing(namespace, words, capsys):
    assert check("welcome.image_centre", namespace) == 0
    assert words in capsys.readouterr().out


@pytest.mark.parametrize("name", ["pinhole.project_pinhole", "pinhole.pixel_focal_length"])
def test_a_shown_solution_runs_in_a_notebook(name, capsys):
    solution(name)
    cell = {"np": np}
    exec(capsys.readouterr().out, cell)
    assert check(name, cell) > 0
    assert "not answered" not in capsys.readouterr().out


@pytest.fixture
def shell():
    """Return what runs the cells of a notebook; it writes nothing to the disk."""
    config = Config({"HistoryManager": {"enabled": False}})
    shell = InteractiveShell(config=config)
    shell.user_ns["check"] = check
    return shell


RIGHT = "%time\ndef image_centre(size):\n    return [(n - 1) / 2 for n in size]"


@pytest.mark.parametrize(
    ("cells", "line"),
    [
        ([RIGHT], None),
        ([RIGHT, "1 +"], None),
        ([RIGHT, RIGHT.replace(" in size]", "")], 3),
        ([RIGHT, RIGHT.replace("(size)", " size)")], 2),
        ([RIGHT, RIGHT.replace("    return", "return")], 3),
        ([RIGHT, RIGHT.replace(" in size]", ""), RIGHT], None),
    ],
    ids=["right", "other cell", "bracket", "first line", "indentation", "mended"],
)
def test_check_says_when_it_judges_an_older_version(shell, cells, line, capsys):
    for cell in cells:
        shell.run_cell(cell, store_history=True)
    capsys.readouterr()
    result = shell.run_cell("check('welcome.image_centre')", store_history=True)
    said = capsys.readouterr().out
    assert result.result == 2
    assert ("the version that you ran before" in said) == (line is not None)
    assert line is None or f"line {line} of the cell" in said


@pytest.mark.parametrize(
    ("environment", "name"),
    [
        ({"COURSE_STUDENT": "ada", "JUPYTERHUB_USER": "hub"}, "ada"),
        ({"COURSE_STUDENT": "", "JUPYTERHUB_USER": "hub"}, "hub"),
        ({}, "login"),
    ],
)
def test_who_works_here_is_told_by_the_environment(environment, name, monkeypatch):
    monkeypatch.setattr("getpass.getuser", lambda: "login")
    assert _student(environment) == name
