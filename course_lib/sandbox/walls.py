"""The inner walls: what separates one submission from the next in the same server (Linux).

The outer walls are bubblewrap's, put up once by the grader: no network, a read-only system,
nothing else in sight. Inside, each submission gets its own users, processes, mounts, temporary
folder and limits, made with the kernel's namespaces as bubblewrap makes them.
"""

from __future__ import annotations

import ctypes
import os
import resource
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from course_lib.sandbox.limits import Allowance

_NEW_MOUNTS, _NEW_IPC, _NEW_USERS, _NEW_PROCESSES = 0x20000, 0x8000000, 0x10000000, 0x20000000
_NO_SETUID, _NO_DEVICES = 0x2, 0x4
_RECURSIVE, _PRIVATE = 0x4000, 0x40000
_DEATH_SIGNAL, _SET_DUMPABLE, _DROP_BOUND, _NO_NEW_PRIVILEGES = 1, 4, 24, 38
_KILL = 9
#: Folders of its own, in memory: where, and which part of the allowance for files.
_OWN_FOLDERS = (("/tmp", 1.0), ("/dev/shm", 0.25))


class _Libc:
    """The C library's calls, which raise what went wrong."""

    def __init__(self) -> None:
        self._library = ctypes.CDLL(None, use_errno=True)

    def __call__(self, name: str, *arguments: Any) -> None:
        if getattr(self._library, name)(*arguments) != 0:
            number = ctypes.get_errno()
            raise OSError(number, f"{name}: {os.strerror(number)}")


_call = _Libc()


def die_with_parent() -> None:
    """Ask the kernel to end this process when its parent ends."""
    _call("prctl", _DEATH_SIGNAL, _KILL, 0, 0, 0)


def hide() -> None:
    """Keep this process from being traced or looked into by others of its user."""
    _call("prctl", _SET_DUMPABLE, 0, 0, 0, 0)


def become(user: int) -> None:
    """Mount the processes' folder as root, and go on as an ordinary user for good.

    Parameters
    ----------
    user : int
        The number of a user and group that own nothing.
    """
    with suppress(OSError):  # it may be bubblewrap's already
        _mount("proc", "/proc", "proc")
    os.setgroups([])
    os.setresgid(user, user, user)
    os.setresuid(user, user, user)
    _call("prctl", _SET_DUMPABLE, 1, 0, 0, 0)


def leave_the_others() -> None:
    """Make namespaces of users, mounts and messages, and one of processes for the children."""
    user, group = os.getuid(), os.getgid()
    _call("unshare", _NEW_USERS | _NEW_MOUNTS | _NEW_IPC | _NEW_PROCESSES)
    _write("/proc/self/setgroups", "deny")
    _write("/proc/self/uid_map", f"{user} {user} 1")
    _write("/proc/self/gid_map", f"{group} {group} 1")


def settle(allowance: Allowance) -> None:
    """As the first process of its namespace, mount what is its own, and give all power up."""
    _call("mount", b"none", b"/", None, _RECURSIVE | _PRIVATE, None)
    _mount("proc", "/proc", "proc")
    for folder, share in _OWN_FOLDERS:
        size = int(allowance.files * share)
        _mount("tmpfs", folder, "tmpfs", f"size={size},nr_inodes=20000,mode=1777")
    for switch in ("user/max_user_namespaces", "kernel/shmall", "kernel/msgmni"):
        with suppress(OSError):  # some kernels keep the last two to the machine's root
            _write(f"/proc/sys/{switch}", "0")
    _give_up_power()


def limit(allowance: Allowance) -> None:
    """Set what the kernel holds a process and its children to."""
    bounds = {
        resource.RLIMIT_AS: allowance.memory,
        resource.RLIMIT_CPU: int(allowance.processor_seconds),
        resource.RLIMIT_NPROC: allowance.processes,
        resource.RLIMIT_FSIZE: allowance.files,
        resource.RLIMIT_NOFILE: 256,
        resource.RLIMIT_CORE: 0,
        resource.RLIMIT_MEMLOCK: 0,
    }
    for which, most in bounds.items():
        hard = resource.getrlimit(which)[1]
        bound = most if hard == resource.RLIM_INFINITY else min(most, hard)
        resource.setrlimit(which, (bound, bound))
    with suppress(OSError):
        _write("/proc/self/oom_score_adj", "1000")


def _give_up_power() -> None:
    """Drop every capability, also for what is started later."""
    for capability in range(64):
        with suppress(OSError):
            _call("prctl", _DROP_BOUND, capability, 0, 0, 0)
    header = (ctypes.c_uint32 * 2)(0x20080522, 0)
    _call("capset", header, (ctypes.c_uint32 * 6)())
    _call("prctl", _NO_NEW_PRIVILEGES, 1, 0, 0, 0)


def _mount(source: str, target: str, kind: str, options: str = "") -> None:
    flags = _NO_SETUID | _NO_DEVICES
    words = [text.encode() for text in (source, target, kind)]
    _call("mount", *words, flags, options.encode() or None)


def _write(path: str, text: str) -> None:
    Path(path).write_text(text, encoding="ascii")


def too_much_memory(most: int, without: Sequence[int]) -> bool:
    """Return whether the processes in sight hold more than this, shared memory counted once.

    Parameters
    ----------
    most : int
        Bytes.
    without : sequence of int
        Processes that do not count.
    """
    numbers = [int(name) for name in os.listdir("/proc") if name.isdecimal()]
    others = [number for number in numbers if number not in without]
    if sum(map(_resident, others)) <= most:  # forks share most of it, so this is an upper bound
        return False
    return sum(map(_proportional, others)) > most


def _resident(process: int) -> int:
    with suppress(OSError), open(f"/proc/{process}/statm", "rb") as file:
        return int(file.read().split()[1]) * resource.getpagesize()
    return 0


def _proportional(process: int) -> int:
    """Return what a process holds, of what several hold its share."""
    with suppress(OSError), open(f"/proc/{process}/smaps_rollup", "rb") as file:
        return next(int(line.split()[1]) for line in file if line.startswith(b"Pss:")) * 1024
    return 0
