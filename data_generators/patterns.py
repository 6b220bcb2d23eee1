"""Patterns without repetition, as glaze, soil or grass have them: detail of every size."""

from __future__ import annotations

import numpy as np

from course_lib.checks import Array
from course_lib.sensor import srgb_decode
from data_generators.scene import Texture


def clouds(
    rng: np.random.Generator, shape: tuple[int, int], sizes: tuple[float, ...], wrap: bool = False
) -> Array:
    """Return smooth noise: spots of several sizes, each as strong as the others.

    Parameters
    ----------
    rng : numpy.random.Generator
        Draws it.
    shape : tuple of int
        Rows and columns.
    sizes : tuple of float
        Standard deviations of the blurs, px.
    wrap : bool
        Whether the left and the right border fit each other; half of each size, rounded down,
        must then divide the number of columns.

    Returns
    -------
    ndarray, shape `shape`
        Mean 0, standard deviation 1.
    """
    import cv2

    total = np.zeros(shape, np.float32)
    for size in sizes:
        # Wide blurs are made small and enlarged: it is quicker, and looks the same.
        coarse = max(1, int(size / 2))
        rows, columns = (-(-side // coarse) for side in shape)
        margin = int(4 * size / coarse) + 1
        rough = rng.standard_normal((rows + 2 * margin, columns + 2 * margin), np.float32)
        if wrap:
            rough[:, -margin:] = rough[:, margin : 2 * margin]
            rough[:, :margin] = rough[:, columns : columns + margin]
        smooth = cv2.GaussianBlur(rough, (0, 0), size / coarse)
        around = cv2.resize(smooth, None, fx=coarse, fy=coarse, interpolation=cv2.INTER_CUBIC)
        first = margin * coarse
        part = around[first : first + shape[0], first : first + shape[1]]
        total += part / part.std()
    return np.asarray((total - total.mean()) / total.std(), np.float64)


def spots(
    picture: Array, rng: np.random.Generator, count: int, radii: tuple[float, float], colour: Array
) -> None:
    """Paint spots of any size between two radii, px, in shades of a colour, where chance wills."""
    import cv2

    height, width = picture.shape[:2]
    for _ in range(count):
        x, y = rng.uniform(0, width), rng.uniform(0, height)
        axes = rng.uniform(*radii, 2)
        shade = np.clip(colour * rng.uniform(0.6, 1.3), 0, 1).tolist()
        place = (round(16 * x), round(16 * y)), (round(16 * axes[0]), round(16 * axes[1]))
        cv2.ellipse(picture, *place, rng.uniform(0, 180), 0, 360, shade, -1, cv2.LINE_AA, 4)


def target(picture: Array, column: float, row: float, radius: float) -> None:
    """Paint a survey mark: a white disc with two black quarters that meet in its middle.

    Parameters
    ----------
    picture : ndarray, shape (h, w, 3)
        Where it is painted, 0 to 1; changed in place.
    column, row : float
        Of its middle, px; ``(0, 0)`` is the middle of the first pixel.
    radius : float
        Of the quarters, px; the disc is half as large again. All of it must be in the picture.
    """
    reach = int(1.5 * radius) + 2
    left, top = int(column) - reach, int(row) - reach
    # Eight samples a pixel, each way, make the edges smooth.
    fine = (np.arange(8 * (2 * reach + 1)) + 0.5) / 8 - 0.5
    x, y = left + fine - column, (top + fine - row)[:, None]
    distance = np.hypot(x, y)
    disc, quarters = distance < 1.5 * radius, (distance < radius) & (x * y > 0)
    inside, black = (
        part.reshape(2 * reach + 1, 8, -1, 8).mean(axis=(1, 3))[..., None]
        for part in (disc, quarters)
    )
    window = picture[top : top + 2 * reach + 1, left : left + 2 * reach + 1]
    window[:] = window * (1 - inside) + inside - black


def as_texture(picture: Array) -> Texture:
    """Return colours as a screen shows them, 0 to 1, as a texture, linear in light."""
    linear = np.rint(255 * srgb_decode(np.arange(256) / 255)).astype(np.uint8)
    return np.asarray(linear[np.rint(255 * np.clip(picture, 0, 1)).astype(np.uint8)])
