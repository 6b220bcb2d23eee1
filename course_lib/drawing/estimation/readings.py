"""Still figures: one unknown, a line through readings, shadows on a line and on a plane."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.camera import Camera
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
from course_lib.drawing.explorers.least_squares import LOADS, readings
from course_lib.drawing.space import onlooker, show_arrow, show_face, show_path
from course_lib.drawing.style import BLACK, FULL_WIDTH, GREY, ROLES
from course_lib.least_squares import fit_line, solve_one_unknown, solve_robust

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Three gauge blocks: their lengths in cm, and the pixels that each covers in the picture.
BLOCKS, PIXELS = np.array([2.0, 3, 4]), np.array([21.6, 29.7, 41.5])


@figure("Three readings with a line through zero, and the sum of squares as a parabola.")
def one_unknown(yours: float | None = None) -> Figure:
    """Show pixels against centimetres, and the sum of squares against the unknown.

    Parameters
    ----------
    yours : float, optional
        The unknown as a student's function found it, px a cm.

    Returns
    -------
    Figure
        Readings with their residuals, and the parabola.
    """
    x = solve_one_unknown(BLOCKS, PIXELS)
    fig, (left, right) = panels(1, 2, (FULL_WIDTH, 3.3))
    ends = np.array([0, 4.6])
    left.plot(ends, x * ends, color=ROLES["camera"], label="smallest sum of squares")
    for a, b in zip(BLOCKS, PIXELS, strict=True):
        left.plot([a, a], [x * a, x * a + 4 * (b - x * a)], color=ROLES["object"], lw=4)
        left.plot(a, b, "o", color=BLACK, ms=4)
    write(left, (0.3, 41), "bars: residuals,\n4 times as long", "object", ha="left", fontsize=9)
    left.set(xlabel="length of the block (cm)", ylabel="its image (px)", xlim=ends, ylim=(0, 50))
    tried = np.linspace(9.55, 11.02, 121)
    sums = ((np.outer(tried, BLOCKS) - PIXELS) ** 2).sum(axis=1)
    right.plot(tried, sums, color=ROLES["ray"])
    right.plot(x, ((x * BLOCKS - PIXELS) ** 2).sum(), "o", color=ROLES["camera"], ms=9)
    for b, a in zip(PIXELS, BLOCKS, strict=True):
        right.plot([b / a, b / a], [0, 0.7], color=GREY, lw=1.5)
        write(right, (b / a, 1.25), f"{a:g} cm", "guide", fontsize=9)
    write(right, (x, 4.2), f"{x:.3f}", "camera")
    drawn = same_shape(yours, np.array(0.0))
    if drawn is not None and 9.55 < drawn < 11.02:
        own = float(((drawn * BLOCKS - PIXELS) ** 2).sum())
        right.plot(float(drawn), own, "*", color=ROLES["second"], ms=15, label="your answer")
        right.legend(loc="upper center")
    right.set(xlabel="x (px a cm)", ylabel="sum of squares (px²)", ylim=(0, 19))
    right.set(xticks=np.arange(9.6, 11.1, 0.2), yticks=(0, 5, 10, 15))
    return fig


@figure("Measurements as an arrow, and its shadows on a line and on a plane of predictions.")
def shadows() -> Figure:
    """Show least squares as a foot of a perpendicular: one unknown, and two.

    Returns
    -------
    Figure
        Left: b and the line of all a x. Right: b and the plane of all A x.
    """
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.5))
    b = np.array([1.0, 0.5, 2.1])
    a, second = np.array([1.9, -0.5, 0.55]), np.array([0.5, 1.9, 0.25])
    for ax, columns, words in zip(
        axes,
        ([a], [a, second]),
        ("one unknown: a line (schematic)", "two unknowns: a plane (schematic)"),
        strict=True,
    ):
        sketch(ax, words)
        _shadow(ax, np.array(columns).T, b)
    return fig


@figure(
    "A matrix takes the circle of all vectors of length one to an ellipse with a shortest axis."
)
def circle_to_ellipse() -> Figure:
    """Show which vector of length one a matrix shrinks most.

    Returns
    -------
    Figure
        Left: the circle. Right: the ellipse that the matrix makes of it, drawn to the same scale.
    """
    A = np.array([[2.0, 1], [1, 2]])
    turn = np.linspace(0, 2 * np.pi, 121)
    circle = np.stack([np.cos(turn), np.sin(turn)])
    shortest, longest = np.array([1, -1]) / np.sqrt(2), np.array([1, 1]) / np.sqrt(2)
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.3))
    for ax, matrix, title in zip(
        axes, (np.eye(2), A), ("all vectors of length one", "what A makes of them"), strict=True
    ):
        ax.plot(*(matrix @ circle), color=ROLES["ray"], lw=2)
        for way, role in ((longest, "guide"), (shortest, "object")):
            tip = matrix @ way
            arrow = {"arrowstyle": "-|>", "color": ROLES[role], "lw": 2.5, "shrinkA": 0}
            ax.annotate("", xy=tuple(tip), xytext=(0, 0), arrowprops={**arrow, "shrinkB": 0})
        ax.set(
            title=title, xlim=(-2.8, 2.8), ylim=(-2.6, 2.6), aspect="equal", xticks=[], yticks=[]
        )
    write(axes[0], (0.85, -1.05), "last row of Vᵀ", "object", ha="left")
    write(axes[1], (0.85, -1.05), "shortest: 1", "object", ha="left")
    write(axes[1], (0.5, 2.0), "longest: 3", "guide", ha="right")
    return fig


def _shadow(ax: Axes, A: Floats, b: Floats) -> None:
    """Draw b, the space of all A x, and the foot of b in it."""
    view = onlooker((6.4, -7.4, 4.2), (0.75, 0.35, 0.9), 1250)
    zero = np.zeros(3)
    foot = A @ np.linalg.lstsq(A, b)[0]
    if A.shape[1] == 1:
        show_path(ax, view, np.outer([-0.35, 1.5], A[:, 0]), "camera", lw=1.5)
    else:
        corners = np.array([[-0.25, -0.3], [1.3, -0.3], [1.3, 1.15], [-0.25, 1.15]])
        show_face(ax, view, corners @ A.T, "camera", alpha=0.15)
    show_arrow(ax, view, zero, b, "object")
    show_arrow(ax, view, zero, foot, "camera")
    show_path(ax, view, np.array([foot, b]), "ray", ls=(0, (4, 3)))
    _right_angle(ax, view, foot, b)
    names = ("a x", "all a x") if A.shape[1] == 1 else ("A x", "all A x")
    far = A @ [1.3, 1.15] if A.shape[1] == 2 else 1.45 * A[:, 0]
    _named(ax, view.project(b), (0, -14), "b: measured", "object")
    _named(ax, view.project(0.55 * (foot + b)), (44, 0), "residual")
    _named(ax, view.project(foot), (52, 22), f"{names[0]}: best", "camera")
    _named(ax, view.project(far), (0, -16), names[1], "camera")
    ax.set(xlim=(100, 690), ylim=(430, 60))


def _named(ax: Axes, at: Floats, off: tuple[float, float], text: str, role: str = "guide") -> None:
    """Write a name beside a point, `off` px from it."""
    write(ax, at + np.array(off), text, role)


def _right_angle(ax: Axes, view: Camera, foot: Floats, b: Floats) -> None:
    """Draw the small square of a right angle at the foot of b."""
    up, back = (v / np.linalg.norm(v) for v in (b - foot, -foot))
    corner = foot + 0.16 * np.array([back, back + up, up])
    show_path(ax, view, corner, "ray", lw=1.2)


@figure("Strain against load: eight readings and a line through them.")
def strain_line(yours: ArrayLike | None = None) -> Figure:
    """Show the readings of the steel bar and a line.

    Parameters
    ----------
    yours : array_like, shape (2,), optional
        Slope and height of a student's line.

    Returns
    -------
    Figure
        Readings, the line if there is one, and the residuals.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.3))
    y = readings()
    drawn = same_shape(yours, np.zeros(2))
    if drawn is not None and np.isfinite(drawn).all():
        slope, height = drawn.tolist()
        ends = np.array([0, 8.8])
        ax.plot(ends, slope * ends + height, color=ROLES["second"], label="your line")
        for x, strain in zip(LOADS, y, strict=True):
            ax.plot([x, x], [strain, slope * x + height], color=ROLES["object"], lw=2)
        ax.legend(loc="upper left")
    ax.plot(LOADS, y, "o", color=BLACK, ms=7)
    ax.set(xlabel="load (kN)", ylabel=r"strain ($10^{-6}$)", xlim=(0, 8.8), ylim=(0, 430))
    return fig


