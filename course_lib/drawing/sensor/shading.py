"""Still figures: light that is lost towards the corners, colours that part, and the flat field."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.diagrams import Floats, figure, panels, same_shape
from course_lib.drawing.sensor.screen import picture, shown
from course_lib.drawing.style import BLUE, FULL_WIDTH, GREY, ORANGE
from course_lib.sensor import (
    flat_field,
    lateral_chromatic_shift,
    mechanical_vignetting,
    vignetting,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from data_generators.flats import Uneven

DIAGONAL = 21.6  # mm: from the middle to the corner of a full-frame sensor


@figure(
    "Light against the distance from the middle of a picture for f = {f:g} mm: it falls with "
    "the fourth power of the cosine, and more when the lens is wide open; two white walls "
    "with dark corners."
)
def vignetting_profile(f: float = 24.0, pupils: tuple[float, float] = (12.0, 3.0)) -> Figure:
    """Show how much light a lens loses towards the corner, wide open and stopped down.

    Parameters
    ----------
    f : float
        Focal length, mm, on a sensor of 36 mm × 24 mm.
    pupils : tuple of float
        Diameters of the opening, mm.

    Returns
    -------
    Figure
        The share of the light against the distance from the middle, and an even wall.
    """
    r = np.linspace(0, DIAGONAL, 200)
    natural = vignetting(np.arctan2(r, f))
    fig, (ax, wide, small) = panels(1, 3, (FULL_WIDTH, 2.5), width_ratios=(1.5, 1, 1))
    ax.plot(r, 100 * natural, color=GREY, lw=8, alpha=0.4, label="cos⁴ alone")
    v, u = np.mgrid[-12:12:161j, -18:18:241j]
    across = np.arctan2(np.hypot(u, v), f)
    for pupil, colour, wall in zip(pupils, (ORANGE, BLUE), (wide, small), strict=True):
        rim = mechanical_vignetting(np.arctan2(r, f), pupil, 17.0, 7.0)
        ax.plot(r, 100 * natural * rim, color=colour, label=f"f/{f / pupil:g}")
        share = vignetting(across) * mechanical_vignetting(across, pupil, 17.0, 7.0)
        picture(wall, shown(0.95 * share), f"a white wall, f/{f / pupil:g}")
        corner = f"corner: {100 * share[0, 0]:.0f} %"
        wall.set_xlabel(corner, fontsize=9, loc="left")
    ax.set(xlabel="from the middle (mm)", ylabel="light (%)", ylim=(0, 105), xlim=0)
    ax.legend(loc="lower left", fontsize=8)
    return fig


@figure(
    "A checkerboard in the middle and in the corner of a picture: in the corner each edge has"
    " a coloured fringe."
)
def colour_fringes(scale: float = 1.006, size: int = 480) -> Figure:
    """Show the corner of a picture whose red image is larger than the green, and the blue smaller.

    Parameters
    ----------
    scale : float
        Magnification of red by that of green; blue has its inverse.
    size : int
        Side of the whole picture, px.

    Returns
    -------
    Figure
        The middle and a corner of a checkerboard, enlarged alike.
    """
    import cv2

    from data_generators.targets import checkerboard

    board = checkerboard(30, 30, size // 30, border=0)[:size, :size].astype(np.float32) / 255
    v, u = np.indices((size, size), dtype=float)
    middle = np.full(2, (size - 1) / 2)
    pixels, channels = np.stack([u.ravel(), v.ravel()], axis=1), []
    for factor in (scale, 1.0, 1 / scale):
        source = lateral_chromatic_shift(pixels, 1 / factor, middle).astype(np.float32)
        maps = source.reshape(size, size, 2)
        channels.append(cv2.remap(board, maps, None, cv2.INTER_LINEAR, None, cv2.BORDER_REPLICATE))
    rgb, n = shown(np.stack(channels, axis=2)), 64
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.4))
    picture(axes[0], rgb[(size - n) // 2 :, (size - n) // 2 :][:n, :n], "middle")
    shift = float(np.hypot(*middle) * (scale - 1))
    picture(axes[1], rgb[-n - 4 : -4, -n - 4 : -4], f"corner: red {shift:.1f} px outwards")
    return fig


@figure(
    "Four pictures: the belt with dark corners, white paper with the same dark corners and "
    "dust, a dark picture, and the belt corrected by your function once it answers."
)
def flat_field_series(pictures: Uneven, yours: ArrayLike | None = None) -> Figure:
    """Show a picture, its dark and flat pictures, and what dividing by them makes of it.

    Parameters
    ----------
    pictures : Uneven
        From `data_generators.flats.uneven_pictures`.
    yours : array_like, optional
        The corrected picture that a student's function gave, DN.

    Returns
    -------
    Figure
        The three pictures and the corrected one, and a row of grey values through the belt.
    """
    image, dark, flat = pictures
    corrected = flat_field(image, dark, flat)
    drawn = same_shape(yours, corrected)
    fig, axes = panels(2, 2, (FULL_WIDTH, 5.2))
    _in_dn(axes[0, 0], image, "the picture", 3200)
    _in_dn(axes[0, 1], flat, "white paper: the flat picture", 3600)
    _in_dn(axes[1, 0], dark, "no light: the dark picture, × 20", 64 + 3400 / 20, 64)
    if drawn is None:
        picture(axes[1, 1], np.ones(image.shape), "corrected by your function")
        axes[1, 1].text(240, 160, "your function", color=GREY, ha="center")
    else:
        _in_dn(axes[1, 1], np.nan_to_num(drawn), "corrected by your function", float(np.mean(flat)))
    return fig


def _in_dn(ax: object, numbers: Floats, title: str, white: float, black: float = 0.0) -> None:
    """Show numbers on a scale from black to white, encoded for the screen."""
    picture(ax, shown((numbers - black) / (white - black)), title)  # type: ignore[arg-type]
