"""A whole class through `course grade`: the same scores as by nbgrader's own command, and safe."""

import fcntl
import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from nbgrader.api import Gradebook
from small_course import run
from walls import walled

from course_lib.authoring.expansion import check_id
from course_lib.cli import main

pytestmark = [pytest.mark.slow, walled]
ASSIGNMENT = "01_pinhole"
#: Seconds until a run on a busy machine counts as stuck.
PATIENCE = 400
#: Graded by nbgrader's own command before; see conftest.
BY_NBGRADER = ("right", "misconception-1", "killed", "pasted-copies", "deleted-cells")
QUESTION = "pinhole-explain_flat_faces"
UNREADABLE = {
    "cut-off": "The notebook's file is damaged (line",
    "empty-file": "The file is empty",
    "renamed": "There is no 01_pinhole.ipynb, but my homework (final).ipynb",
}


@pytest.fixture(scope="module")
def term(graded):
    return graded.term


@pytest.fixture(scope="module")
def command(graded):
    return graded.course


def scores(term):
    """Return all that the gradebook holds of the scores."""
    with Gradebook(f"sqlite:///{term}/gradebook.db") as gradebook:
        return {
            submission.student.id: {
                grade.name: (grade.auto_score, grade.manual_score, grade.needs_manual_grade)
                for notebook in submission.notebooks
                for grade in notebook.grades
            }
            for submission in gradebook.assignment_submissions(ASSIGNMENT)
        }


def test_the_summary_says_what_to_tell_whom(command, submissions):
    assert command.returncode == 1, command.stderr
    readable = {name for name, s in submissions.items() if s.points is not None}
    before = readable & set(BY_NBGRADER)
    done = f"{len(readable - before)} graded, {len(before)} were graded before."
    assert f"{ASSIGNMENT}: {done}" in command.stdout
    for student, sentence in UNREADABLE.items():
        assert f"{student}: {sentence}" in command.stdout
    assert "copied-out: put back: setup" in command.stdout
    numbers = r"pinhole\.project_pinhole +\d\.\d/6 +\d+% +\d+ +\d+  [a-z ]+ \(\d\)"
    assert re.search(numbers, command.stdout)
    assert "Warning" not in command.stderr


def test_what_was_graded_is_not_graded_again(term, command):
    place = term / "autograded/rewritten" / ASSIGNMENT
    before = place.stat().st_mtime_ns
    again = run("course", "grade", ASSIGNMENT, "--student", "right", "rewritten", cwd=term)
    assert again.returncode == 0, again.stderr
    assert "0 graded, 2 were graded before" in again.stdout
    assert place.stat().st_mtime_ns == before


def test_grading_again_changes_nothing_and_keeps_what_a_person_gave(term, command):
    with Gradebook(f"sqlite:///{term}/gradebook.db") as gradebook:
        grade = gradebook.find_grade(QUESTION, ASSIGNMENT, ASSIGNMENT, "rewritten")
        grade.manual_score, grade.needs_manual_grade = 3.5, False
        other = gradebook.find_grade(
            check_id("pinhole.dolly_zoom"), ASSIGNMENT, ASSIGNMENT, "misconception-2"
        )
        other.manual_score, other.extra_credit, other.needs_manual_grade = 2.0, 1.0, False
        gradebook.db.commit()
    before = scores(term)
    again = run(
        "course",
        "grade",
        ASSIGNMENT,
        "--force",
        "--student",
        "rewritten",
        "misconception-2",
        cwd=term,
    )
    assert again.returncode == 0, again.stderr
    assert scores(term) == before
    assert before["rewritten"][QUESTION] == (None, 3.5, False)


