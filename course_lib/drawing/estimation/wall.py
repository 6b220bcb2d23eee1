"""Still figures of walls: a photograph at a slant, straightened by a homography, and measured."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.diagrams import Floats, figure, panels, picture_frame, same_shape, write
from course_lib.drawing.style import BLACK, FULL_WIDTH, ROLES
from course_lib.homogeneous import apply_homography

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# Read off the photograph by hand: where the left edge of a panel meets the slab below it, floor by
# floor from the lowest, px.
FLOORS = (
    "193.3 365.2  224.6 356.5  261.0 344.5  303.0 331.4  353.2 315.0  411.2 297.5  481.0 277.5  "
    "562.9 251.0  662.1 219.6  788.9 182.0",
    "192.7 306.3  224.0 291.3  261.0 277.0  303.0 258.3  352.2 237.3  410.2 212.3  479.2 183.4  "
    "556.8 152.9  655.0 110.0  778.2 60.0",
    "193.3 244.2  224.0 228.0  261.0 210.0  302.4 187.8  350.7 162.7  408.7 130.8  477.0 93.0  "
    "553.2 53.5",
    "194.9 187.8  225.3 166.8  261.0 145.8  302.4 117.6",
)


class Wall(NamedTuple):
    """A photograph of a wall, and points on it.

    Attributes
    ----------
    picture : ndarray, shape (height, width, 3), uint8
        RGB.
    pixels : ndarray, shape (N, 2)
        Where the points are in the photograph.
    places : ndarray, shape (N, 2)
        Where they are on the wall: bays to the right, floors up.
    """

    picture: NDArray[np.uint8]
    pixels: Floats
    places: Floats


def building(path: Path) -> Wall:
    """Return the photograph of a building and the 32 points that were read off it.

    Parameters
    ----------
    path : pathlib.Path
        Of ``opencv_stereo/building.jpg``.

    Returns
    -------
    Wall
        The picture and its points.
    """
    import cv2

    picture = cv2.imread(str(path), cv2.IMREAD_COLOR_RGB)
    pixels = [np.array(floor.split(), dtype=float).reshape(-1, 2) for floor in FLOORS]
    places = [(k, up) for up, floor in enumerate(pixels) for k in range(len(floor))]
    return Wall(np.asarray(picture, np.uint8), np.concatenate(pixels), np.array(places, float))


def rendered_building() -> Wall:
    """Return a computed wall with the corners of its windows, for when there is no network.

    Returns
    -------
    Wall
        The picture, and the bottom-left corners of 17 windows and a door, good to half a pixel.
    """
    from data_generators import cell, facade

    camera = facade.slanted_camera((864, 600))
    places = np.array([(k, floor) for floor in range(3) for k in range(6)], float)
    corners = np.array([facade.window(int(k), int(floor))[0] for k, floor in places])
    exact = camera.project(facade.in_space(corners))
    pixels = cell.observed(exact, 0.5, np.random.default_rng(2))
    return Wall(facade.photograph(camera), pixels, places)


def outer_four(wall: Wall) -> NDArray[np.intp]:
    """Return the numbers of four points that span a wall as widely as its points allow.

    Parameters
    ----------
    wall : Wall
        With its points.

    Returns
    -------
    ndarray, shape (4,)
        The ends of the lowest floor and of the highest floor that is as long.
    """
    right, up = wall.places.T
    widest = right.max()
    top = up[right == widest].max()
    ends = [(0, 0), (widest, 0), (widest, top), (0, top)]
    return np.array([int(np.flatnonzero((right == a) & (up == b))[0]) for a, b in ends])


@figure("A wall at a slant with the points that are used, and the same wall straightened.")
def straightened(wall: Wall, H: ArrayLike | None, used: ArrayLike | None = None) -> Figure:
    """Show a wall, and what a homography makes of it.

    Parameters
    ----------
    wall : Wall
        Photograph and points.
    H : array_like, shape (3, 3), optional
        From pixels to bays and floors.
    used : array_like of int, optional
        Which points made `H`; all of them unless told otherwise.

    Returns
    -------
    Figure
        The photograph, and the straightened wall with a grid of bays and floors.
    """
    fig, (left, right) = panels(1, 2, (FULL_WIDTH, 2.9), width_ratios=(1, 1.6))
    height, width = wall.picture.shape[:2]
    left.imshow(wall.picture)
    picture_frame(left, (width, height))
    chosen = np.arange(len(wall.pixels)) if used is None else np.asarray(used)
    left.plot(*wall.pixels.T, ".", color=ROLES["ray"], ms=4)
    look = {"mfc": "none", "mec": ROLES["object"], "mew": 2}
    left.plot(*wall.pixels[chosen].T, "o", ms=8, **look)
    left.set_title(f"{len(chosen)} points")
    drawn = _usable(H)
    if drawn is None:
        right.axis("off")
        write(right, (0.5, 0.5), "no homography yet", "guide")
        return fig
    _straight(right, wall, drawn, chosen)
    return fig


def through(points: ArrayLike, H: ArrayLike | None) -> Floats | None:
    """Return points after a student's homography; None if it is not one.

    Parameters
    ----------
    points : array_like, shape (N, 2)
        Points of the plane.
    H : array_like, shape (3, 3), optional
        Whatever a student's function gave.

    Returns
    -------
    ndarray, shape (N, 2), or None
        Where they go.
    """
    usable = _usable(H)
    return None if usable is None else apply_homography(points, usable)


def _usable(H: ArrayLike | None) -> Floats | None:
    """Return H as an array if it maps the plane to a plane, whatever a student's function gave."""
    drawn = same_shape(H, np.zeros((3, 3)))
    if drawn is None:
        return None
    try:
        apply_homography((0, 0), drawn)
    except ValueError:
        return None
    return drawn


def _straight(ax: Axes, wall: Wall, H: Floats, used: NDArray[np.intp]) -> None:
    """Draw the straightened wall, half a bay wider than its points, with its grid."""
    import cv2

    low = wall.places.min(axis=0) - np.array([1.0, 0.8])
    high = wall.places.max(axis=0) + np.array([0.9, 1.0])
    scale = 640 / (high - low)[0]
    columns, rows = np.rint((high - low) * scale).astype(int).tolist()
    bays = np.array([[1 / scale, 0, low[0]], [0, -1 / scale, high[1]], [0, 0, 1]])
    flags = cv2.INTER_AREA | cv2.WARP_INVERSE_MAP
    backward = np.linalg.inv(H) @ bays
    straight = cv2.warpPerspective(wall.picture, backward, (columns, rows), flags=flags)
    ax.imshow(straight, extent=(low[0], high[0], low[1], high[1]), aspect="equal")
    for k in range(int(wall.places[:, 0].max()) + 1):
        ax.axvline(k, color=ROLES["camera"], lw=0.8)
    for k in range(int(wall.places[:, 1].max()) + 1):
        ax.axhline(k, color=ROLES["camera"], lw=0.8)
    ax.plot(*apply_homography(wall.pixels, H).T, ".", color=ROLES["ray"], ms=5)
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    ax.set(xlabel="to the right (bays)", ylabel="up (floors)")
    left = apply_homography(wall.pixels, H) - wall.places
    others = np.delete(left, used, axis=0)
    which, left = ("the others", others) if len(others) else ("all", left)
    rms = np.sqrt((left**2).sum(axis=1).mean())
    ax.set_title(f"{which} are off by {rms:.3f} bays (RMS)", color=BLACK)
