"""The lab through `course grade`: words only, a report beside the notebook, no photographs."""

import csv
import html
import re
from pathlib import Path
from types import SimpleNamespace

import nbformat
import numpy as np
import pytest
from nbgrader.api import Gradebook
from small_course import run
from walls import walled

from course_lib import lab
from course_lib.authoring.building import write_notebook
from course_lib.authoring.expansion import REPORT, expand
from course_lib.authoring.lesson import read_lesson
from course_lib.cli import main
from course_lib.lab.report import FILE, read_report
from course_lib.lab.supplied import TARGET_AIMS
from data_generators import desk
from data_generators.classes import Simulation, Submission, write_submissions
from data_generators.phone import write_photograph

ROOT = Path(__file__).resolve().parents[2]
pytestmark = [pytest.mark.slow, walled]
LAB = "12_lab"
#: What somebody types who has photographs, and a name.
OWN = {
    'photographs = "supplied"': 'photographs = "mine"',
    '"desk_15.jpg"': '"IMG_0015.JPG"',
    '"desk_16.jpg", "desk_17.jpg"': '"IMG_0016.JPG", "IMG_0017.JPG"',
    'name = ""': 'name = "Ada"',
}


def retyped(submission, student, changes):
    """Return a submission with other words in its code."""
    notebook = nbformat.reads(submission.content, as_version=4)
    for cell in (c for c in notebook.cells if c.cell_type == "code"):
        for given, typed in changes.items():
            cell.source = cell.source.replace(given, typed)
    return Submission(student, nbformat.writes(notebook).encode(), {})


@pytest.fixture(scope="module")
def handed_in(tmp_path_factory):
    """A report on four photographs that are nowhere when it is graded."""
    home = tmp_path_factory.mktemp("home")
    for number, aim in enumerate(TARGET_AIMS[1:5]):
        rng = np.random.default_rng(number)
        write_photograph(home / f"{number}.jpg", aim, (640, 480), rng, 0.6, 2.0, quality=92)
    work = lab.calibrate(lab.look("mine", home, desk.TARGET, ("0.jpg",)))
    return lab.write_report(work, [], home, pointing=0.5, scale=0.001, name="Ada").read_bytes()


@pytest.fixture(scope="module")
def evening(new_term, handed_in):
    """A term with three labs, graded."""
    term = new_term("lab", [])
    lesson = read_lesson(ROOT / f"lessons/{LAB}.md")
    write_notebook(expand(lesson), term / "source" / LAB / f"{LAB}.ipynb")
    generated = run("nbgrader", "generate_assignment", LAB, cwd=term)
    assert generated.returncode == 0, generated.stderr
    released = nbformat.read(term / "release" / LAB / f"{LAB}.ipynb", as_version=4)
    supplied = Simulation(released, "lab").hand_in("supplied", {})
    forgot = Simulation(released, "lab").hand_in("forgot", {}, words="")
    cut = Submission("cut", supplied.content[:5000], None)
    write_submissions(term, LAB, [supplied, retyped(supplied, "own", OWN), forgot, cut])
    for student in ("supplied", "own"):
        (term / "submitted" / student / LAB / FILE).write_bytes(handed_in)
    config = term / "nbgrader_config.py"
    config.write_text(config.read_text() + "c.AnswerOutside.cell_seconds = 1\n")
    return SimpleNamespace(term=term, done=run("course", "grade", LAB, cwd=term))


def outputs(term, student):
    """Return the text and pictures of a graded notebook's cells: all, and those of the report."""
    notebook = nbformat.read(term / "autograded" / student / LAB / f"{LAB}.ipynb", as_version=4)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    (report,) = [c for c in code if c.metadata.get("nbgrader", {}).get("grade_id") == REPORT]
    everything = " ".join(str(output) for cell in code for output in cell.outputs)
    return " ".join(everything.split()), report.outputs


def text_of(path):
    return " ".join(html.unescape(re.sub(r"<[^>]+>", " ", path.read_text("utf-8"))).split())


@pytest.mark.parametrize("student", ["supplied", "own"])
def test_the_report_is_shown_as_it_was_handed_in(evening, handed_in, student, tmp_path):
    (tmp_path / FILE).write_bytes(handed_in)
    said, shown = outputs(evening.term, student)
    (picture,) = [o for o in shown if o.output_type == "display_data"]
    held = read_report(tmp_path / FILE)
    assert picture.data["image/png"] == held["png"]
    assert picture.data["text/plain"] == held["words"]
    assert (evening.term / "autograded" / student / LAB / FILE).read_bytes() == handed_in
    assert ("There is no folder ../12_lab_photographs" in said) == (student == "own")


def test_who_forgets_the_report_gets_none_from_the_grader(evening):
    _, (shown,) = outputs(evening.term, "forgot")
    assert shown.text.startswith("There is no lab_report.html beside this notebook")


def test_photographs_that_take_too_long_cost_the_pictures_only(evening):
    said, _ = outputs(evening.term, "own")
    assert "This cell was stopped after 1 seconds of computing" in said
    assert evening.done.returncode == 1, evening.done.stderr
    assert "cut: The notebook's file is damaged" in evening.done.stdout
    assert "12_lab: 3 graded." in evening.done.stdout
    assert "Its answers are read by a person" in evening.done.stdout


def rows(term, capsys):
    """Write the tables; return what Canvas gets of each student, and what was said."""
    assert main(["export", LAB, "--term", str(term)]) == 0
    with (term / "export/canvas.csv").open(encoding="utf-8", newline="") as file:
        return {row[3]: row[-1] for row in csv.reader(file)}, capsys.readouterr().out


def test_report_and_tables_say_that_a_person_reads(evening, capsys):
    assert main(["report", LAB, "--term", str(evening.term)]) == 0
    page = text_of(evening.term / f"report/{LAB}/index.html")
    assert "4 students, 4 handed in, 3 graded. Half of the class has 0 of 22 points" in page
    assert "10 answers wait for a person" in page
    assert "All points are given by a person." in page
    assert "explain_camera : 2 to read, in formgrader. own , supplied" in page
    assert "not graded yet" not in page
    assert "1 student handed in what cannot be graded." in page
    own = text_of(evening.term / f"report/{LAB}/students/own.html")
    assert "Not read yet. There are 22 points." in own
    points, said = rows(evening.term, capsys)
    assert [points[name] for name in ("cut", "forgot", "own", "supplied")] == ["", "0", "", ""]
    assert "not graded, so the cell is empty: cut." in said
    assert "not read yet, so the cell is empty: own, supplied." in said


def test_what_a_person_gives_is_what_is_exported(evening, capsys):
    url = f"sqlite:///{evening.term}/gradebook.db"
    with Gradebook(url) as gradebook:
        grade = gradebook.find_grade("lab-explain_camera", LAB, LAB, "own")
        grade.manual_score, grade.needs_manual_grade = 3.5, False
        gradebook.db.commit()
    points, said = rows(evening.term, capsys)
    assert points["own"] == "3.5"
    assert "1 of 3 students have answers that wait for a person" in said
