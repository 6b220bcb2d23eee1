"""The inner walls: what separates one submission from the next in the same server (Linux).

The outer walls are bubblewrap's, put up once by the grader: no network, a read-only system,
nothing else in sight. Inside, each submission gets its own users, processes, mounts, temporary
folder and limits, made with the kernel's namespaces as bubblewrap makes them.
"""

from __future__ import annotations

import ctypes
import os
import resource
import sys
from contextlib import suppress
from pathlib import Path
from typing import Any

from course_lib.sandbox.limits import Allowance

_NEW_MOUNTS, _NEW_IPC, _NEW_USERS, _NEW_PROCESSES = 0x20000, 0x8000000, 0x10000000, 0x20000000
_NO_SETUID, _NO_DEVICES = 0x2, 0x4
_RECURSIVE, _PRIVATE = 0x4000, 0x40000
_DEATH_SIGNAL, _SET_DUMPABLE, _DROP_BOUND, _NO_NEW_PRIVILEGES = 1, 4, 24, 38
_ADOPT, _KILL = 36, 9
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
    """Ask the kernel to end this process when its parent ends; Linux can."""
    if not sys.platform.startswith("linux"):
        return
    _call("prctl", _DEATH_SIGNAL, _KILL, 0, 0, 0)


def adopt() -> None:
    """Become the parent of descendants whose own parent ends; Linux can."""
    if sys.platform.startswith("linux"):
        _call("prctl", _ADOPT, 1, 0, 0, 0)


def hide() -> None:
    """Keep this process from being traced or looked into by others of its user; Linux can."""
    if not sys.platform.startswith("linux"):
        return
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
    """Make namespaces of users, mounts and messages, and one of processes for the children.

    In them, this process is root, which gives it power over these namespaces only.
    """
    _new_users(_NEW_MOUNTS | _NEW_IPC | _NEW_PROCESSES, 0)


def can_nest() -> bool:
    """Return whether a process here can go behind walls of its own; some systems forbid it."""
    user, trial = os.getuid(), os.fork()
    if trial == 0:
        try:
            leave_the_others()
            inner = os.fork()
            if inner == 0:
                settle(Allowance(), user)
                os._exit(0)
            os._exit(os.waitstatus_to_exitcode(os.waitpid(inner, 0)[1]) != 0)
        except BaseException:
            os._exit(1)
    return os.waitpid(trial, 0)[1] == 0


def settle(allowance: Allowance, user: int) -> None:
    """As the first process of its namespace, mount what is its own, and give all power up.

    Parameters
    ----------
    allowance : Allowance
        How large the temporary folders are.
    user : int
        Who to be from now on: in a namespace of users below, without power over the mounts.
    """
    _call("mount", b"none", b"/", None, _RECURSIVE | _PRIVATE, None)
    _mount("proc", "/proc", "proc")
    for folder, share in _OWN_FOLDERS:
        size = int(allowance.files * share)
        _mount("tmpfs", folder, "tmpfs", f"size={size},nr_inodes=20000,mode=1777")
    for switch in ("shmall", "msgmni", "sem"):  # memory that belongs to no process
        _write(f"/proc/sys/kernel/{switch}", "0 0 0 0" if switch == "sem" else "0")
    _new_users(0, user)
    _write("/proc/sys/user/max_user_namespaces", "0")
    _give_up_power()


def _new_users(others: int, user: int) -> None:
    """Make a namespace of users, and become a user of it; and make other namespaces."""
    old_user, old_group = os.getuid(), os.getgid()
    _call("unshare", _NEW_USERS | others)
    _write("/proc/self/setgroups", "deny")
    _write("/proc/self/uid_map", f"{user} {old_user} 1")
    _write("/proc/self/gid_map", f"{user} {old_group} 1")


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
