"""The distortion explorer: twelve coefficients, what they do to a picture, how far they hold."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from course_lib.distortion import (
    displacement_field,
    distort,
    distort_pixels,
    pixel_grid,
    valid_radius,
)
from course_lib.drawing.distortion.models import straight_lines
from course_lib.drawing.distortion.pictures import SIZE, K, house_through
from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot, disc

Floats = NDArray[np.float64]

#: The coefficients in OpenCV's order; they are the names of the sliders.
NAMES = ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4")
PLOT_SIZE = (280, 240)
PROFILE = Plot((34, 268, 26, 200), (0.0, 1.6), (0.0, 1.6))
#: Distance of the picture's corner from the centre, by the focal length.
CORNER = float(np.hypot(*(np.array(SIZE) - 1)) / 2 / K[0, 0])
#: Points on a line of the grid.
STEPS = 24
#: px: a longest arrow is drawn so long; a displacement smaller than the other is none.
ARROW, NONE = 26.0, 0.05
#: To the right and down, as parts of half the picture: the ways on which iso-lines are numbered.
WAYS = ((1, 0), (1, -1), (1, 1), (-1, -1), (-1, 1), (0, -1), (-1, 0), (1, -0.6), (-1, -0.6))


def distortion_frame(**coefficients: float) -> Frame:
    """Return a house through a lens with distortion, its displacements and its profile.

    Parameters
    ----------
    **coefficients
        Any of `NAMES`, no unit; the others are zero.

    Returns
    -------
    Frame
        The picture with a grid of straight lines, the field of displacements, r_d against r, and
        the numbers.
    """
    lens = np.array([coefficients.get(name, 0.0) for name in NAMES])
    limit = valid_radius(lens)
    corners = pixel_grid(SIZE, 2, 2).reshape(-1, 2)
    # Only what does not lie beyond the fold is the image of anything.
    seen = limit > CORNER
    moved = float(np.hypot(*displacement_field(corners, K, lens).T).max())
    aside = float(np.hypot(*displacement_field(corners, K, lens, "tangential").T).max())
    readouts = (
        Readout("Corner moves by", "", f"{moved:.1f}" if seen else "–", "px" if seen else ""),
        Readout("of it tangential", "", f"{aside:.1f}", "px"),
        Readout("Valid radius", "r", "∞" if np.isinf(limit) else f"{limit:.2f}"),
        Readout("Corner of the picture at", "", f"{CORNER:.2f}"),
    )
    return Frame((_house(lens, limit), _field(lens, limit), _profile(lens, limit)), readouts)


def _house(lens: Floats, limit: float) -> Picture:
    """Return the house through the lens, with a grid of straight lines."""
    grid = np.array(straight_lines(steps=STEPS)).reshape(-1, 2)  # bent in one go
    bent = _within(distort_pixels(grid, K, lens), grid, limit).reshape(-1, STEPS, 2)
    lines = [Line(line, "object", 1.5) for line in bent]
    # How far the middle of the upper and of the lower edge bulges out, against its ends.
    edges = distort_pixels(pixel_grid(SIZE, 3, 2).reshape(-1, 2), K, lens)[:, 1].reshape(2, 3)
    above, below = edges[:, [0, 2]].mean(axis=1) - edges[:, 1]
    tilt = edges[:, 2] - edges[:, 0]
    reach = _radial(np.array([limit]), lens)[0] if limit < np.inf else np.inf
    fold = " No ray reaches the corners of the picture." if reach < CORNER else ""
    return Picture(
        "Through the lens",
        f"A house with a grid of straight lines. The line at the upper edge is "
        f"{_bend(above, tilt[0])}, that at the lower edge {_bend(-below, tilt[1])}.{fold}",
        SIZE,
        house_through(lens),
        lines=tuple(lines),
        pixels=True,
    )


def _bend(outwards: float, tilt: float) -> str:
    """Return in words how far a line's middle lies farther out, and its right end farther down."""
    words = []
    if abs(outwards) >= 0.5:
        words = [f"bent {'outwards' if outwards > 0 else 'inwards'} by {abs(outwards):.0f} px"]
    if abs(tilt) >= 0.5:
        words.append(f"{'down' if tilt > 0 else 'up'} at its right end by {abs(tilt):.0f} px")
    return " and ".join(words) or "straight"


def _within(bent: Floats, ideal: Floats, limit: float) -> Floats:
    """Return distorted pixels with NaN where the ideal ones lie beyond the valid radius."""
    away = np.hypot(*((ideal - K[:2, 2]) / K[0, 0]).T)
    near = (np.abs(bent - K[:2, 2]) < 2 * SIZE[0]).all(axis=1)
    return np.where(((away < limit) & near)[:, None], bent, np.nan)


def _field(lens: Floats, limit: float) -> Picture:
    """Return arrows from where a pinhole images a ray to where the lens does, and iso-lines."""
    from contourpy import contour_generator

    fine = pixel_grid(SIZE, 41, 31)
    moved = _moved(fine.reshape(-1, 2), lens, limit).reshape(fine.shape)
    distance = np.hypot(moved[..., 0], moved[..., 1])
    largest = float(np.nanmax(distance))
    places = pixel_grid(SIZE, 13, 10)[1:-1, 1:-1].reshape(-1, 2)
    arrows = _moved(places, lens, limit)
    longest = max(float(np.nanmax(np.hypot(*arrows.T))), NONE)
    lines = [Line(_arrows(places, arrows * min(ARROW / longest, 500)), "ray", 1.5)]
    labels: list[Label] = []
    generator = contour_generator(fine[..., 0], fine[..., 1], np.ma.masked_invalid(distance))
    for level in reversed(_levels(largest)):  # the outer lines have fewer places for a number
        lines += [Line(np.asarray(p, float), "camera", 1.2) for p in generator.lines(level)]
        labels += _level_label(level, distance, fine, labels)
    lines.append(Line(disc(K[:2, 2], 3), "ink", 1.0, closed=True, fill=1.0))
    return Picture(
        "Displacement in px",
        f"Arrows from ideal to distorted pixels, and lines of equal displacement, up to "
        f"{largest:.1f} px.",
        SIZE,
        lines=(*lines, _border()),
        labels=tuple(labels),
    )


