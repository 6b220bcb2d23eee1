"""Right answers in unusual forms: each form and each library occurs, and each is worth all."""

import nbformat
import numpy as np
import pytest
from small_course import write_course

from course_lib.authoring.building import build
from course_lib.authoring.expansion import grade_id
from course_lib.exercises import find
from data_generators.classes import Simulation
from data_generators.pasting_mishaps import by_label
from data_generators.typed_answers import expected_points
from data_generators.unusual import BORROWED, FORMS, unusual_class


@pytest.fixture(scope="module")
def notebooks(tmp_path_factory):
    (path,) = build(write_course(tmp_path_factory.mktemp("unusual") / "c"), ["01_pinhole"])
    simulation = Simulation(nbformat.read(path, as_version=4), "pinhole")
    made = unusual_class(simulation, np.random.default_rng(0))
    return {s.student: nbformat.reads(s.content.decode(), as_version=4) for s in made}


def answered(notebook, name):
    """Run a notebook's cells down to an answer; return its function."""
    cell, scope = by_label(notebook)[grade_id(name)], {"np": np}
    for above in notebook.cells[: notebook.cells.index(cell) + 1]:
        if above.cell_type == "code" and ("my_" in above.source or above is cell):
            exec(above.source, scope)
    return scope[find(name).function_name]


@pytest.mark.parametrize("name", BORROWED)
def test_other_libraries_give_the_same(notebooks, name):
    exercise = find(name)
    assert expected_points(exercise, answered(notebooks["borrower"], name)) == exercise.points


@pytest.mark.parametrize("name", ["pinhole.dolly_zoom", "pinhole.project_pinhole"])
def test_helpers_stand_above_and_go_at_the_end(notebooks, name):
    notebook, exercise = notebooks["helpers"], find(name)
    assert expected_points(exercise, answered(notebook, name)) == exercise.points
    assert f"my_{exercise.function_name}" in notebook.cells[-1].source


def test_every_form_occurs(notebooks):
    code = [c.source for c in notebooks["helpers"].cells if c.cell_type == "code"]
    for form in FORMS:
        begin = form.partition("{")[0] or form.partition("{name}")[2].partition("{")[0]
        assert any(begin in source for source in code), form


def test_the_slow_answer_waits_once(notebooks, monkeypatch):
    waited = []
    monkeypatch.setattr("time.sleep", waited.append)
    function = answered(notebooks["slow"], "pinhole.dolly_zoom")
    assert [function(50, 2, 6), function(50, 2, 4)] == [150.0, 100.0]
    assert waited == [2.5]
