"""The flight planner: an area on the map, a drone, overlaps; and how often each place is seen."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.explorers.frame import Frame, Handle, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot, disc
from course_lib.drawing.planning.flying import COLOURS, STEPS
from course_lib.drawing.planning.site import (
    AREA,
    CELL,
    DRONES,
    EXTENT,
    HALF_AXES,
    HEAP,
    PIT,
    RADIUS,
    counts,
    drone,
    flight,
    in_area,
)
from course_lib.drawing.style import rgb
from course_lib.planning import FlightPlan, ground_sample_distance, max_speed

Floats = NDArray[np.float64]
Pixels = NDArray[np.uint8]

SIZE = (640, 450)  # px of the map with its scale
PLAN = Plot((46, 496, 30, 390), (0, EXTENT[0]), (0, EXTENT[1]))
EXPOSURE, BLUR, TURN = 1 / 1000, 0.5, 5.0  # s, px, and s that are lost at the end of a line
NAMES = ("0 or 1", "2", "3 to 5", "6 to 8", "9 or more")


def flight_frame(
    camera: str,
    gsd: float,
    forward: float,
    side: float,
    heading: float,
    hilly: bool,
    **at: float,
) -> Frame:
    """Return the map of a flight, and how many pictures show each place.

    Parameters
    ----------
    camera : str
        A flying camera of the catalogue.
    gsd : float
        Ground sampling distance, cm.
    forward, side : float
        Overlap along a line and between lines, %.
    heading : float
        Direction of the lines, clockwise from north, degrees.
    hilly : bool
        Whether the ground has its pit and its heap, or is flat.
    **at : float
        ``x1``, ``y1`` … ``x4``, ``y4``: east and north of the area's corners, m.

    Returns
    -------
    Frame
        The map and the numbers of the flight.
    """
    area = np.array([(at[f"x{i}"], at[f"y{i}"]) for i in range(1, 5)])
    try:
        plan = flight(gsd / 100, forward / 100, side / 100, np.radians(heading), area, camera)
    except ValueError as error:  # the corners lie on a line
        return Frame((_empty(area, str(error)),), (Readout("No flight", "", str(error)),))
    seen = counts(plan, hilly)
    return Frame((_map(plan, seen, hilly),), _numbers(plan, seen, camera, hilly))


def _numbers(
    plan: FlightPlan, seen: NDArray[np.intp], name: str, hilly: bool
) -> tuple[Readout, ...]:
    """Return what the flight costs, and what it misses."""
    camera, lens = drone(name)
    speed = float(max_speed(plan.base, 1 / camera.frame_rate, plan.gsd, EXPOSURE, BLUR))
    inside = seen[in_area(plan.polygon)]
    few = 100 * float(np.mean(inside < 3)) if inside.size else 0.0
    lines = int(plan.strips.max()) + 1
    floor = float(ground_sample_distance(plan.H + 20.0 * hilly, lens.f_mm, camera.pitch_um))
    return (
        Readout("Height", "H", f"{plan.H:.0f}", "m"),
        Readout("Base", "B", f"{plan.base:.1f}", "m"),
        Readout("From line to line", "", f"{plan.distance:.1f}", "m"),
        Readout("Pictures", "", f"{len(plan.centres)} in {lines} line{'s' * (lines > 1)}"),
        Readout("Speed", "v", f"{speed:.1f}", "m/s"),
        Readout("Time in the air", "", f"{plan.duration(speed, TURN) / 60:.1f}", "min"),
        Readout("Area in fewer than 3 pictures", "", f"{few:.0f}", "%"),
        Readout("Fewest pictures of a place", "", f"{inside.min()}" if inside.size else "–"),
        Readout("GSD on the lowest ground", "", f"{100 * floor:.2f}", "cm"),
    )


def _map(plan: FlightPlan, seen: NDArray[np.intp], hilly: bool) -> Picture:
    """Return the counts as colours, the flight over them, and the corners to be dragged."""
    inside = seen[in_area(plan.polygon)]
    least = inside.min() if inside.size else 0
    first = plan.footprints()[0]
    lines = (
        PLAN.frame(),
        *(_shapes() if hilly else ()),
        Line(_seen(_dense(first)), "object", 1.5, dashed=True),
        Line(_seen(_dense(plan.centres[:, :2], closed=False)), "camera", 0.8),
        Line(_dots(plan), "camera", 2.0),
        Line(PLAN.pixels(*plan.polygon.T), "ink", 2.0, closed=True),
    )
    return Picture(
        "Drag the corners",
        f"Map of {len(plan.centres)} pictures from {plan.H:.0f} m, "
        f"over {'the pit' if hilly else 'flat ground'}; "
        f"each place of the area is in {least} pictures at least.",
        SIZE,
        _picture(seen),
        lines=lines,
        labels=_words(),
        handles=_handles(plan.polygon),
    )


def _empty(area: Floats, words: str) -> Picture:
    """Return the map without a flight."""
    sentence = words.partition(":")[0]
    return Picture(
        "Drag the corners",
        f"Map without a flight: {sentence}.",
        SIZE,
        np.array(_paper()),
        lines=(PLAN.frame(),),
        labels=_words(),
        handles=_handles(area),
    )


def _handles(area: Floats) -> tuple[Handle, ...]:
    """Return the spots of the corners; each moves its two sliders."""
    left, right, top, bottom = PLAN.box
    east, north = PLAN.x[1] / (right - left), PLAN.y[1] / (bottom - top)
    return tuple(
        Handle(
            PLAN.at(*corner),
            ((f"x{i}", -left * east, east, 0.0), (f"y{i}", bottom * north, 0.0, -north)),
        )
        for i, corner in enumerate(area.tolist(), 1)
    )


def _dense(points: Floats, closed: bool = True) -> Floats:
    """Return a polyline with points every few metres, so that it ends at the edge of the map."""
    ends = np.vstack([points, points[:1]]) if closed else points
    share = np.linspace(0, 1, 24 if closed else 6, endpoint=False)[:, None, None]
    between = ends[:-1] + share * (ends[1:] - ends[:-1])
    return np.vstack([between.transpose(1, 0, 2).reshape(-1, 2), ends[-1:]])


def _seen(points: Floats) -> Floats:
    return PLAN.pixels(*points.T)


def _dots(plan: FlightPlan) -> Floats:
    """Return small strokes at the pictures on the map, as one line that lifts its pen."""
    spots = PLAN.pixels(*plan.centres[:, :2].T)
    spots = spots[np.isfinite(spots[:, 0])]
    stroke = np.array([(-1.5, -1.5), (1.5, 1.5), (np.nan, np.nan)])
    return np.asarray((spots[:, None] + stroke).reshape(-1, 2))


@cache
def _shapes() -> tuple[Line, Line]:
    """Return the edge of the pit and the foot of the heap."""
    circle = disc((0, 0), 1.0)
    edges = (circle * HALF_AXES + PIT, circle * RADIUS + HEAP)
    pit, heap = (Line(PLAN.pixels(*e.T), "guide", 1.5, closed=True, dashed=True) for e in edges)
    return pit, heap


@cache
def _words() -> tuple[Label, ...]:
    """Return the labels that stay."""
    keys = [Label(name, (540, 70 + 26 * i)) for i, name in enumerate(NAMES)]
    return (
        *PLAN.ticks((0, 50, 100, 150, 200, 250), (50, 100, 150, 200)),
        *PLAN.names("east (m)", "north (m)"),
        Label("seen in pictures", (514, 46)),
        *keys,
        Label("dashed red: first", (514, 220), "object"),
        Label("picture's footprint", (514, 236), "object"),
        Label("blue: flight", (514, 262), "camera"),
        Label("black: the area", (514, 288)),
        Label("dashed grey: edge", (514, 314), "guide"),
        Label("of the pit, and heap", (514, 330), "guide"),
    )


def _picture(seen: NDArray[np.intp]) -> Pixels:
    """Return the colours of the counts over the map, beside their scale, on white."""
    import cv2

    picture = np.array(_paper())
    left, right, top, bottom = (int(end) for end in PLAN.box)
    shape = round(EXTENT[1] / CELL), round(EXTENT[0] / CELL)
    colours = _table()[np.digitize(seen, STEPS) - 1].reshape(*shape, 3)
    size = (right - left, bottom - top)
    picture[top:bottom, left:right] = cv2.resize(colours, size, interpolation=cv2.INTER_NEAREST)
    return picture


@cache
def _table() -> Pixels:
    return np.array([rgb(colour) for colour in COLOURS], np.uint8)


@cache
def _paper() -> Pixels:
    """Return white paper with the keys of the colours."""
    paper = np.full((SIZE[1], SIZE[0], 3), 255, np.uint8)
    for i, colour in enumerate(_table()):
        paper[62 + 26 * i : 78 + 26 * i, 514:532] = 118
        paper[63 + 26 * i : 77 + 26 * i, 515:531] = colour
    return paper


START = tuple(AREA)
CAMERAS = tuple(DRONES)
