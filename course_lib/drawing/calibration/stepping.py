"""A calibration as one row of numbers, so that it can be refined step by step."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from course_lib.calibration import (
    initial_distortion,
    intrinsics_from_homographies,
    pose_from_homography,
    reprojection_residuals,
)
from course_lib.distortion import undistort_pixels
from course_lib.drawing.calibration.photographs import BOARD, SIZE
from course_lib.drawing.diagrams import Floats
from course_lib.homography import homography_dlt
from course_lib.transforms import rotation_from_vector, vector_from_rotation

Pose = tuple[Floats, Floats]
#: Numbers of the camera: fx, fy, cx, cy, k1, k2; of a view: three of its turn, three of t.
CAMERA, VIEW = 6, 6
#: Steps for derivatives by differences: of the camera's numbers, and of a pose's.
SMALL = np.array([1e-3, 1e-3, 1e-3, 1e-3, 1e-6, 1e-6, *[1e-6] * 3, *[1e-3] * 3])


def packed(K: ArrayLike, k: ArrayLike, poses: Sequence[Pose]) -> Floats:
    """Return a camera and its poses as one row of numbers.

    Parameters
    ----------
    K : array_like, shape (3, 3)
        Intrinsics, px; skew is left out.
    k : array_like, shape (2,)
        k1 and k2.
    poses : sequence of (R, t)
        Board to camera, mm.

    Returns
    -------
    ndarray, shape (6 + 6 V,)
        ``fx fy cx cy k1 k2``, then for each view axis times angle, and t.
    """
    K = np.asarray(K, dtype=float)
    views = [np.concatenate([vector_from_rotation(R), t]) for R, t in poses]
    return np.concatenate([K[[0, 1, 0, 1], [0, 1, 2, 2]], np.asarray(k, dtype=float), *views])


def unpacked(parameters: ArrayLike) -> tuple[Floats, Floats, list[Pose]]:
    """Return K, (k1, k2) and the poses from a row of numbers; the inverse of `packed`."""
    numbers = np.asarray(parameters, dtype=float)
    fx, fy, cx, cy = numbers[:4]
    rows = numbers[CAMERA:].reshape(-1, VIEW)
    K = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])
    return K, numbers[4:6], [(rotation_from_vector(row[:3]), row[3:]) for row in rows]


def residuals_and_derivatives(
    parameters: ArrayLike, pixels: Sequence[ArrayLike]
) -> tuple[Floats, Floats]:
    """Return all residuals in one row, and how each changes with each number.

    Parameters
    ----------
    parameters : array_like, shape (6 + 6 V,)
        As from `packed`.
    pixels : sequence of V array_like, shape (54, 2)
        Corners of the board in each view.

    Returns
    -------
    residuals : ndarray, shape (108 V,)
        Projected minus observed, px: du, dv of each corner.
    J : ndarray, shape (108 V, 6 + 6 V)
        Derivatives, by differences.

    Raises
    ------
    ValueError
        If the parameters are no camera, or a corner has no image.
    """
    numbers = np.asarray(parameters, dtype=float)
    rows = 2 * len(BOARD.points())
    residuals, J = np.empty(rows * len(pixels)), np.zeros((rows * len(pixels), len(numbers)))
    for view, seen in enumerate(pixels):
        own = [*range(CAMERA), *range(CAMERA + VIEW * view, CAMERA + VIEW * (view + 1))]
        here = slice(rows * view, rows * (view + 1))
        residuals[here] = _of_view(numbers[own], seen)
        for column, small, step in zip(own, SMALL, np.diag(SMALL), strict=True):
            ahead, behind = (_of_view(numbers[own] + sign * step, seen) for sign in (1, -1))
            J[here, column] = (ahead - behind) / (2 * small)
    if not np.isfinite(J).all():
        raise ValueError("with these parameters, corners of the board lie behind the camera")
    return residuals, J


def _of_view(numbers: Floats, pixels: ArrayLike) -> Floats:
    """Return the residuals of one view from the twelve numbers that it depends on, in a row."""
    K, k, ((R, t),) = unpacked(numbers)
    return reprojection_residuals(BOARD.points(), pixels, K, R, t, k).ravel()


def closed_form(pixels: Sequence[ArrayLike]) -> tuple[Floats, list[Pose]]:
    """Return K without skew, and the poses, from homographies alone."""
    plane = BOARD.points()[:, :2]
    Hs = np.array([homography_dlt(plane, view) for view in pixels])
    K = intrinsics_from_homographies(Hs)
    K[0, 1] = 0
    return K, [pose_from_homography(K, H) for H in Hs]


def opencv_calibration(pixels: Sequence[ArrayLike]) -> tuple[float, Floats, Floats]:
    """Return what OpenCV's ``calibrateCamera`` makes of the same corners.

    Parameters
    ----------
    pixels : sequence of array_like, shape (54, 2)
        Corners of each view.

    Returns
    -------
    rms : float
        Over points, px.
    K : ndarray, shape (3, 3)
        Intrinsics, px.
    k : ndarray, shape (5,)
        ``k1 k2 p1 p2 k3``.
    """
    import cv2

    seen = [np.asarray(view, np.float32).reshape(-1, 1, 2) for view in pixels]
    boards = [BOARD.points().astype(np.float32)] * len(seen)
    rms, K, k, *_ = cv2.calibrateCamera(boards, seen, SIZE, None, None)
    return float(rms), np.asarray(K, float), np.asarray(k, float).ravel()


def without_lens(K: ArrayLike, poses: Sequence[Pose]) -> Floats:
    """Return where a camera without distortion would see the corners of all views, (54 V, 2)."""
    K, board = np.asarray(K, dtype=float), BOARD.points()
    seen = [(board @ R.T + t) @ K.T for R, t in poses]
    return np.vstack([rows[:, :2] / rows[:, 2:] for rows in seen])


def in_turns(pixels: Sequence[ArrayLike], rounds: int) -> list[float]:
    """Return the RMS while closed form and lens are found in turns, px.

    Parameters
    ----------
    pixels : sequence of array_like, shape (54, 2)
        Corners of each view.
    rounds : int
        How often.

    Returns
    -------
    list of float
        The RMS after each round, which begins with the pixels straightened by the last lens.
    """
    history, straight = [], list(pixels)
    for _ in range(rounds):
        K, poses = closed_form(straight)
        k = initial_distortion(without_lens(K, poses), np.vstack([*pixels]), K)
        residuals = [
            reprojection_residuals(BOARD.points(), view, K, R, t, k)
            for view, (R, t) in zip(pixels, poses, strict=True)
        ]
        history.append(float(np.sqrt((np.vstack(residuals) ** 2).sum(axis=1).mean())))
        undone = [undistort_pixels(view, K, k) for view in pixels]
        # A first lens can be so wild that it reaches no such pixel.
        straight = [np.where(np.isnan(u), v, u) for u, v in zip(undone, pixels, strict=True)]
    return history
