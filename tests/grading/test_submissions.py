"""Files that are no notebooks, or notebooks that nobody could read, end in a sentence."""

import json

import pytest

from course_lib.grading import submissions
from course_lib.grading.parcels import shown
from course_lib.grading.submissions import (
    MOST_BESIDE,
    MOST_CELLS,
    MOST_LETTERS,
    UnreadableError,
    all_beside,
    demand_size,
    fingerprint,
    handed_in_at,
    read_notebook,
)


def cells(number, source=""):
    return [
        {"cell_type": "markdown", "id": f"c{k}", "metadata": {}, "source": source}
        for k in range(number)
    ]


def notebook(**changed):
    return {"nbformat": 4, "nbformat_minor": 5, "metadata": {}, "cells": cells(2)} | changed


@pytest.mark.parametrize(
    "changed",
    [
        {"nbformat_minor": float("inf")}, {"nbformat": 4.0}, {"nbformat": True}, {"nbformat": -4},
        {"nbformat": 2}, {"nbformat": 3, "worksheets": 7}, {"metadata": float("nan")},
        {"cells": {"a": 1}}, {"cells": [1]}, {"cells": cells(1, "\ud800")},
    ],
    ids=str,
)  # fmt: skip
def test_a_file_that_holds_anything_is_damaged(changed):
    with pytest.raises(UnreadableError, match="its cells are not what JupyterLab writes"):
        read_notebook(json.dumps(notebook(**changed)).encode())


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"cells": cells(MOST_CELLS + 1)}, "2001 cells"),
        ({"cells": cells(2, "x" * (MOST_LETTERS // 2 + 1))}, "500002 letters"),
        ({"nbformat": 3, "worksheets": [{"cells": cells(MOST_CELLS)}] * 2}, "4002 cells"),
        (
            {"nbformat": 3, "worksheets": [{"cells": [{"input": "x" * (MOST_LETTERS + 1)}]}]},
            "500001 letters",
        ),
    ],
    ids=["cells", "letters", "cells of an old format", "letters of an old format"],
)
def test_a_notebook_that_would_keep_the_grader_busy_is_not_read(changed, said):
    with pytest.raises(UnreadableError, match=said):
        read_notebook(json.dumps(notebook(**changed)).encode())


def test_a_large_notebook_is_read():
    large = notebook(cells=cells(200, "x" * (MOST_LETTERS // 200)))
    demand_size(large)
    assert len(read_notebook(json.dumps(large).encode()).cells) == 200


def test_no_more_files_are_looked_at_than_are_allowed(tmp_path):
    for k in range(MOST_BESIDE + 20):
        (tmp_path / f"{k}").touch()
    assert len(list(all_beside(tmp_path))) == MOST_BESIDE + 1


def test_a_name_is_shown_without_what_a_terminal_would_carry_out():
    assert shown("\x1b]0;x\x07\udcff\n ö.ipynb") == "?]0;x??? ö.ipynb"


@pytest.mark.parametrize(
    "content",
    [
        b"", b"no time", b"1:" + b"9" * 40 + b".5", b"2026-11-01 10:00:00 \xff",
        b"2026-11-01 10:00:00 /usr/bin/env", b"2026-11-01 10:00:00 UTC" + b" " * 100,
    ],
    ids=["nothing", "words", "digits", "no letters", "a file", "long"],
)  # fmt: skip
def test_what_is_no_time_counts_as_none(tmp_path, content):
    assert handed_in_at(tmp_path) == ""
    stamp = tmp_path / "timestamp.txt"
    stamp.write_bytes(b"2026-11-01 10:00:00.5 UTC\n")
    assert handed_in_at(tmp_path) == "2026-11-01 10:00:00.5 UTC"
    stamp.write_bytes(content)
    assert handed_in_at(tmp_path) == ""


@pytest.fixture
def handed_in(tmp_path):
    folder = tmp_path / "handed_in"
    (folder / "deep").mkdir(parents=True)
    for name in ("b.ipynb", "a.ipynb", "deep/helper.py"):
        (folder / name).write_text(name)
    return folder


def mark(folder):
    return fingerprint(folder, ["a", "b", "not handed in"])


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("a.ipynb", "A.ipynb"), ("deep/helper.py", "changed"), ("deep/other.py", ""),
        ("b.ipynb", ""), ("picture.png", "dots"),
    ],
)  # fmt: skip
def test_a_changed_or_new_file_makes_another_version(handed_in, name, content):
    before = mark(handed_in)
    (handed_in / name).write_text(content)
    assert mark(handed_in) != before


def test_a_file_under_another_name_makes_another_version(handed_in):
    before = mark(handed_in)
    (handed_in / "deep/helper.py").rename(handed_in / "deep/help.py")
    assert mark(handed_in) != before


@pytest.mark.parametrize(
    "name", ["timestamp.txt", "submission_secret.txt", "deep/__pycache__/x.pyc", "draft.ipynb"]
)
def test_when_it_came_and_what_is_not_graded_makes_no_other_version(handed_in, name):
    before = mark(handed_in)
    (handed_in / name).parent.mkdir(exist_ok=True)
    (handed_in / name).write_text("anything")
    assert mark(handed_in) == before
    assert fingerprint(handed_in, ("b", "a")) == before


def test_links_are_not_followed_for_a_version(handed_in, tmp_path):
    elsewhere = tmp_path / "elsewhere"
    (handed_in / "a.ipynb").unlink()
    for name in ("a.ipynb", "deep/link.py"):
        (handed_in / name).symlink_to(elsewhere)
    before = mark(handed_in)
    elsewhere.write_text("somebody else's")
    assert mark(handed_in) == before


def test_what_cannot_be_read_has_a_version_and_of_a_huge_file_the_beginning_counts(
    handed_in, monkeypatch
):
    monkeypatch.setattr(submissions, "MOST_COMPARED", 1)
    (handed_in / "huge").write_bytes(bytes(3 << 20))
    before = mark(handed_in)
    (handed_in / "huge").write_bytes(bytes((3 << 20) - 1) + b"1")
    assert mark(handed_in) == before

    def refuse(*_):
        raise PermissionError

    monkeypatch.setattr(submissions, "_digest", refuse)
    assert mark(handed_in) != before
