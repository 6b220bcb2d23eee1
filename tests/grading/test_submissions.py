"""Files that are no notebooks, or notebooks that nobody could read, end in a sentence."""

import json

import pytest

from course_lib.grading.parcels import shown
from course_lib.grading.submissions import (
    MOST_BESIDE,
    MOST_CELLS,
    MOST_LETTERS,
    UnreadableError,
    all_beside,
    demand_size,
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
