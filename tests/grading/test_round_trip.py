"""A whole class through nbgrader's own commands, in a term's directory."""

import csv
import html
import re

import nbformat
import numpy as np
import pytest
from nbgrader.api import Gradebook
from small_course import run

from course_lib.authoring.expansion import check_id
from course_lib.exercises import all_exercises, find
from course_lib.grading.marking import CRASH
from course_lib.grading.seeding import grading_seed, read_key
from course_lib.judging import Exercise, ValuesExercise, pose, seed_for
from course_lib.judging.answering import expected_answer
from course_lib.judging.text import format_value
from data_generators.classes import PASTED

pytestmark = pytest.mark.slow
ASSIGNMENT = "01_pinhole"
EXERCISES = [e for e in all_exercises("pinhole") if isinstance(e, Exercise)]
TOTAL = sum(e.points for e in EXERCISES)
KINDS = [
    *("right", "rewritten", "half-done", "untouched", "troubled", "noisy"),
    *(
        "killed",
        "pasted-copies",
        "deleted-cells",
        "copied-out",
        "other-tool",
        "cut-off",
        "empty-file",
        "renamed",
        "helpers",
        "borrower",
        "slow",
    ),
    *(f"misconception-{k + 1}" for k in range(max(len(e.misconceptions) for e in EXERCISES))),
]


@pytest.fixture(scope="module")
def scores(graded):
    with Gradebook(f"sqlite:///{graded.term}/gradebook.db") as gradebook:
        return {
            submission.student.id: {
                grade.name: grade.auto_score
                for notebook in submission.notebooks
                for grade in notebook.grades
            }
            for submission in gradebook.assignment_submissions(ASSIGNMENT)
        }


def feedback(graded, student):
    path = graded.term / "feedback" / student / ASSIGNMENT / f"{ASSIGNMENT}.html"
    page = path.read_text(encoding="utf-8")
    return re.sub(r"<(style|script)\b.*?</\1>", "", page, flags=re.DOTALL)  # numbers of the layout


def test_the_class_is_complete(graded):
    assert set(graded.submissions) == set(KINDS)


def test_everyone_who_was_graded_gets_feedback(graded):
    assert graded.feedback.returncode == graded.release.returncode == 0
    released = list(graded.term.glob("exchange/camera/feedback/*.html"))
    assert len(released) == sum(s.points is not None for s in graded.submissions.values())


@pytest.mark.parametrize("student", KINDS)
def test_scores_are_exactly_those_expected(graded, scores, student):
    points = graded.submissions[student].points
    if points is None:  # could not be graded
        assert {*scores[student].values()} == {None}
    else:
        got = {e.name: scores[student][check_id(e.name)] for e in EXERCISES}
        assert got == points


@pytest.mark.parametrize(
    ("student", "points"),
    [("right", TOTAL), ("rewritten", TOTAL), ("other-tool", TOTAL), ("untouched", 0)],
)
def test_anchors(scores, student, points):
    assert sum(v or 0 for k, v in scores[student].items() if k.endswith("-check")) == points


def test_what_cannot_be_graded_costs_itself_only(graded, scores):
    assert graded.autograde.returncode == 1
    without = [name for name, points in scores.items() if {*points.values()} == {None}]
    assert sorted(without) == ["cut-off", "empty-file", "renamed"]
    failed = re.findall(
        r"error processing assignment '\S+' for student '(.+)'", graded.autograde.stderr
    )
    assert sorted(failed) == ["cut-off", "empty-file", "renamed"]


def test_the_log_names_who_handed_in_copies_and_raises_no_false_alarm(graded):
    assert f"{PASTED} handed in more than one copy of: setup, " in graded.autograde.stderr
    assert "exists multiple times" not in graded.autograde.stderr
    assert "has changed!" not in graded.autograde.stderr


def test_feedback_says_why_a_check_could_not_be_run(graded):
    assert CRASH in html.unescape(feedback(graded, "killed"))


def test_words_wait_for_a_person_unless_there_are_none(graded):
    with Gradebook(f"sqlite:///{graded.term}/gradebook.db") as gradebook:
        for student, waits in (("right", True), ("untouched", False)):
            (notebook,) = gradebook.find_submission(ASSIGNMENT, student).notebooks
            assert notebook.needs_manual_grade == waits


@pytest.mark.parametrize("student", [k for k in KINDS if k.startswith("misconception")])
def test_feedback_holds_each_hint(graded, student):
    text = html.unescape(re.sub(r"</?code>", "`", feedback(graded, student)))
    hints = graded.submissions[student].hints
    assert hints
    assert [hint for hint in hints if hint not in text] == []


