"""The pose explorer: which views of a board determine which numbers of a camera."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib.boards import Checkerboard
from course_lib.calibration import reprojection_residuals
from course_lib.calibration.derivatives import derivative_blocks
from course_lib.calibration.model import CameraModel, State, camera_numbers
from course_lib.calibration.views import gather_views
from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot
from course_lib.drawing.space import onlooker
from course_lib.transforms import rotation_x, rotation_y, rotation_z

Floats = NDArray[np.float64]

BOARD = Checkerboard(9, 6, 30.0)
SIZE = (640, 480)
K = np.array([[560.0, 0, 319.5], [0, 560, 239.5], [0, 0, 1]])
LENS = (-0.25, 0.08)
MODEL = CameraModel(coefficients=("k1", "k2"))
TILT = np.radians(35)
#: By name: how the board is turned about its middle, and where its middle is, mm.
VIEWS: dict[str, tuple[Floats, tuple[float, float, float]]] = {
    "facing": (np.eye(3), (0, 0, 500)),
    "facing, farther away": (np.eye(3), (0, 0, 800)),
    "facing, turned by 90°": (rotation_z(np.pi / 2), (0, 0, 550)),
    "tilted about x": (rotation_x(TILT), (0, 0, 500)),
    "tilted about y": (rotation_y(TILT), (0, 0, 500)),
    "tilted the other way about x": (rotation_x(-TILT), (0, 0, 500)),
    "in the upper left corner": (np.eye(3), (-210, -160, 620)),
    "tilted, in the lower right corner": (rotation_y(-TILT), (230, 170, 620)),
}
ROOM_SIZE, SEEN_SIZE, BARS_SIZE = (330, 270), (320, 240), (300, 270)
SCALE = SEEN_SIZE[0] / SIZE[0]
#: The bars, from 0.01 to 100: by name the unit, and how many times its value a bar is long.
BARS = {"fx": ("px", 1.0), "cx": ("px", 1.0), "cy": ("px", 1.0), "k1": ("", 1000.0)}
AXES = Plot((44, 226, 24, 226), (0.01, 100), (0, 4), log_x=True)
#: A direction that changes no pixel by more than this part of the others is not determined.
UNKNOWN = 1e-9


def poses_frame(noise: float, **switched: bool) -> Frame:
    """Return what chosen views of a board say about a camera.

    Parameters
    ----------
    noise : float
        How well a corner is found, along u and along v, px.
    **switched : bool
        ``view1`` … ``view8``: whether a view of `VIEWS` is used.

    Returns
    -------
    Frame
        Standard deviations of the camera, and the boards in space and in the picture.
    """
    chosen = [bool(switched.get(f"view{n}")) for n in range(1, len(VIEWS) + 1)]
    sigma = {name: noise * value for name, value in sigmas(chosen).items()}
    readouts = [Readout("Views", "", f"{sum(chosen)}")]
    for name, (unit, _) in BARS.items():
        value = sigma[name]
        text = f"± {_short(value)}" if np.isfinite(value) else "not determined"
        readouts.append(Readout(name, "", text, unit if np.isfinite(value) else ""))
    return Frame((_bars(sigma, noise), _room(chosen), _seen(chosen)), tuple(readouts))


def sigmas(chosen: list[bool]) -> dict[str, float]:
    """Return standard deviations of the camera for corners found to 1 px; infinite if one is open.

    Parameters
    ----------
    chosen : list of bool
        Which views are used.

    Returns
    -------
    dict of str to float
        fx, fy, cx, cy, k1, k2.
    """
    N = np.asarray(_information()[chosen].sum(axis=0))
    size = np.sqrt(np.maximum(np.diag(_information().sum(axis=0)), 1e-300))
    values, vectors = np.linalg.eigh(N / np.outer(size, size))
    known = values > UNKNOWN
    open_part = (vectors[:, ~known] ** 2).sum(axis=1)
    variance = ((vectors[:, known] ** 2) / values[known]).sum(axis=1) / size**2
    sigma = np.where(open_part > 1e-6, np.inf, np.sqrt(variance))
    return dict(zip(MODEL.names, sigma.tolist(), strict=True))


@cache
def _information() -> Floats:
    """Return what each view says of the camera whatever its pose, (V, n, n): they add up."""
    poses = [_pose(*view) for view in VIEWS.values()]
    R, t = (np.array(part) for part in zip(*poses, strict=True))
    state = State(MODEL, camera_numbers(K, LENS), R, t)
    views = gather_views(BOARD.points(), _projected(BOARD.points()))
    blocks = np.concatenate([np.array(block) for block in derivative_blocks(state, views)])
    n = len(MODEL.names)
    rows = blocks.reshape(len(R), n + 7, -1)
    camera, pose = rows[:, :n], rows[:, n : n + 6]
    A, B, D = camera @ camera.mT, camera @ pose.mT, pose @ pose.mT
    # The poses are unknown, too: the Schur complement takes their part away.
    return np.asarray(A - B @ np.linalg.solve(D, B.mT))


def _pose(R: Floats, middle: tuple[float, float, float]) -> tuple[Floats, Floats]:
    """Return the pose of a board whose middle is at a place, board to camera."""
    return R, np.array(middle) - R @ BOARD.points().mean(axis=0)


def _outlines() -> list[Floats]:
    """Return the corners of the board with a border in each view, in the camera's frame."""
    last, s = BOARD.points()[-1], BOARD.square
    x, y = (-s, last[0] + s), (-s, last[1] + s)
    flat = np.array([[x[0], y[0], 0], [x[1], y[0], 0], [x[1], y[1], 0], [x[0], y[1], 0]])
    return [flat @ R.T + t for R, t in (_pose(*view) for view in VIEWS.values())]


