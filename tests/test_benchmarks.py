"""What the benchmarks measure with: memory of a tree of processes, and the page of results."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from benchmarks import memory, table
from benchmarks.processes import with_all_below
from benchmarks.table import Row, write_section

PAIR = """
import os, time
taken = bytearray(os.urandom(1)) * 60_000_000
os.fork()
print(flush=True)
time.sleep(60)
"""


@pytest.mark.skipif(
    not Path("/proc/self/smaps_rollup").exists(), reason="this system does not tell it"
)
def test_what_two_processes_share_counts_once(monkeypatch):
    monkeypatch.setattr(memory, "LOOK", 0.01)
    with subprocess.Popen(
        [sys.executable, "-c", PAIR], stdout=subprocess.PIPE, start_new_session=True
    ) as process:
        process.stdout.readline()
        process.stdout.readline()  # both are there
        try:
            with memory.watched(process.pid) as peak:
                while not peak.megabytes:
                    time.sleep(0.01)
        finally:
            os.killpg(process.pid, signal.SIGKILL)
    assert 60 < peak.megabytes < 100


def test_a_process_that_has_ended_started_nothing():
    with subprocess.Popen([sys.executable, "-c", ""]) as process:
        process.wait()
    assert with_all_below(process.pid) == [process.pid]


def test_a_section_takes_the_place_of_its_old_one(monkeypatch, tmp_path):
    monkeypatch.setattr(table, "RESULTS", tmp_path / "results.md")
    for name, number in (("b", 1.0), ("a", 2.0), ("b", 300.4)):
        write_section(name, [Row("what", number, "ms", "a peer", 4.0, "≤ 1 ×")])
    page = (tmp_path / "results.md").read_text("utf-8")
    assert page.startswith(table.TITLE.rstrip())
    assert page.index("## a\n") < page.index("## b\n")
    assert page.count("## ") == 2
    assert "| what | 2 ms | a peer | 4 ms | 0.50 | ≤ 1 × |" in page
    assert "| what | 300 ms | a peer | 4 ms | 75.10 | ≤ 1 × |" in page
    assert "| what | 1 ms |" not in page
