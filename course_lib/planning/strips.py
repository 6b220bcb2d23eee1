"""A flight over a polygon: strips, pictures, and how often each place on the ground is seen.

Lengths are metres; the ground's x points east, y north, z up. Use these functions through
`course_lib.planning`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera import Camera
from course_lib.checks import Array, check_length, check_number, check_numbers, check_points
from course_lib.planning.catalogue import CameraModel, LensModel
from course_lib.planning.flight import base_for_overlap, height_for_resolution

#: Heights of the ground, from x and y.
Terrain = Callable[[Array, Array], Array]
ALONG_THE_RAY = np.linspace(0, 1, 65)[1:-1]  # shares of the way up where the ground may be in it


def flat(x: Array, y: Array) -> Array:
    """Return the heights of flat ground: zero."""
    return np.zeros(np.broadcast_shapes(np.shape(x), np.shape(y)))


@dataclass(frozen=True, eq=False)
class FlightPlan:
    """Where a camera that looks straight down takes pictures of an area.

    Attributes
    ----------
    polygon : ndarray, shape (N, 2)
        Corners of the area.
    K : ndarray, shape (3, 3)
        Intrinsics of the camera, px.
    image_size : tuple of int
        Its picture, px; the width lies across the strips.
    gsd, H : float
        Ground sampling distance, and height above the ground at height zero.
    base, distance : float
        From picture to picture, and from strip to strip.
    centres : ndarray, shape (P, 3)
        Where the pictures are taken, in the order of the flight.
    strips : ndarray of int, shape (P,)
        The strip of each.
    heading : float
        Direction of the strips, clockwise from north, rad.
    """

    polygon: Array
    K: Array
    image_size: tuple[int, int]
    gsd: float
    H: float
    base: float
    distance: float
    centres: Array
    strips: Array
    heading: float

    @property
    def length(self) -> float:
        """Length of the way from the first picture to the last, m."""
        return float(np.linalg.norm(np.diff(self.centres, axis=0), axis=1).sum())

    @cached_property
    def cameras(self) -> tuple[Camera, ...]:
        """The camera of each picture."""
        forward, right = _axes(self.heading)
        R = np.array([[*right, 0], [*-forward, 0], [0, 0, -1]])
        return tuple(Camera(self.K, R, -R @ C, self.image_size) for C in self.centres)

    def duration(self, speed: float, turn: float = 0.0) -> float:
        """Return how long the flight takes, s.

        Parameters
        ----------
        speed : float
            m/s.
        turn : float
            Time lost at the end of each strip, s.
        """
        turns = len(np.unique(self.strips)) - 1
        return self.length / check_length(speed, "speed") + turns * check_number(turn, "turn")

    def footprints(self, height: float = 0.0) -> Array:
        """Return what each picture covers on level ground, shape (P, 4, 2).

        Parameters
        ----------
        height : float
            Of the ground, m; below the camera.
        """
        if (above := self.H - check_number(height, "height")) <= 0:
            raise ValueError(f"the ground at {height:g} m is above the flight at {self.H:g} m")
        width, depth = self.image_size
        corners = np.array([[0, 0], [width, 0], [width, depth], [0, depth]]) - 0.5
        rays = (corners - self.K[:2, 2]) / np.diag(self.K)[:2]
        forward, right = _axes(self.heading)
        around = above * (rays[:, :1] * right - rays[:, 1:] * forward)
        return np.asarray(self.centres[:, None, :2] + around)


def plan_flight(
    polygon: ArrayLike,
    camera: CameraModel,
    lens: LensModel,
    gsd: float,
    forward: float = 0.8,
    side: float = 0.6,
    heading: float = 0.0,
) -> FlightPlan:
    """Return a flight in parallel strips that covers a polygon.

    Parameters
    ----------
    polygon : array_like, shape (N, 2)
        Corners of the area in order, N ≥ 3, m.
    camera, lens : CameraModel, LensModel
        What takes the pictures, the picture's width across the strips.
    gsd : float
        Ground sampling distance wanted at height zero, m.
    forward, side : float
        Overlap along a strip and between strips, from 0 to below 1.
    heading : float
        Direction of the strips, clockwise from north, rad.

    Returns
    -------
    FlightPlan
        Each strip begins and ends where the polygon has all been passed; the outer strips' pictures
        reach the polygon's sides. Neighbouring strips are flown in opposite directions.

    Raises
    ------
    TypeError, ValueError
        If the polygon has no area, or a number is out of its range.

    References
    ----------
    K. Kraus, Photogrammetry, 2nd ed., section 3.7 (planning a flight).
    """
    corners = check_polygon(polygon)
    H = float(height_for_resolution(check_length(gsd, "gsd"), lens.f_mm, camera.pitch_um))
    width, depth = (gsd * n for n in camera.image_size)
    base, distance = float(base_for_overlap(forward, depth)), float(base_for_overlap(side, width))
    heading = check_number(heading, "heading")
    turned = corners @ np.stack(_axes(heading), axis=1)  # along, across
    places, strips = _places(turned, base, distance, width)
    plan = places @ np.stack(_axes(heading))
    centres = np.column_stack([plan, np.full(len(plan), H)])
    K = camera.intrinsics(lens)
    return FlightPlan(
        corners, K, camera.image_size, gsd, H, base, distance, centres, strips, heading
    )


def views_of_ground(
    plan: FlightPlan, points: ArrayLike, terrain: Terrain = flat, numbers: ArrayLike | None = None
) -> NDArray[np.intp]:
    """Return how many pictures show places on the ground.

    Parameters
    ----------
    plan : FlightPlan
        The flight.
    points : array_like, shape (M, 2)
        Places, m.
    terrain : callable
        Heights from x and y, as arrays.
    numbers : array_like of int, optional
        Only these pictures.

    Returns
    -------
    ndarray of int, shape (M,)
        Pictures in which the place is inside of the frame and no ground stands before it: looked
        for at 63 points along each ray. 0 is hidden from all; 2 are the least for a height, and 3
        the least for one that is checked.

    Raises
    ------
    TypeError, ValueError
        If the points are no points, or the ground reaches up to the flight.
    """
    xy = check_points(points, 2, "points").reshape(-1, 2)
    ground = np.column_stack([xy, check_numbers(terrain(*xy.T), "terrain")])
    if (ground[:, 2] >= plan.H).any():
        raise ValueError("the ground reaches up to the flight: fly higher, or follow the terrain")
    chosen = range(len(plan.cameras)) if numbers is None else np.asarray(numbers)
    seen = np.zeros(len(xy), dtype=np.intp)
    for number in chosen:
        camera = plan.cameras[number]
        inside = np.flatnonzero(_inside(camera.project(ground), camera.image_size))
        seen[inside[_free(ground[inside], camera.centre, terrain)]] += 1
    return seen


def check_polygon(polygon: ArrayLike) -> Array:
    """Return the corners of a polygon that has an area, shape (N, 2)."""
    corners = check_points(polygon, 2, "polygon")
    if corners.ndim != 2 or len(corners) < 3:
        raise ValueError(f"polygon must have at least 3 corners, got shape {corners.shape}")
    x, y = (corners - corners.mean(axis=0)).T
    area = abs(float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)))) / 2
    if area <= 1e-9 * float(np.max(x**2 + y**2)):
        raise ValueError("polygon has no area: its corners lie on a line")
    return corners


def inside_polygon(points: Array, corners: Array) -> Array:
    """Return which points a polygon holds: to their right it is crossed an odd number of times."""
    x, y = points.T[..., None]
    (x1, y1), (x2, y2) = corners.T, np.roll(corners, -1, axis=0).T
    crosses = (y1 > y) != (y2 > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        where = x1 + (y - y1) * (x2 - x1) / (y2 - y1)
    return np.asarray((crosses & (x < where)).sum(axis=1) % 2 == 1)


def _axes(heading: float) -> tuple[Array, Array]:
    """Return the unit vectors forward and to the right, on the ground."""
    sine, cosine = np.sin(heading), np.cos(heading)
    return np.array([sine, cosine]), np.array([cosine, -sine])


def _places(turned: Array, base: float, distance: float, width: float) -> tuple[Array, Array]:
    """Return the pictures' places (along, across) and their strips, in the order of the flight."""
    low, high = turned[:, 1].min(), turned[:, 1].max()
    count = max(int(np.ceil((high - low - width) / distance - 1e-9)), 0) + 1
    lines = (low + high) / 2 + distance * (np.arange(count) - (count - 1) / 2)
    places, strips = [], []
    for number, line in enumerate(lines):
        first, last = _reach(turned, line - width / 2, line + width / 2)
        pictures = int(np.ceil((last - first) / base - 1e-9)) + 1
        along = (first + last) / 2 + base * (np.arange(pictures) - (pictures - 1) / 2)
        places.append(np.column_stack([along[:: -1 if number % 2 else 1], np.full(pictures, line)]))
        strips.append(np.full(pictures, number))
    return np.concatenate(places), np.concatenate(strips)


