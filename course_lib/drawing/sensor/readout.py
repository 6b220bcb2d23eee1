"""Still figures: how a sensor is read, and what moves while it is exposed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.diagrams import figure, fit, panels, sketch, stroke, write
from course_lib.drawing.style import BLACK, BLUE, FULL_WIDTH, GREEN, GREY, ORANGE, RED

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

CELL = 0.9  # side of a drawn pixel
SMALL: dict[str, Any] = {"fontsize": 9, "va": "top"}


@figure(
    "Three sensors of 4 by 4 pixels: an interline CCD with covered columns, a frame-transfer "
    "CCD with a covered half below, a CMOS sensor with an amplifier in each pixel."
)
def ways_of_reading() -> Figure:
    """Show how charge leaves an interline CCD, a frame-transfer CCD and a CMOS sensor.

    Returns
    -------
    Figure
        Three sensors of 4 × 4 pixels: green collects light, grey is covered by metal.
    """
    fig, axes = panels(1, 3, (FULL_WIDTH, 3.9))
    titles = ("CCD, interline", "CCD, frame transfer", "CMOS")
    for ax, title, draw in zip(axes, titles, (_interline, _frame_transfer, _cmos), strict=True):
        sketch(ax, title)
        draw(ax)
        fit(ax, -1.0, 8.6, -4.6, 8.4)
    return fig


def _cell(ax: Axes, x: float, y: float, colour: str, height: float = 1.0) -> None:
    right, top = x + CELL, y + height * CELL
    ax.fill([x, right, right, x], [y, y, top, top], color=colour, alpha=0.75, ec="white", lw=0.8)


def _arrow(ax: Axes, start: tuple[float, float], end: tuple[float, float], colour: str) -> None:
    arrow = {"arrowstyle": "-|>", "color": colour, "shrinkA": 0, "shrinkB": 0, "lw": 1.4}
    ax.annotate("", xy=end, xytext=start, arrowprops=arrow)


def _out(ax: Axes, width: float, y: float) -> None:
    """Draw the register at the bottom, the amplifier behind it and its number."""
    ax.fill([0, width, width, 0], [y, y, y - CELL, y - CELL], color=GREY, alpha=0.75)
    _arrow(ax, (0.3, y - CELL / 2), (width - 0.2, y - CELL / 2), "white")
    ax.fill([width + 0.1, width + 0.1, width + 1.1], [y + 0.1, y - 1.0, y - CELL / 2], color=BLUE)
    write(ax, (width / 2, y - CELL - 0.6), "register and one amplifier", fontsize=9)


def _interline(ax: Axes) -> None:
    for column in range(4):
        for row in range(4):
            _cell(ax, 1.8 * column, 1.8 * row + 0.4, GREEN, 1.6)
            _cell(ax, 1.8 * column + CELL, 1.8 * row + 0.4, GREY, 1.6)
            y = 1.8 * row + 1.1
            _arrow(ax, (1.8 * column + 0.4, y), (1.8 * column + 1.3, y), ORANGE)
        _arrow(ax, (1.8 * column + 1.35, 0.75), (1.8 * column + 1.35, -0.15), BLACK)
    _out(ax, 7.2, -0.2)
    write(
        ax, (3.6, -2.9), "1 all charges step aside\n2 then down, row by row", fontsize=9, va="top"
    )


def _frame_transfer(ax: Axes) -> None:
    for column in range(4):
        for row in range(4):
            _cell(ax, 1.3 * column + 1.0, row + 4.3, GREEN)
            _cell(ax, 1.3 * column + 1.0, row + 0.2, GREY)
        x = 1.3 * column + 1.45
        _arrow(ax, (x, 6.6), (x, 2.0), ORANGE)
    _out(ax, 6.2, -0.2)
    write(
        ax,
        (3.6, -2.9),
        "1 the whole picture shifts down\n2 then out, row by row",
        fontsize=9,
        va="top",
    )


def _cmos(ax: Axes) -> None:
    for column in range(4):
        for row in range(4):
            x, y = 1.7 * column + 0.4, 1.9 * row + 0.5
            _cell(ax, x, y, GREEN, 1.5)
            ax.fill([x + 0.95, x + 0.95, x + 1.4], [y + 0.55, y + 0.1, y + 0.32], color=BLUE)
        x = 1.7 * column + 1.85
        stroke(ax, [(x, 8.0), (x, -0.9)], color=BLACK, lw=1)
    for row in range(4):
        stroke(ax, [(0.1, 1.9 * row + 0.35), (7.1, 1.9 * row + 0.35)], "guide", lw=1)
        write(ax, (-0.55, 1.9 * row + 1.1), str(4 - row), fontsize=9)
    ax.fill([0.4, 7.2, 7.2, 0.4], [-0.9, -0.9, -1.5, -1.5], color=RED, alpha=0.6)
    write(ax, (3.8, -2.1), "one converter a column", fontsize=9)
    write(ax, (3.6, -2.9), "an amplifier in each pixel;\nrow 1, row 2, …", fontsize=9, va="top")


@figure(
    "Row against time for a global shutter, where all rows are exposed at once and read "
    "later, and for a rolling one, where each row starts after the one above."
)
def shutters(rows: int = 8, exposure: float = 2.0, row_time: float = 0.7) -> Figure:
    """Show when each row of a sensor is exposed, with a global and with a rolling shutter.

    Parameters
    ----------
    rows : int
        How many are drawn.
    exposure, row_time : float
        How long each is exposed, and from one row's start to the next's, ms.

    Returns
    -------
    Figure
        Two diagrams of row against time.
    """
    fig, axes = panels(1, 2, (FULL_WIDTH, 2.6), sharey=True)
    for ax, delay, title in zip(axes, (0.0, row_time), ("global", "rolling"), strict=True):
        start = delay * np.arange(rows, dtype=np.float64)
        ax.barh(np.arange(rows), exposure, left=start, color=ORANGE, alpha=0.7, label="exposed")
        ax.barh(np.arange(rows), 0.25, left=_read(start, exposure, delay), color=BLUE, label="read")
        ax.set(xlabel="time (ms)", xlim=(0, rows * row_time + exposure + 0.6), title=title)
        ax.invert_yaxis()
    axes[0].invert_yaxis()
    axes[0].set_ylabel("row (px)")
    axes[0].legend(loc="lower right", fontsize=9)
    axes[0].set_ylim(rows - 0.4, -0.6)
    return fig


def _read(start: NDArray[np.float64], exposure: float, delay: float) -> NDArray[np.float64]:
    """Return when each row is read: at once after its exposure, or from a store, one by one."""
    if delay:
        return np.asarray(start + exposure)
    return exposure + 0.3 + 0.45 * np.arange(len(start), dtype=np.float64)


@figure(
    "A blurred photograph of a round clock, and its grey values along two cuts: long ramps in "
    "the horizontal one, steep edges in the vertical one."
)
def clock_blur(picture: ArrayLike, row: int = 150, column: int = 212) -> Figure:
    """Show a real photograph that was blurred by motion, and how long the blur is.

    Parameters
    ----------
    picture : array_like, shape (height, width)
        Grey; made for ``skimage.data.clock()``.
    row, column : int
        Of the two cuts through the middle of the clock, px.

    Returns
    -------
    Figure
        The photograph, and the grey values along both cuts.
    """
    grey = np.asarray(picture, dtype=float)
    fig, (photo, ax) = panels(1, 2, (FULL_WIDTH, 3.0), width_ratios=(1, 1.2))
    photo.imshow(grey, vmin=60, vmax=255)
    photo.set(xlabel="u (px)", ylabel="v (px)")
    photo.axhline(row, color=ORANGE, lw=1.5)
    photo.axvline(column, color=BLUE, lw=1.5)
    across = grey[row - 2 : row + 3].mean(axis=0)
    down = grey[:, column - 2 : column + 3].mean(axis=1)
    x = np.arange(grey.shape[1]) - column
    ax.plot(x, across, color=ORANGE, label="horizontal cut")
    ax.plot(np.arange(grey.shape[0]) - row, down, color=BLUE, lw=1.5, label="vertical cut")
    ax.set(xlabel="pixels from the middle (px)", ylabel="grey value (DN)", xlim=(-110, 110))
    ax.legend(loc="lower center", fontsize=8)
    return fig


@figure(
    "A picture of a pole that leans: its lower end lies farther to the right, as it moved on "
    "while the rows were read."
)
def skewed_pole(
    speed: float = 1800.0, row_time: float = 30e-6, yours: ArrayLike | None = None
) -> Figure:
    """Show an upright pole that passes a camera with a rolling shutter.

    Parameters
    ----------
    speed : float
        Of the pole in the picture, px/s, to the right.
    row_time : float
        From one row to the next, s.
    yours : array_like, shape (), optional
        The skew from top to bottom that a student's function gave, px.

    Returns
    -------
    Figure
        A picture of 320 × 480 px; the dashed line starts at the pole's top and ends where the
        student's number says.
    """
    from course_lib.drawing.diagrams import in_figures, picture_frame, same_shape
    from course_lib.sensor import rolling_shutter_skew

    width, height = 480, 320
    skew = float(rolling_shutter_skew(speed, row_time, height - 1))
    v, u = np.indices((height, width), dtype=float)
    middle = 200 + speed * row_time * v
    pole = np.clip(9.5 - np.abs(u - middle), 0, 1)
    fig, ax = panels(1, 1, (5.6, 3.9))
    sky = np.linspace(0.92, 0.72, height)[:, None, None] * np.ones((1, width, 3))
    ax.imshow(sky * (1 - pole[..., None]) + 0.15 * pole[..., None])
    picture_frame(ax, (width, height))
    stroke(ax, [(200, 0), (200, height - 1)], color=BLACK, lw=1.2, ls=(0, (5, 4)))
    write(ax, (185, 290), "dashed: upright", fontsize=9, ha="right")
    write(ax, (330, 60), "an upright pole that\nmoves to the right", fontsize=10)
    drawn = same_shape(yours, np.array(skew))
    if drawn is not None and np.isfinite(drawn):
        stroke(ax, [(200, 0), (200 + float(drawn), height - 1)], "second", lw=2.5, ls=(0, (5, 3)))
        write(ax, (330, 250), f"your skew: {in_figures(float(drawn), 1)} px")
    return fig
