"""A simulated flight with a lens that is not quite as it was calibrated, and its errors."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from course_lib.bundle import Control, Observations, bundle_adjust, self_calibrate
from course_lib.bundle.block import Indices
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
#: How far inside of the area control points on a grid lie, m.
MARGIN = 15
#: How many control points are tried.
CONTROLS = (3, 4, 5, 7, 10, 15, 20)
#: What is drawn: name, oblique pictures, control points, whether k1 is found from the flight, and
#: by how much it is wrong.
FLIGHTS = {
    "the right lens": (0, 0, False, 0.0),
    "the wrong lens": (0, 0, False, WRONG_K1),
    "wrong, 8 control points": (0, 8, False, WRONG_K1),
    "wrong, 25 control points": (0, 25, False, WRONG_K1),
    "wrong, but 8 oblique,\n$k_1$ adjusted": (8, 0, True, WRONG_K1),
}
#: Steps in which k1 comes to rest.
STEPS = 4


@dataclass(frozen=True, eq=False)
class Flown:
    """A flight as it was adjusted.

    Attributes
    ----------
    known : KnownBlock
        The truth.
    control : ndarray of int
        Numbers of the control points.
    errors : ndarray, shape (n, 3)
        Adjusted minus true points, m; without control the block is laid over the truth first.
    rms : float
        Of the reprojection error, px.
    control_rms : float
        Of the heights of the control points, m; NaN without.
    check_rms : float
        Of the heights of the check points, m.
    k1 : float
        The correction of the lens that was found; 0 if none was looked for.
    """

    known: KnownBlock
    control: Indices
    errors: Floats
    rms: float
    control_rms: float
    check_rms: float
    k1: float


@cache
def flown(oblique: int, controls: int, finds_k1: bool = False, wrong: float = WRONG_K1) -> Flown:
    """Return a flight of 5 strips with 8 pictures each, at 100 m, adjusted.

    Parameters
    ----------
    oblique : int
        Oblique pictures in addition.
    controls : int
        How many surveyed control points take part: none, 8, or the square of a number.
    finds_k1 : bool
        Whether k1 is found from the pictures of the flight.
    wrong : float
        By how much k1 is wrong.

    Returns
    -------
    Flown
        Its errors.
    """
    known, seen = pictures_with(oblique, wrong)
    k1 = k1_told_by(oblique, wrong)[0] if finds_k1 else 0.0
    true = known.truth.points
    chosen = known.control if controls == len(known.control) else spread(true, controls)
    control = Control(chosen, surveyed(true[chosen]), SURVEY) if controls else None
    fit = bundle_adjust(known.truth, bent_by(seen, known.truth.K[0], k1), control)
    X = fit.block.points
    errors = X - true if controls else similarity_transform(X, true).apply(X) - true
    left = fit.control_residuals[:, 2]
    control_rms = float(np.sqrt((left**2).mean())) if controls else np.nan
    check = errors[np.setdiff1d(known.check, chosen)]
    return Flown(
        known, chosen, errors, fit.rms, control_rms, check_point_rmse(check, 0 * check).z, k1
    )


@cache
def pictures_with(oblique: int, wrong: float) -> tuple[KnownBlock, Observations]:
    """Return a flight, and what its pictures show with a lens that is off."""
    known = flight(np.random.default_rng(4), 5, 8, 500, oblique=oblique)
    return known, bent_by(known.observations, known.truth.K[0], wrong)


@cache
def k1_told_by(oblique: int, wrong: float = WRONG_K1) -> tuple[float, float]:
    """Return the correction of k1 that the pictures tell, and its standard deviation."""
    known, seen = pictures_with(oblique, wrong)
    found = self_calibrate(known.truth, seen, steps=STEPS)
    return found.corrections["k1"], found.sigma["k1"]


def spread(points: Floats, count: int) -> Indices:
    """Return the points that are nearest to a square grid over all of them."""
    side = round(count**0.5)
    ends = points.min(axis=0)[:2] + MARGIN, points.max(axis=0)[:2] - MARGIN
    grid = np.stack(np.meshgrid(*np.linspace(*ends, side).T), axis=-1).reshape(-1, 2)
    apart = ((points[:, None, :2] - grid) ** 2).sum(axis=2)
    return np.unique(apart.argmin(axis=0))


def surveyed(points: Floats) -> Floats:
    """Return places as a surveyor measures them."""
    return points + SURVEY * np.random.default_rng(3).standard_normal(points.shape)


def bent_by(seen: Observations, K: Floats, k1: float) -> Observations:
    """Return observations that are moved as a lens with k1 moves them."""
    f, c = K[0, 0], K[:2, 2]
    x = (seen.pixels - c) / f
    r2 = (x**2).sum(axis=1, keepdims=True)
    return Observations(seen.cameras, seen.points, c + f * x * (1 + k1 * r2), seen.sigma)


@figure(
    "Maps of height errors: flat with the right lens; with a wrong one a dome, which control "
    "points hold in places, and which oblique pictures take away."
)
def domes() -> Figure:
    """Show the errors of the heights of five flights, four of them with the same wrong lens.

    Returns
    -------
    Figure
        A map for each, in mm.
    """
    fig, grid = panels(2, 3, (FULL_WIDTH, 5.6))
    axes = np.ravel(grid)
    image: Any = None
    for ax, (name, kind) in zip(axes, FLIGHTS.items(), strict=False):
        image = _map(ax, flown(*kind))
        ax.set_title(_title(name, flown(*kind)), fontsize=10)
    for number, ax in enumerate(axes[:5]):
        ax.tick_params(labelleft=number % 3 == 0, labelbottom=number > 1)
        ax.set(ylabel="" if number % 3 else "y (m)", xlabel="x (m)" if number > 1 else "")
    axes[5].axis("off")
    axes[5].legend(*axes[3].get_legend_handles_labels(), loc="center", fontsize=10)
    axes[5].get_legend().set_in_layout(False)
    fig.colorbar(image, ax=axes, label="height error (mm)", shrink=0.5)
    return fig


def _title(name: str, found: Flown) -> str:
    return f"{name}\nRMS {found.rms:.2f} px, ± {1000 * found.check_rms:.0f} mm"


def _map(ax: Axes, found: Flown) -> Any:
    """Draw the height errors of a flight over the area of the parallel pictures."""
    x, y = found.known.truth.points[:, :2].T
    look: dict[str, Any] = {"levels": np.linspace(-300, 300, 13), "cmap": "PuOr", "extend": "both"}
    image = ax.tricontourf(x, y, 1000 * found.errors[:, 2], **look)
    C = found.known.truth.centres[:40]
    ax.plot(*C[:, :2].T, ".", color=ROLES["camera"], ms=3, label="camera")
    if len(found.control):
        places = found.known.truth.points[found.control, :2].T
        ax.plot(*places, "^k", ms=6, mfc="white", clip_on=False, label="control point")
    half = np.array([4000, 3000]) * 100 / 3600 / 2
    (left, low), (right, high) = C[:, :2].min(axis=0) - half, C[:, :2].max(axis=0) + half
    ax.set(xlim=(left, right), ylim=(low, high), aspect="equal")
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
def flattering(trials: int = 500) -> Floats:
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
