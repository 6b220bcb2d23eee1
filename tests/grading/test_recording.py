"""The one writer: what a submission brings along cannot stop it."""

import json

import pytest
from nbgrader.api import Gradebook

from course_lib.grading import recording
from course_lib.grading.assignment import read_assignment
from course_lib.grading.one import Graded
from course_lib.grading.receipts import write_receipts
from course_lib.grading.recording import Recorder, is_graded
from course_lib.grading.submissions import fingerprint

pytestmark = pytest.mark.slow
ASSIGNMENT = "01_pinhole"


@pytest.fixture
def assignment(new_term):
    return read_assignment(new_term("recorded", ["right"]), ASSIGNMENT)


def graded(assignment, **more):
    mark = fingerprint(assignment.submitted("right"), [ASSIGNMENT])
    return Graded("right", mark, notebooks={ASSIGNMENT: b"{}\n"}, **more)


def save(assignment, what):
    with recording.recording(assignment) as recorder:
        return recorder.save(what)


def test_all_is_written_and_nothing_is_left_over(assignment):
    saved = save(assignment, graded(assignment, notes=("half a letter \udc80",)))
    assert saved.trouble == ""
    final = assignment.autograded("right")
    assert (final / f"{ASSIGNMENT}.ipynb").read_bytes() == b"{}\n"
    assert [path.name for path in final.parent.iterdir()] == [ASSIGNMENT]
    record = json.loads(assignment.record("right").read_text())
    assert record["notes"] == ["half a letter \udc80"]
    assert "notebooks" not in record


class Killed(BaseException):
    """What a kill is to a program: nothing handles it."""


def test_ended_before_a_new_version_took_its_place_it_is_done_again(assignment, monkeypatch):
    def end(*_):
        raise Killed

    save(assignment, graded(assignment))
    (assignment.submitted("right") / "helper.py").write_text("factor = 1")
    with monkeypatch.context() as patch:
        patch.setattr(Recorder, "_put_in_place", end)
        with pytest.raises(Killed):
            save(assignment, graded(assignment))
    assert not is_graded(assignment, "right")
    save(assignment, graded(assignment))
    assert is_graded(assignment, "right")
    assert (assignment.autograded("right") / "helper.py").exists()


@pytest.mark.parametrize("step", ["copy_beside", "_penalize", "_write", "_put_in_place"])
def test_ended_between_any_two_steps_it_is_done_again(assignment, step, monkeypatch):
    def end(*_):
        raise Killed

    cell = "pinhole-dolly_zoom-check"
    what = graded(assignment, grades={ASSIGNMENT: {cell: 4.0}})
    where = recording if hasattr(recording, step) else Recorder
    with monkeypatch.context() as patch:
        patch.setattr(where, step, end)
        with pytest.raises(Killed):
            save(assignment, what)
    assert not is_graded(assignment, "right")
    assert not assignment.autograded("right").exists()
    with Gradebook(assignment.db_url, assignment.course_id) as gradebook:
        before = [s.score for s in gradebook.assignment_submissions(ASSIGNMENT)]
    assert before == ([] if step in ("copy_beside", "_penalize") else [4.0])  # all or nothing
    save(assignment, what)
    assert is_graded(assignment, "right")
    with Gradebook(assignment.db_url, assignment.course_id) as gradebook:
        assert [s.score for s in gradebook.assignment_submissions(ASSIGNMENT)] == [4.0]
    assert [path.name for path in assignment.autograded("right").parent.iterdir()] == [ASSIGNMENT]


def test_a_file_in_the_place_of_a_folder_costs_its_own_submission_only(assignment):
    (assignment.source() / "pictures").mkdir()
    (assignment.source() / "pictures/one.txt").write_text("")
    (assignment.submitted("right") / "pictures").write_text("")
    saved = save(
        assignment, graded(assignment, grades={ASSIGNMENT: {"pinhole-dolly_zoom-check": 4.0}})
    )
    assert "The notebook could not be graded (FileExistsError" in saved.trouble
    assert not assignment.autograded("right").exists()
    assert not is_graded(assignment, "right")
    with Gradebook(assignment.db_url, assignment.course_id) as gradebook:
        assert gradebook.find_submission(ASSIGNMENT, "right").score == 0


def test_a_time_that_is_none_counts_as_no_time(assignment):
    (assignment.submitted("right") / "timestamp.txt").write_text("yesterday, honestly")
    assert save(assignment, graded(assignment)).trouble == ""
    with Gradebook(assignment.db_url, assignment.course_id) as gradebook:
        assert gradebook.find_submission(ASSIGNMENT, "right").timestamp is None


