"""What spoils pictures of a board: blur, noise, a reflection, paper that is not flat."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from course_lib.boards import Board
from course_lib.checks import Array, check_not_negative, check_number

Flaw = Literal["", "blurred", "glare", "cut off", "bent"]
FLAWS = get_args(Flaw)

#: Blur of a blurred view, by the width of the picture (3.5 px of 640).
BLURRED = 0.0055
#: Radius of a reflection by the width of the picture, and how bright it is by white paper.
GLARE, GLARE_LIGHT = 0.09, 2.5
#: How far the middle of a bent board stands out, by its width.
BEND = 0.02


@dataclass(frozen=True)
class Flaws:
    """What a picture suffers from.

    Attributes
    ----------
    flaw : str
        ``""``, ``"blurred"``, ``"glare"``, ``"cut off"`` (the camera sees to that) or ``"bent"``.
    blur : float
        Standard deviation of the blur of every picture, px.
    noise : float
        Standard deviation of the noise, grey levels of 255.

    Raises
    ------
    TypeError, ValueError
        If there is no such flaw or a number is negative.
    """

    flaw: Flaw = ""
    blur: float = 0.7
    noise: float = 2.0

    def __post_init__(self) -> None:
        if self.flaw not in FLAWS:
            raise ValueError(f"flaw must be one of {FLAWS}, got {self.flaw!r}")
        for name in ("blur", "noise"):
            check_number(check_not_negative(getattr(self, name), name), name)

    def bend(self, board: Board) -> float:
        """Return how far the middle of the board stands out towards the viewer."""
        return BEND * float(np.ptp(board.points()[:, 0])) if self.flaw == "bent" else 0.0


def flawed(light: Array, flaws: Flaws, points: Array, rng: np.random.Generator) -> Array:
    """Return the light of a picture with blur, a reflection and noise.

    Parameters
    ----------
    light : ndarray, shape (height, width)
        1 is white.
    flaws : Flaws
        What it suffers from.
    points : ndarray, shape (N, 2)
        Where the board is, px: a reflection lies on it.
    rng : numpy.random.Generator
        For the noise and the place of the reflection.

    Returns
    -------
    ndarray, shape (height, width)
        The spoilt light.
    """
    from scipy.ndimage import gaussian_filter

    width = light.shape[1]
    if flaws.flaw == "glare":
        v, u = np.indices(light.shape)
        middle = points[rng.integers(len(points))]
        away = np.hypot(u - middle[0], v - middle[1]) / (GLARE * width)
        light = light + GLARE_LIGHT * np.exp(-(away**4))
    blur = BLURRED * width if flaws.flaw == "blurred" else flaws.blur
    light = gaussian_filter(light, blur, mode="nearest") if blur else light
    return np.asarray(light + rng.normal(0, flaws.noise / 255, light.shape))
