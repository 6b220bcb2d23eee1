"""Still figures of disparity: where it comes from, and the depth that it tells."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from course_lib.drawing.diagrams import dimension, figure, panels, same_shape, sketch, stroke, write
from course_lib.drawing.style import FULL_WIDTH, ROLES
from course_lib.drawing.triangulation.pair import BASELINE, MARKED, OFFSET, F
from course_lib.drawing.triangulation.rays import OUTSIDE
from course_lib.triangulation import depth_from_disparity

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@figure("Two cameras from above and the triangles they make; depth against disparity, a hyperbola.")
def disparity_and_depth(yours: Any = None) -> Figure:
    """Show the similar triangles of a rectified pair, and the depth of the motorcycle's pair.

    Parameters
    ----------
    yours : array_like, shape (2,), optional
        A student's depths of the marked points, mm.

    Returns
    -------
    Figure
        Triangles from above, and a curve with stars.
    """
    fig, (above, curve) = panels(1, 2, (FULL_WIDTH, 3.8), width_ratios=(1, 1.15))
    _triangles(sketch(above))
    d = np.linspace(5, 69, 200)
    curve.plot(d, depth_from_disparity(d, F, BASELINE, OFFSET) / 1000, color=ROLES["camera"])
    apart = [left[0] - right[0] for left, right in MARKED.values()]
    stars = same_shape(yours, np.zeros(2))
    for k, (name, disparity) in enumerate(zip(MARKED, apart, strict=True)):
        depth = float(depth_from_disparity(disparity, F, BASELINE, OFFSET)) / 1000
        curve.plot(disparity, depth, "o", ms=11, mfc="none", mec=ROLES["object"], mew=2)
        curve.annotate(
            name,
            (disparity, depth),
            (0, -20) if k else (0, 13),
            textcoords="offset points",
            color=ROLES["object"],
            ha="center",
        )
        if stars is not None and 1500 < stars[k] < 5500:
            curve.plot(disparity, stars[k] / 1000, "*", color=ROLES["ray"], ms=14, mec="black")
    if stars is not None and not ((stars > 1500) & (stars < 5500)).all():
        write(curve, (40, 5.1), OUTSIDE, "guide")
    curve.set(xlabel="disparity d (px)", ylabel="depth Z (m)", ylim=(1.5, 5.5), xlim=(0, 70))
    curve.grid(color=ROLES["guide"], alpha=0.3, lw=0.8)
    return fig


def _triangles(ax: Axes) -> None:
    """Draw two cameras, their image planes and a point from above."""
    b, f, X, Z = 2.6, 1.9, 1.4, 4.6
    for x, name in ((0.0, "left"), (b, "right")):
        stroke(ax, [(x, 0), (x, 3.3)], "guide", lw=1, ls=(0, (5, 4)))
        stroke(ax, [(x, 0), (X, Z)], "ray", lw=1.8)
        stroke(ax, [(x - 0.75, f), (x + 0.75, f)], "image", lw=2.5)
        at = x + (X - x) * f / Z
        ax.plot([x, at], [f, f], "-", color=ROLES["object"], lw=6, solid_capstyle="butt", zorder=3)
        ax.plot(at, f, "o", color=ROLES["image"], ms=5, zorder=4)
        ax.plot(x, 0, "s", color=ROLES["camera"], ms=9)
        write(ax, (x, -0.95), name, "camera")
    ax.plot(X, Z, "o", color=ROLES["object"], ms=9)
    write(ax, (X, Z + 0.32), "point at depth Z", "object")
    write(ax, (-0.1, f + 0.33), "$u_L - c_L$", ha="right", fontsize=10)
    write(ax, (b + 0.1, f + 0.33), "$u_R - c_R$", ha="left", fontsize=10)
    dimension(ax, (0, -0.45), (b, -0.45), "b")
    dimension(ax, (-0.95, 0), (-0.95, f), "f")
    dimension(ax, (4.3, 0), (4.3, Z), "Z")
    ax.set(xlim=(-1.3, 4.65), ylim=(-1.3, 5.3))
