"""Rectification by hand: two pictures turn, and their epipolar lines become rows."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib import data
from course_lib.drawing.epipolar.photographs import stereo_boards
from course_lib.drawing.explorers.frame import Frame, Line, Picture, Readout
from course_lib.drawing.explorers.pairs import TOWARDS, cameras, photographs, relative, true_pairs
from course_lib.drawing.explorers.plot import disc
from course_lib.epipolar import (
    epipolar_lines,
    essential_from_pose,
    fundamental_from_essential,
    rectify,
)
from course_lib.homogeneous import apply_homography
from course_lib.transforms import rotation_from_vector, vector_from_rotation

Floats = NDArray[np.float64]
Colour = NDArray[np.uint8]

STREET, BOARD = "street, cameras turned", "photographs of a board"
WIDTH, SIZE = 400, (400, 300)
#: Focal length of the rectified street, as a share: a wider view, so that enough stays inside.
WIDER = 0.8
SHOWN = 9  # points with their lines
ROLES = ("camera", "ray", "image", "object", "second")


@dataclass(frozen=True, eq=False)
class TwoViews:
    """Two pictures without distortion, their cameras, and points that both show.

    Attributes
    ----------
    pictures : tuple of two ndarray, shape (300, 400, 3), uint8
        RGB.
    K1, K2, R, t, K
        Intrinsics, relative pose, and the intrinsics after rectification, px.
    points1, points2 : ndarray, shape (N, 2)
        Pixels that belong together.
    shown : ndarray of int, shape (SHOWN,)
        Which of them are drawn.
    """

    pictures: tuple[Colour, Colour]
    K1: Floats
    K2: Floats
    R: Floats
    t: Floats
    K: Floats
    points1: Floats
    points2: Floats
    shown: NDArray[np.intp]


@cache
def two_views(pair: str) -> TwoViews:
    """Return the pictures of a pair; the street again where photographs cannot be had."""
    if pair == BOARD:
        try:
            return _board()
        except data.Unavailable:
            return two_views(STREET)
    one, other = cameras(TOWARDS, WIDTH)
    K = one.K.copy()
    K[:2, :2] *= WIDER
    points1, points2, _ = true_pairs(TOWARDS, WIDTH)
    order = np.argsort(points1[:, 1])
    shown = order[np.linspace(2, len(order) - 3, SHOWN).astype(int)]
    pose = relative(TOWARDS, WIDTH)
    return TwoViews(photographs(TOWARDS, WIDTH), one.K, other.K, *pose, K, points1, points2, shown)


def _board() -> TwoViews:
    import cv2

    seen, view = stereo_boards(), 0
    scale = np.diag([WIDTH / 640, WIDTH / 640, 1.0])
    scale[:2, 2] = (WIDTH / 640 - 1) / 2  # pixel centres
    small = [
        cv2.resize(picture, SIZE, interpolation=cv2.INTER_AREA)
        for picture in seen.straightened(view)
    ]
    K1, K2 = scale @ seen.calibration.K_left, scale @ seen.calibration.K_right
    left, right = (
        apply_homography(points[54 * view : 54 * (view + 1)], scale)
        for points in seen.straight_corners()
    )
    pictures = tuple(np.repeat(np.asarray(p, np.uint8)[..., None], 3, axis=2) for p in small)
    shown = np.arange(0, 54, 7)[:SHOWN].astype(np.intp)
    R, t = seen.calibration.R, seen.calibration.t
    return TwoViews((pictures[0], pictures[1]), K1, K2, R, t, (K1 + K2) / 2, left, right, shown)


def rectification_frame(s: float, pair: str) -> Frame:
    """Return both pictures of a pair on their way to being rectified.

    Parameters
    ----------
    s : float
        How far: 0 as taken, 1 rectified.
    pair : str
        `STREET` or `BOARD`.

    Returns
    -------
    Frame
        Both pictures with points, their partners' epipolar lines, and how far rows differ.
    """
    views = two_views(pair)
    H1, H2, turns = turned(views, s)
    F = fundamental_from_essential(essential_from_pose(views.R, views.t), views.K1, views.K2)
    F = np.linalg.inv(H2).T @ F @ np.linalg.inv(H1)
    one, other = apply_homography(views.points1, H1), apply_homography(views.points2, H2)
    rows = one[:, 1] - other[:, 1]
    lines = epipolar_lines(other, F.T), epipolar_lines(one, F)
    steepest = np.degrees(np.abs(np.arctan(lines[1][:, 0] / lines[1][:, 1])).max())
    readouts = (
        Readout("Rows differ by (RMS)", "", f"{np.sqrt((rows**2).mean()):.2f}", "px"),
        Readout("Steepest line on the right", "", f"{steepest:.2f}", "°"),
        Readout("Left turned by", "", f"{turns[0]:.2f}", "°"),
        Readout("Right turned by", "", f"{turns[1]:.2f}", "°"),
    )
    names = ("Left", "Right")
    pictures = tuple(
        _picture(views, name, k, H, points, lines[k], rows)
        for k, (name, H, points) in enumerate(zip(names, (H1, H2), (one, other), strict=True))
    )
    return Frame(pictures, readouts)


@cache
def _turns(views: TwoViews) -> tuple[Floats, Floats]:
    """Return the rotation vectors that rectify both cameras, rad."""
    whole = rectify(views.K1, views.K2, views.R, views.t, views.K)
    return vector_from_rotation(whole.R1), vector_from_rotation(whole.R2)


@cache
def _four_channels(views: TwoViews) -> list[Colour]:
    """Return both pictures with a fourth channel: OpenCV turns these in half the time of three."""
    import cv2

    return [np.asarray(cv2.cvtColor(p, cv2.COLOR_RGB2RGBA), np.uint8) for p in views.pictures]


def turned(views: TwoViews, s: float) -> tuple[Floats, Floats, tuple[float, float]]:
    """Return both homographies at a share of the way, and their turns in degrees."""
    out = []
    for K, whole in zip((views.K1, views.K2), _turns(views), strict=True):
        step = s * whole
        now = (1 - s) * K + s * views.K
        H = now @ rotation_from_vector(step) @ np.linalg.inv(K)
        out.append((H, float(np.degrees(np.linalg.norm(step)))))
    return out[0][0], out[1][0], (out[0][1], out[1][1])


def _picture(
    views: TwoViews, name: str, k: int, H: Floats, points: Floats, lines: Floats, rows: Floats
) -> Picture:
    """Return one of the pictures, turned, with points and the lines of their partners."""
    import cv2

    strokes = []
    for n, number in enumerate(views.shown):
        role = ROLES[n % len(ROLES)]
        a, b, c = lines[number]
        u = np.array([0.0, SIZE[0] - 1])
        strokes.append(Line(np.stack([u, -(a * u + c) / b], axis=1), role, 1.8))
        strokes.append(Line(disc(points[number], 4.5), role, 2.5, closed=True))
    shown = cv2.warpPerspective(_four_channels(views)[k], H, SIZE, borderValue=(235,) * 4)
    shown = cv2.cvtColor(shown, cv2.COLOR_RGBA2RGB)
    return Picture(
        name,
        f"{name} picture, turned, with {SHOWN} points and the epipolar lines of their partners. "
        f"Rows of partners differ by up to {np.abs(rows).max():.1f} px.",
        SIZE,
        np.asarray(shown, np.uint8),
        lines=tuple(strokes),
    )
