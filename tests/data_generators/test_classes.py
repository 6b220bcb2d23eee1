from dataclasses import replace

import nbformat
import numpy as np
import pytest
from second_solutions import second_solutions
from small_course import write_course

from course_lib.authoring.building import build
from course_lib.authoring.expansion import grade_id
from course_lib.exercises import all_exercises, find
from course_lib.judging import Exercise, Misconception, ValuesExercise
from data_generators.classes import TIMESTAMP, simulate_class, write_submissions
from data_generators.mishaps import NOISES, TROUBLES
from data_generators.typed_answers import (
    UnsteadyError,
    expected_points,
    misconceived,
    right,
    wrong_answers,
)

EXERCISES = [e for e in all_exercises("pinhole") if isinstance(e, Exercise)]


@pytest.fixture(scope="module")
def released(tmp_path_factory):
    (path,) = build(write_course(tmp_path_factory.mktemp("class") / "c"), ["01_pinhole"])
    return nbformat.read(path, as_version=4)


@pytest.fixture(scope="module")
def submissions(released):
    made = simulate_class(released, "pinhole", second_solutions("pinhole"))
    return {submission.student: submission for submission in made}


def cells(submission):
    notebook = nbformat.reads(submission.content.decode(), as_version=4)
    return {cell.id: cell.source for cell in notebook.cells}


def test_every_misconception_occurs(submissions):
    hints = {hint for submission in submissions.values() for hint in submission.hints}
    assert hints == {m.hint for e in EXERCISES for m in e.misconceptions}


def test_the_released_notebook_is_not_touched(released):
    before = nbformat.writes(released)
    simulate_class(released, "pinhole", second_solutions("pinhole"))
    assert nbformat.writes(released) == before


def test_an_untouched_notebook_is_the_released_one(released, submissions):
    assert nbformat.reads(submissions["untouched"].content.decode(), as_version=4) == released


def test_misconceptions_are_typed_under_the_right_name(submissions):
    typed = cells(submissions["misconception-1"])
    for exercise in EXERCISES:
        source = typed[grade_id(exercise.name)]
        assert f"def {exercise.function_name}(" in source
        assert "NotImplementedError" not in source


def test_who_renames_parameters_renames_them_everywhere():
    exercise = find("triangulation.refine_point")
    other = second_solutions("triangulation")["refine_point"]
    namespace = {"np": np}
    exec(right(exercise, other).source, namespace)
    assert expected_points(exercise, namespace["refine_point"]) == exercise.points
    assert "def refine_point(guess, " in right(exercise, other).source


def right_at_times(f, Z, Z_new):
    return f * Z_new / Z + int(1000 * np.sum(Z)) % 2


def test_wrong_answers_whose_points_depend_on_the_numbers_are_left_out():
    exercise = find("pinhole.dolly_zoom")
    unsteady = Misconception(right_at_times, "When?")
    mixed = replace(exercise, misconceptions=[unsteady, exercise.misconceptions[0]])
    with pytest.raises(UnsteadyError, match=r"right_at_times earns .*, depending on the seed"):
        misconceived(mixed, unsteady)
    assert [one.hint for one in wrong_answers(mixed)] == [exercise.misconceptions[0].hint]


def test_points_are_between_nothing_and_all(submissions):
    for k in range(1, 5):
        points = submissions[f"misconception-{k}"].points
        assert all(points[e.name] < e.points for e in EXERCISES)
    assert sum(submissions["right"].points.values()) == sum(e.points for e in EXERCISES)


def test_points_that_depend_on_the_seed_are_refused(monkeypatch):
    exercise, calls = find("pinhole.dolly_zoom"), []

    def sometimes(f, Z, Z_new):
        calls.append(1)
        return f * Z_new / Z if len(calls) > 20 else 0.0

    with pytest.raises(ValueError, match="depending on the seed"):
        expected_points(exercise, sometimes)


@pytest.mark.parametrize("mishaps", [TROUBLES, NOISES], ids=["troubles", "noises"])
def test_mishaps_are_code_about_the_exercise(mishaps):
    exercise = find("pinhole.project_pinhole")
    for name, happens in mishaps.items():
        source = happens(exercise)
        assert "def project_pinhole(points, f, c):" in source
        if name != "syntax error":
            compile(source, name, "exec")


@pytest.mark.parametrize(("student", "mishaps"), [("troubled", TROUBLES), ("noisy", NOISES)])
def test_every_mishap_occurs(submissions, student, mishaps):
    functions = [e for e in EXERCISES if not isinstance(e, ValuesExercise)]
    typed = set(cells(submissions[student]).values())
    for happens in mishaps.values():
        assert any(happens(exercise) in typed for exercise in functions)


def test_submissions_go_where_nbgrader_looks(tmp_path, submissions):
    write_submissions(tmp_path, "01_pinhole", list(submissions.values()))
    for student, submission in submissions.items():
        folder = tmp_path / "submitted" / student / "01_pinhole"
        name = submission.filename or "01_pinhole.ipynb"
        assert (folder / name).read_bytes() == submission.content
        assert (folder / "timestamp.txt").read_text() == TIMESTAMP
