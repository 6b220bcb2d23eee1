"""The Bayer explorer: a few pixels, the filters before them, and the colours guessed between."""

from __future__ import annotations

from functools import cache, lru_cache

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.explorers.frame import Frame, Picture, Readout
from course_lib.drawing.explorers.street import renderer, upright_camera
from course_lib.sensor import (
    bayer_masks,
    bayer_mosaic,
    demosaic_bilinear,
    srgb_decode,
    srgb_encode,
)

Floats = NDArray[np.float64]

SIZE = (480, 320)  # px of each subject
SHOWN = 240  # px: side of each picture
STAR, LABEL, STREET = "star", "parts and label", "street"
GREY, FILTERS, GREEN = "grey numbers", "colours of the filters", "green pixels only"


def bayer_frame(
    subject: str, view: str, pixels: float, across: float, down: float, softness: float
) -> Frame:
    """Return a part of a picture: as the lens makes it, as the pixels see it, and demosaiced.

    Parameters
    ----------
    subject : str
        `STAR`, `LABEL` or `STREET`.
    view : str
        How the mosaic is shown: `GREY`, `FILTERS` or `GREEN`.
    pixels : float
        Side of the part, px.
    across, down : float
        Where the part lies, from 0 at the left or top to 1.
    softness : float
        Blur of the lens, standard deviation in px.

    Returns
    -------
    Frame
        The three pictures, enlarged alike, and how wrong the colours are.
    """
    truth, mosaic, guessed = _pictures(subject, softness)
    n = int(pixels)
    left = 2 * round(across * (SIZE[0] - n) / 2)
    top = 2 * round(down * (SIZE[1] - n) / 2)
    part = slice(top, top + n), slice(left, left + n)
    error = guessed[part] - truth[part]
    worst, rms = 100 * float(np.abs(error).max()), 100 * float(np.sqrt((error**2).mean()))
    place = f"{n} × {n} pixels of the {subject} at ({left}, {top})"
    pictures = (
        _enlarged("From the lens", f"{place}, in full colour.", truth[part]),
        _enlarged(
            "What the pixels see", f"The same behind the mosaic: {view}.", _seen(mosaic[part], view)
        ),
        _enlarged(
            "Demosaiced", f"The guessed colours; wrong by {rms:.1f} % on average.", guessed[part]
        ),
    )
    readouts = (
        Readout("Numbers measured", "", f"{n * n}"),
        Readout("Numbers guessed", "", f"{2 * n * n}"),
        Readout("Error of the colours (RMS)", "", f"{rms:.1f}", "%"),
        Readout("Largest error", "", f"{worst:.0f}", "%"),
        Readout("Top-left pixel", "", f"({left}, {top})"),
    )
    return Frame(pictures, readouts)


@lru_cache(maxsize=24)
def _pictures(subject: str, softness: float) -> tuple[Floats, Floats, Floats]:
    """Return a subject, its mosaic and the demosaiced picture, linear in light."""
    import cv2

    truth = _subject(subject)
    if softness > 0:
        truth = cv2.GaussianBlur(truth, (0, 0), softness, borderType=cv2.BORDER_REPLICATE)
    mosaic = bayer_mosaic(truth)
    return truth, np.asarray(mosaic, float), demosaic_bilinear(mosaic)


@cache
def _subject(name: str) -> Floats:
    """Return a colour picture of `SIZE`, linear in light, 0 to 1."""
    if name == STREET:
        camera = upright_camera((0.5, -3.5, 1.65), 40, (36, 24))
        return np.asarray(srgb_decode(renderer().picture(camera) / 255))
    if name == LABEL:
        from data_generators.belt import belt

        return np.asarray(np.clip(belt(), 0, 1), float)
    from data_generators.targets import siemens_star

    star = siemens_star(SIZE[1], 60) / 255
    paper = np.full(SIZE[::-1], star[0, 0])
    paper[:, (SIZE[0] - SIZE[1]) // 2 :][:, : SIZE[1]] = star
    return np.repeat(paper[..., None], 3, axis=2)


def _seen(mosaic: Floats, view: str) -> Floats:
    """Return the mosaic as a picture in colour."""
    spread = np.repeat(mosaic[..., None], 3, axis=2)
    if view == GREY:
        return spread
    masks = bayer_masks((mosaic.shape[0], mosaic.shape[1]))
    if view == GREEN:
        masks = masks & np.array([False, True, False])
    return np.asarray(spread * masks)


def _enlarged(title: str, alt: str, part: Floats) -> Picture:
    """Return a part, enlarged to `SHOWN` px without smoothing."""
    small = np.rint(255 * srgb_encode(np.clip(part, 0, 1))).astype(np.uint8)
    index = np.arange(SHOWN) * len(small) // SHOWN
    return Picture(title, alt, (SHOWN, SHOWN), np.ascontiguousarray(small[index][:, index]))
