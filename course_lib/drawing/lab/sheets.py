"""All photographs on one sheet, where the target was in them, and what the lens does."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.distortion import displacement_field, pixel_grid
from course_lib.distortion.plumb_line import across_line
from course_lib.drawing.diagrams import Floats, figure, panels, picture_frame
from course_lib.drawing.style import BLUE, FULL_WIDTH, GREY, RED, ROLES, rgb

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Pixels = NDArray[np.uint8]

SMALL = 320  # px: width of a thumbnail
ACROSS = 6  # thumbnails in a row
CELLS = (8, 6)  # fields of the picture
SIGNS = {True: "✓", False: "✗"}  # used or not


def thumbnail(grey: Pixels, points: ArrayLike, width: int = SMALL) -> Pixels:
    """Return a photograph made small, with dots at what was found in it.

    Parameters
    ----------
    grey : ndarray, shape (h, w), uint8
        The photograph.
    points : array_like, shape (N, 2)
        In its pixels.
    width : int
        Of the result, px.

    Returns
    -------
    ndarray, shape (height, width, 3), uint8
        RGB.
    """
    import cv2

    scale = width / grey.shape[1]
    size = (width, max(1, round(grey.shape[0] * scale)))
    small = cv2.resize(grey, size, interpolation=cv2.INTER_AREA)
    colour = np.repeat(small[..., None], 3, axis=2)
    for u, v in (np.asarray(points, float).reshape(-1, 2) + 0.5) * scale - 0.5:
        centre = (round(8 * u), round(8 * v))
        cv2.circle(colour, centre, 8 * 3, (255, 255, 255), -1, cv2.LINE_AA, 3)
        cv2.circle(colour, centre, 8 * 2, rgb(BLUE), -1, cv2.LINE_AA, 3)
    return np.asarray(colour, np.uint8)


def short_name(name: str) -> str:
    """Return the last 15 characters of a file's name, which tell it from the others."""
    return name if len(name) <= 15 else f"…{name[-14:]}"


