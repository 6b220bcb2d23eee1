"""A rotating propeller, photographed row by row: what a rolling shutter makes of it."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import Array, check_numbers

Floats32 = NDArray[np.float32]

#: Of the propeller by its radius: the hub, and the widest half chord of a blade.
HUB, HALF_CHORD = 0.12, 0.1
TWO_PI = 2 * np.pi


class Propeller:
    """A propeller seen from the front, in the middle of a square picture.

    Parameters
    ----------
    size : int
        Side of the picture, px.
    blades : int
        How many.
    radius : float, optional
        From the axis to the tips, px; 0.46 of the side by default.

    Raises
    ------
    ValueError
        If there is no pixel or no blade.
    """

    def __init__(self, size: int, blades: int = 3, radius: float | None = None) -> None:
        if size < 2 or blades < 1:
            raise ValueError(f"expected size >= 2 and blades >= 1, got {size} and {blades}")
        self.size, self.blades = size, blades
        self.radius = 0.46 * size if radius is None else float(radius)
        v, u = np.indices((size, size), dtype=np.float32) - np.float32((size - 1) / 2)
        r = np.maximum(np.hypot(u, v), np.float32(0.5))
        self._direction = np.arctan2(-v, u).astype(np.float32)  # counter-clockwise on the page
        self._half_angle = self._blade_half_angle(r / np.float32(self.radius))
        self._pixel = 1 / r  # the angle that one pixel covers
        self._hub = np.clip(np.float32(HUB * self.radius) - r + np.float32(0.5), 0, 1)

    def _blade_half_angle(self, r: Floats32) -> Floats32:
        """Return half of the angle that a blade covers at radii r, 1 at the tip."""
        taper = np.clip((1 - r) / 0.04, 0, 1) * (1 - 0.45 * r)
        most = 0.8 * np.pi / self.blades
        return np.asarray(np.minimum(HALF_CHORD * taper / r, most), np.float32)

    def share(self, angle: ArrayLike, smear: float = 0.0) -> Floats32:
        """Return how much of each pixel's light comes from the propeller.

        Parameters
        ----------
        angle : array_like, shape (size,) or ()
            Where the first blade points in the middle of each row's exposure, counter-clockwise
            from the right, rad.
        smear : float
            Turn of the propeller during the exposure, rad.

        Returns
        -------
        ndarray, shape (size, size), float32
            From 0, background all the time, to 1.

        Raises
        ------
        TypeError, ValueError
            If an angle is not a finite number, or their number is not that of the rows.

        Notes
        -----
        A blade passes a pixel while the angle between them is within its half angle. The mean over
        the exposure is the integral of that indicator, a broken line, divided by the smear; the
        angle that the pixel covers is added to the smear, which smooths the edges.
        """
        rows = check_numbers(angle, "angle")
        if rows.shape not in ((), (self.size,)):
            raise ValueError(f"angle must have shape ({self.size},) or (), got {rows.shape}")
        apart = np.float32(TWO_PI / self.blades)
        phase = self._direction - np.mod(rows, apart).astype(np.float32).reshape(-1, 1)
        width = self._pixel + np.float32(abs(smear))
        after = _integral(phase + width / 2, self._half_angle, apart)
        before = _integral(phase - width / 2, self._half_angle, apart)
        return np.asarray(np.maximum((after - before) / width, self._hub), np.float32)


def _integral(angle: Floats32, half: Floats32, apart: np.float32) -> Floats32:
    """Return the integral from 0 to `angle` of the indicator of blades `apart` from each other."""
    turns = np.rint(angle / apart)
    return np.asarray(2 * half * turns + np.clip(angle - apart * turns, -half, half), np.float32)


def row_angles(
    size: int, turns_per_second: float, readout_time: float, start: float = np.pi / 2
) -> Array:
    """Return where the first blade points when the middle of each row's exposure comes.

    Parameters
    ----------
    size : int
        Rows of the picture; the first is exposed first.
    turns_per_second : float
        Of the propeller, counter-clockwise.
    readout_time : float
        From the first row to the last, s; 0 for a global shutter.
    start : float
        Where the first blade points at the middle row, rad.

    Returns
    -------
    ndarray, shape (size,)
        Angles, rad.
    """
    time = (np.arange(size) - (size - 1) / 2) / max(size - 1, 1) * readout_time
    return np.asarray(start + TWO_PI * turns_per_second * time)
