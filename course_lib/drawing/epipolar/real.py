"""Still figures of real pairs: lines through corners, matches, rows, and a wall that is a plane."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.diagrams import Floats, figure, panels, picture_frame
from course_lib.drawing.epipolar.photographs import StereoBoards, wall_homography
from course_lib.drawing.epipolar.street import stroke_of
from course_lib.drawing.style import FULL_WIDTH, ROLES
from course_lib.epipolar import (
    eight_point,
    epipolar_lines,
    essential_from_pose,
    fundamental_from_essential,
    line_distance,
    rectify,
)
from course_lib.homogeneous import apply_homography
from course_lib.tie_points import tie_points

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLOURS = ("camera", "ray", "image", "object", "second")
#: Corners of a board whose lines are drawn.
SHOWN = (0, 22, 31, 44, 53)
#: Corners near the edge of the picture, where the lens bends most.
ENLARGED = (0, 1, 9, 10, 18)
REACH = 45


def board_fundamental(boards: StereoBoards) -> Floats:
    """Return the fundamental matrix of the calibrated stereo camera."""
    c = boards.calibration
    return fundamental_from_essential(essential_from_pose(c.R, c.t), c.K_left, c.K_right)


def _show(ax: Axes, picture: NDArray[np.uint8], title: str) -> None:
    ax.imshow(picture, vmin=0, vmax=255)
    picture_frame(ax, (picture.shape[1], picture.shape[0]))
    ax.set_autoscale_on(False)
    ax.set_title(title, fontsize=11)


@figure(
    "A part of a right photograph of a board, enlarged: five corners, and the lines on which the "
    "left photograph and the calibration put them. As taken the lines pass beside the corners, "
    "without distortion through them."
)
def corner_lines(boards: StereoBoards, view: int = 0) -> Figure:
    """Show epipolar lines of the calibrated pair, with distorted and with straight pixels.

    Parameters
    ----------
    boards : StereoBoards
        Photographs, corners and cameras.
    view : int
        Which pair.

    Returns
    -------
    Figure
        The same part of the right photograph as taken and without distortion.
    """
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.4))
    F, part = board_fundamental(boards), slice(54 * view, 54 * (view + 1))
    straight = [points[part] for points in boards.straight_corners()]
    pictures = boards.right[view], boards.straightened(view)[1]
    lefts, rights = zip(
        (boards.left_corners[view], boards.right_corners[view]), straight, strict=True
    )
    names = "as taken", "without distortion"
    for ax, picture, left, right, name in zip(axes, pictures, lefts, rights, names, strict=True):
        lines = epipolar_lines(left, F)
        _show(ax, picture, f"right, {name}: {line_distance(right, lines).mean():.2f} px off")
        for number, role in zip(ENLARGED, COLOURS, strict=True):
            stroke = stroke_of(lines[number], (640, 480))
            if stroke is not None:
                ax.plot(*stroke.T, color=ROLES[role], lw=2)
            ax.plot(*right[number], "o", mfc="none", mec=ROLES[role], ms=8, mew=2)
        _enlarge(ax, right[list(ENLARGED)])
    return fig


def _enlarge(ax: Axes, points: Floats) -> None:
    """Show only the surroundings of points, twice `REACH` wide and high, px."""
    u, v = (points.min(axis=0) + points.max(axis=0)) / 2
    ax.set(xlim=(u - REACH, u + REACH), ylim=(v + REACH, v - REACH))


@figure(
    "A picture with a stroke from each tie point to where its partner is in the other picture: "
    "green where the pair is right or accepted, red where not."
)
def strokes(
    picture: NDArray[np.uint8],
    points1: ArrayLike,
    points2: ArrayLike,
    fits: ArrayLike,
    title: str = "",
) -> Figure:
    """Show pairs over the first picture.

    Parameters
    ----------
    picture : ndarray, shape (height, width) or (height, width, 3)
        The first picture.
    points1, points2 : array_like, shape (N, 2)
        Pixels of both pictures.
    fits : array_like of bool, shape (N,)
        Which pairs are drawn green.
    title : str
        Above the picture.

    Returns
    -------
    Figure
        The picture with strokes.
    """
    one, other = np.asarray(points1, dtype=float), np.asarray(points2, dtype=float)
    good = np.asarray(fits, dtype=bool)
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.8, 4.5))
    _show(ax, picture, title or f"{good.sum()} of {len(good)} pairs")
    for which, role, width in ((~good, "object", 0.8), (good, "image", 1.1)):
        ends = np.stack([one[which], other[which], np.full_like(one[which], np.nan)], axis=1)
        ax.plot(*ends.reshape(-1, 2).T, color=ROLES[role], lw=width)
        ax.plot(*one[which].T, ".", color=ROLES[role], ms=3)
    return fig


@figure(
    "Left and right photograph side by side with rows drawn across both. As taken, corners of the "
    "same board lie in different rows; rectified, in the same."
)
def rows(boards: StereoBoards, view: int = 0) -> Figure:
    """Show a real pair before and after rectification, with rows across both pictures.

    Parameters
    ----------
    boards : StereoBoards
        Photographs, corners and cameras.
    view : int
        Which pair.

    Returns
    -------
    Figure
        Two rows of two pictures.
    """
    taken = [boards.left_corners[view], boards.right_corners[view]]
    cases = (
        ((boards.left[view], boards.right[view]), taken, "as taken"),
        (*_rectified(boards, view), "rectified"),
    )
    fig, axes = panels(2, 1, (FULL_WIDTH * 0.85, 5.6))
    for ax, (pictures, points, name) in zip(axes, cases, strict=True):
        apart = points[0][:, 1] - points[1][:, 1]
        off = np.sqrt((apart**2).mean())
        _show(ax, np.hstack(pictures), f"{name}: rows of the corners differ by {off:.2f} px")
        for number, role in zip(SHOWN, COLOURS, strict=True):
            ax.axhline(points[0][number, 1], color=ROLES[role], lw=1.2)
            for k in (0, 1):
                at = points[k][number] + (640 * k, 0)
                ax.plot(*at, "o", mfc="none", mec=ROLES[role], ms=7, mew=1.8)
        ax.set(xlabel="u, and u + 640 on the right (px)")
    return fig


def _rectified(boards: StereoBoards, view: int) -> tuple[list[NDArray[np.uint8]], list[Floats]]:
    """Return both photographs of a pair rectified, and their corners."""
    import cv2

    c, part = boards.calibration, slice(54 * view, 54 * (view + 1))
    pair = rectify(c.K_left, c.K_right, c.R, c.t)
    Hs = pair.H1, pair.H2
    pictures = [
        np.asarray(cv2.warpPerspective(picture, H, (640, 480)), np.uint8)
        for picture, H in zip(boards.straightened(view), Hs, strict=True)
    ]
    corners = [
        apply_homography(points[part], H)
        for points, H in zip(boards.straight_corners(), Hs, strict=True)
    ]
    return pictures, corners


def two_halves(
    wall: NDArray[np.uint8], from_side: NDArray[np.uint8]
) -> tuple[Floats, Floats, Floats, Floats]:
    """Return fundamental matrices from two halves of the tie points of a plane.

    Parameters
    ----------
    wall, from_side : ndarray, shape (640, 800, 3)
        The pictures of the painted wall.

    Returns
    -------
    F, G : ndarray, shape (3, 3)
        From one half of the pairs, and from the other.
    points1, points2 : ndarray, shape (N, 2)
        All pairs that the wall's homography explains to 3 px.

    Raises
    ------
    Unavailable
        If the published homography is not here and cannot be downloaded.
    """
    one, other = tie_points(wall, from_side)
    off = np.linalg.norm(apply_homography(one, wall_homography()) - other, axis=1)
    one, other = one[off < 3], other[off < 3]
    half = np.random.default_rng(0).permutation(len(one)) < len(one) // 2
    F, G = (eight_point(one[which], other[which]) for which in (half, ~half))
    return F, G, one, other


@figure(
    "A painted wall with the epipolar lines of the same five points by two fundamental matrices "
    "that fit the same pairs equally well. They have nothing in common but the points."
)
def two_answers(
    picture: NDArray[np.uint8], points1: ArrayLike, points2: ArrayLike, F: ArrayLike, G: ArrayLike
) -> Figure:
    """Show the lines of five points by two matrices.

    Parameters
    ----------
    picture : ndarray, shape (height, width, 3)
        The second picture.
    points1, points2 : array_like, shape (5, 2)
        Five pairs, px.
    F, G : array_like, shape (3, 3)
        Two fundamental matrices.

    Returns
    -------
    Figure
        The second picture with both lines of each point.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.7, 4.4))
    _show(ax, picture, "two answers for the same points")
    size = picture.shape[1], picture.shape[0]
    for matrix, role, name in ((F, "camera", "one half"), (G, "object", "the other half")):
        for n, line in enumerate(epipolar_lines(points1, matrix)):
            stroke = stroke_of(line, size)
            if stroke is not None:
                label = f"F from {name} of the pairs" if n == 0 else None
                ax.plot(*stroke.T, color=ROLES[role], lw=1.8, label=label)
    ax.plot(*np.asarray(points2, dtype=float).T, "o", mfc="white", mec=ROLES["ray"], ms=7, mew=2)
    ax.legend(loc="lower left", fontsize=9, frameon=True)
    return fig
