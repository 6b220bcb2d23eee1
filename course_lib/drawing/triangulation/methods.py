"""Still figures that compare ways to triangulate, and count cameras."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from course_lib.camera import camera_at
from course_lib.drawing.diagrams import Floats, figure, panels
from course_lib.drawing.style import FULL_WIDTH, GREY, ROLES
from course_lib.triangulation import (
    point_covariance,
    refine_point,
    triangulate_linear,
    triangulate_midpoint,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

K = np.array([[800.0, 0, 319.5], [0, 800, 239.5], [0, 0, 1]])
SIZE = (640, 480)
NOISE = 0.5  # px
TRIALS = 4000
#: Where two cameras stand that look at the origin, m; z is up.
SETUPS: dict[str, tuple[tuple[float, float, float], ...]] = {
    "4 m away, 1 m apart": ((-0.5, -4, 0), (0.5, -4, 0)),
    "1 m and 10 m away": ((0, -1, 0), (10, 0, 0)),
    "4 m away, 6 cm apart": ((-0.03, -4, 0), (0.03, -4, 0)),
}
METHODS = {"midpoint": "camera", "linear": "second", "refined": "object"}
COUNTS = (2, 3, 4, 6, 8, 12, 16)
ARC = 2 * np.arctan(0.5 / 4)  # rad: the angle of 1 m at 4 m


def cameras(eyes: Sequence[Sequence[float]]) -> Floats:
    """Return camera matrices, (V, 3, 4), of cameras that look at the origin."""
    return np.stack([camera_at(eye, (0, 0, 0), K, SIZE).P for eye in eyes])


def pixels_of_origin(P: Floats, seed: int = 1) -> Floats:
    """Return where cameras see the origin, (V, TRIALS, 2), with noise."""
    exact = P[:, :2, 3] / P[:, 2:, 3]
    noise = np.random.default_rng(seed).standard_normal((len(P), TRIALS, 2))
    return np.asarray(exact[:, None] + NOISE * noise)


@cache
def answers(setup: str) -> dict[str, Floats]:
    """Return what each method finds for the origin in many tries, (TRIALS, 3), m.

    Parameters
    ----------
    setup : str
        A key of `SETUPS`.

    Returns
    -------
    dict of str to ndarray
        By method.
    """
    P = cameras(SETUPS[setup])
    seen = pixels_of_origin(P)
    middle = triangulate_midpoint(*seen, *P)
    linear = triangulate_linear(seen, P)
    return {"midpoint": middle, "linear": linear, "refined": refine_point(middle, seen, P)}


def rms_mm(found: Floats) -> float:
    """Return the root mean square of points' distances from the origin, or of numbers, m to mm."""
    return 1000 * float(np.sqrt((found.reshape(len(found), -1) ** 2).sum(axis=1).mean()))


@figure("Errors of three methods: alike for two cameras side by side, not for one near, one far.")
def methods_compared() -> Figure:
    """Show how far midpoint, linear and refined answers are off, for three set-ups.

    Returns
    -------
    Figure
        Bars: the whole error of two set-ups, and the height alone for cameras near and far.
    """
    side, unequal, close = SETUPS
    shown = (
        (side, "whole error", {n: rms_mm(X) for n, X in answers(side).items()}),
        (unequal, "whole error", {n: rms_mm(X) for n, X in answers(unequal).items()}),
        (unequal, "height alone", {n: rms_mm(X[:, 2]) for n, X in answers(unequal).items()}),
        (close, "whole error", {n: rms_mm(X) for n, X in answers(close).items()}),
    )
    fig, axes = panels(1, 4, (FULL_WIDTH, 3.1))
    for ax, (setup, part, errors) in zip(axes, shown, strict=True):
        bars = ax.bar(
            list(errors), list(errors.values()), color=[ROLES[r] for r in METHODS.values()]
        )
        low = -0.04 * max(errors.values())
        for bar, (name, value) in zip(bars, errors.items(), strict=True):
            x = bar.get_x() + bar.get_width() / 2
            ax.text(x, value * 1.02, _two_digits(value), ha="center", va="bottom", fontsize=10)
            ax.text(x, low, name, ha="center", va="top", rotation=90, fontsize=10)
        ax.set_title(f"{setup}\n{part}", fontsize=10)
        ax.set_ylim(-0.42 * max(errors.values()), 1.14 * max(errors.values()))
        ax.axhline(0, color=GREY, lw=0.8)
        ax.set(xticks=[], yticks=[])
        ax.spines[:].set_visible(False)
    axes[0].set_ylabel("RMS error (mm)")
    return fig


def _two_digits(value: float) -> str:
    """Return a positive number as text, with two digits: chance leaves no more of them."""
    after = 1 - int(np.floor(np.log10(value)))
    return f"{round(value, after):.{max(after, 0)}f}"


@figure("More cameras within the same angle help little; a wider angle helps much.")
def more_cameras() -> Figure:
    """Show the error in depth and sideways against the number of cameras on an arc.

    Returns
    -------
    Figure
        Lines as predicted by the covariance, dots as simulated, for two arcs.
    """
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.0), sharey=True)
    for ax, wide, name in zip(axes, (1, 4), ("on an arc of 14°", "on an arc of 57°"), strict=True):
        predicted, found = zip(*(arc_errors(n, wide * ARC) for n in COUNTS), strict=True)
        for k, (label, role, up) in enumerate(
            (("in depth", "object", 9), ("sideways", "camera", 8))
        ):
            values = [one[k] for one in predicted]
            ax.plot(COUNTS, values, "-", color=ROLES[role])
            ax.plot(COUNTS, [one[k] for one in found], "o", color=ROLES[role], ms=5)
            ax.annotate(
                label if ax is axes[0] else "",
                (COUNTS[-1], values[-1]),
                (0, up),
                textcoords="offset points",
                color=ROLES[role],
                ha="right",
            )
        ax.set(xlabel="cameras (number)", title=name, xticks=(2, 4, 8, 12, 16), ylim=(0, 16))
    axes[0].set_ylabel("standard deviation (mm)")
    axes[1].plot([], [], "-", color=GREY, label="line: by the formula")
    axes[1].plot([], [], "o", color=GREY, ms=5, label=f"dot: {TRIALS} tries")
    axes[1].legend(loc="upper right")
    return fig


@cache
def arc_errors(count: int, angle: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return predicted and simulated errors in depth and sideways, mm, of cameras on an arc.

    Parameters
    ----------
    count : int
        Number of cameras, evenly over the arc, 4 m from the point.
    angle : float
        From the first camera to the last, seen from the point, rad.

    Returns
    -------
    predicted, simulated : tuple of float
        Standard deviation or RMS in depth, and sideways, mm.
    """
    turns = np.linspace(-angle / 2, angle / 2, count)
    P = cameras([(4 * np.sin(turn), -4 * np.cos(turn), 0) for turn in turns])
    sigma = 1000 * np.sqrt(np.diag(point_covariance([0, 0, 0], P, NOISE)))
    found = refine_point(np.zeros((TRIALS, 3)), pixels_of_origin(P), P)
    off = 1000 * np.sqrt((found**2).mean(axis=0))
    return (float(sigma[1]), float(sigma[0])), (float(off[1]), float(off[0]))
