"""Join and meet: two lines, the point in which they meet, and the rays behind both."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera import Camera, camera_at
from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout
from course_lib.homogeneous import meet

Floats = NDArray[np.float64]

PLANE_SIZE = (400, 340)
SPACE_SIZE = (440, 340)
REACH = np.array([5.5, 4.6])  # how much of the plane the first picture shows, to each side
SCALE = 36.0  # px a unit
ORIGIN = (np.array(PLANE_SIZE) - 1) / 2
SHEET = np.array([[-2.4, -1.8], [2.4, -1.8], [2.4, 1.8], [-2.4, 1.8]])  # drawn of the plane w = 1
NUMBER = 49  # points of a circle
NAME_OF_ORIGIN = np.array([-52.0, 50.0])  # px: a thin line leads to it, clear of the sphere
RADIUS = 0.85  # of the sphere: any does, as only directions count
REACH_OF_RAY = 2.6  # how far the ray of the meeting point is drawn, in radii
WORLD_FROM_HOMOGENEOUS = np.array([[0.0, 0, 1], [-1, 0, 0], [0, 1, 0]])  # w forward, y up


def join_meet_frame(p: float, q: float, r: float, s: float) -> Frame:
    """Return two lines, their meeting point, and what they are in homogeneous coordinates.

    Parameters
    ----------
    p, q : float
        Slope and height of the first line, ``y = p x + q``.
    r, s : float
        Slope and height of the second line, ``y = r x + s``.

    Returns
    -------
    Frame
        The plane, the rays and planes of space that stand for its points and lines, and vectors.
    """
    lines = np.array([[p, -1.0, q], [r, -1.0, s]])
    same = bool((lines[0] == lines[1]).all())
    point = np.zeros(3) if same else meet(lines[0], lines[1]) + 0.0
    words = _words(point)
    readouts = (
        Readout("Line l", "", _vector(lines[0])),
        Readout("Line m", "", _vector(lines[1])),
        Readout("They meet in", "l × m", _vector(point)),
        Readout("In the plane", "(x, y)", words),
    )
    return Frame((_plane(lines, point, words), _space(lines, point, words)), readouts)


def _vector(v: Floats) -> str:
    """Return three numbers as text, never -0."""
    return "({})".format(", ".join(f"{round(x, 2) + 0.0:g}" for x in v.tolist()))


def _words(point: Floats) -> str:
    """Say where a homogeneous point is."""
    if not point.any():
        return "everywhere: it is one line"
    if point[2] == 0:
        return f"at infinity, direction ({point[0]:.3g}, {point[1]:.3g})"
    x, y = (point[:2] / point[2]).round(2) + 0.0  # never -0
    return f"({x:.2f}, {y:.2f})"


# The plane


def _plane(lines: Floats, point: Floats, words: str) -> Picture:
    """Return the plane with both lines; an arrow shows the way to a point that is outside."""
    x = np.array([-1.0, 1.0]) * (REACH[0] + 1)
    strokes = [
        Line(_on_page(np.stack([x, slope * x + height], 1)), role, 2.5)
        for (slope, _, height), role in zip(lines, ("camera", "image"), strict=True)
    ]
    labels = [
        Label(f"line {name}", _pair(_on_page(_name_place(line, side))), role, "middle")
        for line, name, role, side in zip(lines, "lm", ("camera", "image"), (-1, 1), strict=True)
    ]
    if _outside(point):  # a point at infinity lies in both directions
        strokes += [_arrow(point)] if point[2] else [_arrow(point), _arrow(-point)]
    elif point[2]:
        strokes += [_dot(point)]
    return Picture(
        "The plane",
        f"Two lines in a plane, {_slope(lines[0])} and {_slope(lines[1])}. They meet {words}.",
        PLANE_SIZE,
        lines=(*_axes(), *strokes),
        labels=(*labels, Label("x", (PLANE_SIZE[0] - 12, ORIGIN[1] + 12)), Label("y", (210, 10))),
    )


def _slope(line: Floats) -> str:
    return f"of slope {line[0]:g}"


def _outside(point: Floats) -> bool:
    """Return whether the meeting point is not on the page, or at infinity."""
    return bool(point.any() and (np.abs(point[:2]) > np.abs(point[2]) * REACH).any())


def _name_place(line: Floats, side: int) -> Floats:
    """Return where a line's name stands: above its left end (-1), below its right end (1)."""
    slope, _, height = line.tolist()
    x, top = side * (REACH[0] - 0.6), REACH[1] - 0.8
    y = float(np.clip(slope * x + height, -top, top))
    if slope:
        x = float(np.clip((y - height) / slope, -abs(x), abs(x)))
    return np.array([x, np.clip(y - side * (0.35 + 0.3 * abs(slope)), -REACH[1], REACH[1])])


