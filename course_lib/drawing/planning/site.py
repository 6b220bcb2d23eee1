"""The gravel pit: its ground, the area to be flown, and how often each place is seen."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.planning import FlightPlan, LensModel, plan_flight, read_cameras, read_lenses
from course_lib.planning.catalogue import CameraModel
from course_lib.planning.strips import inside_polygon

Floats = NDArray[np.float64]
Drone = tuple[CameraModel, LensModel]

#: The area of the text: corners, east and north, m.
AREA = ((30.0, 30.0), (270.0, 30.0), (270.0, 180.0), (30.0, 210.0))
EXTENT = (300.0, 240.0)  # m: of the map
CELL = 10.0  # m: of the grid on which pictures are counted
PIT, HALF_AXES, DEPTH, WALL = (140.0, 115.0), (80.0, 55.0), 20.0, 2.5  # m
HEAP, RADIUS, TOP = (235.0, 70.0), 24.0, 14.0  # m
#: Cameras of the catalogue that fly, with their lenses.
DRONES = {
    "DJI Phantom 4 RTK": "Phantom 4 RTK lens",
    "DJI Zenmuse P1": "DJI DL 35 mm F2.8 LS ASPH",
}
ENOUGH = 2  # pictures that a height needs
AZIMUTHS = np.arange(0, 360, 10)  # degrees: in which horizons are looked up
REACH = np.concatenate([np.arange(1.0, 20, 1.0), np.geomspace(20, 140, 20)])  # m: how far


def ground(x: ArrayLike, y: ArrayLike) -> Floats:
    """Return the heights of the gravel pit: a hole with steep walls, and a heap beside it, m."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    across = np.hypot((x - PIT[0]) / HALF_AXES[0], (y - PIT[1]) / HALF_AXES[1])
    within = (1 - across) * min(HALF_AXES) / WALL  # 0 at the edge, 1 at the foot of the wall
    heap = TOP * np.clip(1 - np.hypot(x - HEAP[0], y - HEAP[1]) / RADIUS, 0, None)
    return np.asarray(heap - DEPTH * np.clip(within, 0, 1))


@cache
def drones() -> dict[str, Drone]:
    """Return the flying cameras of the catalogue, each with its lens, by name."""
    cameras, lenses = read_cameras(), read_lenses()
    return {camera: (cameras[camera], lenses[lens]) for camera, lens in DRONES.items()}


def drone(name: str = "DJI Phantom 4 RTK") -> Drone:
    """Return a flying camera of the catalogue, and its lens."""
    return drones()[name]


def with_lenses(
    cameras: Mapping[str, CameraModel], lenses: Mapping[str, LensModel]
) -> dict[str, Drone]:
    """Return cameras with the first lens that fits each, of these or else of the catalogue."""
    found, several = {}, [*lenses.values(), *read_lenses().values()]
    for name, camera in cameras.items():
        fitting = [lens for lens in several if lens.mount == camera.mount]
        if not fitting:
            raise ValueError(
                f"{name} has the mount {camera.mount!r}, and no lens has it: give its lens, too"
            )
        found[name] = camera, fitting[0]
    return found


def flight(
    gsd: float = 0.02,
    forward: float = 0.8,
    side: float = 0.6,
    heading: float = np.pi / 2,
    area: ArrayLike = AREA,
    flying: Drone | None = None,
) -> FlightPlan:
    """Return a flight over the pit, by default that of the text: strips from west to east."""
    return plan_flight(area, *(flying or drone()), gsd, forward, side, heading)


@cache
def grid() -> Floats:
    """Return the places where pictures are counted, rows from north to south, (N, 3), m."""
    x = np.arange(CELL / 2, EXTENT[0], CELL)
    y = np.arange(EXTENT[1] - CELL / 2, 0, -CELL)
    places = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    return np.column_stack([places, ground(*places.T)])


@cache
def horizons() -> Floats:
    """Return how steep the ground rises around each place of the grid, (N, 37).

    The tangent of the horizon's height in each azimuth, clockwise from north; the last column is
    the first one again.
    """
    turn = np.radians(AZIMUTHS)
    steps = REACH[:, None, None] * np.stack([np.sin(turn), np.cos(turn)], axis=-1)
    around = grid()[:, None, None, :2] + steps
    rise = ground(around[..., 0], around[..., 1]) - grid()[:, 2, None, None]
    highest = (rise / REACH[:, None]).max(axis=1)
    return np.concatenate([highest, highest[:, :1]], axis=1)


