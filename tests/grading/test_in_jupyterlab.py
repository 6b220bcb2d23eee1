"""nbgrader's buttons in a real JupyterLab: formgrader for the instructor, Validate for students."""

import json

import nbformat
import pytest
from lab import Lab, browser, chromium, open_notebook
from nbgrader.api import Gradebook
from small_course import run

from course_lib.exercises import all_exercises
from course_lib.judging import Exercise
from data_generators.classes import WORDS, Simulation, Submission, write_submissions
from data_generators.typed_answers import misconceived, right

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(chromium() is None, reason="needs Chromium"),
]
ASSIGNMENT = "01_pinhole"
LAB_KNOWS_FORMGRADER = "() => window.jupyterapp?.commands.hasCommand('nbgrader:open-formgrader')"
OPEN_FORMGRADER = "() => window.jupyterapp.commands.execute('nbgrader:open-formgrader')"


@pytest.fixture(scope="module")
def first_mistakes(released_term):
    """A student with the first misconception of every exercise."""
    path = released_term / "release" / ASSIGNMENT / f"{ASSIGNMENT}.ipynb"
    simulation = Simulation(nbformat.read(path, as_version=4), "pinhole")
    exercises = [e for e in all_exercises("pinhole") if isinstance(e, Exercise)]
    typed = {e.name: misconceived(e, e.misconceptions[0]) for e in exercises}
    typed[exercises[0].name] = right(exercises[0])
    return simulation.hand_in("mistaken", typed)


@pytest.fixture
def open_lab(tmp_path):
    """Start JupyterLab in a folder, and a page of a browser; both are gone afterwards."""
    labs = []
    with browser() as chrome:

        def start(folder):
            labs.append(Lab(folder, tmp_path / "home"))
            return labs[0], chrome.new_context(viewport={"width": 1300, "height": 900}).new_page()

        yield start
    for lab in labs:
        lab.stop()


def test_formgrader_lists_grades_and_shows_the_rubric(released_term, first_mistakes, open_lab):
    write_submissions(released_term, ASSIGNMENT, [first_mistakes])
    lab, page = open_lab(released_term)
    page.goto(f"{lab.url}/lab?token={lab.token}&reset")
    page.wait_for_function(LAB_KNOWS_FORMGRADER, timeout=60_000)
    page.evaluate(OPEN_FORMGRADER)
    listed = page.frame_locator("iframe").locator("tr", has_text=ASSIGNMENT)
    listed.wait_for(timeout=60_000)

    page.goto(f"{lab.url}/formgrader/manage_submissions/{ASSIGNMENT}")
    page.locator("tr", has_text="mistaken").locator(".autograde a").click()
    page.get_by_text("Successfully autograded").wait_for(timeout=120_000)
    with Gradebook(f"sqlite:///{released_term}/gradebook.db") as gradebook:
        submission = gradebook.find_submission(ASSIGNMENT, "mistaken")
        score, notebook = submission.score, submission.notebooks[0].id
    assert score == sum(first_mistakes.points.values())

    page.goto(f"{lab.url}/formgrader/submissions/{notebook}/")
    page.get_by_text("Model answer.").wait_for(timeout=60_000)
    text = page.inner_text("body")
    assert all(hint.replace("`", "") in text for hint in first_mistakes.hints)
    assert page.locator("input.score").count() == len(first_mistakes.points) + 1


GIVES_ITSELF_POINTS = """Because the camera stood far away.

<img src="none.png" onerror="document.body.dataset.ran = 'handler'">
<script>
document.body.dataset.ran = "script";
const same = {"X-CSRFToken": document.cookie.match(/_xsrf=([^;]+)/)[1]};
const grades = base_url + "/api/grades?submission_id=" + submission_id;
fetch(grades, {headers: same}).then(answer => answer.json()).then(all => Promise.all(all.map(
    one => fetch(base_url + "/api/grade/" + one.id,
        {method: "PUT", headers: same, body: JSON.stringify({manual_score: 99})})
))).then(() => {document.body.dataset.points = "given"});
</script>
"""


def points_by_hand(term, student):
    """Return what a person gave, and where the notebook is shown."""
    with Gradebook(f"sqlite:///{term}/gradebook.db") as gradebook:
        (notebook,) = gradebook.find_submission(ASSIGNMENT, student).notebooks
        return {grade.manual_score for grade in notebook.grades}, notebook.id


def test_a_students_words_do_not_run_where_points_are_given(new_term, submissions, open_lab):
    term = new_term("hostile", [])
    content = submissions["right"].content.replace(
        json.dumps(WORDS).encode(), json.dumps(GIVES_ITSELF_POINTS).encode()
    )
    everybody = [Submission(name, content, None) for name in ("by-command", "by-button")]
    assert b"onerror" in content
    write_submissions(term, ASSIGNMENT, everybody)
    graded = run("course", "grade", ASSIGNMENT, "--student", "by-command", cwd=term)
    assert graded.returncode == 0, graded.stderr
    lab, page = open_lab(term)
    page.goto(f"{lab.url}/lab?token={lab.token}&reset")
    page.goto(f"{lab.url}/formgrader/manage_submissions/{ASSIGNMENT}")
    page.locator("tr", has_text="by-button").locator(".autograde a").click()
    page.get_by_text("Successfully autograded").wait_for(timeout=120_000)
    for submission in everybody:
        _, notebook = points_by_hand(term, submission.student)
        page.goto(f"{lab.url}/formgrader/submissions/{notebook}/", wait_until="networkidle")
        assert "Because the camera stood far away." in page.inner_text("body")
        assert "fetch(grades" in page.locator("pre", has_text="<script>").inner_text()  # as typed
        assert page.evaluate("document.body.dataset.ran") is None
        assert points_by_hand(term, submission.student)[0] == {None}

    # The attack is a real one: it works where the words stand as they were handed in.
    place = term / "autograded/by-command" / ASSIGNMENT / f"{ASSIGNMENT}.ipynb"
    place.chmod(0o644)
    place.write_bytes(content)
    _, notebook = points_by_hand(term, "by-command")
    page.goto(f"{lab.url}/formgrader/submissions/{notebook}/")
    page.wait_for_function("document.body.dataset.points == 'given'")
    assert points_by_hand(term, "by-command")[0] == {99}


def test_validate_says_what_is_wrong(first_mistakes, tmp_path, open_lab):
    path = tmp_path / "work" / f"{ASSIGNMENT}.ipynb"
    path.parent.mkdir()
    path.write_bytes(first_mistakes.content)
    lab, page = open_lab(path.parent)
    open_notebook(page, lab, path)
    page.locator(".jp-NotebookPanel-toolbar").get_by_text("Validate", exact=True).click()
    results = page.locator(".jp-Dialog", has_text="Validation Results")
    results.get_by_text("pinhole.pixel_focal_length: 0 of 4 points").wait_for(timeout=120_000)
    shown = " ".join(results.inner_text().split())
    assert all(hint in shown for hint in first_mistakes.hints)
    assert "best_pinhole_diameter" not in shown