@figure("A slipped gauge pulls the line of least squares; the robust line stays with the others.")
def slipped_gauge() -> Figure:
    """Show what one wrong reading does to least squares, and to a robust fit.

    Returns
    -------
    Figure
        Readings with their weights, and both lines.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.5))
    y = readings(slipped=True)
    A = np.column_stack([LOADS, np.ones_like(LOADS)])
    robust, ends = solve_robust(A, y), np.array([0.0, 8.8])
    pairs = (
        (fit_line(LOADS, y), "object", "--", "least squares"),
        (robust.x, "image", "-", "robust"),
    )
    for (slope, height), role, dash, label in pairs:
        ax.plot(ends, slope * ends + height, dash, color=ROLES[role], label=label)
    ax.scatter(LOADS, y, s=20 + 90 * robust.weights, color=BLACK, zorder=3)
    for x, strain, weight in zip(LOADS, y, robust.weights, strict=True):
        write(ax, (x, strain - 42), f"{weight:.2f}", "guide", fontsize=9)
    write(ax, (8.7, 20), "numbers: how much each reading counts", "guide", ha="right", fontsize=9)
    ax.set(xlabel="load (kN)", ylabel=r"strain ($10^{-6}$)", xlim=(0, 8.8), ylim=(-20, 600))
    ax.legend(loc="upper left")
    return fig


@figure("A bar under load, and the line that its eight readings nearly make.")
def bar_in_tension() -> Figure:
    """Show the steel bar, pulled at both ends, with the strain gauge on it.

    Returns
    -------
    Figure
        A sketch.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 1.4))
    sketch(ax)
    ax.fill([-3, 3, 3, -3], [-0.22, -0.22, 0.22, 0.22], color=GREY, alpha=0.5, lw=0)
    ax.fill([-0.35, 0.35, 0.35, -0.35], [-0.1, -0.1, 0.1, 0.1], color=ROLES["object"], lw=0)
    for side in (-1, 1):
        arrow = {"arrowstyle": "-|>", "color": ROLES["camera"], "lw": 2.5}
        ax.annotate("", xy=(side * 4.1, 0), xytext=(side * 3.05, 0), arrowprops=arrow)
        write(ax, (side * 4.6, 0), "load", "camera")
    stroke(ax, [(0, 0.12), (0, 0.5)], "object", lw=1)
    write(ax, (0, 0.66), "strain gauge: how much longer, in millionths", "object")
    fit(ax, -5.2, 5.2, -0.5, 0.9)
    return fig
