"""Still figures of the street: where a partner may be, lines of a student, and going forward."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.diagrams import (
    Floats,
    figure,
    in_figures,
    panels,
    picture_frame,
    same_shape,
    write,
)
from course_lib.drawing.explorers.pairs import (
    AHEAD,
    TOWARDS,
    cameras,
    lamp,
    photographs,
    true_pairs,
)
from course_lib.drawing.explorers.trails import Trail
from course_lib.drawing.style import FULL_WIDTH, ROLES
from course_lib.epipolar import epipole, fundamental_from_cameras
from course_lib.epipolar.fundamental import pair_rows
from course_lib.homography import normalise_points

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

WIDTH = 480
PAPER = {"facecolor": "white", "edgecolor": "none", "pad": 1.0, "alpha": 0.85}
DEPTHS = (9.0, 12.0, 16.0, 28.0)
COLOURS = ("camera", "ray", "image", "object", "second")
#: Five of the pairs that both cameras see, spread over the picture.
CHOSEN = 5
#: A line of a student that is no line, or has no direction, is not drawn.
NO_NORMAL = 1e-9


def street_cameras() -> tuple[Floats, Floats]:
    """Return the camera matrices P1 and P2 of the two pictures of the street."""
    one, other = cameras(TOWARDS, WIDTH)
    return one.P, other.P


def street_points() -> tuple[Floats, Floats]:
    """Return five points of the left picture, and where the right one shows them, px."""
    one, other, _ = true_pairs(TOWARDS, WIDTH)
    order = np.argsort(one[:, 1])
    shown = order[np.linspace(6, len(order) - 3, CHOSEN).astype(int)]
    return one[shown], other[shown]


def _both(which: str) -> tuple[Figure, NDArray[np.object_]]:
    """Return a figure with both pictures of an arrangement."""
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.3))
    for ax, picture, title in zip(axes, photographs(which, WIDTH), ("left", "right"), strict=True):
        ax.imshow(picture)
        picture_frame(ax, (WIDTH, 3 * WIDTH // 4))
        ax.set_autoscale_on(False)
        ax.set_title(title, fontsize=11)
    return fig, axes


@figure(
    "Two pictures of a street. In the left one a ring marks a lamp; in the right one four spots "
    "show where it would be if it were 9 to 28 m away. They lie on a line."
)
def candidates() -> Figure:
    """Show a lamp in the left picture, and where the right one may show it.

    Returns
    -------
    Figure
        Both pictures; on the right a spot for each of some depths.
    """
    fig, (left, right) = _both(TOWARDS)
    at, _ = lamp(TOWARDS, WIDTH)
    left.plot(*at, "o", mfc="none", mec=ROLES["object"], ms=13, mew=2.5)
    spots = Trail.between(*cameras(TOWARDS, WIDTH), 1, 1.0, DEPTHS).spots(at)
    right.plot(*spots.T, "o", color=ROLES["object"], ms=6, mec="white")
    for depth, (u, v) in zip(DEPTHS, spots, strict=True):
        write(right, (u, v + 24), f"{depth:g} m", bbox=PAPER, fontsize=8)
    return fig


def stroke_of(line: Floats, size: tuple[int, int]) -> Floats | None:
    """Return where a line ``(a, b, c)`` crosses a picture, (2, 2), px; None where it does not."""
    a, b, c = line
    if not np.isfinite(line).all() or np.hypot(a, b) <= NO_NORMAL * np.abs(line).max():
        return None
    w, h = np.array(size) - 0.5
    ends = []
    if abs(b) > NO_NORMAL * abs(a):
        ends += [(u, -(a * u + c) / b) for u in (-0.5, w)]
    if abs(a) > NO_NORMAL * abs(b):
        ends += [(-(b * v + c) / a, v) for v in (-0.5, h)]
    inside = [p for p in ends if -0.6 <= p[0] <= w + 0.1 and -0.6 <= p[1] <= h + 0.1]
    return np.array([inside[0], inside[-1]]) if len(inside) >= 2 else None


@figure(
    "Two pictures of a street: five numbered points on the left, and on the right where they "
    "really are, with the lines on which they should be."
)
def lines_of_points(lines: ArrayLike | None) -> Figure:
    """Show five points, and the lines that a student's function gives for them.

    Parameters
    ----------
    lines : array_like, shape (5, 3), or None
        A line of the right picture for each of the `street_points`.

    Returns
    -------
    Figure
        Both pictures, points and lines in five colours.
    """
    fig, (left, right) = _both(TOWARDS)
    one, other = street_points()
    yours = same_shape(lines, np.zeros((CHOSEN, 3)))
    missing = 0
    for n, role in enumerate(COLOURS):
        _numbered(left, one[n], n + 1, role)
        stroke = None if yours is None else stroke_of(yours[n], (WIDTH, 3 * WIDTH // 4))
        missing += stroke is None
        if stroke is not None:
            right.plot(*stroke.T, color="white", lw=4, alpha=0.6)
            right.plot(*stroke.T, color=ROLES[role], lw=2)
        _numbered(right, other[n], n + 1, role)
    if missing:
        words = "no answer yet" if yours is None else f"{missing} of 5 lines miss the picture"
        write(right, (WIDTH / 2, 14), words, bbox=PAPER, fontsize=10)
    return fig


def _numbered(ax: Axes, at: Floats, number: int, role: str) -> None:
    """Mark a point with a ring and its number."""
    ax.plot(*at, "o", mfc="white", mec=ROLES[role], ms=7, mew=2)
    u, v = at
    write(ax, (u + 11, v - 11), str(number), bbox=PAPER, fontsize=9)


@figure(
    "Two pictures from a car that drives down a street. Arrows lead from where points were to "
    "where they are now: all of them away from the epipole in the middle."
)
def forward(e: ArrayLike | None) -> Figure:
    """Show what happens to points when the camera goes forward, and a student's epipole.

    Parameters
    ----------
    e : array_like, shape (2,), or None
        The epipole of the first picture, px.

    Returns
    -------
    Figure
        The first picture with the ways of points; the second with the points.
    """
    fig, (first, second) = _both(AHEAD)
    for ax, title in ((first, "first, and where points go"), (second, "second, 4 m ahead")):
        ax.set_title(title, fontsize=11)
    one, other, _ = true_pairs(AHEAD, WIDTH)
    for start, end in zip(one[:40], other[:40], strict=True):
        look = {
            "arrowstyle": "-|>",
            "color": ROLES["camera"],
            "lw": 1.5,
            "shrinkA": 0,
            "shrinkB": 0,
        }
        first.annotate("", xy=tuple(end), xytext=tuple(start), arrowprops=look)
    second.plot(*other[:40].T, "o", color=ROLES["camera"], ms=4, mec="white", mew=0.6)
    _mark_epipole(first, same_shape(e, np.zeros(2)))
    return fig


def _mark_epipole(ax: Axes, e: Floats | None) -> None:
    """Mark a student's epipole, or say why there is none to be seen."""
    size = np.array([WIDTH, 3 * WIDTH // 4])
    if e is not None and ((e >= 0) & (e <= size)).all():
        ax.plot(*e, "*", color=ROLES["object"], ms=17, mec="white")
        write(ax, e + np.array([0, 26]), "epipole", "object", bbox=PAPER, fontsize=10)
        return
    words = "no epipole yet"
    if e is not None and np.isfinite(e).all():
        u, v = (in_figures(place, 0) for place in e)
        words = f"your epipole is outside: ({u}, {v}) px"
    write(ax, size * (0.5, 0.94), words, bbox=PAPER, fontsize=10)


def forward_fundamental() -> Floats:
    """Return the fundamental matrix of the two pictures from the car."""
    return fundamental_from_cameras(*(camera.P for camera in cameras(AHEAD, WIDTH)))


def eight_pairs(sigma: float = 0.5) -> tuple[Floats, Floats]:
    """Return eight pairs of the two pictures from the car, each coordinate with an error, px."""
    one, other, _ = true_pairs(AHEAD, WIDTH)
    rng = np.random.default_rng(5)
    points1, points2 = (p[:64:8] + sigma * rng.normal(size=(8, 2)) for p in (one, other))
    return points1, points2


def of_rank_three(points1: ArrayLike, points2: ArrayLike) -> Floats:
    """Return what the equations of eight or more pairs give, before the rank is made 2.

    Parameters
    ----------
    points1, points2 : array_like, shape (N, 2)
        N ≥ 8 pixels of picture 1, and their partners in picture 2.

    Returns
    -------
    ndarray, shape (3, 3)
        The matrix for pixels, of rank 3 if the pixels have errors.
    """
    (near1, T1), (near2, T2) = normalise_points(points1), normalise_points(points2)
    raw = np.linalg.svd(pair_rows(near1, near2))[2][-1].reshape(3, 3)
    return np.asarray(T2.T @ raw @ T1)


@figure(
    "Epipolar lines around the epipole, 6 × 4 px of it. Left: of a matrix of rank 3 they miss "
    "each other. Right: of rank 2 they meet in one point."
)
def rank(raw: ArrayLike, mended: ArrayLike) -> Figure:
    """Show the lines of two fundamental matrices near their epipole.

    Parameters
    ----------
    raw, mended : array_like, shape (3, 3)
        Fundamental matrices of the pictures from the car, of rank 3 and of rank 2.

    Returns
    -------
    Figure
        The same points' lines in the second picture, for both.
    """
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.4))
    one = true_pairs(AHEAD, WIDTH)[0][:24]
    middle = epipole(np.asarray(mended, dtype=float).T)
    names = ("rank 3: no common point (6 × 4 px)", "rank 2: one epipole (6 × 4 px)")
    for ax, F, title in zip(axes, (raw, mended), names, strict=True):
        for u, v in one:
            a, b, c = np.asarray(F, dtype=float) @ (u, v, 1)
            normal = np.array([a, b]) / np.hypot(a, b)
            foot = middle - (normal @ middle + c / np.hypot(a, b)) * normal
            way = 400 * np.array([-normal[1], normal[0]])
            ax.plot(*np.stack([foot - way, foot + way]).T, color=ROLES["ray"], lw=1.2)
        reach = 3.0
        ax.set(xlim=(middle[0] - reach, middle[0] + reach))
        ax.set(ylim=(middle[1] + 0.7 * reach, middle[1] - 0.7 * reach), aspect="equal")
        ax.set(xlabel="u (px)", ylabel="v (px)")
        ax.set_title(title, fontsize=11)
    return fig
