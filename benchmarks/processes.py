"""Programs of this environment, and the processes that they start."""

from __future__ import annotations

import os
import sys
from contextlib import suppress
from pathlib import Path


def program(name: str) -> str:
    """Return where a program of the environment is whose Python this is."""
    return str(Path(sys.executable).with_name(name))


def clean_environment() -> dict[str, str]:
    """Return the environment without tuning of the BLAS for one kind of processor."""
    tuned = {"OPENBLAS_CORETYPE", "OPENBLAS_L2_SIZE"}
    return {name: value for name, value in os.environ.items() if name not in tuned}


def children(process: int) -> list[int]:
    """Return the processes that a process, or one of its threads, has started."""
    listed: list[int] = []
    with suppress(OSError):  # it has ended
        for thread in os.listdir(f"/proc/{process}/task"):
            with suppress(OSError):  # this one has
                text = Path(f"/proc/{process}/task/{thread}/children").read_text()
                listed += map(int, text.split())
    return listed


def with_all_below(process: int) -> list[int]:
    """Return a process and all that it has started, directly or not."""
    return [process, *(below for child in children(process) for below in with_all_below(child))]
