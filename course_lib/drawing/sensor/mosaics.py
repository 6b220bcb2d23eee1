"""Still figures: a small part of a picture behind the mosaic, and its colours guessed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera import Camera
from course_lib.drawing.diagrams import Floats, figure, panels, same_shape
from course_lib.drawing.explorers.street import renderer, upright_camera
from course_lib.drawing.sensor.screen import picture, shown
from course_lib.drawing.style import FULL_WIDTH, GREY
from course_lib.sensor import SensorModel, bayer_masks, bayer_mosaic, expose, srgb_decode

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def label_and_nut() -> Floats:
    """Return a small part of the belt with a nut in colour, linear in light, shape (48, 64, 3)."""
    from data_generators.belt import belt

    return np.asarray(np.clip(belt()[12:108:2, 184:312:2].astype(float), 0, 1))


def computed_raw() -> NDArray[np.uint16]:
    """Return a raw picture of the street, for those who cannot download a real one.

    Returns
    -------
    ndarray, shape (512, 768), uint16
        RGGB, 600 for no light and 15520 for white, red and blue weaker than green as in the real
        one; with noise.
    """
    camera = upright_camera((0.5, -3.5, 1.65), 28, (36, 24))
    size = (768, 512)
    K = camera.K * np.array([[1.6], [1.6], [1]])
    # The street's colours look natural as they are without encoding; so they are codes for light.
    street = srgb_decode(renderer().picture(Camera(K, camera.R, camera.t, size)) / 255)
    light = srgb_decode(street)
    sensor = SensorModel(full_well=40_000, gain=0.373, offset=600, bits=14)
    filtered = light / np.array([1.949, 1.0, 1.344])
    photons = bayer_mosaic(filtered).astype(float) * 40_000 / sensor.quantum_efficiency
    return expose(photons, sensor, np.random.default_rng(9)).astype(np.uint16)


@figure(
    "A brass nut: from the lens, behind a mosaic of red, green and blue filters, and, where they "
    "are asked for, with guessed colours; empty where your function does not answer yet."
)
def mosaic_and_back(
    light: ArrayLike,
    mosaic: ArrayLike | None = None,
    colours: ArrayLike | None = None,
    *,
    asked: bool = False,
) -> Figure:
    """Show a colour picture, what a mosaic leaves of it, and the colours guessed from that.

    Parameters
    ----------
    light : array_like, shape (rows, columns, 3)
        The picture, linear in light, 0 to 1.
    mosaic : array_like, shape (rows, columns), optional
        What a student's function made of it; shown in the colours of the filters.
    colours : array_like, shape (rows, columns, 3), optional
        What a student's function guessed from the mosaic.
    asked : bool
        Whether colours are asked for already; else there is no place for them.

    Returns
    -------
    Figure
        Two or three pictures; empty where there is no answer yet.
    """
    truth = np.asarray(light, dtype=float)
    seen = same_shape(mosaic, truth[..., 0])
    guessed = same_shape(colours, truth)
    filtered = None if seen is None else seen[..., None] * bayer_masks(seen.shape)
    fig, axes = panels(1, 2 + asked, (FULL_WIDTH, 2.3))
    picture(axes[0], shown(truth), "from the lens")
    _or_empty(axes[1], filtered, truth, "mosaic" if asked else "your mosaic")
    if asked:
        _or_empty(axes[2], guessed, truth, "your colours")
    return fig


def _or_empty(ax: Axes, light: Floats | None, truth: Floats, title: str) -> None:
    """Show a picture, or a white sheet of its size where there is none."""
    if light is None:
        picture(ax, np.ones_like(truth), title)
        ax.text(truth.shape[1] / 2, truth.shape[0] / 2, "not yet", color=GREY, ha="center")
    else:
        picture(ax, shown(np.nan_to_num(light)), title)
