"""A length that was measured, the ruler beside it, and whether its rays meet."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.lab.numbers import other_unit, read_ruler
from course_lib.lab.shots import Shot
from course_lib.lab.words import say
from course_lib.measuring import Measured, point_in_space, rays_miss

#: Rays that miss by so many times what was pointed with do not belong together: by chance, one
#: pair of points in 8000 would.
TOO_FAR = 3.0
#: Rays that meet at less leave the distance open, degrees.
NARROW_DEG = 20.0


@dataclass(frozen=True, eq=False)
class Result:
    """A length that was measured, and the ruler beside it.

    Attributes
    ----------
    name : str
        What was measured.
    length : Measured
        By the camera.
    ruler : tuple of float, optional
        By a ruler, and half the width of its interval of 95 %, mm.
    pointed : tuple of (Shot, ndarray)
        Photographs, and where both ends are in each, shape (2, 2), px.
    """

    name: str
    length: Measured
    ruler: tuple[float, float] | None
    pointed: tuple[tuple[Shot, NDArray[np.float64]], ...]

    @property
    def difference(self) -> float:
        """Camera minus ruler, mm; only with a ruler."""
        assert self.ruler is not None
        return self.length.value - self.ruler[0]

    @property
    def ratio(self) -> float:
        """The difference by what both are uncertain by, together: below 1, they agree.

        References
        ----------
        ISO 13528, the E_n number: ``|difference| / √(U₁² + U₂²)`` with intervals of 95 %.
        """
        assert self.ruler is not None
        return abs(self.difference) / float(np.hypot(self.length.plus_minus, self.ruler[1]))

    @property
    def said(self) -> str:
        """The result in a line."""
        if self.ruler is None:
            return f"{self.name}: {self.length}; not compared with a ruler"
        by_ruler = f"{self.ruler[0]:g} mm ± {self.ruler[1]:g} mm"
        verdict = "they agree" if self.ratio < 1 else "they do not agree"
        apart = f"{round(self.difference, 2) + 0.0:+.2f} mm, E = {self.ratio:.2f}: {verdict}"
        return f"{self.name}: {self.length}; ruler {by_ruler}; difference {apart}"

    def taken(self, pointing: float) -> str:
        """Return from where both ends were seen, and whether the rays meet, as sentences."""
        shots, pixels = zip(*self.pointed, strict=True)
        far = [shot.view.centre - shot.view.target.mean(axis=0) for shot in shots]
        told = " and ".join(f"{np.linalg.norm(away):.0f}" for away in far)
        said = f"The camera was {told} mm from the middle of the target."
        return said if len(shots) == 1 else f"{said} {meeting(shots, pixels, pointing)}"


def result(name: str, length: Measured, ruler: object, *pointed: tuple[Shot, ArrayLike]) -> Result:
    """Return a length beside what a ruler says of it.

    Parameters
    ----------
    name : str
        What was measured.
    length : Measured
        By the camera.
    ruler : tuple of float
        By a ruler, and its ± (95 %), mm. If that cannot be meant, a sentence says so, and the
        length is compared with nothing.
    *pointed : tuple of (Shot, array_like)
        Photographs, and where both ends are in each, shape (2, 2), px.
    """
    seen = tuple((shot, np.asarray(ends, float)) for shot, ends in pointed)
    read = read_ruler(ruler)
    if isinstance(read, str):
        say(
            f"{name}: the ruler's value {ruler!r:.40} cannot be used: {read}. Write the length and "
            "its ± in mm, like (85.5, 0.7)."
        )
        return Result(name, length, None, seen)
    if unit := other_unit(read[0], length.value):
        say(f"{name}: the camera found {length}. Is {read[0]:g} in {unit}? Write mm.")
    return Result(name, length, read, seen)


def meeting(shots: Sequence[Shot], pointed: Sequence[ArrayLike], pointing: float) -> str:
    """Return whether the rays of two photographs meet, in sentences.

    Parameters
    ----------
    shots : sequence of Shot
        Two photographs.
    pointed : sequence of array_like, shape (2, 2)
        Pixels of both ends in each.
    pointing : float
        Standard deviation of a coordinate that is pointed at, px.

    Returns
    -------
    str
        By how much they miss and at which angle they meet; more if that is too much or too little.
    """
    views = [shot.view for shot in shots]
    pixels = np.stack([np.asarray(ends, float) for ends in pointed])
    miss, angle = rays_miss(pixels, views), rays_angle_deg(shots, pixels)
    said = f"The rays miss each other by {miss:.2f} px, and meet at {angle:.0f}°."
    if miss > TOO_FAR * pointing:
        said += (
            f" That is far more than the {pointing:g} px that you point to: are the marks at the "
            "same two points in both pictures, in the same order? Has something moved? Do not "
            "believe this ±."
        )
    if angle < NARROW_DEG:
        said += " That angle is small: small errors along the rays become large ones."
    return said


def rays_angle_deg(shots: Sequence[Shot], pixels: ArrayLike) -> float:
    """Return at which angle the rays of two photographs meet, midway between both ends.

    Parameters
    ----------
    shots : sequence of Shot
        Two photographs.
    pixels : array_like, shape (2, 2, 2)
        Both ends in each, px.
    """
    views = [shot.view for shot in shots]
    middle = point_in_space(pixels, views).mean(axis=0)
    one, other = (view.centre - middle for view in views)
    cosine = one @ other / (np.linalg.norm(one) * np.linalg.norm(other))
    return float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))
