"""The explorers of chapter 05."""

from __future__ import annotations

from course_lib.drawing.explorers.distortion import distortion_frame
from course_lib.drawing.explorers.undistort import BOARDS, undistort_frame
from course_lib.widgets.controls import Choice, Slider
from course_lib.widgets.explorer import Explorer


def distortion_explorer(twelve: bool = False) -> Explorer:
    """Return the distortion explorer: coefficients of a lens and what they do to a picture.

    Parameters
    ----------
    twelve : bool
        Whether there are sliders for all twelve coefficients, or for the first five.

    Returns
    -------
    Explorer
        The picture, the displacements and the distances from the centre.
    """
    radial = [_coefficient(f"k{n}", f"k{'₁₂₃'[n - 1]}", "Radial", 0.6) for n in (1, 2, 3)]
    tangential = [_coefficient(f"p{n}", f"p{'₁₂'[n - 1]}", "Tangential", 0.05) for n in (1, 2)]
    below = [_coefficient(f"k{n}", f"k{'₄₅₆'[n - 4]}", "Rational", 0.6) for n in (4, 5, 6)]
    prism = [_coefficient(f"s{n}", f"s{'₁₂₃₄'[n - 1]}", "Prism", 0.05) for n in (1, 2, 3, 4)]
    more = [*below, *prism] if twelve else []
    return Explorer("Lens distortion", [*radial, *tangential, *more], distortion_frame)


def _coefficient(name: str, symbol: str, label: str, most: float) -> Slider:
    """Return the slider of a coefficient, from minus to plus the most, at zero."""
    step, digits = (0.01, 2) if most > 0.2 else (0.001, 3)
    return Slider(name, label, symbol, "", -most, most, 0, step=step, digits=digits)


def undistort_explorer() -> Explorer:
    """Return the undistort explorer: a photograph whose lines become straight."""
    first, *_ = BOARDS
    return Explorer(
        "Straighten a photograph",
        [
            Slider("k1", "Radial", "k₁", "", -0.6, 0.2, 0, step=0.01, digits=2),
            Slider("k2", "Radial", "k₂", "", -0.4, 0.4, 0, step=0.01, digits=2),
            Choice("photograph", "Photograph", tuple(BOARDS), first),
        ],
        undistort_frame,
    )
