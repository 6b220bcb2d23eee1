"""Still figures of the first sitting: the rig, what goes wrong, the box in the picture."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from course_lib.drawing.diagrams import figure, panels, write
from course_lib.drawing.planning.panel import (
    BOX,
    TASK,
    Floats,
    Pixels,
    close_up,
    overview,
    pair,
)
from course_lib.drawing.space import onlooker, show_face, show_frustum, show_path
from course_lib.drawing.style import FULL_WIDTH, ROLES
from course_lib.planning import Setup, box_in_view

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: The set-up of the text: distance (m), turn (rad), f-number and exposure time (s).
DISTANCE, TURN, N, TIME = 2.2, np.radians(15), 10.0, 1 / 4000


def chosen() -> Setup:
    """Return the camera on the right of the text's set-up."""
    return pair(DISTANCE, TURN, N, TIME)[0]


@figure("A panel inside a box, and two cameras that look at it from the front, turned inwards.")
def rig() -> Figure:
    """Show the panel, the box around it and the two cameras.

    Returns
    -------
    Figure
        The rig in space.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.5))
    view = onlooker((2.9, -3.6, 1.9), (0.02, -0.95, -0.02), 1150, (900, 440))
    for start, end in BOX.edges:
        show_path(ax, view, [start, end], "object", lw=1.3)
    plate = BOX.corners[[2, 3, 7, 6]]
    show_face(ax, view, plate, "object", alpha=0.15)
    for setup, name in zip(pair(DISTANCE, TURN, N, TIME), ("right", "left"), strict=True):
        show_frustum(ax, view, setup.view, 0.35, "")
        show_path(ax, view, np.array([setup.eye, np.zeros(3)]), "ray", lw=1, ls="--")
        write(ax, np.add(view.project(setup.eye), (0, 26)), f"{name} camera", "camera")
    u, v = view.project((0.3, 0, 0.25))
    write(ax, (u + 12, v - 16), "box: 600 × 60 × 500 mm", "object", ha="left")
    write(ax, view.project((0.16, 0, -0.36)), "panel, shaken up and down", ha="left")
    middle = view.project(0.5 * pair(DISTANCE, TURN, N, TIME)[0].eye)
    write(ax, np.add(middle, (14, 12)), "2.2 m", color="#8A5F00", ha="left")
    ax.set(xlim=(20, 920), ylim=(425, 45), aspect="equal")
    ax.axis("off")
    return fig


@figure("A star at the near end of the panel, as planned, out of focus, smeared, and too dark.")
def failures() -> Figure:
    """Show the same 64 pixels when one thing is wrong.

    Returns
    -------
    Figure
        Four pictures.
    """
    fig, axes = panels(1, 4, (FULL_WIDTH, 2.4))
    names = ("as planned", "f/4 instead of f/10", "1/1000 s", "1/20000 s")
    setup = chosen()
    changes: tuple[dict[str, Any], ...] = (
        {},
        {"N": 4.0},
        {"exposure_time": 1 / 1000},
        {"exposure_time": 1 / 20000},
    )
    for ax, name, change in zip(axes, names, changes, strict=True):
        ax.imshow(close_up(replace(setup, **change), 0), vmin=0, vmax=255)
        ax.set_title(name, fontsize=11)
        ax.axis("off")
    return fig


@figure("The panel in the picture, with the corners of its box and the room left on each side.")
def box_in_picture(setup: Setup | None = None) -> Figure:
    """Show the box, and the larger one that holds it wherever it moves, in the picture.

    Parameters
    ----------
    setup : Setup, optional
        The camera; that of the text on the right unless given.

    Returns
    -------
    Figure
        The picture with the eight corners.
    """
    setup = setup or chosen()
    seen = box_in_view(BOX.with_motion(TASK.motion), setup.view)
    _, picture = overview(setup, 512)
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.66, 5.0))
    _show(ax, setup, picture)
    for start, end in BOX.with_motion(TASK.motion).edges:
        ax.plot(*setup.view.project([start, end]).T, color=ROLES["ray"], lw=1.5)
    ax.plot(*seen.pixels.T, "o", color=ROLES["ray"], ms=5)
    _rooms(ax, setup, seen.margins)
    return fig


def _show(ax: Axes, setup: Setup, picture: Pixels) -> None:
    """Draw a small picture where the pixels of the whole one are."""
    width, height = setup.view.image_size
    ax.imshow(picture, extent=(-0.5, width - 0.5, height - 0.5, -0.5), interpolation="bilinear")
    ax.set(xlim=(-0.5, width - 0.5), ylim=(height - 0.5, -0.5), xlabel="u (px)", ylabel="v (px)")


def _rooms(ax: Axes, setup: Setup, margins: Floats) -> None:
    """Write the room beside each edge of the picture."""
    width, height = setup.view.image_size
    left, right, top, bottom = (f"{room:.0f} px" for room in margins)
    look: dict[str, Any] = {"color": "white", "ha": "center", "va": "center", "fontsize": 10}
    ax.text(margins[0] / 2 + 4, height / 2, left, rotation=90, **look)
    ax.text(width - margins[1] / 2 - 4, height / 2, right, rotation=90, **look)
    ax.text(width / 2, margins[2] / 2, top, **look)
    ax.text(width / 2, height - margins[3] / 2, bottom, **look)
