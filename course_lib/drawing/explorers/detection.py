"""The detection viewer: where a search finds a corner whose true place is known."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib.boards import Checkerboard
from course_lib.detection.corner_fit import fit_corners
from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import disc
from course_lib.homogeneous import apply_homography

Floats = NDArray[np.float64]

BOARD = Checkerboard(9, 6, 1.0)
SIZE = (256, 192)  # px of the picture
SHOWN_SIZE, NEAR_SIZE = (384, 288), (310, 310)
#: From the board, in squares, to px; the far squares are small.
H = np.array([[37.0, -2.0, 40.0], [6.0, 27.6, 36.0], [0.115, 0.012, 1.0]])
RAYS = 8  # a pixel, along each axis
DARK, LIGHT = 40.0, 210.0
NEAR = 31  # px that are enlarged
TIMES = NEAR_SIZE[0] / NEAR
LEGEND = (
    Label("ring: truth", (6, 12), "image"),
    Label("window search", (6, 28), "object"),
    Label("fit", (6, 44), "camera"),
)
START = (0.7, -0.6)  # px: how far off the places are where both searches begin


def detection_frame(corner: float, reach: float, blur: float, noise: float) -> Frame:
    """Return where two searches find the corners of a computed picture.

    Parameters
    ----------
    corner : float
        Number of the corner that is enlarged, 0 to 53.
    reach : float
        How far the window of OpenCV's search reaches to each side, px.
    blur : float
        Standard deviation of the blur, px.
    noise : float
        Standard deviation of the noise, grey levels.

    Returns
    -------
    Frame
        The picture, the corner enlarged, and the errors of both searches.
    """
    picture = photograph(float(blur), float(noise))
    truth, number = true_corners(), int(corner)
    searched = searched_corners(picture, int(reach))
    fitted = fitted_corner(picture, number)
    off = np.linalg.norm(searched - truth, axis=1)
    readouts = (
        Readout("Next edge", "", f"{next_edge(number):.1f}", "px away"),
        Readout("Error of the window search", "", f"{off[number]:.3f}", "px"),
        Readout("Error of the fit", "", f"{np.linalg.norm(fitted - truth[number]):.3f}", "px"),
        Readout("Window search, all 54, RMS", "", f"{_rms(off):.3f}", "px"),
    )
    near = _near(picture, number, int(reach), truth[number], searched[number], fitted)
    return Frame((_whole(picture, number, int(reach)), near), readouts)


def _rms(lengths: Floats) -> float:
    return float(np.sqrt((lengths**2).mean()))


@cache
def true_corners() -> Floats:
    """Return where the corners are, (54, 2), px."""
    return np.asarray(apply_homography(BOARD.points()[:, :2], H))


@cache
def next_edge(number: int) -> float:
    """Return how far a window must reach from a corner to touch an edge that is not its own, px.

    The window is upright, so the larger of the distances along u and v counts.
    """
    x, y = BOARD.points()[number, :2]
    lines = np.array([[1, 0, 1 - x], [1, 0, -1 - x], [0, 1, 1 - y], [0, 1, -1 - y]])
    a, b, c = (lines @ np.linalg.inv(H)).T  # a line l of the board is H⁻ᵀ l in the picture
    u, v = true_corners()[number]
    return float((np.abs(a * u + b * v + c) / (np.abs(a) + np.abs(b))).min())


@cache
def _sharp() -> Floats:
    """Return the picture without blur and noise: each pixel the mean of many rays."""
    width, height = SIZE
    offsets = (np.arange(RAYS) + 0.5) / RAYS - 0.5
    u = (np.arange(width)[:, None] + offsets).ravel()
    v = (np.arange(height)[:, None] + offsets).ravel()
    across, down = np.meshgrid(u, v)
    rays = np.column_stack([across.ravel(), down.ravel()])
    x, y = apply_homography(rays, np.linalg.inv(H)).T
    dark = (np.floor(x) + np.floor(y)) % 2 == 0
    board = (x > -1) & (x < BOARD.columns) & (y > -1) & (y < BOARD.rows)
    levels = np.where(board & dark, DARK, LIGHT).reshape(height, RAYS, width, RAYS)
    return np.asarray(levels.mean(axis=(1, 3)))


@cache
def _noise() -> Floats:
    return np.random.default_rng(4).standard_normal((SIZE[1], SIZE[0]))


def photograph(blur: float, noise: float) -> NDArray[np.uint8]:
    """Return the picture with a blur (px) and a noise (grey levels), as `uint8`."""
    import cv2

    levels = cv2.GaussianBlur(_sharp(), (0, 0), blur) if blur > 0 else _sharp()
    return np.asarray(np.clip(np.rint(levels + noise * _noise()), 0, 255), np.uint8)


def searched_corners(picture: NDArray[np.uint8], reach: int) -> Floats:
    """Return the corners that OpenCV's search finds with a window.

    Parameters
    ----------
    picture : ndarray, shape (192, 256), uint8
        The picture.
    reach : int
        How far the window reaches to each side, px.

    Returns
    -------
    ndarray, shape (54, 2)
        Pixels. The search begins `START` off the true places.
    """
    import cv2

    rough = (true_corners() + START).astype(np.float32).reshape(-1, 1, 2)
    stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_COUNT, 50, 1e-4)
    searched = cv2.cornerSubPix(picture, rough, (reach, reach), (-1, -1), stop)
    return np.asarray(searched, float).reshape(-1, 2)


def fitted_corner(picture: NDArray[np.uint8], number: int) -> Floats:
    """Return one corner as the course's fit finds it, shape (2,), px."""
    truth = true_corners()
    nearest = np.argsort(np.linalg.norm(truth - truth[number], axis=1))[:2]  # itself, and the next
    return np.asarray(fit_corners(picture, truth[nearest] + START).points[0])


