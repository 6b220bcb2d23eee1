"""What the still figures share: one frame for all of them, and small pieces to draw with."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from inspect import signature
from typing import TYPE_CHECKING, Any, ParamSpec, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.style import BLACK, GREY, ROLES, course_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

P = ParamSpec("P")
Floats = NDArray[np.float64]


@overload
def figure(draw: Callable[P, Figure], /) -> Callable[P, Figure]: ...
@overload
def figure(description: str, /) -> Callable[[Callable[P, Figure]], Callable[P, Figure]]: ...
def figure(argument: Any, /) -> Any:
    """Draw in the course's style, and show the figure once: as the value of its cell.

    Use it as ``@figure`` or, better, as ``@figure("What the picture shows, in a sentence.")``. A
    field such as ``{f:g}`` in the sentence is filled with the function's argument of that name.

    Parameters
    ----------
    argument : str or callable
        The text alternative of the figure; or the function itself, which returns a Matplotlib
        figure. Then the first line of its docstring is the text alternative.

    Returns
    -------
    callable
        The same function; its figure is a `DescribedFigure` and is closed, so that a notebook
        does not show it twice.
    """
    if isinstance(argument, str):
        return lambda draw: _styled(draw, argument)
    summary = (argument.__doc__ or "").strip().partition("\n")[0]
    return _styled(argument, summary.replace("{", "{{").replace("}", "}}"))


def _styled(draw: Callable[P, Figure], description: str) -> Callable[P, Figure]:
    """Return `draw` with the course's style around it and a description of its figure."""
    parameters = signature(draw)

    @wraps(draw)
    def styled(*args: P.args, **kwargs: P.kwargs) -> Figure:
        import matplotlib.pyplot as plt

        from course_lib.drawing.described import DescribedFigure

        with course_style():
            drawn = draw(*args, **kwargs)
        plt.close(drawn)
        given = parameters.bind(*args, **kwargs)
        given.apply_defaults()
        drawn.__class__ = DescribedFigure  # whatever made it: `panels`, or pyplot
        assert isinstance(drawn, DescribedFigure)
        drawn.description = description.format(**given.arguments)
        return drawn

    return styled


def panels(
    rows: int, columns: int, size: tuple[float, float], **options: Any
) -> tuple[Figure, Any]:
    """Return a figure of `size` inches and its axes, as `matplotlib.pyplot.subplots` does."""
    import matplotlib.pyplot as plt

    return plt.subplots(rows, columns, figsize=size, **options)


def sketch(ax: Axes, title: str = "") -> Axes:
    """Make `ax` a drawing to scale: no axes, equal units, y up."""
    ax.set_aspect("equal")
    ax.axis("off")
    ax.set_title(title)
    return ax


def stroke(ax: Axes, points: ArrayLike, role: str = "guide", **options: Any) -> None:
    """Draw a polyline through points (N, 2) in the colour of a role."""
    x, y = np.asarray(points, dtype=float).T
    ax.plot(x, y, **{"color": ROLES[role], "solid_capstyle": "round", **options})


def write(ax: Axes, at: ArrayLike, text: str, role: str | None = None, **options: Any) -> None:
    """Write `text` at a point, in ink or in the colour of a role, centred unless told otherwise."""
    x, y = np.asarray(at, dtype=float)
    colour = ROLES[role] if role else BLACK
    ax.text(x, y, text, **{"color": colour, "ha": "center", "va": "center", **options})


def dimension(ax: Axes, start: ArrayLike, end: ArrayLike, text: str, **options: Any) -> None:
    """Draw a dimension line from `start` to `end` with its label in the middle, on white."""
    a, b = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
    arrow = {"arrowstyle": "<|-|>", "color": GREY, "lw": 1.2, "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", xy=tuple(b), xytext=tuple(a), arrowprops=arrow)
    paper = {"facecolor": "white", "edgecolor": "none", "pad": 1.5}
    write(ax, (a + b) / 2, text, **{"bbox": paper, **options})


def tree(ax: Axes, foot: ArrayLike, height: float, role: str = "object") -> None:
    """Draw a small tree whose trunk starts at `foot`; a negative height turns it over."""
    x, y = np.asarray(foot, dtype=float)
    trunk, crown = 0.3 * height, abs(height)
    stroke(ax, [(x, y), (x, y + trunk)], role, lw=3, solid_capstyle="butt")
    for level, width in ((0.25, 0.26), (0.45, 0.21), (0.65, 0.15)):
        base, tip = y + level * height, y + min(level + 0.42, 1.0) * height
        corners = np.array([(x - width * crown, base), (x + width * crown, base), (x, tip)])
        ax.fill(*corners.T, color=ROLES[role], lw=0)


def hole_in_wall(ax: Axes, x: float, d: float, reach: float, thickness: float) -> None:
    """Draw a wall across the optical axis at `x`, with a hole of diameter `d` in it."""
    for side in (-1, 1):
        low, high = sorted((side * d / 2, side * reach))
        ax.fill_between([x - thickness / 2, x + thickness / 2], low, high, color=BLACK, lw=0)


def fit(ax: Axes, left: float, right: float, bottom: float, top: float) -> None:
    """Show the rectangle from left to right and bottom to top, and no more."""
    ax.set_xlim(left, right)
    ax.set_ylim(bottom, top)


def same_shape(yours: ArrayLike | None, expected: Floats) -> Floats | None:
    """Return a student's result as an array if it can be drawn where `expected` is drawn.

    Parameters
    ----------
    yours : array_like or None
        Whatever a student's function returned.
    expected : ndarray
        The result of the course's function for the same inputs.

    Returns
    -------
    ndarray or None
        The numbers; None where there are none, or of another shape.
    """
    if yours is None:
        return None
    try:
        if np.iscomplexobj(yours):
            return None
        drawable = np.asarray(yours, dtype=float)
    except (TypeError, ValueError):
        return None
    return drawable if drawable.shape == np.shape(expected) else None


def in_figures(number: float, digits: int) -> str:
    """Return a student's number with `digits` after the point; a huge one by its power of ten.

    Written out, 1e100 would be wider than any figure.
    """
    return f"{number:.{digits}f}" if abs(number) < 1e7 else f"{number:.1e}"


def picture_frame(ax: Axes, size: tuple[int, int]) -> None:
    """Turn `ax` into a picture of `size` (width, height) px, with v down."""
    width, height = size
    ax.set(xlim=(-0.5, width - 0.5), ylim=(height - 0.5, -0.5), aspect="equal")
    ax.set(xlabel="u (px)", ylabel="v (px)")
    ax.spines[["top", "right"]].set_visible(True)


def plain_numbers(ax: Axes) -> None:
    """Label logarithmic axes with plain numbers."""
    from matplotlib.ticker import NullFormatter

    for axis in (ax.xaxis, ax.yaxis):
        axis.set_major_formatter(lambda value, _: f"{value:g}")
        axis.set_minor_formatter(NullFormatter())
