"""Still figures: what a lens does to straight lines, where in the camera, and how far it holds."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.distortion import (
    distort,
    distort_pixels,
    distort_radial,
    pixels_from_normalised,
    valid_radius,
)
from course_lib.drawing.diagrams import (
    Floats,
    figure,
    panels,
    picture_frame,
    same_shape,
    stroke,
    write,
)
from course_lib.drawing.distortion.pictures import SIZE, K, house_through
from course_lib.drawing.style import BLACK, FULL_WIDTH, GREY, LIGHT, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@figure("A house through a barrel lens, through a pinhole, and through a pincushion lens.")
def barrel_and_pincushion(k1: float = 0.2) -> Figure:
    """Show a house with a grid of straight lines through two lenses and a pinhole.

    Parameters
    ----------
    k1 : float
        Size of the radial coefficient, no unit; the barrel has it with a minus.

    Returns
    -------
    Figure
        Three pictures.
    """
    fig, axes = panels(1, 3, (FULL_WIDTH, 2.6))
    titles = (f"Barrel, $k_1$ = −{k1:g}", "Pinhole, $k_1$ = 0", f"Pincushion, $k_1$ = +{k1:g}")
    for ax, sign, title in zip(axes, (-1, 0, 1), titles, strict=True):
        lens = [sign * k1]
        ax.imshow(house_through(lens))
        for line in straight_lines():
            stroke(ax, distort_pixels(line, K, lens), "object", lw=1.2)
        ax.set(xlim=(-0.5, SIZE[0] - 0.5), ylim=(SIZE[1] - 0.5, -0.5))
        ax.axis("off")
        ax.set_title(title, fontsize=11)
    return fig


def straight_lines(columns: int = 9, rows: int = 7, steps: int = 40) -> list[Floats]:
    """Return a grid of straight lines over the ideal picture of the house, px.

    Parameters
    ----------
    columns, rows : int
        How many upright and level lines; they reach beyond the picture.
    steps : int
        Points on each.

    Returns
    -------
    list of ndarray, each of shape (steps, 2)
        Upright lines first.
    """
    u = np.linspace(-0.1, 1.1, columns) * SIZE[0]
    v = np.linspace(-0.1, 1.1, rows) * SIZE[1]
    down, across = np.linspace(v[0], v[-1], steps), np.linspace(u[0], u[-1], steps)
    upright = [np.stack([np.full(steps, x), down], axis=1) for x in u]
    return upright + [np.stack([across, np.full(steps, y)], axis=1) for y in v]


@figure(
    "The same grid of points three times: where the rays meet the plane at distance 1, where the "
    "lens has moved them there, and in pixels. One point is marked at each stage."
)
def where_it_acts(
    point: Sequence[float] = (1.0, 0.5, 2.0), k1: float = -0.2, f: float = 536.0
) -> Figure:
    """Show one point of space on its way to its pixel: divided by Z, distorted, times K.

    Parameters
    ----------
    point : sequence of float
        (X, Y, Z) in the camera frame, m.
    k1 : float
        Radial coefficient, no unit.
    f : float
        Focal length, px; the principal point is (342, 236).

    Returns
    -------
    Figure
        Three grids.
    """
    intrinsics = np.array([[f, 0, 342.0], [0, f, 236.0], [0, 0, 1]])
    ideal = np.array(point[:2]) / point[2]
    bent = distort(ideal, [k1])
    stages = ((lambda p: p), (lambda p: distort(p, [k1])))
    fig, axes = panels(1, 3, (FULL_WIDTH, 3.1), width_ratios=[1, 1, 1.05])
    for ax, stage, title in zip(axes, stages, ("1  Divide by Z", "2  The lens"), strict=False):
        _stage_grid(ax, stage)
        ax.set(xlim=(-0.75, 0.75), ylim=(0.55, -0.55), xlabel="x (no unit)", ylabel="y (no unit)")
        ax.set_title(title, fontsize=11)
    _stage_grid(axes[2], lambda p: pixels_from_normalised(distort(p, [k1]), intrinsics))
    picture_frame(axes[2], (640, 480))
    axes[2].set_title("3  Times K", fontsize=11)
    for ax, place, digits in zip(
        axes, (ideal, bent, pixels_from_normalised(bent, intrinsics)), (4, 4, 1), strict=True
    ):
        _marked(ax, place, digits)
    return fig


def _stage_grid(ax: Axes, stage: object) -> None:
    """Draw a grid of the plane at distance 1 as a stage of the camera shows it."""
    assert callable(stage)
    for x in np.linspace(-0.6, 0.6, 7):
        line = np.stack([np.full(30, x), np.linspace(-0.4, 0.4, 30)], axis=1)
        stroke(ax, stage(line), "guide", lw=0.9)
    for y in np.linspace(-0.4, 0.4, 5):
        line = np.stack([np.linspace(-0.6, 0.6, 30), np.full(30, y)], axis=1)
        stroke(ax, stage(line), "guide", lw=0.9)
    ax.set_aspect("equal")


def _marked(ax: Axes, place: Floats, digits: int) -> None:
    """Mark a point and write its coordinates below it, on white."""
    ax.plot(*place, "o", color=ROLES["object"], ms=8, zorder=5)
    low, high = ax.get_ylim()
    x, y = place + 1e-9  # 593.25 is 593.3, as at school
    text = f"({x:.{digits}f}, {y:.{digits}f})"
    paper = {"facecolor": "white", "edgecolor": "none", "pad": 1.0, "alpha": 0.9}
    below = (place[0], place[1] + 0.09 * (low - high))
    write(ax, below, text, fontsize=9, ha="right", bbox=paper)


@figure(
    "Distance from the centre before and after the lens for several radial lenses; where a curve "
    "turns round, a circle marks its valid radius."
)
def profiles(
    lenses: Sequence[ArrayLike] = ((-0.31,), (-0.31, 0.12), (0.2,)),
    corner: float = 0.78,
    yours: Sequence[float | None] | None = None,
) -> Figure:
    """Show how far from the centre a point lands, against where a pinhole would put it.

    Parameters
    ----------
    lenses : sequence of array_like
        Radial coefficients k1, k2, … of each.
    corner : float
        Distance of the corner of our picture from the centre, by the focal length; the picture
        holds what lies nearer after the lens.
    yours : sequence of float, optional
        Valid radius of each lens that a student's function gave.

    Returns
    -------
    Figure
        Curves of r_d against r.
    """
    r = np.linspace(0, 1.8, 300)
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.9))
    ax.plot(r, r, color=GREY, lw=1.2, ls=(0, (6, 4)), label="pinhole")
    for lens, style, role in zip(
        lenses, ("-", "--", "-."), ("object", "camera", "ray"), strict=False
    ):
        limit, name = valid_radius(_opencv(lens)), _named(lens)
        if np.isfinite(limit):
            height = float(_along(np.array([limit]), lens)[0])
            ax.plot(limit, height, "o", color=BLACK, ms=17, mfc="none", mew=1.6, zorder=4)
            name += f", folds over at {limit:.2f}"
        ax.plot(r, _along(r, lens), style, color=ROLES[role], label=name)
    ax.axhspan(0, corner, color=LIGHT, lw=0, zorder=0)
    write(ax, (0.03, corner - 0.07), "inside our picture", "guide", ha="left")
    _your_limits(ax, lenses, yours)
    ax.set(xlabel="$r$: distance from the centre, pinhole (no unit)", xlim=(0, 1.8))
    ax.set(ylabel="$r_d$: with the lens (no unit)", ylim=(0, 1.75))
    ax.legend(loc=(0.45, 0.02), fontsize=9)
    return fig


def _your_limits(
    ax: Axes, lenses: Sequence[ArrayLike], yours: Sequence[float | None] | None
) -> None:
    """Draw the finite limits that a student's function gave as stars on their curves."""
    for lens, limit in zip(lenses, yours or (), strict=False):
        drawn = same_shape(limit, np.zeros(()))
        if drawn is not None and 0 < drawn < 1.8:
            height = _along(np.atleast_1d(drawn), lens)
            ax.plot(drawn, height, "*", color=ROLES["second"], ms=13, zorder=5)


def _along(r: Floats, lens: ArrayLike) -> Floats:
    """Return r_d for distances r through a lens with radial coefficients k1, k2, …."""
    return np.asarray(distort_radial(np.stack([r, np.zeros_like(r)], axis=1), lens)[:, 0])


def _opencv(lens: ArrayLike) -> list[float]:
    """Return radial coefficients k1, k2 in OpenCV's order."""
    k = np.append(np.asarray(lens, dtype=float), [0.0])
    return [float(k[0]), float(k[1]), 0.0, 0.0]


def _named(lens: ArrayLike) -> str:
    parts = [f"$k_{n}$ = {k:g}" for n, k in enumerate(np.atleast_1d(np.asarray(lens)), start=1)]
    return ", ".join(parts).replace("-", "−")
