"""Submissions that cheat, steal and destroy, against the real walls."""

import os
import re
import socket
import time
from dataclasses import replace
from pathlib import Path

import pytest
from attacks import FORGERIES, HARM, LEAKS, OUTSIDE, RIGHT, VALUES, Attack
from attacks.attack import body
from nbformat.v4 import new_code_cell, new_notebook
from walls import walled

from course_lib.exercises import find
from course_lib.grading.marking import CRASH, REASONS, mark
from course_lib.grading.outside import Judge, Submitted
from course_lib.grading.seeding import write_key
from course_lib.grading.submissions import files_beside
from course_lib.judging import pose, seed_for
from course_lib.judging.text import to_text
from course_lib.sandbox.limits import Allowance

pytestmark = [pytest.mark.slow, walled]
SECOND = (
    "def pixel_focal_length(focal_length, sensor_size, image_size):\n"
    "    return tuple(focal_length * n / s for n, s in zip(image_size, sensor_size))"
)
SMALL = Allowance(
    cell_seconds=1.5,
    notebook_seconds=5.0,
    answer_seconds=1.0,
    total_seconds=20.0,
    processor_seconds=30.0,
    memory=1_500_000_000,
    processes=40,
    files=60_000_000,
    output=20_000,
)
SEED = "a seed"


@pytest.fixture(scope="module")
def judge():
    with Judge("bubblewrap", SMALL) as judge:
        yield judge


def checked(name: str):
    flags = {"grade": True, "solution": False, "locked": True, "grade_id": name, "points": 4}
    return new_code_cell(f'check("pinhole.{name}")', metadata={"nbgrader": flags})


def notebook(attack: Attack, after: str = ""):
    setup = new_code_cell(
        "import numpy as np\nfrom course_lib.notebook import check",
        metadata={"nbgrader": {"locked": True, "grade": False, "grade_id": "setup"}},
    )
    cells = [new_code_cell(source) for source in (attack.cell, attack.answer, SECOND, after)]
    return new_notebook(
        cells=[
            setup, cells[0], cells[1], checked("dolly_zoom"), cells[2],
            checked("pixel_focal_length"), cells[3],
        ]
    )  # fmt: skip


def graded(judge, attack: Attack, after: str = "", files=None):
    """Return the points of both answers, and all words that reach a person.

    Wherever points are lost, there is a sentence.
    """
    submitted = notebook(attack, after)
    outcome = judge.judge(Submitted(submitted, SEED, (), files or {}))
    mark(submitted, outcome)
    verdicts = [outcome.verdicts[k] for k in sorted(outcome.verdicts)]
    points = [0.0 if verdict is None else verdict.points for verdict in verdicts]
    for place, verdict in outcome.verdicts.items():
        if verdict is None:
            assert submitted.cells[place].outputs[0].evalue in {CRASH, *REASONS.values()}
        else:
            lost = [part.feedback.message for part in verdict.parts if part.points < part.possible]
            assert all(re.search(r"\w+ \w+ \w+.*[.?]$", message) for message in lost), lost
    words = [to_text(verdict) for verdict in verdicts if verdict is not None]
    words += [str(cell.outputs) for cell in submitted.cells]
    return points, "\n".join(words)


@pytest.fixture(autouse=True, scope="module")
def everybody_is_well(judge):
    """An honest submission gets its points before and after all attacks."""
    honest = Attack("1 + 1", RIGHT)
    assert graded(judge, honest)[0] == [4.0, 4.0]
    yield
    assert graded(judge, honest)[0] == [4.0, 4.0]


@pytest.mark.parametrize("name", [*FORGERIES, *VALUES])
def test_no_point_is_gained(judge, name):
    attack = FORGERIES.get(name) or VALUES[name]
    points, words = graded(judge, attack)
    assert points[0] == attack.first
    assert attack.second is None or points[1] == attack.second
    assert attack.says in words


def hidden_numbers():
    """Return the beginnings of the hidden focal lengths."""
    exercise = find("pinhole.dolly_zoom")
    cases = pose(exercise, seed_for(SEED, exercise.name))
    numbers = [repr(float(next(iter(case.inputs.values()))))[:6] for case in cases]
    return [*numbers, *(number.replace(".", "") for number in numbers)]