def _reach(turned: Array, left: float, right: float) -> tuple[float, float]:
    """Return from where to where a polygon reaches along the track, between two lines."""
    along, across = turned.T
    ends = [along[(across >= left) & (across <= right)]]
    step_along, step = np.roll(along, -1) - along, np.roll(across, -1) - across
    for line in (left, right):
        with np.errstate(divide="ignore", invalid="ignore"):
            share = (line - across) / step
        cut = (share >= 0) & (share <= 1)
        ends.append(along[cut] + share[cut] * step_along[cut])
    found = np.concatenate(ends)
    return float(found.min()), float(found.max())


def _inside(pixels: Array, image_size: tuple[int, int]) -> Array:
    """Return which pixels are in the picture; NaN is not."""
    limit = np.array(image_size) - 0.5
    return np.asarray(((pixels >= -0.5) & (pixels <= limit)).all(axis=1))


def _free(ground: Array, centre: Array, terrain: Terrain) -> Array:
    """Return which points on the ground have nothing but air between them and a camera."""
    way = ground[:, None] + ALONG_THE_RAY[:, None] * (centre - ground)[:, None]
    below = terrain(way[..., 0], way[..., 1])
    return np.asarray((way[..., 2] > below - 1e-9 * centre[2]).all(axis=1))
