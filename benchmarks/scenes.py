"""Terms that are graded again and again: fresh copies, a database for each, perhaps a cluster."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from benchmarks import grading
from benchmarks.postgres import Server
from benchmarks.processes import clean_environment, program
from tests.browser.lab import free_port

ASSIGNMENT = grading.ASSIGNMENT
#: Seconds until a run counts as stuck.
PATIENCE = 900.0


@dataclass
class Scene:
    """Where it happens.

    Attributes
    ----------
    base : pathlib.Path
        A term in which submissions wait; it stays as it is.
    work : pathlib.Path
        A folder for copies of it.
    server : Server, optional
        Where each copy gets a database of its own, from the base's.
    scheduler : str
        Of the Dask cluster that grades; empty to grade here.
    workers_of : sequence of int
        Processes whose children are the cluster's workers.
    """

    base: Path
    work: Path
    server: Server | None = None
    scheduler: str = ""
    workers_of: Sequence[int] = ()

    def copy(self, name: str) -> Path:
        """Return a fresh copy of the term."""
        term = self.work / name
        shutil.copytree(self.base, term, symlinks=True)
        if self.server:
            old, new = database_of(self.base), name.replace("-", "_")
            self.server.make_database(new, template=old)
            config = term / "nbgrader_config.py"
            config.write_text(config.read_text().replace(f"/{old}'", f"/{new}'"))
        return term

    def start(self, term: Path, *options: str) -> subprocess.Popen[bytes]:
        """Start a run of the grader, which writes into ``grade.log`` there."""
        own = [*options, *(["--scheduler", self.scheduler] if self.scheduler else [])]
        with (term / "grade.log").open("ab") as log:
            return subprocess.Popen(
                [program("course"), "grade", ASSIGNMENT, *own],
                cwd=term,
                env=self.environment(),
                stdout=log,
                stderr=log,
                start_new_session=True,
            )

    def environment(self) -> dict[str, str]:
        """Return what a program needs to enter the database."""
        return clean_environment() | (self.server.environment if self.server else {})


def finish(scene: Scene, term: Path) -> None:
    """Let a run come to its end. Where a kill left something set aside, a second run mends it."""
    for _ in range(2):
        process = scene.start(term)
        if process.wait(PATIENCE) == 0:
            return
    raise RuntimeError((term / "grade.log").read_text()[-3000:])


def records(term: Path) -> list[Path]:
    """Return what the grader has noted, a file for each submission."""
    return sorted((term / "grading" / ASSIGNMENT).glob("*.json"))


def handed_in(term: Path) -> int:
    """Return how many submissions there are."""
    return len(list((term / "submitted").iterdir()))


def database_of(term: Path) -> str:
    """Return the name of a term's database."""
    config = (term / "nbgrader_config.py").read_text()
    return config.partition("db_url = '")[2].partition("'")[0].rpartition("/")[2]


def move_gradebook(scene: Scene) -> None:
    """Let a term that was made with SQLite use a database of PostgreSQL."""
    from course_lib.grading.gradebooks import gradebook_url

    assert scene.server is not None
    config = scene.base / "nbgrader_config.py"
    url = gradebook_url(scene.server.make_database("base"))
    config.write_text(f"{config.read_text()}c.CourseDirectory.db_url = {url!r}\n")
    command = [program("nbgrader"), "generate_assignment", ASSIGNMENT, "--force"]
    subprocess.run(command, cwd=scene.base, env=scene.environment(), check=True)


@contextmanager
def dask_cluster(workers: int, folder: Path) -> Iterator[tuple[str, int]]:
    """Start a scheduler and workers, as a cluster's owner would; yield address and process."""
    dask, port = program("dask"), free_port()
    address = f"tcp://127.0.0.1:{port}"
    own = ["--host", "127.0.0.1", "--no-dashboard"]
    commands = (
        [dask, "scheduler", *own, "--port", str(port)],
        [dask, "worker", address, *own, "--nworkers", str(workers), "--nthreads", "1"],
    )
    processes = []
    try:
        for command in commands:
            with (folder / f"{command[1]}.log").open("wb") as log:
                env = clean_environment()
                process = subprocess.Popen(command, cwd=folder, env=env, stdout=log, stderr=log)
            processes.append(process)
        yield address, processes[1].pid
    finally:
        for process in reversed(processes):
            process.terminate()
            with suppress(subprocess.TimeoutExpired):
                process.wait(30)
            process.kill()
            process.wait()
