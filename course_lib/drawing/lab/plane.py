"""A length on the target's plane: a ray meets it, and the desk as seen from straight above."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.distortion import distort_pixels
from course_lib.drawing.diagrams import (
    Floats,
    dimension,
    figure,
    fit,
    panels,
    sketch,
    stroke,
    write,
)
from course_lib.drawing.style import FULL_WIDTH, ROLES

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Pixels = NDArray[np.uint8]

FINE = 0.5  # mm: a pixel of the view from above
#: The camera, its height, and a thing of some height on the desk, in the sketch's units.
HIGH, THING, AT = 5.0, 1.0, 4.0


@figure(
    "A ray from the camera to a point above the desk goes on and meets the desk farther out, so "
    "who forgets the height measures too long."
)
def ray_and_plane() -> Figure:
    """Show the ray of a pixel, the plane it meets, and what a forgotten height does."""
    fig, ax = panels(1, 1, (FULL_WIDTH, 2.9))
    sketch(ax)
    end = AT * HIGH / (HIGH - THING)
    stroke(ax, [(-1.2, 0), (6.6, 0)], "guide", lw=3)
    write(ax, (1.1, -0.4), "the plane of the target, z = 0", "guide", fontsize=9)
    stroke(ax, [(0, HIGH), (AT, THING)], "ray")
    stroke(ax, [(AT, THING), (end, 0)], "ray", ls="--")
    ax.plot(0, HIGH, "o", color=ROLES["camera"], ms=8)
    write(ax, (0.25, HIGH), "camera C", "camera", ha="left", fontsize=10)
    ax.plot(AT, THING, "o", color=ROLES["object"], ms=7)
    write(ax, (AT + 0.2, THING + 0.15), "what was pointed at", "object", ha="left", fontsize=9)
    ax.plot(end, 0, "o", mfc="white", mec=ROLES["object"], ms=7)
    write(ax, (end + 0.2, 0.3), "what is measured", "object", ha="left", fontsize=9)
    dimension(ax, (-0.7, 0), (-0.7, HIGH), "Z", fontsize=10)
    dimension(ax, (AT, 0), (AT, THING), "h", fontsize=10)
    fit(ax, -2.6, 8.6, -0.7, HIGH + 0.4)
    return fig


@figure(
    "The desk as if seen from straight above, with a scale in millimetres and what is measured."
)
def from_above(
    photograph: Pixels,
    camera: tuple[ArrayLike, ArrayLike, ArrayLike, ArrayLike],
    extent: tuple[float, float, float, float],
    ends: ArrayLike | None = None,
    text: str = "",
) -> Figure:
    """Show a photograph turned into a map of the target's plane.

    Parameters
    ----------
    photograph : ndarray, shape (h, w, 3), uint8
        RGB.
    camera : tuple of array_like
        K, coefficients, and the pose R, t from the target's frame.
    extent : tuple of float
        Smallest and largest x, smallest and largest y, mm.
    ends : array_like, shape (2, 2), optional
        Both ends of a length, mm on the plane.
    text : str
        Written at the length.

    Returns
    -------
    Figure
        With axes in mm; y runs down, as on the target.
    """
    left, right, top, bottom = extent
    map_ = above(photograph, camera, extent)
    shape = (bottom - top) / (right - left)
    fig, ax = panels(1, 1, (FULL_WIDTH, FULL_WIDTH * shape + 0.4))
    ax.imshow(map_, extent=(left, right, bottom, top))
    if ends is not None:
        (x, y), (x2, y2) = np.asarray(ends, float)
        ax.plot([x, x2], [y, y2], "-", color="white", lw=4)
        ax.plot([x, x2], [y, y2], "o-", color=ROLES["object"], lw=2, ms=4)
        at = ((x + x2) / 2, min(y, y2) - 0.06 * (bottom - top))
        write(ax, at, text, fontsize=10, bbox={"facecolor": "white", "edgecolor": "none", "pad": 2})
    ax.set(xlabel="x (mm)", ylabel="y (mm)", xlim=(left, right), ylim=(bottom, top))
    return fig


def above(
    photograph: Pixels,
    camera: tuple[ArrayLike, ArrayLike, ArrayLike, ArrayLike],
    extent: tuple[float, float, float, float],
) -> Pixels:
    """Return a photograph as a map of the target's plane, two pixels a mm; white where none is."""
    import cv2

    K, coefficients, R, t = (np.asarray(part, float) for part in camera)
    left, right, top, bottom = extent
    x, y = np.arange(left, right, FINE) + FINE / 2, np.arange(top, bottom, FINE) + FINE / 2
    points: Floats = np.stack([*np.meshgrid(x, y), np.zeros((len(y), len(x)))], axis=-1)
    seen = points.reshape(-1, 3) @ R.T + t
    ideal = seen @ K.T
    in_front = seen[:, 2] > 1e-6
    pixels = np.full((len(seen), 2), -1e4)
    pixels[in_front] = distort_pixels(ideal[in_front, :2] / ideal[in_front, 2:], K, coefficients)
    where = np.nan_to_num(pixels, nan=-1e4).reshape(len(y), len(x), 2).astype(np.float32)
    map_ = cv2.remap(photograph, where, None, cv2.INTER_LINEAR, borderValue=(255, 255, 255))
    return np.asarray(map_, np.uint8)
