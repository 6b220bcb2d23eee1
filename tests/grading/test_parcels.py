import pickle

import pytest

from course_lib.grading.assignment import read_assignment
from course_lib.grading.parcels import MOST_COPIED, TOO_LARGE, copy_beside, pack
from course_lib.grading.seeding import read_key

pytestmark = pytest.mark.slow
ASSIGNMENT = "01_pinhole"


@pytest.fixture
def assignment(new_term):
    return read_assignment(new_term("packed", ["right"]), ASSIGNMENT)


def test_all_that_grading_takes_is_in_it_but_not_the_key(assignment, submissions):
    parcel = pack(assignment, "right")
    assert parcel.notebooks == {ASSIGNMENT: submissions["right"].content}
    assert parcel.trouble == ""
    sent = pickle.dumps((assignment.notebooks, parcel))
    key = read_key(assignment.key_file)
    assert parcel.seed.encode() in sent
    assert key not in sent
    assert str(assignment.term).encode() not in sent


def test_too_much_beside_the_notebook_is_said(assignment):
    with (assignment.submitted("right") / "film.mp4").open("wb") as file:
        file.truncate(MOST_COPIED + 1)
    assert pack(assignment, "right").trouble == TOO_LARGE


def test_without_the_key_it_is_not_graded(assignment):
    assignment.key_file.unlink()
    assert "no key in" in pack(assignment, "right").trouble


def test_links_and_notebooks_are_not_copied(assignment, tmp_path):
    folder = assignment.submitted("right")
    (folder / "deep").mkdir()
    (folder / "deep/data.csv").write_text("1")
    (folder / "key.csv").symlink_to(assignment.key_file)
    copy_beside(folder, tmp_path / "copy")
    found = {p.name for p in (tmp_path / "copy").rglob("*") if p.is_file()}
    assert found == {"data.csv", "timestamp.txt", "submission_secret.txt"}