def _arrow(point: Floats) -> Line:
    """Return an arrow at the edge of the page, towards a point that is not on it."""
    way = point[:2] * (np.sign(point[2]) or 1.0)
    way = way / np.linalg.norm(way)
    # As far from the middle as the page allows.
    far = np.min((REACH - 0.4) / np.maximum(np.abs(way), 1e-9))
    tip, across = far * way, np.array([-way[1], way[0]])
    points = [tip - 1.6 * way, tip, tip - 0.45 * way + 0.25 * across, tip]
    points += [tip - 0.45 * way - 0.25 * across]
    return Line(_on_page(np.array(points)), "object", 3.0)


def _dot(point: Floats) -> Line:
    turn = np.linspace(0, 2 * np.pi, 17)[:-1]
    circle = 0.16 * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    return Line(_on_page(point[:2] / point[2] + circle), "object", 2.0, closed=True, fill=1.0)


def _axes() -> tuple[Line, ...]:
    (a, b), nan = REACH, [np.nan, np.nan]
    cross = np.array([[-a, 0], [a, 0], nan, [0, -b], [0, b]])
    return (Line(_on_page(cross), "guide", 1.0),)


def _on_page(points: Floats) -> Floats:
    """Return pixels from (x, y); y is up, as in school."""
    return ORIGIN + SCALE * points * [1, -1]


# The space behind it


def _space(lines: Floats, point: Floats, words: str) -> Picture:
    """Return the plane w = 1 in space, and the planes and the ray that stand for lines and point.

    Every ray meets a sphere around the origin twice; the sphere is the whole projective plane.
    """
    strokes: list[Line] = []
    for line, role in zip(lines, ("camera", "image"), strict=True):
        ends = _on_sheet(line)
        if len(ends):
            fan = np.vstack([[0.0, 0, 0], ends])
            strokes.append(Line(_seen(fan), role, 0.0, closed=True, fill=0.18))
        strokes += [
            Line(_seen(RADIUS * _great_circle(line)), role, 2.2),
            Line(_seen(ends), role, 2.2),
        ]
    return Picture(
        "The rays behind it",
        "The same in space: each line of the plane w = 1 is a plane through the origin and a "
        f"circle on a sphere. Planes and circles share the ray of the meeting point: {words}.",
        SPACE_SIZE,
        lines=(*_still_life(), *strokes, *_ray(point)),
        labels=(*_names(), *_letters(lines)),
    )


def _letters(lines: Floats) -> tuple[Label, ...]:
    """Return the names of the lines beside their right ends on the sheet."""
    named = zip(lines, "lm", ("camera", "image"), strict=True)
    ends = ((_on_sheet(line), name, role) for line, name, role in named)
    return tuple(
        Label(name, _pair(_seen(end[1]) + np.array([8.0, 0.0])), role)
        for end, name, role in ends
        if len(end)
    )


def _ray(point: Floats) -> tuple[Line, ...]:
    """Return the line through the origin that is the meeting point, and where it cuts."""
    if not point.any():
        return ()
    d = RADIUS * point / np.linalg.norm(point)
    strokes = [
        Line(_seen(np.array([-REACH_OF_RAY * d, REACH_OF_RAY * d])), "object", 2.5, dashed=True)
    ]
    cuts = [d, -d]
    if point[2] and (np.abs(point[:2] / point[2]) <= SHEET[2]).all():
        cuts.append(point / point[2])
        strokes.append(Line(_seen(np.array([0 * d, cuts[-1]])), "object", 2.0, dashed=True))
    return (*strokes, *(_mark(cut) for cut in cuts))


