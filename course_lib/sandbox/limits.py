"""How much a submission may use of the machine that grades it."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any


@dataclass(frozen=True)
class Allowance:
    """What one submission may use.

    Attributes
    ----------
    cell_seconds : float
        For one cell of the notebook.
    notebook_seconds : float
        For all its cells together.
    answer_seconds : float
        For one call of an answer.
    total_seconds : float
        From beginning to end.
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
    notebook_seconds: float = 120.0
    answer_seconds: float = 5.0
    total_seconds: float = 300.0
    processor_seconds: float = 150.0
    memory: int = 3_000_000_000
    processes: int = 64
    files: int = 200_000_000
    output: int = 100_000

    def as_dict(self) -> dict[str, Any]:
        """Return the numbers by name."""
        return asdict(self)
