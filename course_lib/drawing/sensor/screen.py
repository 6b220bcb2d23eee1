"""What the still figures of chapter 04 share: light on a screen, and numbers on grey squares."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.style import BLACK
from course_lib.sensor import srgb_encode

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def shown(light: ArrayLike) -> NDArray[np.float64]:
    """Return a picture that is linear in light, 0 to 1, as a screen needs it; more is white."""
    return np.asarray(srgb_encode(np.clip(np.asarray(light, dtype=float), 0, 1)))


def picture(ax: Axes, image: ArrayLike, title: str = "", **options: Any) -> None:
    """Show a picture without axes, grey ones from 0 to 1."""
    ax.imshow(np.asarray(image), **{"vmin": 0, "vmax": 1, **options})
    ax.set(xticks=[], yticks=[])
    ax.spines[:].set_visible(False)
    ax.set_title(title, fontsize=10)


def grey_squares(ax: Axes, values: NDArray[np.generic], white: float, size: float = 10) -> None:
    """Write each value of a small picture on a square of its grey."""
    ax.imshow(values, vmin=0, vmax=white)
    ax.set(xticks=[], yticks=[])
    for (i, j), value in np.ndenumerate(values):
        ink = BLACK if float(value) > 0.47 * white else "white"
        ax.text(j, i, f"{value}", color=ink, ha="center", va="center", fontsize=size)