@figure("All photographs, small; a tick and blue corners where the target was found, else a cross.")
def contact_sheet(
    thumbnails: Sequence[Pixels | None], names: Sequence[str], used: Sequence[bool]
) -> Figure:
    """Show all photographs, and which of them can be used.

    Parameters
    ----------
    thumbnails : sequence of ndarray or None
        As of `thumbnail`; None for a file that is no photograph.
    names : sequence of str
        Of the files.
    used : sequence of bool
        Which can be used.

    Returns
    -------
    Figure
        Six in a row.
    """
    rows = -(-len(names) // ACROSS)
    fig, grid = panels(rows, ACROSS, (FULL_WIDTH, 1.25 * rows), squeeze=False)
    for ax in grid.ravel():
        ax.axis("off")
    for ax, picture, name, good in zip(grid.ravel(), thumbnails, names, used, strict=False):
        if picture is not None:
            ax.imshow(picture)
        title = f"{SIGNS[good]} {short_name(name)}"
        ax.set_title(title, fontsize=7.5, color=BLUE if good else RED, fontweight="normal")
    return fig


@figure("Where the target was in all photographs: outlines, corners, and fields without a corner.")
def covered(views: Sequence[ArrayLike], size: tuple[int, int], corners: Sequence[int]) -> Figure:
    """Show where in the picture the target was.

    Parameters
    ----------
    views : sequence of array_like, shape (N, 2)
        Points of the target in each photograph, px.
    size : tuple of int
        Width and height, px.
    corners : sequence of int
        Which points are the target's outermost, in order around; others if not all were found.

    Returns
    -------
    Figure
        Fields without a point are grey.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.72, FULL_WIDTH * 0.72 * size[1] / size[0] + 0.3))
    every = np.concatenate([np.asarray(view, float) for view in views])
    across, down = (np.linspace(-0.5, n - 0.5, k + 1) for n, k in zip(size, CELLS, strict=True))
    counts = np.histogram2d(every[:, 0], every[:, 1], bins=(across, down))[0].T
    ax.pcolormesh(across, down, np.where(counts > 0, np.nan, 1), cmap="Greys", vmin=0, vmax=4)
    for view in views:
        points = np.asarray(view, float)
        ax.plot(*points.T, ".", ms=2, color=ROLES["camera"])
        if len(points) > max(corners):
            ax.fill(*points[list(corners)].T, fill=False, ec=ROLES["camera"], lw=0.7, alpha=0.6)
    picture_frame(ax, size)
    ax.set_title(
        f"{(counts > 0).sum()} of {counts.size} fields have corners (grey: none)", fontsize=10
    )
    return fig


@figure("How far the lens moves each place of the picture, as lines drawn longer than they are.")
def lens_bend(K: ArrayLike, coefficients: ArrayLike, size: tuple[int, int]) -> Figure:
    """Show what is undone when a photograph is straightened.

    Parameters
    ----------
    K, coefficients : array_like
        The camera, px.
    size : tuple of int
        Width and height, px.

    Returns
    -------
    Figure
        Lines from where a pinhole would show a place (dots) to where it is.
    """
    pixels = pixel_grid(size, 17, 13)[1:-1, 1:-1].reshape(-1, 2)
    moved = displacement_field(pixels, K, coefficients)
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.72, FULL_WIDTH * 0.72 * size[1] / size[0] + 0.3))
    longest, far = _moves(ax, pixels, moved, size)
    picture_frame(ax, size)
    ax.set_title(f"{far:g} times as long as they are; the longest is {longest:.1f} px", fontsize=10)
    return fig


def _moves(ax: Axes, pixels: Floats, moved: Floats, size: tuple[int, int]) -> tuple[float, float]:
    """Draw moves as lines; return the longest one, px, and how many times longer they are drawn."""
    lengths = np.linalg.norm(moved, axis=1)
    longest = float(np.nanmax(lengths))
    far = _times(longest, size)
    lines = np.stack([pixels, pixels + far * moved], axis=1)
    for line in lines:
        ax.plot(*line.T, "-", color=ROLES["camera"], lw=1.2)
    ax.plot(*pixels.T, ".", ms=2, color=GREY)
    return longest, far


def _times(longest: float, size: tuple[int, int]) -> float:
    """Return how many times as long as it is a move is drawn to be seen: 1, 2, 5, 10 and so on."""
    wanted = 0.05 * size[0] / max(longest, 1e-9)
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(max(step * power for step in (1, 2, 5) if step * power <= wanted))


@figure(
    "A photograph as taken and straightened; a row of corners, drawn more bent than it is, is "
    "straight in the second."
)
def straightened(
    photographs: Sequence[Pixels], rows: Sequence[ArrayLike], size: tuple[int, int]
) -> Figure:
    """Show what undistorting does to a photograph, and to a row of the target's corners.

    Parameters
    ----------
    photographs : two ndarray, shape (h, w), uint8
        Before and after; they may be smaller than they were taken.
    rows : two array_like, shape (N, 2)
        Corners that lie on a straight line of the target, px of the photograph as taken.
    size : tuple of int
        Its width and height, px.

    Returns
    -------
    Figure
        Two pictures.
    """
    offsets = [across_line(np.asarray(row, float)) for row in rows]
    far = _times(float(np.abs(offsets[0][0]).max()), size)
    fig, axes = panels(1, 2, (FULL_WIDTH, FULL_WIDTH / 2 * size[1] / size[0] + 0.5))
    names = ("as taken", "straightened")
    for ax, picture, row, (off, normal), name in zip(
        axes, photographs, rows, offsets, names, strict=True
    ):
        picture_frame(ax, size)
        ax.imshow(picture, extent=(-0.5, size[0] - 0.5, size[1] - 0.5, -0.5), vmin=0, vmax=255)
        on_line = np.asarray(row, float) - off[:, None] * normal
        ax.plot(*on_line[[0, -1]].T, color=ROLES["ray"], lw=1.5)
        bent = on_line + far * off[:, None] * normal
        ax.plot(*bent.T, "o-", color=ROLES["camera"], ms=4, mec="white", mew=0.6, lw=1.2)
        most = np.abs(off).max()
        ax.set_title(f"{name}: {most:.2f} px off a line, drawn {far:g} ×", fontsize=10)
    return fig
