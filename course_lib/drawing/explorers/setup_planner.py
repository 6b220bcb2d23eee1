"""The set-up planner: what two cameras would see of the panel, and whether it is good enough."""

from __future__ import annotations

import textwrap
from collections import Counter
from collections.abc import Iterable, Mapping
from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera
from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import lifted
from course_lib.drawing.planning.choosing import shown
from course_lib.drawing.planning.panel import BOX, TASK, close_up, overview, stand
from course_lib.planning import (
    CameraModel,
    LensModel,
    Setup,
    Verdict,
    judge_setup,
    read_cameras,
    read_lenses,
)

Floats = NDArray[np.float64]
Pixels = NDArray[np.uint8]

VIEW_SIZE, PIXELS_SIZE, TABLE_SIZE = (320, 320), (148, 320), (470, 320)
SIDE, TIMES = 46, 3  # px of a close-up, and by how much it is enlarged
TOPS = (20, 180)  # px: where the close-ups begin
TABLE = "Verdicts, and why or what would help"
ROW = 31  # px: height of a row of the table
MOST = 9  # names of lenses that the table has room for
#: Demands whose number must not be smaller than the limit; the others', not larger.
AT_LEAST = ("in view", "closest focus", "image circle", "frame rate", "light")


@cache
def cameras() -> dict[str, CameraModel]:
    """Return the cameras of the catalogue that stand on the ground, by a short name."""
    flying = ("Phantom 4 RTK", "DJI DL")
    return short_names(c for c in read_cameras().values() if c.mount not in flying)


@cache
def lenses() -> dict[str, LensModel]:
    """Return the lenses that fit one of the cameras, by name."""
    mounts = {camera.mount for camera in cameras().values()}
    return {name: lens for name, lens in read_lenses().items() if lens.mount in mounts}


def short_names(given: Iterable[CameraModel]) -> dict[str, CameraModel]:
    """Return cameras by what stands before the first comma in their names, if that is enough."""
    cameras = list(given)
    short = [camera.name.partition(",")[0] for camera in cameras]
    alike = Counter(short)
    return {s if alike[s] == 1 else c.name: c for s, c in zip(short, cameras, strict=True)}


def setup_frame(
    camera: str,
    lens: str,
    Z: float,
    turn_deg: float,
    N: float,
    t: float,
    *,
    bodies: Mapping[str, CameraModel] | None = None,
    glasses: Mapping[str, LensModel] | None = None,
) -> Frame:
    """Return what a pair of cameras sees of the panel, and the verdicts on it.

    Parameters
    ----------
    camera, lens : str
        Their names.
    Z : float
        Distance from the middle of the box, m.
    turn_deg : float
        How far each camera stands to the side of straight ahead, degrees.
    N : float
        f-number; the lens's nearest if it has none so small or so large.
    t : float
        Exposure time, µs.
    bodies, glasses : mapping, optional
        All cameras and lenses by name; those of the catalogue unless given.

    Returns
    -------
    Frame
        The right camera's picture, pixels of it, and a table of verdicts.
    """
    bodies, glasses = bodies or cameras(), glasses or lenses()
    body, glass = bodies[camera], glasses[lens]
    if body.mount != glass.mount:
        fitting = [name for name, other in glasses.items() if other.mount == body.mount]
        return _does_not_fit(camera, body.mount, glass, fitting)
    N = float(np.clip(N, glass.N_least, glass.N_most))
    turn = np.radians(turn_deg)
    one, other = (stand(body, glass, Z, side * turn, N, t / 1e6) for side in (1, -1))
    verdicts = judge_setup(one, TASK, other)
    missed = [verdict for verdict in verdicts if not verdict.met]
    readouts = (
        Readout("Demands met", "", f"{len(verdicts) - len(missed)} of {len(verdicts)}"),
        Readout("f-number", "N", f"{N:g}"),
        Readout("Focus distance", "s", f"{one.focus_distance:.3f}", "m"),
        Readout("Distance of the two cameras", "", f"{2 * Z * np.sin(turn):.2f}", "m"),
    )
    return Frame((_view(one, verdicts[0].met), _pixels(one), _table(verdicts)), readouts)


def _view(setup: Setup, inside: bool) -> Picture:
    """Return the whole picture, the box drawn into it, on white."""
    camera, picture = overview(setup, VIEW_SIZE[0])
    paper = np.full((VIEW_SIZE[1], VIEW_SIZE[0], 3), 255, np.uint8)
    paper[: len(picture)] = picture
    what = "lies in the picture" if inside else "is cut off by the edge of the picture"
    return Picture(
        "Through the right camera",
        f"The panel through {setup.lens.name} from {np.linalg.norm(setup.eye):.2f} m; "
        f"its box, with its motion, {what}.",
        VIEW_SIZE,
        paper,
        lines=(Line(_outline(camera), "image" if inside else "object", 2.0),),
    )