@pytest.mark.parametrize("student", ["right", "untouched", "troubled", "noisy", "misconception-1"])
def test_feedback_gives_no_secret_away(graded, student):
    text = html.unescape(feedback(graded, student))
    key = read_key(graded.term / "grading.key")
    seed = grading_seed(key, student, ASSIGNMENT)
    assert seed not in text
    assert key.decode() not in text
    for exercise in EXERCISES:
        if not isinstance(exercise, ValuesExercise):
            hidden = hidden_numbers(exercise, seed)
            assert hidden
            assert [number for number in hidden if number in text] == []


def hidden_numbers(exercise, seed):
    """Return the numbers of hidden inputs and answers that nobody could come across by chance."""
    numbers = set()
    for case in pose(exercise, seed_for(seed, exercise.name)):
        for value in [*case.inputs.values(), expected_answer(exercise, case)]:
            written = f"{value!r} {format_value(value)} {np.asarray(value).tolist()!r}"
            numbers.update(re.findall(r"\d+\.\d{3,}", written))
    return {number for number in numbers if len(number) > 6}


def test_contents_of_the_feedback_name_the_exercises(graded):
    text = feedback(graded, "right")
    assert re.findall(r"<code>([\w.]+)</code></a> \(Score", text) == [e.name for e in EXERCISES]
    assert "Test cell" not in text


def test_hidden_inputs_differ_between_students_and_from_their_own(graded):
    key, exercise = read_key(graded.term / "grading.key"), find("pinhole.project_pinhole")
    seeds = [grading_seed(key, student, ASSIGNMENT) for student in ("ada", "ben")]
    # Hundreds of rounded numbers agree by chance now and then; those with all digits do not.
    found = [hidden_numbers(exercise, seed) for seed in [*seeds, "ada"]]
    posed = [{number for number in numbers if len(number) > 12} for numbers in found]
    assert all(posed)
    assert not posed[0] & posed[1]
    assert not posed[0] & posed[2]


def test_autograded_notebooks_show_verdicts_without_examples(graded):
    path = graded.term / "autograded/misconception-1" / ASSIGNMENT / f"{ASSIGNMENT}.ipynb"
    cells = nbformat.read(path, as_version=4).cells
    shown = [
        str(output.data)
        for cell in cells
        for output in cell.get("outputs", [])
        if output.output_type == "display_data"
    ]
    assert len(shown) == len(EXERCISES)
    assert not any("What was tried" in text for text in shown)


def test_the_grader_sees_the_rubric_and_the_student_does_not(graded):
    released = (graded.term / "release" / ASSIGNMENT / f"{ASSIGNMENT}.ipynb").read_text()
    path = graded.term / "autograded/right" / ASSIGNMENT / f"{ASSIGNMENT}.ipynb"
    assert "Rubric" not in released
    assert "Rubric" in path.read_text()


def test_grading_again_gives_the_same(graded, scores):
    again = run(
        "nbgrader", "autograde", ASSIGNMENT, "--student", "misconception-3", "--force",
        cwd=graded.term,
    )  # fmt: skip
    assert again.returncode == 0, again.stderr
    with Gradebook(f"sqlite:///{graded.term}/gradebook.db") as gradebook:
        (notebook,) = gradebook.find_submission(ASSIGNMENT, "misconception-3").notebooks
        assert {g.name: g.auto_score for g in notebook.grades} == scores["misconception-3"]


def test_without_the_key_nothing_is_done_and_nothing_removed(graded):
    key, page = graded.term / "grading.key", graded.term / "autograded/right" / ASSIGNMENT
    hidden, before = key.rename(key.with_suffix(".away")), sorted(page.iterdir())
    try:
        for command in (["autograde", ASSIGNMENT, "--student=right", "--force"], ["export"]):
            failed = run("nbgrader", *command, cwd=graded.term)
            assert failed.returncode == 1
            assert failed.stdout == ""
            (sentence,) = failed.stderr.splitlines()
            assert f"no key in {key}: without it nothing can be graded" in sentence
    finally:
        hidden.rename(key)
    assert sorted(page.iterdir()) == before


def test_the_table_of_grades(graded, scores):
    assert graded.export.returncode == 0, graded.export.stderr
    with (graded.term / "grades.csv").open(newline="") as file:
        rows = {row["student_id"]: row for row in csv.DictReader(file)}
    assert set(rows) == set(KINDS)
    for student, row in rows.items():
        assert float(row["raw_score"]) == sum(v or 0 for v in scores[student].values())
        assert float(row["max_score"]) == TOTAL + 4
