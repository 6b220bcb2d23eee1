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
    for number, R, t in order:
        corners = (board_outline() @ np.asarray(R).T + np.asarray(t)) @ up.T
        if np.isfinite(corners).all():
            show_face(ax, view, corners, "object", alpha=0.12)
            write(ax, view.project(corners[0]), str(number), fontsize=9)
    ax.set(xlim=(0, 640), ylim=(450, 20))
    return fig


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
    spans = [corners, np.array([[0, 0], SIZE])]
    for column, role, sides in ((0, "camera", ((0, 1), (3, 2))), (1, "object", ((0, 3), (1, 2)))):
        meet = H[:2, column] / H[2, column]
        spans.append(meet[None])
        for side in sides:
            far = corners[list(side)][np.argmax(np.linalg.norm(corners[list(side)] - meet, axis=1))]
            ax.plot(*np.array([far, meet]).T, color=ROLES[role], lw=1.8)
        ax.plot(*meet, "o", color=ROLES[role], ms=8)
        sign = 1 if meet[0] > SIZE[0] / 2 else -1
        name = f"$\\mathbf{{h}}_{column + 1}$: ({meet[0]:.0f}, {meet[1]:.0f}) px"
        below = sign > 0
        ax.annotate(
            name,
            meet,
            (-8 * sign, -16 if below else 14),
            textcoords="offset points",
            color=ROLES[role],
            ha="right" if sign > 0 else "left",
            va="center",
        )
    everything = np.vstack(spans)
    (left, top), (right, bottom) = everything.min(axis=0) - 60, everything.max(axis=0) + 60
    ax.set(xlim=(left, right), ylim=(bottom + 20, top - 20))
    return fig


def _mapped(H: Floats, points: ArrayLike) -> Floats:
    rows = np.column_stack([np.asarray(points, float), np.ones(len(np.asarray(points)))]) @ H.T
    return np.asarray(rows[:, :2] / rows[:, 2:])
