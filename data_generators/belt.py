"""A conveyor belt with small parts, seen from straight above; and what motion does to a picture."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import check_number, check_numbers

Light = NDArray[np.float32]

#: Side of a pixel on the belt, mm, and the size of the picture, px.
PIXEL, SIZE = 0.2, (480, 320)
FINE = 4  # subpixels a pixel, each way, for the outlines
RUBBER, STEEL, BRASS, PAPER = (0.035, 0.04, 0.042), (0.5, 0.52, 0.55), (0.6, 0.42, 0.16), 0.85
#: Outer and inner radius of a washer, mm.
WASHER = (9.0, 4.6)
WASHERS = ((16.0, 14.0), (50.0, 46.5), (76.0, 17.0))  # mm from the top-left corner
NUTS = ((45.0, 14.0, 0.2), (18.0, 47.0, 0.7))  # x, y in mm and turn in rad
NUT = (8.0, 4.0)  # corner radius and hole radius, mm
LABEL = (63.0, 33.0, 27.0, 22.0)  # left, top, width, height, mm


def belt(rng: np.random.Generator | None = None) -> Light:
    """Return the light that a belt with washers, nuts and a label sends up.

    Parameters
    ----------
    rng : numpy.random.Generator, optional
        For the grain of the rubber and the metal; the same belt every time without one.

    Returns
    -------
    ndarray, shape (320, 480, 3), float32
        Radiance, RGB, linear in light, 1 for a white surface; a pixel is 0.2 mm wide.
    """
    rng = np.random.default_rng(4) if rng is None else rng
    picture = _grained(RUBBER, 0.1, (1, 1), rng)
    label = _label_print()
    left, top, width, height = (round(length / PIXEL) for length in LABEL)
    picture[top : top + height, left : left + width] = label[..., None]
    for share, colour in _parts():
        metal = _grained(colour, 0.06, (9, 1), rng)
        picture += share[..., None] * (metal - picture)
    return picture


def silhouettes() -> Light:
    """Return how much of each pixel is covered by a metal part, shape (320, 480), 0 to 1."""
    return np.asarray(np.clip(sum(share for share, _ in _parts()), 0, 1), np.float32)


def _parts() -> list[tuple[Light, tuple[float, float, float]]]:
    """Return each metal part: its share of each pixel, and its colour."""
    parts = []
    for centre in WASHERS:
        turn = np.linspace(0, 2 * np.pi, 241)[:-1]
        parts.append((_ring(centre, WASHER, turn), STEEL))
    for x, y, start in NUTS:
        parts.append((_ring((x, y), NUT, start + np.arange(6) * np.pi / 3), BRASS))
    return parts


def _ring(
    centre: tuple[float, float], radii: tuple[float, float], corners: NDArray[np.float64]
) -> Light:
    """Return the share of each pixel that a disc or polygon with a round hole covers."""
    import cv2

    width, height = SIZE
    canvas = np.zeros((height * FINE, width * FINE), np.uint8)
    hole = np.linspace(0, 2 * np.pi, 241)[:-1]
    for radius, angles, value in ((radii[0], corners, 255), (radii[1], hole, 0)):
        outline = np.array(centre) + radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        fixed = np.rint((outline * FINE / PIXEL - 0.5) * 16).astype(np.int32)
        cv2.fillPoly(canvas, [fixed], value, cv2.LINE_8, 4)
    small = cv2.resize(canvas, SIZE, interpolation=cv2.INTER_AREA)
    return np.asarray(small / np.float32(255), np.float32)


def _grained(
    colour: tuple[float, float, float],
    depth: float,
    grain: tuple[int, int],
    rng: np.random.Generator,
) -> Light:
    """Return a surface of one colour with a grain of (width, height) px."""
    import cv2

    noise = rng.standard_normal((SIZE[1], SIZE[0])).astype(np.float32)
    noise = cv2.blur(noise, grain, borderType=cv2.BORDER_REFLECT) * np.sqrt(grain[0] * grain[1])
    light = np.clip(1 + depth * noise, 0.3, 1.8)[..., None]
    return np.asarray(light * np.array(colour, np.float32), np.float32)


def _label_print() -> Light:
    """Return a paper label with a bar code and a number, linear in light."""
    import cv2

    width, height = round(LABEL[2] / PIXEL), round(LABEL[3] / PIXEL)
    paper = np.full((height * FINE, width * FINE), 255, np.uint8)
    bars = np.random.default_rng(11).integers(2, 5, 36) * 2
    edges = 30 + np.concatenate([[0], np.cumsum(bars)])
    for left, right in zip(edges[0:-1:2], edges[1::2], strict=False):
        paper[32 : 13 * height * FINE // 20, left:right] = 0
    at, font = (30, height * FINE - 40), cv2.FONT_HERSHEY_SIMPLEX
    cv2.putText(paper, "LOT 0417-B", at, font, 2.5, 0, 7, cv2.LINE_AA)
    small = cv2.resize(paper, (width, height), interpolation=cv2.INTER_AREA)
    return np.asarray(0.03 + (PAPER - 0.03) * small / np.float32(255), np.float32)


def smeared(picture: ArrayLike, length: float) -> Light:
    """Return a picture whose content moved to the right while the shutter was open.

    Parameters
    ----------
    picture : array_like, shape (h, w) or (h, w, c)
        Linear in light.
    length : float
        The way during the exposure, px; not negative.

    Returns
    -------
    ndarray, the same shape, float32
        Each pixel is the mean over the way, from half a way to the left to half a way to the
        right; beyond the edges the picture goes on with its first and last column.

    Raises
    ------
    ValueError
        If the length is negative.
    """
    import cv2

    light = np.ascontiguousarray(check_numbers(picture, "picture"), np.float32)
    length = check_number(length, "length")
    if length < 0:
        raise ValueError(f"length must not be negative, got {length:g}")
    if length < 1e-3:
        return light.copy()
    weights = _falling(length)
    total = np.zeros_like(light)
    for reach, part in enumerate(weights - np.append(weights[1:], 0)):
        if part > 1e-12:  # one box for each step of the weights: two at most on each side
            total += np.float32(part) * cv2.boxFilter(
                light, -1, (2 * reach + 1, 1), normalize=False, borderType=cv2.BORDER_REPLICATE
            )
    return total


def _falling(length: float) -> NDArray[np.float64]:
    """Return the weights of the pixels 0, 1, 2, ... columns away, for a way of `length` px.

    Light falls on a pixel from its whole width, so a moving pixel takes from both neighbours in
    turn: the weight is the integral of a triangle over the way.
    """
    away, half = np.arange(np.ceil(length / 2) + 2), length / 2
    return np.asarray((_under_triangle(away + half) - _under_triangle(away - half)) / length)


def _under_triangle(x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the area left of x under a triangle of height 1 from -1 to 1."""
    x = np.clip(x, -1, 1)
    return np.asarray(np.where(x < 0, (1 + x) ** 2 / 2, 1 - (1 - x) ** 2 / 2))
