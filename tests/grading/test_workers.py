"""Workers share with the grader what was there before they were forked."""

import gc
import re
import sys
from multiprocessing import get_context
from pathlib import Path

import pytest

from course_lib.grading.workers import memory_stays_shared

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
