"""How much a submission may use of the machine that grades it."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from math import inf
from typing import Any


@dataclass(frozen=True)
class Allowance:
    """What one submission may use.

    Attributes
    ----------
    cell_seconds : float
        Of the processor for one cell of the notebook; see `cell_clock`.
    notebook_seconds : float
        By the clock for all its cells together.
    answer_seconds : float
        Of the processor for one call of an answer; see `answer_clock`.
    total_seconds : float
        By the clock from beginning to end.
    processor_seconds : float
        Of one process.
    memory : int
        Bytes of one process, and of all together.
    processes : int
        Processes and threads at a time.
    files : int
        Bytes of temporary files.
    output : int
        Characters of a cell's output that are kept.
    """

    cell_seconds: float = 30.0
    notebook_seconds: float = 180.0
    answer_seconds: float = 5.0
    total_seconds: float = 300.0
    processor_seconds: float = 150.0
    memory: int = 3_000_000_000
    processes: int = 64
    files: int = 200_000_000
    output: int = 100_000

    @property
    def cell_clock(self) -> float:
        """Seconds by the clock for one cell: a machine may be busy, and a cell may wait."""
        return 2 * self.cell_seconds

    @property
    def answer_clock(self) -> float:
        """Seconds by the clock for one call of an answer: as for a cell."""
        return max(self.answer_seconds, self.cell_clock)

    def as_dict(self) -> dict[str, Any]:
        """Return the numbers by name."""
        return asdict(self)


def allowance_for(cell_seconds: float) -> Allowance:
    """Return the usual allowance, for cells that may take longer, or less long.

    Parameters
    ----------
    cell_seconds : float
        Of the processor for one cell. If it is more than usual, what all cells and the whole
        submission may take grows with it.

    Raises
    ------
    ValueError
        If it is no time.
    """
    if not 0 < cell_seconds < inf:
        raise ValueError(
            f"c.AnswerOutside.cell_seconds in nbgrader_config.py must be more than 0, "
            f"not {cell_seconds:g}"
        )
    usual = Allowance()
    more = max(1.0, cell_seconds / usual.cell_seconds)
    return Allowance(
        cell_seconds=cell_seconds,
        notebook_seconds=more * usual.notebook_seconds,
        total_seconds=more * usual.total_seconds,
        processor_seconds=more * usual.processor_seconds,
    )
