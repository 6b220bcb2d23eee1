"""Dense stereo: OpenCV's matcher on the motorcycle's pair, and how far it is right."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera
from course_lib.drawing.diagrams import Floats, figure, panels
from course_lib.drawing.space import onlooker
from course_lib.drawing.style import BLACK, FULL_WIDTH, ROLES
from course_lib.drawing.triangulation.pair import BASELINE, K_LEFT, OFFSET, F, motorcycle
from course_lib.triangulation import depth_from_disparity

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: The matcher: how far it searches and how wide its windows are, px.
SEARCH, WINDOW = 64, 5
BAD = 2.0  # px
#: From the frame of the camera, y down, to the world of an onlooker, z up.
UPRIGHT = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
VIEW_SIZE = (520, 400)
#: A place of the floor that the motorcycle hides from both cameras, mm, z up.
HIDDEN = (-200.0, 3100.0, -310.0)


def match_pair(left: NDArray[np.uint8], right: NDArray[np.uint8]) -> Floats:
    """Return the disparity that OpenCV's semi-global matcher finds for each pixel of the left.

    Parameters
    ----------
    left, right : ndarray, shape (height, width, 3), uint8
        A rectified pair, RGB.

    Returns
    -------
    ndarray, shape (height, width)
        Disparity, px; NaN where it found none that it trusts.
    """
    import cv2

    area = 3 * WINDOW**2
    matcher = cv2.StereoSGBM_create(  # type: ignore[attr-defined]
        minDisparity=0,
        numDisparities=SEARCH,
        blockSize=WINDOW,
        P1=8 * area,
        P2=32 * area,
        disp12MaxDiff=1,
        uniquenessRatio=10,
        speckleWindowSize=100,
        speckleRange=2,
        preFilterCap=31,
    )
    sixteenths = matcher.compute(left, right)
    return np.where(sixteenths < 0, np.nan, sixteenths / 16.0)


@cache
def dense_disparity() -> Floats:
    """Return the matcher's disparity of the motorcycle's left picture, (500, 741), px."""
    pair = motorcycle()
    return match_pair(pair.left, pair.right)


def depths(disparity: Floats) -> Floats:
    """Return depths of the motorcycle's pair, mm; NaN where there is no disparity."""
    known = np.isfinite(disparity)
    Z = np.full(disparity.shape, np.nan)
    Z[known] = depth_from_disparity(disparity[known], F, BASELINE, OFFSET)
    return Z


def judged() -> dict[str, float]:
    """Return how the matcher did, where the truth is known.

    Returns
    -------
    dict of str to float
        Shares of the pixels with truth: ``found``; of those found: ``bad`` (> 2 px off) and
        ``good`` (at most 0.5 px); the median absolute error ``median`` in px.
    """
    truth, found = motorcycle().truth, dense_disparity()
    known = np.isfinite(truth)
    both = known & np.isfinite(found)
    off = np.abs(found - truth)[both]
    return {
        "found": float(both.sum() / known.sum()),
        "bad": float((off > BAD).mean()),
        "good": float((off <= 0.5).mean()),
        "median": float(np.median(off)),
    }


def kinds() -> dict[str, NDArray[np.bool_]]:
    """Return which pixels, of those with a known truth and where the matcher searches, are what.

    Returns
    -------
    dict of str to ndarray of bool, shape (500, 741)
        ``edges``: the depth jumps within 5 px, by more than 4 px of disparity. ``plain``: no edge,
        and grey values differ by less than 2 levels (standard deviation over 9 px). ``textured``:
        no edge, and by more than 8.
    """
    import cv2

    pair = motorcycle()
    known = np.isfinite(pair.truth)
    square = np.ones((11, 11), np.uint8)
    most = cv2.dilate(np.where(known, pair.truth, -1).astype(np.float32), square)
    least = cv2.erode(np.where(known, pair.truth, 999).astype(np.float32), square)
    edges = np.asarray(most - least > 4)
    grey = pair.left.mean(axis=2)
    spread = cv2.boxFilter(grey**2, -1, (9, 9)) - cv2.boxFilter(grey, -1, (9, 9)) ** 2
    known &= np.arange(known.shape[1]) >= SEARCH
    plain, textured = spread < 2**2, spread > 8**2
    return {
        "edges": known & edges,
        "plain": known & ~edges & plain,
        "textured": known & ~edges & textured,
    }


def block_matching(reach: int) -> Floats:
    """Return the disparity of the most similar window in the same row, (500, 741), px.

    Parameters
    ----------
    reach : int
        How far a window reaches to each side, px.

    Returns
    -------
    ndarray, shape (500, 741)
        Whole pixels from 0 to 63, whatever lies beside.
    """
    import cv2

    pair = motorcycle()
    left, right = pair.left.astype(np.float32), pair.right.astype(np.float32)
    width = left.shape[1]
    cost = np.full((SEARCH, *left.shape[:2]), np.inf, np.float32)
    for d in range(SEARCH):
        apart = ((left[:, d:] - right[:, : width - d]) ** 2).mean(axis=2)
        cost[d, :, d:] = cv2.boxFilter(apart, -1, (2 * reach + 1, 2 * reach + 1))
    return np.asarray(cost.argmin(axis=0), np.float64)


