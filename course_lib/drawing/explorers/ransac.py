"""The RANSAC stepper: draw after draw, what a sample of eight pairs says, and who agrees."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.explorers.frame import Frame, Line, Picture, Readout
from course_lib.drawing.explorers.pairs import TOWARDS, photographs, true_pairs
from course_lib.drawing.explorers.plot import Plot, disc
from course_lib.epipolar import eight_point, ransac_iterations, sampson_error

Floats = NDArray[np.float64]

WIDTH = 340
SIZE, PLOT_SIZE = (340, 255), (300, 256)
PAIRS, SAMPLE, MOST = 60, 8, 300
NOISE = 0.3  # px, of each coordinate of a right pair
CONFIDENCE = 0.99
MANY = 1_000_000  # draws: more than anybody makes
HALF = np.array([0.0, 1.5])  # px: half of a tick of the history
PLOT = Plot((40, 284, 26, 218), (0, MOST), (0, PAIRS))


@dataclass(frozen=True, eq=False)
class Drawn:
    """Pairs of which some are wrong, and what every draw says of them.

    Attributes
    ----------
    points1, points2 : ndarray, shape (PAIRS, 2)
        Pixels of both pictures.
    right : ndarray of bool, shape (PAIRS,)
        Which pairs are right.
    samples : ndarray of int, shape (MOST, SAMPLE)
        The pairs of each draw.
    errors : ndarray, shape (MOST, PAIRS)
        Sampson errors of all pairs, for the matrix of each draw, px.
    """

    points1: Floats
    points2: Floats
    right: NDArray[np.bool_]
    samples: NDArray[np.intp]
    errors: Floats


@cache
def drawn(wrong: float) -> Drawn:
    """Return pairs of which so many percent are wrong, and `MOST` draws from them."""
    one, other, _ = true_pairs(TOWARDS, WIDTH, PAIRS)
    rng = np.random.default_rng(4)
    one, other = (points + NOISE * rng.normal(size=points.shape) for points in (one, other))
    right = rng.permutation(PAIRS) >= round(PAIRS * wrong / 100)
    other[~right] = rng.uniform((0, 0), SIZE, ((~right).sum(), 2))
    samples = np.array([rng.choice(PAIRS, SAMPLE, replace=False) for _ in range(MOST)])
    found = [eight_point(one[sample], other[sample]) for sample in samples]
    errors = np.array([sampson_error(one, other, F) for F in found])
    return Drawn(one, other, right, samples, errors)


def ransac_frame(n: int, wrong: float, threshold: float) -> Frame:
    """Return what draw number n says, and the best draw so far.

    Parameters
    ----------
    n : int
        Number of the draw, 1 to `MOST`.
    wrong : float
        Share of wrong pairs, %.
    threshold : float
        Largest Sampson error of a pair that agrees, px.

    Returns
    -------
    Frame
        The pairs of this draw, those of the best, and how many agreed with each draw.
    """
    all_draws = drawn(wrong)
    agree = all_draws.errors[: int(n)] <= threshold
    counts = agree.sum(axis=1)
    now, best = int(n) - 1, int(np.argmax(counts))
    share = min(counts[best] / PAIRS, 1.0)
    needed = ransac_iterations(CONFIDENCE, SAMPLE, 1 - share) if share > 0 else np.inf
    long = f"{needed:,}".replace(",", "\N{NARROW NO-BREAK SPACE}")
    long = long if needed <= MANY else "more than a million"
    good = int(all_draws.right[all_draws.samples[now]].sum())
    readouts = (
        Readout("Right pairs in this sample", "", f"{good} of {SAMPLE}"),
        Readout("Agree with this draw", "", f"{counts[now]} of {PAIRS}"),
        Readout("Most so far", "", f"{counts[best]}, draw {best + 1}"),
        Readout("Draws needed, by the best", "", long),
    )
    pictures = (
        _pairs(all_draws, now, agree[now], f"Draw {now + 1}: {counts[now]} agree"),
        _pairs(all_draws, best, agree[best], f"Best: draw {best + 1}, {counts[best]} agree"),
        _history(counts, int(all_draws.right.sum())),
    )
    return Frame(pictures, readouts)


def _pairs(all_draws: Drawn, number: int, agree: NDArray[np.bool_], title: str) -> Picture:
    """Return the left picture with a stroke from each point to where its partner is."""
    strokes = np.stack([all_draws.points1, all_draws.points2], axis=1)
    lines = []
    for role, which, width in (("object", ~agree, 1.2), ("image", agree, 2.0)):
        gaps = np.full((int(which.sum()), 1, 2), np.nan)
        path = np.concatenate([strokes[which], gaps], axis=1).reshape(-1, 2)
        lines.append(Line(path, role, width))
    starts = all_draws.points1[all_draws.samples[number]]
    lines += [Line(disc(at, 4.5), "camera", 2.5, closed=True) for at in starts]
    return Picture(
        title,
        f"The left picture with a stroke from each of {PAIRS} points to where its partner is in "
        f"the right one. {int(agree.sum())} pairs agree (green), the others do not (red). "
        "Rings: the eight pairs of the sample.",
        SIZE,
        photographs(TOWARDS, WIDTH)[0],
        lines=tuple(lines),
    )


def _history(counts: NDArray[np.intp], right: int) -> Picture:
    """Return how many pairs agreed with each draw, the most so far, and how many are right."""
    draws = np.arange(1, len(counts) + 1)
    spots = PLOT.pixels(draws, counts)
    ticks = np.stack([spots - HALF, spots + HALF, np.full_like(spots, np.nan)], axis=1)
    most = np.repeat(np.maximum.accumulate(counts), 2)[:-1]
    steps = PLOT.pixels(np.repeat(draws, 2)[1:], most)
    lines = (
        PLOT.frame(),
        Line(PLOT.pixels([0, MOST], right), "image", 1.5, dashed=True),
        Line(ticks.reshape(-1, 2), "guide", 2.5),
        Line(steps, "camera", 2.5),
        Line(disc(spots[-1], 4), "camera", 2.0, closed=True, fill=1.0),
    )
    return Picture(
        "How many agree",
        f"How many pairs agreed with each of {len(counts)} draws, the most so far "
        f"({counts.max()}), and as a dashed line the {right} pairs that are right.",
        PLOT_SIZE,
        lines=lines,
        labels=(
            *PLOT.ticks((0, 100, 200, 300), (0, 20, 40, 60)),
            *PLOT.names("draw", "pairs that agree"),
        ),
    )
