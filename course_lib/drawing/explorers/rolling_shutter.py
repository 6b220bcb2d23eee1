"""The rolling-shutter explorer: a propeller, and when each row of the sensor looks at it."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout

if TYPE_CHECKING:
    from data_generators.propeller import Propeller

SIZE = 320  # px: side of the picture
SKY, DARK = (206, 222, 236), (40, 44, 52)
DIAGRAM_SIZE = (260, 320)
PLOT = (64.0, 246.0, 34.0, 272.0)  # px: left, right, top, bottom
LONGEST = 45.0  # ms: end of the time axis
ROLLING, GLOBAL = "rolling: row after row", "global: all rows at once"


def rolling_shutter_frame(
    turns: float, readout_ms: float, exposure_ms: float, blades: float, shutter: str
) -> Frame:
    """Return the photograph of a propeller, and the times at which its rows were exposed.

    Parameters
    ----------
    turns : float
        Turns of the propeller a second.
    readout_ms : float
        From the start of the first row's exposure to that of the last, ms.
    exposure_ms : float
        How long each row is exposed, ms.
    blades : float
        How many blades.
    shutter : str
        `ROLLING` or `GLOBAL`.

    Returns
    -------
    Frame
        The photograph, the diagram of row and time, and the numbers.
    """
    from data_generators.propeller import row_angles

    readout = readout_ms if shutter == ROLLING else 0.0
    propeller = _propeller(int(blades))
    smear = 2 * np.pi * turns * exposure_ms / 1000
    share = propeller.share(row_angles(SIZE, turns, readout / 1000), smear)
    during_readout, during_exposure = 0.36 * turns * readout, float(np.degrees(smear))
    blur = smear * propeller.radius
    photograph = Picture(
        "What the camera writes",
        f"A propeller of {blades:g} blades that turns by {during_readout:.0f}° while the rows "
        f"are read and by {during_exposure:.1f}° while each is exposed.",
        (SIZE, SIZE),
        _painted(share),
        pixels=True,
    )
    return Frame(
        (photograph, _diagram(readout, exposure_ms)),
        _readouts(during_readout, during_exposure, blur, readout),
    )


def _readouts(
    during_readout: float, during_exposure: float, blur: float, readout: float
) -> tuple[Readout, ...]:
    """Return the numbers: turns in degrees, the blur in px, the read-out in ms."""
    return (
        Readout("Turn from first to last row", "", f"{during_readout:.0f}", "°"),
        Readout("Turn during one exposure", "", f"{during_exposure:.1f}", "°"),
        Readout("Blur at the tips", "", f"{blur:.1f}", "px"),
        Readout("From one row to the next", "", f"{1000 * readout / (SIZE - 1):.0f}", "µs"),
    )


@lru_cache(maxsize=6)
def _propeller(blades: int) -> Propeller:
    from data_generators.propeller import Propeller

    return Propeller(SIZE, blades)


def _painted(share: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Return the propeller before the sky, from its share in each pixel."""
    level = np.rint(share * 255).astype(np.uint8)
    sky, dark = np.array(SKY, float), np.array(DARK, float)
    table = sky + (dark - sky) * np.arange(256)[:, None] / 255
    return np.asarray(np.rint(table).astype(np.uint8)[level])


def _diagram(readout: float, exposure: float) -> Picture:
    """Return row against time: each row is exposed for one horizontal stretch."""
    left, right, top, bottom = PLOT
    first, last = _at(0, 0), _at(readout, SIZE - 1)
    band = [first, _at(exposure, 0), _at(readout + exposure, SIZE - 1), last]
    ticks = tuple(
        Label(f"{t:g}", (_at(t, 0)[0], bottom + 14), anchor="middle") for t in (0, 10, 20, 30, 40)
    )
    return Picture(
        "When each row is exposed",
        f"The last row starts {readout:.1f} ms after the first; each is exposed for "
        f"{exposure:.2g} ms.",
        DIAGRAM_SIZE,
        lines=(
            Line([[left, top], [left, bottom], [right, bottom]], "guide", 1.2),
            Line(band, "ray", 1.5, closed=True, fill=0.35),
            Line(_some_rows(readout, exposure), "ray", 2.0),
        ),
        labels=(
            *ticks,
            Label("time in ms", ((left + right) / 2, bottom + 34), anchor="middle"),
            Label("first row", (left - 4, top + 4), anchor="end"),
            Label("last row", (left - 4, bottom - 6), anchor="end"),
        ),
    )


def _some_rows(readout: float, exposure: float) -> list[tuple[float, float]]:
    """Return the stretches of nine rows, with a lifted pen between them."""
    points = []
    for row in np.linspace(0, SIZE - 1, 9).tolist():
        start = readout * row / (SIZE - 1)
        points += [_at(start, row), _at(start + exposure, row), (np.nan, np.nan)]
    return points


def _at(time: float, row: float) -> tuple[float, float]:
    """Return a pixel of the diagram from a time in ms and a row of the photograph."""
    left, right, top, bottom = PLOT
    down = (bottom - top - 6) * row / (SIZE - 1)
    return left + (right - left) * time / LONGEST, top + down
