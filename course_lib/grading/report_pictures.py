"""Pictures of a class report, drawn as SVG: how scores are spread, what became of the answers."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

import numpy as np
from numpy.typing import NDArray

from course_lib.checks import Array
from course_lib.grading.item_analysis import ItemAnalysis
from course_lib.grading.states import STATES, State
from course_lib.judging.text import format_points
from course_lib.page import AMBER, BLUE, DARK, GREY, ORANGE, SKY, svg

#: Fill and the colour of the number on it; the legend and the numbers say the same.
COLOURS: dict[State, tuple[str, str]] = {
    "full points": (BLUE, "white"),
    "some points": (SKY, DARK),
    "no points": (AMBER, DARK),
    "error": (ORANGE, "white"),
    "not tried": ("#ddd", DARK),
    "not reached": (GREY, DARK),
}
#: Bars of the histogram.
BARS = 10
WIDTH = 720
LEFT, BASE, HIGH, STEP = 50.0, 210.0, 160.0, (WIDTH - 80) / BARS


def score_histogram(scores: Sequence[float], possible: float) -> str:
    """Return how many students have how many points.

    Parameters
    ----------
    scores : sequence of float
        Points of each student.
    possible : float
        Points of a full submission.

    Returns
    -------
    str
        A figure of HTML; a sentence if there are no scores.
    """
    if not scores or possible <= 0:
        return "<p>Nobody has points yet.</p>"
    clipped = np.clip(scores, 0, possible)
    counts, edges = np.histogram(clipped, bins=BARS, range=(0, possible))
    middle = float(np.median(clipped))
    pairs = zip(edges, edges[1:], counts, strict=False)
    ranges = ", ".join(f"{format_points(a)} to {format_points(b)}: {n}" for a, b, n in pairs if n)
    said = f"students by points; median {format_points(middle)}; {ranges}"
    bars, numbers = _bars(counts)
    content = bars + _scale(edges, middle, possible) + numbers
    caption = "Students by points. The last bar includes full points."
    drawn = svg(f"0 0 {WIDTH} 260", content, said)
    return f"<figure class='wide'>{drawn}<figcaption>{caption}</figcaption></figure>"


def _bars(counts: NDArray[np.intp]) -> tuple[str, str]:
    """Return the bars, and the numbers on them, which a line must not strike out."""
    parts, numbers, most = [], [], max(int(counts.max()), 1)
    for k, count in enumerate(counts):
        x, tall = LEFT + k * STEP, HIGH * count / most
        parts.append(_rectangle(x + 2, BASE - tall, STEP - 4, tall, BLUE))
        numbers.append(_text(x + STEP / 2, BASE - tall - 8, str(count)) if count else "")
    return "".join(parts), f"<g class='halo'>{''.join(numbers)}</g>"


def _scale(edges: Array, middle: float, possible: float) -> str:
    """Return the axis of points, and a dashed line above it at the median."""
    x = LEFT + middle / possible * STEP * BARS
    dashed = f"stroke='{ORANGE}' stroke-width='2' stroke-dasharray='6 4'"
    parts = [
        f"<path d='M{LEFT} {BASE}h{STEP * BARS}' stroke='{DARK}'/>",
        f"<path d='M{x:.1f} 26V{BASE}' {dashed}/>",
        _text(x, 18, f"median {format_points(middle)}"),
        _text(WIDTH / 2, BASE + 42, f"points, of {format_points(possible)}"),
    ]
    steps = enumerate(edges)
    return "".join(
        [*parts, *(_text(LEFT + k * STEP, BASE + 20, format_points(round(e, 1))) for k, e in steps)]
    )


def answer_bars(analyses: Sequence[ItemAnalysis]) -> str:
    """Return what became of the answers to each exercise.

    Parameters
    ----------
    analyses : sequence of ItemAnalysis
        Those with recorded states are drawn.

    Returns
    -------
    str
        A figure of HTML; a sentence if nothing was recorded.
    """
    drawn = [a for a in analyses if sum(a.states.values())]
    if not drawn:
        return "<p>No answer in code was recorded by <code>course grade</code>.</p>"
    used = [state for state in STATES if any(a.states[state] for a in drawn)]
    left, row = 210.0, 30.0
    parts = [_legend(used)]
    for k, analysis in enumerate(drawn):
        y, x = 44 + k * row, left
        name = escape(analysis.item.short_name)
        parts.append(_text(left - 10, y + row / 2, name, anchor="end", size=14))
        for state in used:
            count, total = analysis.states[state], sum(analysis.states.values())
            wide = (WIDTH - left - 10) * count / total
            fill, ink = COLOURS[state]
            parts.append(_rectangle(x, y + 3, wide, row - 6, fill) if count else "")
            parts.append(_text(x + wide / 2, y + row / 2, str(count), ink) if wide > 14 else "")
            x += wide
    said = "; ".join(
        f"{a.item.short_name}: " + ", ".join(f"{a.states[s]} {s}" for s in used) for a in drawn
    )
    picture = svg(f"0 0 {WIDTH} {50 + row * len(drawn):.0f}", "".join(parts), said)
    caption = "What became of the answers: how many students, exercise by exercise."
    return f"<figure class='wide'>{picture}<figcaption>{caption}</figcaption></figure>"


def _legend(states: Sequence[State]) -> str:
    step, parts = WIDTH / len(states), []
    for k, state in enumerate(states):
        parts.append(_rectangle(k * step, 10, 16, 16, COLOURS[state][0]))
        parts.append(_text(k * step + 22, 19, state, anchor="start", size=14))
    return "".join(parts)


def _rectangle(x: float, y: float, width: float, height: float, fill: str) -> str:
    size = f"width='{width:.1f}' height='{height:.1f}'"
    return f"<rect x='{x:.1f}' y='{y:.1f}' {size} fill='{fill}'/>"


def _text(
    x: float, y: float, said: str, fill: str = DARK, anchor: str = "middle", size: int = 15
) -> str:
    return (
        f"<text x='{x:.1f}' y='{y:.1f}' font-size='{size}' text-anchor='{anchor}' "
        f"dominant-baseline='middle' fill='{fill}'>{said}</text>"
    )
