"""Still figures: points as rays, and what the transformations of the plane preserve."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.diagrams import (
    Floats,
    figure,
    fit,
    panels,
    same_shape,
    sketch,
    stroke,
    write,
)
from course_lib.drawing.style import BLACK, FULL_WIDTH, ROLES
from course_lib.homogeneous import apply_homography, from_homogeneous

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: A name and the matrix of each kind of transformation, from the mildest to the wildest.
KINDS: dict[str, Floats] = {
    "Euclidean": np.array([[0.94, -0.342, 0.1], [0.342, 0.94, -0.1], [0, 0, 1]]),
    "similarity": np.array([[0.62, -0.22, 0.1], [0.22, 0.62, 0.0], [0, 0, 1]]),
    "affine": np.array([[0.85, 0.4, 0.0], [0.1, 0.62, 0.0], [0, 0, 1]]),
    "projective": np.array([[0.8, 0.06, 0.0], [0.03, 0.72, 0.1], [0.05, 0.32, 1]]),
}


@figure(
    "Points (x, w) on a page, rays through the origin, and the line w = 1. All points of one ray "
    "meet that line in one place; level rays meet it nowhere."
)
def points_on_rays(points: ArrayLike, yours: ArrayLike | None = None) -> Figure:
    """Show homogeneous points of a line: two numbers each, of which only the ratio counts.

    Parameters
    ----------
    points : array_like, shape (N, 2)
        Homogeneous points (x, w).
    yours : array_like, shape (N, 1), optional
        The ordinary coordinate that a student's function gave for each.

    Returns
    -------
    Figure
        The points, their rays, and where each ray meets w = 1.
    """
    points = np.asarray(points, dtype=float)
    expected = from_homogeneous(points)
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.4))
    ax.axhline(1, color=ROLES["image"], lw=2)
    for (x, w), place in zip(points, expected[:, 0], strict=True):
        end = np.array([x, w]) if np.isnan(place) else max(w, 1.0) * np.array([place, 1])
        # A point with w < 0 lies on the same line through the origin, on its other side.
        start = np.array([x, w]) if w < 0 else 0 * end
        stroke(ax, np.array([1.08 * start, 1.08 * end]), "ray", lw=1.2)
        ax.plot(x, w, "o", color=ROLES["object"], ms=7, zorder=3)
        ha, beside = ("left", x + 0.06) if x > 0 else ("right", x - 0.08)
        write(ax, (beside, w - 0.1), f"({x:g}, {w:g})", "object", ha=ha, fontsize=10)
        ax.plot(place, 1, "o", color=BLACK, mfc="none", ms=12)
    drawn = same_shape(yours, expected)
    if drawn is not None:
        there = drawn[np.isfinite(drawn)]
        ax.plot(there, 1 + 0 * there, "*", color=ROLES["second"], ms=11, label="your function")
        ax.legend(loc="upper left", frameon=True)
    ax.plot(0, 0, "o", color=BLACK, ms=7)
    ax.margins(x=0.1)  # room for the names beside the points
    ax.set(xlabel="x (no unit)", ylabel="w (no unit)", ylim=(-0.85, 2.45))
    write(ax, (ax.get_xlim()[1], 1.1), "w = 1", "image", ha="right")
    return fig


@figure(
    "Four versions of a square with a cross and a circle in it: turned; turned and smaller; "
    "slanted, with parallel edges; and seen in perspective, where parallel edges run together."
)
def what_survives() -> Figure:
    """Show one drawing under transformations of four kinds.

    Returns
    -------
    Figure
        Dashed: the drawing as it was. Each kind contains all those to its left.
    """
    fig, axes = panels(1, len(KINDS), (FULL_WIDTH, 2.6))
    for ax, (name, H) in zip(axes, KINDS.items(), strict=True):
        sketch(ax)
        ax.set_title(name, loc="center", fontsize=11)
        _drawing(ax, np.eye(3), "guide", lw=0.8, ls=(0, (3, 2)))
        _drawing(ax, H, "camera", lw=1.8)
        fit(ax, -1.5, 1.5, -1.5, 1.5)
    return fig


def _drawing(ax: Axes, H: Floats, role: str, **options: object) -> None:
    """Draw a square with a grid and a circle in it, transformed by H."""
    turn = np.linspace(0, 2 * np.pi, 61)
    paths = [np.stack([np.cos(turn), np.sin(turn)], axis=1)]
    for k in (-1.0, 0.0, 1.0):
        paths += [np.array([(-1.0, k), (1, k)]), np.array([(k, -1.0), (k, 1)])]
    for path in paths:
        stroke(ax, apply_homography(path, H), role, **options)
