"""Still figures: the way back from a distorted point, and from a distorted picture."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.distortion import distort, undistort_pixels, undistort_points
from course_lib.drawing.diagrams import Floats, figure, panels, picture_frame, same_shape, write
from course_lib.drawing.distortion.pictures import (
    NOWHERE,
    SIZE,
    K,
    Picture,
    house_through,
    looked_up,
    straight_map,
)
from course_lib.drawing.style import FULL_WIDTH, GREY, ROLES

if TYPE_CHECKING:
    from matplotlib.figure import Figure

HOUSE_LENS = (-0.2,)


#: Lenses on which the way back is tried: a name, k1 and perhaps k2, and an ideal distance.
TRIED = (
    ("mild barrel", (-0.2,), 0.7),
    ("strong pincushion", (0.8,), 0.7),
    ("folds at r = 1.21", (0.5, -0.3), 1.1),
)


@figure(
    "Error after each step of the fixed-point iteration and of Newton's method, for three lenses: "
    "with a mild barrel both find the answer, with a strong pincushion only Newton's method, and "
    "with a lens that folds over near the point only the fixed-point iteration."
)
def iterations(steps: int = 10) -> Figure:
    """Show how two methods undo the distortion of one point, step by step.

    Parameters
    ----------
    steps : int
        How many steps.

    Returns
    -------
    Figure
        Errors on a logarithmic axis, a panel for each lens.
    """
    fig, axes = panels(1, 3, (FULL_WIDTH, 3.0), sharey=True)
    for ax, (name, k, r) in zip(axes, TRIED, strict=True):
        for method, style, role in ((fixed_point, "o-", "object"), (newton, "s--", "camera")):
            errors = np.abs(method(image_and_slope(r, k)[0], k, steps) - r)
            label = method.__name__.replace("_", " ").replace("newton", "Newton")
            ax.plot(np.maximum(errors, 1e-17), style, color=ROLES[role], ms=5, label=label)
        ax.set(yscale="log", ylim=(1e-17, 10), xlabel="step (no unit)")
        ax.set_xticks(range(0, steps + 1, 2))
        numbers = ", ".join(f"$k_{n}$ = {value:g}" for n, value in enumerate(k, 1))
        ax.set_title(f"{name}\n{numbers}".replace("-", "−"), fontsize=11)
    axes[0].set_ylabel("error of r (no unit)")
    axes[0].legend(fontsize=10)
    return fig


def image_and_slope(r: float, k: ArrayLike) -> tuple[float, float]:
    """Return where a lens images a distance from the centre, and how fast that grows with it.

    Parameters
    ----------
    r : float
        Ideal distance, no unit.
    k : array_like
        ``k1``, perhaps with ``k2 …``.

    Returns
    -------
    tuple of float
        ``r (1 + k1 r² + …)`` and its derivative ``1 + 3 k1 r² + …``.
    """
    k = np.atleast_1d(np.asarray(k, float))
    powers = 2 * np.arange(1, len(k) + 1)
    terms = k * r**powers
    return float(r * (1 + terms.sum())), float(1 + ((powers + 1) * terms).sum())


def fixed_point(r_d: float, k: ArrayLike, steps: int) -> Floats:
    """Return the first guesses of r: to each, add what its image lacks.

    Parameters
    ----------
    r_d : float
        Distorted distance from the centre, no unit; the first guess.
    k : array_like
        As in `image_and_slope`.
    steps : int
        How many steps.

    Returns
    -------
    ndarray, shape (steps + 1,)
        The guesses.
    """
    guesses = [r_d]
    for _ in range(steps):
        guesses.append(guesses[-1] + r_d - image_and_slope(guesses[-1], k)[0])
    return np.array(guesses)


def newton(r_d: float, k: ArrayLike, steps: int) -> Floats:
    """Return the guesses of Newton's method; arguments as for `fixed_point`."""
    guesses = [r_d]
    for _ in range(steps):
        image, slope = image_and_slope(guesses[-1], k)
        guesses.append(guesses[-1] + (r_d - image) / slope)
    return np.array(guesses)


@figure("Points before and after a lens, or after taking its distortion back, joined by lines.")
def moved_points(
    points: ArrayLike, coefficients: ArrayLike, yours: ArrayLike | None = None, back: bool = False
) -> Figure:
    """Show where a lens moves points, or from where it has moved them.

    Parameters
    ----------
    points : array_like, shape (N, 2)
        Points in normalised coordinates.
    coefficients : array_like
        As in `course_lib.distortion.distort`.
    yours : array_like, shape (N, 2), optional
        Where a student's function moves them.
    back : bool
        Whether `points` are distorted and the way back is shown.

    Returns
    -------
    Figure
        Dots for the points, circles for where they belong, stars for the student's.
    """
    start = np.asarray(points, dtype=float)
    end = (undistort_points if back else distort)(start, coefficients)
    names = ("distorted", "ideal") if back else ("ideal", "distorted")
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.9))
    ax.plot(*np.stack([start, end]).transpose(2, 0, 1), color=ROLES["guide"], lw=1)
    ax.plot(*start.T, "o", color=ROLES["guide"], ms=4, label=names[0])
    ax.plot(*end.T, "o", color=ROLES["object"], ms=11, mfc="none", mew=1.4, label=names[1])
    drawn = same_shape(yours, end)
    if drawn is not None:
        ax.plot(*drawn.T, "*", color=ROLES["second"], ms=9, ls="", label="yours")
    reach = 1.25 * np.abs(np.stack([start, end])).max(axis=(0, 1))
    ax.set(xlim=(-reach[0], reach[0]), ylim=(reach[1], -reach[1]), aspect="equal")
    ax.set(xlabel="x (no unit)", ylabel="y (no unit)")
    ax.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    return fig