def _enlarged(grey: NDArray[np.uint8], size: tuple[int, int]) -> NDArray[np.uint8]:
    """Return a grey picture as RGB of a larger size, its pixels as squares."""
    import cv2

    larger = cv2.resize(grey, size, interpolation=cv2.INTER_NEAREST)
    return np.repeat(np.asarray(larger, np.uint8)[..., None], 3, axis=2)


def _box(middle: Floats, reach: float, times: float) -> Floats:
    """Return the outline of a window, in px of a picture that is enlarged."""
    around = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * (reach + 0.5)
    return np.asarray(times * (middle + around + 0.5) - 0.5)


def _whole(picture: NDArray[np.uint8], number: int, reach: int) -> Picture:
    """Return the whole picture, with the window around the chosen corner."""
    times = SHOWN_SIZE[0] / SIZE[0]
    truth = true_corners()[number]
    return Picture(
        "The picture",
        f"A computed picture of a board. The window around corner {number} is "
        f"{2 * reach + 1} pixels wide; the next edge is {next_edge(number):.1f} px away.",
        SHOWN_SIZE,
        _enlarged(picture, SHOWN_SIZE),
        lines=(Line(_box(np.rint(truth), reach, times), "ray", 2.0, closed=True),),
    )


def _near(
    picture: NDArray[np.uint8],
    number: int,
    reach: int,
    truth: Floats,
    searched: Floats,
    fitted: Floats,
) -> Picture:
    """Return the chosen corner enlarged, with the window and what was found."""
    middle = np.clip(np.rint(truth).astype(int), NEAR // 2, np.array(SIZE) - 1 - NEAR // 2)
    left, top = middle - NEAR // 2
    part = picture[top : top + NEAR, left : left + NEAR]

    def at(place: Floats) -> Floats:
        return np.asarray(TIMES * (place - (left, top) + 0.5) - 0.5)

    lines = (
        Line(_box(np.rint(truth) - (left, top), reach, TIMES), "ray", 2.0, closed=True),
        Line(disc(at(truth), 9), "image", 2.5, closed=True),
        Line(_cross(at(searched), 10), "object", 2.5),
        Line(_cross(at(fitted), 6), "camera", 2.5),
    )
    off = np.linalg.norm(searched - truth), np.linalg.norm(fitted - truth)
    return Picture(
        f"Corner {number}, enlarged",
        f"Corner {number}: the search in the window is {off[0]:.3f} px off, the fit {off[1]:.3f}.",
        NEAR_SIZE,
        _enlarged(part, NEAR_SIZE),
        lines=lines,
        labels=LEGEND,
    )


def _cross(at: Floats, size: float) -> Floats:
    u, v = at
    gap = [np.nan, np.nan]
    return np.array([[u - size, v], [u + size, v], gap, [u, v - size], [u, v + size]])
