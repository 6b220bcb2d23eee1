"""Kill the grader at random moments, go on, and compare with a run that nobody disturbed.

``python -m benchmarks.kills`` does it 50 times with 60 submissions; ``--gradebook postgresql``
and ``--cluster`` do it with a database of PostgreSQL, and on a Dask cluster whose workers are
killed, too.
"""

from __future__ import annotations

import argparse
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from contextlib import ExitStack, suppress
from dataclasses import dataclass, field
from pathlib import Path

from benchmarks import grading
from benchmarks.postgres import postgres_server
from benchmarks.processes import children
from benchmarks.scenes import (
    PATIENCE,
    Scene,
    dask_cluster,
    finish,
    handed_in,
    move_gradebook,
    records,
)
from benchmarks.snapshots import snapshot

#: Whom a kill hits: the grader, everything that it started, too, or one worker.
VICTIMS = ("grader", "everything", "worker")
#: Between two kills at most this part of the submissions is graded, or so many.
PART, FEW = 1 / 12, 2.0


@dataclass
class Report:
    """What came of it."""

    kills: Counter[str] = field(default_factory=Counter)
    rounds: int = 0
    differences: list[str] = field(default_factory=list)


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
    workers = [child for one in above for child in children(one) if not _is_helper(child)]
    targets = [grader] if victim == "grader" else workers
    try:
        os.kill(rng.choice(targets), signal.SIGKILL)
    except (IndexError, ProcessLookupError):  # there is none, or none any more
        return False
    return True


def _is_helper(process: int) -> bool:
    """Whether it is multiprocessing's own, which grades nothing."""
    try:
        return b"resource_tracker" in Path(f"/proc/{process}/cmdline").read_bytes()
    except OSError:
        return True


def _is_done(term: Path) -> bool:
    return len(records(term)) == handed_in(term)


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


if __name__ == "__main__":
    sys.exit(main())
