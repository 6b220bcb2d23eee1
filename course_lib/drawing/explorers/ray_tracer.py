"""The ray tracer: an object, one or two thin lenses, and where its image comes to be."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from course_lib.checks import DegenerateConfigurationError
from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import disc
from course_lib.optics import (
    cardinal_points,
    free_space,
    image_of_point,
    system_matrix,
    thin_lens,
    trace_rays,
)

Floats = NDArray[np.float64]

ONE, COLLECTING, SPREADING = "none", "collecting, f₂ > 0", "spreading, f₂ < 0"
SECOND = (ONE, COLLECTING, SPREADING)

SIZE = (760, 330)  # px
LENS_U, AXIS_V = 330.0, 162.0  # px: where the first lens stands on the axis
ALONG, UP = 1.0, 3.0  # px a mm: heights are drawn larger than lengths
HEIGHT = 15.0  # mm: of the object
FAR = 1e5  # mm: what is farther, or larger than this, is called infinite
RIM = 28.0  # mm: half the height of a lens
DISTANT = 5000.0  # mm: the light of what is farther is drawn as nearly parallel
ENDS = ((0 - LENS_U) / ALONG, (SIZE[0] - LENS_U) / ALONG)  # mm: what the picture shows


def ray_tracer_frame(
    Z: float, f1: float, second: str = ONE, f2: float = 30.0, d: float = 30.0
) -> Frame:
    """Return rays from an object through one or two lenses.

    Parameters
    ----------
    Z : float
        Distance from the object to the first lens, mm; its light is parallel when it is large.
    f1, f2 : float
        Focal lengths, mm, positive; that of the second lens counts negative when it spreads.
    second : str
        One of `SECOND`.
    d : float
        Distance between the lenses, mm.

    Returns
    -------
    Frame
        The drawing, and the numbers of the system.
    """
    lenses = [(0.0, f1)]
    if second != ONE:
        lenses.append((d, f2 if second == COLLECTING else -f2))
    system = system_matrix(_elements(lenses))
    image, m = image_of_point(system, Z)
    focal, front, back = _cardinal(system)
    planes = _planes(front, lenses[-1][0] + back, focal)
    lines, labels = planes if len(lenses) > 1 else ((), ())
    drawing = Picture(
        "Rays of the arrow's tip",
        _in_words(Z, lenses, image, m),
        SIZE,
        lines=(
            *lines,
            *_scene(Z, lenses),
            *_rays(Z, lenses, image),
            *_image(lenses[-1][0], image, m),
        ),
        labels=(*labels, *_labels(Z, lenses, image, m)),
    )
    numbers = _image_numbers(image, m, len(lenses))
    if len(lenses) > 1:
        numbers += _system_numbers(focal, front, back)
    return Frame((drawing,), numbers)


def _elements(lenses: list[tuple[float, float]]) -> list[Floats]:
    """Return the lenses and the ways between them, as matrices in the order of the light."""
    elements, place = [], 0.0
    for where, f in lenses:
        elements += [free_space(where - place), thin_lens(f)]
        place = where
    return elements


def _cardinal(system: Floats) -> tuple[float, float, float]:
    """Return focal length and principal planes; infinite for a telescope."""
    try:
        return cardinal_points(system)
    except DegenerateConfigurationError:
        return np.inf, np.inf, np.inf


def _pixels(points: object) -> Floats:
    """Return pixels from (place on the axis, height) in mm."""
    x, y = np.asarray(points, dtype=float).T
    return np.stack([LENS_U + ALONG * x, AXIS_V - UP * y], axis=1)


def _at(x: float, y: float, right: float = 0, down: float = 0) -> tuple[float, float]:
    """Return one pixel, moved to the right and down."""
    ((u, v),) = _pixels([(x, y)])
    return float(u) + right, float(v) + down


def _path(Z: float, at_lens: float, lenses: list[tuple[float, float]]) -> Floats:
    """Return the corners of a ray from the tip that meets the first lens at a height, mm."""
    angle = (at_lens - HEIGHT) / Z
    way = [free_space(Z), *_elements(lenses)[1:], free_space(ENDS[1] - lenses[-1][0])]
    heights = trace_rays(way, (HEIGHT, angle))[:, 0]
    start = min(Z, 10 - ENDS[0])  # a far object lies out of the picture
    places = [-start, *(where for where, _ in lenses), ENDS[1]]
    first = HEIGHT + angle * (Z - start)
    return np.stack([places, [first, *heights[1:-1:2], heights[-1]]], axis=1)


def _rays(Z: float, lenses: list[tuple[float, float]], image: float) -> list[Line]:
    """Return the light of the tip, three rays of it, and where they seem to come from."""
    f1 = lenses[0][1]
    rims = [_path(Z, y, lenses) for y in (RIM, -RIM)]
    lines = [Line(_pixels(np.vstack([rims[0], rims[1][::-1]])), "ray", 0.5, closed=True, fill=0.12)]
    heights = [HEIGHT, 0.0]
    if Z > DISTANT:
        heights.append(-HEIGHT)
    elif abs(Z - f1) > 1e-9:
        heights.append(-HEIGHT * f1 / (Z - f1))  # it passes the front focal point
    paths = [_path(Z, y, lenses) for y in heights if abs(y) <= RIM]
    lines += [Line(_pixels(path), "ray", 2.0) for path in paths]
    if -FAR < image < 0:
        back = max(lenses[-1][0] + image, ENDS[0])
        for path in paths:
            (x, y), (right, high) = path[-2:]
            there = y + (high - y) / (right - x) * (back - x)
            lines.append(Line(_pixels([(x, y), (back, there)]), "ray", 1.2, dashed=True))
    return lines


def _scene(Z: float, lenses: list[tuple[float, float]]) -> list[Line]:
    """Return the axis, the object, the lenses and their focal points."""
    lines = [Line(_pixels([(ENDS[0], 0), (ENDS[1], 0)]), "guide", 1.0, dashed=True)]
    for where, f in lenses:
        lines += _lens(where, f)
    f1 = lenses[0][1]
    lines += [Line(disc(_at(x, 0), 4), "camera", 1.0, closed=True, fill=1.0) for x in (-f1, f1)]
    return [*lines, *(_arrow(-Z, HEIGHT, "object") if _shown(-Z) else [])]


def _lens(where: float, f: float) -> list[Line]:
    """Return a lens: outer tips for one that collects light, inner ones for one that spreads."""
    u, top = _at(where, RIM)
    bottom = _at(where, -RIM)[1]
    out = 9.0 if f > 0 else -9.0
    tips = [
        [[u - 7, end + turn * out], [u, end], [u + 7, end + turn * out]]
        for end, turn in ((top, 1), (bottom, -1))
    ]
    stem = Line([[u, top], [u, bottom]], "camera", 3.0)
    return [stem, *(Line(tip, "camera", 3.0) for tip in tips)]


def _arrow(x: float, height: float, role: str) -> list[Line]:
    """Return an upright arrow on the axis."""
    (u, foot), (_, tip) = _at(x, 0), _at(x, height)
    size = min(10.0, abs(tip - foot))
    back = tip + size * np.sign(foot - tip)
    head = [[u, tip], [u - 5, back], [u + 5, back]]
    return [Line([[u, foot], [u, tip]], role, 3.5), Line(head, role, 1.0, closed=True, fill=1.0)]


def _image(last: float, image: float, m: float) -> list[Line]:
    """Return the image as an arrow, if it lies in the picture."""
    if not _shown(last + image):
        return []
    return _arrow(last + image, HEIGHT * m, "image")


def _shown(x: float) -> bool:
    """Return whether a place on the axis is in the picture."""
    return bool(np.isfinite(x)) and ENDS[0] + 8 < x < ENDS[1] - 8


def _planes(front: float, back: float, focal: float) -> tuple[tuple[Line, ...], tuple[Label, ...]]:
    """Return the principal planes of a system, dashed, and its focal point, with their names."""
    lines, labels = [], []
    for x, name, lower in ((front, "H", 14), (back, "H′", 28)):
        if _shown(x):
            lines.append(Line(_pixels([(x, 36), (x, -36)]), "second", 1.8, dashed=True))
            labels.append(Label(name, _at(x, -36, 0, lower), "second", "middle"))
    if _shown(back + focal):  # its name stands below that of an image
        lines.append(Line(disc(_at(back + focal, 0), 4), "second", 1.0, closed=True, fill=1.0))
        labels.append(Label("F′", _at(back + focal, 0, 0, 30), "second", "middle"))
    return tuple(lines), tuple(labels)


def _labels(
    Z: float, lenses: list[tuple[float, float]], image: float, m: float
) -> tuple[Label, ...]:
    """Return the names of what is seen."""
    labels = [
        _object_label(Z),
        *_focal_labels(lenses[0][1], len(lenses)),
        *_lens_labels([where for where, _ in lenses]),
        Label("heights are drawn 3 times as large as lengths", (8, SIZE[1] - 10), "guide"),
    ]
    place = lenses[-1][0] + image
    if not _shown(place):
        labels += _outside(image, m, len(lenses))
    else:
        name = "image" if image > 0 else "virtual image"
        tip = float(np.clip(HEIGHT * m, -46, 46))
        labels.append(Label(name, _at(place, tip, 0, 13 if m < 0 else -12), "image", "middle"))
    return tuple(labels)


def _lens_labels(places: list[float]) -> list[Label]:
    """Return the names of the lenses; those of a near pair stand on its two sides."""
    tops = [_at(place, RIM, 0, -14) for place in places]
    if len(places) == 1:
        return [Label("lens", tops[0], "camera", "middle")]
    anchor = "end" if places[1] < 48 else "middle"  # mm: nearer, and the names would touch
    return [Label("lens 1", tops[0], "camera", anchor), Label("lens 2", tops[1], "camera")]


def _focal_labels(f1: float, count: int) -> list[Label]:
    """Return the names of the first lens's focal points, above the axis: images are below."""
    which = "₁" if count > 1 else ""  # a pair of lenses has focal points of its own
    names = {-f1: f"F{which}", f1: f"F{which}′"}
    return [Label(name, _at(x, 0, 0, -14), "camera", "middle") for x, name in names.items()]


