"""What the two commands take: opening the course again, and building its notebooks."""

from __future__ import annotations

import os
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from benchmarks.processes import clean_environment
from benchmarks.table import Row
from tests.browser.lab import free_port

ROOT = Path(__file__).resolve().parents[1]
TOKEN = "benchmark"


def starting(rounds: int = 5) -> list[Row]:
    """Measure a second start until Lab answers, and a bare Lab in the same environment.

    The environment must be the one that start.py made.
    """
    with tempfile.TemporaryDirectory() as folder:
        python = [sys.executable]
        options = [f"--IdentityProvider.token={TOKEN}", "--allow-root"]
        course = [*python, "start.py", "--no-browser", "--work", folder, "--", *options]
        bare = [*python, "-m", "jupyterlab", "--no-browser", f"--notebook-dir={folder}", *options]
        ours, theirs = _alternating(
            lambda: _seconds_to_answer(course), lambda: _seconds_to_answer(bare), rounds
        )
    return [
        Row("start.py, warm, until Lab answers", ours, "s", "bare jupyter lab", theirs, "≈ 1 ×")
    ]


def building(rounds: int = 5) -> list[Row]:
    """Measure the build of all notebooks, and nbgrader's own command for the same sources."""
    with _term() as term:
        command = [sys.executable, "-m", "nbgrader", "generate_assignment", "--force"]
        one_by_one = [[*command, chapter.name] for chapter in sorted((term / "source").iterdir())]
        build = [sys.executable, "-m", "course_lib.cli", "build"]
        ours, theirs = _alternating(
            lambda: _seconds(build, ROOT),
            lambda: sum(_seconds(each, term) for each in one_by_one),
            rounds,
        )
    return [Row("course build, all chapters", ours, "s", "nbgrader, a command each", theirs)]


@contextmanager
def _term() -> Iterator[Path]:
    """Make a term with every chapter; take it away again."""
    from course_lib.exercises import CHAPTERS

    folder = Path(tempfile.mkdtemp())
    term = folder / "term"
    make = [sys.executable, "-m", "course_lib.cli", "term", str(term), "--chapters"]
    try:
        subprocess.run([*make, *CHAPTERS.values()], cwd=ROOT, check=True, capture_output=True)
        yield term
    finally:
        shutil.rmtree(folder)


def _alternating(
    one: Callable[[], float], other: Callable[[], float], rounds: int
) -> tuple[float, float]:
    """Return the medians of two measurements that take turns; the first round is dropped."""
    taken = [(one(), other()) for _ in range(rounds + 1)][1:]
    return statistics.median(a for a, _ in taken), statistics.median(b for _, b in taken)


def _seconds(command: list[str], folder: Path) -> float:
    start = time.perf_counter()
    subprocess.run(command, cwd=folder, env=clean_environment(), check=True, capture_output=True)
    return time.perf_counter() - start


def _seconds_to_answer(command: list[str], limit: float = 60) -> float:
    """Start a Lab on a free port; return how long it takes until its page is served."""
    port = free_port()
    start = time.perf_counter()
    process = subprocess.Popen(
        [*command, f"--ServerApp.port={port}"],
        cwd=ROOT,
        env=clean_environment() | {"JUPYTER_PREFER_ENV_PATH": "1"},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    try:
        while time.perf_counter() - start < limit:
            try:
                address = f"http://127.0.0.1:{port}/lab?token={TOKEN}"
                urllib.request.urlopen(address, timeout=5).close()
                return time.perf_counter() - start
            except (urllib.error.URLError, OSError):
                if process.poll() is not None:
                    raise RuntimeError(f"it ended: {' '.join(command)}; try it by hand") from None
                time.sleep(0.02)
        raise TimeoutError(f"no Lab within {limit:g} s: {' '.join(command)}")
    finally:
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGTERM)
        process.wait()
