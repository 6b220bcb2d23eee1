import copy

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_notebook
from nbgrader.api import Gradebook
from nbgrader.nbgraderformat import MetadataValidator
from nbgrader.preprocessors import OverwriteCells
from nbgrader.utils import compute_checksum

from course_lib.grading.restoring import RestoreCells

pytestmark = pytest.mark.slow


@pytest.fixture
def released(released_term):
    return nbformat.read(released_term / "release/01_pinhole/01_pinhole.ipynb", as_version=4)


@pytest.fixture
def restore(released_term):
    which = {"notebook": "01_pinhole", "assignment": "01_pinhole"}
    resources = {"nbgrader": which | {"db_url": f"sqlite:///{released_term}/gradebook.db"}}
    return lambda notebook: RestoreCells().preprocess(notebook, resources)[0]


def names(notebook):
    return [cell.metadata.get("nbgrader", {}).get("grade_id", "") for cell in notebook.cells]


def without(notebook, *gone):
    fewer = copy.deepcopy(notebook)
    fewer.cells = [
        c for c, name in zip(notebook.cells, names(notebook), strict=True) if name not in gone
    ]
    return fewer


def test_a_whole_notebook_stays_as_it_is(released, restore):
    assert restore(copy.deepcopy(released)) == released


@pytest.mark.parametrize(
    "gone",
    [
        ["setup"],
        ["pinhole-dolly_zoom-check"],
        ["pinhole-explain_flat_faces-question", "pinhole-explain_flat_faces"],
        ["pinhole-explain_flat_faces"],
        ["pinhole-project_pinhole-check", "pinhole-dolly_zoom-check", "setup"],
    ],
)
def test_missing_cells_come_back_in_their_place(released, restore, gone):
    back = restore(without(released, *gone))
    flagged = [name for name in names(back) if name]
    assert flagged == [name for name in names(released) if name]
    MetadataValidator().validate_nb(back)
    nbformat.validate(back)
    assert all(
        compute_checksum(cell) == cell.metadata.nbgrader.checksum
        for cell, name in zip(back.cells, names(back), strict=True)
        if name in gone
    )


def test_an_exercise_without_both_cells_gets_its_check_back(released, restore):
    back = restore(without(released, "pinhole-dolly_zoom", "pinhole-dolly_zoom-check"))
    assert names(back)[-1] == "pinhole-dolly_zoom-check"


def test_answers_copied_into_a_new_notebook_come_before_their_checks(released, restore):
    code = [c for c in released.cells if c.cell_type == "code" and not c.source.startswith("check")]
    back = restore(new_notebook(cells=[new_code_cell(cell.source) for cell in code]))
    found = names(back)
    assert found[0] == "setup"
    assert found.index("pinhole-dolly_zoom-check") >= len(code)
    expected = [
        n for n in names(released) if n.endswith("-check") or "explain" in n or n == "setup"
    ]
    assert [name for name in found if name] == expected


def test_points_are_those_of_the_gradebook(released_term, released, restore):
    back = restore(without(released, "pinhole-data_sheet-check"))
    cell = back.cells[names(back).index("pinhole-data_sheet-check")]
    with Gradebook(f"sqlite:///{released_term}/gradebook.db") as gradebook:
        graded = gradebook.find_grade_cell("pinhole-data_sheet-check", "01_pinhole", "01_pinhole")
        assert cell.metadata.nbgrader.points == graded.max_score == 5


def test_nbgraders_own_way_stops_with_an_error(released_term, released):
    """If this fails, nbgrader has mended it, and `RestoreCells` may go."""
    which = {"notebook": "01_pinhole", "assignment": "01_pinhole"}
    resources = {"nbgrader": which | {"db_url": f"sqlite:///{released_term}/gradebook.db"}}
    for gone in (
        ["pinhole-dolly_zoom", "pinhole-dolly_zoom-check"],
        ["pinhole-explain_flat_faces"],
    ):
        with pytest.raises(KeyError):
            OverwriteCells(add_missing_cells=True).preprocess(without(released, *gone), resources)
