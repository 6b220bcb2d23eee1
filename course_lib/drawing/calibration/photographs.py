"""The thirteen photographs of the chapter, or computed ones, and other cameras' published data."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib import data
from course_lib.boards import Checkerboard
from course_lib.detection import Detection
from course_lib.distortion import undistort_pixels
from course_lib.drawing.diagrams import Floats, figure, panels, picture_frame
from course_lib.drawing.distortion.boards import COLUMNS, PHOTOGRAPHS, ROWS
from course_lib.drawing.distortion.pictures import looked_up, mesh_map
from course_lib.drawing.style import FULL_WIDTH, ROLES
from data_generators.board_observations import observe_board
from data_generators.targets import checkerboard

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Grey = NDArray[np.uint8]

SIZE = (640, 480)
#: The board of the photographs: 30 mm squares.
BOARD = Checkerboard(COLUMNS, ROWS, 30.0)
NAMES = tuple(name.partition("/")[2].removesuffix(".jpg") for name in PHOTOGRAPHS)
#: The camera of the computed photographs, which stand in for the real ones.
K = np.array([[534.0, 0, 342], [0, 534, 234], [0, 0, 1]])
LENS = (-0.28, 0.1, 0.001, 0.0001, 0.0)
TEXTURE = 24  # px of the texture for a square


def left_photographs() -> list[Grey]:
    """Return the thirteen photographs of a board by one camera.

    Returns
    -------
    list of ndarray, shape (480, 640), uint8
        Grey values.

    Raises
    ------
    Unavailable
        If one of them is not here and cannot be downloaded.
    """
    return [grey_file(name) for name in PHOTOGRAPHS]


def grey_file(name: str) -> Grey:
    """Return a photograph of the course's data as grey values."""
    import cv2

    picture = cv2.imdecode(np.fromfile(data.fetch(name), np.uint8), cv2.IMREAD_GRAYSCALE)
    return np.asarray(picture, np.uint8)


@cache
def _computed() -> tuple[Grey, ...]:
    """Return photographs of a board in thirteen poses, through a lens."""
    rng = np.random.default_rng(7)
    seen = observe_board(rng, BOARD.points(), K, LENS, SIZE, views=60, tilt=0.4)
    inside = [min(p.min(), (SIZE - p).min()) > 25 for p in seen.pixels]
    poses = [pose for pose, whole in zip(seen.poses, inside, strict=True) if whole][: len(NAMES)]
    return tuple(computed_photograph(R, t, rng) for R, t in poses)


@cache
def _lens() -> tuple[Floats, tuple[int, int], NDArray[np.float32]]:
    """Return a wider pinhole camera, the size of its picture, and where the lens looks in it."""
    wide, size = K + np.outer((200, 200, 0), (0, 0, 1)), (SIZE[0] + 400, SIZE[1] + 400)
    return wide, size, mesh_map(lambda pixels: undistort_pixels(pixels, K, LENS, wide), SIZE)


def computed_photograph(R: Floats, t: Floats, rng: np.random.Generator) -> Grey:
    """Return a computed photograph of the board by the camera `K` with the distortion `LENS`.

    Parameters
    ----------
    R, t : ndarray, shape (3, 3) and (3,)
        Board to camera, mm.
    rng : numpy.random.Generator
        For the noise of the sensor.

    Returns
    -------
    ndarray, shape (480, 640), uint8
        Grey values.
    """
    import cv2

    wide, size, lens = _lens()
    H = wide @ np.column_stack([*R.T[:2], t])
    texture = checkerboard(COLUMNS + 1, ROWS + 1, TEXTURE, border=1)
    # The first inner corner is two squares from the edge of the texture; pixels are centres.
    to_mm = np.array([[1, 0, 0.5 - 2 * TEXTURE], [0, 1, 0.5 - 2 * TEXTURE], [0, 0, 1.0]])
    to_mm[:2] *= BOARD.square / TEXTURE
    pinhole = cv2.warpPerspective(texture, H @ to_mm, size, flags=cv2.INTER_AREA, borderValue=120)
    picture = cv2.GaussianBlur(looked_up(pinhole, lens), (0, 0), 0.8).astype(float)
    noisy = 0.75 * picture + 25 + rng.normal(0, 2, picture.shape)
    return np.asarray(np.rint(np.clip(noisy, 0, 255)), np.uint8)


def computed_photographs() -> list[Grey]:
    """Return thirteen computed photographs by a camera `K` with the distortion `LENS`.

    Returns
    -------
    list of ndarray, shape (480, 640), uint8
        Grey values.
    """
    return list(_computed())


def zhang_data() -> tuple[Floats, list[Floats]]:
    """Return what Zhang measured: the corners of his board, and where five pictures show them.

    Returns
    -------
    points : ndarray, shape (256, 3)
        Corners of 64 squares, in inches.
    pixels : list of five ndarray, shape (256, 2)
        The same in his pictures, px.

    Raises
    ------
    Unavailable
        If a file is not here and cannot be downloaded.

    References
    ----------
    Z. Zhang, "A flexible new technique for camera calibration", IEEE PAMI 22 (2000), section 5.2.
    """
    names = ["zhang/Model.txt", *(f"zhang/data{n}.txt" for n in range(1, 6))]
    model, *pixels = (np.loadtxt(data.fetch(name)).reshape(-1, 2) for name in names)
    return np.column_stack([model, np.zeros(len(model))]), pixels


