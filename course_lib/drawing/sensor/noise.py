"""Still figures: photons by chance, the curves of a sensor, and its gain measured."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.diagrams import figure, in_figures, panels, same_shape
from course_lib.drawing.sensor.screen import picture
from course_lib.drawing.style import BLUE, FULL_WIDTH, GREEN, GREY, ORANGE, RED, ROLES
from course_lib.sensor import SensorModel, sensor_response, signal_to_noise

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from data_generators.flats import Pairs


@figure(
    "Even grey patches with few to many photons in a pixel, from very grainy to smooth; the "
    "standard deviation of each is near the root of its mean."
)
def photon_patches(means: Sequence[float] = (4, 16, 100, 10_000), side: int = 60) -> Figure:
    """Show even grey surfaces that sent few and many photons into each pixel.

    Parameters
    ----------
    means : sequence of float
        Photons in a pixel, on average.
    side : int
        Of each patch, px.

    Returns
    -------
    Figure
        The patches, scaled to the same mean, with mean ± standard deviation as measured.
    """
    rng = np.random.default_rng(8)
    fig, axes = panels(1, len(means), (FULL_WIDTH, 2.5))
    for ax, mean in zip(axes, means, strict=True):
        counts = rng.poisson(mean, (side, side))
        picture(ax, 0.5 * counts / mean, f"{counts.mean():.0f} ± {counts.std():.1f} photons")
        ax.set_xlabel(f"SNR {counts.mean() / counts.std():.1f}")
    return fig


@figure(
    "The number in the file against photons: dashed lines at the full well and the largest "
    "number; with an answer, a straight line up to the full well, level beyond it."
)
def response_curve(sensor: SensorModel, yours: ArrayLike | None = None) -> Figure:
    """Show which number a sensor writes for how many photons.

    Parameters
    ----------
    sensor : SensorModel
        The sensor.
    yours : array_like, shape (13,), optional
        What a student's function gave for 0, 3000, 6000, ... 36 000 photons, DN.

    Returns
    -------
    Figure
        The full well and the largest number as dashed lines; with an answer, the mean number
        against photons, the student's and the course's.
    """
    photons, some = np.linspace(0, 36_000, 400), np.linspace(0, 36_000, 13)
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.1))
    drawn = same_shape(yours, sensor_response(some, sensor))
    if drawn is not None:
        numbers = sensor_response(photons, sensor)
        ax.plot(photons, numbers, color=BLUE, label="the course's function")
        ax.plot(some, drawn, "o", color=ROLES["second"], ms=8, label="your function")
        ax.legend(loc="upper left", bbox_to_anchor=(0.0, 0.86))
    full = sensor.full_well / sensor.quantum_efficiency
    ax.axvline(full, color=GREY, lw=1.2, ls=(0, (5, 3)))
    ax.text(full + 300, 300, f"{sensor.full_well:g} electrons:\nthe well is full", fontsize=9)
    ax.axhline(sensor.white, color=GREY, lw=1.2, ls=(0, (5, 3)))
    ax.text(300, sensor.white * 0.985, f"largest number {sensor.white}", fontsize=9, va="top")
    ax.set(xlabel="photons in a pixel (number)", ylabel="number in the file (DN)")
    ax.set(xlim=(-1000, 37_000), ylim=(0, 1.05 * sensor.white))
    return fig


@figure(
    "Signal-to-noise ratio against photons, logarithmic: steep where fixed noise rules in the"
    " dark, half as steep where shot noise rules."
)
def snr_curve(sensor: SensorModel, yours: ArrayLike | None = None) -> Figure:
    """Show how the signal-to-noise ratio of a pixel grows with its photons.

    Parameters
    ----------
    sensor : SensorModel
        The sensor.
    yours : array_like, shape (9,), optional
        What a student's function gave for 3, 10, 30, ... 30 000 photons.

    Returns
    -------
    Figure
        Logarithmic axes: the curve, and its two straight limits.
    """
    photons = np.geomspace(3, 30_000, 200)
    some = np.array([3, 10, 30, 100, 300, 1000, 3000, 10_000, 30_000], float)
    electrons = sensor.quantum_efficiency * photons
    dark = np.hypot(sensor.read_noise, sensor.quantisation_noise)
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.2))
    ax.plot(
        photons, np.sqrt(electrons), color=ORANGE, lw=1.5, label=r"shot noise alone: $\sqrt{n}$"
    )
    ax.plot(photons, electrons / dark, color=GREEN, lw=1.5, label="fixed noise alone: n / σ")
    ax.plot(photons, signal_to_noise(photons, sensor), color=BLUE, label="all noise")
    drawn = same_shape(yours, signal_to_noise(some, sensor))
    if drawn is not None:
        ax.plot(some, drawn, "o", color=ROLES["second"], ms=8, label="your function")
    ax.axhline(1, color=GREY, lw=1, ls=(0, (5, 3)))
    ax.set(xscale="log", yscale="log", ylim=(0.1, 300))
    ax.set(xlabel="photons in a pixel (number)", ylabel="SNR (ratio)")
    ax.legend(loc="upper left", fontsize=9)
    return fig


@figure(
    "Variance against mean for pairs of pictures: points on a straight line through zero, "
    "whose slope is the gain; the clipped lights lie far below it."
)
def photon_transfer(pairs: Pairs, white: float, gain: float | None = None) -> Figure:
    """Show the noise of a camera against its signal, as measured from pairs of pictures.

    Parameters
    ----------
    pairs : Pairs
        From `data_generators.flats.flat_pairs`.
    white : float
        The largest number of the camera, DN.
    gain : float, optional
        The slope that a student's function found, DN per electron.

    Returns
    -------
    Figure
        Variance against mean, a point for each light; clipped lights are open circles.
    """
    first, second, *dark = (np.asarray(part, float) for part in pairs)
    mean = (first + second).mean(axis=(1, 2)) / 2 - np.mean(dark)
    variance = (first - second).var(axis=(1, 2)) / 2 - (dark[0] - dark[1]).var() / 2
    shares = [(part >= white).mean(axis=(1, 2)) for part in (first, second)]
    clipped = np.maximum(*shares) > 0.001
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.2))
    ax.plot(mean[~clipped], variance[~clipped], "o", color=BLUE, ms=8, label="pairs")
    ax.plot(mean[clipped], variance[clipped], "o", mfc="none", mec=RED, ms=8, label="clipped pairs")
    ax.set(xlabel="mean above the dark picture (DN)", ylabel="variance (DN²)", ylim=0, xlim=0)
    slope = same_shape(gain, np.array(0.0))
    if slope is not None and np.isfinite(slope):
        x = np.array([0, mean.max()])
        label = f"your gain: {in_figures(float(slope), 3)} DN per electron"
        ax.plot(x, float(slope) * x, color=ROLES["second"], lw=2, label=label)
    ax.legend(loc="upper left")
    return fig
