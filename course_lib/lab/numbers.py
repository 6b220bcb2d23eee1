"""Numbers that a reader writes into the lab: they are taken, or a sentence says what to write."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from course_lib.lab.words import say
from course_lib.measuring import pointing_sigma

#: Who points worse than that, px, has not pointed at the same place.
FAR = 5.0
#: No number of the lab is as large.
BEYOND = 1e300


@dataclass(frozen=True)
class Expected:
    """A number that is asked for.

    Attributes
    ----------
    write : str
        What it is, in which unit.
    usual : float
        What is taken if nothing usable was written.
    least, most : float
        Between these it can be meant.
    """

    write: str
    usual: float
    least: float
    most: float


#: By the name of the variable.
NUMBERS = {
    "bar": Expected("the length of the bar in mm, like 97.5", 100.0, 20.0, 400.0),
    "scale": Expected(
        "the σ of the bar divided by its length; 0.1 mm of 100 mm are 0.001", 0.001, 0.0, 0.02
    ),
    "unevenness": Expected("the σ of the target's corners in mm, like 0.1", 0.1, 0.0, 2.0),
    "pointing": Expected("the σ of a coordinate in px, like 0.5", 0.5, 0.01, 20.0),
}


def number(name: str, value: object) -> float:
    """Return a number that a reader wrote; if it cannot be meant, say so and return the usual one.

    Parameters
    ----------
    name : str
        Of the variable, one of `NUMBERS`.
    value : object
        What it holds.

    Returns
    -------
    float
        In the unit of that variable.
    """
    expected = NUMBERS[name]
    read = read_number(value)
    if isinstance(read, float) and not expected.least <= read <= expected.most:
        read = f"it should be between {expected.least:g} and {expected.most:g}"
    if isinstance(read, float):
        return read
    say(
        f"{name} = {value!r:.40} cannot be used: {read}. Write {expected.write}. "
        f"{expected.usual:g} is taken in its place: do not use what is measured with it."
    )
    return expected.usual


def read_number(value: object) -> float | str:
    """Return one finite number as a float, or why something is none, for who wrote it."""
    if isinstance(value, str):
        return "it is a text, and a number has no quotation marks and no unit"
    if value is None:
        return "nothing was written"
    if isinstance(value, tuple) and len(value) == 2 and all(type(part) is int for part in value):
        return f"decimals are written with a point, {value[0]}.{value[1]}"
    if isinstance(value, bool) or not isinstance(value, int | float | np.integer | np.floating):
        return "it is not one number"
    return float(value) if -BEYOND < value < BEYOND else "it is not a finite number"


def read_ruler(written: object) -> tuple[float, float] | str:
    """Return what a ruler says and its ±, mm, or why it cannot be used.

    Parameters
    ----------
    written : object
        A pair of numbers, if all is well.
    """
    if not isinstance(written, tuple | list):
        alone = read_number(written)
        return alone if isinstance(alone, str) else "its ± is missing"
    if len(written) != 2:
        return "it is not two numbers"
    read = [read_number(part) for part in written]
    for part, what in zip(read, ("the length", "its ±"), strict=True):
        if isinstance(part, str):
            return f"as to {what}, {part}"
        if part <= 0:
            return f"{what} is not larger than 0"
    length, plus_minus = (part for part in read if isinstance(part, float))
    return (length, plus_minus) if plus_minus < length else "its ± is as large as the length"


def other_unit(ruler: float, camera: float) -> str:
    """Return in which unit a length seems to be that should be in mm; empty if in mm.

    Parameters
    ----------
    ruler, camera : float
        The length as it was written, and as the camera measured it, mm.
    """
    for unit, size in (("cm", 10.0), ("m", 1000.0), ("inches", 25.4)):
        if abs(ruler * size / camera - 1) < 0.05:
            return unit
    return ""


def say_pointing(attempts: Sequence[Sequence[float]]) -> None:
    """Say how well somebody points, from several attempts at the same place.

    Parameters
    ----------
    attempts : sequence of (float, float)
        Pixels.
    """
    try:
        sigma = pointing_sigma(attempts)
    except (TypeError, ValueError):
        say(
            "attempts cannot be used: two or more pixels are needed, each with its column and row, "
            "like [(790.0, 479.5), (789.4, 479.8)]."
        )
        return
    say(f"σ of a coordinate: {sigma:.2f} px")
    if sigma > FAR:
        say("That is much: was it the same corner each time?")
    if sigma == 0:
        say("All attempts are the same: begin each one from the start.")
