"""What is said of a calibration."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Statement:
    """One sentence or two.

    Attributes
    ----------
    level : str
        ``"good"``, ``"note"`` or ``"bad"``.
    text : str
        What is so, and what to do.
    """

    level: str
    text: str

    @property
    def sign(self) -> str:
        """One character that stands for the level."""
        return {"good": "+", "note": "·", "bad": "!"}[self.level]
