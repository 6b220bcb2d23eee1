"""Kill the grader at random moments, go on, and compare with a run that nobody disturbed.

``python -m benchmarks.kills`` does it 50 times with 60 submissions; ``--gradebook postgresql``
and ``--cluster`` do it with a database of PostgreSQL, and on a Dask cluster whose workers are
killed, too.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from benchmarks import grading
from benchmarks.commands import free_port
from benchmarks.compute import clean_environment
from benchmarks.postgres import Server, postgres_server

ASSIGNMENT = grading.ASSIGNMENT
#: Whom a kill hits: the grader, everything that it started, too, or one worker.
VICTIMS = ("grader", "everything", "worker")
#: Between two kills at most this part of the submissions is graded, or so many.
PART, FEW = 1 / 12, 2.0
#: Seconds until a run counts as stuck.
PATIENCE = 900.0


@dataclass
class Report:
    """What came of it."""

    kills: Counter[str] = field(default_factory=Counter)
    rounds: int = 0
    differences: list[str] = field(default_factory=list)


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
        program = str(Path(sys.executable).with_name("course"))
        log = (term / "grade.log").open("ab")
        with log:
            return subprocess.Popen(
                [program, "grade", ASSIGNMENT, *own],
                cwd=term,
                env=self.environment(),
                stdout=log,
                stderr=log,
                start_new_session=True,
            )

    def environment(self) -> dict[str, str]:
        """Return what a program needs to enter the database."""
        return clean_environment() | (self.server.environment if self.server else {})


def torment(scene: Scene, kills: int, seed: int = 0) -> Report:
    """Kill runs at random moments, round after round; compare each round's end.

    Parameters
    ----------
    scene : Scene
        Where.
    kills : int
        How many.
    seed : int
        Of the moments and the victims.

    Returns
    -------
    Report
        Without differences if all is well.
    """
    rng, report = random.Random(seed), Report()
    term = scene.copy("undisturbed")
    start = time.monotonic()
    finish(scene, term)
    pace = (time.monotonic() - start) / handed_in(term)
    expected = snapshot(term, scene)
    while report.kills.total() < kills:
        report.rounds += 1
        term = scene.copy(f"round-{report.rounds}")
        while report.kills.total() < kills and not _is_done(term):
            _disturb(scene, term, rng, pace, report, kills)
        finish(scene, term)
        found = snapshot(term, scene)
        different = sorted(k for k in expected | found if expected.get(k) != found.get(k))
        report.differences += [f"round {report.rounds}: {name}" for name in different]
        said = f"{dict(report.kills)}, {len(different)} differences"
        print(f"round {report.rounds}: {said}", flush=True)
    return report


def _disturb(
    scene: Scene, term: Path, rng: random.Random, pace: float, report: Report, kills: int
) -> None:
    """Start a run and kill what belongs to it, until the grader itself is gone."""
    process = scene.start(term)
    try:
        while process.poll() is None:
            amount = rng.uniform(0, max(FEW, PART * handed_in(term)))
            _wait_for(process, term, len(records(term)) + int(amount))
            time.sleep((amount % 1) * pace)
            if process.poll() is not None:
                return
            victim = rng.choice(VICTIMS)
            if _kill(process.pid, victim, scene, rng):
                report.kills[victim] += 1
            if victim != "worker" or report.kills.total() >= kills:
                return
    finally:
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def _wait_for(process: subprocess.Popen[bytes], term: Path, number: int) -> None:
    """Wait until so many are graded, or the run ends."""
    limit = time.monotonic() + PATIENCE
    while len(records(term)) < number and process.poll() is None:
        if time.monotonic() > limit:
            raise TimeoutError(f"stuck: {(term / 'grade.log').read_text()[-500:]}")
        time.sleep(0.02)


def _kill(grader: int, victim: str, scene: Scene, rng: random.Random) -> bool:
    """Kill; return whether there was something to kill."""
    if victim == "everything":
        os.killpg(grader, signal.SIGKILL)
        return True
    above = scene.workers_of or [grader]
    targets = [grader] if victim == "grader" else [c for p in above for c in children(p)]
    if targets:
        with suppress(ProcessLookupError):
            os.kill(rng.choice(targets), signal.SIGKILL)
    return bool(targets)


def children(process: int) -> list[int]:
    """Return the processes that a process, or one of its threads, has started."""
    listed = []
    for path in Path(f"/proc/{process}/task").glob("*/children"):
        with suppress(OSError):  # a thread that has ended
            listed += [int(word) for word in path.read_text().split()]
    return [child for child in listed if not _is_helper(child)]


def _is_helper(process: int) -> bool:
    """Whether it is multiprocessing's own, which grades nothing."""
    try:
        return b"resource_tracker" in Path(f"/proc/{process}/cmdline").read_bytes()
    except OSError:
        return True


