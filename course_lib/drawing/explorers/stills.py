"""A frame of an explorer as a still figure, for readers without a kernel."""

from __future__ import annotations

import io
import re
import textwrap
from typing import TYPE_CHECKING, Any

import numpy as np

from course_lib.drawing import style
from course_lib.drawing.explorers.frame import Frame, Picture

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.patheffects import AbstractPathEffect

ANCHORS = {"start": "left", "middle": "center", "end": "right"}


def still(frame: Frame, settings: str = "") -> bytes:
    """Draw a frame as a still figure, for readers without a kernel.

    Parameters
    ----------
    frame : Frame
        What to draw.
    settings : str
        Where the controls stand, written above the numbers.

    Returns
    -------
    bytes
        A PNG picture.
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    widths, heights = zip(*(p.size for p in frame.pictures), strict=True)
    caption = _caption(frame, settings)
    with style.course_style():
        height = (
            style.FULL_WIDTH * max(heights) / sum(widths) + 0.5 + 0.18 * (caption.count("\n") + 1)
        )
        figure = Figure(figsize=(style.FULL_WIDTH, height))
        FigureCanvasAgg(figure)
        row = figure.subplots(1, len(widths), width_ratios=widths, squeeze=False)[0]
        for axes, picture in zip(row, frame.pictures, strict=True):
            _draw(axes, picture)
        figure.supxlabel(caption, fontsize=9)
        png = io.BytesIO()
        figure.savefig(png, format="png")
    return png.getvalue()


def _caption(frame: Frame, settings: str) -> str:
    """Return where the controls stand, in lines that part no value from its unit, and numbers."""
    unbroken = re.sub(r"(?<![,;]) ", "\N{NO-BREAK SPACE}", settings)
    lines = [*textwrap.wrap(unbroken, 115), *filter(None, [_numbers(frame)])]
    return _typeset("\n".join(lines))


def _typeset(text: str) -> str:
    """Return a text with minus signs and groups of three, as the front end shows it."""
    signed = re.sub(r"(?<![\w.)])-(?=\.?\d)", "\N{MINUS SIGN}", text)
    gap = "\N{NARROW NO-BREAK SPACE}"
    return re.sub(
        r"(?<![\d.])\d{5,}(?!\d)", lambda found: f"{int(found[0]):,}".replace(",", gap), signed
    )


def _draw(axes: Axes, picture: Picture) -> None:
    """Draw one picture into its axes, in its own pixels."""
    width, height = picture.size
    axes.set(xlim=(-0.5, width - 0.5), ylim=(height - 0.5, -0.5), xticks=[], yticks=[])
    axes.set_title(picture.title, fontsize=10)
    axes.set_aspect("equal")
    axes.spines[:].set_visible(False)
    if picture.image is not None:
        axes.imshow(picture.image)
    for line in picture.lines:
        points = np.asarray(line.points, dtype=float).reshape(-1, 2)
        colour = _colour(line.role)
        if line.fill:
            axes.fill(*points.T, color=colour, alpha=line.fill, linewidth=0)
        if line.closed:
            points = np.vstack([points, points[:1]])
        look: dict[str, Any] = {"ls": "--" if line.dashed else "-", "lw": 0.6 * line.width}
        axes.plot(*points.T, color=colour, path_effects=_halo(picture, look["lw"]), **look)
    for handle in picture.handles:
        axes.plot(*handle.at, "o", ms=7, mfc="white", mec=_colour(handle.role), mew=1.8)
    for label in picture.labels:
        look = {"ha": ANCHORS[label.anchor], "va": "center", "fontsize": 7}
        look |= {"color": _colour(label.role), "path_effects": _halo(picture, 0)}
        axes.text(*label.at, _typeset(label.text), **look)


def _halo(picture: Picture, width: float) -> list[AbstractPathEffect]:
    """Return a light rim for what is drawn over a photograph, so that it stands out."""
    from matplotlib.patheffects import withStroke

    if picture.image is None:
        return []
    return [withStroke(linewidth=width + 1.6, foreground="white", alpha=0.75)]


def _colour(role: str) -> str:
    return style.BLACK if role == "ink" else style.ROLES[role]


def _numbers(frame: Frame) -> str:
    """Return the numbers of a frame in lines of at most three, then a line for each matrix."""
    texts = [f"{r.label}: {r.quantity}" for r in frame.readouts if not r.rows]
    lines = ["   ·   ".join(texts[i : i + 3]) for i in range(0, len(texts), 3)]
    return "\n".join(lines + [f"{r.symbol} = {r.quantity}" for r in frame.readouts if r.rows])
