"""Pointing at two places of a photograph: the whole picture, and each place magnified."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.explorers.frame import Frame, Handle, Label, Line, Picture, Readout

Floats = NDArray[np.float64]
Pixels = NDArray[np.uint8]

WHOLE = 480  # px: the whole picture is shown that wide
CLOSE = 240  # px: and each close-up
REACH = 20  # px of the photograph around a mark, to each side
FINE = 0.1  # px: the finest step
GRIP = (44.0, 44.0)  # px: where a close-up is gripped, beside its mark
MAGNIFIED = CLOSE / (2 * REACH)
ROLES = ("object", "camera")
NOTHING = 1e-9
#: Four strokes around a mark, px of a close-up; a NaN row lifts the pen.
CROSS = np.concatenate(
    [[3 * s, 30 * s, s * np.nan] for s in np.array([(1, 0), (-1, 0), (0, 1), (0, -1.0)])]
)


@dataclass(frozen=True, eq=False)
class Pointed:
    """A photograph in which two places are pointed at.

    Attributes
    ----------
    photograph : ndarray, shape (h, w, 3), uint8
        The photograph, in full size.
    names : tuple of str
        What the two places are called.
    value : callable, optional
        From the pixels of both, shape (2, 2), to what is measured, as readouts.
    """

    photograph: Pixels
    names: tuple[str, str] = ("end 1", "end 2")
    value: Callable[[Floats], Sequence[Readout]] | None = None

    @property
    def scale(self) -> float:
        """Pixels of the photograph in one of the whole picture as it is shown."""
        return float(max(self.photograph.shape[:2]) / WHOLE)

    @property
    def shown(self) -> Pixels:
        """The whole photograph, made smaller."""
        import cv2

        height, width = (2 * round(n / self.scale / 2) for n in self.photograph.shape[:2])
        small = cv2.resize(self.photograph, (width, height), interpolation=cv2.INTER_AREA)
        return np.asarray(small, np.uint8)


def marks(state: dict[str, Any]) -> Floats:
    """Return where the two marks are, shape (2, 2), px: coarse and fine together."""
    return np.array([[state[f"{c}{i}"] + state[f"d{c}{i}"] for c in "uv"] for i in (1, 2)])


def pointing_frame(pointed: Pointed, shown: Pixels, **state: float) -> Frame:
    """Return the whole photograph with its two marks, and what is around each of them.

    Parameters
    ----------
    pointed : Pointed
        The photograph, and what its marks are.
    shown : ndarray
        ``pointed.shown``, made once.
    **state : float
        ``u1``, ``v1``, ``u2``, ``v2``: where to look, px; ``du1`` …: from there to the mark, px.

    Returns
    -------
    Frame
        Three pictures, and what is measured between the marks.
    """
    places = marks(state)
    near = [np.array([state[f"u{i}"], state[f"v{i}"]]) for i in (1, 2)]
    close = [_close_up(pointed, i, near[i], places[i]) for i in (0, 1)]
    return Frame((_whole(pointed, shown, places), *close), _numbers(pointed, places))


def _numbers(pointed: Pointed, places: Floats) -> tuple[Readout, ...]:
    apart = float(np.linalg.norm(places[1] - places[0]))
    first = tuple(
        Readout(_capital(name), "(u, v)", f"{u:.1f}, {v:.1f}", "px")
        for name, (u, v) in zip(pointed.names, places.tolist(), strict=True)
    )
    measured = pointed.value(places) if pointed.value else ()
    height, width = pointed.photograph.shape[:2]
    beyond = np.any((places < -0.5) | (places > (width - 0.5, height - 0.5)), axis=1)
    out = [pointed.names[k] for k in np.flatnonzero(beyond)]
    told = (Readout("Outside the photograph", "", " and ".join(out)),) if out else ()
    return (*first, Readout("Apart in the picture", "", f"{apart:.1f}", "px"), *measured, *told)


def _whole(pointed: Pointed, shown: Pixels, places: Floats) -> Picture:
    """Return the whole photograph: its marks can be dragged."""
    height, width = shown.shape[:2]
    small = (places + 0.5) / pointed.scale - 0.5
    one, other = [f"({u:.1f}, {v:.1f})" for u, v in places.tolist()]
    return Picture(
        "Drag the marks near",
        f"The whole photograph; {pointed.names[0]} is marked at {one} px, {pointed.names[1]} at "
        f"{other} px.",
        (width, height),
        shown,
        lines=(Line(small, "ray", 2.0),),
        labels=_names(pointed, small, (width, height)),
        handles=tuple(_handle(i, at, pointed.scale) for i, at in enumerate(small.tolist(), 1)),
    )


def _handle(number: int, at: list[float], scale: float) -> Handle:
    """Return the spot of a mark in the whole photograph."""
    offset = 0.5 * scale - 0.5
    moves = (
        (f"u{number}", offset, scale, 0.0),
        (f"v{number}", offset, 0.0, scale),
        (f"du{number}", 0.0, NOTHING, 0.0),  # the fine part starts again
        (f"dv{number}", 0.0, 0.0, NOTHING),
    )
    return Handle((at[0], at[1]), moves, ROLES[number - 1])


def _names(pointed: Pointed, small: Floats, size: tuple[int, int]) -> tuple[Label, ...]:
    """Return the names beside the marks, away from the other mark, inside the picture."""
    labels = []
    for i, name in enumerate(pointed.names):
        u, v = small[i].tolist()
        down = 1 if small[i, 1] >= small[1 - i, 1] else -1
        at = (min(max(u, 30), size[0] - 30), min(max(v + 18 * down, 8), size[1] - 8))
        labels.append(Label(name, at, ROLES[i], "middle"))
    return tuple(labels)


def _close_up(pointed: Pointed, which: int, near: Floats, place: Floats) -> Picture:
    """Return a mark magnified; it is gripped beside the mark, so that nothing is hidden."""
    name, role = pointed.names[which], ROLES[which]
    at = _in_close_up(place, near)
    grip = at + GRIP * np.where(at + GRIP < CLOSE - 8, 1, -1)
    back = (at - grip + 0.5) / MAGNIFIED - REACH - 0.5
    moves = (
        (f"du{which + 1}", float(back[0]), 1 / MAGNIFIED, 0.0),
        (f"dv{which + 1}", float(back[1]), 0.0, 1 / MAGNIFIED),
    )
    return Picture(
        f"{_capital(name)}, magnified",
        f"{2 * REACH} × {2 * REACH} px around {name}, magnified {MAGNIFIED:g} times; a cross at "
        f"({place[0]:.1f}, {place[1]:.1f}) px.",
        (CLOSE, CLOSE),
        _magnified(pointed.photograph, near),
        lines=(
            Line(at + CROSS, role, 2.0),
            Line([at + 6 * np.sign(grip - at), grip], role, 1.0),
        ),
        handles=(Handle((float(grip[0]), float(grip[1])), moves, role),),
    )


def _in_close_up(pixels: Floats, near: Floats) -> Floats:
    """Return where pixels of the photograph are in the close-up around `near`."""
    return np.asarray(MAGNIFIED * (pixels - near + REACH + 0.5) - 0.5)


def _capital(name: str) -> str:
    return name[0].upper() + name[1:]


def _magnified(photograph: Pixels, near: Floats) -> Pixels:
    """Return what is around a pixel; each pixel becomes a square, grey where there is none."""
    import cv2

    u, v = np.rint(near).astype(int)
    patch = np.full((2 * REACH, 2 * REACH, 3), 118, np.uint8)
    rows, columns = np.arange(v - REACH, v + REACH), np.arange(u - REACH, u + REACH)
    height, width = photograph.shape[:2]
    inside_v, inside_u = (rows >= 0) & (rows < height), (columns >= 0) & (columns < width)
    patch[np.ix_(inside_v, inside_u)] = photograph[np.ix_(rows[inside_v], columns[inside_u])]
    large = cv2.resize(patch, (CLOSE, CLOSE), interpolation=cv2.INTER_NEAREST)
    return np.asarray(large, np.uint8)
