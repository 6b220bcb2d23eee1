import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook, new_output
from nbgrader.utils import determine_grade
from second_solutions import second_solutions

from course_lib.exercises import find
from course_lib.grading.marking import CRASH, REASONS, mark, points_of
from course_lib.grading.outside import Outcome
from course_lib.judging import answer, judge, pose

EXERCISE = find("pinhole.dolly_zoom")


def check_cell(source='check("pinhole.dolly_zoom")', points=4):
    flags = {"grade": True, "solution": False, "locked": True, "grade_id": "a", "points": points}
    return new_code_cell(source, metadata={"nbgrader": flags}, outputs=[stream("left from before")])


def stream(text):
    return new_output("stream", name="stdout", text=text)


def verdict_of(function):
    cases = pose(EXERCISE, 0)
    return judge(EXERCISE, cases, answer(EXERCISE, function, cases), reveal=False)


def marked(cell, verdicts=None, outputs=None, reason=""):
    mark(new_notebook(cells=[cell]), Outcome(verdicts or {}, outputs or {}, reason))
    return cell


def test_a_check_holds_the_verdict_and_the_points_that_nbgrader_reads():
    right = marked(check_cell(), {0: verdict_of(second_solutions("pinhole")["dolly_zoom"])})
    assert determine_grade(right) == (EXERCISE.points, 4)
    assert "course-verdict right" in right.outputs[0].data["text/html"]
    assert points_of(right) == EXERCISE.points
    wrong = marked(check_cell(), {0: verdict_of(lambda *_: 1.0)})
    assert determine_grade(wrong) == (0, 4)


@pytest.mark.parametrize("reason", ["", *REASONS])
def test_a_check_that_was_not_reached_says_why_and_earns_nothing(reason):
    cell = marked(check_cell(), {0: None}, reason=reason)
    assert determine_grade(cell) == (0, 4)
    assert cell.outputs[0].evalue == REASONS.get(reason, CRASH)
    assert points_of(cell) == 0


def test_a_test_cell_of_the_instructor_keeps_what_it_wrote():
    passed = {"cell": 0, "outputs": []}
    assert determine_grade(marked(check_cell("assert True"), outputs={0: passed})) == (4, 4)
    failed = {"output_type": "error", "ename": "AssertionError", "evalue": "", "traceback": []}
    cell = marked(check_cell("assert False"), outputs={0: {"cell": 0, "outputs": [failed]}})
    assert determine_grade(cell) == (0, 4)
    assert determine_grade(marked(check_cell("assert True"))) == (0, 4)  # not reached


def test_an_error_without_traceback_shows_its_sentence_where_pages_look_for_it():
    late = {
        "output_type": "error",
        "ename": "TimeLimitReached",
        "evalue": "Stopped.",
        "traceback": [],
    }
    cell = marked(new_code_cell("while True: pass"), outputs={0: {"cell": 0, "outputs": [late]}})
    assert cell.outputs[0].traceback == ["TimeLimitReached: Stopped."]


@pytest.mark.parametrize(
    "forged",
    [
        None,
        "text",
        [],
        {},
        {"output_type": "display_data", "data": {"text/html": "<script>alert(1)</script>"}},
        {"output_type": "display_data", "data": {"image/png": '"><script>'}},
        {"output_type": "stream", "name": 3, "text": ["a"]},
        {"output_type": "error", "ename": None, "traceback": "x"},
        {"output_type": "execute_result", "data": 7},
        {"output_type": "update", "data": {}},
    ],
)
def test_what_is_no_plain_output_is_dropped(forged):
    cell = marked(new_code_cell("1"), outputs={0: {"cell": 0, "outputs": [forged]}})
    shown = str(cell.outputs)
    assert "script" not in shown
    assert "None" not in shown.replace("'execution_count': None", "")


def test_old_outputs_are_gone_and_other_cells_untouched():
    words = new_markdown_cell("words")
    code = new_code_cell("1", outputs=[stream("old")])
    mark(new_notebook(cells=[words, code]), Outcome({}, {}, ""))
    assert code.outputs == []
    assert words.source == "words"


@pytest.mark.parametrize(("shown", "points"), [("2.5", 2.5), ("np.float64(2.5)", 4), ("<b>", 4)])
def test_nbgrader_reads_plain_numbers_only(shown, points):
    """The trap: what is not a plain number counts as full marks."""
    result = new_output("execute_result", data={"text/plain": shown}, execution_count=1)
    cell = check_cell()
    cell.outputs = [result]
    assert determine_grade(cell) == (points, 4)
