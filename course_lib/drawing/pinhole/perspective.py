"""Still figures: what a pinhole does to sizes, distances and parallel lines."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.camera import project_pinhole
from course_lib.drawing.diagrams import (
    Floats,
    figure,
    fit,
    panels,
    picture_frame,
    same_shape,
    sketch,
    stroke,
    write,
)
from course_lib.drawing.style import BLACK, FULL_WIDTH, GREEN, GREY, LIGHT, ORANGE, RED, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

GABLE = [(-3, 1.5), (3, 1.5), (3, -2.5), (0, -5), (-3, -2.5)]  # X, Y in m, y down
HOUSE_EDGES = [(i, (i + 1) % 5) for i in range(5)]
HOUSE_EDGES += [(i + 5, j + 5) for i, j in HOUSE_EDGES] + [(i, i + 5) for i in range(5)]
HOUSE_FACES = [tuple(range(5)), tuple(range(5, 10))]
HOUSE_FACES += [(i, j, j + 5, i + 5) for i, j in HOUSE_EDGES[:5]]


def house(X: float = 4.0, Z: float = 20.0, depth: float = 9.0) -> Floats:
    """Return the ten corners of a house in the camera frame.

    Parameters
    ----------
    X, Z : float
        Middle of its front, m.
    depth : float
        Length of the house along the optical axis, m.

    Returns
    -------
    ndarray, shape (10, 3)
        Five corners of the front, then those of the back, m; the ground is 1.5 m below the hole.
    """
    return np.array([(x + X, y, z) for z in (Z, Z + depth) for x, y in GABLE])


@figure(
    "The ten corners of a house in a picture of 640 × 480 px, for f = {f} px: circles by the "
    "course's function, filled points and lines by yours once it answers."
)
def house_picture(
    points: ArrayLike,
    f: float = 800.0,
    c: tuple[float, float] = (319.5, 239.5),
    yours: ArrayLike | None = None,
) -> Figure:
    """Draw the picture of a house from its projected corners.

    Parameters
    ----------
    points : array_like, shape (10, 3)
        From `house`, camera frame, m.
    f, c : float and (float, float)
        Focal length and principal point, px.
    yours : array_like, shape (10, 2), optional
        Pixels that a student's function gave for the same points.

    Returns
    -------
    Figure
        A picture of 640 × 480 px: open circles by the course, filled ones by the student. The
        edges that the house itself hides are dashed.
    """
    pixels = project_pinhole(points, f, c)
    fig, ax = panels(1, 1, (6.4, 4.8))
    picture_frame(ax, (640, 480))
    ax.plot(*pixels.T, "o", mfc="none", mec=BLACK, ms=11, mew=1.5, label="the course's function")
    drawn = same_shape(yours, pixels)
    if drawn is not None:
        seen = _seen_edges(np.asarray(points, dtype=float))
        for edge in HOUSE_EDGES:
            dashes = {"zorder": 3} if edge in seen else {"ls": (0, (4, 3)), "lw": 1.2}
            stroke(ax, drawn[list(edge)], "second", **dashes)
        for face in _seen_faces(np.asarray(points, dtype=float)):
            alpha = 0.25 if face == HOUSE_FACES[0] else 0.45  # the side wall lies in the shade
            ax.fill(*drawn[list(face)].T, color=ROLES["second"], alpha=alpha, lw=0)
        ax.plot(*drawn.T, "o", color=ROLES["second"], ms=6, label="your function")
    ax.plot(*c, "+", color=GREY, ms=12, label="principal point")
    ax.legend(loc="lower left")
    return fig


def _seen_faces(points: Floats) -> list[tuple[int, ...]]:
    """Return the faces whose outside is turned to the hole."""
    middle = points.mean(axis=0)
    faces = []
    for face in HOUSE_FACES:
        corner = points[list(face)]
        normal = np.cross(corner[1] - corner[0], corner[2] - corner[1])
        if (normal @ corner[0]) * (normal @ (corner[0] - middle)) < 0:  # the hole is at 0
            faces.append(face)
    return faces


def _seen_edges(points: Floats) -> set[tuple[int, int]]:
    """Return the edges of the faces whose outside is turned to the hole."""
    faces = [set(face) for face in _seen_faces(points)]
    return {edge for edge in HOUSE_EDGES if any(set(edge) <= face for face in faces)}


@figure(
    "Height in the picture against distance, for a person of {height:g} m and f = {f:g} px: "
    "the curve falls, and at twice the distance the height is half."
)
def size_against_distance(f: float = 800.0, height: float = 1.8, marked: float = 5.0) -> Figure:
    """Show how the height of a person in the picture falls with the distance.

    Parameters
    ----------
    f, height, marked : float
        Focal length in px, height of the person and one distance to mark, m.

    Returns
    -------
    Figure
        Height in px against distance in m; the marks are at 1, 2 and 4 times `marked`.
    """
    Z = np.linspace(2, 45, 300)
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.2))
    ax.plot(Z, f * height / Z, color=ROLES["image"])
    for distance in marked * np.array([1, 2, 4]):
        size = f * height / distance
        stroke(ax, [(distance, 0), (distance, size)], "object", lw=6, solid_capstyle="butt")
        write(ax, (distance + 0.7, size + 14), f"{distance:g} m: {size:.0f} px", ha="left")
    ax.set(xlabel="distance Z (m)", ylabel="height in the picture (px)", xlim=(0, 45), ylim=0)
    return fig


@figure(
    "Five equal steps of {step:g} m on the ground, from the side and in the picture: the "
    "farther away a step is, the flatter it is in the picture."
)
def foreshortening(f: float = 800.0, height: float = 1.5, step: float = 2.0) -> Figure:
    """Show why equal steps on the ground are unequal steps in the picture.

    Parameters
    ----------
    f : float
        Focal length, px.
    height, step : float
        Height of the hole above the ground and length of a step, m.

    Returns
    -------
    Figure
        Side view with a ray to the end of each step, and the picture of the steps with their
        heights, px.
    """
    Z = 5 + step * np.arange(6, dtype=np.float64)
    fig, (side, picture) = panels(1, 2, (FULL_WIDTH, 3.4), width_ratios=(1.7, 1))
    sketch(side, "From the side").set_aspect("auto")
    _steps_from_the_side(side, Z, height)
    picture.set_title("In the picture, lower half")
    for k, (near, far) in enumerate(pairwise(Z)):
        road = [(-2, height, near), (2, height, near), (2, height, far), (-2, height, far)]
        tile = project_pinhole(road, f, (319.5, 239.5))
        picture.fill(*tile.T, color=(ORANGE, LIGHT)[k % 2], lw=0)
        edge, high = tile[1:3].mean(axis=0), tile[0, 1] - tile[2, 1]
        write(picture, (edge[0] + 30, edge[1]), f"{high:.0f} px", ha="left", fontsize=8)
    picture.axhline(239.5, color=GREY, lw=1.5, ls=(0, (8, 4)))
    write(picture, (319.5, 222), "horizon", "guide")
    picture.set(xlim=(-0.5, 639.5), ylim=(479.5, 200), xlabel="u (px)", ylabel="v (px)")
    return fig


def _steps_from_the_side(ax: Axes, Z: Floats, height: float) -> None:
    """Draw the hole, an image plane and rays to equal steps on the ground."""
    plane = 0.6 * Z[0]
    for k, (near, far) in enumerate(pairwise(Z)):
        ground, image = -height - 0.15, -plane * height / np.array([near, far])
        ax.fill_between([near, far], ground, -height, color=(ORANGE, LIGHT)[k % 2], lw=0)
        stroke(ax, [(0, 0), (far, -height)], "ray", lw=1)
        stroke(ax, [(plane, image[0]), (plane, image[1])], color=(ORANGE, GREY)[k % 2], lw=5)
    stroke(ax, [(0, 0), (Z[0], -height)], "ray", lw=1)
    stroke(ax, [(0, 0), (Z[-1], 0)], "guide", lw=1.5, ls=(0, (8, 4)))
    stroke(ax, [(plane, -1.3), (plane, 0.5)], "image", lw=1)
    ax.plot(0, 0, "o", color=BLACK, ms=8)
    write(ax, (0, 0.25), "hole", va="bottom")
    write(ax, (plane, 0.6), "image plane", "image", va="bottom")
    write(ax, (Z.mean(), -height - 0.4), "equal steps on the ground", va="top")
    fit(ax, -0.8, Z[-1] + 0.3, -height - 0.7, 0.9)


@figure(
    "From above: rays from the hole to points farther and farther along a line turn until "
    "they are parallel to it. The parallel ray cuts the image plane in the vanishing point."
)
def one_line_runs_away(direction: Sequence[float] = (0.45, 1.0), f: float = 2.0) -> Figure:
    """Show why the image of a line ends in a vanishing point: points that run away along it.

    Parameters
    ----------
    direction : sequence of float
        Direction (X, Z) of the line; seen from above.
    f : float
        Focal length.

    Returns
    -------
    Figure
        Top view: rays to points farther and farther along the line turn towards its direction.
    """
    d = np.array(direction[::-1], float) / np.linalg.norm(direction)  # drawn as (Z, X)
    start = np.array([3.0, -0.4])
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.2))
    sketch(ax)
    stroke(ax, [start, start + 8 * d], "object")
    for along in (0.0, 1.0, 2.5, 5.0, 8.0):
        point = start + along * d
        stroke(ax, np.array([(0, 0), point]), "ray", lw=1)
        ax.plot(*point, "o", color=RED, ms=7)
        ax.plot(f, f * point[1] / point[0], "o", color=GREEN, ms=6)
    stroke(ax, np.array([(0, 0), 8.3 * d]), "guide", lw=1.5, ls=(0, (6, 3)))
    end = np.array([f, f * d[1] / d[0]])
    stroke(ax, [(f, -0.9), (f, end[1] + 0.7)], "image", lw=2)
    ax.plot(*end, "*", color=ROLES["second"], ms=16, zorder=5)
    ax.plot(0, 0, "o", color=BLACK, ms=8)
    write(ax, (0, -0.25), "hole", va="top")
    write(ax, end - np.array([0.2, -0.1]), "vanishing point", ha="right", va="bottom")
    write(ax, start + 8 * d + np.array([0.15, 0]), "a line with direction d", "object", ha="left")
    fit(ax, -0.5, start[0] + 8 * d[0] + 3.0, -1.2, 8.5 * d[1])
    return fig
