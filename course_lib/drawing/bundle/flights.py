"""A simulated flight with a lens that is not quite as it was calibrated, and its errors."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from course_lib.bundle import Observations, bundle_adjust
from course_lib.drawing.diagrams import Floats, figure, panels
from course_lib.drawing.style import FULL_WIDTH, ROLES
from course_lib.orientation import check_point_rmse
from course_lib.similarity import similarity_transform
from data_generators.blocks import KnownBlock, flight

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: By how much the k1 that was calibrated at home is wrong in the air.
WRONG_K1 = -0.002
#: Standard deviation of a surveyed coordinate, m.
SURVEY = 0.01
#: How many control points are tried.
CONTROLS = (3, 4, 5, 7, 10, 15, 20)
#: What is drawn: name, oblique pictures, control points, whether k1 is found from the flight.
FLIGHTS = {
    "parallel": (0, False, False),
    "parallel, 8 control points": (0, True, False),
    "with 8 oblique, k1 adjusted": (8, False, True),
}


@dataclass(frozen=True, eq=False)
class Flown:
    """A flight as it was adjusted.

    Attributes
    ----------
    known : KnownBlock
        The truth.
    errors : ndarray, shape (n, 3)
        Adjusted minus true points, m; without control the block is laid over the truth first.
    rms : float
        Of the reprojection error, px.
    control_rms : float
        Of the heights of the control points, m; NaN without.
    check_rms : float
        Of the heights of the check points, m.
    k1 : float
        What the lens was taken to be off by.
    """

    known: KnownBlock
    errors: Floats
    rms: float
    control_rms: float
    check_rms: float
    k1: float


@cache
def flown(oblique: int, controlled: bool, finds_k1: bool, wrong: float = WRONG_K1) -> Flown:
    """Return a flight of 5 strips with 8 pictures each, at 100 m, adjusted.

    Parameters
    ----------
    oblique : int
        Oblique pictures in addition.
    controlled : bool
        Whether eight surveyed control points take part.
    finds_k1 : bool
        Whether k1 is found from the pictures of the flight.
    wrong : float
        By how much k1 is wrong.

    Returns
    -------
    Flown
        Its errors.
    """
    known = flight(np.random.default_rng(4), 5, 8, 500, oblique=oblique)
    bent = bent_by(known.observations, known.truth.K[0], wrong)
    control = known.surveyed(np.random.default_rng(3), SURVEY) if controlled else None
    k1 = best_k1(known, bent)[0] if finds_k1 else 0.0
    fit = bundle_adjust(known.truth, bent_by(bent, known.truth.K[0], k1), control)
    true, X = known.truth.points, fit.block.points
    errors = X - true if controlled else similarity_transform(X, true).apply(X) - true
    left = fit.control_residuals[:, 2]
    control_rms = float(np.sqrt((left**2).mean())) if controlled else np.nan
    check = check_point_rmse(errors[known.check], 0 * errors[known.check])
    return Flown(known, errors, fit.rms, control_rms, check.z, k1)


def bent_by(seen: Observations, K: Floats, k1: float) -> Observations:
    """Return observations that are moved as a lens with k1 moves them."""
    f, c = K[0, 0], K[:2, 2]
    x = (seen.pixels - c) / f
    r2 = (x**2).sum(axis=1, keepdims=True)
    return Observations(seen.cameras, seen.points, c + f * x * (1 + k1 * r2), seen.sigma)


def best_k1(known: KnownBlock, seen: Observations) -> tuple[float, float]:
    """Return the k1 with which the pixels fit best, and its standard deviation.

    The cost against k1 is a parabola; three adjustments find its lowest point.
    """
    tried = np.array([-0.003, 0, 0.003])
    K = known.truth.K[0]
    costs = [bundle_adjust(known.truth, bent_by(seen, K, k)).cost for k in tried]
    a, b, _ = np.polyfit(tried, costs, 2)
    fit = bundle_adjust(known.truth, bent_by(seen, K, -b / (2 * a)))
    return float(-b / (2 * a)), float(fit.sigma0 / np.sqrt(a))


@figure(
    "Maps of height errors: a dome, held in places by control points, gone with oblique pictures."
)
def domes() -> Figure:
    """Show the errors of the heights of three flights with the same wrong lens.

    Returns
    -------
    Figure
        A map for each, in mm.
    """
    fig, axes = panels(1, 3, (FULL_WIDTH, 3.5), sharey=True)
    image: Any = None
    for ax, (name, kind) in zip(axes, FLIGHTS.items(), strict=True):
        found = flown(*kind)
        image = _map(ax, found)
        if kind[1]:
            ax.plot(*found.known.truth.points[found.known.control, :2].T, "^k", ms=6, mfc="white")
        ax.set_title(
            f"{name}\nRMS {found.rms:.2f} px,\nheights ± {1000 * found.check_rms:.0f} mm",
            fontsize=10,
        )
    axes[0].set_ylabel("y (m)")
    fig.colorbar(image, ax=axes, label="height error (mm)", shrink=0.8)
    return fig


def _map(ax: Axes, found: Flown) -> Any:
    """Draw the height errors of a flight over the area of the parallel pictures."""
    x, y = found.known.truth.points[:, :2].T
    look: dict[str, Any] = {"levels": np.linspace(-300, 300, 13), "cmap": "PuOr", "extend": "both"}
    image = ax.tricontourf(x, y, 1000 * found.errors[:, 2], **look)
    C = found.known.truth.centres[:40]
    ax.plot(*C[:, :2].T, ".", color=ROLES["camera"], ms=3)
    half = np.array([4000, 3000]) * 100 / 3600 / 2
    (left, low), (right, high) = C[:, :2].min(axis=0) - half, C[:, :2].max(axis=0) + half
    ax.set(xlim=(left, right), ylim=(low, high), aspect="equal", xlabel="x (m)")
    return image


def simulated_control(
    rng: np.random.Generator, points: int = 30, noise: float = 0.02
) -> tuple[Floats, Floats]:
    """Return points of a model with errors, and where they truly are.

    Parameters
    ----------
    rng : numpy.random.Generator
        Source of places and errors.
    points : int
        How many.
    noise : float
        Standard deviation of a coordinate of the model, m.

    Returns
    -------
    model, world : ndarray, shape (points, 3)
        In the model's frame and unit, and in the world, m.
    """
    world = rng.uniform([0, 0, 0], [200, 150, 20], (points, 3))
    noisy = world + noise * rng.standard_normal(world.shape)
    turn = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
    return (noisy - [100, 80, 0]) @ turn.T / 25, world


@cache
def flattering(trials: int = 200) -> Floats:
    """Return for several numbers of control points what they leave, and what the truth is.

    Parameters
    ----------
    trials : int
        How many models are laid over the world for each number.

    Returns
    -------
    ndarray, shape (N, 3)
        Number of control points; root mean square of their residuals, and of the errors of all
        other points, over all trials, m.
    """
    rng, rows = np.random.default_rng(1), []
    for count in CONTROLS:
        squares = []
        for _ in range(trials):
            model, world = simulated_control(rng)
            found = similarity_transform(model[:count], world[:count])
            apart = ((found.apply(model) - world) ** 2).sum(axis=1)
            squares.append([apart[:count].mean(), apart[count:].mean()])
        rows.append([count, *np.sqrt(np.mean(squares, axis=0))])
    return np.array(rows)


@figure("With few control points their residuals are small, and the errors of check points large.")
def control_flatters() -> Figure:
    """Show residuals at control points and errors at check points against their number.

    Returns
    -------
    Figure
        Two lines.
    """
    numbers, control, check = flattering().T
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.75, 3.0))
    both = ((check, "object", "s", "check points"), (control, "camera", "o", "control points"))
    for values, role, mark, name in both:
        ax.plot(numbers, 1000 * values, f"{mark}-", color=ROLES[role], ms=5, label=name)
    ax.set(xlabel="control points (number)", ylabel="RMS in space (mm)", xticks=numbers)
    ax.set_ylim(0, None)
    ax.legend()
    return fig
