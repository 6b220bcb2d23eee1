"""Still figures of uncertainty: a cloud of answers and its ellipse, depth against the baseline."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.diagrams import Floats, figure, panels, same_shape, write
from course_lib.drawing.style import FULL_WIDTH, GREY, ROLES
from course_lib.drawing.triangulation.rays import OUTSIDE
from course_lib.triangulation import depth_uncertainty, point_covariance, refine_point

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Two cameras 1 m apart, side by side; the point is 4 m before them. In m and px.
F, APART, NOISE = 800.0, 1.0, 0.5
PAIR = np.array(
    [
        [[F, 0, 319.5, 0], [0, F, 239.5, 0], [0, 0, 1, 0]],
        [[F, 0, 319.5, -F * APART], [0, F, 239.5, 0], [0, 0, 1, 0]],
    ]
)
POINT = np.array([0.5, 0.0, 4.0])
TRIALS = 1000
BASELINES = (100, 200, 566)  # mm
RIG_F, RIG_SIGMA = 1000.0, 0.1 * np.sqrt(2)  # px


@cache
def thousand_answers() -> Floats:
    """Return the best answers of many tries, (TRIALS, 3), m: the pixels have noise."""
    image = PAIR @ np.append(POINT, 1)
    exact = image[:, :2] / image[:, 2:]
    noise = np.random.default_rng(3).standard_normal((2, TRIALS, 2))
    seen = exact[:, None] + NOISE * noise
    return refine_point(np.tile(POINT, (TRIALS, 1)), seen, PAIR)


def outline(covariance: ArrayLike, times: float = 2.0) -> Floats:
    """Return an ellipse of so many standard deviations about the origin, (73, 2).

    Parameters
    ----------
    covariance : array_like, shape (2, 2)
        Symmetric, not negative.
    times : float
        Half axes in standard deviations.

    Returns
    -------
    ndarray, shape (73, 2)
        A closed line, in the unit of the standard deviations.
    """
    sizes, axes = np.linalg.eigh(np.asarray(covariance, dtype=float))
    turn = np.linspace(0, 2 * np.pi, 73)
    round_ = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    return np.asarray(times * round_ * np.sqrt(np.maximum(sizes, 0)) @ axes.T)


def inside(points: Floats, covariance: Floats, times: float = 2.0) -> float:
    """Return which part of the points, (N, 2), lies inside of an ellipse about the origin."""
    away = (points * np.linalg.solve(covariance, points.T).T).sum(axis=1)
    return float((away <= times**2).mean())


@figure("A thousand answers for one point: a narrow cloud along the line of sight, in an ellipse.")
def cloud(yours: Any = None) -> Figure:
    """Show cameras and ellipses from above, and one ellipse enlarged with simulated answers.

    Parameters
    ----------
    yours : array_like, shape (3, 3), optional
        A student's covariance of `POINT`, m².

    Returns
    -------
    Figure
        Left to scale with ellipses too large; right the cloud.
    """
    fig, (plan, near) = panels(1, 2, (FULL_WIDTH * 0.8, 4.4), width_ratios=(1.6, 1))
    _plan(plan)
    C = 1e6 * point_covariance(POINT, PAIR, NOISE)[np.ix_([0, 2], [0, 2])]
    off = 1000 * (thousand_answers() - POINT)[:, [0, 2]]
    near.plot(*off.T, ".", color=ROLES["object"], ms=3, alpha=0.5)
    near.plot(*outline(C).T, color=ROLES["camera"], lw=2)
    share = f"{100 * inside(off, C):.0f} % inside of 2σ"
    covariance = same_shape(yours, np.zeros((3, 3)))
    if covariance is not None:
        line = _own_ellipse(covariance)
        near.plot(*line.T, "--", color=ROLES["ray"], lw=3)
        share += "\ndashed: yours" if len(line) else f"\n{OUTSIDE}"
    near.set(xlim=(-24, 24), ylim=(-60, 60), aspect="equal", title="1000 answers")
    near.set(xlabel=f"error in x (mm)\n{share}", ylabel="error in z (mm)")
    return fig


def _own_ellipse(covariance: Floats) -> Floats:
    """Return the ellipse of a student's covariance, (73, 2) or (0, 2), mm: none if out of sight."""
    part = covariance[np.ix_([0, 2], [0, 2])]
    if not (np.abs(part) < 1).all():  # m², also if it is no number
        return np.zeros((0, 2))
    line = outline(5e5 * (part + part.T))
    seen = (np.abs(line) < (24, 60)).all() and np.ptp(line, axis=0).min() > 0.5
    return line if seen else np.zeros((0, 2))


def _plan(ax: Axes) -> None:
    """Show both cameras from above, and ellipses of points before them, twenty times too large."""
    for x, role in ((0.0, "camera"), (APART, "camera")):
        ax.fill([x, x - 0.14, x + 0.14], [0, 0.28, 0.28], color=ROLES[role], lw=0)
    for z in (2.0, 3, 4, 5):
        for x in (-1.0, 0.5, 2):
            C = point_covariance([x, 0, z], PAIR, NOISE)[np.ix_([0, 2], [0, 2])]
            shape = np.add(outline(C, 20), (x, z))
            ax.fill(*shape.T, fc=ROLES["object"], alpha=0.3, lw=0)
            ax.plot(*shape.T, color=ROLES["object"], lw=1.2)
    for x in (0.0, APART):
        ax.plot([x, POINT[0]], [0.28, POINT[2]], color=ROLES["ray"], lw=1)
    ax.set(xlim=(-1.8, 2.8), ylim=(-0.2, 6.2), aspect="equal", title="ellipses, 20 σ")
    ax.set(xlabel="x (m)", ylabel="z (m)")


@figure(
    "The uncertainty of depth grows with the square of the distance, less for longer baselines."
)
def depth_curves(yours: Any = None) -> Figure:
    """Show the standard deviation of depth against depth, for three baselines.

    Parameters
    ----------
    yours : array_like, shape (4,), optional
        A student's values at 1, 2, 3 and 4 m for the middle baseline, mm.

    Returns
    -------
    Figure
        A curve for each baseline, the wish of 1 mm at 2 m, stars.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.85, 3.4))
    Z = np.linspace(500, 4200, 100)
    for b, role in zip(BASELINES, ("second", "camera", "image"), strict=True):
        sigma = depth_uncertainty(Z, RIG_F, b, RIG_SIGMA)
        ax.plot(Z / 1000, sigma, color=ROLES[role])
        end = min(4.2, float(np.sqrt(15 * RIG_F * b / RIG_SIGMA)) / 1000)
        height = float(depth_uncertainty(1000 * end, RIG_F, b, RIG_SIGMA))
        ax.annotate(f"b = {b} mm", (end, height), (8, -9), textcoords="offset points")
    ax.plot([0.5, 2, 2], [1, 1, 0], "--", color=GREY, lw=1.2)
    ax.plot(2, 1, "o", color=ROLES["object"], ms=7)
    ax.annotate("1 mm at 2 m", (2, 1), (6, -11), textcoords="offset points", color=ROLES["object"])
    stars = same_shape(yours, np.zeros(4))
    if stars is not None:
        good = (stars >= 0) & (stars <= 16)
        ax.plot(np.arange(1, 5)[good], stars[good], "*", color=ROLES["ray"], ms=15, mec="black")
        if not good.all():
            write(ax, (1.6, 14.5), OUTSIDE, "guide")
    ax.set(xlim=(0.5, 5), ylim=(0, 16), xlabel="distance Z (m)", ylabel="$\\sigma_Z$ (mm)")
    return fig
