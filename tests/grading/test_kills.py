"""Kills at random moments: grader, workers, everything at once. Fifty: benchmarks/kills.py."""

import pytest
from walls import walled

from benchmarks.kills import Scene, torment

pytestmark = [pytest.mark.slow, walled]
CLASS = ("right", "rewritten", "half-done", "untouched", "misconception-1", "misconception-3")


def test_nothing_is_lost_and_nothing_is_there_twice(new_term, tmp_path):
    report = torment(Scene(new_term("killed", CLASS), tmp_path), kills=6, seed=3)
    assert report.kills.total() == 6
    assert len(report.kills) > 1
    assert report.differences == []
