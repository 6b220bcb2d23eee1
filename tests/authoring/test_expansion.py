from pathlib import Path

import nbformat
import pytest
from small_course import SETUP, chapter_lesson, exercise_cell, lesson, question_cell

from course_lib.authoring.building import notebook_bytes
from course_lib.authoring.expansion import check_id, expand, grade_id, rubric
from course_lib.authoring.lesson import LessonError, read_lesson
from course_lib.exercises import CHAPTERS, all_exercises
from course_lib.judging import Exercise, Explain, ValuesExercise

EXERCISES = [e for e in all_exercises() if isinstance(e, Exercise)]
QUESTIONS = [e for e in all_exercises() if isinstance(e, Explain)]


def expanded(tmp_path: Path, text: str, name: str = "01_pinhole"):
    path = tmp_path / f"{name}.md"
    path.write_text(text, encoding="utf-8")
    return expand(read_lesson(path))


@pytest.fixture(params=list(CHAPTERS))
def chapter(request, tmp_path):
    notebook = expanded(tmp_path, chapter_lesson(request.param), CHAPTERS[request.param])
    return request.param, notebook


def flags(notebook):
    found = {}
    for cell in notebook.cells:
        if "nbgrader" in cell.metadata:
            found[cell.metadata.nbgrader.grade_id] = cell
    return found


def test_is_valid_and_has_unique_ids(chapter):
    _, notebook = chapter
    nbformat.validate(notebook)
    ids = [cell.id for cell in notebook.cells]
    assert len(set(ids)) == len(ids)


def test_every_exercise_has_a_solution_and_a_check(chapter):
    name, notebook = chapter
    cells = flags(notebook)
    for exercise in all_exercises(name):
        if isinstance(exercise, Exercise):
            solution, check = cells[grade_id(exercise.name)], cells[check_id(exercise.name)]
            assert "### BEGIN SOLUTION" in solution.source
            assert (solution.metadata.nbgrader.solution, solution.metadata.nbgrader.grade) == (1, 0)
            assert check.source == f'check("{exercise.name}")'
            assert (check.metadata.nbgrader.locked, check.metadata.nbgrader.grade) == (1, 1)
            assert check.metadata.nbgrader.points == exercise.points


def test_checks_of_solutions_give_all_points_as_nbgrader_reads_them(chapter):
    """nbgrader gives full marks for what it cannot read as a number, also at score 0."""
    _, notebook = chapter
    scope = {"__name__": "__main__"}
    for cell in notebook.cells:
        if cell.source.startswith("check("):
            points = eval(cell.source, scope)
            assert float(repr(points)) == points  # as nbgrader reads it
            assert points == cell.metadata.nbgrader.points
        elif cell.cell_type == "code":
            exec(cell.source, scope)


def test_checks_of_stubs_give_a_zero_that_nbgrader_reads(capsys):
    from course_lib.notebook import check

    for exercise in EXERCISES:
        points = check(exercise.name, {})
        assert float(repr(points)) == points  # as nbgrader reads it
        assert points == 0
    assert capsys.readouterr().err == ""


def test_question_has_rubric_and_model_answer(chapter):
    name, notebook = chapter
    cells = flags(notebook)
    for question in all_exercises(name):
        if isinstance(question, Explain):
            asked = cells[f"{grade_id(question.name)}-question"]
            assert asked.source.startswith("Why is that so?\n<!-- BEGIN MARK SCHEME -->")
            assert asked.metadata.nbgrader.locked
            answer = cells[grade_id(question.name)]
            assert answer.source == question.model_answer
            assert answer.metadata.nbgrader.points == question.points


@pytest.mark.parametrize("question", QUESTIONS, ids=lambda e: e.name)
def test_rubric_says_what_each_point_is_for(question):
    text = rubric(question)
    for points, what in question.rubric:
        assert f"**{points:g}** · {what}" in text


def test_values_start_as_none(chapter):
    name, notebook = chapter
    for exercise in all_exercises(name):
        if isinstance(exercise, ValuesExercise):
            lines = flags(notebook)[grade_id(exercise.name)].source.splitlines()
            stub = lines[: lines.index("### BEGIN SOLUTION")]
            assert stub == [f"{v} = None  # {unit}" for v, unit in exercise.units.items()]


def test_only_the_first_import_of_check_is_read_only(tmp_path):
    notebook = expanded(tmp_path, lesson("# T\n", SETUP, SETUP))
    assert list(flags(notebook)) == ["setup"]
    assert notebook.cells[1].metadata.nbgrader.locked


def test_the_same_lesson_gives_the_same_bytes(tmp_path):
    text = lesson("# T\n", SETUP, SETUP, "same\n\n+++\n\nsame\n")
    first, second = (notebook_bytes(expanded(tmp_path, text)) for _ in range(2))
    assert first == second


def test_ids_of_other_cells_stay_when_one_changes(tmp_path):
    before = expanded(tmp_path, lesson("# T\n", SETUP, "Old.\n"))
    after = expanded(tmp_path, lesson("# T\n", SETUP, "New.\n"))
    assert [c.id for c in before.cells[:2]] == [c.id for c in after.cells[:2]]


@pytest.mark.parametrize(
    ("block", "message"),
    [
        (exercise_cell("pinhole.project_pinhol"), r"no exercise .* did you mean .*project_pinhole"),
        (exercise_cell("pinhole.explain_flat_faces"), "belongs in a Markdown cell"),
        (question_cell("pinhole.dolly_zoom"), "belongs in a code cell"),
    ],
)
def test_errors_name_the_line(tmp_path, block, message):
    with pytest.raises(LessonError, match=message) as caught:
        expanded(tmp_path, lesson("# T\n", block))
    assert "/01_pinhole.md:" in str(caught.value)
