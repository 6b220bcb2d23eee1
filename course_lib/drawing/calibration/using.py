"""Still figures on using a calibrated camera: its rays, how sure they are, and when they change."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from course_lib.calibration import Calibration
from course_lib.calibration.derivatives import derivative_blocks
from course_lib.calibration.model import State
from course_lib.calibration.result import state_of
from course_lib.calibration.views import gather_views
from course_lib.distortion import undistort_points
from course_lib.drawing.calibration.photographs import SIZE
from course_lib.drawing.diagrams import (
    Floats,
    figure,
    panels,
    picture_frame,
    plain_numbers,
    stroke,
    write,
)
from course_lib.drawing.space import onlooker, show_axes, show_path
from course_lib.drawing.style import BLACK, FULL_WIDTH, ROLES
from course_lib.optics import image_distance

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: A small lens, mm, and the focal length in px that it has when it is focused far away.
LENS, FAR = 6.0, 534.0
GRID = (129, 97)  # columns and rows of pixels at which rays are looked at
LEVELS = (0.05, 0.1, 0.2, 0.5, 1.0, 5.0)  # px: where lines of equal uncertainty are drawn


def directions(calibration: Calibration, pixels: ArrayLike) -> Floats:
    """Return where rays through pixels meet the plane at distance 1, (N, 3); NaN if nowhere."""
    (fx, s, cx), (_, fy, cy), _ = calibration.K
    u, v = np.asarray(pixels, dtype=float).T
    y = (v - cy) / fy
    ideal = undistort_points(np.column_stack([(u - cx - s * y) / fx, y]), calibration.coefficients)
    return np.column_stack([ideal, np.ones(len(ideal))])


def ray_sigma(calibration: Calibration, pixels: ArrayLike, seen: ArrayLike) -> Floats:
    """Return how far rays may be off, by the covariance of the camera.

    A turn of the whole camera is left out, as it changes no shape that is measured: the one that
    brings the rays of the corners together best.

    Parameters
    ----------
    calibration : Calibration
        The camera.
    pixels : array_like, shape (N, 2)
        Where, px.
    seen : array_like, shape (M, 2)
        Corners that the camera was calibrated with, px.

    Returns
    -------
    ndarray, shape (N,)
        Standard deviation of the length of the error in the picture, px.
    """
    camera, turn = _slopes(calibration, np.asarray(pixels, dtype=float))
    camera_seen, turn_seen = _slopes(calibration, np.asarray(seen, dtype=float))
    left = camera - turn @ np.linalg.lstsq(turn_seen, camera_seen, rcond=None)[0]
    variance = np.einsum("ij,jk,ik->i", left, calibration.covariance, left)
    return np.asarray(np.sqrt(variance.reshape(2, -1).sum(axis=0)))


def _slopes(calibration: Calibration, pixels: Floats) -> tuple[Floats, Floats]:
    """Return how pixels of fixed rays change with the camera's numbers, and if it turns.

    Both have a row for each u, then one for each v.
    """
    # A board at distance 1 that faces the camera, with a point on each ray.
    wall = directions(calibration, pixels) * [1, 1, 0]
    pose = np.eye(3)[None], np.array([[0.0, 0, 1]])
    alone = State(calibration.model, state_of(calibration).camera, *pose)
    (block,) = derivative_blocks(alone, gather_views([wall], [pixels]))
    n = len(calibration.sigma)
    columns = block[0].reshape(n + 7, -1).T
    turn, shift = columns[:, n : n + 3], columns[:, n + 3 : n + 6]
    # Turned about the camera's centre, the board also shifts: w × (0, 0, 1).
    return columns[:, :n], turn + shift @ np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 0]])


@figure("How far a ray may be off: little where corners were seen, much where there were none.")
def ray_uncertainty(calibration: Calibration, pixels: Sequence[ArrayLike]) -> Figure:
    """Show over the picture how uncertain the rays of a calibrated camera are.

    Parameters
    ----------
    calibration : Calibration
        The camera.
    pixels : sequence of array_like, shape (N, 2)
        The corners it was calibrated with.

    Returns
    -------
    Figure
        Lines of equal standard deviation, px, and the corners.
    """
    columns, rows = GRID
    u, v = np.meshgrid(np.linspace(0, SIZE[0] - 1, columns), np.linspace(0, SIZE[1] - 1, rows))
    seen = np.vstack([np.asarray(view, dtype=float) for view in pixels])
    sigma = ray_sigma(calibration, np.column_stack([u.ravel(), v.ravel()]), seen).reshape(u.shape)
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.75, 4.0))
    ax.plot(*seen.T, ".", color="#B8BEC4", ms=3)
    ax.contour(u, v, sigma, levels=LEVELS, colors=ROLES["object"], linewidths=1.4)
    picture_frame(ax, SIZE)
    _numbers(ax, u, v, sigma)
    ax.set_title("standard deviation of a ray (px); dots: corners seen", fontsize=10.5)
    return fig


def _numbers(ax: Axes, u: Floats, v: Floats, sigma: Floats) -> None:
    """Write each line's number left of the middle, where it has room, and those of the corners."""
    look: dict[str, Any] = {"bbox": {"facecolor": "white", "edgecolor": "none", "pad": 1.2}}
    row, half, last = int(0.58 * len(u)), u.shape[1] // 2, np.inf
    for level in LEVELS:
        at = float(np.interp(-level, -sigma[row, :half], u[row, :half]))
        if 25 < at < last - 30:
            write(ax, (at, v[row, 0]), f"{level:g}", "object", fontsize=9, **look)
            last = at
    middle = len(u) // 2
    ax.plot(0, v[middle, 0], "o", color=ROLES["object"], ms=7, clip_on=False)
    edge = f"{sigma[middle, 0]:.1f} px"
    write(ax, (9, v[middle, 0]), edge, "object", ha="left", va="center", **look)
    for row, low in ((0, False), (-1, True)):
        for column, right in ((0, False), (-1, True)):
            at_corner = u[row, column] - (6 if right else -6), v[row, column] - (6 if low else -6)
            look |= {"ha": "right" if right else "left", "va": "bottom" if low else "top"}
            write(ax, at_corner, f"{sigma[row, column]:.1f} px", "object", **look)


