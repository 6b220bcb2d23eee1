"""How much memory a process and all that it starts take at most."""

from __future__ import annotations

import re
import threading
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from types import TracebackType

#: Seconds between two looks.
LOOK = 0.2


class Peak:
    """Watches a tree of processes while a block runs.

    Pages that several processes share count once: each process counts its share of them.

    Attributes
    ----------
    megabytes : float
        The most that was seen.
    """

    def __init__(self, process: int) -> None:
        self._root, self._over = process, threading.Event()
        self._thread = threading.Thread(target=self._watch)
        self.megabytes = 0.0

    def __enter__(self) -> Peak:
        self._thread.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self._over.set()
        self._thread.join()

    def _watch(self) -> None:
        while not self._over.wait(LOOK):
            taken = sum(map(_share, _tree(self._root)))
            self.megabytes = max(self.megabytes, taken / 1e6)


def _tree(process: int) -> Iterator[int]:
    """Yield a process and all below it."""
    yield process
    for listed in Path(f"/proc/{process}/task").glob("*/children"):
        with suppress(OSError):
            for child in listed.read_text().split():
                yield from _tree(int(child))


def _share(process: int) -> float:
    """Return the bytes of a process, its share of what is shared."""
    with suppress(OSError):
        text = Path(f"/proc/{process}/smaps_rollup").read_text()
        found = re.search(r"^Pss:\s+(\d+) kB", text, re.MULTILINE)
        return 1024.0 * int(found[1]) if found else 0.0
    return 0.0
