"""Kills at random moments: grader, workers, everything at once. Fifty: benchmarks/kills.py."""

import shutil
import sqlite3
from contextlib import closing

import pytest
from walls import walled

from benchmarks.kills import torment
from benchmarks.scenes import Scene, records
from benchmarks.snapshots import snapshot

pytestmark = [pytest.mark.slow, walled]
CLASS = ("right", "rewritten", "half-done", "untouched", "misconception-1", "misconception-3")


@pytest.fixture(scope="module")
def scene(new_term, tmp_path_factory):
    return Scene(new_term("killed", CLASS), tmp_path_factory.mktemp("kills"))


def test_nothing_is_lost_and_nothing_is_there_twice(scene):
    report = torment(scene, kills=6, seed=3)
    assert report.kills.total() == 6
    assert len(report.kills) > 1
    assert report.differences == []


def test_what_is_lost_or_there_twice_would_be_found(scene):
    """A comparison that sees nothing would find no differences either."""
    term = shutil.copytree(scene.work / "undisturbed", scene.work / "spoilt")
    expected = snapshot(term, scene)
    with closing(sqlite3.connect(term / "gradebook.db")) as gradebook, gradebook:
        scored = "SELECT max(rowid) FROM grade WHERE auto_score > 0"
        gradebook.execute(f"UPDATE grade SET auto_score = 0 WHERE rowid = ({scored})")
        gradebook.execute("DELETE FROM comment WHERE rowid = (SELECT max(rowid) FROM comment)")
    record, twice = records(term)[:2]
    record.unlink()
    shutil.copy(twice, twice.with_stem("somebody"))
    page = next((term / "autograded/half-done").rglob("*.ipynb"))
    page.chmod(0o644)
    page.write_bytes(page.read_bytes() + b"\n")
    found = snapshot(term, scene)
    different = {key for key in expected | found if expected.get(key) != found.get(key)}
    kinds = {key.split()[1] for key in different if " " in key and not key.startswith("rows of")}
    assert kinds == {"grade", "comment"}
    assert "rows of comment" in different
    files = {page, record, record.with_stem("somebody")}
    assert {str(path.relative_to(term)) for path in files} <= different
