import copy

import nbformat
import pytest
from nbformat.v4 import new_code_cell
from nbgrader.nbgraderformat import MetadataValidator, SchemaTooOldError
from nbgrader.preprocessors import DeduplicateIds

from course_lib.grading.labelling import LabelCells

pytestmark = pytest.mark.slow
ANSWER, CHECK = "pinhole-dolly_zoom", "pinhole-dolly_zoom-check"
QUESTION, WORDS = "pinhole-explain_flat_faces-question", "pinhole-explain_flat_faces"


@pytest.fixture
def released(released_term):
    return nbformat.read(released_term / "release/01_pinhole/01_pinhole.ipynb", as_version=4)


@pytest.fixture
def label(released_term):
    which = {"notebook": "01_pinhole", "assignment": "01_pinhole", "student": "ada"}
    resources = {"nbgrader": which | {"db_url": f"sqlite:///{released_term}/gradebook.db"}}

    def run_it(notebook):
        labelled, _ = LabelCells().preprocess(copy.deepcopy(notebook), resources)
        MetadataValidator().validate_nb(labelled)
        return labelled

    return run_it


def names(notebook):
    return [cell.metadata.get("nbgrader", {}).get("grade_id", "") for cell in notebook.cells]


def index_of(notebook, name):
    return names(notebook).index(name)


def pasted(notebook, name, at, source=None):
    """Paste a copy of a cell, as JupyterLab does: with its label."""
    cell = copy.deepcopy(notebook.cells[index_of(notebook, name)])
    cell.id = f"pasted-{len(notebook.cells)}"
    cell.source = cell.source if source is None else source
    notebook.cells.insert(len(notebook.cells) if at is None else at, cell)


def kept(notebook, name):
    (cell,) = [c for c, n in zip(notebook.cells, names(notebook), strict=True) if n == name]
    return cell


def test_nbgraders_own_way_stops_everything(released):
    """If this fails, nbgrader has mended it, and `LabelCells` need not look for copies."""
    pasted(released, ANSWER, at=None)
    DeduplicateIds().preprocess(released, {})
    with pytest.raises(SchemaTooOldError):
        MetadataValidator().validate_nb(released)


def test_a_whole_notebook_keeps_its_labels(released, label):
    labelled = label(released)
    assert names(labelled) == names(released)
    for cell, was in zip(labelled.cells, released.cells, strict=True):
        assert cell.source == was.source or "Rubric" in cell.source
        if "nbgrader" in was.metadata and cell.source == was.source:
            assert cell.metadata.nbgrader == was.metadata.nbgrader


def test_no_cell_is_moved_changed_or_removed(released, label):
    pasted(released, ANSWER, at=3, source="def dolly_zoom(): ...")
    pasted(released, CHECK, at=None)
    labelled = label(released)
    shown = [c.source for c in labelled.cells if "Rubric" not in c.source]
    assert shown == [c.source for c in released.cells if c.source in shown]
    assert len(labelled.cells) == len(released.cells)


@pytest.mark.parametrize("first", [True, False])
def test_an_answer_counts_rather_than_a_stub(released, label, first):
    at = index_of(released, ANSWER)
    pasted(released, ANSWER, at if first else at + 1, source="answer")
    assert kept(label(released), ANSWER).source == "answer"


def test_of_two_answers_before_the_check_the_later_counts(released, label):
    at = index_of(released, ANSWER)
    released.cells[at].source = "first"
    pasted(released, ANSWER, at + 1, source="second")
    assert kept(label(released), ANSWER).source == "second"


def test_an_answer_after_the_only_check_did_not_meet_it(released, label):
    released.cells[index_of(released, ANSWER)].source = "first"
    pasted(released, ANSWER, at=None, source="second")
    assert kept(label(released), ANSWER).source == "first"


def test_answer_and_check_pasted_at_the_end_count_there(released, label):
    pasted(released, ANSWER, at=None, source="answer")
    pasted(released, CHECK, at=None)
    labelled = label(released)
    assert kept(labelled, ANSWER) is labelled.cells[-2]
    assert kept(labelled, CHECK) is labelled.cells[-1]


def test_an_untouched_pair_at_the_end_takes_nothing_away(released, label):
    stub = released.cells[index_of(released, ANSWER)].source
    released.cells[index_of(released, ANSWER)].source = "answer"
    pasted(released, ANSWER, at=None, source=stub)
    pasted(released, CHECK, at=None)
    labelled = label(released)
    assert kept(labelled, ANSWER).source == "answer"
    assert index_of(labelled, CHECK) == index_of(released, CHECK)


def test_words_count_where_they_are_written(released, label):
    pasted(released, WORDS, index_of(released, WORDS), source="Because of the distance.")
    pasted(released, QUESTION, at=None)
    labelled = label(released)
    assert kept(labelled, WORDS).source == "Because of the distance."
    assert index_of(labelled, QUESTION) == index_of(released, QUESTION)


def test_an_unchanged_question_gets_its_rubric_and_a_changed_one_is_left_to_nbgrader(
    released, label
):
    assert "Rubric" in kept(label(released), QUESTION).source
    released.cells[index_of(released, QUESTION)].source = "My own question"
    assert kept(label(released), QUESTION).source == "My own question"


@pytest.mark.parametrize(
    "damage",
    [
        {"schema_version": 99},
        {"schema_version": 0},
        {"points": -3, "grade": True},
        {"locked": False, "solution": True},
        {"nonsense": 1},
    ],
    ids=str,
)
def test_labels_become_those_of_the_source(released, label, damage):
    expected = names(released)
    for cell in released.cells:
        cell.metadata.get("nbgrader", {}).update(damage)
    labelled = label(released)
    assert names(labelled) == expected
    assert kept(labelled, CHECK).metadata.nbgrader.points == 4


@pytest.mark.parametrize("odd", [{}, "text", None, ["a"], {"grade_id": ["a"]}, {"grade_id": "no"}])
def test_what_is_no_label_of_ours_is_taken_away(released, label, odd):
    released.cells.append(new_code_cell("1", metadata={"nbgrader": odd}))
    assert "nbgrader" not in label(released).cells[-1].metadata


def test_a_warning_names_the_student_and_the_exercise(released, label, caplog):
    label(released)
    assert caplog.text == ""
    pasted(released, ANSWER, at=None)
    label(released)
    assert "ada handed in more than one copy of: pinhole-dolly_zoom." in caplog.text
