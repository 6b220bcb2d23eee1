"""Watch the memory of all processes in sight together; the kernel's limits hold for each alone."""

from __future__ import annotations

import os
import resource
from collections.abc import Sequence
from contextlib import suppress


class MemoryWatch:
    """Knows when a submission's processes hold more than they may.

    Parameters
    ----------
    most : int
        Bytes.
    without : sequence of int
        Processes in sight that do not count.
    """

    def __init__(self, most: int, without: Sequence[int]) -> None:
        self._most, self._without = most, set(without)
        self._before = _shared_in_all()

    def is_too_much(self) -> bool:
        """Whether the processes hold more now, what several share counted once.

        What can be had cheaply is looked at first: sums that can only be too large.
        """
        names = (int(name) for name in os.listdir("/proc") if name.isdecimal())
        others = [number for number in names if number not in self._without]
        files = 0
        if _shared_in_all() - self._before > self._most // 2:  # somebody on this machine took it
            files = _files_in_memory(others)
        if files + sum(map(_resident, others)) <= self._most:
            return False
        return files + sum(map(_proportional, others)) > self._most


def _resident(process: int) -> int:
    with suppress(OSError), open(f"/proc/{process}/statm", "rb") as file:
        return int(file.read().split()[1]) * resource.getpagesize()
    return 0


def _proportional(process: int) -> int:
    """Return what a process holds, and its share of what several hold; all, if it hides that."""
    with suppress(OSError), open(f"/proc/{process}/smaps_rollup", "rb") as file:
        return next(int(line.split()[1]) for line in file if line.startswith(b"Pss:")) * 1024
    return _resident(process)


def _shared_in_all() -> int:
    """Return what files in memory take on the whole machine, without a name or with one."""
    with open("/proc/meminfo", "rb") as file:
        return next(int(line.split()[1]) for line in file if line.startswith(b"Shmem:")) * 1024


def _files_in_memory(processes: Sequence[int]) -> int:
    """Return what files without a name take that are held open; of unknown size, if hidden."""
    sizes = {}
    for process in processes:
        folder = f"/proc/{process}/fd"
        try:
            for name in os.listdir(folder):
                with suppress(OSError):
                    found = os.stat(f"{folder}/{name}")
                    if not found.st_nlink:
                        sizes[found.st_dev, found.st_ino] = found.st_blocks * 512
        except PermissionError:
            return 1 << 62
        except OSError:  # it has ended
            continue
    return sum(sizes.values())