def _moved(pixels: Floats, lens: Floats, limit: float) -> Floats:
    """Return displacements in px, NaN beyond the valid radius."""
    return _within(displacement_field(pixels, K, lens) + pixels, pixels, limit) - pixels


def _levels(largest: float) -> list[float]:
    """Return four or five round numbers below the largest displacement."""
    if largest < NONE:
        return []
    step = 10 ** np.floor(np.log10(largest / 4))
    step *= max(m for m in (1, 2, 5) if m * step <= largest / 3)
    return [float(level) for level in np.arange(1, 12) * step if level < largest]


def _level_label(level: float, distance: Floats, fine: Floats, others: list[Label]) -> list[Label]:
    """Return the number of an iso-line, where one of several ways from the centre crosses it.

    The first way is to the right; a corner's is taken where that does not reach the line, or would
    write over another number.
    """
    rows, columns = distance.shape
    steps = np.linspace(0, 1, 60)
    for right, down in WAYS:
        row = np.rint((rows - 1) * (1 + down * steps) / 2).astype(int)
        column = np.rint((columns - 1) * (1 + right * steps) / 2).astype(int)
        over = np.flatnonzero(distance[row, column] > level)
        if not len(over) or over[0] == 0:
            continue
        u, v = fine[row[over[0]], column[over[0]]]
        u, v = min(max(float(u), 16.0), SIZE[0] - 16.0), min(max(float(v), 14.0), SIZE[1] - 8.0)
        if all(max(abs(u - o.at[0]) / 30, abs(v - o.at[1]) / 16) >= 1 for o in others):
            return [Label(f"{level:g}", (u, v), anchor="middle")]
    return []


def _arrows(places: Floats, moves: Floats) -> Floats:
    """Return arrows as one polyline: shaft, head, and a NaN row between two arrows."""
    tips = places + moves
    aside = np.stack([-moves[:, 1], moves[:, 0]], axis=1)
    left, right = tips - 0.3 * moves + 0.16 * aside, tips - 0.3 * moves - 0.16 * aside
    gap = np.full_like(places, np.nan)
    return np.stack([places, tips, left, tips, right, gap], axis=1).reshape(-1, 2)


def _border() -> Line:
    """Return the edge of the picture."""
    width, height = SIZE
    return Line(
        [[0, 0], [width - 1, 0], [width - 1, height - 1], [0, height - 1]], "guide", 1, closed=True
    )


def _profile(lens: Floats, limit: float) -> Picture:
    """Return the radial terms as a curve, r_d against r, with the place where it folds over."""
    r = np.linspace(0, PROFILE.x[1], 160)
    r_d = _radial(r, lens)
    left, right = PROFILE.x
    inside = PROFILE.pixels([left, right, right, left], [0, 0, CORNER, CORNER])
    fold, mark = _fold(lens, limit)
    said = "never folds over" if np.isinf(limit) else f"folds over at r = {limit:.2f}"
    return Picture(
        "Distance from the centre",
        f"Distorted against ideal distance, by focal lengths; the curve {said}.",
        PLOT_SIZE,
        lines=(
            PROFILE.frame(),
            Line(inside, "guide", 0.5, closed=True, fill=0.12),
            Line(PROFILE.pixels(PROFILE.x, PROFILE.y), "guide", 1.2, dashed=True),
            Line(PROFILE.pixels(r, np.where(r < limit, r_d, np.nan)), "camera", 2.5),
            Line(PROFILE.pixels(r, np.where(r < limit, np.nan, r_d)), "guide", 1.5, dashed=True),
            *fold,
        ),
        labels=(
            *PROFILE.ticks((0, 0.5, 1, 1.5), (0.5, 1, 1.5)),
            *PROFILE.names("r of a pinhole", "r with the lens"),
            Label("picture", PROFILE.at(PROFILE.x[0], CORNER, 4, 9), "guide"),
            *mark,
        ),
    )


def _radial(r: Floats, lens: Floats) -> Floats:
    """Return distorted distances for ideal ones, by the radial terms."""
    radial = lens.copy()
    radial[[2, 3, 8, 9, 10, 11]] = 0
    return np.asarray(distort(np.stack([r, np.zeros_like(r)], axis=1), radial)[:, 0])


def _fold(lens: Floats, limit: float) -> tuple[list[Line], list[Label]]:
    """Return a dot and a word where the curve folds over, if that is inside of the plot."""
    if limit > PROFILE.x[1]:
        return [], []
    height = float(_radial(np.array([limit]), lens)[0])
    if not PROFILE.y[0] <= height <= PROFILE.y[1]:
        return [], []
    u, v = PROFILE.at(limit, height)
    word = Label(f"folds at {limit:.2f}", (u, v - 12), "object", "middle")
    return [Line(disc((u, v), 5), "object", 1.5, closed=True, fill=1.0)], [word]
