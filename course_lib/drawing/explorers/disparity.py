"""The disparity explorer: a window of the left picture is looked for along a row of the right."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.explorers.frame import Frame, Handle, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot, disc
from course_lib.drawing.triangulation.pair import BASELINE, OFFSET, SIZE, F, motorcycle
from course_lib.triangulation import depth_from_disparity, depth_uncertainty

Floats = NDArray[np.float64]
RGB = NDArray[np.uint8]

#: Two pictures a row, where there is room: three are too wide.
SHOWN_SIZE, CURVE_SIZE, NEAR_SIZE = (448, 302), (448, 240), (448, 240)
SCALE = SHOWN_SIZE[0] / SIZE[0]
FARTHEST = 70  # px: the largest disparity that is tried
REACH = 12  # px: the widest window reaches so far to each side
#: How far off good matches of a window of 9 px are in these photographs, RMS, px.
SIGMA = 0.35
TILE = 190  # px of a window that is enlarged
TILES, TOP = (20, 238), 32  # where they begin, px
#: Another disparity fits nearly as well if its difference is at most so many times the smallest.
ALIKE = 1.15
#: Where the curve is drawn, px, and heights of its axis, grey levels: the first that holds it.
CURVE_BOX = (44, 436, 44, 184)
HEIGHTS = (5, 10, 20, 30, 50, 75, 100, 150, 200, 300)
#: Pixels of the left picture to which the explorer goes by name; the last name leaves it free.
PLACES = {"rear lamp": (97, 208), "red box": (570, 220), "white door": (260, 70)}
FREE = "anywhere"


class Match(NamedTuple):
    """What the search along a row finds.

    Attributes
    ----------
    differences : ndarray, shape (n,)
        RMS difference of the windows at the disparities 0 … n − 1, grey levels.
    disparity : float
        Where it is smallest, between the whole numbers, px.
    best : int
        The whole number.
    """

    differences: Floats
    disparity: float
    best: int


def disparity_frame(u: float, v: float, reach: float, place: str = FREE) -> Frame:
    """Return where a window of the left picture is found in the right one.

    Parameters
    ----------
    u, v : float
        Its middle in the left picture, px.
    reach : float
        How far it reaches to each side, px.
    place : str
        A key of `PLACES`, which is taken instead of `u` and `v`, or `FREE`.

    Returns
    -------
    Frame
        Both pictures, the difference along the row, the windows enlarged, disparity and depth.
    """
    fixed = PLACES.get(place)
    (column, row), h = fixed or (int(u), int(v)), int(reach)
    found = search(column, row, h)
    truth = float(motorcycle().truth[row, column])
    depth = float(depth_from_disparity(max(found.disparity, 0), F, BASELINE, OFFSET))
    sigma = float(depth_uncertainty(depth, F, BASELINE, SIGMA))
    off = found.disparity - truth
    readouts = (
        Readout("Disparity", "d", f"{found.disparity:.1f}", "px"),
        Readout(
            "True disparity", "", f"{truth:.1f}" if np.isfinite(truth) else "not known", _px(truth)
        ),
        Readout("Depth", "Z", f"{depth:.0f} ± {sigma:.0f}", "mm"),
        Readout("Off by", "", f"{off:+.1f}" if np.isfinite(off) else "not known", _px(off)),
        Readout("Another valley as deep", "", _elsewhere(found)),
    )
    pictures = (
        _left(column, row, h, "" if fixed is None else place),
        _right(column, row, h, found, truth),
        _curve(found, truth),
        _windows(column, row, h, found),
    )
    follows = {} if fixed is None else {"u": column, "v": row}
    return Frame(pictures, readouts, follows=follows)


def _px(number: float) -> str:
    return "px" if np.isfinite(number) else ""


def search(u: int, v: int, reach: int) -> Match:
    """Return how much windows of the right picture's row differ from one of the left picture.

    Parameters
    ----------
    u, v : int
        Middle of the window in the left picture, px.
    reach : int
        How far it reaches to each side, px.

    Returns
    -------
    Match
        For every disparity whose window is inside of the right picture, up to `FARTHEST`.
    """
    left, right = _floats()
    rows, width = slice(v - reach, v + reach + 1), 2 * reach + 1
    window = left[rows, u - reach : u + reach + 1]
    count = min(FARTHEST, u - reach) + 1
    strip = right[rows, u - reach - count + 1 : u + reach + 1]
    others = np.lib.stride_tricks.sliding_window_view(strip, width, axis=1)  # (w, n, 3, w)
    squares = (others - window.transpose(0, 2, 1)[:, None]) ** 2
    means = squares.mean(axis=(0, 2, 3))[::-1].astype(float)
    best = int(np.argmin(means))
    return Match(np.sqrt(means), best + _between(means, best), best)


def _between(means: Floats, best: int) -> float:
    """Return where a parabola through the smallest number and its neighbours has its lowest point.

    With neighbours a, c and the smallest b it is ``(a − c) / (2 (a − 2b + c))`` away from it.
    """
    if not 0 < best < len(means) - 1:
        return 0.0
    a, b, c = means[best - 1 : best + 2].tolist()
    return (a - c) / (2 * (a - 2 * b + c)) if a - 2 * b + c > 0 else 0.0


def _elsewhere(found: Match) -> str:
    """Return the disparities that fit nearly as well, at least 3 px away, as text."""
    d = found.differences
    inner = np.r_[False, (d[1:-1] <= d[:-2]) & (d[1:-1] <= d[2:]), False]
    rivals = np.flatnonzero(inner & (d <= ALIKE * d[found.best]))
    rivals = rivals[np.abs(rivals - found.best) > 2]
    return ", ".join(str(n) for n in rivals[:4]) + " px" if len(rivals) else "nowhere"


@cache
def _floats() -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    pair = motorcycle()
    return pair.left.astype(np.float32), pair.right.astype(np.float32)


@cache
def _small() -> tuple[RGB, RGB]:
    """Return both pictures at the size at which they are shown."""
    import cv2

    pair = motorcycle()
    size = SHOWN_SIZE
    left, right = (
        cv2.resize(p, size, interpolation=cv2.INTER_AREA) for p in (pair.left, pair.right)
    )
    return np.asarray(left, np.uint8), np.asarray(right, np.uint8)


def _shown(u: float, v: float) -> tuple[float, float]:
    """Return where a pixel is in the small picture."""
    return SCALE * (u + 0.5) - 0.5, SCALE * (v + 0.5) - 0.5


def _box(u: float, v: float, reach: int) -> Floats:
    around = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * (SCALE * (reach + 0.5))
    return np.asarray(np.array(_shown(u, v)) + around)


def _left(u: int, v: int, h: int, place: str) -> Picture:
    # A pixel p of the small picture is u = (p + 0.5) / SCALE - 0.5 in the photograph.
    shift = 0.5 / SCALE - 0.5
    moves = (("u", shift, 1 / SCALE, 0.0), ("v", shift, 0.0, 1 / SCALE))
    return Picture(
        f"Left: {place or 'drag the spot'}",
        f"The left photograph of a motorcycle, with a window of {2 * h + 1} pixels around the "
        f"pixel ({u}, {v}).",
        SHOWN_SIZE,
        _small()[0],
        lines=(
            Line([_shown(0, v), _shown(SIZE[0] - 1, v)], "guide", 1.2, dashed=True),
            Line(_box(u, v, h), "object", 2.0, closed=True),
        ),
        handles=() if place else (Handle(_shown(u, v), moves),),
    )


def _right(u: int, v: int, h: int, found: Match, truth: float) -> Picture:
    last = u - (len(found.differences) - 1)
    lines = [
        Line([_shown(last, v), _shown(u, v)], "guide", 1.5),
        Line(_box(u - found.disparity, v, h), "camera", 2.0, closed=True),
    ]
    if np.isfinite(truth):
        lines.append(Line(disc(_shown(u - truth, v), 5), "image", 2.0, closed=True))
    return Picture(
        "Right: the same row",
        f"The right photograph. The window fits best {found.disparity:.1f} pixels further left, "
        f"at column {u - found.disparity:.1f}.",
        SHOWN_SIZE,
        _small()[1],
        lines=tuple(lines),
        labels=(Label("ring: truth", (6, 290), "image"),),
    )


def curve_axes(found: Match) -> Plot:
    """Return axes that hold the curve of a match, and not much more."""
    most = float(found.differences.max())
    top = next(height for height in HEIGHTS if height >= most)
    return Plot(CURVE_BOX, (0, FARTHEST), (0, top))


def _curve(found: Match, truth: float) -> Picture:
    """Return the difference of the windows against the disparity."""
    d = np.arange(len(found.differences))
    axes = curve_axes(found)
    lines = [axes.frame(), Line(axes.pixels(d, found.differences), "ink", 1.8)]
    least = float(found.differences[found.best])
    at = float(np.clip(found.disparity, 0, FARTHEST))
    lines.append(Line(disc(axes.pixels(at, least)[0], 5), "camera", 2.5, closed=True))
    if np.isfinite(truth) and 0 <= truth <= FARTHEST:
        lines.append(Line(axes.pixels(truth, axes.y), "image", 1.5, dashed=True))
    return Picture(
        "Difference",
        f"The difference of the windows along the row. It is smallest, {least:.1f} grey levels, at "
        f"a disparity of {found.disparity:.1f} pixels; another as deep: {_elsewhere(found)}.",
        CURVE_SIZE,
        lines=tuple(lines),
        labels=(
            *axes.ticks((0, 10, 20, 30, 40, 50, 60, 70), (0, axes.y[1] / 2, axes.y[1])),
            Label("disparity (px); dashed: truth", (240, 228), anchor="middle"),
            Label("difference in grey levels (RMS)", (10, 12)),
        ),
    )


def _windows(u: int, v: int, h: int, found: Match) -> Picture:
    """Return both windows enlarged, side by side."""
    import cv2

    pair, canvas = motorcycle(), np.full((*NEAR_SIZE[::-1], 3), 255, np.uint8)
    for picture, column, left in ((pair.left, u, TILES[0]), (pair.right, u - found.best, TILES[1])):
        part = picture[v - h : v + h + 1, column - h : column + h + 1]
        tile = cv2.resize(part, (TILE, TILE), interpolation=cv2.INTER_NEAREST)
        canvas[TOP : TOP + TILE, left : left + TILE] = tile
    return Picture(
        "Enlarged",
        f"The window of the left picture and the one that fits best in the right picture: "
        f"{2 * h + 1} pixels wide, {found.differences[found.best]:.1f} grey levels apart.",
        NEAR_SIZE,
        canvas,
        labels=(
            Label("left", (TILES[0] + TILE / 2, 16), "object", "middle"),
            Label("right", (TILES[1] + TILE / 2, 16), "camera", "middle"),
        ),
    )