@pytest.mark.parametrize("name", LEAKS)
def test_no_hidden_input_comes_out(judge, name):
    prints = "import os\nif os.path.exists('/tmp/seen'): print(open('/tmp/seen').read())"
    points, words = graded(judge, Attack(answer=LEAKS[name]), prints)
    assert points == [0.0, 4.0]
    assert not re.search(r"secret\s*[\d_]", words)
    assert [number for number in hidden_numbers() if number in words] == []


@pytest.fixture(scope="module")
def patient_judge():
    """Taking memory takes time on a busy machine; what ends these must be the memory."""
    allowance = replace(SMALL, cell_seconds=40.0, notebook_seconds=50.0, total_seconds=60.0)
    with Judge("bubblewrap", allowance, 1) as judge:
        yield judge


@pytest.mark.parametrize("name", HARM)
def test_harm_stays_inside_and_ends_in_time(judge, patient_judge, name):
    attack, start = HARM[name], time.monotonic()
    points, words = graded(patient_judge if "memory" in name else judge, attack)
    assert time.monotonic() - start < 60
    assert points[0] == attack.first
    assert attack.second is None or points[1] == attack.second
    assert attack.says in words
    assert len(words) < 500_000
    assert graded(judge, Attack("import os; print(os.listdir('/tmp'))", RIGHT))[0] == [4.0, 4.0]


def test_an_answer_that_has_to_wait_is_right_and_one_that_waits_for_ever_ends(judge):
    waits = body("time.sleep(left.pop())", "return focal_length * new_distance / distance")
    some_time = f"import time\nleft = [*[0] * 99, {1.3 * SMALL.answer_seconds}]"
    assert graded(judge, Attack(some_time, waits))[0] == [4.0, 4.0]
    start = time.monotonic()
    points, words = graded(judge, Attack("import time\nleft = [600]", waits))
    assert (points, time.monotonic() - start < 20) == ([0.0, 4.0], True)
    assert "Does a loop never end" in words


def test_all_answers_together_end_with_the_time_of_the_submission():
    short, start = replace(SMALL, cell_seconds=9.0, total_seconds=8.0), time.monotonic()
    with Judge("bubblewrap", short, 2) as judge:
        sleeps = body("import time", "time.sleep(600)")
        points, words = graded(judge, Attack(answer=sleeps))
    assert (points, time.monotonic() - start < 30) == ([0.0, 0.0], True)
    assert words.count("Does a loop never end") >= 1
    assert "Not tried, because an answer before it took too long" in words
    assert "a crash" not in words


@pytest.fixture(scope="module")
def outside(tmp_path_factory):
    """A term with secrets, and a server on this machine."""
    term = tmp_path_factory.mktemp("term")
    write_key(term / "grading.key")
    (term / "gradebook.db").write_bytes(b"scores")
    other = term / "submitted/ada/01_pinhole"
    other.mkdir(parents=True)
    (other / "01_pinhole.ipynb").write_text("{}")
    (other / "key.link").symlink_to(term / "grading.key")
    with socket.create_server(("127.0.0.1", 0)) as server:
        yield {
            "key": str(term / "grading.key"),
            "gradebook": str(term / "gradebook.db"),
            "other": str(other / "01_pinhole.ipynb"),
            "term": str(term),
            "course": str(Path(find.__code__.co_filename)),
            "grader": os.getpid(),
            "port": server.getsockname()[1],
            "home": str(Path.home() / ".config"),
            "folder": other,
        }
    assert (term / "gradebook.db").read_bytes() == b"scores"


@pytest.mark.parametrize("name", OUTSIDE)
def test_nothing_outside_is_reached(judge, outside, name):
    code = OUTSIDE[name].format(**outside)
    cell = (
        f"try:\n    {code}\n    print('reached')\n"
        "except (OSError, AssertionError, ValueError) as error:\n    print('held', type(error))"
    )
    points, words = graded(judge, Attack(cell, RIGHT), files=files_beside(outside["folder"]))
    assert "reached" not in words.replace(code, "")
    assert "held" in words
    assert points == [4.0, 4.0]


def test_the_environment_holds_no_secret(judge, outside):
    cell = "import os\nprint(dict(os.environ))\nprint(open('/proc/1/cmdline').read())"
    _, words = graded(judge, Attack(cell, RIGHT))
    assert SEED not in words
    assert str(outside["term"]) not in words


def test_what_is_shown_to_the_grader_is_no_program(judge):
    cell = "from IPython.display import HTML, Javascript\nHTML('<script>steal()</script>')"
    _, words = graded(judge, Attack(cell, RIGHT))
    assert "<script>" not in words
