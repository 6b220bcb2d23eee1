"""The structured-light explorer: stripes from the side, seen from above, and the height in them."""

from __future__ import annotations

from functools import cache, lru_cache

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Probe, Readout
from course_lib.illumination import stripe_height

Floats = NDArray[np.float64]

SIZE, PIXEL = (400, 300), 0.1  # px, mm
PERIOD, WIDTH = 3.0, 0.8  # mm: of the pattern of many stripes
LINE_WIDTH = 0.6  # mm: of a single stripe
ONE, MANY = "one line", "many stripes"
HIDDEN = "This stripe meets an upright side, which is not seen from above."
SIDE_SIZE = (400, 190)
SIDE_ZERO, SIDE_SCALE = (200.0, 150.0), 9.6  # px of x = 0 on the table; px a mm
LIGHT, TABLE = np.array([255, 92, 70], np.float32), np.array([226, 226, 220], np.float32)


def structured_light_frame(
    shape: str, height: float, angle_deg: float, pattern: str, place: float
) -> Frame:
    """Return stripes on a thing from above, and the cut through its middle.

    Parameters
    ----------
    shape : str
        A key of `data_generators.relief.SHAPES`.
    height : float
        Of the thing, mm.
    angle_deg : float
        Between the light and the vertical, degrees.
    pattern : str
        `ONE` or `MANY`.
    place : float
        Of the stripe on the table, mm from the middle.

    Returns
    -------
    Frame
        The view from above with the height under the pointer, the view from the side, the
        numbers of the stripe.
    """
    angle = float(np.radians(angle_deg))
    heights = _heights(shape, height)
    row = heights[SIZE[1] // 2]
    seen, shift = _stripe_in_row(row, angle, place)
    found = float(stripe_height(abs(shift) * PIXEL, angle)) if np.isfinite(shift) else np.nan
    truth = float(np.interp(seen, np.arange(SIZE[0]), row)) if np.isfinite(seen) else np.nan
    words = f"The stripe is {abs(shift):.0f} px left of its place: {found:.2f} mm high."
    above = Picture(
        "Seen from straight above",
        f"Stripes of light, {angle_deg:g}° from the vertical, on a {shape} of {height:g} mm. "
        + (words if np.isfinite(shift) else HIDDEN),
        SIZE,
        _photograph(shape, height, angle, pattern, place),
        lines=_marks(seen, place),
        probes=(Probe("true height", "mm", heights[::10, ::10]),),
        pixels=True,
    )
    numbers = _readouts(shift, found, truth, angle)
    return Frame((above, _side(row, angle, place, seen, angle_deg)), numbers)


def _readouts(shift: float, found: float, truth: float, angle: float) -> tuple[Readout, ...]:
    """Return the numbers of the stripe: its shift in px, heights in mm."""
    px, mm = ("px", "mm") if np.isfinite(shift) else ("", "")
    return (
        Readout("Shift of the stripe", "s", _number(abs(shift), 1), px),
        Readout("The same on the table", "", _number(abs(shift) * PIXEL, 2), mm),
        Readout("Height from the shift", "h", _number(found, 2), mm),
        Readout("True height there", "", _number(truth, 2), mm),
        Readout("One pixel of shift means", "", f"{float(stripe_height(PIXEL, angle)):.3f}", "mm"),
    )


def _number(value: float, digits: int) -> str:
    return f"{value:.{digits}f}" if np.isfinite(value) else "not seen"


@lru_cache(maxsize=16)
def _heights(shape: str, height: float) -> Floats:
    from data_generators.relief import height_map

    return height_map(shape, height, SIZE, PIXEL)


def _photograph(
    shape: str, height: float, angle: float, pattern: str, place: float
) -> NDArray[np.uint8]:
    """Return the picture from above: room light on everything, red light in the stripes."""
    from data_generators.relief import ROOM, striped

    period, width = (1e6, LINE_WIDTH) if pattern == ONE else (PERIOD, WIDTH)
    light = striped(_heights(shape, height), angle, PIXEL, period, width, place)
    share = (light - np.float32(ROOM)) / np.float32(1 - ROOM)
    step = np.rint(share * 127).astype(np.uint8) + 128 * (_heights(shape, height) > 0)
    return np.asarray(_colours()[step])


@cache
def _colours() -> NDArray[np.uint8]:
    """Return 128 steps from room light to a stripe, on the table and then on the thing."""
    levels = np.arange(128, dtype=np.float32)[:, None] / 127
    table = [TABLE * np.float32(dark) * (1 - levels) + LIGHT * levels for dark in (0.55, 0.72)]
    return np.rint(np.concatenate(table)).astype(np.uint8)


def _stripe_in_row(row: Floats, angle: float, place: float) -> tuple[float, float]:
    """Return the column where the stripe of a place on the table is seen, and its shift, px.

    Both are NaN where that light meets an upright side of the thing, which cannot be seen.
    """
    from data_generators.relief import on_the_table

    where, lit = (found[0] for found in on_the_table(row[None], angle, PIXEL))
    upright = np.abs(np.diff(row)) > 0.25 * row.max()
    between = (where[:-1] - place) * (where[1:] - place) <= 0
    steps = np.flatnonzero(lit[:-1] & lit[1:] & between & ~upright)
    nearest = int(np.where(lit, np.abs(where - place), np.inf).argmin())
    if steps.size:
        k = int(steps[0])
        seen = k + (place - where[k]) / (where[k + 1] - where[k])
    elif abs(where[nearest] - place) <= 0.75 * PIXEL:
        seen = nearest
    else:
        return np.nan, np.nan
    zero = place / PIXEL + (len(row) - 1) / 2
    return float(seen), float(zero - seen)


def _marks(seen: float, place: float) -> tuple[Line, ...]:
    """Return where the stripe would be on the empty table, and its shift in the middle row."""
    zero, middle = place / PIXEL + (SIZE[0] - 1) / 2, SIZE[1] / 2
    rest = Line([[zero, 0], [zero, SIZE[1]]], "guide", 1.5, dashed=True)
    if not np.isfinite(seen):
        return (rest,)
    return (rest, Line([[seen, middle], [zero, middle]], "camera", 3.0))


def _side(row: Floats, angle: float, place: float, seen: float, angle_deg: float) -> Picture:
    """Return the cut through the middle row, with the ray of the stripe."""
    x = (np.arange(len(row)) - (len(row) - 1) / 2) * PIXEL
    outline = [[-20, 0], *np.stack([x, row], axis=1)[::2], [20, 0], [20, -1.5], [-20, -1.5]]
    lines = [
        Line(_on_side(outline), "guide", 1.0, True, fill=0.25),
        Line(_on_side([[place, 0], [place - 14 * np.tan(angle), 14]]), "guide", 1.0, dashed=True),
    ]
    labels = [Label("light", _spot(place, angle), "ray", "end")]
    if np.isfinite(seen):
        at = (seen - (len(row) - 1) / 2) * PIXEL
        lines += _triangle(at, float(np.interp(seen, np.arange(len(row)), row)), angle, place)
        u, v = _on_side([[at, 12.5]])[0]
        labels.append(Label("to the camera", (float(u) + 6, float(v)), "camera"))
    else:
        lines.append(Line(_on_side(_stopped(row, angle, place)), "ray", 2.5))
    return Picture(
        "From the side: the middle row, cut",
        f"Light falls from the left, {angle_deg:g}° from the vertical; the camera is above.",
        SIDE_SIZE,
        lines=tuple(lines),
        labels=tuple(labels),
    )


def _triangle(x: float, height: float, angle: float, place: float) -> list[Line]:
    """Return the ray to where the stripe is seen, the line of sight, the shift and the height."""
    return [
        Line(_on_side([[x - (13 - height) * np.tan(angle), 13], [x, height]]), "ray", 2.5),
        Line(_on_side([[x, height], [x, 14]]), "camera", 2.0),
        Line(_on_side([[x, 0], [place, 0]]), "camera", 4.0),
        Line(_on_side([[x, 0], [x, height]]), "object", 3.0),
    ]


def _stopped(row: Floats, angle: float, place: float) -> Floats:
    """Return the light of a place on the table, from above to the upright side that stops it."""
    z = np.linspace(13, 0, 651)
    x = place - z * np.tan(angle)
    surface = np.interp(x, (np.arange(len(row)) - (len(row) - 1) / 2) * PIXEL, row)
    k = int((surface >= z).argmax())
    return np.array([[x[0], z[0]], [x[k], z[k]]])


def _spot(place: float, angle: float) -> tuple[float, float]:
    """Return where the word beside the ray stands, kept inside the drawing."""
    u, v = _on_side([[place - 9.5 * np.tan(angle), 9.5]])[0]
    if u >= 90 and angle < 0.9:
        return float(u) - 8, float(v)
    # At the left edge, and beside a flat ray, it stands below the ray.
    right = max(float(u) - 8, 44.0)
    z = (place - (right - SIDE_ZERO[0]) / SIDE_SCALE) / np.tan(angle)
    return right, float(_on_side([[0, z]])[0, 1]) + 16


def _on_side(points: object) -> Floats:
    """Return pixels of the cut from x and height, mm."""
    return np.asarray(SIDE_ZERO) + SIDE_SCALE * np.asarray(points, float) * [1, -1]
