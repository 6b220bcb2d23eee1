"""The two photographs of the chapter: a motorcycle, two cameras side by side, the true depth."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.diagrams import Floats, figure, panels
from course_lib.drawing.style import FULL_WIDTH, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

RGB = NDArray[np.uint8]

#: Of both cameras, as published with the photographs: px, mm, px.
F, BASELINE, OFFSET = 994.978, 193.001, 31.086
K_LEFT = np.array([[F, 0, 311.193], [0, F, 254.877], [0, 0, 1]])
K_RIGHT = np.array([[F, 0, 311.193 + OFFSET], [0, F, 254.877], [0, 0, 1]])
#: Camera matrices; the world is the frame of the left camera, in mm.
P_LEFT = np.column_stack([K_LEFT, np.zeros(3)])
P_RIGHT = np.column_stack([K_RIGHT, K_RIGHT @ [-BASELINE, 0, 0]])
SIZE = (741, 500)
#: By name: pixels in the left and in the right picture, marked by hand to about half a pixel.
MARKED = {
    "rear lamp": ((97.0, 208.0), (52.0, 208.5)),
    "front axle": ((573.0, 380.0), (521.5, 379.5)),
}
NEAR = 24  # px to each side that are enlarged


@dataclass(frozen=True, eq=False)
class Pair:
    """Two rectified photographs and the true disparity of the left one.

    Attributes
    ----------
    left, right : ndarray, shape (500, 741, 3), uint8
        RGB.
    truth : ndarray, shape (500, 741)
        Disparity in px; NaN where nobody measured it.
    """

    left: RGB
    right: RGB
    truth: Floats


@cache
def motorcycle() -> Pair:
    """Return the photographs of the motorcycle and the disparity that was measured by other means.

    Returns
    -------
    Pair
        The pair, a quarter of its published size.

    References
    ----------
    D. Scharstein et al., "High-resolution stereo datasets with subpixel-accurate ground truth",
    GCPR 2014.
    """
    from skimage.data import stereo_motorcycle

    left, right, disparity = stereo_motorcycle()
    truth = np.where(np.isfinite(disparity), disparity, np.nan).astype(np.float64)
    return Pair(left, right, truth)


@figure("A motorcycle in a garage from two places, with its rear lamp and its front axle marked.")
def marked_pair() -> Figure:
    """Show both photographs with the points that were marked by hand, and these enlarged.

    Returns
    -------
    Figure
        Two photographs; below them both points, left and right.
    """
    pair = motorcycle()
    fig, axes = panels(2, 4, (FULL_WIDTH, 4.9), height_ratios=(2.9, 2))
    grid = axes[0, 0].get_gridspec()
    for ax in axes[0]:
        ax.remove()
    for side, picture in enumerate((pair.left, pair.right)):
        ax = fig.add_subplot(grid[0, 2 * side : 2 * side + 2])
        ax.imshow(picture)
        ax.set_title(("left camera", "right camera")[side])
        ax.axis("off")
        for (name, pixels), low in zip(MARKED.items(), (-1, 1), strict=True):
            u, v = pixels[side]
            ax.plot(u, v, "o", ms=11, mfc="none", mec="white", mew=3.5)
            ax.plot(u, v, "o", ms=11, mfc="none", mec=ROLES["camera"], mew=2)
            look = {"fc": "white", "ec": "none", "alpha": 0.85, "pad": 1.5}
            ax.text(
                u, v + low * 40, name, ha="left" if u < 300 else "center", va="center", bbox=look
            )
    for number, (name, pixels) in enumerate(MARKED.items()):
        for side, picture in enumerate((pair.left, pair.right)):
            _enlarged(axes[1, 2 * side + number], picture, pixels[side], name)
    return fig


def _enlarged(ax: Axes, picture: RGB, pixel: tuple[float, float], name: str) -> None:
    """Show the surroundings of a pixel, with a cross on it and its numbers."""
    u, v = pixel
    ax.imshow(picture)
    ax.set(xlim=(u - NEAR, u + NEAR), ylim=(v + NEAR, v - NEAR), xticks=[], yticks=[])
    for colour, width in (("white", 3.5), (ROLES["camera"], 1.8)):
        ax.plot(u, v, "+", ms=17, color=colour, mew=width)
    ax.set_title(f"({u:.1f}, {v:.1f})", fontsize=11, fontweight="normal", loc="center")
    ax.set_xlabel(name)
