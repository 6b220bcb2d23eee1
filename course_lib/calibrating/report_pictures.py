"""Pictures of a report, drawn as SVG: lines stay sharp, and the page needs no other file."""

from __future__ import annotations

import base64

import numpy as np
from numpy.typing import NDArray

from course_lib.calibrating.looking import Photo
from course_lib.calibrating.solving import Solved
from course_lib.calibration import Coverage
from course_lib.checks import Array
from course_lib.page import BLUE, DARK, ORANGE, svg

#: Arrows of residuals are this long for a typical one, by the picture's width.
TYPICAL_ARROW = 0.02


def photo_svg(
    photo: Photo,
    pixels: Array | None = None,
    residuals: Array | None = None,
    kept: NDArray[np.bool_] | None = None,
    scale: float = 1.0,
) -> str:
    """Return a photograph with its points, and arrows to where the camera expects them, scaled."""
    if photo.thumbnail is None or photo.header is None:
        return "<div class='blank'>no picture</div>"
    width, height = photo.header.size
    marks = []
    if pixels is None and photo.detection is not None:
        pixels = photo.detection.points
    radius = 0.011 * width
    for i, (u, v) in enumerate(pixels if pixels is not None else ()):
        colour = ORANGE if kept is not None and not kept[i] else BLUE
        marks.append(
            f"<circle cx='{u:.1f}' cy='{v:.1f}' r='{radius:.1f}' fill='none' stroke='{colour}' "
            f"stroke-width='{radius / 2.5:.2f}'/>"
        )
    if pixels is not None and residuals is not None:
        marks.append(_arrows(pixels, scale * residuals, width, ORANGE))
    image = (
        f"<image href='{_png(photo.thumbnail)}' x='-0.5' y='-0.5' width='{width}' "
        f"height='{height}' preserveAspectRatio='none'/>"
    )
    said = f"{len(pixels) if pixels is not None else 0} points found in {photo.name}"
    return _svg(width, height, image + "".join(marks), said)


def _png(picture: NDArray[np.uint8]) -> str:
    """Return a picture as an address that holds all of it."""
    import cv2

    encoded = cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, 80])[1]
    return "data:image/jpeg;base64," + base64.b64encode(encoded.tobytes()).decode()


def coverage_svg(covered: Coverage, size: tuple[int, int]) -> str:
    """Return how many points there are in each part of the picture."""
    (rows, columns), (width, height) = covered.counts.shape, size
    parts, most = [], max(int(covered.counts.max()), 1)
    for (row, column), count in np.ndenumerate(covered.counts):
        x, y = column * width / columns - 0.5, row * height / rows - 0.5
        shade = 0.1 + 0.9 * count / most if count else 0
        parts.append(
            f"<rect x='{x:.1f}' y='{y:.1f}' width='{width / columns:.1f}' "
            f"height='{height / rows:.1f}' fill='{BLUE}' fill-opacity='{0.6 * shade:.2f}' "
            f"stroke='#999' stroke-width='{width / 900:.2f}'/>"
            f"<text x='{x + width / columns / 2:.1f}' y='{y + height / rows / 2:.1f}' "
            f"font-size='{width / 32:.1f}' text-anchor='middle' dominant-baseline='central' "
            f"fill='{DARK}'>{count}</text>"
        )
    said = f"points in each part of the picture: {100 * covered.share:.0f} % are covered"
    return (
        f"<figure>{_svg(width, height, ''.join(parts), said)}<figcaption>Points in each part "
        "of the picture.</figcaption></figure>"
    )


def residuals_svg(solved: Solved) -> str:
    """Return the residuals of all views over the picture, magnified."""
    width, height = solved.calibration.image_size
    pixels = np.concatenate([p[k] for p, k in zip(solved.pixels, solved.kept, strict=True)])
    residuals, scale = kept_residuals(solved), magnification(solved)
    frame = (
        f"<rect x='-0.5' y='-0.5' width='{width}' height='{height}' fill='white' stroke='#999' "
        f"stroke-width='{width / 600:.2f}'/>"
    )
    said = f"residuals of all views, {scale:.0f} times as long"
    drawn = _svg(width, height, frame + _arrows(pixels, scale * residuals, width, BLUE), said)
    return (
        f"<figure>{drawn}<figcaption>From each point to where the camera expects it, "
        f"{scale:.0f} times as long. Arrows that point all ways are chance; neighbours that agree "
        "are something the camera's model lacks, or a bent board.</figcaption></figure>"
    )


def kept_residuals(solved: Solved) -> Array:
    """Return the residuals of all points that were not rejected, shape (N, 2), px."""
    views = zip(solved.calibration.residuals, solved.kept, strict=True)
    return np.concatenate([residuals[kept] for residuals, kept in views])


def magnification(solved: Solved) -> float:
    """Return by how much residuals are drawn longer: 1, 2 or 5 times a power of ten."""
    usual = float(np.sqrt(np.mean((kept_residuals(solved) ** 2).sum(axis=1))))
    wanted = TYPICAL_ARROW * solved.calibration.image_size[0] / max(usual, 1e-9)
    power = 10 ** np.floor(np.log10(wanted))
    return float(max(step * power for step in (1, 2, 5) if step * power <= wanted))


def _arrows(pixels: Array, steps: Array, width: int, colour: str) -> str:
    """Return lines from points along steps."""
    ends = pixels + steps
    lines = "".join(
        f"M{u:.1f} {v:.1f}L{x:.1f} {y:.1f}" for (u, v), (x, y) in zip(pixels, ends, strict=True)
    )
    return f"<path d='{lines}' stroke='{colour}' stroke-width='{width / 400:.2f}' fill='none'/>"


def _svg(width: int, height: int, content: str, said: str) -> str:
    return svg(f"-0.5 -0.5 {width} {height}", content, said)
