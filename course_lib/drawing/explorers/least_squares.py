"""Least squares by hand: a line through readings, its squares, and the parabolas of their sum."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.explorers.frame import Frame, Handle, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot, disc
from course_lib.least_squares import fit_line

Floats = NDArray[np.float64]

#: A steel bar is pulled: loads in kN, and the strain that was read, in millionths.
LOADS = np.array([1.0, 2, 3, 4, 5, 6, 7, 8])
STRAINS = np.array([74.0, 95, 171, 196, 262, 277, 355, 381])
SLIPPED, SLIP = 6, 190.0  # the reading that a slipped gauge changes, and by how much
SLOPES, INTERCEPTS = (10.0, 80.0), (-100.0, 140.0)
SIZE, SIDE = (440, 340), (280, 340)  # px
PLOT = Plot((52, 424, 28, 296), (0, 9), (-100, 600))
LARGEST = 160.0  # thousands of millionths squared: the top of the parabolas


def least_squares_frame(m: float, c: float, slipped: bool = False, best: bool = False) -> Frame:
    """Return a line through readings, with the square of each residual.

    Parameters
    ----------
    m : float
        Slope of the line, millionths a kN.
    c : float
        Its height at load zero, millionths.
    slipped : bool
        Whether one reading is wrong.
    best : bool
        Whether the line of least squares is drawn too, and told in numbers.

    Returns
    -------
    Frame
        The readings, the sum of squares against the slope and against the height, and numbers.
    """
    y = readings(slipped)
    slope, intercept = fit_line(LOADS, y)
    total = squares(m, c, y)
    numbers: tuple[Readout, ...] = (Readout("Sum of the squares", "E²", f"{total:.0f}"),)
    if best:
        numbers += (
            Readout("Smallest possible", "", f"{squares(slope, intercept, y):.0f}"),
            Readout("Best slope", "", f"{slope:.1f}", "/kN"),
            Readout("Best height", "", f"{intercept:.1f}"),
        )
    pictures = (
        _readings(m, c, y, total, (slope, intercept) if best else None),
        _parabola("m", SLOPES, np.array([squares(s, c, y) for s in _range(SLOPES)]), m, total),
        _parabola(
            "c", INTERCEPTS, np.array([squares(m, h, y) for h in _range(INTERCEPTS)]), c, total
        ),
    )
    return Frame(pictures, numbers)


def readings(slipped: bool = False) -> Floats:
    """Return the strains that were read, in millionths; one of them is wrong if `slipped`."""
    y = STRAINS.copy()
    y[SLIPPED] += SLIP * slipped
    return y


def squares(m: float, c: float, y: Floats) -> float:
    """Return the sum of the squared residuals of a line."""
    return float(((y - m * LOADS - c) ** 2).sum())


def _range(ends: tuple[float, float]) -> Floats:
    return np.linspace(*ends, 61)


def _readings(
    m: float, c: float, y: Floats, total: float, best: tuple[float, float] | None
) -> Picture:
    """Return the readings, the line with its two handles, and a square on each residual."""
    lines = [
        PLOT.frame(),
        *(_square(x, strain, m * x + c) for x, strain in zip(LOADS, y, strict=True)),
    ]
    if best:
        lines.append(Line(_line(*best), "image", 2.0, dashed=True))
    lines.append(Line(_line(m, c), "camera", 2.5))
    lines += [Line(disc(at, 4), "ink", 1.0, closed=True, fill=1.0) for at in PLOT.pixels(LOADS, y)]
    worst = int(np.argmax(np.abs(y - m * LOADS - c)))
    return Picture(
        "Drag the line by its spots",
        f"Eight readings of strain against load and the line {m:g} · load + {c:g}. The sum of the "
        f"squares is {total:.0f}; the largest belongs to the reading at {LOADS[worst]:g} kN.",
        SIZE,
        lines=tuple(lines),
        labels=(
            *PLOT.ticks((0, 2, 4, 6, 8), (0, 200, 400, 600)),
            *PLOT.names("load (kN)", "strain (millionths)"),
        ),
        handles=_handles(m, c),
    )


def _line(m: float, c: float) -> Floats:
    """Return a line where it lies inside the axes."""
    x = np.linspace(*PLOT.x, 181)
    return PLOT.pixels(x, m * x + c)


def _square(x: float, strain: float, on_line: float) -> Line:
    """Return the square whose side is the residual, px by px."""
    (u, v), foot = PLOT.at(x, strain), PLOT.at(x, float(np.clip(on_line, *PLOT.y)))[1]
    side = abs(v - foot)
    side = side if u + side < SIZE[0] - 4 else -side
    corners = [(u, v), (u, foot), (u + side, foot), (u + side, v)]
    return Line(corners, "object", 1.2, closed=True, fill=0.22)


def _handles(m: float, c: float) -> tuple[Handle, ...]:
    """Return a spot at load zero that moves the height, and one far right that turns the line."""
    top, bottom = PLOT.box[2:]
    unit = (PLOT.y[1] - PLOT.y[0]) / (bottom - top)  # strain a px
    zero = PLOT.y[0] + unit * bottom  # strain at v = 0
    far = 8.5
    spots = [Handle(PLOT.at(0, float(np.clip(c, *PLOT.y))), (("c", zero, 0.0, -unit),), "camera")]
    end = float(np.clip(m * far + c, *PLOT.y))
    turn = ("m", (zero - c) / far, 0.0, -unit / far)
    return (*spots, Handle(PLOT.at(far, end), (turn,), "camera"))


def _parabola(
    name: str, ends: tuple[float, float], sums: Floats, here: float, total: float
) -> Picture:
    """Return the sum of squares against one unknown, while the other one stays."""
    words = {"m": ("slope m", "slope"), "c": ("height c", "height")}[name]
    plot = Plot((46, 266, 28, 296), ends, (0, LARGEST))
    lowest = int(np.argmin(sums))
    lines = [plot.frame(), Line(plot.pixels(_range(ends), sums / 1000), "ray", 2.5)]
    if total / 1000 <= LARGEST:
        spot = plot.at(here, total / 1000)
        lines.append(Line(disc(spot, 5), "camera", 2.0, closed=True, fill=1.0))
    ticks = (20, 40, 60, 80) if name == "m" else (-100, 0, 100)
    return Picture(
        f"E² against the {words[1]}",
        f"The sum of the squares against the {words[0]}: a parabola, lowest near "
        f"{_range(ends)[lowest]:.0f}, where it is {sums[lowest]:.0f}; now it is {total:.0f}.",
        SIDE,
        lines=tuple(lines),
        labels=(
            *plot.ticks(ticks, (0, 50, 100, 150)),
            *plot.names(words[0], "E² (thousands)"),
        ),
    )
