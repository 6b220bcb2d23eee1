"""How long a submission's cells may take."""

import json
import subprocess
import sys

import pytest

from course_lib.sandbox.limits import Allowance, allowance_for

#: Cells that may compute for 0.3 s and take 0.6 s; for the last two so many seconds are left.
CELLS = {
    "waits": ("import time; time.sleep(0.4); print('here')", 60),
    "computes": ("while True: pass", 60),
    "computes after an attempt": (
        "from course_lib.sandbox.plain_notebook import attempt\n"
        "print(attempt(lambda: 3))\nwhile True: pass",
        60,
    ),
    "sleeps": ("time.sleep(60)", 60),
    "swallows": ("try:\n    time.sleep(60)\nexcept BaseException: print('no')", 60),
    "comes late": ("time.sleep(60)", 0.1),
    "comes too late": ("time.sleep(60)", -3),
}
RUN = f"""
import json
from course_lib.sandbox.limits import Allowance
from course_lib.sandbox.notebook import _run_cell, make_shell
shell, allowance = make_shell(), Allowance(cell_seconds=0.3)
cells = {[*CELLS.values()]!r}
print(json.dumps([_run_cell(shell, source, allowance, left) for source, left in cells]))
"""


def test_a_cell_may_compute_so_long_and_wait_a_little_longer():
    done = subprocess.run([sys.executable, "-c", RUN], capture_output=True, text=True, check=True)
    outputs = dict(zip(CELLS, json.loads(done.stdout), strict=True))
    assert outputs.pop("waits") == [{"output_type": "stream", "name": "stdout", "text": "here\n"}]
    assert outputs["computes after an attempt"][0]["text"] == "3\n"
    assert outputs["swallows"][0]["text"] == "no\n"
    said = {name: shown[-1]["evalue"] for name, shown in outputs.items()}
    late = {said.pop("comes late"), said.pop("comes too late")}
    stopped = "This cell was stopped after 0.3 seconds of computing, or 0.6 by the clock."
    assert said == dict.fromkeys(said, stopped)
    assert late == {
        "This cell was stopped after all cells together had taken 180 seconds by the clock. "
        "Which of them takes so long?"
    }


def test_longer_cells_have_longer_notebooks():
    usual = Allowance()
    assert allowance_for(usual.cell_seconds) == usual
    long = allowance_for(4 * usual.cell_seconds)
    assert long.cell_seconds == 4 * usual.cell_seconds
    assert long.notebook_seconds == 4 * usual.notebook_seconds
    assert long.total_seconds == 4 * usual.total_seconds
    assert long.processor_seconds == 4 * usual.processor_seconds
    short = allowance_for(1.0)
    assert (short.cell_seconds, short.notebook_seconds) == (1.0, usual.notebook_seconds)
    for allowance in (usual, long):  # a cell that takes too long leaves time for the others
        assert 2 * allowance.cell_clock < allowance.notebook_seconds < allowance.total_seconds


@pytest.mark.parametrize("seconds", [0.0, -1.0, float("inf"), float("nan")])
def test_what_is_no_time_is_refused(seconds):
    with pytest.raises(ValueError, match="must be more than 0"):
        allowance_for(seconds)