@figure("Pixels in a grid, and the rays behind them, which meet a wall in a bent grid.")
def set_of_rays(calibration: Calibration) -> Figure:
    """Show the camera as rays: from a regular grid of pixels to a wall.

    Parameters
    ----------
    calibration : Calibration
        The camera.

    Returns
    -------
    Figure
        Centre, picture and wall in space.
    """
    columns, rows = 9, 7
    u, v = np.meshgrid(np.linspace(0, SIZE[0] - 1, columns), np.linspace(0, SIZE[1] - 1, rows))
    far = directions(calibration, np.column_stack([u.ravel(), v.ravel()]))
    K = calibration.K
    near = np.column_stack([(u.ravel() - K[0, 2]) / K[0, 0], (v.ravel() - K[1, 2]) / K[1, 1]])
    up = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
    far, near = far @ up.T, 0.55 * np.column_stack([near, np.ones(len(near))]) @ up.T
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.8))
    ax.set_aspect("equal")
    ax.axis("off")
    view = onlooker((2.6, -0.9, 1.1), (0.05, 0.5, 0), 950)
    for at in far:
        show_path(ax, view, [np.zeros(3), at], "ray", lw=0.6)
    for points, role in ((far, "object"), (near, "image")):
        grid = points.reshape(rows, columns, 3)
        for line in (*grid, *grid.transpose(1, 0, 2)):
            show_path(ax, view, line, role, lw=1.4)
    show_axes(ax, view, np.zeros(3), 0.2 * up.T, "xyz", "camera", "centre")
    wall = view.project(far)
    write(ax, (wall[:, 0].max() + 12, wall[:, 1].mean()), "wall", "object", ha="left")
    ax.invert_yaxis()
    picture = view.project(near)
    write(ax, (picture[:, 0].mean(), picture[:, 1].max() + 18), "pixels", "image")
    return fig


@figure("The focal length in pixels grows by several per cent as the lens is focused nearer.")
def focus_changes() -> Figure:
    """Show how K's focal length depends on where a lens is focused.

    Returns
    -------
    Figure
        Focal length in px against the distance in focus.
    """
    away = np.geomspace(0.1, 10, 200)
    f = FAR * np.asarray(image_distance(LENS, 1000 * away)) / LENS
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.8, 2.8))
    ax.axhline(FAR, color=ROLES["guide"], lw=1, ls=(0, (5, 4)))
    stroke(ax, np.column_stack([away, f]), "camera", lw=2.5)
    near = FAR * float(image_distance(LENS, 500.0)) / LENS
    ax.plot(0.5, near, "o", color=ROLES["object"], ms=7)
    write(ax, (0.54, near + 2.5), f"{near:.1f} px at 0.5 m", "object", ha="left")
    write(ax, (2.2, FAR - 2.2), f"{FAR:.0f} px, focused far away", color=BLACK)
    ax.set_xscale("log")
    ax.set_xticks([0.1, 0.2, 0.5, 1, 2, 5, 10])
    plain_numbers(ax)
    ax.set_yscale("linear")
    ax.set(xlabel="distance in focus (m)", ylabel="focal length (px)", ylim=(528, 570))
    return fig
