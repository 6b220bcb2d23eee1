"""Inputs for the exercises of chapter 02; nearly all with the answer known by construction."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from course_lib.judging import Known

Floats = NDArray[np.float64]


def away_from_zero(rng: Generator, least: float, most: float, size: Any = None) -> Any:
    """Draw numbers whose size is between two bounds, of either sign."""
    return rng.uniform(least, most, size) * rng.choice([-1, 1], size)


def any_rotation(rng: Generator) -> Floats:
    """Draw a rotation that is far from the identity and from its own transpose."""
    while True:
        Q, upper = np.linalg.qr(rng.normal(size=(3, 3)))
        Q = Q * np.sign(np.diag(upper))
        R = Q * np.sign(np.linalg.det(Q))
        asymmetry = np.abs(R - R.T)[np.triu_indices(3, 1)]
        if asymmetry.min() > 0.2 and np.abs(R).max() < 0.95 and np.abs(R).min() > 0.05:
            return np.asarray(R)


# --- points of the plane and of space ---------------------------------------------------------


def rows_of(rng: Generator, count: int, dimension: int) -> Known:
    points = away_from_zero(rng, 2, 50, (count, dimension))
    return Known({"points": points}, np.column_stack([points, np.ones(count)]))


def plane_points(rng: Generator) -> Known:
    return rows_of(rng, 5, 2)


def space_points(rng: Generator) -> Known:
    return rows_of(rng, 5, 3)


def a_single_point(rng: Generator) -> Known:
    many = rows_of(rng, 5, 2)
    return Known({"points": many.inputs["points"][0]}, many.truth[0])


def scaled(rng: Generator, dimension: int) -> Known:
    """Make homogeneous points from ordinary ones, with a w of its own for each."""
    points = away_from_zero(rng, 2, 50, (5, dimension))
    w = away_from_zero(rng, 0.3, 6, (5, 1))
    return Known({"points": np.hstack([w * points, w])}, points)


def scaled_plane_points(rng: Generator) -> Known:
    return scaled(rng, 2)


def scaled_space_points(rng: Generator) -> Known:
    return scaled(rng, 3)


def scaled_point(rng: Generator) -> Known:
    many = scaled(rng, 2)
    return Known({"points": many.inputs["points"][0]}, many.truth[0])


def some_at_infinity(rng: Generator) -> Known:
    many = scaled(rng, 2)
    points, truth = many.inputs["points"].copy(), many.truth.copy()
    points[[1, 3], 2] = 0
    truth[[1, 3]] = np.nan
    return Known({"points": points}, truth)


# --- lines of the plane: (cos a, sin a, -d) is at the distance d from the origin --------------


def slanted(rng: Generator) -> float:
    """Draw the direction of a line's normal, far from both axes and both diagonals."""
    return float(rng.choice([0, np.pi / 2, np.pi, -np.pi / 2]) + rng.uniform(0.2, 0.6))


def on_line(angle: float, distance: float, along: float, w: float) -> Floats:
    """Return a homogeneous point of a line."""
    normal = np.array([np.cos(angle), np.sin(angle)])
    tangent = np.array([-normal[1], normal[0]])
    return w * np.append(distance * normal + along * tangent, 1)


def line_from(rng: Generator, w: tuple[float, float]) -> Known:
    angle, d = slanted(rng), rng.uniform(3, 20)
    along = rng.uniform(1, 9), -rng.uniform(1, 9)
    p, q = (on_line(angle, d, a, b) for a, b in zip(along, w, strict=True))
    return Known({"p": p, "q": q}, np.array([np.cos(angle), np.sin(angle), -d]))


def slanted_line(rng: Generator) -> Known:
    return line_from(rng, (1, 1))


def points_of_any_w(rng: Generator) -> Known:
    return line_from(rng, (rng.uniform(0.4, 0.8), -rng.uniform(1.5, 3)))


def vertical_line(rng: Generator) -> Known:
    """Make two points with exactly the same x."""
    x = away_from_zero(rng, 2, 9)
    p, q = (np.array([x, y, 1]) for y in (rng.uniform(1, 4), -rng.uniform(1, 4)))
    return Known({"p": p, "q": q}, np.array([1.0, 0.0, -x]))


def line_to_infinity(rng: Generator) -> Known:
    """Make a point, and a point at infinity: a direction to go from it."""
    angle, d = slanted(rng), rng.uniform(3, 20)
    q = away_from_zero(rng, 0.5, 3) * np.array([-np.sin(angle), np.cos(angle), 0])
    p = on_line(angle, d, rng.uniform(1, 9), rng.uniform(2, 4))
    return Known({"p": p, "q": q}, np.array([np.cos(angle), np.sin(angle), -d]))


def stacked(several: list[Known]) -> Known:
    """Put the inputs of several cases into rows."""
    names = several[0].inputs
    rows = {name: np.array([one.inputs[name] for one in several]) for name in names}
    return Known(rows, np.array([one.truth for one in several]))


def several_lines(rng: Generator) -> Known:
    return stacked([slanted_line(rng) for _ in range(4)])


def two_lines(rng: Generator) -> Known:
    x, y = away_from_zero(rng, 2, 9), away_from_zero(rng, 12, 20)
    first = slanted(rng)
    angles = first, first + rng.uniform(0.7, 1.2)
    normals = [np.array([np.cos(a), np.sin(a)]) for a in angles]
    scales = away_from_zero(rng, 0.5, 4, 2)
    lines = [s * np.append(n, -n @ (x, y)) for s, n in zip(scales, normals, strict=True)]
    return Known({"l": lines[0], "m": lines[1]}, np.array([x, y, 1]))


def parallel_lines(rng: Generator) -> Known:
    """Make two lines of one direction, whose normals are whole multiples of each other."""
    normal = np.array([rng.integers(1, 5), -rng.integers(5, 9)], dtype=float)
    l, m = np.append(normal, rng.uniform(1, 5)), np.append(-2 * normal, rng.uniform(20, 30))  # noqa: E741
    return Known({"l": l, "m": m}, np.array([-normal[1], normal[0], 0]))


def several_meetings(rng: Generator) -> Known:
    return stacked([two_lines(rng) for _ in range(4)])


# --- rotations --------------------------------------------------------------------------------


def turn(axis: Floats, angle: float, length: float) -> Known:
    """Turn about z in a frame whose z is the axis, to know the answer without a formula for it."""
    axis = axis / np.linalg.norm(axis)
    x = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    x /= np.linalg.norm(x)
    frame = np.column_stack([x, np.cross(axis, x), axis])
    c, s = np.cos(angle), np.sin(angle)
    about_z = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    return Known({"axis": length * axis, "angle": angle}, frame @ about_z @ frame.T)


def some_angle(rng: Generator) -> float:
    return float(away_from_zero(rng, 0.4, 2.6))


def about_a_coordinate_axis(rng: Generator) -> Known:
    return turn(np.eye(3)[rng.integers(3)], some_angle(rng), 1)


def about_a_unit_axis(rng: Generator) -> Known:
    return turn(away_from_zero(rng, 0.3, 1, 3), some_angle(rng), 1)


def about_a_long_axis(rng: Generator) -> Known:
    return turn(away_from_zero(rng, 0.3, 1, 3), some_angle(rng), float(rng.choice([0.5, 1.6])))