@dataclass(frozen=True, eq=False)
class Counted:
    """How many pictures show each place of the grid.

    Attributes
    ----------
    shown, covered : ndarray of int, shape (N,)
        Pictures that show it, and that have it in their frame.
    inside : ndarray of bool, shape (N,)
        Whether it lies in the area.
    """

    shown: NDArray[np.intp]
    covered: NDArray[np.intp]
    inside: NDArray[np.bool_]

    @property
    def least(self) -> int:
        """Fewest pictures of a place in the area; 0 if no place of the grid is in it."""
        return int(self.shown[self.inside].min()) if self.inside.any() else 0

    @property
    def partly_hidden(self) -> NDArray[np.bool_]:
        """Where ground stands before a place in at least one picture."""
        return self.shown < self.covered

    @property
    def hidden(self) -> NDArray[np.bool_]:
        """Where only this leaves fewer than two pictures."""
        return (self.shown < ENOUGH) & (self.covered >= ENOUGH)

    def percent(self, where: NDArray[np.bool_]) -> float:
        """Return which part of the area some places are, %."""
        all_ = np.count_nonzero(self.inside)
        return 100 * np.count_nonzero(where & self.inside) / all_ if all_ else 0.0


def counts(plan: FlightPlan, hilly: bool = True) -> NDArray[np.intp]:
    """Return how many pictures show each place of the grid, as `count_places` does."""
    return count_places(plan, hilly).shown


def count_places(plan: FlightPlan, hilly: bool = True) -> Counted:
    """Count the pictures that show each place of the grid.

    Parameters
    ----------
    plan : FlightPlan
        The flight.
    hilly : bool
        Whether the ground is the pit's, or flat.

    Returns
    -------
    Counted
        Quicker than `course_lib.planning.views_of_ground`: horizons are looked up.
    """
    points = grid() if hilly else grid() * [1, 1, 0]
    seen, number = in_footprints(plan, points)
    shown = covered = np.bincount(number, minlength=len(points))
    if hilly:
        free = _free(points, plan.centres, seen, number)
        shown = np.bincount(number[free], minlength=len(points))
    return Counted(shown, covered, in_area(plan.polygon))


def in_footprints(plan: FlightPlan, points: Floats) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return which picture could show which point: pairs of their numbers."""
    sine, cosine = np.sin(plan.heading), np.cos(plan.heading)
    turn = np.array([[sine, cosine], [cosine, -sine]])  # along, across
    here = (points[:, :2] @ turn.T).astype(np.float32)
    there = (plan.centres[:, :2] @ turn.T).astype(np.float32)
    half = np.array(plan.image_size)[::-1] / 2 / plan.K[0, 0]
    reach = ((plan.H - points[:, 2, None]) * half).astype(np.float32)
    near = np.abs(there[:, None, 0] - here[:, 0]) <= reach[:, 0]
    near &= np.abs(there[:, None, 1] - here[:, 1]) <= reach[:, 1]
    seen, number = np.nonzero(near)
    return seen, number


def _free(
    points: Floats, centres: Floats, seen: NDArray[np.intp], number: NDArray[np.intp]
) -> NDArray[np.bool_]:
    """Return which pairs of picture and point have no ground between them."""
    way = (centres[seen] - points[number]).astype(np.float32)
    azimuth = np.degrees(np.arctan2(way[:, 0], way[:, 1])) % 360 / AZIMUTHS[1]
    below = azimuth.astype(np.intp)
    share = azimuth - below
    table = horizons()
    horizon = (1 - share) * table[number, below] + share * table[number, below + 1]
    return np.asarray(way[:, 2] >= horizon * np.hypot(way[:, 0], way[:, 1]))


def in_area(area: ArrayLike) -> NDArray[np.bool_]:
    """Return which places of the grid lie in a polygon."""
    return np.asarray(inside_polygon(grid()[:, :2], np.asarray(area, float)), bool)
