"""The one writer: what a submission brings along cannot stop it."""

import json

import pytest
from nbgrader.api import Gradebook

from course_lib.grading.assignment import read_assignment
from course_lib.grading.one import Graded
from course_lib.grading.recording import Recorder, is_graded

pytestmark = pytest.mark.slow
ASSIGNMENT = "01_pinhole"


@pytest.fixture
def assignment(new_term):
    return read_assignment(new_term("recorded", ["right"]), ASSIGNMENT)


def graded(**more):
    return Graded("right", "mark", notebooks={ASSIGNMENT: b"{}\n"}, **more)


def save(assignment, what):
    with Recorder(assignment) as recorder:
        return recorder.save(what)


def test_all_is_written_and_nothing_is_left_over(assignment):
    saved = save(assignment, graded(notes=("half a letter \udc80",)))
    assert saved.trouble == ""
    final = assignment.autograded("right")
    assert (final / f"{ASSIGNMENT}.ipynb").read_bytes() == b"{}\n"
    assert [path.name for path in final.parent.iterdir()] == [ASSIGNMENT]
    record = json.loads(assignment.record("right").read_text())
    assert record["notes"] == ["half a letter \udc80"]
    assert "notebooks" not in record


def test_a_file_in_the_place_of_a_folder_costs_its_own_submission_only(assignment):
    (assignment.source() / "pictures").mkdir()
    (assignment.source() / "pictures/one.txt").write_text("")
    (assignment.submitted("right") / "pictures").write_text("")
    saved = save(assignment, graded(grades={ASSIGNMENT: {"pinhole-dolly_zoom-check": 4.0}}))
    assert "The notebook could not be graded (FileExistsError" in saved.trouble
    assert not assignment.autograded("right").exists()
    assert not is_graded(assignment, "right")
    with Gradebook(assignment.db_url, assignment.course_id) as gradebook:
        assert gradebook.find_submission(ASSIGNMENT, "right").score == 0


def test_a_time_that_is_none_counts_as_no_time(assignment):
    (assignment.submitted("right") / "timestamp.txt").write_text("yesterday, honestly")
    assert save(assignment, graded()).trouble == ""
    with Gradebook(assignment.db_url, assignment.course_id) as gradebook:
        assert gradebook.find_submission(ASSIGNMENT, "right").timestamp is None