def wrong_shares(disparity: Floats) -> dict[str, float]:
    """Return which part of each of `kinds` is more than 2 px off or has no answer."""
    right = np.abs(disparity - motorcycle().truth) <= BAD
    return {name: float((~right[pixels]).mean()) for name, pixels in kinds().items()}


@figure("Depth of every pixel in colours, as measured by other means and as the matcher finds it.")
def dense_result() -> Figure:
    """Show the true depth and the matcher's, in metres.

    Returns
    -------
    Figure
        Two pictures in colours; white where nothing is known or found.
    """
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.0))
    pictures = {"true depth": motorcycle().truth, "found by the program": dense_disparity()}
    for ax, (name, disparity) in zip(axes, pictures.items(), strict=True):
        shown = ax.imshow(depths(disparity) / 1000, cmap="viridis_r", vmin=2, vmax=5.2)
        ax.set_title(name)
        ax.set(xticks=[], yticks=[])
        ax.spines[:].set_visible(True)
    fig.colorbar(shown, ax=axes, label="depth (m)", shrink=0.8)
    return fig


@figure("Where the matcher is wrong: at edges, in thin and in plain parts; and a narrow histogram.")
def dense_errors() -> Figure:
    """Show where the matcher is more than 2 px off or silent, and a histogram of its errors.

    Returns
    -------
    Figure
        The photograph in grey with coloured pixels; the histogram.
    """
    pair, found = motorcycle(), dense_disparity()
    off = found - pair.truth
    fig, (ax, bars) = panels(1, 2, (FULL_WIDTH, 3.2), width_ratios=(1.75, 1))
    grey = 0.5 * pair.left.mean(axis=2, keepdims=True).repeat(3, axis=2) / 255 + 0.5
    grey[np.isnan(found)] = _rgb("camera")
    grey[np.abs(off) > BAD] = _rgb("object")
    ax.imshow(grey)
    ax.set(xticks=[], yticks=[], title="red: over 2 px off, blue: no answer")
    bars.hist(off[np.isfinite(off)], np.arange(-4, 4.01, 0.125), color=ROLES["image"], lw=0)
    bars.axvspan(-BAD, BAD, color=ROLES["guide"], alpha=0.12, lw=0)
    bars.set(xlabel="error of the disparity (px)", yticks=[], xlim=(-4, 4), title="errors")
    bars.spines["left"].set_visible(False)
    return fig


def _rgb(role: str) -> tuple[float, float, float]:
    from matplotlib.colors import to_rgb

    return to_rgb(ROLES[role])


@figure("The points of the matcher in their colours, seen from the left side and from above.")
def point_cloud() -> Figure:
    """Show the matcher's points in the colours of the photograph from two other places.

    Returns
    -------
    Figure
        Two views by the course's camera.
    """
    points, colours = cloud_points()
    views = {
        "from the side": onlooker((-1900, 700, 250), (250, 2500, -40), 600, VIEW_SIZE),
        "from above": onlooker((100, 1700, 3000), (100, 2750, 0), 480, VIEW_SIZE),
    }
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.3))
    for ax, (name, view) in zip(axes, views.items(), strict=True):
        ax.imshow(splat(points, colours, view))
        ax.set(xticks=[], yticks=[], title=name)
        ax.spines[:].set_visible(False)
        _hole(ax, view, -38 if ax is axes[0] else 22)
    return fig


def _hole(ax: Axes, view: Camera, right: float) -> None:
    """Point at the floor that the motorcycle hides; the words stand so far to the right of it."""
    u, v = view.project(HIDDEN)
    ax.annotate(
        "no floor\nhere",
        (u, v),
        (u + right, v - 40),
        ha="center",
        arrowprops={"arrowstyle": "-|>", "color": BLACK, "lw": 1.5},
    )


@cache
def cloud_points() -> tuple[Floats, NDArray[np.uint8]]:
    """Return the matcher's points up to 4 m away, (N, 3), mm, z up, and their colours."""
    Z = depths(dense_disparity())
    v, u = np.nonzero(np.nan_to_num(Z, nan=np.inf) < 4000)
    rays = np.column_stack([u, v, np.ones(len(u))]) @ np.linalg.inv(K_LEFT).T
    return rays * Z[v, u][:, None] @ UPRIGHT.T, motorcycle().left[v, u]


def splat(points: Floats, colours: NDArray[np.uint8], view: Camera) -> NDArray[np.uint8]:
    """Return the picture of coloured points, each 2 px wide, the nearest in front.

    Parameters
    ----------
    points : ndarray, shape (N, 3)
        World points.
    colours : ndarray, shape (N, 3), uint8
        RGB.
    view : Camera
        The camera that looks at them.

    Returns
    -------
    ndarray, shape (height, width, 3), uint8
        White where there is no point.
    """
    width, height = view.image_size
    picture = np.full((height, width, 3), 255, np.uint8)
    far_first = np.argsort(-(points @ view.R[2] + view.t[2]))
    pixels, shown = view.project(points[far_first]), colours[far_first]
    for du in (0, 1):
        for dv in (0, 1):
            at: Any = np.floor(np.add(pixels, (du, dv)))
            inside = (at >= 0).all(axis=1) & (at < (width, height)).all(axis=1)
            u, v = at[inside].astype(int).T
            picture[v, u] = shown[inside]
    return picture
