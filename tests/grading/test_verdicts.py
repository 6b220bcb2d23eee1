import pytest
from nbformat.v4 import new_code_cell, new_output
from nbgrader.utils import determine_grade

from course_lib.grading.verdicts import REPLACED, KeepVerdicts
from course_lib.judging import answer, judge, pose
from course_lib.judging.html import to_html

SCORE = new_output("execute_result", data={"text/plain": "3.0"}, execution_count=1)
STDERR = new_output("stream", name="stderr", text="f = 12.5")
STDOUT = new_output("stream", name="stdout", text="f = 12.5")
PICTURE = new_output("display_data", data={"text/plain": "f = 12.5"})


def cell_of(*outputs, grade=True):
    flags = {"grade": grade, "solution": False, "locked": True, "grade_id": "a", "points": 4}
    return new_code_cell("check('a')", outputs=list(outputs), metadata={"nbgrader": flags})


def kept(cell):
    KeepVerdicts().preprocess_cell(cell, {}, 0)
    return list(cell.outputs)


def verdict_output():
    from course_lib.exercises import find

    exercise = find("pinhole.dolly_zoom")
    cases = pose(exercise, 0)
    verdict = judge(exercise, cases, answer(exercise, exercise.reference, cases))
    return new_output("display_data", data={"text/html": to_html(verdict)})


def test_keeps_what_the_check_says():
    verdict = verdict_output()
    assert kept(cell_of(STDOUT, STDERR, PICTURE, verdict, SCORE)) == [verdict, SCORE]


def test_stray_stderr_would_cost_all_points():
    cell = cell_of(STDERR, verdict_output(), SCORE)
    assert determine_grade(cell) == (0, 4)
    kept(cell)
    assert determine_grade(cell) == (3, 4)


def test_errors_stay():
    error = new_output("error", ename="NameError", evalue="check", traceback=[])
    assert kept(cell_of(error)) == [error]


@pytest.mark.parametrize("outputs", [[], [SCORE], [STDOUT, SCORE], [PICTURE, SCORE], [PICTURE]])
def test_a_check_that_is_not_the_courses_earns_nothing(outputs):
    cell = cell_of(*outputs)
    (error,) = kept(cell)
    assert error.evalue == REPLACED
    assert determine_grade(cell) == (0, 4)


@pytest.mark.parametrize(("shown", "points"), [("2.5", 2.5), ("np.float64(2.5)", 4), ("<b>", 4)])
def test_nbgrader_reads_plain_numbers_only(shown, points):
    """The trap: what is not a plain number counts as full marks."""
    result = new_output("execute_result", data={"text/plain": shown}, execution_count=1)
    assert determine_grade(cell_of(result)) == (points, 4)


def test_other_cells_are_left_alone():
    assert kept(cell_of(STDERR, PICTURE, grade=False)) == [STDERR, PICTURE]
    assert kept(new_code_cell("1", outputs=[STDERR])) == [STDERR]
