"""Still figures: a calibration object, the camera found from it, and what a table corrects."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from course_lib.camera.projection import project
from course_lib.drawing.diagrams import (
    Floats,
    figure,
    in_figures,
    panels,
    picture_frame,
    same_shape,
    write,
)
from course_lib.drawing.estimation.table import SIGMA
from course_lib.drawing.style import BLACK, FULL_WIDTH, GREY, LIGHT, ROLES
from course_lib.homogeneous import apply_homography
from course_lib.homography import homography_dlt
from course_lib.resection.correction import correction_from_table, correction_table
from course_lib.resection.learned_correction import HeldOut, hold_out
from data_generators import cell

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.patches import Rectangle

#: The dots of a sheet that lies on the table, mm.
SHEET = np.stack(np.meshgrid(np.arange(0, 481, 30.0), np.arange(0, 321, 32.0)), -1).reshape(-1, 2)
CHANCE = SIGMA * np.sqrt(2)  #: px: RMS of the error of a dot, in u and v together
#: Cells of correction tables: (rows, columns).
TABLES = ((1, 1), (2, 2), (2, 3), (3, 4), (4, 5), (5, 7), (6, 8), (8, 10), (10, 13), (12, 16))


@figure("A calibration object of three panels with 48 dots, and where a camera matrix puts them.")
def calibration_object(pixels: ArrayLike, P: ArrayLike | None = None) -> Figure:
    """Show the calibration object with the dots that were found, and a camera matrix's answer.

    Parameters
    ----------
    pixels : array_like, shape (48, 2)
        Where the dots were found.
    P : array_like, shape (3, 4), optional
        A camera matrix; its projections and the axes of the robot are drawn.

    Returns
    -------
    Figure
        The photograph, and a part of it enlarged.
    """
    camera = cell.camera_beside()
    picture, at = cell.photograph(camera, "object"), np.asarray(pixels, dtype=float)
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.3), width_ratios=(1.35, 1))
    for ax in axes:
        ax.imshow(picture)
        picture_frame(ax, cell.SIZE)
        ax.plot(*at.T, "+", color="white", ms=7, mew=1.5)
    drawn = same_shape(P, np.zeros((3, 4)))
    title = "48 dots" if drawn is None else _projected(axes, drawn, at)
    axes[0].set_title(title)
    axes[1].set(xlim=(at[40, 0] - 60, at[40, 0] + 60), ylim=(at[40, 1] + 55, at[40, 1] - 55))
    axes[1].set_title("enlarged")
    return fig


def _projected(axes: Floats, P: Floats, pixels: Floats) -> str:
    """Draw what a camera matrix makes of dots and axes; return how far off the dots are."""
    try:
        seen = project(cell.object_points(), P)
    except ValueError:
        return "P is not a camera"
    for ax in axes:
        ax.plot(*seen.T, "o", mfc="none", mec=ROLES["ray"], ms=11, mew=1.6)
    origin, *tips = project([[0, 0, 0], [100, 0, 0], [0, 100, 0], [0, 0, 100]], P)
    for name, tip in zip("xyz", tips, strict=True):
        if np.isfinite([origin, tip]).all():
            axes[0].plot(*np.array([origin, tip]).T, color=ROLES["second"], lw=2)
            axes[0].text(*tip, f"${name}$", color="white", fontsize=12, clip_on=True)
    rms = np.sqrt(((seen - pixels) ** 2).sum(axis=1).mean())
    if np.isnan(rms):
        return "P has dots behind the camera"
    return f"rings: P, {in_figures(rms, 2)} px from the dots"


@figure("A correction table: an arrow for each of its cells, drawn {times:g} times as long.")
def correction(
    table: ArrayLike | None, shape: tuple[int, int] = (6, 8), times: float = 20.0
) -> Figure:
    """Show a correction table over the picture, and what it says between its cells.

    Parameters
    ----------
    table : array_like, shape (rows, columns, 2), optional
        Mean residuals, px.
    shape : tuple of int
        Rows and columns that it should have.
    times : float
        How many times too long they are drawn.

    Returns
    -------
    Figure
        The cells with their arrows; fine arrows in between are interpolated.
    """
    fig, ax = panels(1, 1, (0.78 * FULL_WIDTH, 4.4))
    picture_frame(ax, cell.SIZE)
    rows, columns = shape
    entries = same_shape(table, np.zeros((rows, columns, 2)))
    if entries is None or not (np.abs(entries) < np.max(cell.SIZE)).all():  # nor NaN
        write(ax, (320, 240), "no table yet", "guide")
        return fig
    for k, (count, line) in enumerate(((columns, ax.axvline), (rows, ax.axhline))):
        for edge in np.arange(1, count) * cell.SIZE[k] / count - 0.5:
            line(edge, color=GREY, lw=0.8)
    for r, c in np.argwhere(~entries.any(axis=-1)):
        corner = (c * cell.SIZE[0] / columns - 0.5, r * cell.SIZE[1] / rows - 0.5)
        ax.add_patch(_shade(corner, columns, rows))
    fine = np.stack(np.meshgrid(np.linspace(12, 627, 26), np.linspace(12, 467, 20)), -1)
    between = correction_from_table(fine.reshape(-1, 2), entries, cell.SIZE)
    _arrows(ax, fine.reshape(-1, 2), between, times, ROLES["ray"], 0.0018)
    u, v = (
        (np.arange(n) + 0.5) * s / n - 0.5 for n, s in zip((columns, rows), cell.SIZE, strict=True)
    )
    middles = np.stack(np.meshgrid(u, v), -1).reshape(-1, 2)
    _arrows(ax, middles, entries.reshape(-1, 2), times, ROLES["object"], 0.0045)
    ax.set_title(f"{rows} × {columns} cells, arrows {times:g} times as long; grey: zero, no dots")
    return fig


def _shade(corner: tuple[float, float], columns: int, rows: int) -> Rectangle:
    """Return a grey cell, for one without an entry."""
    from matplotlib.patches import Rectangle

    width, height = cell.SIZE[0] / columns, cell.SIZE[1] / rows
    return Rectangle(corner, width, height, color=LIGHT, lw=0, zorder=0)


def _arrows(ax: Axes, at: Floats, ways: Floats, times: float, colour: str, width: float) -> None:
    look: dict[str, Any] = {"angles": "xy", "scale_units": "xy", "scale": 1 / times, "width": width}
    ax.quiver(*at.T, *ways.T, color=colour, **look)


@figure("Residuals after the correction against the size of the table: learned and held out.")
def held_out(pixels: ArrayLike, residuals: ArrayLike) -> Figure:
    """Show when a larger table stops helping.

    Parameters
    ----------
    pixels, residuals : array_like, shape (N, 2)
        What tables are learned from, px.

    Returns
    -------
    Figure
        Root mean squares against the number of cells.
    """
    judged = [judge_table(pixels, residuals, shape) for shape in TABLES]
    cells = [rows * columns for rows, columns in TABLES]
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.4))
    ax.axhline(judged[0].before, color=GREY, lw=1.5, ls=(0, (6, 4)))
    write(ax, (230, judged[0].before + 0.07), "no correction", "guide", ha="right")
    ax.axhline(CHANCE, color=GREY, lw=1.5, ls=(0, (1, 2)))
    write(ax, (1.0, CHANCE - 0.08), f"chance alone: {CHANCE:.2f} px", "guide", ha="left")
    learned, unseen = ([getattr(j, name) for j in judged] for name in ("learned", "held_out"))
    ax.semilogx(cells, learned, "s--", color=ROLES["image"], label="points it was made from")
    ax.semilogx(cells, unseen, "o-", color=ROLES["object"], label="points it has not seen")
    ax.semilogx(
        cells, _without_errors(), "-", color=BLACK, lw=1, label="the same, dots without errors"
    )
    best = int(np.argmin(unseen))
    ax.plot(cells[best], unseen[best], "o", ms=16, mfc="none", mec=BLACK, mew=1.5)
    ax.set(xlabel="size of the table (cells), logarithmic")
    ax.set(ylabel="residual, RMS (px)", ylim=(0, None))
    ax.set_xticks(cells, [str(c) for c in cells])
    ax.minorticks_off()
    ax.legend(loc="upper right", bbox_to_anchor=(1, 0.93))
    return fig


@cache
def _without_errors() -> tuple[float, ...]:
    """Return what is left at unseen dots for each size of table, with dots that are exact."""
    return tuple(judge_table(*exact_sheet(), shape).held_out for shape in TABLES)


def exact_sheet() -> tuple[Floats, Floats]:
    """Return where the dots of the sheet are seen through the cover, and what a homography leaves.

    Returns
    -------
    pixels, residuals : ndarray, shape (N, 2)
        Without any error of measuring, px.
    """
    straight = cell.camera_above().project(cell.on_table(SHEET))
    pixels = straight + cell.cover_shift(straight)
    return pixels, pixels - apply_homography(SHEET, homography_dlt(SHEET, pixels))


def judge_table(pixels: ArrayLike, residuals: ArrayLike, shape: tuple[int, int]) -> HeldOut:
    """Return how good a table of a shape is, at points that it has not seen."""

    def correct(known: Floats, left: Floats, at: Floats) -> Floats:
        table = correction_table(known, left, cell.SIZE, shape)
        return correction_from_table(at, table, cell.SIZE)

    return hold_out(correct, pixels, residuals, 10, np.random.default_rng(1))
