"""Still figures of the equations of a block: what is zero, and what is left without the points."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from course_lib.bundle import Block, Observations, reprojection_jacobian
from course_lib.drawing.diagrams import Floats, figure, panels, write
from course_lib.drawing.style import BLACK, FULL_WIDTH, GREY, LIGHT, ROLES
from data_generators.blocks import turntable

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@cache
def small_block() -> tuple[Block, Observations]:
    """Return six pictures around a vase with 24 points, small enough to show each number."""
    known = turntable(np.random.default_rng(2), pictures=6, points=30, noise=0.5)
    return known.truth, known.observations


def whole_jacobian(block: Block, seen: Observations) -> Floats:
    """Return all derivatives of a block: a row for each measured number, cameras first.

    Parameters
    ----------
    block : Block
        v cameras and n points.
    seen : Observations
        m observations.

    Returns
    -------
    ndarray, shape (2m, 6v + 3n)
        The matrix; most of it is zero.
    """
    v = len(block.R)
    J = np.zeros((2 * len(seen), 6 * v + 3 * len(block.points)))
    for row, (i, j) in enumerate(zip(seen.cameras, seen.points, strict=True)):
        by_pose, by_point = reprojection_jacobian(
            block.points[j], block.K[i], block.R[i], block.t[i]
        )
        J[2 * row : 2 * row + 2, 6 * i : 6 * i + 6] = by_pose
        J[2 * row : 2 * row + 2, 6 * v + 3 * j : 6 * v + 3 * j + 3] = by_point
    return J


@figure("Three matrices of a block, nearly all zero: the derivatives, the arrow, what is left.")
def sparsity() -> Figure:
    """Show where the matrices of a small block are not zero.

    Returns
    -------
    Figure
        J, its normal matrix in the shape of an arrow, and that of the cameras alone.
    """
    block, seen = small_block()
    J, c = whole_jacobian(block, seen), 6 * len(block.R)
    J = J[np.argsort(np.repeat(seen.points, 2), kind="stable")]  # point after point
    N = J.T @ J
    S = N[:c, :c] - N[:c, c:] @ np.linalg.inv(N[c:, c:]) @ N[c:, :c]
    fig, axes = panels(1, 3, (FULL_WIDTH, 3.6), width_ratios=(1, 1, 0.72))
    titles = ("derivatives $J$", "normal matrix $J^T J$", "cameras alone")
    rows = np.arange(len(N)) < c
    for ax, matrix, title, of_camera in zip(
        axes, (J, N, S), titles, (None, rows, rows[:c]), strict=True
    ):
        _pattern(ax, matrix, c, of_camera)
        rows, columns = matrix.shape
        ax.set_title(f"{title}\n{rows} × {columns}", fontsize=11)
    _block_names(axes[1], c, len(N))
    return fig


def _pattern(
    ax: Axes, matrix: Floats, cameras: int, rows_of_cameras: NDArray[np.bool_] | None
) -> None:
    """Draw what is not zero in the colours of cameras and points; black where the two meet."""
    from matplotlib.colors import ListedColormap

    filled = np.abs(matrix) > 1e-9 * np.abs(matrix).max()
    kinds = np.where(np.arange(matrix.shape[1]) < cameras, 1, 2)[None] * filled
    if rows_of_cameras is not None:
        kinds[(rows_of_cameras[:, None] != (kinds == 1)) & filled] = 3
    colours = ListedColormap([LIGHT, ROLES["camera"], ROLES["object"], BLACK])
    ax.imshow(kinds, cmap=colours, vmin=0, vmax=3, aspect="auto", interpolation="nearest")
    ax.set(xticks=[], yticks=[])
    ax.spines[:].set_visible(True)
    ax.spines[:].set_color(GREY)


def _block_names(ax: Axes, cameras: int, size: int) -> None:
    paper = {"facecolor": "white", "edgecolor": "none", "pad": 1.5}
    half = (cameras + size) / 2
    places = {"U": (cameras / 2, cameras / 2), "W": (half, cameras / 2), "V": (half, half)}
    for name, place in (places | {"W^T": (cameras / 2, half)}).items():
        write(ax, place, f"${name}$", fontsize=13, bbox=paper)
