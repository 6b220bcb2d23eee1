"""The DLT under noise: where a camera is found, again and again, from points that are not exact."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera, camera_at, decompose_projection
from course_lib.checks import DegenerateConfigurationError
from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot, disc
from course_lib.resection import camera_dlt

Floats = NDArray[np.float64]

TRIALS = 16
SIZE = (400, 300)  # px of the camera's picture as it is drawn
PLAN_SIZE, ZOOM_SIZE = (300, 300), (300, 300)
K = np.array([[820.0, 0, 319.5], [0, 820, 239.5], [0, 0, 1]])
PLATE = np.array([[-30.0, -30, 0], [450, -30, 0], [450, 330, 0], [-30, 330, 0]])  # mm
PLAN = Plot((8, 292, 8, 292), (-60, 860), (-560, 360))
REACH = 100.0  # mm: half the width of the enlarged view, always the same so that one can compare


def dlt_noise_frame(n: int, sigma: float, h: float, draw: int) -> Frame:
    """Return where the DLT finds a camera that sees pins on a plate.

    Parameters
    ----------
    n : int
        Number of pins, 6 to 48.
    sigma : float
        Standard deviation of each pixel coordinate, px.
    h : float
        Height of the tallest pin, mm; with 0 all points lie in one plane.
    draw : int
        Which chance errors.

    Returns
    -------
    Frame
        The camera's picture, the plan and a part of it enlarged, with the scatter in numbers.
    """
    points, camera = pins(int(n), h), _camera()
    found = centres(points, sigma, int(draw))
    if found is None:
        words = "The points lie in one plane: the camera's DLT is undetermined."
        readouts: tuple[Readout, ...] = (Readout("No camera", "", words),)
        return Frame((_seen(points, sigma), _plan(np.zeros((0, 3))), _empty(words)), readouts)
    spread, axes = _ellipse(found[:, :2])
    away = float(np.linalg.norm(camera.centre - points.mean(axis=0)))
    readouts = (
        Readout("Scatter, longest way", "", f"{spread[0]:.2f}", "mm"),
        Readout("Scatter, shortest way", "", f"{spread[1]:.2f}", "mm"),
        Readout("Camera to plate", "", f"{away:.0f}", "mm"),
        Readout("Equations", "2N", f"{2 * int(n)}"),
    )
    outline = _outline(found[:, :2].mean(axis=0), 2 * spread, axes)
    pictures = (
        _seen(points, sigma),
        _plan(found, outline),
        _zoom(found, outline, spread),
    )
    return Frame(pictures, readouts)


def pins(n: int, h: float) -> Floats:
    """Return the tops of n pins, at most h mm high, shape (n, 3), mm."""
    places, heights = _places()
    return np.asarray(np.column_stack([places, h * heights])[:n])


def centres(points: Floats, sigma: float, draw: int) -> Floats | None:
    """Return the centres that the DLT finds from observations with errors; None if it cannot.

    Parameters
    ----------
    points : ndarray, shape (N, 3)
        World points, mm.
    sigma : float
        Standard deviation of each pixel coordinate, px.
    draw : int
        Which chance errors.

    Returns
    -------
    ndarray, shape (TRIALS, 3), or None
        Centres, mm.
    """
    pixels, rng = _camera().project(points), np.random.default_rng(draw)
    noise = sigma * rng.standard_normal((TRIALS, *pixels.shape))
    try:
        return np.array([decompose_projection(camera_dlt(points, pixels + e))[2] for e in noise])
    except DegenerateConfigurationError:
        return None


@cache
def _camera() -> Camera:
    return camera_at((680, -400, 600), (215, 150, 30), K, (640, 480))


@cache
def _places() -> tuple[Floats, Floats]:
    """Return where the pins stand, the widest spread first, and their heights as parts of h."""
    x, y = np.meshgrid(np.arange(8) * 60.0, np.arange(6) * 60.0)
    places = np.stack([x.ravel(), y.ravel()], axis=1)
    order = [0]
    far = np.linalg.norm(places - places[0], axis=1)
    while len(order) < len(places):  # each next pin is the one farthest from all before
        order.append(int(np.argmax(far)))
        far = np.minimum(far, np.linalg.norm(places - places[order[-1]], axis=1))
    heights = np.random.default_rng(3).permutation(np.linspace(0, 1, len(places)))
    return places[order], heights


def _ellipse(points: Floats) -> tuple[Floats, Floats]:
    """Return the scatter along its two axes, the longer first, and the axes as columns."""
    sizes, axes = np.linalg.eigh(np.cov(points.T))
    return np.sqrt(np.maximum(sizes[::-1], 0)), axes[:, ::-1]


def _outline(centre: Floats, radii: Floats, axes: Floats) -> Floats:
    turn = np.linspace(0, 2 * np.pi, 73)
    return np.asarray(centre + np.stack([np.cos(turn), np.sin(turn)], axis=1) * radii @ axes.T)


def _seen(points: Floats, sigma: float) -> Picture:
    """Return the camera's picture: plate, pins and their tops."""
    camera, scale = _camera(), SIZE[0] / 640
    feet = points * [1, 1, 0]
    lines = [Line(scale * camera.project(PLATE), "guide", 1.5, closed=True, fill=0.15)]
    for foot, top in zip(camera.project(feet), camera.project(points), strict=True):
        lines.append(Line(scale * np.array([foot, top]), "guide", 2.0))
        lines.append(Line(disc(scale * top, 3.5), "object", 1.0, closed=True, fill=1.0))
    tallest = points[:, 2].max()
    return Picture(
        "What the camera sees",
        f"A plate with {len(points)} pins of up to {tallest:.0f} mm. Each top is found to "
        f"{sigma:g} px.",
        SIZE,
        lines=tuple(lines),
    )


