"""A real photograph of a checkerboard, the straight lines on it, and how straight they look."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib import data
from course_lib.detection import Checkerboard, detect_board
from course_lib.distortion import (
    distort_radial,
    normalised_from_pixels,
    pixel_grid,
    pixels_from_normalised,
    straightness,
    undistort_pixels,
)
from course_lib.drawing.diagrams import Floats, figure, panels, picture_frame, plain_numbers, write
from course_lib.drawing.distortion.pictures import looked_up, mesh_map
from course_lib.drawing.style import FULL_WIDTH, ROLES
from data_generators.rails import LENS, SIZE, K
from data_generators.targets import checkerboard

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Thirteen photographs of one board by one camera; its inner corners.
PHOTOGRAPHS = tuple(f"opencv_stereo/left{n:02}.jpg" for n in (*range(1, 10), *range(11, 15)))
COLUMNS, ROWS = 9, 6
#: Lines that are numbered in the photograph, the first one 1: the ends of both families.
NUMBERED = (1, 6, 7, 10, 15)
#: The one that the chapter shows: its board comes close to the picture's edge.
SHOWN = PHOTOGRAPHS[5]


@cache
def board_photograph(name: str = SHOWN) -> tuple[NDArray[np.uint8], bool]:
    """Return a photograph of a checkerboard; without a network, a computed one.

    Parameters
    ----------
    name : str
        One of `PHOTOGRAPHS`.

    Returns
    -------
    picture : ndarray, shape (480, 640), uint8
        Grey values.
    real : bool
        Whether it is the photograph.
    """
    import cv2

    try:
        path = data.fetch(name)
    except data.Unavailable:
        return computed_board(), False
    picture = cv2.imdecode(np.fromfile(path, np.uint8), cv2.IMREAD_GRAYSCALE)
    return np.asarray(picture, np.uint8), True


@cache
def computed_board() -> NDArray[np.uint8]:
    """Return a computed photograph of a board through the lens `LENS` of the rails.

    Returns
    -------
    ndarray, shape (480, 640), uint8
        Grey values, with a little blur and noise.
    """
    import cv2

    board = checkerboard(ROWS + 1, COLUMNS + 1, square=48)
    tall, broad = board.shape
    corners = np.array([[0, 0], [broad, 0], [broad, tall], [0, tall]], np.float32) - 0.5
    # Where they lie in the pinhole's picture, which reaches 200 px farther on every side.
    seen = np.array([[398, 20], [672, 38], [638, 480], [380, 440]], np.float32) + 200
    wide, size = K + np.outer((200, 200, 0), (0, 0, 1)), (SIZE[0] + 400, SIZE[1] + 400)
    warp = cv2.getPerspectiveTransform(corners, seen)
    pinhole = cv2.warpPerspective(board, warp, size, flags=cv2.INTER_AREA, borderValue=90)
    places = mesh_map(lambda pixels: undistort_pixels(pixels, K, LENS, wide), SIZE)
    picture = cv2.GaussianBlur(looked_up(pinhole, places), (0, 0), 0.7).astype(float)
    noise = np.random.default_rng(2).normal(0, 1.5, picture.shape)
    return np.asarray(np.rint(np.clip(0.8 * picture + 20 + noise, 0, 255)), np.uint8)


def board_lines(picture: NDArray[np.uint8]) -> list[Floats]:
    """Return the straight lines of a board: its rows and columns of inner corners.

    Parameters
    ----------
    picture : ndarray, shape (height, width), uint8
        A photograph of a board with 9 by 6 inner corners.

    Returns
    -------
    list of ndarray, each of shape (9, 2) or (6, 2)
        Corners of each line in px: six lines of nine, then nine of six.

    Raises
    ------
    ValueError
        If there is no such board in the picture.
    """
    seen = detect_board(picture, Checkerboard(COLUMNS, ROWS, square=1.0))  # of any size
    if not seen.found:
        raise ValueError(seen.verdict)
    grid = seen.points.reshape(ROWS, COLUMNS, 2)
    return [*grid, *grid.transpose(1, 0, 2)]


@cache
def all_lines() -> list[Floats]:
    """Return the lines of all thirteen photographs; of the computed one without a network."""
    lines = []
    for name in PHOTOGRAPHS:
        picture, real = board_photograph(name)
        if not real:  # one that does not arrive is enough: each may take a long while
            return board_lines(computed_board())
        lines += board_lines(picture)
    return lines


def most_bent(lines: Sequence[ArrayLike]) -> int:
    """Return which of several lines is the least straight one."""
    return int(np.argmax([straightness(line) for line in lines]))


@figure(
    "Left: the photograph of a board with a straight edge laid over its most bent line of corners. "
    "Right: how far each line of corners is from straight, in px."
)
def bent_lines(
    picture: NDArray[np.uint8], lines: Sequence[ArrayLike], yours: Sequence[object] | None = None
) -> Figure:
    """Show the lines of a board in a photograph, and how straight each of them is.

    Parameters
    ----------
    picture : ndarray, shape (height, width), uint8
        The photograph.
    lines : sequence of array_like, each of shape (N, 2)
        Points of each line, px.
    yours : sequence of float, optional
        How straight a student's function found each line, px.

    Returns
    -------
    Figure
        The photograph with the lines, and a bar for each.
    """
    points = [np.asarray(line, dtype=float) for line in lines]
    worst = most_bent(points)
    fig, (left, right) = panels(1, 2, (FULL_WIDTH, 3.5), width_ratios=[1.3, 1])
    left.imshow(picture, vmin=0, vmax=255)
    for line in points:
        left.plot(*line.T, color=ROLES["camera"], lw=0.8)
    left.plot(*points[worst][[0, -1]].T, color=ROLES["ray"], lw=1.6)
    left.plot(*points[worst].T, "o", color=ROLES["object"], ms=4)
    for number in NUMBERED:
        _numbered(left, points, number)
    picture_frame(left, (picture.shape[1], picture.shape[0]))
    count = np.arange(1, len(points) + 1)
    bars = right.bar(count, [straightness(line) for line in points], color=ROLES["camera"])
    bars[worst].set_color(ROLES["object"])
    if yours is not None and None not in yours:
        right.plot(count, np.asarray(yours, float), "*", color=ROLES["second"], ms=9, ls="")
    right.set(xlabel="line (no unit)", ylabel="RMS from straight (px)")
    right.set_xticks(count[::2])
    plain_numbers(right)
    return fig


def _numbered(ax: Axes, lines: Sequence[Floats], number: int) -> None:
    """Write the number of a line beyond one of its ends, on white."""
    if number > len(lines):
        return
    line = lines[number - 1]
    # Long lines are numbered behind the last point, short ones before the first.
    end, next_one = (line[-1], line[-2]) if len(line) == COLUMNS else (line[0], line[1])
    place = end + 26 * (end - next_one) / np.hypot(*(end - next_one))
    paper = {"facecolor": "white", "edgecolor": "none", "pad": 1.0, "alpha": 0.9}
    write(ax, tuple(place), str(number), fontsize=9, bbox=paper)


@figure(
    "Left: a photograph of a board. Right: the same, straightened by a map that goes on beyond the "
    "valid radius: in the four corners parts of the scene appear a second time, mirrored."
)
def doubled_corners(k1: float = LENS[0], wider: float = 0.48) -> Figure:
    """Show what a map does to a photograph beyond the radius at which its model folds over.

    Parameters
    ----------
    k1 : float
        Radial coefficient of the map, no unit.
    wider : float
        Focal length of the new picture, as a share of the old one.

    Returns
    -------
    Figure
        The photograph, and what the map makes of it.
    """
    picture, _ = board_photograph()
    ideal = normalised_from_pixels(pixel_grid(SIZE, *SIZE).reshape(-1, 2), K) / wider
    there = pixels_from_normalised(distort_radial(ideal, [k1]), K)
    places = np.asarray(there.reshape(*picture.shape, 2), np.float32)
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.2))
    titles = ("Photograph", f"By a map with $k_1$ = {k1:g}, wider".replace("-", "−"))
    for ax, shown, title in zip(axes, (picture, looked_up(picture, places)), titles, strict=True):
        ax.imshow(shown, vmin=0, vmax=255)
        picture_frame(ax, SIZE)
        ax.set_title(title, fontsize=11)
    return fig
