from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from course_lib.grading.planning import names_used, plan

SETUP = "import numpy as np\nfrom course_lib.drawing import pinhole as draw\ndraw.holes()"
GIVEN = (
    "cameras = [1, 2]\ndraw.cameras(cameras)",
    "markers = [c + 1 for c in cameras]",
    "draw.holes()\ndraw.box().show()",
    "unused = markers",
)


def labelled(source, **flags):
    usual = {"grade": False, "solution": False, "locked": False, "grade_id": source[:20]}
    return new_code_cell(source, metadata={"nbgrader": usual | flags})


def check(name):
    return labelled(f'check("pinhole.{name}")', grade=True, locked=True, points=4)


def ran(*own, given=GIVEN):
    cells = [labelled(SETUP, locked=True), *map(new_code_cell, given), *own]
    planned = plan(new_notebook(cells=[new_markdown_cell("words"), *cells]), GIVEN)
    return planned, [step["source"] for step in planned.steps if "source" in step]


def test_given_cells_are_run_only_if_something_needs_them():
    answer = labelled("def dolly_zoom(a, b, c):\n    return a", solution=True)
    assert ran(answer)[1] == [SETUP.replace("\ndraw.holes()", ""), answer.source]
    own = new_code_cell("print(markers)")
    assert ran(own)[1][1:] == ["cameras = [1, 2]", GIVEN[1], "print(markers)"]


def test_a_changed_cell_is_the_students():
    assert ran(given=["cameras = [3]"])[1][1:] == ["cameras = [3]"]


def test_who_can_see_everything_gets_everything():
    assert len(ran(new_code_cell("print(globals())"))[1]) == 5  # all but the one that only shows


def test_what_cannot_be_read_counts_with_all_its_words():
    assert names_used("def f(:\n  markers") >= {"def", "f", "markers"}
    assert "get_ipython" in names_used("%time markers\n!ls")  # which sees everything
    assert ran(new_code_cell("x = markers ("))[1][1:3] == ["cameras = [1, 2]", GIVEN[1]]


def test_names_of_a_function_are_its_own():
    assert "markers" not in names_used("def f(markers):\n    markers = 1\n    return markers")
    assert "markers" in names_used("def f():\n    return [markers for _ in 'a']")


def test_checks_stand_where_they_are_and_others_are_run_as_they_are():
    test = labelled("assert True", grade=True, locked=True, points=1)
    planned, _ = ran(check("dolly_zoom"), test, check("data_sheet"))
    assert [c.exercise.function_name for c in planned.checks] == ["dolly_zoom", "data_sheet"]
    steps = list(planned.steps)
    assert steps[1]["function"] == "dolly_zoom"
    assert steps[2]["source"] == "assert True"
    assert steps[3]["variables"]


def test_a_check_in_a_cell_of_the_students_is_none():
    planned, sources = ran(new_code_cell('check("pinhole.dolly_zoom")'))
    assert planned.checks == ()
    assert sources[-1].startswith("check")


def test_all_is_run_and_drawn_if_a_person_must_grade_code():
    drawn = labelled("plot()", grade=True, solution=True, points=2)
    planned, sources = ran(drawn)
    assert planned.draws
    assert sources == [SETUP, *GIVEN, "plot()"]


def test_a_report_is_always_shown_and_nothing_else_is_run_for_it():
    report = labelled("show_report()", grade_id="report", locked=True)
    planned, sources = ran(report)
    assert planned.draws
    assert sources == [SETUP.replace("\ndraw.holes()", ""), "show_report()"]
    assert not ran()[0].draws


def test_a_cell_of_magics_is_planned_at_once_and_everything_runs():
    """IPython takes minutes to make Python of this, and then gives up."""
    names = names_used("!ls\n" * 5000 + "f(x)")
    assert {"get_ipython", "f", "x"} <= names
    assert "get_ipython" not in names_used("def f(x:\n    return y % 2")
    assert "get_ipython" in names_used("%matplotlib inline\nf(x)")
