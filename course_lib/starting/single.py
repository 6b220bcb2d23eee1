"""One set-up at a time: a lock that ends with the program that holds it, however it ends."""

import contextlib
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path


def try_lock(handle: int) -> bool:
    """Return whether the open file is locked for this process now.

    Both systems free the lock when its holder ends, so none is ever stale.
    """
    try:
        if sys.platform == "win32":
            import msvcrt

            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        return False
    return True


@contextlib.contextmanager
def only_one(path: Path, say: Callable[[str], None]) -> Iterator[int]:
    """Wait until no other set-up runs; yield the lock's file descriptor.

    A child that inherits the descriptor (POSIX) holds the lock too: a pip that outlives its
    killed parent still keeps others out.

    Parameters
    ----------
    path : Path
        The lock's file. It stays behind, empty.
    say : callable
        Told once, if there is a wait.
    """
    with path.open("a") as file:
        told = False
        while not try_lock(file.fileno()):
            if not told:
                say("Another start is setting the course up; waiting for it (Ctrl-C to stop).")
            told = True
            time.sleep(0.3)
        yield file.fileno()
