"""Still figures of boards: the three kinds, and what an imperfect one does to a calibration."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from course_lib.boards import Board, Charuco, Checkerboard, DotGrid
from course_lib.calibration import Calibration, calibrate
from course_lib.camera import camera_matrix, project
from course_lib.detection.circles import circle_bias
from course_lib.distortion import distort_pixels
from course_lib.drawing.calibration.photographs import BOARD, SIZE
from course_lib.drawing.diagrams import Floats, figure, panels, sketch, stroke, write
from course_lib.drawing.style import FULL_WIDTH, GREY, ROLES
from data_generators.board_observations import observe_board
from data_generators.board_scenes import on_board
from data_generators.targets import charuco, checkerboard, dot_grid

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: A camera that we choose, to see how far a calibration with a bad board is from it.
K = np.array([[560.0, 0, 322.4], [0, 558, 241.7], [0, 0, 1]])
LENS = np.array([-0.28, 0.1, 0.0005, -0.0003, 0.0])
NOISE = 0.1  # px
DOTS = DotGrid(BOARD.columns, BOARD.rows, BOARD.square, 0.6 * BOARD.square)


@figure("A checkerboard, a grid of dots, and a checkerboard with markers; their points in red.")
def targets() -> Figure:
    """Show three kinds of boards, with the points that are measured on them.

    Returns
    -------
    Figure
        A panel for each.
    """
    fig, axes = panels(1, 3, (FULL_WIDTH, 2.5))
    square = 32
    boards: dict[str, tuple[NDArray[np.uint8], Board, float]] = {
        "checkerboard": (checkerboard(6, 5, square), Checkerboard(5, 4, square), 1.5),
        "dot grid": (dot_grid(5, 4, square, 0.6), DotGrid(5, 4, square, 0.6 * square), 0.5),
        "ChArUco": (charuco(Charuco(5, 4, 1, 0.73), square), Charuco(5, 4, square, 1), 1.5),
    }
    for ax, (name, (picture, board, first)) in zip(axes, boards.items(), strict=True):
        ax.imshow(picture, vmin=0, vmax=255)
        corner = first * square - 0.5
        ax.plot(
            *(board.points()[:, :2] + corner).T, "o", mfc="none", mec=ROLES["object"], ms=7, mew=2
        )
        ax.set_title(name)
        ax.axis("off")
    return fig


@cache
def _shot() -> tuple[tuple[Floats, Floats], ...]:
    """Return thirteen poses of a board before the camera."""
    rng = np.random.default_rng(7)
    seen = observe_board(rng, BOARD.points(), K, LENS, SIZE, views=13, tilt=0.4)
    return tuple(seen.poses)


def with_bad_board(points: Floats, noise: float = NOISE) -> Calibration:
    """Return the calibration of somebody who believes that a board is as it should be.

    Parameters
    ----------
    points : ndarray, shape (54, 3)
        Where its corners really are, mm.
    noise : float
        Standard deviation of each pixel coordinate, px.

    Returns
    -------
    Calibration
        From thirteen views by the camera `K` with the distortion `LENS`.
    """
    rng = np.random.default_rng(3)
    pixels = [distort_pixels(project(points, camera_matrix(K, R, t)), K, LENS) for R, t in _shot()]
    return calibrate(BOARD.points(), [p + rng.normal(0, noise, p.shape) for p in pixels], SIZE)


def with_dots(noise: float = 0.02) -> Calibration:
    """Return the calibration of somebody who takes the middle of a dot's picture for its centre.

    Parameters
    ----------
    noise : float
        Standard deviation of each pixel coordinate, px.

    Returns
    -------
    Calibration
        From thirteen views by the camera `K` with the distortion `LENS`.
    """
    rng, pixels = np.random.default_rng(1), []
    for R, t in _shot():
        centres = project(DOTS.points(), camera_matrix(K, R, t))
        middles = centres + circle_bias(DOTS.points(), DOTS.diameter / 2, K, R, t)
        pixels.append(distort_pixels(middles, K, LENS) + rng.normal(0, noise, middles.shape))
    return calibrate(DOTS.points(), pixels, SIZE)


def bad_boards() -> dict[str, tuple[Floats, Calibration]]:
    """Return boards that are not as they should be, and what a calibration makes of them.

    Returns
    -------
    dict of str to (points, Calibration)
        By what is wrong: the true corners, mm, and the calibration.
    """
    flat = BOARD.points()
    boards = {
        "as it should be": flat,
        "bent by 1 mm": on_board(BOARD, 1.0),
        "1 % too long one way": flat * [1.01, 1, 1],
        "1 % too large": flat * 1.01,
    }
    return {name: (points, with_bad_board(points)) for name, points in boards.items()}


def tilted_views(tilt: float) -> Calibration:
    """Return the calibration from thirteen views of a board that is tilted little or much.

    Parameters
    ----------
    tilt : float
        Standard deviation of the board's turns about the camera's x and y, rad.

    Returns
    -------
    Calibration
        Of the camera `K`; corners are found to `NOISE`.

    Raises
    ------
    DegenerateConfigurationError
        If the tilts are too small.
    """
    rng = np.random.default_rng(3)
    seen = observe_board(
        rng, BOARD.points(), K, LENS, SIZE, views=13, noise=NOISE, tilt=float(tilt)
    )
    return calibrate(BOARD.points(), seen.pixels, SIZE)


@figure("A bent board, one too long and one too large, and how far fx, fy and distances are off.")
def flatness() -> Figure:
    """Show three bad boards and what each does to a calibration.

    Returns
    -------
    Figure
        A panel for each board, with the errors of focal lengths and distance below.
    """
    fig, axes = panels(1, 4, (FULL_WIDTH, 2.3))
    for ax, (name, (points, found)) in zip(axes, bad_boards().items(), strict=True):
        sketch(ax)
        ax.set_title(name, fontsize=10)
        # Seen from above, the bend and the surplus drawn larger than they are.
        stroke(ax, _flat(), "guide", lw=1.2, ls=(0, (4, 3)))
        stroke(ax, _exaggerated(points), "object", lw=3)
        off = found.K - K
        away = np.mean([t[2] / u[2] for (_, t), (_, u) in zip(found.poses, _shot(), strict=True)])
        lines = (
            f"fx {off[0, 0]:+.1f} px, fy {off[1, 1]:+.1f} px",
            f"distance {round(100 * (away - 1), 1) + 0.0:+.1f} %",
            f"RMS {found.rms:.2f} px",
        )
        for row, line in enumerate(lines):
            write(ax, (0, -1.15 - 0.42 * row), line, fontsize=9.5)
        ax.set(xlim=(-1.6, 1.6), ylim=(-2.3, 1.1))
    note = f"true: fx {K[0, 0]:.0f} px, fy {K[1, 1]:.0f} px; up to 0.3 px is chance"
    fig.suptitle(f"{note}      drawn: bend × 60, length × 20", fontsize=8, color=GREY, y=0.03)
    return fig


def _flat() -> Floats:
    return np.array([[-1.0, -0.6], [1, -0.6], [1, 0.7], [-1, 0.7], [-1, -0.6]])


def _exaggerated(points: Floats) -> Floats:
    """Return the outline of a board with its faults drawn larger; the bend is out of its plane."""
    flat = BOARD.points()
    across = 1 + 20 * (np.ptp(points[:, 0]) / np.ptp(flat[:, 0]) - 1)
    down = 1 + 20 * (np.ptp(points[:, 1]) / np.ptp(flat[:, 1]) - 1)
    bend = 60 * np.ptp(points[:, 2]) / np.ptp(flat[:, 0])
    x = np.linspace(-1, 1, 41)
    lift = bend * (1 - x**2)
    lower, upper = np.column_stack([x, lift - 0.6]), np.column_stack([x, lift + 0.7])
    around = np.vstack([lower, upper[::-1], lower[:1]])
    return np.asarray((around - [0, 0.05]) * [across, down] + [0, 0.05])