def finish(scene: Scene, term: Path) -> None:
    """Let a run come to its end. Where a kill left something set aside, a second run mends it."""
    for _ in range(2):
        process = scene.start(term)
        if process.wait(PATIENCE) == 0:
            return
    raise RuntimeError((term / "grade.log").read_text()[-3000:])


def records(term: Path) -> list[Path]:
    return sorted((term / "grading" / ASSIGNMENT).glob("*.json"))


def handed_in(term: Path) -> int:
    return len(list((term / "submitted").iterdir()))


def _is_done(term: Path) -> bool:
    return len(records(term)) == handed_in(term)


def database_of(term: Path) -> str:
    """Return the name of a term's database."""
    config = (term / "nbgrader_config.py").read_text()
    return config.partition("db_url = '")[2].partition("'")[0].rpartition("/")[2]


def snapshot(term: Path, scene: Scene) -> dict[str, Any]:
    """Return everything that must be the same: gradebook, graded notebooks, records."""
    found: dict[str, Any] = {}
    for path in sorted((term / "autograded").rglob("*")):
        if path.is_file():
            found[str(path.relative_to(term))] = hashlib.sha256(path.read_bytes()).hexdigest()
    for path in records(term):
        found[str(path.relative_to(term))] = without_seconds(json.loads(path.read_text()))
    code = "import sys; from benchmarks.kills import print_gradebook; print_gradebook(sys.argv[1])"
    done = subprocess.run(
        [sys.executable, "-c", code, str(term)],
        cwd=grading.ROOT,
        env=scene.environment(),
        check=True,
        capture_output=True,
        text=True,
    )
    return found | json.loads(done.stdout)


def without_seconds(record: Any) -> Any:
    """Return a record without what differs from one run to the next."""
    if isinstance(record, dict):
        return {k: without_seconds(v) for k, v in record.items() if k != "seconds"}
    return record


def print_gradebook(term: str) -> None:
    """Print all rows of a term's gradebook, by student and cell, and how many there are."""
    from nbgrader.api import Base, Gradebook
    from sqlalchemy import func, select

    from course_lib.grading.assignment import read_assignment

    assignment = read_assignment(Path(term), ASSIGNMENT)
    rows: dict[str, Any] = {}
    with Gradebook(assignment.db_url, assignment.course_id) as gradebook:
        for submission in gradebook.assignment_submissions(ASSIGNMENT):
            who = submission.student.id
            rows[who] = [str(submission.timestamp), submission.score]
            for notebook in submission.notebooks:
                rows[f"{who} {notebook.name}"] = notebook.late_submission_penalty
                for g in notebook.grades:
                    row = [g.auto_score, g.manual_score, g.extra_credit, g.needs_manual_grade]
                    rows[f"{who} grade {g.name}"] = row
                for c in notebook.comments:
                    rows[f"{who} comment {c.name}"] = [c.auto_comment, c.manual_comment]
        for table in Base.metadata.sorted_tables:
            number = gradebook.db.execute(select(func.count()).select_from(table)).scalar()
            rows[f"rows of {table.name}"] = number
    print(json.dumps(rows))


@contextmanager
def dask_cluster(workers: int, folder: Path) -> Iterator[tuple[str, int]]:
    """Start a scheduler and workers, as a cluster's owner would; yield address and process."""
    dask, port = str(Path(sys.executable).with_name("dask")), free_port()
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


def main() -> int:
    """Carry it out as the command line says."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.kills", description=__doc__)
    parser.add_argument("--kills", type=int, default=50)
    parser.add_argument("--submissions", type=int, default=60)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--gradebook", choices=["sqlite", "postgresql"], default="sqlite")
    parser.add_argument("--cluster", action="store_true", help="grade on a Dask cluster")
    options = parser.parse_args()
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="kills-")))
        scene = Scene(folder / "base", folder)
        grading.make_term(scene.base, options.submissions)
        if options.gradebook == "postgresql":
            scene.server = stack.enter_context(postgres_server())
            move_gradebook(scene)
        if options.cluster:
            scene.scheduler, owner = stack.enter_context(dask_cluster(2, folder))
            scene.workers_of = [owner]
        report = torment(scene, options.kills, options.seed)
    print(f"{dict(report.kills)} in {report.rounds} rounds of {options.submissions} submissions")
    print("\n".join(report.differences) or "the same gradebook, notebooks and records each time")
    return 1 if report.differences else 0


def move_gradebook(scene: Scene) -> None:
    """Let a term that was made with SQLite use a database of PostgreSQL."""
    from course_lib.grading.gradebooks import gradebook_url

    assert scene.server is not None
    config = scene.base / "nbgrader_config.py"
    url = gradebook_url(scene.server.make_database("base"))
    config.write_text(f"{config.read_text()}c.CourseDirectory.db_url = {url!r}\n")
    program = str(Path(sys.executable).with_name("nbgrader"))
    command = [program, "generate_assignment", ASSIGNMENT, "--force"]
    subprocess.run(command, cwd=scene.base, env=scene.environment(), check=True)


if __name__ == "__main__":
    sys.exit(main())
