"""How much memory a process and all that it starts take at most."""

from __future__ import annotations

import re
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from benchmarks.processes import with_all_below

#: Seconds between two looks.
LOOK = 0.2


@dataclass
class Peak:
    """The most that was seen, in MB."""

    megabytes: float = 0.0


@contextmanager
def watched(process: int) -> Iterator[Peak]:
    """Watch a tree of processes while a block runs.

    Pages that several processes share count once: each process counts its share of them.

    Parameters
    ----------
    process : int
        The tree's root.

    Yields
    ------
    Peak
        Filled in until the block is left.
    """
    peak, over = Peak(), threading.Event()

    def watch() -> None:
        while not over.wait(LOOK):
            taken = sum(map(_share, with_all_below(process)))
            peak.megabytes = max(peak.megabytes, taken / 1e6)

    thread = threading.Thread(target=watch)
    thread.start()
    try:
        yield peak
    finally:
        over.set()
        thread.join()


def _share(process: int) -> float:
    """Return the bytes of a process, with its share of what is shared; 0 if it has ended."""
    with suppress(FileNotFoundError, ProcessLookupError):
        text = Path(f"/proc/{process}/smaps_rollup").read_text()
        found = re.search(r"^Pss:\s+(\d+) kB", text, re.MULTILINE)
        return 1024.0 * int(found[1]) if found else 0.0
    return 0.0
