"""What a data sheet says of an image sensor. Use it through `course_lib.sensor`.

Counts of electrons are those of one pixel and one exposure; DN ("digital number") is what the
file holds.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from course_lib.checks import check_length, check_not_negative, check_number


@dataclass(frozen=True)
class SensorModel:
    """What a data sheet says of an image sensor: how light becomes numbers.

    Attributes
    ----------
    quantum_efficiency : float
        Electrons set free for each photon, above 0 and at most 1.
    full_well : float
        Electrons that a pixel can hold.
    read_noise : float
        Standard deviation that the readout adds, in electrons.
    dark_current : float
        Electrons that warmth sets free in a pixel, per second.
    gain : float
        DN for each electron. The amplifier sits before the digitiser; ISO turns this knob.
    offset : float
        DN of a picture without light, so that noise can go both ways.
    bits : int
        Numbers run from 0 to ``2**bits - 1``; 1 to 16.

    Raises
    ------
    TypeError, ValueError
        If a value is outside its range.

    References
    ----------
    EMVA Standard 1288, release 4.0 (linear), section 2.
    """

    quantum_efficiency: float = 0.6
    full_well: float = 15_000.0
    read_noise: float = 5.0
    dark_current: float = 2.0
    gain: float = 0.25
    offset: float = 64.0
    bits: int = 12

    def __post_init__(self) -> None:
        if not 0 < check_number(self.quantum_efficiency, "quantum_efficiency") <= 1:
            raise ValueError(
                f"quantum_efficiency must be above 0 and at most 1, got {self.quantum_efficiency}: "
                "60 % is 0.6"
            )
        check_length(self.full_well, "full_well")
        check_length(self.gain, "gain")
        for name in ("read_noise", "dark_current", "offset"):
            check_number(check_not_negative(getattr(self, name), name), name)
        if self.bits not in range(1, 17):
            raise ValueError(f"bits must be a whole number from 1 to 16, got {self.bits}")
        if self.offset >= self.white:
            raise ValueError(f"offset must be below {self.white}, the largest number: no room left")

    @property
    def white(self) -> int:
        """The largest number that the digitiser can write, in DN."""
        return (1 << int(self.bits)) - 1

    @property
    def saturation(self) -> float:
        """Electrons beyond which a picture is white: the well is full, or the numbers end."""
        return min(self.full_well, (self.white - self.offset) / self.gain)

    @property
    def quantisation_noise(self) -> float:
        """Standard deviation of rounding to whole numbers, ``1 / √12`` DN, in electrons."""
        return 1 / (math.sqrt(12) * self.gain)

    def amplified(self, factor: float) -> SensorModel:
        """Return the sensor with its gain multiplied, as at `factor` times the ISO speed."""
        return replace(self, gain=self.gain * check_length(factor, "factor"))
