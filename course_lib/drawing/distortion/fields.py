"""Still figures: by how many pixels a lens moves each point of the picture."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.distortion import displacement_field, opencv_from_bouguet, pixel_grid
from course_lib.drawing.diagrams import Floats, figure, panels, picture_frame
from course_lib.drawing.style import BLACK, FULL_WIDTH, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: The camera of Bouguet's first calibration example, as printed after the last step.
CLASSIC_SIZE = (640, 480)
CLASSIC_K, CLASSIC_LENS = opencv_from_bouguet(
    [657.30254, 657.74391], [302.71656, 242.33386], 0, [-0.25349, 0.11868, -0.00028, 0.00005, 0]
)
#: Iso-lines of each part, px.
LEVELS = {
    "complete": np.arange(5.0, 30, 5),
    "radial": np.arange(5.0, 30, 5),
    "tangential": np.arange(0.02, 0.15, 0.03),
}


@figure(
    "Displacement of the pixels of the classic example: complete, radial and tangential part, "
    "with lines of equal displacement in px and arrows that show its direction."
)
def displacement_fields(
    K: ArrayLike = CLASSIC_K,
    coefficients: ArrayLike = CLASSIC_LENS,
    image_size: tuple[int, int] = CLASSIC_SIZE,
) -> Figure:
    """Show the complete, the radial and the tangential displacement over a picture.

    Parameters
    ----------
    K : array_like, shape (3, 3)
        Intrinsics, px.
    coefficients : array_like
        As in `course_lib.distortion.distort`.
    image_size : tuple of int
        Width and height, px.

    Returns
    -------
    Figure
        A panel for each part; arrows are scaled panel by panel.
    """
    fig, axes = panels(1, 3, (FULL_WIDTH, 2.7), sharey=True)
    for ax, part in zip(axes, ("complete", "radial", "tangential"), strict=True):
        largest = _field(ax, np.asarray(K, float), coefficients, image_size, part)
        ax.set_title(f"{part.capitalize()}, up to {largest:#.3g} px", fontsize=10)
        if part != "complete":
            ax.set_ylabel("")
    return fig


def _field(ax: Axes, K: Floats, coefficients: ArrayLike, size: tuple[int, int], part: str) -> float:
    """Draw arrows and iso-lines of one part, and return the largest displacement."""
    fine = pixel_grid(size, 81, 61)
    moved = displacement_field(fine.reshape(-1, 2), K, coefficients, part).reshape(fine.shape)
    distance = np.hypot(moved[..., 0], moved[..., 1])
    lines = ax.contour(
        fine[..., 0], fine[..., 1], distance, LEVELS[part], colors=ROLES["camera"], linewidths=1.1
    )
    _numbered(ax, lines, fine, distance, LEVELS[part])
    places = pixel_grid(size, 11, 8).reshape(-1, 2)
    arrows = displacement_field(places, K, coefficients, part)
    scale = np.hypot(*arrows.T).max() / 75  # px: the longest arrow as drawn
    look = {"angles": "xy", "scale_units": "xy", "scale": scale, "width": 0.009}
    ax.quiver(*places.T, *arrows.T, color=ROLES["ray"], **look)
    ax.plot(*K[:2, 2], "+", color=BLACK, ms=10, mew=1.8)
    picture_frame(ax, size)
    return float(distance.max())


def _numbered(ax: Axes, lines: Any, fine: Floats, distance: Floats, levels: NDArray[Any]) -> None:
    """Write on each iso-line what it stands for, where it crosses the way to a corner."""
    way = np.linspace(len(fine) // 2, 0, 60)  # from the centre to the upper right
    across = np.rint(fine.shape[1] / 2 + (way[0] - way) * 1.3).astype(int)
    places, along = fine[way.astype(int), across], distance[way.astype(int), across]
    reached = [float(level) for level in levels[::2] if along.min() < level < along.max()]
    spots = [tuple(places[np.argmin(np.abs(along - level))]) for level in reached]
    texts = ax.clabel(lines, reached, manual=spots, fontsize=8, colors=BLACK, fmt="%g")
    for text in texts:
        text.set(rotation=0, bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5})