@pytest.fixture
def due(new_term):
    """An assignment with a deadline, after which all points are taken off."""
    term = new_term("due", ["right"])
    with (term / "nbgrader_config.py").open("a") as file:
        file.write('c.LateSubmissionPlugin.penalty_method = "zero"\n')
    found = read_assignment(term, ASSIGNMENT)
    with Gradebook(found.db_url, found.course_id) as gradebook:
        gradebook.update_or_create_assignment(ASSIGNMENT, duedate="2026-10-02 12:00:00 UTC")
    return found


def hand_in_at(assignment, time):
    (assignment.submitted("right") / "timestamp.txt").write_text(time)


def time_and_score(assignment):
    with Gradebook(assignment.db_url, assignment.course_id) as gradebook:
        found = gradebook.find_submission(ASSIGNMENT, "right")
        return str(found.timestamp), found.score - found.late_submission_penalty


def test_handed_in_again_unchanged_it_gets_the_new_time_and_its_penalty(due, monkeypatch):
    def end(*_):
        raise Killed

    early, late = "2026-10-02 11:00:00 UTC", "2026-10-02 13:00:00 UTC"
    hand_in_at(due, early)
    save(due, graded(due, grades={ASSIGNMENT: {"pinhole-dolly_zoom-check": 4.0}}))
    assert time_and_score(due) == ("2026-10-02 11:00:00", 4.0)
    hand_in_at(due, late)
    assert is_graded(due, "right")
    with recording.recording(due) as recorder:
        for where, step in ((Recorder, "_penalize"), (recording, "_write")):
            with monkeypatch.context() as patch:
                patch.setattr(where, step, end)
                with pytest.raises(Killed):
                    recorder.note_time("right")
        assert recorder.note_time("right")
        assert time_and_score(due) == ("2026-10-02 13:00:00", 0.0)
        assert not recorder.note_time("right")
        (due.submitted("right") / "timestamp.txt").unlink()  # as if it had come by mail
        assert recorder.note_time("right")
        assert not recorder.note_time("right")
        hand_in_at(due, late)  # at the time that it had before
        assert recorder.note_time("right")
        assert time_and_score(due) == ("2026-10-02 13:00:00", 0.0)
        (due.submitted("right") / "timestamp.txt").unlink()
        assert recorder.note_time("right")
    assert time_and_score(due) == ("None", 4.0)
    assert is_graded(due, "right")


def test_a_receipt_is_not_taken_for_a_time(assignment):
    (assignment.submitted("right") / "timestamp.txt").unlink(missing_ok=True)
    save(assignment, graded(assignment))
    final = assignment.autograded("right")
    write_receipts([str(final / f"{ASSIGNMENT}.ipynb")])
    with recording.recording(assignment) as recorder:
        assert not recorder.note_time("right")
    assert (final / "timestamp.txt").exists()


def test_a_file_beside_the_notebook_is_a_part_of_it(assignment):
    helper = assignment.submitted("right") / "deep/helper.py"
    helper.parent.mkdir()
    helper.write_text("factor = 1")
    save(assignment, graded(assignment))
    assert is_graded(assignment, "right")
    helper.write_text("factor = 2")
    assert not is_graded(assignment, "right")
    save(assignment, graded(assignment))
    hand_in_at(assignment, "2026-10-02 13:00:00 UTC")
    assert is_graded(assignment, "right")


def test_what_nbgraders_own_command_graded_is_graded_until_it_comes_at_another_time(assignment):
    early, late = "2026-10-02 11:00:00 UTC", "2026-10-02 13:00:00 UTC"
    hand_in_at(assignment, early)
    assert not is_graded(assignment, "right")
    final = assignment.autograded("right")
    final.mkdir(parents=True)
    assert not is_graded(assignment, "right")
    (final / "timestamp.txt").write_text(early)
    assert is_graded(assignment, "right")
    hand_in_at(assignment, late)
    assert not is_graded(assignment, "right")


def by_hand(assignment, points=None):
    """Enter points by hand, if any; return whether a person must look at them."""
    cell = "pinhole-dolly_zoom-check"
    with Gradebook(assignment.db_url, assignment.course_id) as gradebook:
        grade = gradebook.find_grade(cell, ASSIGNMENT, ASSIGNMENT, "right")
        if points is not None:
            grade.manual_score, grade.needs_manual_grade = points, False
            gradebook.db.commit()
        assert grade.manual_score in (None, 3.0)
        return grade.needs_manual_grade


def test_points_by_hand_stay_and_are_looked_at_again_if_anything_changed(assignment):
    def again(score):
        save(
            assignment, graded(assignment, grades={ASSIGNMENT: {"pinhole-dolly_zoom-check": score}})
        )
        return by_hand(assignment)

    assert not again(4.0)
    by_hand(assignment, 3.0)
    assert not again(4.0)
    assert again(2.0)
    by_hand(assignment, 3.0)
    (assignment.submitted("right") / "helper.py").write_text("factor = 1")
    assert again(2.0)
