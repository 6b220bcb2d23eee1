"""How far pip is, in one line that is drawn again and again (or a few lines in a file)."""

import re
import shutil
import sys
from dataclasses import dataclass
from typing import TextIO


@dataclass(frozen=True)
class Stage:
    """Where an installation stands: `done` of `total` packages, and what is at work."""

    doing: str
    done: int
    total: int
    name: str = ""

    def __str__(self) -> str:
        """Return the line that a student sees."""
        return f"{self.doing} {self.done} of {self.total}{': ' if self.name else ''}{self.name}"


def stage_of(log: str, pinned: int, unpacked: int) -> Stage | None:
    """Return how far pip is, once it has told which packages it leaves out.

    Parameters
    ----------
    log : str
        What pip printed so far.
    pinned : int
        Number of packages that the lock file pins, for all systems.
    unpacked : int
        Number of packages that this run has put into the environment.

    Returns
    -------
    Stage or None
        None until pip names the first package: then it has read the whole list.
    """
    installing = re.search(r"^Installing collected packages: (.*)$", log, re.MULTILINE)
    if installing:
        total = installing[1].count(",") + 1
        return Stage("Installing package", min(unpacked, total), total)
    ignored = len(re.findall(r"^Ignoring ", log, re.MULTILINE))  # those for other systems
    names = re.findall(
        r"^(?:Collecting|Requirement already satisfied:) ([\w.-]+)", log, re.MULTILINE
    )
    if not names:
        return None
    total = max(pinned - ignored, 1)
    return Stage("Getting package", min(len(names), total), total, names[-1])


class Line:
    """One line of progress: redrawn in a terminal, a new line each quarter elsewhere."""

    def __init__(self, stream: TextIO | None = None) -> None:
        self.stream = stream or sys.stdout
        self.redraws = self.stream.isatty()
        self.last = ""
        self.drawn = 0

    def show(self, stage: Stage | None) -> None:
        """Draw the stage, unless it says nothing new."""
        if stage is None:
            return
        quarter = f"{stage.doing}{4 * stage.done // stage.total}"
        news = str(stage) if self.redraws else quarter
        if news == self.last:
            return
        self.last = news
        if self.redraws:
            self._draw(str(stage)[: shutil.get_terminal_size().columns - 1])
        else:
            self._write(f"  {stage}\n")

    def clear(self) -> None:
        """Leave an empty line for what is said next."""
        if self.drawn:
            self.drawn += len("^C")  # which a terminal shows when that is why it ends
            self._draw("")
            self._write("\r")

    def _draw(self, text: str) -> None:
        self._write(f"\r{text:{self.drawn}}")  # blanks over what was there
        self.drawn = len(text)

    def _write(self, text: str) -> None:
        self.stream.write(text)
        self.stream.flush()
