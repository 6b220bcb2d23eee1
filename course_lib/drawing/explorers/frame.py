"""What an explorer shows for one state: pictures, numbers and their alternatives in words.

A frame is plain data that the browser draws; `stills` draws it for readers without a kernel.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.explorers.marks import Marks
from course_lib.drawing.explorers.trails import Trail

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Line:
    """A polyline in the pixels of its picture; a NaN row lifts the pen.

    Attributes
    ----------
    points : array_like, shape (N, 2)
        Corners (u, v) in px.
    role : str
        A key of `style.ROLES`, or ``"ink"`` for the colour of the text.
    width : float
        Width in px.
    closed, dashed : bool
        Whether the last point joins the first; whether the stroke is broken.
    fill : float
        Opacity of the inside, 0 to 1.
    """

    points: ArrayLike
    role: str = "ink"
    width: float = 1.5
    closed: bool = False
    dashed: bool = False
    fill: float = 0.0


@dataclass(frozen=True)
class Label:
    """A word in a picture, at the pixel `at`; `anchor` is start, middle or end."""

    text: str
    at: tuple[float, float]
    role: str = "ink"
    anchor: str = "start"


@dataclass(frozen=True)
class Probe:
    """A quantity read under the pointer, on a coarse grid over the whole picture.

    Attributes
    ----------
    label, unit : str
        What is read, and its unit.
    values : ndarray, shape (rows, columns)
        The corners of the grid are the centres of the picture's corner pixels; values between
        the nodes are interpolated bilinearly; NaN means nothing to read.
    digits : int
        Decimals shown.
    """

    label: str
    unit: str
    values: Floats
    digits: int = 1


@dataclass(frozen=True)
class Handle:
    """A spot that can be dragged; it moves controls of the explorer.

    Attributes
    ----------
    at : tuple of float
        Where it is, px of its picture.
    moves : tuple of (str, float, float, float)
        Name, a, b and c of each control that it sets to ``a + b u + c v`` when it is dragged to
        the pixel (u, v). One that no b, or no c, concerns stays in its column, or in its row.
    role : str
        As of a line.
    """

    at: tuple[float, float]
    moves: tuple[tuple[str, float, float, float], ...]
    role: str = "object"


@dataclass(frozen=True)
class Picture:
    """One picture of a frame: a photograph with an overlay, or a line drawing without one.

    Attributes
    ----------
    title, alt : str
        What stands above it, and what it shows, in words, for this state.
    size : tuple of int
        Width and height in px.
    image : ndarray, shape (height, width, 3), uint8, optional
        The photograph, RGB; another shape or type raises a ValueError.
    lines, labels : tuple
        Drawn over it, in its pixels.
    probes, pixels : tuple of Probe, bool
        What the pointer reads, and whether it also reads (u, v).
    handles : tuple of Handle
        Spots that can be dragged; with marks or trails, a press anywhere takes the first one.
    marks, trails : Marks, optional, and tuple of Trail
        Points that say what they are, and what the pointer draws in other pictures.
    """

    title: str
    alt: str
    size: tuple[int, int]
    image: NDArray[np.uint8] | None = None
    lines: tuple[Line, ...] = ()
    labels: tuple[Label, ...] = ()
    probes: tuple[Probe, ...] = ()
    pixels: bool = False
    handles: tuple[Handle, ...] = ()
    marks: Marks | None = None
    trails: tuple[Trail, ...] = ()

    def __post_init__(self) -> None:
        image, shape = self.image, (self.size[1], self.size[0], 3)
        if image is not None and (image.dtype != np.uint8 or image.shape != shape):
            raise ValueError(
                f"{self.title}: expected a uint8 image of shape {shape}, got {image.dtype} "
                f"of shape {image.shape}"
            )


@dataclass(frozen=True)
class Readout:
    """A number of the frame, as it is shown: label, symbol, value and unit.

    A matrix has `rows`, the texts of its entries; its value is the same in one line.
    """

    label: str
    symbol: str
    value: str
    unit: str = ""
    rows: tuple[tuple[str, ...], ...] = ()

    @property
    def quantity(self) -> str:
        """Value and unit together: 3 mm, but 3°."""
        gap = "" if self.unit == "°" else " "
        return f"{self.value}{gap}{self.unit}".strip()


def matrix(label: str, symbol: str, entries: ArrayLike, digits: ArrayLike = 3) -> Readout:
    """Return a matrix as a readout.

    Parameters
    ----------
    label, symbol : str
        In words, and as in the formulas.
    entries : array_like, shape (M, N)
        The matrix.
    digits : int or array_like, shape (M,)
        Decimals of each row.

    Returns
    -------
    Readout
        With a table of the entries, and a value for readers without one.
    """
    numbers = np.asarray(entries, dtype=float)
    decimals = np.broadcast_to(np.asarray(digits), len(numbers)).tolist()
    # + 0.0 after rounding: no entry is shown as -0
    rows = tuple(
        tuple(f"{round(x, d) + 0.0:.{d}f}" for x in row)
        for row, d in zip(numbers.tolist(), decimals, strict=True)
    )
    return Readout(label, symbol, f"[{'; '.join(' '.join(row) for row in rows)}]", rows=rows)


@dataclass(frozen=True)
class Frame:
    """Everything an explorer shows for one state.

    Attributes
    ----------
    pictures : tuple of Picture
        At least one.
    readouts : tuple of Readout
        The numbers beside them.
    follows : mapping
        Controls that this state determines, with their values: they move by themselves.
    """

    pictures: tuple[Picture, ...]
    readouts: tuple[Readout, ...] = ()
    follows: Mapping[str, float] = field(default_factory=dict)

    def in_words(self) -> str:
        """Return the frame as text: every picture's alternative, then every number."""
        numbers = [f"{f'{r.label} {r.symbol}'.strip()}: {r.quantity}" for r in self.readouts]
        return "\n".join([p.alt for p in self.pictures] + numbers)
