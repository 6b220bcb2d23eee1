"""What a whole lesson takes: every cell of a student's notebook, with the answers in it."""

from __future__ import annotations

import tempfile
import time
from pathlib import Path

from nbclient import NotebookClient

from benchmarks.table import Row
from course_lib.authoring.building import find_lessons
from course_lib.authoring.expansion import expand
from course_lib.authoring.lesson import read_lesson

ROOT = Path(__file__).resolve().parents[1]


def executing() -> list[Row]:
    """Run each lesson from top to bottom in a kernel of its own, and count its start too."""
    return [
        Row(f"{path.stem}, all cells", _seconds(path), "s", goal="≤ 60 s")
        for path in find_lessons(ROOT)
    ]


def _seconds(path: Path) -> float:
    notebook = expand(read_lesson(path))
    with tempfile.TemporaryDirectory() as folder:
        client = NotebookClient(notebook, timeout=600, resources={"metadata": {"path": folder}})
        start = time.perf_counter()
        client.execute()
        return time.perf_counter() - start
