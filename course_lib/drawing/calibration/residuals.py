"""Still figures of what a calibration leaves over: arrows, views one by one, the whole picture."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.calibration import rms_error
from course_lib.drawing.calibration.photographs import SIZE
from course_lib.drawing.diagrams import Floats, figure, panels, picture_frame, same_shape, write
from course_lib.drawing.style import FULL_WIDTH, GREY, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@figure("A photograph with an arrow at each corner: what is left over there, {times:g} times.")
def residual_arrows(
    photograph: NDArray[np.uint8],
    pixels: ArrayLike,
    residuals: ArrayLike | None,
    times: float = 10.0,
) -> Figure:
    """Show the residuals of one view over its photograph.

    Parameters
    ----------
    photograph : ndarray, shape (height, width)
        The picture.
    pixels : array_like, shape (N, 2)
        Where corners were seen.
    residuals : array_like, shape (N, 2), or None
        Projected minus observed, px.
    times : float
        How many times too long the arrows are.

    Returns
    -------
    Figure
        The photograph with arrows from the observed corners.
    """
    at = np.asarray(pixels, dtype=float)
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.8, 4.6))
    height, width = photograph.shape
    ax.imshow(photograph, vmin=0, vmax=255, alpha=0.55)
    picture_frame(ax, (width, height))
    left = same_shape(residuals, at)
    if left is None or not (np.abs(left) < 1e6).all():  # nor NaN
        write(ax, (width / 2, height / 2), "no answer yet", "guide", fontsize=14)
        return fig
    _arrows(ax, at, left, times)
    ax.set_title(
        f"RMS {rms_error(left):.2f} px, arrows × {times:g}, from seen towards projected",
        fontsize=10.5,
    )
    return fig


def _arrows(ax: Axes, at: Floats, left: Floats, times: float, **options: Any) -> None:
    """Draw residuals as arrows that begin where the corners were seen."""
    look: dict[str, Any] = {"angles": "xy", "scale_units": "xy", "scale": 1 / times}
    ax.quiver(*at.T, *left.T, **(look | {"color": ROLES["object"], "width": 0.004} | options))


@figure("What is left over in each view, as arrows {times:g} times too long, with its RMS.")
def views_one_by_one(
    pixels: Sequence[ArrayLike],
    residuals: Sequence[ArrayLike],
    times: float = 60.0,
) -> Figure:
    """Show the residuals of every view in a panel of its own.

    Parameters
    ----------
    pixels, residuals : sequence of array_like, shape (N, 2)
        Corners and residuals of each view, px.
    times : float
        How many times too long the arrows are.

    Returns
    -------
    Figure
        A panel for each view with the root mean square of its residuals.
    """
    rows = -(-len(pixels) // 5)
    fig, axes = panels(rows, 5, (FULL_WIDTH, 1.5 * rows), squeeze=False)
    for ax in axes.flat[len(pixels) :]:
        ax.axis("off")
    for number, (ax, at, left) in enumerate(zip(axes.flat, pixels, residuals, strict=False)):
        picture_frame(ax, SIZE)
        ax.set(xticks=[], yticks=[], xlabel="", ylabel="")
        _arrows(ax, np.asarray(at, float), np.asarray(left, float), times, width=0.008)
        ax.set_title(f"view {number}: {rms_error(left):.2f} px", fontsize=8.5, pad=2)
    fig.suptitle(f"arrows × {times:g}", fontsize=9, color=GREY, x=0.99, ha="right")
    return fig


@figure("All residuals over the picture, {times:g} times, and where they lie around zero.")
def over_the_picture(
    pixels: Sequence[ArrayLike], residuals: Sequence[ArrayLike], times: float = 60.0
) -> Figure:
    """Show the residuals of all views together: over the picture, and as a cloud around zero.

    Parameters
    ----------
    pixels, residuals : sequence of array_like, shape (N, 2)
        Corners and residuals of each view, px.
    times : float
        How many times too long the arrows are.

    Returns
    -------
    Figure
        Arrows over the picture, and the residuals as points.
    """
    at, left = (np.vstack([np.asarray(v, float) for v in x]) for x in (pixels, residuals))
    fig, (picture, cloud) = panels(1, 2, (FULL_WIDTH, 3.5), width_ratios=(1.5, 1))
    picture_frame(picture, SIZE)
    _arrows(picture, at, left, times, width=0.0025)
    picture.set_title(f"over the picture, arrows × {times:g}", fontsize=10.5)
    reach = 1.1 * np.abs(left).max()
    cloud.plot(*left.T, ".", color=ROLES["object"], ms=3, alpha=0.5)
    turn = np.linspace(0, 2 * np.pi, 91)
    rms = rms_error(left)
    cloud.plot(rms * np.cos(turn), rms * np.sin(turn), color=ROLES["camera"], lw=2)
    cloud.axhline(0, color=GREY, lw=0.8, zorder=0)
    cloud.axvline(0, color=GREY, lw=0.8, zorder=0)
    cloud.set(xlim=(-reach, reach), ylim=(reach, -reach), aspect="equal")
    cloud.set(xlabel="du (px)", ylabel="dv (px)")
    cloud.set_title(f"circle: RMS {rms:.3f} px", fontsize=10.5)
    return fig
