"""A class in which twenty attack at once and five are honest, through an evening's commands."""

import json
import os
import re
from dataclasses import replace

import nbformat
import pytest
from attacks import FORGERIES, HARM, LEAKS, RIGHT, VALUES, Attack
from attacks.attack import body
from nbformat.v4 import new_code_cell, new_markdown_cell, new_raw_cell
from nbgrader.api import Gradebook
from small_course import run
from walls import walled

from course_lib.authoring.expansion import check_id, grade_id
from course_lib.exercises import all_exercises
from course_lib.judging import Exercise
from data_generators.classes import Submission, write_submissions

pytestmark = [pytest.mark.slow, walled]
ASSIGNMENT = "01_pinhole"
TARGET = "pinhole.dolly_zoom"
HONEST = ("right", "rewritten", "half-done", "misconception-2", "copied-out")
PAGE = "<script>document.title = 'stolen'</script><img src=x onerror=alert(1)>"
#: Attacks from the catalogue that are tried while others are graded.
CODE = {
    "forger": FORGERIES["forges messages"],
    "thief": FORGERIES["looks for sources in the frames of a run that has others"],
    "liar": VALUES["a generator"],
    "teller": Attack(answer=LEAKS["in the exception's text"]),
    "shaper": Attack(answer=LEAKS["as an empty shape"]),
    "killer": HARM["kills everybody"],
    "leaver": HARM["ends Python"],
    "demon": HARM["leaves a daemon"],
    "crowd": HARM["leaves busy grandchildren"],
    "bomber": HARM["forks without end"],
    "glutton": HARM["takes memory"],
    "filler": HARM["fills the temporary folder"],
    "talker": HARM["prints fifty megabytes"],
    "flood": HARM["displays a million times"],
    "wizard": HARM["writes magics"],
    "sleeper": Attack(answer=body("import time", "time.sleep(60)"), says="Does a loop never end"),
}


def with_attack(submission, name, attack):
    """Return a right submission with an attack as its first cell and in one answer."""
    notebook = nbformat.reads(submission.content, as_version=4)
    for cell in notebook.cells:
        if cell.metadata.get("nbgrader", {}).get("grade_id") == grade_id(TARGET):
            cell.source = attack.answer
    notebook.cells.insert(0, new_code_cell(attack.cell))
    return Submission(name, nbformat.writes(notebook).encode(), None)


def hostile_files(submission):
    """Return right submissions whose file is an attack."""
    notebook = nbformat.reads(submission.content, as_version=4)
    for cell in notebook.cells:
        cell.metadata["tags"] = [PAGE]
        if "nbgrader" in cell.metadata:
            cell.metadata["nbgrader"] |= {"points": 100.0, "locked": False, "grade": True}
        if cell.cell_type == "code":
            cell.metadata["max_execution"], cell.outputs = 9, []
    notebook.metadata["kernelspec"] = {"name": PAGE, "display_name": PAGE, "argv": ["/bin/sh"]}
    notebook.metadata["language_info"] = {"name": PAGE, "pygments_lexer": PAGE}
    notebook.metadata["title"] = PAGE
    notebook.cells.append(new_markdown_cell(PAGE, attachments={"a": {"text/html": PAGE}}))
    notebook.cells.append(new_raw_cell(PAGE, metadata={"raw_mimetype": "text/html"}))
    yield replace(submission, student="labeller", content=nbformat.writes(notebook).encode())
    tree = json.loads(submission.content)
    empty = {"cell_type": "markdown", "id": "a", "metadata": {}, "source": ""}
    tree["cells"] += [empty | {"id": f"a{k}"} for k in range(5000)]
    yield replace(submission, student="many-cells", content=json.dumps(tree).encode())
    half = submission.content.replace(b"def dolly_zoom", b"# \\ud800\\ndef dolly_zoom", 1)
    yield replace(submission, student="half-letter", content=half)
    name = "\x1b]0;stolen\x07=HYPERLINK(1).ipynb"
    yield replace(submission, student="named", filename=name)


def put_traps(term):
    """Put what is no notebook beside, or in the place of, right ones."""
    folder = term / "submitted/trapper" / ASSIGNMENT
    (folder / "key.link").symlink_to(term / "grading.key")
    (folder / "gradebook.db").write_bytes(b"mine")
    os.mkfifo(folder / "fifo")
    (folder / "timestamp.txt").unlink()
    os.mkfifo(folder / "timestamp.txt")
    pipe = term / "submitted/piper" / ASSIGNMENT
    (pipe / f"{ASSIGNMENT}.ipynb").unlink()
    os.mkfifo(pipe / f"{ASSIGNMENT}.ipynb")
    litter = term / "submitted/litterer" / ASSIGNMENT
    for k in range(1100):
        (litter / f"{k}").touch()
    odd = os.fsencode(term / "submitted/renamer" / ASSIGNMENT)
    os.rename(odd + f"/{ASSIGNMENT}.ipynb".encode(), odd + b"/\xff\xfe.ipynb")


def outside(term):
    """Return all that must be the same afterwards."""
    kept = ("grading.key", "nbgrader_config.py", "release", "source", "submitted")
    paths = [p for name in kept for p in (term / name, *(term / name).rglob("*"))]
    return {str(p): p.read_bytes() for p in paths if p.is_file() and not p.is_symlink()}


