"""Still figures: histograms, and what can be mended after the exposure."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.diagrams import Floats, figure, panels
from course_lib.drawing.explorers.street import renderer, upright_camera
from course_lib.drawing.sensor.screen import picture, shown
from course_lib.drawing.style import BLUE, FULL_WIDTH, RED
from course_lib.sensor import SensorModel, expose, grey_from_rgb, srgb_decode

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Numbers = NDArray[np.unsignedinteger]

#: The camera of these figures, and the photons that fill its wells.
SENSOR = SensorModel(full_well=15_000, read_noise=5, gain=0.27, offset=64, bits=12)
HIGHEST = 16  # % of the pixels: where the histograms are cut off
FULL = SENSOR.full_well / SENSOR.quantum_efficiency


@cache
def street_light() -> Floats:
    """Return the street in grey, linear in light, shape (320, 480), 1 for the brightest sky."""
    camera = upright_camera((0.5, -3.5, 1.65), 24, (36, 24))
    light = grey_from_rgb(srgb_decode(renderer().picture(camera) / 255))
    return np.asarray(light / np.percentile(light, 99.5))


def street_exposed(stops: float, sensor: SensorModel = SENSOR, seed: int = 2) -> Numbers:
    """Photograph the street.

    Parameters
    ----------
    stops : float
        More light than just fills the wells with the brightest sky; negative for less.
    sensor : SensorModel
        The camera.
    seed : int
        Of the noise.

    Returns
    -------
    ndarray, shape (320, 480)
        DN.
    """
    return expose(0.9 * FULL * 2.0**stops * street_light(), sensor, np.random.default_rng(seed))


def as_light(numbers: Numbers, sensor: SensorModel, factor: float = 1.0) -> Floats:
    """Return numbers on a scale from 0, the offset, to 1, the largest number, times a factor."""
    return (numbers.astype(float) - sensor.offset) / (sensor.white - sensor.offset) * factor


@figure(
    "A street under-exposed, well exposed and over-exposed; the histograms below are crowded "
    "on the left, spread out, and piled up against the right end."
)
def histogram_series(stops: tuple[float, ...] = (-3.0, 0.0, 2.0)) -> Figure:
    """Show a street too dark, right and too bright, each with its histogram.

    Parameters
    ----------
    stops : tuple of float
        Exposures, by the right one.

    Returns
    -------
    Figure
        Photographs above, histograms of their numbers below; red where they are clipped.
    """
    fig, axes = panels(2, len(stops), (FULL_WIDTH, 3.9), height_ratios=(1.25, 1), sharey="row")
    for (top, bottom), stop in zip(axes.T, stops, strict=True):
        numbers = street_exposed(stop)
        picture(top, shown(as_light(numbers, SENSOR)), f"{stop:+g} stops" if stop else "right")
        _histogram(bottom, numbers, SENSOR.white)
    axes[1, 0].set_ylabel("pixels (share in %)")
    axes[1, 0].set_ylim(0, HIGHEST)
    return fig


def _histogram(ax: Axes, numbers: Numbers, white: int) -> None:
    edges = np.linspace(0, white + 1, 65)
    share = 100 * np.histogram(numbers, edges)[0] / numbers.size
    ax.bar(edges[:-1], share, np.diff(edges), align="edge", color=BLUE)
    clipped = 100 * float((numbers >= white).mean())
    if clipped > 0.05:
        ax.bar(edges[-2], share[-1], edges[-1] - edges[-2], align="edge", color=RED)
        ax.text(0.95 * white, 11, f"{clipped:.0f} % clipped", ha="right", fontsize=9)
    if share.max() > HIGHEST:
        what = f"highest bar: {share.max():.0f} %,\ncut off here"
        ax.text(0.95 * white, 13.2, what, ha="right", fontsize=8)
    ax.set(xlabel="number (DN)", xlim=(0, white + 1))


@figure(
    "Two corrected pictures of a street with a detail each: the under-exposed one is complete"
    " and grainy, the sky of the over-exposed one is an even grey."
)
def corrected_afterwards(stops: tuple[float, float] = (-3.0, 2.0)) -> Figure:
    """Show an under- and an overexposed picture, both brought to the right brightness afterwards.

    Parameters
    ----------
    stops : tuple of float
        The two exposures, by the right one.

    Returns
    -------
    Figure
        The two corrected pictures, and a detail of each.
    """
    fig, axes = panels(2, 2, (FULL_WIDTH, 5.2))
    sky, shade = (slice(0, 110), slice(190, 355)), (slice(140, 250), slice(15, 180))
    for column, stop in enumerate(stops):
        light = as_light(street_exposed(stop), SENSOR, 2.0**-stop)
        word = "under" if stop < 0 else "over"
        title = f"{abs(stop):g} stops {word}exposed, corrected"
        picture(axes[0, column], shown(light), title)
        part = shade if stop < 0 else sky
        detail = "in the shade: noise" if stop < 0 else "in the sky: nothing left"
        picture(axes[1, column], shown(light[part]), detail)
    return fig


@figure(
    "Two details of a dark street, {factor:g} times brighter: amplified before digitising it "
    "has all grey values, multiplied afterwards only a few, with gaps in the histogram."
)
def gain_before_or_after(factor: float = 16.0, bits: int = 8) -> Figure:
    """Show the same few photons, amplified before they are made numbers, and afterwards.

    Parameters
    ----------
    factor : float
        Of the brightness.
    bits : int
        Of the camera.

    Returns
    -------
    Figure
        Two details of the street and their histograms.
    """
    base = SensorModel(full_well=15_000, read_noise=5, gain=0.016, offset=4, bits=bits)
    part = slice(120, 250), slice(10, 205)
    fig, axes = panels(2, 2, (FULL_WIDTH, 4.6), height_ratios=(1.7, 1))
    cases = ((base.amplified(factor), 1.0, "gain before"), (base, factor, "multiplied afterwards"))
    for (top, bottom), (sensor, after, title) in zip(axes.T, cases, strict=True):
        numbers = street_exposed(-np.log2(factor), sensor)
        light = np.clip(as_light(numbers, sensor, after), 0, 1)
        picture(top, shown(light[part]), f"{factor:g} times, {title}")
        values = np.rint(255 * light).astype(int)
        share = 100 * np.bincount(values.ravel(), minlength=256) / values.size
        bottom.bar(np.arange(256), share, width=1.3, color=BLUE)
        bottom.set(xlabel="number (DN)", xlim=(0, 256))
    for ax in axes[1]:
        ax.set_ylabel("pixels (%)")
    return fig
