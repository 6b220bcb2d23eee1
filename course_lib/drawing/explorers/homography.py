"""The homography explorer: four corners in a photograph, and the wall that they straighten."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib.checks import DegenerateConfigurationError
from course_lib.drawing.explorers.frame import (
    Frame,
    Handle,
    Label,
    Line,
    Picture,
    Probe,
    Readout,
    matrix,
)
from course_lib.homogeneous import apply_homography
from course_lib.homography import homography_dlt

Floats = NDArray[np.float64]

SIZE = (480, 360)  # px of the photograph
SCALE = 34  # px a metre of the straightened wall
NAMES = ("bottom left", "bottom right", "top right", "top left")
#: Where the four spots stand at first, px.
START = np.array([[110.0, 290], [350, 290], [350, 80], [110, 80]])
MEASURED = (4, 1)  # column and floor of the window that is measured
GRID = (17, 13)  # nodes of what the pointer reads


def homography_frame(
    u1: float, v1: float, u2: float, v2: float, u3: float, v3: float, u4: float, v4: float
) -> Frame:
    """Return the photograph with four spots, and the wall that they make.

    Parameters
    ----------
    u1, v1, u2, v2, u3, v3, u4, v4 : float
        Pixels that are taken for the wall's corners: bottom left, bottom right, top right, top
        left.

    Returns
    -------
    Frame
        The photograph, the straightened wall, the homography, and the size of a window.
    """
    corners = np.array([[u1, v1], [u2, v2], [u3, v3], [u4, v4]])
    try:
        H = homography_dlt(corners, _truth()[0])
    except DegenerateConfigurationError:  # of four corners there is no other reason
        why = Readout("No homography", "", "three corners lie on one line")
        return Frame((_photograph(corners, None), _nothing()), (why,))
    measured = apply_homography(_truth()[1], H)
    width, height = _extent(measured)
    readouts = (
        Readout("A window is wide", "", _metres(width), "m"),
        Readout("and high", "", _metres(height), "m"),
        Readout("It really has", "", "1.00 × 1.30", "m"),
        matrix("Homography", "H", H, (4, 4, 6)),
    )
    return Frame((_photograph(corners, H), _wall(H, width, height)), readouts)


def true_corners() -> Floats:
    """Return where the wall's corners are in the photograph, px, shape (4, 2)."""
    from data_generators import facade

    return facade.slanted_camera(SIZE).project(facade.in_space(facade.CORNERS))


@cache
def _truth() -> tuple[Floats, Floats]:
    """Return the wall's corners, m, and the corners of the measured window in the picture, px."""
    from data_generators import facade

    window = facade.in_space(facade.window(*MEASURED))
    return facade.CORNERS, facade.slanted_camera(SIZE).project(window)


@cache
def _picture() -> NDArray[np.uint8]:
    from data_generators import facade

    return facade.photograph(facade.slanted_camera(SIZE))


def _extent(corners: Floats) -> tuple[float, float]:
    """Return width and height of a window as it was measured: the means of opposite sides."""
    sides = np.linalg.norm(np.roll(corners, -1, axis=0) - corners, axis=1)
    return float(sides[::2].mean()), float(sides[1::2].mean())


def _metres(length: float) -> str:
    return f"{length:.2f}" if length < 100 else "more than 100"


def _photograph(corners: Floats, H: Floats | None) -> Picture:
    """Return the photograph with the four spots and, if there is a homography, a grid of metres."""
    grid = () if H is None else _metre_lines(H)
    handles = tuple(
        Handle((float(u), float(v)), ((f"u{i}", 0, 1, 0), (f"v{i}", 0, 0, 1)))
        for i, (u, v) in enumerate(corners, 1)
    )
    places = "; ".join(
        f"{name} ({u:.0f}, {v:.0f})" for name, (u, v) in zip(NAMES, corners.tolist(), strict=True)
    )
    return Picture(
        "The photograph: drag the spots to the wall's corners",
        f"A house at a slant, with spots at {places}.",
        SIZE,
        _picture(),
        lines=(Line(corners, "object", 2.0, closed=True), *grid),
        probes=() if H is None else _probes(H),
        pixels=True,
        handles=handles,
    )


def _metre_lines(H: Floats) -> tuple[Line, ...]:
    """Return the lines of every second metre on the wall, in the photograph."""
    (width, height), back = _size(), np.linalg.inv(H)
    strokes = [[(x, 0.0), (x, height)] for x in np.arange(2, width, 2)]
    strokes += [[(0.0, y), (width, y)] for y in np.arange(2, height, 2)]
    ends = apply_homography(np.array(strokes).reshape(-1, 2), back).reshape(-1, 2, 2)
    pens = np.full((len(ends), 1, 2), np.nan)
    return (Line(np.concatenate([ends, pens], axis=1).reshape(-1, 2), "camera", 1.0),)


def _size() -> tuple[float, float]:
    from data_generators import facade

    return facade.WALL


def _probes(H: Floats) -> tuple[Probe, Probe]:
    """Return what the pointer reads: metres to the right and up on the wall."""
    u, v = np.meshgrid(np.linspace(0, SIZE[0] - 1, GRID[0]), np.linspace(0, SIZE[1] - 1, GRID[1]))
    flat = np.stack([u.ravel(), v.ravel()], axis=1)
    w = np.column_stack([flat, np.ones(len(flat))]) @ H[2]
    places = apply_homography(flat, H)
    front = np.sign(np.median(w))
    places[(w * front <= 0) | (np.abs(places) > 99).any(axis=1)] = np.nan
    right, up = places.T.reshape(2, GRID[1], GRID[0])
    return Probe("right", "m", right, 1), Probe("up", "m", up, 1)


def _wall(H: Floats, width: float, height: float) -> Picture:
    """Return the photograph, straightened: each pixel of the wall looks up its colour."""
    import cv2

    wide, high = _size()
    columns, rows = 2 * round(wide * SCALE / 2), 2 * round(high * SCALE / 2)
    # From a pixel of the straightened picture to the wall in metres, and on to the photograph.
    metres = np.array([[1 / SCALE, 0, 0.5 / SCALE], [0, -1 / SCALE, high - 0.5 / SCALE], [0, 0, 1]])
    backward = np.linalg.inv(H) @ metres
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    size, beyond = (columns, rows), (235,) * 3
    straight = cv2.warpPerspective(_picture(), backward, size, flags=flags, borderValue=beyond)
    column, floor = MEASURED
    seen = apply_homography(_truth()[1], np.linalg.inv(metres) @ H)
    return Picture(
        "The wall, straightened",
        f"The wall as these corners straighten it, {wide:g} m × {high:g} m. Window {column + 1} of "
        f"floor {floor + 1} measures {_metres(width)} m × {_metres(height)} m.",
        size,
        np.ascontiguousarray(straight),
        lines=(Line(seen, "second", 2.0, closed=True),),
    )


def _nothing() -> Picture:
    """Return an empty wall."""
    words = "These corners make no homography."
    return Picture(
        "The wall, straightened",
        words,
        (408, 278),
        labels=(Label(words, (204, 139), anchor="middle"),),
    )
