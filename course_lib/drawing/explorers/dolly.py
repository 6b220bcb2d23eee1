"""The dolly zoom explorer: walk away and zoom in, and the subject keeps its size."""

from __future__ import annotations

from functools import cache

import numpy as np

from course_lib.camera import Camera, dolly_zoom
from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import disc
from course_lib.drawing.explorers.street import (
    CHART,
    CHART_EDGES,
    angle_probe,
    renderer,
    upright_camera,
)
from course_lib.optics import field_of_view
from data_generators.places import HOUSES, KERB, TREES

SENSOR = (36.0, 24.0)  # mm
FIRST_Z, FIRST_F = 4.0, 28.0  # m, mm: the shot that the coupled lens keeps
EYE_HEIGHT = 1.65  # m
#: Foot and top of a staff beside the subject and of a tree far behind it, m in the world.
SUBJECT = np.array([[CHART[0] + 0.72, CHART[1], z] for z in CHART_EDGES])
TREE = np.array([[*TREES[1][:2], z] for z in (0, TREES[1][2])])

NORTH_END = 60.0  # m: how far the map reaches
MAP_SIZE = (220, 320)
MAP_ORIGIN, MAP_SCALE = (110.0, 236.0), 3.9  # px where x = y = 0, px a metre


def dolly_zoom_frame(Z: float, f: float, coupled: bool) -> Frame:
    """Return the picture of a subject at a distance, and the map of the shot.

    Parameters
    ----------
    Z : float
        Distance of the subject along the axis, m.
    f : float
        Focal length, mm; not used when coupled.
    coupled : bool
        Whether the focal length keeps the size of the subject.

    Returns
    -------
    Frame
        The photograph, the map, and the numbers; ``follows["f"]`` when coupled.
    """
    if coupled:
        f = float(dolly_zoom(FIRST_F, FIRST_Z, Z))
    x, y = CHART
    camera = upright_camera((float(x), float(y) - Z, EYE_HEIGHT), f, SENSOR)
    subject, tree = camera.project(SUBJECT), camera.project(TREE)
    heights = [float(abs(ends[1, 1] - ends[0, 1])) for ends in (subject, tree)]
    angle = float(np.degrees(field_of_view(f, SENSOR)[0]))
    words = f"Letter chart {Z:.1f} m away with {f:.0f} mm: {heights[0]:.0f} px high; "
    photograph = Picture(
        "What the camera sees",
        words + f"the tree behind it {heights[1]:.0f} px.",
        camera.image_size,
        renderer().picture(camera),
        lines=(_marks(subject, "object"), _marks(tree, "image")),
        probes=(angle_probe(camera),),
        pixels=True,
    )
    readouts = (
        Readout("Chart in the picture", "", f"{heights[0]:.0f}", "px"),
        Readout("Tree behind it", "", f"{heights[1]:.0f}", "px"),
        Readout("Field of view", "θ", f"{angle:.1f}", "°"),
        Readout("Ratio", "f / Z", f"{f / Z:.2f}", "mm/m"),
    )
    return Frame((photograph, _map(camera, Z, angle)), readouts, {"f": f} if coupled else {})


def _marks(ends: np.ndarray, role: str) -> Line:
    """Return a bracket beside something upright, from its foot to its top in the picture."""
    u, (low, high) = float(ends[:, 0].max()), ends[:, 1]
    points = [[u - 7, low], [u + 7, low], [u, low], [u, high], [u - 7, high], [u + 7, high]]
    return Line(points, role, 2.0)


def _map(camera: Camera, Z: float, angle: float) -> Picture:
    """Return the shot from above: north is up."""
    centre = camera.centre[:2]
    board = CHART + np.array([[-0.6, 0.0], [0.6, 0.0]])
    gap = np.array([[CHART[0] + 2, CHART[1]], [CHART[0] + 2, centre[1]]])
    return Picture(
        "The shot from above",
        f"Map: the camera is {Z:.1f} m from the chart and sees {angle:.0f}° to the north.",
        MAP_SIZE,
        lines=(
            *_surroundings(),
            Line(_on_map(_fan(camera)), "camera", 2.0, fill=0.15),
            Line(_on_map(board), "object", 4.0),
            Line(_on_map(gap), "ray", 1.5, dashed=True),
            Line(disc(_on_map(TREE[0, :2]), 1.4 * MAP_SCALE), "image", 1.5, closed=True, fill=0.9),
            Line(disc(_on_map(centre), 0.8 * MAP_SCALE), "camera", 1.5, closed=True, fill=1.0),
        ),
        labels=(
            Label("camera", _at(centre - [1.6, 0.8]), "camera", "end"),
            Label("chart", _at(CHART - [1.4, -0.8]), "object", "end"),
            Label("tree", _at(TREE[0, :2] - [2.4, 0]), "image", "end"),
            Label(f"Z = {Z:.1f} m", _at(gap.mean(axis=0) - [-0.8, 0])),
        ),
    )


def _fan(camera: Camera) -> np.ndarray:
    """Return the sides of what a camera sees at the height of its axis, on the map, m."""
    centre = camera.centre[:2]
    w, h = camera.image_size
    sides = camera.pixel_ray([[-0.5, (h - 1) / 2], [w - 0.5, (h - 1) / 2]])[:, :2]
    reach = (NORTH_END - centre[1]) * sides / sides[:, 1:]
    return np.array([centre + reach[0], centre, centre + reach[1]])


@cache
def _surroundings() -> tuple[Line, Line]:
    """Return the road and the houses beside it, as on a map; they stay the same."""
    lift = [[np.nan, np.nan]]
    kerbs = [[-KERB, -22], [-KERB, NORTH_END], *lift, [KERB, -22], [KERB, NORTH_END]]
    walls = []
    for side, start, length, depth, *_ in HOUSES:
        near, far, end = side * 6.6, side * (6.6 + depth), start + length
        walls += [[near, start], [far, start], [far, end], [near, end], [near, start], *lift]
    return (
        Line(_on_map(np.array(kerbs)), "guide", 1.0),
        Line(_on_map(np.array(walls)), "guide", 1.0, fill=0.25),
    )


def _on_map(points: np.ndarray) -> np.ndarray:
    """Return pixels of the map from east and north, m."""
    return np.asarray(MAP_ORIGIN) + MAP_SCALE * points * [1, -1]


def _at(point: np.ndarray) -> tuple[float, float]:
    """Return one pixel of the map."""
    u, v = _on_map(point)
    return float(u), float(v)