def _object_label(Z: float) -> Label:
    """Return the name of the object, or from how far its light comes."""
    if _shown(-Z):
        return Label("object", _at(-Z, HEIGHT, 0, -12), "object", "middle")
    return Label(f"← object {Z / 1000:g} m away", (8, _at(0, HEIGHT)[1] - 12), "object")


def _outside(image: float, m: float, count: int) -> list[Label]:
    """Return where an image is that lies out of the picture; nothing where there is none."""
    if abs(image) > FAR:
        return []
    last = "the lens" if count == 1 else "lens 2"
    if image > 0:
        text = f"image {_text(image, 0)} mm behind {last} →"
        free = 12 if m < 0 else SIZE[1] - 10  # away from the light
        return [Label(text, (SIZE[0] - 8, free), "image", "end")]
    return [Label(f"← virtual image {_text(-image, 0)} mm before {last}", (8, 12), "image")]


def _image_numbers(image: float, m: float, count: int) -> tuple[Readout, ...]:
    """Return the numbers of the image."""
    last = "the lens" if count == 1 else "the last lens"
    size = _quantity(m, 2, "×") if abs(image) <= FAR else ("–", "")  # of no image
    return (
        Readout(f"Image behind {last}", "s", *_quantity(image, 1, "mm")),
        Readout("Magnification", "", *size),
    )


