import os
import re

import pytest

from course_lib.grading.receipts import write_receipts


@pytest.fixture
def notebook(tmp_path):
    path = tmp_path / "01_pinhole.ipynb"
    path.write_text("{}")
    os.utime(path, (0, 0))
    return path


def test_a_missing_receipt_is_written(notebook):
    write_receipts(assignment="01_pinhole", student="*", notebooks=[str(notebook)])
    assert notebook.with_name("timestamp.txt").read_text() == "1970-01-01 00:00:00 UTC"
    secret = notebook.with_name("submission_secret.txt").read_text()
    assert re.fullmatch("[0-9a-f]{128}", secret)


def test_a_receipt_that_is_there_stays(notebook):
    kept = {"timestamp.txt": "2026-10-01 12:00:00 UTC", "submission_secret.txt": "of the exchange"}
    for name, text in kept.items():
        notebook.with_name(name).write_text(text)
    write_receipts(notebooks=[str(notebook)])
    assert {name: notebook.with_name(name).read_text() for name in kept} == kept


def test_secrets_differ(tmp_path, notebook):
    found = set()
    for _ in range(2):
        write_receipts(notebooks=[str(notebook)])
        found.add(notebook.with_name("submission_secret.txt").read_text())
        notebook.with_name("submission_secret.txt").unlink()
    assert len(found) == 2
