"""What a reader can move: sliders, choices and switches, declared as data.

Every control has a finite list of positions, so that the number beside it, the picture and the
state in Python are always the same number. A bad value is moved to the nearest position.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np


@dataclass(frozen=True)
class Slider:
    """A number on a line of positions.

    Attributes
    ----------
    name : str
        The argument of the frame function, and the symbol in the code.
    label, symbol, unit : str
        In words, as in the formulas, and the unit.
    start, stop : float
        Ends of the range, in `unit`.
    default : float
        Where it stands at first; the nearest position is taken.
    step : float
        Distance of neighbouring positions, linear sliders only.
    steps : int
        Number of positions of a logarithmic slider; 0 makes a linear one.
    digits : int
        Decimals shown; on a logarithmic slider significant digits, 0 meaning 2.
    landmarks : tuple of float
        Values that a logarithmic slider must reach exactly.
    """

    name: str
    label: str
    symbol: str
    unit: str
    start: float
    stop: float
    default: float
    step: float = 1.0
    steps: int = 0
    digits: int = 0
    landmarks: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        if not self.start < self.stop:
            raise ValueError(f"slider {self.name}: start {self.start} must be below {self.stop}")
        if self.steps and self.start <= 0:
            raise ValueError(f"slider {self.name}: a logarithmic slider starts above 0")

    @cached_property
    def positions(self) -> list[float]:
        """Every value it can take, ascending."""
        if self.steps:
            values = np.geomspace(self.start, self.stop, self.steps)
            rounded = {float(f"{v:.{self.digits or 2}g}") for v in values}
            return sorted(rounded | {float(v) for v in (self.default, *self.landmarks)})
        count = round((self.stop - self.start) / self.step) + 1
        return [round(self.start + i * self.step, 10) for i in range(count)]

    def nearest(self, value: object) -> float:
        """Return the position nearest to `value`; the default where it is not a number.

        Parameters
        ----------
        value : object
            Anything a browser or a reader may send.

        Returns
        -------
        float
            A member of `positions`.
        """
        try:
            number = float(value)  # type: ignore[arg-type]
        except (TypeError, ValueError):
            number = self.default
        if math.isnan(number):
            number = self.default
        number = min(max(number, self.start), self.stop)
        return min(self.positions, key=lambda p: abs(p - number))

    def refusal(self, value: object) -> str:
        """Return nothing: every number has a nearest position."""
        return ""

    def text(self, value: float) -> str:
        """Return `value` as it is shown, without the unit; long numbers in groups of three."""
        decimals = self.digits
        if self.steps:
            decimals = max((self.digits or 2) - 1 - math.floor(math.log10(abs(value))), 0)
        if abs(value) < 10_000:
            return f"{value:.{decimals}f}"
        return f"{value:,.{decimals}f}".replace(",", "\N{NARROW NO-BREAK SPACE}")

    def spec(self) -> dict[str, Any]:
        """Return what the browser needs to show it."""
        positions = self.positions
        return {
            "kind": "slider",
            "name": self.name,
            "label": self.label,
            "symbol": self.symbol,
            "unit": self.unit,
            "values": positions,
            "texts": [self.text(p) for p in positions],
            "default": self.nearest(self.default),
        }


@dataclass(frozen=True)
class Choice:
    """One of a few named options; the names are the values."""

    name: str
    label: str
    options: tuple[str, ...]
    default: str

    def __post_init__(self) -> None:
        if self.default not in self.options:
            raise ValueError(f"choice {self.name}: {self.default!r} is not one of {self.options}")

    def nearest(self, value: object) -> str:
        """Return `value` if it is an option, else the default."""
        return value if isinstance(value, str) and value in self.options else self.default

    def refusal(self, value: object) -> str:
        """Return why a value from Python is refused, or nothing."""
        if value in self.options:
            return ""
        options = ", ".join(repr(option) for option in self.options)
        return f"{self.name} must be one of {options}, got {value!r}"

    def spec(self) -> dict[str, Any]:
        """Return what the browser needs to show it."""
        return {
            "kind": "choice",
            "name": self.name,
            "label": self.label,
            "options": list(self.options),
            "default": self.default,
        }


@dataclass(frozen=True)
class Switch:
    """Something that is on or off."""

    name: str
    label: str
    default: bool = False

    def nearest(self, value: object) -> bool:
        """Return `value` if it is true or false, else the default."""
        return value if isinstance(value, bool) else self.default

    def refusal(self, value: object) -> str:
        """Return why a value from Python is refused, or nothing."""
        return (
            "" if isinstance(value, bool) else f"{self.name} must be True or False, got {value!r}"
        )

    def spec(self) -> dict[str, Any]:
        """Return what the browser needs to show it."""
        return {
            "kind": "switch",
            "name": self.name,
            "label": self.label,
            "default": self.default,
        }


Control = Slider | Choice | Switch
