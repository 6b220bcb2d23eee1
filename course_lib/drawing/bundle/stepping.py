"""What the exercises of chapter 10 are tried on: a third picture, small equations, half a chain."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from course_lib.bundle import NormalBlocks, normal_blocks, squared_error
from course_lib.drawing.bundle.growing import chain, grown, observed
from course_lib.drawing.bundle.matrices import small_block
from course_lib.drawing.diagrams import Floats, figure, panels, plain_numbers, write
from course_lib.drawing.style import FULL_WIDTH, ROLES

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Cameras of the chain that are adjusted in the exercise.
HALF = 12
#: Damping of the small equations.
DAMPING = 1e-3


class Table(NamedTuple):
    """A block as the exercise takes it.

    Attributes
    ----------
    K : ndarray, shape (3, 3)
        Intrinsics, px.
    R, t : ndarray, shape (v, 3, 3) and (v, 3)
        Poses, world to camera.
    points : ndarray, shape (n, 3)
        Points, m.
    pixels : ndarray, shape (v, n, 2)
        Where cameras see points; NaN where they do not.
    """

    K: Floats
    R: Floats
    t: Floats
    points: Floats
    pixels: Floats


def third_picture() -> tuple[Floats, Floats, Floats]:
    """Return points that the first two pictures of the vase gave, where the third sees them, K."""
    start = grown("only chained")[0]
    numbers, pixels = observed(chain(), 2)
    known = np.isfinite(start.points[numbers, 0])
    return start.points[numbers[known]], pixels[known], start.block.K[0]


def pixel(point: ArrayLike, K: ArrayLike, R: ArrayLike, t: ArrayLike) -> Floats:
    """Return where a camera sees points, shape (2,) or (N, 2), px."""
    q = (np.asarray(point) @ np.asarray(R).T + np.asarray(t)) @ np.asarray(K).T
    return np.asarray(q[..., :2] / q[..., 2:])


def pose_rms(
    points: ArrayLike, pixels: ArrayLike, K: ArrayLike, R: ArrayLike, t: ArrayLike
) -> float:
    """Return the RMS of the reprojection error of one camera, px."""
    left = pixel(points, K, R, t) - np.asarray(pixels)
    return float(np.sqrt((left**2).sum(axis=1).mean()))


@cache
def small_equations() -> NormalBlocks:
    """Return the damped normal equations of the small block."""
    block, seen = small_block()
    pixels = np.full((len(block.R), len(block.points), 2), np.nan)
    pixels[seen.cameras, seen.points] = seen.pixels
    U, W, V, g_c, g_p = normal_blocks(block.K, block.R, block.t, block.points, pixels)
    more = DAMPING * np.eye(len(U))
    return NormalBlocks(U * (1 + more), W, V * (1 + DAMPING * np.eye(3)), g_c, g_p)


def arrow(U: Floats, W: Floats, V: Floats) -> Floats:
    """Return the whole normal matrix, cameras first, from its blocks."""
    c, n = len(U), len(V)
    N = np.zeros((c + 3 * n, c + 3 * n))
    N[:c, :c] = U
    for j in range(n):
        own = slice(c + 3 * j, c + 3 * j + 3)
        N[:c, own], N[own, :c], N[own, own] = W[j], W[j].T, V[j]
    return N


@cache
def half_chain() -> Table:
    """Return the first twelve cameras of the chain, not adjusted, and the points they see."""
    stage, seen = grown("only chained")[HALF - 2], chain()
    mine = seen.only((seen.cameras < HALF) & np.isfinite(stage.points[seen.points, 0]))
    known, numbers = np.unique(mine.points, return_inverse=True)
    pixels = np.full((HALF, len(known), 2), np.nan)
    pixels[mine.cameras, numbers] = mine.pixels
    block = stage.block
    return Table(block.K[0], block.R, block.t, stage.points[known], pixels)


def block_rms(K: ArrayLike, R: Any, t: Any, points: Any, pixels: ArrayLike) -> float:
    """Return the RMS of the reprojection error of a block, px; NaN if it is no block.

    Parameters
    ----------
    K, pixels
        As in `Table`.
    R, t, points : object
        Whatever a student's function returned.

    Returns
    -------
    float
        Infinite if a point is behind a camera that sees it.
    """
    try:
        error = squared_error(K, R, t, points, pixels)
    except (TypeError, ValueError):
        return float("nan")
    return float(np.sqrt(error / np.isfinite(np.asarray(pixels)[..., 0]).sum()))


@figure("How the reprojection error of twelve cameras falls, step by step.")
def adjustment_steps(rms: ArrayLike) -> Figure:
    """Show the RMS after no step, after one, and so on.

    Parameters
    ----------
    rms : array_like, shape (N,)
        The RMS, px; what is not finite is not drawn.

    Returns
    -------
    Figure
        The RMS against the number of steps.
    """
    values = np.asarray(rms, dtype=float)
    values = values[: int(np.argmin(np.append(np.isfinite(values), False)))]
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.75, 2.9))
    ax.plot(values.clip(0.3, 6), "o-", color=ROLES["camera"], ms=5)
    ax.set(
        xlabel="steps (number)", ylabel="RMS (px), logarithmic", xticks=range(7), xlim=(-0.4, 6.4)
    )
    ax.set(yscale="log", ylim=(0.3, 6))
    ax.set_yticks([0.3, 0.5, 1, 2, 5])
    plain_numbers(ax)
    for n in sorted({0, len(values) - 1} - {-1}):
        text = f"{values[n]:.2f} px" if values[n] < 6 else "more than 6 px"
        write(ax, (n, values[n].clip(0.3, 4.2) * 1.2), text, "camera")
    if len(values) < 2:
        write(ax, (3.5, 1.2), "no answer yet", "guide", fontsize=14)
    return fig