@pytest.fixture(scope="module")
def evening(new_term, submissions):
    """The term after grading, the report, the export and the feedback."""
    term = new_term("hostile-class", HONEST)
    right = submissions["right"]
    attackers = [with_attack(right, name, attack) for name, attack in CODE.items()]
    attackers += hostile_files(right)
    attackers += [replace(right, student=s) for s in ("trapper", "piper", "litterer", "renamer")]
    write_submissions(term, ASSIGNMENT, attackers)
    put_traps(term)
    config = term / "nbgrader_config.py"
    config.write_text(config.read_text() + "c.AnswerOutside.cell_seconds = 3\n")
    before = outside(term)
    done = run("course", "grade", ASSIGNMENT, "--workers", "2", cwd=term)
    others = [run("course", word, ASSIGNMENT, cwd=term) for word in ("report", "export")]
    feedback = ("nbgrader", "generate_feedback", ASSIGNMENT, "--student")
    others += [run(*feedback, student, cwd=term) for student in ("labeller", "teller")]
    assert outside(term) == before
    return term, done, others


def points(term, student):
    """Return the automatic points by exercise."""
    with Gradebook(f"sqlite:///{term}/gradebook.db") as gradebook:
        (notebook,) = gradebook.find_submission(ASSIGNMENT, student).notebooks
        scores = {grade.name: grade.auto_score for grade in notebook.grades}
    exercises = [e.name for e in all_exercises("pinhole") if isinstance(e, Exercise)]
    return {name: scores[check_id(name)] for name in exercises}


@pytest.mark.parametrize("student", HONEST)
def test_the_honest_get_what_they_deserve(evening, submissions, student):
    assert points(evening[0], student) == submissions[student].points


def test_who_computes_long_loses_nothing_beside_a_crowd(new_term, submissions):
    """Two are graded at the same time: one starts 55 processes that compute without a pause."""
    term, right = new_term("crowded", ()), submissions["right"]
    crowd = Attack(
        "import os, time\n"
        "end = time.monotonic() + 8\n"
        "for _ in range(55):\n"
        "    if os.fork() == 0:\n"
        "        os.setsid()  # a scheduler that is fair to sessions is not fair to others then\n"
        "        time.sleep(1)\n"
        "        while time.monotonic() < end: pass\n"
        "        os._exit(0)\n"
        "print('crowded')\n"
        "time.sleep(7)",
        RIGHT,
    )
    answer = body(
        "work, start = tasks.pop(), time.process_time()",
        "while time.process_time() < start + work: pass",
        "return focal_length * new_distance / distance",
    )
    plodder = Attack("import time\ntasks = [0] * 99 + [2]", answer)
    both = {"crowd": crowd, "plodder": plodder}
    write_submissions(term, ASSIGNMENT, [with_attack(right, *one) for one in both.items()])
    done = run("course", "grade", ASSIGNMENT, "--workers", "2", cwd=term)
    assert done.returncode == 0, done.stdout
    graded = (term / f"autograded/crowd/{ASSIGNMENT}/{ASSIGNMENT}.ipynb").read_text("utf-8")
    assert '"crowded\\n"' in graded
    assert points(term, "plodder") == right.points


@pytest.mark.parametrize("student", CODE)
def test_an_attacker_gains_nothing_and_reads_why(evening, submissions, student):
    term, attack, most = evening[0], CODE[student], submissions["right"].points
    got = points(term, student)
    assert got[TARGET] == attack.first
    assert all(got[name] <= most[name] for name in most)
    if attack.second == 4.0:
        assert got == most | {TARGET: attack.first}
    page = (term / f"report/{ASSIGNMENT}/students/{student}.html").read_text(encoding="utf-8")
    graded = (term / f"autograded/{student}/{ASSIGNMENT}/{ASSIGNMENT}.ipynb").read_text("utf-8")
    assert attack.says in graded
    assert not re.search(r"secret\s*[\d_]", page + graded)


def test_files_that_attack_cost_themselves_only(evening, submissions):
    term, done, _ = evening
    most = submissions["right"].points
    assert points(term, "labeller") == points(term, "trapper") == most
    assert (term / f"autograded/trapper/{ASSIGNMENT}/gradebook.db").read_bytes() == b"mine"
    assert not (term / f"autograded/trapper/{ASSIGNMENT}/key.link").exists()
    for student, sentence in {
        "many-cells": "which is too much to grade",
        "half-letter": "its cells are not what JupyterLab writes",
        "named": f"There is no {ASSIGNMENT}.ipynb, but ?]0;stolen?=HYPERLINK(1).ipynb",
        "piper": "The notebook is no ordinary file",
        "litterer": "too large or too many",
        "renamer": f"There is no {ASSIGNMENT}.ipynb, but ??.ipynb",
    }.items():
        assert f"{student}: " in done.stdout
        assert sentence in done.stdout
    assert done.returncode == 1
    assert "\x1b" not in done.stdout + done.stderr
    assert "Traceback" not in done.stderr


def test_no_page_runs_what_they_wrote(evening):
    term, _, others = evening
    for one in others:
        assert "Traceback" not in one.stderr, one.stderr
    pages = [*term.glob("report/**/*.html"), *term.glob("feedback/*/*/*.html")]
    assert {page.parent.parent.name for page in term.glob("feedback/*/*/*.html")} == {
        "labeller",
        "teller",
    }
    assert len(pages) > 25
    for page in pages:
        text = page.read_text(encoding="utf-8")
        assert "<script>document.title" not in text, page
        assert "<img src=x" not in text, page


def test_no_process_is_left(evening):
    listed = [p for p in os.listdir("/proc") if p.isdecimal()]
    names = []
    for number in listed:
        try:
            with open(f"/proc/{number}/cmdline", "rb") as file:
                names.append(file.read())
        except OSError:
            continue
    assert [n for n in names if str(evening[0]).encode() in n] == []