def _plan(found: Floats, outline: Floats | None = None) -> Picture:
    """Return plate and camera from above, with every centre that was found."""
    centre = _camera().centre
    lines = [Line(PLAN.pixels(*PLATE[:, :2].T), "guide", 1.5, closed=True, fill=0.15)]
    lines.append(Line(PLAN.pixels([centre[0], 210], [centre[1], 150]), "guide", 1.0, dashed=True))
    lines += _cloud(PLAN, found, outline)
    away = np.linalg.norm(found[:, :2] - centre[:2], axis=1)
    tries = f"the tries put it up to {away.max():.0f} mm away" if len(away) else "no try finds it"
    return Picture(
        "From above",
        f"The plate, and the camera {np.linalg.norm(centre[:2] - [210, 150]):.0f} mm beside it; "
        f"{tries}.",
        PLAN_SIZE,
        lines=tuple(lines),
        labels=(
            Label("plate", PLAN.at(210, 150), "ink", "middle"),
            Label("camera", PLAN.at(centre[0], centre[1], -14, 4), "camera", "end"),
        ),
    )


def _cloud(plot: Plot, found: Floats, outline: Floats | None) -> list[Line]:
    """Return the true centre as a ring, the found ones as spots, and their ellipse."""
    centre = _camera().centre
    spots = plot.pixels(found[:, 0], found[:, 1])
    lines = [Line(disc(at, 3.5), "object", 1.0, closed=True, fill=1.0) for at in spots]
    if outline is not None:
        lines.append(Line(plot.pixels(*outline.T), "object", 1.5))
    true = plot.pixels(centre[0], centre[1])[0]
    return [*lines, Line(disc(true, 7), "camera", 2.5, closed=True)]


def _zoom(found: Floats, outline: Floats, spread: Floats) -> Picture:
    """Return the surroundings of the camera from above, and how many tries are beyond them."""
    centre = _camera().centre[:2]
    plot = Plot((44, 286, 26, 262), (-REACH, REACH), (-REACH, REACH))
    spots = plot.pixels(*(found[:, :2] - centre).T)
    near = spots[np.isfinite(spots).all(axis=1)]
    lines = [
        plot.frame(),
        *(Line(disc(at, 2.5), "object", 1.0, closed=True, fill=1.0) for at in near),
    ]
    lines.append(Line(plot.pixels(*(outline - centre).T), "object", 1.5))
    lines.append(Line(disc(plot.pixels(0, 0)[0], 7), "camera", 2.5, closed=True))
    ticks, beyond = (-REACH, 0, REACH), len(spots) - len(near)
    verb = "is" if beyond == 1 else "are"
    note = (Label(f"{beyond} of them {verb} outside", (284, 42), anchor="end"),) if beyond else ()
    return Picture(
        f"{TRIALS} tries, enlarged",
        f"{TRIALS} tries scatter around the camera's true place: {spread[0]:.2f} mm the longest "
        f"way, {spread[1]:.2f} mm the shortest. The ellipse has twice these radii.",
        ZOOM_SIZE,
        lines=tuple(lines),
        labels=(
            *plot.ticks(ticks, ticks),
            *plot.names("error in x (mm)", "error in y (mm)"),
            *note,
        ),
    )


def _empty(words: str) -> Picture:
    sentence, reason = words.split(": ")
    labels = (
        Label(f"{sentence}:", (150, 140), anchor="middle"),
        Label(reason, (150, 160), anchor="middle"),
    )
    return Picture(f"{TRIALS} tries, enlarged", words, ZOOM_SIZE, labels=labels)