def _system_numbers(focal: float, front: float, back: float) -> tuple[Readout, ...]:
    """Return the numbers of two lenses that act as one."""
    return (
        Readout("Focal length of the whole", "f", *_quantity(focal, 1, "mm")),
        Readout("Power of the whole", "1/f", _text(1000 / focal, 1), "dpt"),
        Readout("H behind lens 1", "", *_quantity(front, 1, "mm")),
        Readout("H′ behind the last lens", "", *_quantity(back, 1, "mm")),
    )


def _quantity(value: float, digits: int, unit: str) -> tuple[str, str]:
    """Return a number as text and its unit; infinity has none."""
    return _text(value, digits), "" if abs(value) > FAR else unit


def _text(value: float, digits: int) -> str:
    """Return a number with a true minus sign, or the sign of infinity."""
    if abs(value) > FAR:
        return "∞"
    return f"{round(value, digits) + 0.0:.{digits}f}".replace("-", "−")


def _in_words(Z: float, lenses: list[tuple[float, float]], image: float, m: float) -> str:
    """Say what the drawing shows."""
    glass = " and ".join(f"f = {_text(f, 0)} mm" for _, f in lenses)
    start = f"An object {Z:.0f} mm before a lens, {glass}: "
    if abs(image) > FAR:
        return start + "the rays leave parallel, and there is no image."
    kind = "a real image" if image > 0 else "a virtual image"
    way = "behind" if image > 0 else "before"
    turn = "upside down" if m < 0 else "upright"
    where = f"{abs(image):.0f} mm {way} the last lens"
    return f"{start}{kind} {where}, {turn}, {abs(m):.2f} times as large."
