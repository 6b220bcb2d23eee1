"""The flight planner: an area on the map, a drone, overlaps; and how often each place is seen."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.explorers.frame import Frame, Handle, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot, disc, lifted
from course_lib.drawing.planning.flying import COLOURS, STEPS
from course_lib.drawing.planning.site import (
    AREA,
    CELL,
    EXTENT,
    HALF_AXES,
    HEAP,
    PIT,
    RADIUS,
    Counted,
    Drone,
    count_places,
    flight,
)
from course_lib.drawing.planning.site import drones as known_drones
from course_lib.drawing.style import ROLES, rgb
from course_lib.planning import FlightPlan, ground_sample_distance, max_speed
from course_lib.planning.flight import SMALLEST_OBJECT

Floats = NDArray[np.float64]
Pixels = NDArray[np.uint8]

SIZE = (640, 450)  # px of the map with its scale
PLAN = Plot((46, 496, 30, 390), (0, EXTENT[0]), (0, EXTENT[1]))
EXPOSURE, BLUR, TURN = 1 / 1000, 0.5, 5.0  # s, px, and s that are lost at the end of a line
NAMES = ("0 or 1", "2", "3 to 5", "6 to 8", "9 or more", "0 or 1: hidden")
START = tuple(AREA)


def flight_frame(
    camera: str,
    gsd: float,
    forward: float,
    side: float,
    heading: float,
    hilly: bool,
    drones: Mapping[str, Drone] | None = None,
    **at: float,
) -> Frame:
    """Return the map of a flight, and how many pictures show each place.

    Parameters
    ----------
    camera : str
        Name of a flying camera.
    gsd : float
        Ground sampling distance, cm.
    forward, side : float
        Overlap along a line and between lines, %.
    heading : float
        Direction of the lines, clockwise from north, degrees.
    hilly : bool
        Whether the ground has its pit and its heap, or is flat.
    drones : mapping, optional
        All flying cameras with their lenses by name; those of the catalogue unless given.
    **at : float
        ``x1``, ``y1`` … ``x4``, ``y4``: east and north of the area's corners, m.

    Returns
    -------
    Frame
        The map and the numbers of the flight.
    """
    area = np.array([(at[f"x{i}"], at[f"y{i}"]) for i in range(1, 5)])
    flying = (drones or known_drones())[camera]
    try:
        plan = flight(gsd / 100, forward / 100, side / 100, np.radians(heading), area, flying)
    except ValueError as error:  # the corners lie on a line
        return Frame((_empty(area, str(error)),), (Readout("No flight", "", str(error)),))
    counted = count_places(plan, hilly)
    return Frame((_map(plan, counted, hilly),), _numbers(plan, counted, flying, hilly))


def _numbers(plan: FlightPlan, counted: Counted, flying: Drone, hilly: bool) -> tuple[Readout, ...]:
    """Return what the flight costs, and what it misses."""
    camera, lens = flying
    speed = float(max_speed(plan.base, 1 / camera.frame_rate, plan.gsd, EXPOSURE, BLUR))
    few, partly = (counted.percent(w) for w in (counted.shown < 3, counted.partly_hidden))
    least = f"{counted.least}" if counted.inside.any() else "–"
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
        Readout("Area hidden from some pictures", "", f"{partly:.0f}", "%"),
        Readout("Fewest pictures of a place", "", least),
        Readout("GSD on the lowest ground", "", f"{100 * floor:.2f}", "cm"),
        Readout("Smallest object found there", "", f"{100 * SMALLEST_OBJECT * floor:.1f}", "cm"),
    )


def _map(plan: FlightPlan, counted: Counted, hilly: bool) -> Picture:
    """Return the counts as colours, the flight over them, and the corners to be dragged."""
    edges = _edges(plan.footprints()[plan.strips == 0])
    way = np.stack([plan.centres[:-1, :2], plan.centres[1:, :2]], axis=1)
    lines = (
        PLAN.frame(),
        *(_shapes() if hilly else ()),
        Line(lifted(PLAN.within(edges[0])), "object", 1.5, dashed=True),
        Line(lifted(PLAN.within(way)), "camera", 0.8),
        Line(_dots(plan), "camera", 2.0),
        Line(PLAN.pixels(*plan.polygon.T), "ink", 2.0, closed=True),
    )
    return Picture(
        "Drag the corners",
        _in_words(plan, counted, hilly),
        SIZE,
        _picture(counted, PLAN.within(edges[1:].reshape(-1, 2, 2))),
        lines=lines,
        labels=_words(),
        handles=_handles(plan.polygon),
    )


def _in_words(plan: FlightPlan, counted: Counted, hilly: bool) -> str:
    """Return what the map shows."""
    width, depth = (plan.gsd * n for n in plan.image_size)
    partly, hidden = counted.percent(counted.partly_hidden), counted.percent(counted.hidden)
    return (
        f"Map of {len(plan.centres)} pictures from {plan.H:.0f} m, "
        f"over {'the pit' if hilly else 'flat ground'}, each of {width:.0f} × {depth:.0f} m; "
        f"each place of the area is in {counted.least} pictures at least. {partly:.0f} % of the "
        f"area are hidden from some pictures, {hidden:.0f} % so that fewer than two remain."
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
        Handle((u, v), ((f"x{i}", -left * east, east, 0.0), (f"y{i}", bottom * north, 0.0, -north)))
        for i, (u, v) in enumerate(PLAN.pixels(*area.T).tolist(), 1)
    )


def _edges(footprints: Floats) -> Floats:
    """Return the two ends of each edge, (..., 4, 2, 2)."""
    return np.stack([footprints, np.roll(footprints, -1, axis=-2)], axis=-2)


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
    rows = (
        ("hatched: hidden", "ink"),
        ("from some pictures", "ink"),
        ("dashed red: first", "object"),
        ("picture's footprint", "object"),
        ("thin red: those of", "object"),
        ("the first line", "object"),
        ("blue: flight", "camera"),
        ("black: the area", "ink"),
        ("dashed grey: edge", "guide"),
        ("of the pit, and heap", "guide"),
    )
    return (
        *PLAN.ticks((0, 50, 100, 150, 200, 250), (50, 100, 150, 200)),
        *PLAN.names("east (m)", "north (m)"),
        Label("seen in pictures", (514, 46)),
        *keys,
        *(Label(text, (514, 236 + 17 * i), role) for i, (text, role) in enumerate(rows)),
    )


def _picture(counted: Counted, footprints: Floats) -> Pixels:
    """Return the colours of the counts over the map, beside their scale, on white.

    `footprints` are the two ends of each of their edges, (M, 2, 2), px.
    """
    import cv2

    picture = np.array(_paper())
    left, right, top, bottom = (int(end) for end in PLAN.box)
    step = np.where(counted.hidden, len(STEPS), np.digitize(counted.shown, STEPS) - 1)
    shape = round(EXTENT[1] / CELL), round(EXTENT[0] / CELL)
    colours = _table()[step].reshape(*shape, 3)
    size = right - left, bottom - top
    map_ = cv2.resize(colours, size, interpolation=cv2.INTER_NEAREST)
    if counted.partly_hidden.any():
        seen_by_all = np.where(counted.partly_hidden, 0, 255).astype(np.uint8).reshape(shape)
        paper = cv2.resize(seen_by_all, size, interpolation=cv2.INTER_NEAREST) | _hatching()
        map_ = cv2.bitwise_and(map_, map_, mask=paper)
    ends = np.rint(16 * (footprints - (left, top))).astype(np.int32)
    lines = map_.copy()
    cv2.polylines(lines, list(ends), False, rgb(ROLES["object"]), 1, cv2.LINE_AA, shift=4)
    picture[top:bottom, left:right] = cv2.addWeighted(map_, 0.35, lines, 0.65, 0)
    return picture


@cache
def _hatching() -> NDArray[np.uint8]:
    """Return the map's paper, 255, with thin slanted strokes of ink, 0."""
    left, right, top, bottom = (int(end) for end in PLAN.box)
    stroke = np.add.outer(np.arange(bottom - top), np.arange(right - left)) % 5 == 0
    return np.where(stroke, 0, 255).astype(np.uint8)


@cache
def _table() -> Pixels:
    """Return the colours of the classes, the last one for what is hidden."""
    return np.array([rgb(colour) for colour in (*COLOURS, ROLES["second"])], np.uint8)


@cache
def _paper() -> Pixels:
    """Return white paper with the keys of the colours."""
    paper = np.full((SIZE[1], SIZE[0], 3), 255, np.uint8)
    for i, colour in enumerate(_table()):
        paper[62 + 26 * i : 78 + 26 * i, 514:532] = 118
        paper[63 + 26 * i : 77 + 26 * i, 515:531] = colour
    return paper
