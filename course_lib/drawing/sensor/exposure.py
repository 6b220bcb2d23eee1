"""Still figures: what exposure time, aperture, ISO and light do to a picture."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.diagrams import Floats, figure, panels, same_shape
from course_lib.drawing.explorers.exposure import exposure_frame
from course_lib.drawing.sensor.screen import picture
from course_lib.drawing.style import BLACK, BLUE, FULL_WIDTH, GREY, ROLES
from course_lib.sensor import exposure_value

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Settings = tuple[float | None, float, float, float]  # seconds, f-number, ISO, lux

#: Scenes by the exposure value that they ask for at ISO 100.
SCENES = (
    (15, "sun"),
    (12, "overcast sky"),
    (9, "bright hall"),
    (6, "living room"),
    (3, "street at night"),
)
#: Exposure times that the chart shows, s.
TIMES = (2e-5, 60.0)
#: Full stops of the f-number.
STOPS = (1.0, 1.4, 2.0, 2.8, 4.0, 5.6, 8.0, 11.0, 16.0, 22.0)


@figure(
    "Photographs of washers, nuts and a label on a belt, one for each setting: long exposures"
    " are smeared sideways, short ones dark or grainy."
)
def belt_photographs(
    settings: Sequence[Settings],
    speed: float = 800.0,
    detail: tuple[int, int, int, int] | None = None,
) -> Figure:
    """Show photographs of parts on a belt, taken with different settings.

    Parameters
    ----------
    settings : sequence of (seconds, f-number, ISO, lux)
        Of each photograph; without a time (None) there is none.
    speed : float
        Of the belt, mm/s.
    detail : (int, int, int, int), optional
        Left, top, width and height of the part that is shown, px; the whole without.

    Returns
    -------
    Figure
        The photographs beside each other, with their settings.
    """
    left, top, width, height = detail or (0, 0, 480, 320)
    fig, axes = panels(1, len(settings), (FULL_WIDTH, 2.6 * 3 / len(settings)), squeeze=False)
    for ax, (t, N, iso, lux) in zip(axes[0], settings, strict=True):
        usable = t is not None and 1e-6 <= t <= 30
        image = _photograph(t, N, iso, lux, speed) if usable and t else np.ones((320, 480))
        time = seconds(t) if t is not None else "your time"
        part = image[top : top + height, left : left + width]
        picture(ax, part, f"{time}, f/{N:g}, ISO {iso:g}\n{lux:g} lx")
    return fig


def _photograph(t: float, N: float, iso: float, lux: float, speed: float) -> NDArray[np.generic]:
    frame = exposure_frame(1000 * t, N, iso, lux, speed, False)
    return np.asarray(frame.pictures[0].image)


def seconds(t: float) -> str:
    """Return an exposure time as photographers write it: 1/125 s, but 2 s."""
    return f"{t:.3g} s" if not 0 < t < 0.3 else f"1/{1 / t:.0f} s"


@figure(
    "Openings of a lens from large to small; from each f-number to the next the area, and so "
    "the light, halves."
)
def apertures_to_scale(numbers: Sequence[float] = STOPS[3:9]) -> Figure:
    """Show the openings of a lens at full stops: each has half the area of the one before.

    Parameters
    ----------
    numbers : sequence of float
        F-numbers.

    Returns
    -------
    Figure
        The opening of one lens at each f-number, to scale, and its light by that of the first.
    """
    fig, axes = panels(1, len(numbers), (FULL_WIDTH, 1.9))
    turn = np.linspace(0, 2 * np.pi, 7)[:-1] + 0.3
    for k, (ax, N) in enumerate(zip(axes, numbers, strict=True)):
        radius = numbers[0] / N
        circle = np.linspace(0, 2 * np.pi, 90)
        ax.fill(1.08 * np.cos(circle), 1.08 * np.sin(circle), color=BLACK)
        ax.fill(radius * np.cos(turn), radius * np.sin(turn), color="#FFF3D6")
        ax.set(aspect="equal", xticks=[], yticks=[])
        ax.spines[:].set_visible(False)
        ax.set_title(f"f/{N:g}", fontsize=11, loc="center")
        ax.set_xlabel("light 1" if k == 0 else f"1/{2**k}")
    return fig


@figure(
    "Exposure time against f-number, both logarithmic: rising lines of equal exposure value, "
    "from a street at night to full sun, and a row of circles at 1/125 s. With an answer, dots "
    "where its exposure values lie: inside the circles, if it is right."
)
def exposure_chart(yours: ArrayLike | None = None) -> Figure:
    """Show which pairs of exposure time and f-number suit scenes of different brightness.

    Parameters
    ----------
    yours : array_like, shape (10,), optional
        The exposure values that a student's function gave for 1/125 s and the full stops.

    Returns
    -------
    Figure
        Lines of equal exposure value at ISO 100; the student's values at the full stops, each at
        the exposure time that belongs to it, or at the edge of the chart.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.8))
    N = np.geomspace(1, 22, 60)
    for value, name in SCENES:
        time = N**2 / 2.0**value
        ax.plot(N, time, color=GREY, lw=1.4)
        left = 2.2 if value > 12 else 8.5
        ax.text(left, 1.35 * left**2 / 2.0**value, f"EV {value}: {name}", fontsize=9, rotation=13)
    stops = np.array(STOPS)
    ax.plot(stops, np.full(10, 1 / 125), "o", mfc="none", mec=BLUE, ms=11, label="1/125 s")
    ax.set(xscale="log", yscale="log", xlabel="f-number (no unit)", ylabel="exposure time (s)")
    ax.set(xlim=(0.88, 24.5), ylim=TIMES)
    _your_values(ax, stops, same_shape(yours, exposure_value(stops, 1 / 125)))
    ax.set_xticks(stops, [f"{s:g}" for s in stops])
    ax.set_yticks([1e-4, 1e-2, 1], ["1/10000", "1/100", "1"])
    ax.minorticks_off()
    ax.legend(loc="lower right")
    return fig


def _your_values(ax: Axes, stops: Floats, values: Floats | None) -> None:
    """Put a dot where each of a student's exposure values lies, and write the value below it."""
    if values is None or not np.isfinite(values).all():
        return
    # EV = log2(N² / t), solved for t; what lies beyond the chart is put at its edge.
    times = np.clip(stops**2 / 2.0 ** np.clip(values, -60, 60), 2 * TIMES[0], TIMES[1] / 2)
    ax.plot(stops, times, "o", color=ROLES["second"], ms=6, label="your EV")
    paper = {"facecolor": "white", "edgecolor": "none", "pad": 0.8}
    for N, t, value in zip(stops, times, values, strict=True):
        aside, side = (t * 0.5, "top") if t > 10 * TIMES[0] else (t * 2, "bottom")
        ax.text(N, aside, f"{value:.1f}", ha="center", va=side, fontsize=8, bbox=paper)
