"""The repository as it stands: linted, formatted, typed, and its notebooks fresh."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from course_lib.authoring.building import check_built

ROOT = Path(__file__).parents[1]

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("command", ["ruff check", "ruff format --check", "mypy"])
def test_what_authors_run_before_a_commit_finds_nothing(command: str) -> None:
    done = subprocess.run(
        [sys.executable, "-m", *command.split()], cwd=ROOT, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_notebooks_are_what_their_lessons_give() -> None:
    assert check_built(ROOT) == []
