"""Still figures in space: a block of pictures around a vase, and how a chain of them drifts."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from course_lib.bundle import Block, BundleAdjustment, bundle_adjust
from course_lib.bundle.adjustment import Gauge
from course_lib.camera import Camera
from course_lib.drawing.bundle.growing import PICTURES, WAYS, grown, true_centres, vase
from course_lib.drawing.diagrams import Floats, figure, panels, write
from course_lib.drawing.space import onlooker
from course_lib.drawing.style import FULL_WIDTH, GREY, ROLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: How much longer than true the deviations of the chain are drawn.
TIMES = 5


def pyramid(block: Block, camera: int, depth: float, size: tuple[int, int]) -> Floats:
    """Return a camera as a polyline in space: its picture at a depth, and edges to its centre.

    Parameters
    ----------
    block : Block
        The cameras.
    camera : int
        Which one.
    depth : float
        How far from its centre the picture is drawn.
    size : tuple of int
        Width and height of the picture, px.

    Returns
    -------
    ndarray, shape (10, 3)
        Corners of the polyline.
    """
    w, h = size
    corners = np.array([[0, 0, 1], [w, 0, 1], [w, h, 1], [0, h, 1.0]]) - [0.5, 0.5, 0]
    rays = depth * corners @ np.linalg.inv(block.K[camera]).T
    a, b, c, d = rays @ block.R[camera] + block.centres[camera]
    o = block.centres[camera]
    return np.array([a, b, c, d, a, o, b, c, o, d])


@figure("A vase made of points, cameras in a circle around it, and the rays of one point.")
def vase_block() -> Figure:
    """Show the block of the vase: points, cameras, and all rays of one point.

    Returns
    -------
    Figure
        As an onlooker above sees it.
    """
    known = vase()
    true, seen = known.truth, known.observations
    fig, ax = panels(1, 1, (FULL_WIDTH, 4.2))
    ax.set_aspect("equal")
    ax.axis("off")
    view = onlooker((0.5, -2.9, 1.9), (0, 0, 0.12), 900)
    chosen = int(np.argmax(np.bincount(seen.points)))
    rays = seen.cameras[seen.points == chosen]
    for camera in range(len(true.R)):
        on = camera in rays
        outline = view.project(pyramid(true, camera, 0.28, known.image_size))
        ax.plot(*outline.T, color=ROLES["camera"] if on else GREY, lw=1.6 if on else 0.8)
        if on:
            ray = view.project(np.array([true.centres[camera], true.points[chosen]]))
            ax.plot(*ray.T, color=ROLES["ray"], lw=1.2)
    ax.plot(*view.project(true.points).T, ".", color=ROLES["object"], ms=3)
    u, v = view.project(true.points[chosen])
    ax.plot(u, v, "o", mfc="white", mec=ROLES["object"], mew=2, ms=7)
    _name_cameras(ax, view, true)
    ax.invert_yaxis()
    return fig


def _name_cameras(ax: Axes, view: Camera, block: Block) -> None:
    """Write the numbers of every third camera outside of the circle."""
    for camera in range(0, len(block.R), 3):
        outside = block.centres[camera] * [1.12, 1.12, 1]
        write(ax, view.project(outside), str(camera), "camera", fontsize=10)


@figure(
    "From above: the true circle of cameras, and two chains that leave it; deviations are enlarged."
)
def chains_from_above() -> Figure:
    """Show where 25 cameras come to lie, chained only and adjusted, five times exaggerated.

    Returns
    -------
    Figure
        One panel for each way, with the gap between the first camera and the last.
    """
    fig, axes = panels(1, 2, (FULL_WIDTH, 4.3))
    for ax, way in zip(axes, WAYS, strict=True):
        stage = grown(way)[-1]
        true = true_centres(len(stage.block.R))[:, :2]
        shown = true + TIMES * (stage.block.centres[:, :2] - true)
        ax.plot(*true.T, color=GREY, lw=1, ls=(0, (5, 4)))
        ax.plot(*shown.T, "o-", color=ROLES["camera"], ms=4, lw=1)
        ax.plot(*vase().truth.points[:, :2].T, ".", color=ROLES["object"], ms=2)
        for number, place in ((0, shown[0]), (24, shown[-1])):
            ax.plot(*place, "o", color=ROLES["second"], ms=7)
            aside = (10, -10 if number else 10)
            look = {"textcoords": "offset points", "va": "center", "ha": "left"}
            ax.annotate(f"{number}", tuple(place), aside, **look)
        first, last = stage.block.centres[[0, -1]]
        gap = 1000 * float(np.linalg.norm(last - first))
        title = f"{way} (deviations × {TIMES})\nRMS {stage.after:.2f} px, gap {gap:.1f} mm"
        ax.set_title(title, fontsize=11)
        ax.set(aspect="equal", xlabel="x (m)", ylabel="y (m)", xlim=(-1.5, 1.5), ylim=(-1.4, 1.4))
    return fig


@figure("How well each camera is known: with the first one held, and with all of them free.")
def two_gauges() -> Figure:
    """Show the standard deviations of the cameras of the vase in two gauges.

    Returns
    -------
    Figure
        Against the number of the camera.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.8, 2.9))
    gauges: tuple[tuple[Gauge, str, str, float], ...] = (
        ("fixed", "object", "first camera held", 0.25),
        ("inner", "camera", "inner", -0.25),
    )
    for gauge, role, name, up in gauges:
        sigma = 1000 * centre_sigma(gauge)
        ax.plot(range(PICTURES), sigma, "o-", color=ROLES[role], ms=4)
        write(ax, (12, sigma[12] + up), name, role)
    ax.set(xlabel="camera (number)", ylabel="its centre, ± (mm)", xticks=range(0, PICTURES, 3))
    ax.set_ylim(0, 2.3)
    return fig


@cache
def adjusted_vase(gauge: Gauge) -> BundleAdjustment:
    """Return the adjusted block of the vase, all points recognised, in a gauge."""
    known = vase()
    return bundle_adjust(known.truth, known.observations, gauge=gauge)


def centre_sigma(gauge: Gauge) -> Floats:
    """Return the standard deviation of each camera's centre in space, (24,), m."""
    sigma = adjusted_vase(gauge).precision.centre_sigma
    return np.asarray(np.sqrt((sigma**2).sum(axis=1)))
