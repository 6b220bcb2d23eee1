"""Rows of a result, and the page they are written to."""

from __future__ import annotations

import os
import platform
import re
import subprocess
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path

RESULTS = Path(__file__).with_name("results.md")
TITLE = """# What was measured

Medians; ours and its peer took turns in the same run. `python -m benchmarks NAME …` measures again
and replaces the sections it measured.
"""
PACKAGES = (
    "numpy",
    "opencv-python-headless",
    "matplotlib",
    "ipywidgets",
    "anywidget",
    "jupyterlab",
)


@dataclass(frozen=True)
class Row:
    """One measurement: ours, and a peer if there is one, in the same unit."""

    what: str
    ours: float
    unit: str
    peer: str = ""
    theirs: float | None = None
    goal: str = ""

    def cells(self) -> list[str]:
        """Return the row as text."""
        theirs, ratio = "", ""
        if self.theirs is not None:
            theirs, ratio = self._text(self.theirs), f"{self.ours / self.theirs:.2f}"
        return [self.what, self._text(self.ours), self.peer, theirs, ratio, self.goal]

    def _text(self, number: float) -> str:
        """Return a number with its unit, to three digits or to whole ones."""
        return f"{number:.0f} {self.unit}" if number >= 100 else f"{number:.3g} {self.unit}"


def write_section(name: str, rows: list[Row]) -> None:
    """Put the rows of one entry into the page of results, in place of the old ones."""
    head = ["what", "ours", "peer", "theirs", "ours / theirs", "goal"]
    lines = [head, ["---"] * len(head), *(row.cells() for row in rows)]
    table = "\n".join("| " + " | ".join(line) + " |" for line in lines)
    section = f"## {name}\n\n{machine()}\n\n{table}\n"
    page = RESULTS.read_text("utf-8") if RESULTS.exists() else TITLE
    parts = [p for p in re.split(r"(?m)^(?=## )", page) if not p.startswith(f"## {name}\n")]
    parts = [part.rstrip() + "\n" for part in (*parts, section)]
    RESULTS.write_text("\n".join([parts[0], *sorted(parts[1:])]), "utf-8")


def machine() -> str:
    """Return when and on what this was measured."""
    from tests.browser.lab import chromium

    versions = [f"Python {platform.python_version()}"]
    versions += [f"{package} {version(package)}" for package in PACKAGES]
    if chromium():
        command = [str(chromium()), "--version"]
        found = subprocess.run(command, capture_output=True, text=True, check=False).stdout
        versions.append(" ".join(found.split()[:2]))
    busy = ", ".join(f"{load:.1f}" for load in os.getloadavg())
    return (
        f"{datetime.now(UTC):%Y-%m-%d}, {_processor()}, {os.cpu_count()} cores, {_priority()} "
        f"(load average afterwards {busy}); " + ", ".join(versions) + "."
    )


def _priority() -> str:
    """Return whether this ran ahead of everything else on a busy machine (``chrt -r 1``)."""
    ahead = hasattr(os, "sched_getscheduler") and os.sched_getscheduler(0) == os.SCHED_RR
    return "at real-time priority on a busy machine" if ahead else "at normal priority"


def _processor() -> str:
    """Return the name of the processor."""
    listed = Path("/proc/cpuinfo")
    names = re.findall(r"model name\s*: (.*)", listed.read_text()) if listed.exists() else []
    return names[0] if names else platform.processor() or platform.machine()
