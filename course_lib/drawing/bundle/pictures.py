"""A reconstruction from pictures: the photographs, points followed through them, the model."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from course_lib.bundle import Observations
from course_lib.camera import Camera
from course_lib.drawing.bundle.space import pyramid
from course_lib.drawing.diagrams import Floats, figure, panels, write
from course_lib.drawing.space import onlooker, show_axes
from course_lib.drawing.style import FULL_WIDTH, ROLES
from course_lib.reconstruction import Reconstruction
from data_generators.block_pictures import SIZE, BlockPictures, turntable_pictures

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Pictures of the circle that are shown side by side, and points that are marked in all of them.
SHOWN, MARKED = (0, 1, 2), 16
#: How many pictures to each side a picture is compared with.
REACH = 2
#: Eyes of the two onlookers, and how far from the middle points are drawn, in mean distances of
#: the cameras.
HIGH, LOW, NEAR = (0.5, -2.3, 2.1), (0.5, -2.6, 1.1), 0.4


@cache
def photographs() -> BlockPictures:
    """Return 24 computed photographs of a vase on a turntable, 15 degrees apart."""
    return turntable_pictures(np.random.default_rng(1))


def neighbours(pictures: int = 24) -> list[tuple[int, int]]:
    """Return which pictures of a circle are compared: each with the next two."""
    pairs = [(i, (i + k) % pictures) for i in range(pictures) for k in range(1, REACH + 1)]
    return [(min(pair), max(pair)) for pair in pairs]


@figure("Three neighbouring pictures of a painted vase; dots of one colour are one detail.")
def followed_points(known: BlockPictures, seen: Observations) -> Figure:
    """Show three pictures, and details that were followed through them.

    Parameters
    ----------
    known : BlockPictures
        The photographs.
    seen : Observations
        Their tie points.

    Returns
    -------
    Figure
        The pictures side by side; a detail keeps its colour.
    """
    import matplotlib as mpl

    everywhere = [seen.points[seen.cameras == camera] for camera in SHOWN]
    common = sorted(set(everywhere[0]).intersection(*everywhere[1:]))
    chosen = np.array(common)[np.linspace(0, len(common) - 1, MARKED).astype(int)]
    colours = mpl.colormaps["turbo"](np.linspace(0, 1, MARKED))
    fig, axes = panels(1, len(SHOWN), (FULL_WIDTH, 2.5))
    for ax, camera in zip(axes, SHOWN, strict=True):
        ax.imshow(known.pictures[camera])
        mine = seen.only((seen.cameras == camera) & np.isin(seen.points, chosen))
        order = np.argsort(mine.points)
        ax.scatter(*mine.pixels[order].T, s=60, c=colours, edgecolors="white", linewidths=0.8)
        ax.set_title(f"picture {camera}", fontsize=10)
        ax.axis("off")
    return fig


@figure("Cameras all around a vase of thousands of coloured points, and the vase enlarged.")
def reconstructed(known: BlockPictures, model: Reconstruction) -> Figure:
    """Show a reconstruction: points in their own colours, cameras, and the frame it is in.

    Parameters
    ----------
    known : BlockPictures
        The photographs, for the colours.
    model : Reconstruction
        What was made of them.

    Returns
    -------
    Figure
        As onlookers see it, who stand upright as the cameras do; on the right enlarged.
    """
    fig, (whole, near) = panels(1, 2, (FULL_WIDTH, 3.9), width_ratios=(1.6, 1))
    block, up = model.block, upright(model)
    middle = block.points.mean(axis=0)
    size = float(np.linalg.norm(block.centres - middle, axis=1).mean())

    def at(points: Floats) -> Floats:
        return np.asarray((points - middle) @ up.T / size)

    far, close = (onlooker(eye, (0, 0, 0.1), f) for eye, f in ((HIGH, 1000), (LOW, 2400)))
    for ax, view, dot in ((whole, far, 2), (near, close, 9)):
        ax.set_aspect("equal")
        ax.axis("off")
        _show_points(ax, view, at(block.points), point_colours(known, model) / 255, dot)
    for camera in range(len(block.R)):
        outline = at(pyramid(block, camera, 0.16 * size, SIZE))
        whole.plot(*far.project(outline).T, color=ROLES["camera"], lw=0.9)
    first = at(block.centres[:1])[0]
    show_axes(whole, far, first, 0.3 * (block.R[0] @ up.T), "xyz", "object")
    u, v = far.project(first)
    write(whole, (u, v - 20), f"picture {model.cameras[0]}", "object", fontsize=10)
    whole.invert_yaxis()
    near.invert_yaxis()
    return fig


def _show_points(ax: Axes, view: Camera, places: Floats, colours: Floats, dot: float) -> None:
    """Draw the points near the middle in their colours, the nearest to the onlooker last."""
    shown = np.flatnonzero(np.linalg.norm(places, axis=1) < NEAR)
    order = shown[np.argsort(-np.linalg.norm(places[shown] - view.centre, axis=1))]
    u, v = view.project(places[order]).T
    ax.scatter(u, v, s=dot, c=colours[order], linewidths=0)


def upright(model: Reconstruction) -> Floats:
    """Return the rotation after which the cameras of a model stand upright, on the average."""
    z = -model.block.R[:, 1].mean(axis=0)
    z = z / np.linalg.norm(z)
    x = np.cross(z, model.block.R[0, 2])
    x = x / np.linalg.norm(x)
    return np.array([x, np.cross(z, x), z])


def point_colours(known: BlockPictures, model: Reconstruction) -> Floats:
    """Return the colour of the pixel where each point was first seen, (n, 3), 0 to 255."""
    seen = model.observations
    _, first = np.unique(seen.points, return_index=True)
    u, v = np.rint(seen.pixels[first]).astype(int).T
    pictures = model.cameras[seen.cameras[first]]
    stack = np.array(known.pictures)
    return np.asarray(stack[pictures, v.clip(0, SIZE[1] - 1), u.clip(0, SIZE[0] - 1)], float)
