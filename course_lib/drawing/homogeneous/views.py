"""Still figures in the street: projected edges, the columns of P, a panorama, and one ray."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.camera import Camera
from course_lib.drawing.diagrams import Floats, figure, panels, picture_frame, same_shape, write
from course_lib.drawing.homogeneous.site import (
    FARTHEST,
    HOUSE,
    HOUSE_EDGES,
    SIZE,
    K,
    photograph,
    say,
    say_where_lost,
    show_view,
)
from course_lib.drawing.style import BLACK, FULL_WIDTH, ROLES
from course_lib.transforms import gimbal_pose

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PAPER = {"facecolor": "white", "edgecolor": "none", "alpha": 0.9, "pad": 1.5}


@figure("The red house in a photograph, and its edges drawn over it from their coordinates.")
def wire(camera: Camera, yours: ArrayLike | None = None) -> Figure:
    """Show the walls of the red house over their photograph.

    Parameters
    ----------
    camera : Camera
        Takes the photograph.
    yours : array_like, shape (8, 2), optional
        Pixels that a student's function gave for the corners `HOUSE`.

    Returns
    -------
    Figure
        Open circles: the corners by the course's function. Lines: the student's.
    """
    expected = camera.project(HOUSE)
    fig, ax = panels(1, 1, (FULL_WIDTH, 5.6))
    ax.imshow(photograph(camera))
    picture_frame(ax, camera.image_size)
    ax.set_autoscale_on(False)
    circle = {"color": BLACK, "ms": 12, "mew": 1.5, "ls": "", "clip_on": True}
    ax.plot(*expected.T, "o", mfc="none", label="the course's function", **circle)
    drawn = same_shape(yours, expected)
    if drawn is not None:
        for start, end in HOUSE_EDGES:
            front = start < 4 and end < 4
            look = {"lw": 2.5} if front else {"lw": 1.2, "ls": (0, (4, 3))}
            ax.plot(*drawn[[start, end]].T, color=ROLES["second"], **look)
        ax.plot([], [], color=ROLES["second"], lw=2.5, label="your function")
        say_where_lost(ax, drawn, at=(0.5, 0.94))
    ax.legend(loc="lower right", frameon=True, framealpha=0.9)
    return fig


@figure(
    "A photograph with the images of the world's axes. The columns of the camera matrix are the "
    "vanishing points of the axes and the image of the world's origin; arrows lead to those that "
    "are beside the page."
)
def columns_of(P: ArrayLike | None, camera: Camera) -> Figure:
    """Show what the columns of a camera matrix mean, in the photograph of the camera.

    Parameters
    ----------
    P : array_like, shape (3, 4), or None
        A camera matrix, the course's or a student's; nothing is drawn for None.
    camera : Camera
        Takes the photograph.

    Returns
    -------
    Figure
        Lines from the image of the origin to the vanishing point of each axis.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 4.7))
    w, h = camera.image_size
    ax.imshow(photograph(camera), extent=(-0.5, w - 0.5, h - 0.5, -0.5))
    picture_frame(ax, camera.image_size)
    ax.set(xlim=(-120, w + 270), ylim=(h + 90, -30))
    drawn = same_shape(P, np.zeros((3, 4)))
    if drawn is None or not (np.abs(drawn) < FARTHEST).all():
        write(ax, (w / 2, h + 50), "no camera matrix yet", "guide")
        return fig
    far = np.abs(drawn[2]) < 1e-9 * np.abs(drawn).max(axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        columns = np.where(far, np.nan, drawn[:2] / drawn[2]).T
    _mark_columns(ax, columns)
    return fig


_COLUMNS = (
    ("$p_1$: X at infinity", "camera"),
    ("$p_2$: Y at infinity", "image"),
    ("$p_3$: Z at infinity", "object"),
    ("$p_4$: origin", "second"),
)


def _mark_columns(ax: Axes, columns: Floats) -> None:
    """Mark what the columns are the images of, or say where it is."""
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    low, high = np.array([left, top]), np.array([right, bottom])
    inside = np.all((columns > low) & (columns < high), axis=1).tolist()
    start, beside = columns[3], []
    for place, (name, role), there in zip(columns, _COLUMNS, inside, strict=True):
        if np.isfinite([start, place]).all():
            ax.plot(*np.array([start, place]).T, color=ROLES[role], lw=1.5, clip_on=True)
        if there:
            ax.plot(*place, "o", color=ROLES[role], mec="white", ms=10, zorder=3)
            write(ax, place + np.array([0, 34]), name, bbox=PAPER, fontsize=10)
            continue
        where = (
            "at ({:.0f}, {:.0f})".format(*place) if np.isfinite(place).all() else "nowhere (w is 0)"
        )
        if inside[3] and np.isfinite(place).all():
            _lead_out(ax, start, place, (low, high), f"{name},\n{where}")
        else:
            beside.append(f"{name}, {where}")
    if beside:
        say(ax, (0.5, 0.03), "not on this page: " + "; ".join(beside), fontsize=9)


def _lead_out(
    ax: Axes, start: Floats, place: Floats, page: tuple[Floats, Floats], words: str
) -> None:
    """End the way to a place beside the page in an arrow, and say where it leads."""
    way = place - start
    with np.errstate(divide="ignore"):
        share = np.where(way > 0, page[1] - start, page[0] - start) / way
    tip = start + 0.97 * np.nanmin(share) * way
    look = {"arrowstyle": "-|>", "color": BLACK, "lw": 1.5, "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", xy=tuple(tip), xytext=tuple(start + 0.8 * (tip - start)), arrowprops=look)
    at = np.clip(tip, page[0] + (140, 30), page[1] - (230, 40)) + np.array([16, 0])
    write(ax, at, words, bbox=PAPER, fontsize=10, ha="left")


#: Corners of the walls along the street, m: the front of each house that a sweep comes by.
FRONTS = np.array(
    [
        (x, y, z)
        for x, start, end, top in (
            (-6.6, 16.5, 25.5, 5.4),
            (-6.6, 29, 37, 8.2),
            (6.6, 20.5, 28.5, 8.2),
        )
        for y in (start, end)
        for z in (0.0, top)
    ]
)


@figure(
    "Pictures from a camera on a gimbal, one for each pan angle, side by side. Circles mark where "
    "corners of the houses ought to be, stars where they are."
)
def sweep(poses: Sequence[object], cases: Sequence[tuple[float, float, Floats, Floats]]) -> Figure:
    """Show what a camera on a gimbal sees on its way round.

    Parameters
    ----------
    poses : sequence of (R, t) or None
        World to camera, from a student's function.
    cases : sequence of tuple
        Pan and tilt, rad, mount and offset, m: what each pose belongs to.

    Returns
    -------
    Figure
        A photograph for each. Circles: corners of houses by the course's function; stars: the same
        corners by the student's.
    """
    fig, axes = panels(1, len(poses), (FULL_WIDTH, 0.4 + 5.4 / len(poses)), squeeze=False)
    for ax, pose, case in zip(axes[0], poses, cases, strict=True):
        camera = show_view(ax, pose)
        if camera is not None:
            ax.set_autoscale_on(False)
            corners = Camera(K, *gimbal_pose(*case), SIZE).project(FRONTS)
            ax.plot(*corners.T, "o", mfc="none", mec=BLACK, ms=11, mew=2)
            ax.plot(*camera.project(FRONTS).T, "*", color=ROLES["second"], mec="white", ms=9)
        ax.set(xticks=[], yticks=[], xlabel="", ylabel="")
        ax.set_title(f"pan {np.degrees(case[0]):.0f}°", fontsize=10, fontweight="normal")
    return fig


@figure(
    "Left: one pixel of the first camera's picture. Right: what that pixel sees at several "
    "distances, in the second camera's picture: points on a line."
)
def one_ray(
    pixel: ArrayLike,
    first: Camera,
    second: Camera,
    yours: ArrayLike | None = None,
    distances: Sequence[float] = (6.0, 8.0, 11.0, 16.0),
) -> Figure:
    """Show a pixel of one camera, and its ray as another camera sees it.

    Parameters
    ----------
    pixel : array_like, shape (2,)
        In the first picture, px.
    first, second : Camera
        The cameras.
    yours : array_like, shape (2, 3), optional
        Start and direction of the ray that a student's function gave.
    distances : sequence of float
        Along the ray, m.

    Returns
    -------
    Figure
        Both photographs; stars at the distances along the student's ray.
    """
    fig, axes = panels(1, 2, (FULL_WIDTH, 3.1))
    for ax, camera, title in zip(axes, (first, second), ("camera 1", "camera 2"), strict=True):
        ax.imshow(photograph(camera))
        picture_frame(ax, camera.image_size)
        ax.set_autoscale_on(False)
        ax.set_title(title)
    look = {"mfc": "none", "mec": ROLES["object"], "ms": 12, "mew": 2.5}
    axes[0].plot(*np.asarray(pixel, dtype=float), "o", **look)
    steps = np.array(distances)[:, None]
    truth = second.project(first.centre + steps * first.pixel_ray(pixel))
    axes[1].plot(*truth.T, "o", color=BLACK, mfc="none", ms=11)
    ray = same_shape(yours, np.zeros((2, 3)))
    if ray is not None and (np.abs(ray) < FARTHEST).all():
        stars = second.project(ray[0] + steps * ray[1])
        axes[1].plot(*stars.T, "*-", color=ROLES["second"], ms=10)
        say_where_lost(axes[1], stars)
    for (u, v), distance in zip(truth, distances, strict=True):
        write(axes[1], (u - 16, v + 34), f"{distance:g} m", fontsize=9, bbox=PAPER, ha="right")
    return fig
