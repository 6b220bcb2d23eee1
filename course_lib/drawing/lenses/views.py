"""Still figures of chapter 03 that look through a lens: markers on a wing, defocused and spread."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.diagrams import Floats, figure, panels
from course_lib.drawing.style import FULL_WIDTH
from course_lib.optics import (
    airy_diameter,
    aperture_diameter,
    circle_of_confusion,
    image_distance,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: The camera of chapter 01's data sheet: width of a pixel, mm.
PITCH = 27.6 / 2048
MARKER = 42.0  # mm: width of a marker on the wing
WAVELENGTH = 550e-6  # mm: green
CROP = 60  # px of the sensor in the series of apertures
SHOWN, FINE, MARGIN = 150, 2, 60  # px of the sensor; parts of one; subpixels around


@figure("Six star-shaped markers on a wing, {near:g} m to {far:g} m away, at f/{N:g}.")
def wing(
    N: float = 1.4, focus: float = 2.2, f: float = 85.0, near: float = 2.0, far: float = 2.5
) -> Figure:
    """Show how one camera sees markers at six distances.

    Parameters
    ----------
    N : float
        f-number.
    focus : float
        Distance on which the lens is focused, m.
    f : float
        Focal length, mm.
    near, far : float
        Distances of the first and the last marker, m.

    Returns
    -------
    Figure
        A part of the photograph for each marker, pixel by pixel, with its blur.
    """
    distances = np.linspace(near, far, 6)
    fig, axes = panels(2, 3, (FULL_WIDTH, 5.7))
    for ax, Z in zip(axes.flat, distances, strict=True):
        blur = float(circle_of_confusion(1000 * Z, 1000 * focus, f, N)) / PITCH
        _show(ax, through_lens(Z, focus, f, N))
        title = f"{Z:.1f} m: defocus {blur:.1f} px"
        ax.set_title(title, fontsize=11, fontweight="normal")
    working = image_distance(f, 1000 * focus) / aperture_diameter(f, N)
    disk = float(airy_diameter(WAVELENGTH, working)) / PITCH
    words = f"f = {f:g} mm at f/{N:g}, focused on {focus:g} m; Airy disk {disk:.1f} px everywhere"
    fig.suptitle(words, x=0.01, ha="left")
    return fig


@figure("The marker {Z:g} m away, through a lens focused on {focus:g} m, at several f-numbers.")
def aperture_series(
    numbers: Sequence[float] = (1.4, 4, 8, 16, 32, 64),
    Z: float = 2.0,
    focus: float = 2.2,
    f: float = 85.0,
) -> Figure:
    """Show one marker through all apertures of a lens, equally bright.

    Parameters
    ----------
    numbers : sequence of float
        f-numbers.
    Z, focus : float
        Distance of the marker, and the one on which the lens is focused, m.
    f : float
        Focal length, mm.

    Returns
    -------
    Figure
        The middle of the marker for each f-number, pixel by pixel.
    """
    rows = -(-len(numbers) // 3)
    fig, axes = panels(rows, 3, (FULL_WIDTH, 2.75 * rows), squeeze=False)
    for ax in axes.flat:
        ax.axis("off")
    for ax, N in zip(axes.flat, numbers, strict=False):
        middle = slice(SHOWN // 2 - CROP // 2, SHOWN // 2 + CROP // 2)
        _show(ax, through_lens(Z, focus, f, N)[middle, middle])
        ax.set_title(f"f/{N:g}")
    return fig


def through_lens(Z: float, focus: float, f: float, N: float) -> NDArray[np.uint8]:
    """Return a marker as the sensor sees it: defocused, spread by diffraction, on pixels.

    Parameters
    ----------
    Z, focus : float
        Distance of the marker, and the one on which the lens is focused, m.
    f, N : float
        Focal length in mm, and f-number.

    Returns
    -------
    ndarray, shape (SHOWN, SHOWN, 3), uint8
        RGB. Defocus and diffraction act one after the other, which is an approximation where
        both are equally large.
    """
    from data_generators.hole import Hole, Spread

    behind = float(image_distance(f, 1000 * focus))
    sharp = _sharp(behind * MARKER / (1000 * Z) / PITCH)
    spread = Spread(sharp, (MARGIN, MARGIN), (PITCH / FINE, PITCH / FINE))
    lens = Hole(float(aperture_diameter(f, N)), behind, WAVELENGTH)
    blur = float(circle_of_confusion(1000 * Z, 1000 * focus, f, N))
    fine = spread.through(lens, disk=blur).reshape(SHOWN, FINE, SHOWN, FINE, 3)
    seen = np.rint(np.clip(fine.mean(axis=(1, 3)), 0, 255))
    return np.asarray(seen, np.uint8)


def _sharp(width: float) -> Floats:
    """Return a star `width` px of the sensor wide in the middle of a grey wing, in subpixels."""
    import cv2

    side = SHOWN * FINE + 2 * MARGIN
    scale, middle = width * FINE / len(_star()), (side - 1) / 2
    # The warp takes a pixel of the result to one of the star; middles fall on each other.
    back = np.array([[1, 0, -middle], [0, 1, -middle]]) / scale
    back[:, 2] += (len(_star()) - 1) / 2
    flags = cv2.INTER_AREA | cv2.WARP_INVERSE_MAP
    smooth = cv2.GaussianBlur(_star(), (0, 0), 0.4 / scale)
    seen = cv2.warpAffine(
        smooth, back, (side, side), flags=flags, borderMode=cv2.BORDER_CONSTANT, borderValue=150
    )
    return np.asarray(seen, dtype=float)[..., None].repeat(3, axis=2)


@cache
def _star() -> NDArray[np.uint8]:
    """Return the marker: a star with a white rim."""
    from data_generators.targets import siemens_star

    return siemens_star(640, 24)


def _show(ax: Axes, picture: NDArray[np.uint8]) -> None:
    ax.imshow(picture)
    ax.axis("off")