@figure(
    "A corner of the house straightened twice: pixels sent forward leave black holes, pixels that "
    "look backward leave none."
)
def forward_and_backward(corner: tuple[int, int] = (0, 0), side: int = 64) -> Figure:
    """Show what happens when pixels are sent to their new places, and when they are looked up.

    Parameters
    ----------
    corner : tuple of int
        Column and row of the part that is shown, px.
    side : int
        Width of the part, px; it is three quarters as high.

    Returns
    -------
    Figure
        Distorted picture, forward, backward: each pixel by pixel.
    """
    bent = house_through(HOUSE_LENS)
    shown = (bent, sent_forward(bent), looked_up(bent, straight_map(K, HOUSE_LENS, SIZE)))
    fig, axes = panels(1, 3, (FULL_WIDTH, 2.6))
    titles = ("With distortion", "Sent forward: holes", "Looked up backward")
    for ax, picture, title in zip(axes, shown, titles, strict=True):
        ax.imshow(picture)
        (u, v), down = corner, 3 * side // 4
        ax.set(xlim=(u - 0.5, u + side - 0.5), ylim=(v + down - 0.5, v - 0.5))
        ax.axis("off")
        ax.set_title(title, fontsize=11)
    return fig


def sent_forward(picture: Picture) -> Picture:
    """Return a straightened picture in which every pixel was sent to the nearest new place."""
    u, v = np.meshgrid(np.arange(SIZE[0]), np.arange(SIZE[1]))
    old = np.stack([u.ravel(), v.ravel()], axis=1)
    new = np.rint(undistort_pixels(old, K, HOUSE_LENS))
    inside = ((new >= 0) & (new < SIZE)).all(axis=1)
    straight = np.zeros_like(picture)
    (to_u, to_v), (from_u, from_v) = new[inside].astype(int).T, old[inside].T
    straight[to_v, to_u] = picture[from_v, from_u]
    return straight


@figure(
    "A picture before and after it was straightened, with a straight edge laid over the same line "
    "in both."
)
def before_and_after(
    picture: NDArray[Any],
    maps: ArrayLike | None,
    lines: tuple[ArrayLike, ArrayLike],
    part: tuple[int, int] | None = None,
) -> Figure:
    """Show a picture and the one that a map makes of it, with a straight edge over both.

    Parameters
    ----------
    picture : ndarray, shape (height, width), uint8
        Picture with distortion.
    maps : array_like, shape (2, height, width), or None
        Columns and rows in it, for each pixel of the new picture; None leaves that empty.
    lines : tuple of array_like, each of shape (N, 2)
        Points of the same line before and after, px.
    part : tuple of int, optional
        First and last column that are shown, px; the whole picture unless given.

    Returns
    -------
    Figure
        Two pictures.
    """
    height, width = picture.shape[:2]
    straight = _by_map(picture, maps)
    left, right = part or (0, width - 1)
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.9 * height / (right - left) + 0.3))
    for ax, shown, line, title in zip(
        axes, (picture, straight), lines, ("Before", "After"), strict=True
    ):
        picture_frame(ax, (width, height))
        ax.set(xlim=(left - 0.5, right + 0.5), title=title)
        if shown is not None:
            ax.imshow(shown, vmin=0, vmax=255)
            points = np.asarray(line, dtype=float)
            ax.plot(*points[[0, -1]].T, color=ROLES["ray"], lw=1.2)
            ax.plot(*points.T, "o", color=ROLES["camera"], ms=4.5, mec="white", mew=0.6)
        else:
            write(ax, ((left + right) / 2, height / 2), "your map goes here", color=GREY)
    return fig


def _by_map(picture: NDArray[Any], maps: ArrayLike | None) -> Picture | None:
    """Return a picture that looks up its colours by a student's map, if that is one."""
    places = same_shape(maps, np.zeros((2, *picture.shape[:2])))
    if places is None:
        return None
    places = np.clip(np.where(np.isfinite(places), places, NOWHERE), NOWHERE, -NOWHERE)
    return looked_up(picture, np.moveaxis(places, 0, -1).astype(np.float32))