def _outline(camera: Camera) -> Floats:
    """Return the edges of the box with its motion, where they are in the picture."""
    points = camera.project(BOX.with_motion(TASK.motion).outline).reshape(12, -1, 2)
    limit = np.array(camera.image_size) - 0.5
    points[((points < -0.5) | (points > limit)).any(axis=-1)] = np.nan
    return lifted(points)


def _pixels(setup: Setup) -> Picture:
    """Return pixels at the near and at the far end of the box, enlarged."""
    paper = np.full((PIXELS_SIZE[1], PIXELS_SIZE[0], 3), 255, np.uint8)
    large = SIDE * TIMES
    for end, top in enumerate(TOPS):
        detail = close_up(setup, end, SIDE).repeat(TIMES, axis=0).repeat(TIMES, axis=1)
        paper[top : top + large, 5 : 5 + large] = detail
    names = ("near end", "far end")
    labels = tuple(Label(n, (5, top - 10)) for n, top in zip(names, TOPS, strict=True))
    return Picture(
        "Pixel by pixel",
        f"{SIDE} × {SIDE} pixels at both ends of the box, at f/{setup.N:g} and "
        f"{1e6 * setup.exposure_time:.0f} µs, focused on {setup.focus_distance:.3f} m.",
        PIXELS_SIZE,
        paper,
        labels=labels,
    )


def _table(verdicts: list[Verdict]) -> Picture:
    """Return the verdicts, each with its reason, or with what would help if it is not met."""
    labels: list[Label] = []
    for number, verdict in enumerate(verdicts):
        labels += _row(verdict, 10 + ROW * number)
    missed = [verdict.name for verdict in verdicts if not verdict.met]
    words = f"not met: {', '.join(missed)}" if missed else "all demands are met"
    told = " ".join(map(_in_words, verdicts))
    return Picture(
        TABLE,
        f"Table of {len(verdicts)} demands; {words}. {told}",
        TABLE_SIZE,
        labels=tuple(labels),
    )


def _row(verdict: Verdict, v: float) -> list[Label]:
    """Return a demand, its number and its limit; below, why it is met or what would help."""
    role, below = ("image", "guide") if verdict.met else ("object", "object")
    why = verdict.reason if verdict.met else verdict.remedy
    return [
        Label("✓" if verdict.met else "✗", (4, v), role),
        Label(verdict.name, (22, v), role),
        Label(f"{shown(verdict.value)} {verdict.unit}", (150, v)),
        Label(_limit(verdict), (256, v), "guide"),
        Label(textwrap.shorten(why, 76, placeholder=" …"), (22, v + 13), below),
    ]


def _limit(verdict: Verdict) -> str:
    """Return what a demand asks for."""
    bound = "at least" if verdict.name in AT_LEAST else "at most"
    return f"{bound} {shown(verdict.limit)} {verdict.unit}"


def _in_words(verdict: Verdict) -> str:
    """Return a verdict in sentences: number and limit, why, and what would help."""
    met = "met" if verdict.met else "not met"
    number = f"{verdict.name}: {shown(verdict.value)} {verdict.unit}, {_limit(verdict)}, {met}."
    return f"{number[0].upper()}{number[1:]} {verdict.reason} {verdict.remedy}".rstrip()


def _does_not_fit(camera: str, mount: str, glass: LensModel, fitting: list[str]) -> Frame:
    """Return a frame that says why there is no picture, and which lenses would fit."""
    words = f"{glass.name} has the mount {glass.mount}, {camera} has {mount}"
    table = [Label("This lens does not fit:", (4, 20), "object")]
    table += [Label(line, (22, 42 + 20 * i)) for i, line in enumerate(words.split(", ", 1))]
    table += [Label("These lenses fit this camera:", (4, 106))]
    names = fitting or ["none"]
    table += [Label(name, (22, 128 + 20 * i)) for i, name in enumerate(names[:MOST])]
    empty = f"No picture: {words}."
    told = f"{empty} These lenses fit this camera: {', '.join(names)}."
    pictures = (
        Picture("Through the right camera", empty, VIEW_SIZE),
        Picture("Pixel by pixel", empty, PIXELS_SIZE),
        Picture(TABLE, told, TABLE_SIZE, labels=tuple(table)),
    )
    return Frame(pictures, (Readout("No set-up", "", "the lens does not fit the camera"),))