def test_a_changed_answer_asks_for_a_second_look(new_term, submissions):
    term = new_term("changed", ["right", "half-done"])
    assert run("course", "grade", ASSIGNMENT, cwd=term).returncode == 0
    with Gradebook(f"sqlite:///{term}/gradebook.db") as gradebook:
        grade = gradebook.find_grade(QUESTION, ASSIGNMENT, ASSIGNMENT, "right")
        grade.manual_score, grade.needs_manual_grade = 3.5, False
        gradebook.db.commit()
    path = term / "submitted/right" / ASSIGNMENT / f"{ASSIGNMENT}.ipynb"
    path.write_bytes(submissions["misconception-1"].content)
    stamp = term / "submitted/half-done" / ASSIGNMENT / "timestamp.txt"
    stamp.write_text("2026-10-02 13:00:00 UTC")
    again = run("course", "grade", ASSIGNMENT, cwd=term)
    assert "1 graded, 1 were graded before" in again.stdout
    assert "so that only the new time counts: half-done." in again.stdout
    assert scores(term)["right"][QUESTION] == (None, 3.5, True)
    assert scores(term)["right"][check_id("pinhole.project_pinhole")][0] < 6

    path.write_bytes(b"{")  # a broken file comes after a good one: the grade stays
    assert run("course", "grade", ASSIGNMENT, cwd=term).returncode == 1
    assert scores(term)["right"][QUESTION] == (None, 3.5, True)


def start(term, *options):
    program = [str(Path(sys.executable).with_name("course")), "grade", ASSIGNMENT, *options]
    return subprocess.Popen(
        program, cwd=term, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )


def records(term):
    return {path.stem: path for path in (term / "grading" / ASSIGNMENT).glob("*.json")}


HONEST = ("right", "rewritten", "half-done", "misconception-2", "misconception-5", "copied-out")


def test_a_killed_worker_costs_nothing(new_term):
    term = new_term("worker", HONEST[:4])
    process, limit = start(term, "--workers", "2"), time.monotonic() + PATIENCE
    hit = set()
    while process.poll() is None and len(hit) < 2 and time.monotonic() < limit:
        listed = f"/proc/{process.pid}/task/{process.pid}/children"
        for child in Path(listed).read_text().split() if Path(listed).exists() else []:
            if records(term) and child not in hit and len(hit) < 2:
                os.kill(int(child), signal.SIGKILL)
                hit.add(child)
        time.sleep(0.02)
    out, err = process.communicate(timeout=PATIENCE)
    assert len(hit) == 2
    assert process.returncode == 0, err
    assert "4 graded" in out


def test_two_at_once_are_refused(new_term):
    term = new_term("twice", ["right"])
    (term / "grading").mkdir()
    with (term / "grading/.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        second = run("course", "grade", ASSIGNMENT, cwd=term)
    assert second.returncode == 2
    assert "another `course grade` is at work" in second.stderr
    assert not (term / "autograded").exists()


def test_the_record_says_what_was_wrong_and_nothing_hidden(term, command):
    record = json.loads(records(term)["misconception-2"].read_text(encoding="utf-8"))
    found = record["exercises"]["pinhole.pixel_focal_length"]
    assert found["misconceptions"]
    assert found["points"] < found["possible"] == 4
    assert record["trouble"] == ""


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (["02_nothing"], "there is no assignment '02_nothing' in the gradebook; it has 01_pinhole"),
        ([ASSIGNMENT, "--student", "nobody"], "nothing was handed in for 01_pinhole by nobody"),
        ([], "name an assignment"),
        ([ASSIGNMENT, "--term", "/"], "is no term's directory"),
    ],
)
def test_errors_say_what_to_do(term, options, sentence, monkeypatch, capsys):
    monkeypatch.chdir(term)
    assert main(["grade", *options]) == 2
    assert sentence in capsys.readouterr().err


def test_without_walls_it_is_refused_unless_told_otherwise(new_term, monkeypatch, tmp_path):
    term = new_term("unprotected", ["right"])
    monkeypatch.setenv("PATH", str(tmp_path))  # no bwrap here
    refused = run("course", "grade", ASSIGNMENT, cwd=term)
    assert refused.returncode == 2
    assert "bubblewrap is not installed" in refused.stderr
    assert not (term / "autograded").exists()
    trusted = run("course", "grade", ASSIGNMENT, "--isolation", "none", cwd=term)
    assert trusted.returncode == 0, trusted.stderr
    assert "Nothing is isolated" in trusted.stderr
    assert sum(score or 0 for score, *_ in scores(term)["right"].values()) == 41
