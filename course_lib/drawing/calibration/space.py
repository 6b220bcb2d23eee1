"""Still figures in space: where the board was, its vanishing points, and a camera as rays."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.calibration.photographs import BOARD, SIZE
from course_lib.drawing.diagrams import (
    Floats,
    figure,
    panels,
    write,
)
from course_lib.drawing.style import FULL_WIDTH, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Pose = tuple[ArrayLike, ArrayLike]


def board_outline() -> Floats:
    """Return the corners of the board of the photographs with its border, shape (4, 3), mm."""
    s, last = BOARD.square, BOARD.points()[-1]
    x, y = (-s, last[0] + s), (-s, last[1] + s)
    return np.array([[x[0], y[0], 0], [x[1], y[0], 0], [x[1], y[1], 0], [x[0], y[1], 0]])


#: The views whose boards are drawn: near and far, left and right, tilted in several ways.
SHOWN = (4, 5, 6, 9)


@figure("The camera and the board in four of its poses before it, seen from above, in cm.")
def board_poses(K: ArrayLike, poses: Sequence[Pose | None]) -> Figure:
    """Show where the board was in some of the views, in the camera's frame.

    Parameters
    ----------
    K : array_like, shape (3, 3)
        Intrinsics, px.
    poses : sequence of (R, t) or None
        Board to camera, mm, in the order of the views; those of `SHOWN` are drawn.

    Returns
    -------
    Figure
        Camera and boards from above, numbered, their upper edges thick.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.8, 4.4))
    K = np.asarray(K, dtype=float)
    sides = (np.array([0, SIZE[0]]) - K[0, 2]) / K[0, 0]
    for side in sides:
        ax.plot([0, 60 * side], [0, 60], color=ROLES["guide"], lw=1, ls=(0, (5, 4)))
    near = 5 * np.array([[0, 0], [sides[0], 1], [sides[1], 1]])
    ax.fill(*near.T, fc=ROLES["camera"], ec=ROLES["camera"], lw=1.5)
    write(ax, (4, 1.5), "camera", "camera", ha="left")
    chosen = [(n, poses[n]) for n in SHOWN if n < len(poses)]
    if not chosen or any(pose is None for _, pose in chosen):
        write(ax, (0, 30), "no answer yet", "guide", fontsize=14)
    for number, pose in chosen:
        if pose is not None:
            _from_above(ax, number, *pose)
    ax.set_title("from above; thick: the upper edge of a board", fontsize=10.5)
    ax.set(xlim=(-27, 27), ylim=(-2, 58), aspect="equal", xlabel="x (cm)", ylabel="z (cm)")
    return fig


def _from_above(ax: Axes, number: int, R: ArrayLike, t: ArrayLike) -> None:
    """Draw a board in the plane of the camera's x and z, with its number at its near end."""
    corners = (board_outline() @ np.asarray(R).T + np.asarray(t)) / 10
    if not np.isfinite(corners).all():
        return
    x, z = corners[:, [0, 2]].T
    from matplotlib.colors import to_rgb

    ax.fill(x, z, fc=(*to_rgb(ROLES["object"]), 0.12), ec=ROLES["object"], lw=2)
    upper = np.argsort(corners[:, 1])[:2]  # y grows downwards
    ax.plot(x[upper], z[upper], color=ROLES["object"], lw=4.5, solid_capstyle="butt")
    end = int(np.argmin(z))
    write(ax, (x[end], z[end] - 1.8), str(number), "object", fontsize=11)


@figure("The rows of a board meet in one point, its columns in another: columns of H.")
def vanishing_columns(photograph: NDArray[np.uint8], H: ArrayLike) -> Figure:
    """Show that the first two columns of a homography are the board's vanishing points.

    Parameters
    ----------
    photograph : ndarray, shape (height, width)
        The picture.
    H : array_like, shape (3, 3)
        Homography from the board to pixels.

    Returns
    -------
    Figure
        The photograph with the board's edges, prolonged to where they meet.
    """
    H = np.asarray(H, dtype=float)
    fig, ax = panels(1, 1, (FULL_WIDTH, 4.0))
    ax.set_aspect("equal")
    ax.axis("off")
    ax.imshow(photograph, vmin=0, vmax=255)
    width, height, _ = BOARD.points()[-1]
    corners = _mapped(H, [[0, 0], [width, 0], [width, height], [0, height]])
    meets = (H[:2, :2] / H[2, :2]).T
    everything = np.vstack([corners, [[0, 0], SIZE], meets])
    middle = (everything.min(axis=0) + everything.max(axis=0)) / 2
    _converge(ax, corners[[[0, 1], [3, 2]]], meets[0], "h_1", middle, "camera")
    _converge(ax, corners[[[0, 3], [1, 2]]], meets[1], "h_2", middle, "object")
    _along(ax, corners[:2], meets[0], "rows", "camera")
    _along(ax, corners[[0, 3]], meets[1], "columns", "object")
    (left, top), (right, bottom) = everything.min(axis=0), everything.max(axis=0)
    room = 0.12 * max(right - left, bottom - top)
    ax.set(xlim=(left - room, right + room), ylim=(bottom + room, top - room))
    return fig


def _converge(ax: Axes, sides: Floats, meet: Floats, name: str, middle: Floats, role: str) -> None:
    """Prolong two sides (2, 2, 2) to the point where they meet, and name it towards the middle."""
    for ends in sides:
        far = ends[np.argmax(np.linalg.norm(ends - meet, axis=1))]
        ax.plot(*np.array([far, meet]).T, color=ROLES[role], lw=1.8)
    ax.plot(*meet, "o", color=ROLES[role], ms=8)
    right, low = meet > middle
    text = f"$\\mathbf{{{name[0]}}}_{name[2]}$: ({meet[0]:.0f}, {meet[1]:.0f}) px"
    look: dict[str, Any] = {"color": ROLES[role], "ha": "right" if right else "left"}
    aside = (-12 if right else 4, 16 if low else -18)
    ax.annotate(text, tuple(meet), aside, textcoords="offset points", va="center", **look)


def _along(ax: Axes, side: Floats, meet: Floats, name: str, role: str) -> None:
    """Write what meets on one of the lines, halfway to where it ends."""
    near = side[np.argmin(np.linalg.norm(side - meet, axis=1))]
    paper = {"facecolor": "white", "edgecolor": "none", "pad": 1.5}
    write(ax, (near + meet) / 2, name, role, bbox=paper)


def _mapped(H: Floats, points: ArrayLike) -> Floats:
    rows = np.column_stack([np.asarray(points, float), np.ones(len(np.asarray(points)))]) @ H.T
    return np.asarray(rows[:, :2] / rows[:, 2:])
