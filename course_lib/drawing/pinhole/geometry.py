"""Still figures: similar triangles, the two image planes and the convention of older texts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from course_lib.drawing.diagrams import dimension, figure, fit, panels, sketch, stroke, tree, write
from course_lib.drawing.style import BLACK, FULL_WIDTH, GREEN, GREY, ORANGE, RED, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@figure(
    "From above: a small triangle with the sides f and x lies inside a large one with the "
    "sides Z and X; both have a corner in the hole and share its angle."
)
def similar_triangles(f: float = 2.0, X: float = 1.5, Z: float = 6.0) -> Figure:
    """Show the two similar triangles from which the pinhole equation is read.

    Parameters
    ----------
    f, X, Z : float
        Focal length, sideways position and depth of the point, one unit of length.

    Returns
    -------
    Figure
        Top view: hole, image plane in front of it, optical axis and point. To look forward is to
        look to the right in it, so that the camera's right is down.
    """
    x = f * X / Z
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.3))
    sketch(ax)
    ax.fill([0, Z, Z], [0, 0, -X], color=ORANGE, alpha=0.15, lw=0)
    ax.fill([0, f, f], [0, 0, -x], color=GREEN, alpha=0.35, lw=0)
    stroke(ax, [(0, 0), (Z, -X)], "ray")
    _axis(ax, -0.3, Z + 1.3)
    stroke(ax, [(f, 0.5), (f, -1.2 * X)], "image", lw=3)
    stroke(ax, [(Z, 0), (Z, -X)], "object", lw=3)
    ax.plot(Z, -X, "o", color=ROLES["object"], ms=9)
    ax.plot(f, -x, "o", color=ROLES["image"], ms=9)
    ax.plot(0, 0, "o", color=BLACK, ms=8)
    write(ax, (-0.15, 0.12), "hole", ha="right", va="bottom")
    write(ax, (f - 0.08, -x / 2), "$x$", "image", ha="right", fontsize=13)
    write(ax, (Z + 0.12, -X / 2), "$X$", "object", ha="left", fontsize=13)
    write(ax, (Z, -X - 0.2), "point", "object", va="top")
    write(ax, (f, -1.2 * X - 0.1), "image plane", "image", va="top")
    dimension(ax, (0, 0.7), (f, 0.7), "$f$")
    dimension(ax, (0, 1.2), (Z, 1.2), "$Z$")
    _right_and_forward(ax, (-0.9, -0.7))
    fit(ax, -1.7, Z + 1.4, -1.2 * X - 0.6, 1.5)
    return fig


def _right_and_forward(ax: Axes, at: tuple[float, float]) -> None:
    """Draw the camera's directions as they lie on a page that is seen from above."""
    arrow = {"arrowstyle": "-|>", "color": BLACK, "shrinkA": 0, "shrinkB": 0}
    for way, name in (((0.7, 0), "$Z$"), ((0, -0.7), "$X$")):
        tip = (at[0] + way[0], at[1] + way[1])
        ax.annotate("", xy=tip, xytext=at, arrowprops=arrow)
        write(ax, (at[0] + 1.25 * way[0], at[1] + 1.28 * way[1]), name)


def _axis(ax: Axes, left: float, right: float) -> None:
    ax.plot([left, right], [0, 0], color=GREY, lw=1, ls=(0, (8, 4)))
    write(ax, (right, 0.08), "optical axis", "guide", ha="right", va="bottom", fontsize=9)


@figure(
    "A tree and its image from the side, twice: behind the hole the image is upside down; on "
    "a plane in front of the hole, at the same distance f, it is upright and equally large."
)
def image_planes(f: float = 2.0, height: float = 2.4, Z: float = 5.0) -> Figure:
    """Show the image behind the hole, upside down, and the same image in front of it, upright.

    Parameters
    ----------
    f, height, Z : float
        Focal length, height of the tree and its distance from the hole, one unit of length.

    Returns
    -------
    Figure
        Side views: a real camera obscura, and the way the course draws it.
    """
    fig, axes = panels(2, 1, (FULL_WIDTH, 5.4))
    titles = ("Behind the hole: what a box with a hole does", "In front: what we compute with")
    for ax, side, title in zip(axes, (-1, 1), titles, strict=True):
        sketch(ax, title)
        foot, top = -height / 3, 2 * height / 3
        tree(ax, (Z, foot), height)
        for y in (foot, top):
            stroke(ax, [(min(side * f, 0), min(side, 0) * f * y / Z), (Z, y)], "ray", lw=1.3)
        _axis(ax, -f - 0.4, Z + 2.3)
        stroke(ax, [(side * f, -1.25), (side * f, 1.25)], "image", lw=3)
        tree(ax, (side * f, side * f * foot / Z), side * f * height / Z, "image")
        ax.plot(0, 0, "o", color=BLACK, ms=8, zorder=5)
        write(ax, (0, 0.22), "hole", va="bottom")
        dimension(ax, (0, -1.45), (side * f, -1.45), "$f$")
        dimension(ax, (0, -1.95), (Z, -1.95), "$Z$")
        sign = "$y = -fY/Z$" if side < 0 else "$y = fY/Z$"
        write(ax, (side * f, 1.3), sign, "image", va="bottom", fontsize=13)
        fit(ax, -f - 1.2, Z + 2.4, -2.25, 1.9)
    return fig


@figure(
    "One camera from above: older texts count Z from the image plane behind the lens, the "
    "course counts it from the lens, so the two differ by f."
)
def lens_centred(f: float = 1.5, X: float = 1.5, Z_old: float = 6.5) -> Figure:
    """Show one camera with the axes of older texts and with ours.

    Parameters
    ----------
    f, X, Z_old : float
        Focal length, and the point's sideways position and distance from the image plane.

    Returns
    -------
    Figure
        Top view. In the old convention the origin lies on the image plane behind the lens, so
        that the lens is at Z = f; in ours it lies in the lens.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.3))
    sketch(ax)
    x = f * X / (f - Z_old)
    stroke(ax, [(0, x), (Z_old, X)], "ray")
    _axis(ax, -0.5, Z_old + 1.2)
    stroke(ax, [(0, -1.0), (0, 1.0)], "image", lw=3)
    ax.plot([f], [0], "o", color=BLACK, ms=9)
    ax.plot([Z_old], [X], "o", color=RED, ms=9)
    ax.plot([0], [x], "o", color=GREEN, ms=9)
    stroke(ax, [(Z_old, 0), (Z_old, X)], "object", lw=2, ls=":")
    write(ax, (0, 1.08), "image plane", "image", va="bottom")
    write(ax, (f, 0.2), "lens", va="bottom")
    write(ax, (Z_old, X + 0.15), "point", "object", va="bottom")
    write(ax, (Z_old + 0.1, X / 2), "$X$", "object", ha="left", fontsize=13)
    write(ax, (-0.15, x), "$x$", "image", ha="right", fontsize=13)
    dimension(ax, (0, -1.25), (f, -1.25), "$f$")
    dimension(ax, (f, -1.25), (Z_old, -1.25), "ours: $Z$")
    dimension(ax, (0, -1.8), (Z_old, -1.8), r"older texts: $Z_{\mathrm{old}} = Z + f$")
    fit(ax, -1.0, Z_old + 1.3, -2.1, X + 0.55)
    return fig
