"""The depth-of-field explorer: a street through a real lens, and what of it is sharp."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera
from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot, disc
from course_lib.drawing.explorers.street import NORTH
from course_lib.optics import (
    airy_diameter,
    circle_of_confusion,
    depth_of_field,
    hyperfocal_distance,
    magnification,
    working_f_number,
)

if TYPE_CHECKING:
    from data_generators.defocus import DefocusedView

Floats = NDArray[np.float64]

SIZE = (480, 320)  # px of the sensor: few, so that each can be seen
WAVELENGTH = 550e-6  # mm: green
MAP_SIZE, MAP_SCALE, EYE = (190, 320), 17.0, (95.0, 296.0)  # px; px a metre; px of the lens
TOP = (EYE[1] - 16) / MAP_SCALE  # m: the distance at the upper edge of the map
PLOT_SIZE = (264, 320)
CURVE = Plot((38, 254, 32, 274), (0.7, 60.0), (0.1, 60.0), log_x=True, log_y=True)


def depth_of_field_frame(f: float, N: float, focus: float, pitch: float) -> Frame:
    """Return a street with signs at five distances, seen through a thin lens.

    Parameters
    ----------
    f, N : float
        Focal length in mm, and f-number.
    focus : float
        Distance from the lens on which it is focused, m.
    pitch : float
        Of the pixels, µm; a spot of one pixel counts as sharp.

    Returns
    -------
    Frame
        The photograph, the sharp range from above, the blur against distance, and the numbers.
    """
    c, s = pitch / 1000, 1000 * focus
    near, far = (float(limit) / 1000 for limit in depth_of_field(f, N, s, c))
    H = float(hyperfocal_distance(f, N, c)) / 1000
    airy = float(airy_diameter(WAVELENGTH, working_f_number(N, magnification(f, s)))) / c
    readouts = (
        Readout("Near limit", "", f"{near:.2f}", "m"),
        Readout("Far limit", "", *_metres(far, f"{far:.2f}")),
        Readout("Depth of field", "", *_metres(far, f"{far - near:.3g}")),
        Readout("Hyperfocal distance", "H", f"{H:.3g}", "m"),
        Readout("Blur of a star", "", f"{float(_blurs(np.inf, f, N, focus, c)):.2f}", "px"),
        Readout("Airy disk (not drawn)", "", f"{airy:.2f}", "px"),
    )
    pictures = (
        _photograph(f, N, focus, c),
        _map(f, focus, (near, far), c),
        _curve(f, N, focus, (near, far), c),
    )
    return Frame(pictures, readouts)


def _metres(value: float, text: str) -> tuple[str, str]:
    """Return a text with its unit, or infinity without one."""
    return ("∞", "") if np.isinf(value) else (text, "m")


def _blurs(Z: object, f: float, N: float, focus: float, c: float) -> Floats:
    """Return the blur of points at distances in m, in px."""
    distances = 1000 * np.asarray(Z, dtype=float)
    return np.asarray(circle_of_confusion(distances, 1000 * focus, f, N) / c)


@cache
def view() -> DefocusedView:
    """Return the street with its signs, ready to be seen through lenses; made once."""
    from data_generators.defocus import DefocusedView
    from data_generators.signs import street_with_signs

    return DefocusedView(street_with_signs(), zooms=True)


def _photograph(f: float, N: float, focus: float, c: float) -> Picture:
    """Return what the sensor sees, with the blur of each sign above it."""
    from data_generators.lens import Lens
    from data_generators.signs import DISTANCES, VIEWPOINT

    lens = Lens(f, N, 1000 * focus)
    camera = Camera(lens.intrinsics(c, SIZE), NORTH, -NORTH @ VIEWPOINT, SIZE)
    blurs = _blurs(DISTANCES, f, N, focus, c)
    sharp = [f"{Z:g} m" for Z, blur in zip(DISTANCES, blurs, strict=True) if blur <= 1]
    which = " and ".join(sharp) if sharp else "none"
    return Picture(
        "Through the lens",
        f"A street with signs at {', '.join(f'{Z:g}' for Z in DISTANCES)} m, focused on "
        f"{focus:g} m; sharp: {which}.",
        SIZE,
        view().picture(camera, lens),
        labels=_sign_labels(camera, blurs),
        pixels=True,
    )


def _sign_labels(camera: Camera, blurs: Floats) -> tuple[Label, ...]:
    """Return the blur above each sign and its distance below it, where there is room."""
    from data_generators.signs import DISTANCES, VIEWPOINT, WIDTH, sign_feet

    if camera.K[0, 0] * WIDTH < 44:  # px: the width of a sign
        return ()
    labels = []
    half = np.array([0, 0, WIDTH / 2])
    for Z, foot, blur, role in zip(DISTANCES, sign_feet(), blurs, _roles(blurs), strict=True):
        middle = np.array([*foot[:2], VIEWPOINT[2]])
        (u, top), (_, bottom) = camera.project([middle + Z * half, middle - Z * half]).tolist()
        if 20 < u < SIZE[0] - 20:
            digits = 2 if round(float(blur), 1) == 1 else 1  # on which side of one pixel?
            labels.append(Label(f"{blur:.{digits}f} px", (u, max(top - 9, 9)), role, "middle"))
            labels.append(Label(f"{Z:g} m", (u, min(bottom + 9, SIZE[1] - 9)), "ink", "middle"))
    return tuple(labels)


def _roles(blurs: Floats) -> list[str]:
    """Return the colours of points: that of the image where they are sharp."""
    return ["image" if blur <= 1 else "object" for blur in blurs]


def _on_map(x: object, Z: object) -> Floats:
    """Return pixels of the map from metres to the right and forward."""
    x, Z = np.broadcast_arrays(np.asarray(x, float), np.asarray(Z, float))
    return np.stack([EYE[0] + MAP_SCALE * x, EYE[1] - MAP_SCALE * Z], axis=-1)


def _map(f: float, focus: float, limits: tuple[float, float], c: float) -> Picture:
    """Return the street from above, with the sharp range inside the angle of view."""
    near, far = limits
    half = SIZE[0] * c / 2 / f * (1 - f / (1000 * focus))  # tangent of half the angle of view
    sides = _on_map([-half * TOP, 0, half * TOP], [TOP, 0, TOP])
    a, b = min(near, TOP), min(far, TOP)
    lines = [
        Line(_on_map([-3.2, -3.2, np.nan, 3.2, 3.2], [-1, TOP, 0, -1, TOP]), "guide", 1.0),
        Line(sides, "camera", 2.0, fill=0.12),
        Line(disc(EYE, 4), "camera", 1.5, closed=True, fill=1.0),
    ]
    if near < TOP:
        band = _on_map([-half * a, half * a, half * b, -half * b], [a, a, b, b])
        lines.append(Line(band, "image", 1.5, closed=True, fill=0.45))
    if focus < TOP:
        lines.append(Line(_on_map([-3.2, 3.2], focus), "ray", 2.0, dashed=True))
    reach = "infinity" if np.isinf(far) else f"{far:.2f} m"
    return Picture(
        "From above",
        f"Map: sharp from {near:.2f} m to {reach}, in an angle of view of "
        f"{2 * np.degrees(np.arctan(half)):.0f}°.",
        MAP_SIZE,
        lines=(*lines, *_signs_on_map()),
        labels=_map_labels(focus, (near, far)),
    )


def _signs_on_map() -> list[Line]:
    """Return the signs as strokes across the view."""
    from data_generators.signs import DIRECTIONS, DISTANCES, WIDTH

    strokes = []
    for Z, direction in zip(DISTANCES, DIRECTIONS, strict=True):
        ends = Z * direction + Z * WIDTH / 2 * np.array([-1, 1])
        strokes.append(Line(_on_map(ends, Z), "object", 4.0))
    return strokes


def _map_labels(focus: float, limits: tuple[float, float]) -> tuple[Label, ...]:
    """Return distances at the edge of the map, and what lies beyond it."""
    labels = [
        Label(f"{Z:g} m", (MAP_SIZE[0] - 4, EYE[1] - MAP_SCALE * Z), "guide", "end")
        for Z in (0, 5, 10, 15)
    ]
    near, far = limits
    if near >= TOP:
        labels.append(Label("↑ sharp beyond the map", (4, 8), "image"))
    elif far > TOP:
        labels.append(Label("↑ ∞" if np.isinf(far) else f"↑ {far:.0f} m", (4, 8), "image"))
    if focus < TOP:
        labels.append(Label("focus", (4, EYE[1] - MAP_SCALE * focus - 9), "ray"))
    return tuple(labels)


def _curve(f: float, N: float, focus: float, limits: tuple[float, float], c: float) -> Picture:
    """Return the blur against distance, the signs on it, and the line of one pixel."""
    from data_generators.signs import DISTANCES

    # The curve dives to zero at the focus.
    Z = np.sort([*np.geomspace(*CURVE.x, 150), 0.999 * focus, focus, 1.001 * focus])
    blurs = np.clip(_blurs(Z, f, N, focus, c), CURVE.y[0], None)
    left, right = (float(np.clip(limit, *CURVE.x)) for limit in limits)
    low, high = CURVE.y
    band = CURVE.pixels([left, right, right, left], [low, low, high, high])
    return Picture(
        "Blur against distance",
        f"The blur is zero at {focus:g} m and at most one pixel in the marked range.",
        PLOT_SIZE,
        lines=(
            CURVE.frame(),
            Line(band, "image", 0.5, closed=True, fill=0.3),
            Line(CURVE.pixels(CURVE.x, 1.0), "guide", 1.2, dashed=True),
            Line(CURVE.pixels(Z, blurs), "ray", 2.5),
            *_dots(_blurs(DISTANCES, f, N, focus, c)),
        ),
        labels=(
            *CURVE.ticks((1, 2, 5, 10, 20, 50), (0.1, 1, 10)),
            *CURVE.names("distance in m", "blur in px"),
        ),
    )


def _dots(blurs: Floats) -> list[Line]:
    """Return the blurs of the signs on the curve; those beyond an axis at its end."""
    from data_generators.signs import DISTANCES

    places = CURVE.pixels(DISTANCES, np.clip(blurs, *CURVE.y))
    return [
        Line(disc(place, 4.5), role, 1.0, closed=True, fill=1.0)
        for place, role in zip(places, _roles(blurs), strict=True)
    ]
