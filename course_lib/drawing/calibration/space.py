"""Still figures in space: where the board was, its vanishing points, and a camera as rays."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera import Camera
from course_lib.drawing.calibration.photographs import BOARD, SIZE
from course_lib.drawing.diagrams import (
    Floats,
    figure,
    panels,
    write,
)
from course_lib.drawing.space import onlooker, show_axes, show_face, show_frustum
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


@figure("The camera, and the board in all its poses before it, seen from the side.")
def board_poses(K: ArrayLike, poses: Sequence[Pose | None]) -> Figure:
    """Show where the board was in each view, in the camera's frame.

    Parameters
    ----------
    K : array_like, shape (3, 3)
        Intrinsics, px.
    poses : sequence of (R, t) or None
        Board to camera, mm.

    Returns
    -------
    Figure
        Camera and boards in space, numbered.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 4.2))
    ax.set_aspect("equal")
    ax.axis("off")
    # The onlooker's world has z up: turn the camera's frame over.
    up = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
    view = onlooker((1000, -420, 480), (10, 230, -5), 900)
    camera = Camera(np.asarray(K, float), up.T, np.zeros(3), SIZE)
    show_frustum(ax, view, camera, 90.0, name="")
    show_axes(ax, view, np.zeros(3), 110 * up.T, "xyz", "camera", "camera")
    if any(pose is None for pose in poses):
        write(ax, (330, 200), "no answer yet", "guide", fontsize=14)
    order = sorted(((n, *pose) for n, pose in enumerate(poses) if pose is not None), key=_farthest)
    taken: list[Floats] = []
    for number, R, t in order:
        corners = (board_outline() @ np.asarray(R).T + np.asarray(t)) @ up.T
        if np.isfinite(corners).all():
            show_face(ax, view, corners, "object", alpha=0.08)
            _number(ax, np.asarray(view.project(corners)), number, taken)
    ax.set(xlim=(0, 640), ylim=(450, 20))
    return fig


def _number(ax: Axes, corners: Floats, number: int, taken: list[Floats]) -> None:
    """Write a board's number at the corner where there is most room, if there is any."""
    room = [min([float(np.hypot(*(at - c))) for at in taken], default=np.inf) for c in corners]
    best = int(np.argmax(room))
    if room[best] > 22:
        taken.append(corners[best])
        write(ax, corners[best], str(number), fontsize=9)


def _farthest(numbered: tuple[int, Any, Any]) -> float:
    """Return minus how far to the left a board is, which the onlooker sees from the right."""
    return float(np.asarray(numbered[2])[0])


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


def _mapped(H: Floats, points: ArrayLike) -> Floats:
    rows = np.column_stack([np.asarray(points, float), np.ones(len(np.asarray(points)))]) @ H.T
    return np.asarray(rows[:, :2] / rows[:, 2:])
