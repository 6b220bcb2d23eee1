"""What is copied from the exchange, and what is not, without a term."""

import os
import shutil

import pytest
from nbgrader.coursedir import CourseDirectory

from course_lib.grading.collecting import CollectFiles


@pytest.fixture
def sent(tmp_path):
    folder = tmp_path / "sent"
    (folder / "deep").mkdir(parents=True)
    for name in ("01_pinhole.ipynb", "deep/helper.py"):
        (folder / name).write_text(name)
    (folder / "timestamp.txt").write_text("2026-11-01 10:00:00.0 UTC")
    (tmp_path / "secret").write_text("secret")
    return folder


@pytest.fixture
def copied(tmp_path):
    """Return the files that are copied from a folder, as sorted paths."""

    def copy(folder, largest=None):
        course = CourseDirectory(root=str(tmp_path))
        if largest is not None:
            course.max_dir_size = largest
        goal = tmp_path / "submitted/ada/01_pinhole"
        goal.parent.mkdir(parents=True)
        CollectFiles(coursedir=course).do_copy(str(folder), str(goal))
        assert [*goal.parent.iterdir()] in ([], [goal])  # nothing half-made stays
        return sorted(path.relative_to(goal).as_posix() for path in goal.rglob("*"))

    return copy


ALL = ["01_pinhole.ipynb", "deep", "deep/helper.py", "timestamp.txt"]


def test_files_and_folders_are_copied(sent, copied):
    assert copied(sent) == ALL


def test_links_and_pipes_are_left_out(sent, copied, tmp_path):
    for name in ("link", "deep/link"):
        (sent / name).symlink_to(tmp_path / "secret")
    (sent / "folder").symlink_to(tmp_path)
    (sent / "nowhere").symlink_to(tmp_path / "nowhere")
    os.mkfifo(sent / "deep/pipe")
    assert copied(sent) == ALL
    assert (sent / "link").is_symlink()


def test_what_is_no_folder_is_not_collected(sent, copied, tmp_path):
    (tmp_path / "link").symlink_to(sent)
    assert copied(tmp_path / "link") == []


def test_what_is_too_large_is_not_even_copied(sent, copied, monkeypatch):
    (sent / "large").write_bytes(bytes(3000))
    monkeypatch.delattr(shutil, "copytree")
    assert copied(sent, largest=2) == []


def test_what_is_just_not_too_large_is_collected(sent, copied):
    (sent / "large").write_bytes(bytes(3000))
    assert copied(sent, largest=4) == sorted([*ALL, "large"])


@pytest.mark.parametrize("is_folder", [False, True])
def test_a_time_that_is_none_is_left_out(sent, copied, is_folder):
    stamp = sent / "timestamp.txt"
    stamp.unlink()
    if is_folder:
        stamp.mkdir()
        (stamp / "x").touch()
    else:
        stamp.write_text("no time")
    assert copied(sent) == ALL[:3]
