"""Workers share with the grader what was there before they were forked, and no core."""

import gc
import os
import re
import sys
import time
from multiprocessing import get_context
from pathlib import Path

import pytest

from course_lib.grading import workers
from course_lib.grading.workers import memory_stays_shared
from course_lib.sandbox.limits import Allowance

MEMORY = Path("/proc/self/smaps_rollup")


def own_megabytes():
    return int(re.search(r"Private_Dirty:\s+(\d+) kB", MEMORY.read_text())[1]) / 1e3


def collect(line):
    before = own_megabytes()
    gc.collect()
    line.send(own_megabytes() - before)


@pytest.mark.skipif(not MEMORY.exists(), reason=f"{sys.platform} does not tell what is shared")
def test_a_forked_process_shares_what_was_there_though_it_collects():
    pile = [[number] for number in range(300_000)]  # 20 MB
    mine, its = get_context("fork").Pipe()
    with memory_stays_shared():
        process = get_context("fork").Process(target=collect, args=(its,))
        process.start()
        taken = mine.recv()
        process.join()
        assert gc.get_freeze_count() > len(pile)
    assert taken < 5
    assert gc.get_freeze_count() == 0


@pytest.mark.skipif(not hasattr(os, "sched_getaffinity"), reason="Linux only")
def test_several_workers_have_a_core_each():
    cores = sorted(os.sched_getaffinity(0))
    team = workers._Team(None, workers.Manner("none", Allowance()), [])
    try:
        team.begin(2)
        limit = time.monotonic() + 60
        for k, worker in enumerate(team._workers):
            own = {cores[k % len(cores)]}
            while os.sched_getaffinity(worker.process.pid) != own and time.monotonic() < limit:
                time.sleep(0.01)
            assert os.sched_getaffinity(worker.process.pid) == own
    finally:
        team.stop()
    assert sorted(os.sched_getaffinity(0)) == cores


def test_a_single_worker_may_use_all_cores(monkeypatch):
    given = []

    def start(*arguments):
        given.append(arguments[-1])
        return workers._Worker(None, None)

    monkeypatch.setattr(workers, "_start", start)
    workers._Team(None, workers.Manner("none", Allowance()), []).begin(1)
    assert given == [None]
