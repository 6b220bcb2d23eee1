"""Calls of the kernel that a submission must not make, in a process of its own."""

import subprocess
import sys

import pytest

from course_lib.sandbox.calls import FORBIDDEN, MACHINES, filter_program

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="Linux only")
TRIAL = """
import ctypes, os, platform, socket, subprocess
from course_lib.sandbox.calls import FORBIDDEN, MACHINES, forbid
forbid()
libc = ctypes.CDLL(None, use_errno=True)
which = MACHINES[platform.machine()][0]
for name, numbers in FORBIDDEN.items():
    assert (libc.syscall(numbers[which], 0, 0, 0, 0, 0), ctypes.get_errno()) == (-1, 1), name
for family in (socket.AF_UNIX, socket.AF_INET, socket.AF_INET6):
    socket.socket(family).close()
socket.socketpair()[0].close()
for family in (3, 15, 17, 29, 30, 31, 38, 40, 44):
    try:
        socket.socket(family, socket.SOCK_STREAM)
    except OSError as error:
        assert error.errno == 97, (family, error)
    else:
        raise AssertionError(family)
print(subprocess.run(["/bin/true"]).returncode, os.getpid() > 0)
"""


def test_they_are_refused_and_all_else_works():
    done = subprocess.run(
        [sys.executable, "-c", TRIAL], capture_output=True, text=True, check=False, timeout=60
    )
    assert (done.stdout, done.stderr) == ("0 True\n", "")


@pytest.mark.parametrize("machine", MACHINES)
def test_the_program_ends_on_every_way(machine):
    """Every jump stays inside, and the last instruction returns."""
    program = filter_program(machine)
    steps = [program[k : k + 8] for k in range(0, len(program), 8)]
    assert steps[-1][0] == 0x06
    assert all(k + 1 + max(s[2:4]) < len(steps) for k, s in enumerate(steps) if s[0] != 0x06)
    assert len({numbers[MACHINES[machine][0]] for numbers in FORBIDDEN.values()}) == len(FORBIDDEN)