@figure("Thirteen photographs of the same checkerboard, held in another pose each time.")
def contact_sheet(photographs: Sequence[Grey], corners: Sequence[ArrayLike] = ()) -> Figure:
    """Show all photographs small, and if given, the corners that were found in them.

    Parameters
    ----------
    photographs : sequence of ndarray
        Pictures.
    corners : sequence of array_like, shape (N, 2)
        Pixels in each.

    Returns
    -------
    Figure
        A panel for each photograph.
    """
    rows = -(-len(photographs) // 5)
    fig, axes = panels(rows, 5, (FULL_WIDTH, 1.42 * rows), squeeze=False)
    for ax in axes.flat:
        ax.axis("off")
    for number, (ax, photograph) in enumerate(zip(axes.flat, photographs, strict=False)):
        ax.imshow(photograph, vmin=0, vmax=255)
        ax.set_title(f"view {number}", fontsize=9, pad=2)
        if len(corners):
            ax.plot(*np.asarray(corners[number]).T, ".", color=ROLES["object"], ms=1.5)
    return fig


@figure("The corners that were found in a photograph, numbered row by row, and one of them near.")
def detected_corners(photograph: Grey, detection: Detection, near: int = 13) -> Figure:
    """Show where corners were found, in which order, and one of them enlarged.

    Parameters
    ----------
    photograph : ndarray, shape (height, width)
        The picture.
    detection : Detection
        What was found in it.
    near : int
        Number of the corner that is enlarged.

    Returns
    -------
    Figure
        The photograph, and 25 × 25 pixels of it.
    """
    fig, (whole, part) = panels(1, 2, (FULL_WIDTH, 3.6), width_ratios=(1.55, 1))
    for ax in (whole, part):
        ax.imshow(photograph, vmin=0, vmax=255)
    corners = detection.points
    _show_order(whole, corners)
    height, width = photograph.shape
    picture_frame(whole, (width, height))
    whole.set_title(f"{len(corners)} corners")
    if len(corners) <= near:
        return fig
    u, v = corners[near]
    whole.plot(u, v, "s", mfc="none", mec=ROLES["ray"], ms=11, mew=2)
    part.plot(u, v, "+", color=ROLES["object"], ms=26, mew=2.5)
    middle = np.rint([u, v])
    part.set(xlim=(middle[0] - 12.5, middle[0] + 12.5), ylim=(middle[1] + 12.5, middle[1] - 12.5))
    part.set(xlabel="u (px)", ylabel="v (px)")
    part.set_title(f"corner {near}: ({u:.2f}, {v:.2f})", fontsize=11)
    return fig


def _show_order(ax: Axes, corners: Floats) -> None:
    """Draw corners with a line through them in their order, and numbers at the first few."""
    ax.plot(*corners.T, "-", color=ROLES["ray"], lw=0.8)
    ax.plot(*corners.T, "o", mfc="none", mec=ROLES["object"], ms=5, mew=1.2)
    paper = {"facecolor": "white", "edgecolor": "none", "pad": 0.6, "alpha": 0.8}
    for number in (0, COLUMNS - 1, COLUMNS, len(corners) - 1):
        if number < len(corners):
            u, v = corners[number]
            side = -1 if number % COLUMNS == 0 else 1
            ax.text(
                u + 22 * side,
                v,
                str(number),
                color=ROLES["object"],
                ha="center",
                va="center",
                fontsize=9,
                bbox=paper,
            )


def opencv_corners(photographs: Sequence[Grey], reach: int) -> list[Floats]:
    """Return the corners that OpenCV's sub-pixel search finds with a window of some size.

    Parameters
    ----------
    photographs : sequence of ndarray
        Pictures of the board `BOARD`, all of it in each.
    reach : int
        How far a window reaches to each side of a corner, px.

    Returns
    -------
    list of ndarray, shape (54, 2)
        Pixels.

    Raises
    ------
    ValueError
        If OpenCV does not see the board in one of them.
    """
    import cv2

    stop, views = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_COUNT, 50, 1e-4), []
    for number, photograph in enumerate(photographs):
        seen, rough = cv2.findChessboardCorners(photograph, (COLUMNS, ROWS))
        if not seen:
            raise ValueError(f"OpenCV sees no board with {BOARD.name} in view {number}")
        fine = cv2.cornerSubPix(photograph, rough, (reach, reach), (-1, -1), stop)
        views.append(np.asarray(fine, dtype=float).reshape(-1, 2))
    return views


@figure("A corner beside the edge of the board: the window reaches the edge, and the search slips.")
def slipped_search(
    photograph: Grey, searched: ArrayLike, fitted: ArrayLike, number: int, reach: int
) -> Figure:
    """Show one corner that a search has lost, with its window.

    Parameters
    ----------
    photograph : ndarray, shape (height, width)
        The picture.
    searched, fitted : array_like, shape (N, 2)
        All corners as the search with the window found them, and as they are.
    number : int
        Which corner.
    reach : int
        How far the window reaches to each side, px.

    Returns
    -------
    Figure
        61 × 61 pixels around the corner.
    """
    (u, v), (x, y) = np.asarray(searched)[number], np.asarray(fitted)[number]
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.6, 4.0))
    ax.imshow(photograph, vmin=0, vmax=255)
    side = reach + 0.5
    window = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]]) * side + np.rint([u, v])
    ax.plot(*window.T, color=ROLES["ray"], lw=2.5)
    ax.plot(x, y, "+", color=ROLES["camera"], ms=20, mew=3)
    ax.plot(u, v, "x", color=ROLES["object"], ms=16, mew=3)
    ax.set(xlim=(x - 30.5, x + 30.5), ylim=(y + 30.5, y - 30.5), xlabel="u (px)", ylabel="v (px)")
    away = np.hypot(u - x, v - y)
    ax.set_title(f"corner {number}: the search (×) ends {away:.1f} px away (+)", fontsize=10.5)
    return fig