@cache
def _in_room() -> tuple[list[Floats], Floats, Floats]:
    """Return the boards, the camera's pyramid and the ends of its axis as an onlooker sees them."""
    up = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
    view = onlooker((1500, -500, 750), (20, 400, -10), 640, ROOM_SIZE)
    w, h, d = 0.571 * 120, 0.428 * 120, 120.0
    frame = np.array([[-w, -h, d], [w, -h, d], [w, h, d], [-w, h, d]])
    pyramid = [frame[[0, 1, 2, 3, 0]], *(np.array([np.zeros(3), corner]) for corner in frame)]
    lifted = np.vstack([np.vstack([part, np.full((1, 3), np.nan)]) for part in pyramid])
    finite = np.isfinite(lifted).all(axis=1)
    drawn = np.full((len(lifted), 2), np.nan)
    drawn[finite] = view.project(lifted[finite] @ up.T)
    boards = [np.asarray(view.project(board @ up.T)) for board in _outlines()]
    return boards, drawn, np.asarray(view.project(np.zeros(3)))


@cache
def _in_picture() -> list[Floats]:
    """Return the outlines of the outermost corners in the picture, px of the small one."""
    around = np.r_[0:9, 17:54:9, 52:44:-1, 36:0:-9]
    return [SCALE * outline for outline in _projected(BOARD.points()[around])]


def _projected(points: Floats) -> list[Floats]:
    """Return the pixels of points of the board in each view."""
    nothing = np.zeros((len(points), 2))
    poses = (_pose(*view) for view in VIEWS.values())
    return [reprojection_residuals(points, nothing, K, R, t, LENS) for R, t in poses]


def _room(chosen: list[bool]) -> Picture:
    boards, pyramid, centre = _in_room()
    lines = [Line(pyramid, "camera", 1.5)]
    for on, board in zip(chosen, boards, strict=True):
        role, width, fill = ("object", 2.0, 0.15) if on else ("guide", 0.8, 0.0)
        lines.append(Line(board, role, width, closed=True, dashed=not on, fill=fill))
    u, v = centre.tolist()
    return Picture(
        "Camera and boards",
        f"A camera and {sum(chosen)} boards before it: {_named(chosen)}.",
        ROOM_SIZE,
        lines=tuple(lines),
        labels=(Label("camera", (u + 6, v + 30), "camera", "middle"), *_numbers(chosen, boards)),
    )


def _seen(chosen: list[bool]) -> Picture:
    width, height = SEEN_SIZE
    frame = np.array([[1, 1], [width - 2, 1], [width - 2, height - 2], [1, height - 2]])
    lines = [Line(frame, "image", 1.5, closed=True)]
    for on, outline in zip(chosen, _in_picture(), strict=True):
        role, thick, fill = ("object", 2.0, 0.15) if on else ("guide", 0.8, 0.0)
        lines.append(Line(outline, role, thick, closed=True, dashed=not on, fill=fill))
    return Picture(
        "In the picture",
        f"Where the boards are in the picture: {_named(chosen)}.",
        SEEN_SIZE,
        lines=tuple(lines),
        labels=_numbers(chosen, [outline[[0, 8, 13, 21]] for outline in _in_picture()]),
    )


def _numbers(chosen: list[bool], corners: list[Floats]) -> tuple[Label, ...]:
    """Return the number of each chosen view, inside one corner or another of its board.

    Those of the later views are farther inside: some of their boards cover an earlier one.
    """
    labels = []
    for number, (on, board) in enumerate(zip(chosen, corners, strict=True), start=1):
        out = 0.85 if number <= 4 else 0.66
        u, v = (out * board[number % 4] + (1 - out) * board.mean(axis=0)).tolist()
        labels += [Label(f"{number}", (u, v), "object", "middle")] if on else []
    return tuple(labels)


def _named(chosen: list[bool]) -> str:
    names = [name for name, on in zip(VIEWS, chosen, strict=True) if on]
    return "; ".join(names) or "none"


def _short(value: float) -> str:
    """Return two significant digits, without a power of ten where the number is large."""
    return f"{value:.0f}" if value >= 99.5 else f"{value:.2g}"


def _bars(sigma: dict[str, float], noise: float) -> Picture:
    left, right, top, bottom = AXES.box
    lines, labels, said = [AXES.frame()], [*AXES.ticks((0.01, 0.1, 1, 10, 100), ())], []
    labels.append(AXES.names("px; for k1 (no unit) 1000 times", "")[0])
    for number, (name, (unit, factor)) in enumerate(BARS.items()):
        v = top + (number + 0.5) * (bottom - top) / len(BARS)
        value = factor * sigma[name]
        known = np.isfinite(value)
        end = AXES.at(float(np.clip(value, 0.0101, 99)), 0)[0] if known else right
        box = [[left, v - 12], [end, v - 12], [end, v + 12], [left, v + 12]]
        role = "camera" if known else "guide"
        lines.append(Line(box, role, 1.0, closed=True, dashed=not known, fill=0.5 if known else 0))
        text = f"{_short(sigma[name])} {unit}".rstrip() if known else "open"
        labels += [Label(name, (left - 6, v), anchor="end"), Label(text, (end + 5, v))]
        said.append(f"{name} {text}")
    return Picture(
        "Sigma of each number",
        f"Standard deviations if corners are found to {noise:g} px: {', '.join(said)}.",
        BARS_SIZE,
        lines=tuple(lines),
        labels=tuple(labels),
    )