def _mark(point: Floats) -> Line:
    """Return a spot on a point of space."""
    turn = np.linspace(0, 2 * np.pi, 13)[:-1]
    circle = _seen(point) + 4 * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    return Line(circle, "object", 1.5, closed=True, fill=1.0)


def _great_circle(normal: Floats) -> Floats:
    """Return the unit vectors at right angles to a normal, shape (NUMBER, 3)."""
    n = normal / np.linalg.norm(normal)
    first = np.cross(n, np.eye(3)[np.argmin(np.abs(n))])
    first = first / np.linalg.norm(first)
    turn = np.linspace(0, 2 * np.pi, NUMBER)[:, None]
    return np.asarray(np.cos(turn) * first + np.sin(turn) * np.cross(n, first))


def _on_sheet(line: Floats) -> Floats:
    """Return the ends of ``(slope, -1, height)`` on the drawn part of w = 1; none: shape (0, 3)."""
    slope, _, height = line.tolist()
    x, y = SHEET[2]
    low, high = -x, x
    if slope:
        ends = sorted(((-y - height) / slope, (y - height) / slope))
        low, high = max(low, ends[0]), min(high, ends[1])
    if low >= high or abs(slope * low + height) > y + 1e-9:
        return np.zeros((0, 3))
    return np.array([[end, slope * end + height, 1.0] for end in (low, high)])


def _seen(points: Floats) -> Floats:
    """Return the onlooker's image of (x, y, w): x to the right, y up, w away from the origin."""
    return _onlooker().project(points @ WORLD_FROM_HOMOGENEOUS.T)


@cache
def _onlooker() -> Camera:
    """Return the camera from behind the origin, to the right of it and above."""
    K = np.array([[760.0, 0, 200], [0, 760, 174], [0, 0, 1]])
    return camera_at((-5.6, -8.5, 5.6), (0.5, 0, 0), K, SPACE_SIZE)


@cache
def _still_life() -> tuple[Line, ...]:
    """Return what does not move: the sheet, the sphere and its equator."""
    eye = WORLD_FROM_HOMOGENEOUS.T @ _onlooker().centre / RADIUS
    sheet = np.column_stack([SHEET, np.ones(4)])
    # The outline of the unit sphere is the circle in which the eye's tangents touch it.
    square = float(eye @ eye)
    outline = _great_circle(eye) * np.sqrt(1 - 1 / square) + eye / square
    equator = RADIUS * _great_circle(np.array([0.0, 0, 1]))
    return (
        Line(_seen(sheet), "guide", 1.0, closed=True, fill=0.12),
        Line(_seen(RADIUS * outline), "guide", 1.0, closed=True, fill=0.1),
        Line(_seen(equator), "second", 2.8),
        _mark(np.zeros(3)),
        Line(_seen(np.zeros(3)) + np.array([[0.0, 0.0], NAME_OF_ORIGIN]), "ink", 0.8),
    )


@cache
def _names() -> tuple[Label, ...]:
    top = _seen(np.array([-1.4, 1.8, 1.0])) + np.array([12.0, -12.0])
    infinity = _seen(np.array([0.0, RADIUS, 0.0])) - np.array([28.0, 6.0])
    origin = _seen(np.zeros(3)) + NAME_OF_ORIGIN + np.array([-4.0, 0.0])
    return (
        Label("plane w = 1", _pair(top), "guide", "middle"),
        Label("origin", _pair(origin), "ink", "end"),
        Label("line at infinity", _pair(infinity), "second", "end"),
    )


def _pair(point: ArrayLike) -> tuple[float, float]:
    u, v = np.asarray(point, dtype=float)
    return float(u), float(v)
