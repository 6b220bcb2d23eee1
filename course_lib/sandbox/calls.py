"""Forbid calls of the kernel that no notebook needs, and that no namespace holds back (Linux).

Keys that the kernel keeps belong to a user, not to a namespace; sockets of other families than the
usual ones lead past the network's; some calls are doors that attackers of the kernel like; and who
moves to another core takes it from the submission that is graded there.
"""

from __future__ import annotations

import ctypes
import os
import platform
import struct
import sys

#: Names: the numbers on Intel and on ARM, each with 64 bits.
FORBIDDEN = {
    "sched_setaffinity": (203, 122),
    "add_key": (248, 217),
    "request_key": (249, 218),
    "keyctl": (250, 219),
    "perf_event_open": (298, 241),
    "bpf": (321, 280),
    "userfaultfd": (323, 282),
    "io_uring_setup": (425, 425),
    "io_uring_enter": (426, 426),
    "io_uring_register": (427, 427),
}
#: Which of the two, by machine: its name in the kernel (AUDIT_ARCH), `socket` and `seccomp`.
MACHINES = {"x86_64": (0, 0xC000003E, 41, 317), "aarch64": (1, 0xC00000B7, 198, 277)}
#: On Intel, calls from this number on have addresses of 32 bits.
SHORT_ADDRESSES = 0x40000000
#: Unix, IPv4, IPv6, netlink.
FAMILIES = (1, 2, 10, 16)
_LOAD, _EQUAL, _AT_LEAST, _RETURN = 0x20, 0x15, 0x35, 0x06
_CALL, _MACHINE, _FIRST_ARGUMENT = 0, 4, 16
_ALLOW, _NOT_PERMITTED, _NO_SUCH_FAMILY = 0x7FFF0000, 0x00050001, 0x00050061
_NO_NEW_PRIVILEGES, _FILTER, _AS_FAST = 38, 1, 4


def filter_program(machine: str) -> bytes:
    """Return the program by which the kernel decides on each call (seccomp, classic BPF).

    Parameters
    ----------
    machine : str
        One of `MACHINES`.

    Returns
    -------
    bytes
        Its instructions; see ``linux/filter.h`` and ``linux/seccomp.h``.
    """
    which, name, socket, _ = MACHINES[machine]
    steps = [(_LOAD, 0, 0, _MACHINE), (_EQUAL, 1, 0, name), (_RETURN, 0, 0, _NOT_PERMITTED)]
    steps += [(_LOAD, 0, 0, _CALL)]
    steps += [(_AT_LEAST, 0, 1, SHORT_ADDRESSES), (_RETURN, 0, 0, _NOT_PERMITTED)]
    for numbers in FORBIDDEN.values():
        steps += [(_EQUAL, 0, 1, numbers[which]), (_RETURN, 0, 0, _NOT_PERMITTED)]
    families = [step for f in FAMILIES for step in ((_EQUAL, 0, 1, f), (_RETURN, 0, 0, _ALLOW))]
    families = [(_LOAD, 0, 0, _FIRST_ARGUMENT), *families, (_RETURN, 0, 0, _NO_SUCH_FAMILY)]
    steps += [(_EQUAL, 0, len(families), socket), *families, (_RETURN, 0, 0, _ALLOW)]
    return b"".join(struct.pack("=HBBI", *step) for step in steps)


def forbid() -> None:
    """Forbid the calls in this process, and in all that it starts, for good.

    Raises
    ------
    OSError
        If the kernel refuses. On machines of another kind nothing is done.
    """
    machine = platform.machine()
    if not sys.platform.startswith("linux") or machine not in MACHINES:
        return
    program = filter_program(machine)
    code = ctypes.create_string_buffer(program, len(program))
    head = struct.pack("@HP", len(program) // 8, ctypes.addressof(code))
    library = ctypes.CDLL(None, use_errno=True)
    library.prctl(_NO_NEW_PRIVILEGES, 1, 0, 0, 0)
    if library.syscall(MACHINES[machine][3], _FILTER, _AS_FAST, head) != 0:
        number = ctypes.get_errno()
        raise OSError(number, f"seccomp: {os.strerror(number)}")
