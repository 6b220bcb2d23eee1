import json
from pathlib import Path

import pytest

from course_lib.starting.trouble import Trouble
from course_lib.starting.work_folder import RECORD, update

NAME = "01_pinhole/01_pinhole.ipynb"
BESIDE = "01_pinhole/01_pinhole (new version).ipynb"
BESIDE_2 = "01_pinhole/01_pinhole (new version 2).ipynb"


@pytest.fixture
def course(tmp_path: Path) -> tuple[Path, Path]:
    notebooks, work = tmp_path / "notebooks", tmp_path / "Käme räs 相机" / "work"
    publish(notebooks, "first")
    update(notebooks, work)
    return notebooks, work


def publish(notebooks: Path, text: str) -> None:
    (notebooks / NAME).parent.mkdir(parents=True, exist_ok=True)
    (notebooks / NAME).write_text(text)


def test_first_start_copies_everything_that_is_visible(tmp_path):
    notebooks, work = tmp_path / "notebooks", tmp_path / "work"
    publish(notebooks, "first")
    (notebooks / "01_pinhole/.ipynb_checkpoints").mkdir()
    (notebooks / "01_pinhole/.ipynb_checkpoints/old.ipynb").write_text("old")
    (notebooks / "01_pinhole/tree.png").write_bytes(b"\x89PNG\xff")
    assert update(notebooks, work) == [f"2 files were copied to {work}"]
    assert (work / NAME).read_text() == "first"
    assert (work / "01_pinhole/tree.png").read_bytes() == b"\x89PNG\xff"
    assert not (work / "01_pinhole/.ipynb_checkpoints").exists()


def test_second_start_says_and_changes_nothing(course):
    notebooks, work = course
    (work / NAME).write_text("mine")
    before = {path: path.stat().st_mtime_ns for path in work.rglob("*.ipynb")}
    assert update(notebooks, work) == []
    assert {path: path.stat().st_mtime_ns for path in work.rglob("*.ipynb")} == before


def test_unedited_copy_follows_an_update_and_it_is_said(course):
    notebooks, work = course
    publish(notebooks, "second")
    (saying,) = update(notebooks, work)
    assert (work / NAME).read_text() == "second"
    assert "01_pinhole.ipynb: updated" in saying
    assert update(notebooks, work) == []


def test_edited_copy_stays_and_the_update_is_beside_it_once(course):
    notebooks, work = course
    (work / NAME).write_text("mine")
    publish(notebooks, "second")
    (saying,) = update(notebooks, work)
    assert (work / NAME).read_text() == "mine"
    assert (work / BESIDE).read_text() == "second"
    assert "01_pinhole (new version).ipynb" in saying
    assert update(notebooks, work) == []


def test_next_update_replaces_an_untouched_offer(course):
    notebooks, work = course
    (work / NAME).write_text("mine")
    for text in ("second", "third"):
        publish(notebooks, text)
        update(notebooks, work)
    assert (work / BESIDE).read_text() == "third"
    assert not (work / BESIDE_2).exists()


def test_an_offer_that_was_edited_is_the_students_too(course):
    notebooks, work = course
    (work / NAME).write_text("mine")
    publish(notebooks, "second")
    update(notebooks, work)
    (work / BESIDE).write_text("also mine")
    publish(notebooks, "third")
    (saying,) = update(notebooks, work)
    assert [(work / name).read_text() for name in (NAME, BESIDE, BESIDE_2)] == [
        "mine",
        "also mine",
        "third",
    ]
    assert "(new version 2)" in saying


def test_a_removed_offer_does_not_come_back_until_the_next_update(course):
    notebooks, work = course
    (work / NAME).write_text("mine")
    publish(notebooks, "second")
    update(notebooks, work)
    (work / BESIDE).unlink()
    assert update(notebooks, work) == []
    assert not (work / BESIDE).exists()


def test_a_student_who_adopts_the_offer_follows_again(course):
    notebooks, work = course
    (work / NAME).write_text("mine")
    publish(notebooks, "second")
    update(notebooks, work)
    (work / BESIDE).replace(work / NAME)
    update(notebooks, work)
    publish(notebooks, "third")
    update(notebooks, work)
    assert (work / NAME).read_text() == "third"


def test_a_deleted_notebook_comes_back(course):
    notebooks, work = course
    (work / NAME).unlink()
    assert update(notebooks, work) == [f"One file was copied to {work}"]
    assert (work / NAME).read_text() == "first"


@pytest.mark.parametrize("record", ["", "{", "[]", f'{{"{NAME}": "text"}}', "\0"])
def test_a_broken_record_counts_every_changed_file_as_edited(course, record):
    notebooks, work = course
    (work / RECORD).write_text(record)
    publish(notebooks, "second")
    update(notebooks, work)
    assert (work / NAME).read_text() == "first"
    assert (work / BESIDE).read_text() == "second"
    assert NAME in json.loads((work / RECORD).read_text())


def test_a_file_of_the_same_name_from_elsewhere_is_kept(tmp_path):
    notebooks, work = tmp_path / "notebooks", tmp_path / "work"
    publish(notebooks, "first")
    (work / NAME).parent.mkdir(parents=True)
    (work / NAME).write_text("from another year")
    update(notebooks, work)
    assert (work / NAME).read_text() == "from another year"
    assert (work / BESIDE).read_text() == "first"


def test_originals_are_never_the_work_folder(course):
    notebooks, _ = course
    with pytest.raises(Trouble, match="--work"):
        update(notebooks, notebooks / "01_pinhole")


def notebook(source: str, *, was_run: bool = False) -> str:
    cell = {"cell_type": "code", "id": "a", "source": [source], "outputs": [], "metadata": {}}
    if was_run:  # what JupyterLab saves after a look at the notebook
        cell |= {"outputs": [{"text": "42"}], "execution_count": 3, "metadata": {"trusted": True}}
    return json.dumps({"cells": [cell], "metadata": {"kernelspec": {}} if was_run else {}})


def test_a_notebook_that_was_only_run_keeps_its_outputs(course):
    notebooks, work = course
    publish(notebooks, notebook("6 * 7"))
    update(notebooks, work)
    (work / NAME).write_text(notebook("6 * 7", was_run=True))
    assert update(notebooks, work) == []
    assert (work / NAME).read_text() == notebook("6 * 7", was_run=True)


def test_a_notebook_that_was_only_run_follows_an_update(course):
    notebooks, work = course
    publish(notebooks, notebook("6 * 7"))
    update(notebooks, work)
    (work / NAME).write_text(notebook("6 * 7", was_run=True))
    publish(notebooks, notebook("6 * 8"))
    (saying,) = update(notebooks, work)
    assert "updated" in saying
    assert (work / NAME).read_text() == notebook("6 * 8")
    assert not (work / BESIDE).exists()


def test_one_changed_letter_in_a_cell_is_an_edit(course):
    notebooks, work = course
    publish(notebooks, notebook("6 * 7"))
    update(notebooks, work)
    (work / NAME).write_text(notebook("6 * 9", was_run=True))
    publish(notebooks, notebook("6 * 8"))
    update(notebooks, work)
    assert (work / NAME).read_text() == notebook("6 * 9", was_run=True)
    assert (work / BESIDE).read_text() == notebook("6 * 8")


def test_nothing_temporary_stays(course):
    _, work = course
    names = {path.name for path in work.rglob("*") if path.is_file()}
    assert names == {RECORD, "01_pinhole.ipynb"}
