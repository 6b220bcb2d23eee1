"""Calls of the kernel that a submission must not make, in a process of its own."""

import struct
import subprocess
import sys

import pytest

from course_lib.sandbox.calls import (
    FAMILIES,
    FORBIDDEN,
    MACHINES,
    SHORT_ADDRESSES,
    filter_program,
)

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


def run(program):
    command = [sys.executable, "-c", program]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)


def test_they_are_refused_and_all_else_works():
    done = run(TRIAL)
    assert (done.stdout, done.stderr) == ("0 True\n", "")


def test_a_kernel_that_takes_no_filter_is_told_of():
    unknown = "calls.MACHINES = {name: (*m[:3], 9999) for name, m in calls.MACHINES.items()}"
    done = run(f"from course_lib.sandbox import calls; {unknown}; calls.forbid()")
    assert done.stderr.strip().endswith("seccomp: Function not implemented")


@pytest.mark.parametrize("machine", MACHINES)
def test_the_program_ends_on_every_way(machine):
    """Every jump stays inside, and the last instruction returns."""
    program = filter_program(machine)
    steps = [program[k : k + 8] for k in range(0, len(program), 8)]
    assert steps[-1][0] == 0x06
    assert all(k + 1 + max(s[2:4]) < len(steps) for k, s in enumerate(steps) if s[0] != 0x06)
    assert len({numbers[MACHINES[machine][0]] for numbers in FORBIDDEN.values()}) == len(FORBIDDEN)


ALLOWED, REFUSED, NO_SUCH_FAMILY = 0x7FFF0000, 0x00050000 | 1, 0x00050000 | 97


def decision(machine, call, *, on=None, argument=0):
    """Run a filter as the kernel does; return what it decides on a call."""
    name = MACHINES[machine][1] if on is None else on
    data = struct.pack("=IIQQ", call, name, 0, argument)
    steps = list(struct.iter_unpack("=HBBI", filter_program(machine)))
    value = place = 0
    while True:
        code, if_so, if_not, k = steps[place]
        place += 1
        if code == 0x20:
            (value,) = struct.unpack_from("=I", data, k)
        elif code == 0x06:
            return k
        else:
            place += if_so if {0x15: value == k, 0x35: value >= k}[code] else if_not


@pytest.mark.parametrize("machine", MACHINES)
def test_each_call_is_decided_on_as_it_should_be(machine):
    which, _, socket, _ = MACHINES[machine]
    forbidden = {numbers[which] for numbers in FORBIDDEN.values()}
    for call in {*range(600)} - {socket}:
        assert decision(machine, call) == (REFUSED if call in forbidden else ALLOWED), call
    for family in range(50):
        wanted = ALLOWED if family in FAMILIES else NO_SUCH_FAMILY
        assert decision(machine, socket, argument=family) == wanted, family


def test_calls_of_another_kind_are_refused():
    """32-bit programs number their calls in another way, and would get round the list."""
    for machine, other in (("x86_64", 0x40000003), ("aarch64", 0x40000028)):  # i386, ARM
        assert decision(machine, 0, on=other) == REFUSED
        assert decision(machine, SHORT_ADDRESSES) == REFUSED
        assert decision(machine, SHORT_ADDRESSES + 321) == REFUSED
        assert decision(machine, SHORT_ADDRESSES - 1) == ALLOWED
