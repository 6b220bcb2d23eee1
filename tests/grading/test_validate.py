"""What a student reads who presses *Validate*."""

import nbformat
import pytest
from nbgrader.validator import Validator
from second_solutions.pinhole import dolly_zoom
from small_course import write_course

from course_lib.authoring.building import build
from course_lib.exercises import all_exercises, find
from course_lib.judging import Exercise
from data_generators.classes import Simulation
from data_generators.typed_answers import Typed, misconceived, right

pytestmark = pytest.mark.slow
EXERCISES = [e for e in all_exercises("pinhole") if isinstance(e, Exercise)]


@pytest.fixture(scope="module")
def simulation(tmp_path_factory):
    course = write_course(tmp_path_factory.mktemp("validate") / "course")
    (path,) = build(course, ["01_pinhole"])
    return Simulation(nbformat.read(path, as_version=4), "pinhole")


@pytest.fixture
def failed(simulation, tmp_path):
    def validate(typed):
        path = tmp_path / "01_pinhole.ipynb"
        path.write_bytes(simulation.hand_in("ada", typed).content)
        found = Validator().validate(str(path))
        assert set(found) <= {"failed"}
        return {cell["source"]: cell["raw_error"] for cell in found.get("failed", [])}

    return validate


def test_an_untouched_notebook(failed):
    errors = failed({})
    assert set(errors) == {f'check("{e.name}")' for e in EXERCISES}
    assert all("not answered yet" in text for text in errors.values())


def test_right_answers_pass(failed):
    done = {e.name: right(e) for e in EXERCISES}
    done["pinhole.dolly_zoom"] = right(find("pinhole.dolly_zoom"), dolly_zoom)
    assert failed(done) == {}


def test_a_part_of_the_points_comes_with_its_reason_and_hint(failed):
    done = {e.name: right(e) for e in EXERCISES}
    exercise = find("pinhole.project_pinhole")
    mistake = next(m for m in exercise.misconceptions if m.name == "mirrors_what_is_behind")
    done[exercise.name] = misconceived(exercise, mistake)
    (error,) = failed(done).values()
    assert "4 of 6 points" in error
    assert " ".join(mistake.hint.split()) in " ".join(error.split())
    assert "passed some but not all" not in error
    assert max(map(len, error.splitlines())) <= 82


def test_a_syntax_error_does_not_stop_the_others(failed):
    done = {e.name: right(e) for e in EXERCISES}
    done["pinhole.dolly_zoom"] = Typed("def dolly_zoom(f, Z, Z_new):\n    return (f", 0)
    assert set(failed(done)) == {'check("pinhole.dolly_zoom")'}
