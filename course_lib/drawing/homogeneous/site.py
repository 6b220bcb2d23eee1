"""The site of chapter 02: the red house, the cameras around it, and the street from above."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera import Camera, camera_at
from course_lib.drawing.diagrams import Floats, figure, panels, picture_frame, same_shape, write
from course_lib.drawing.explorers.street import renderer
from course_lib.drawing.style import BLACK, FULL_WIDTH, GREY, LIGHT, ROLES
from course_lib.transforms import rotation_z

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SIZE = (720, 480)
#: Both cameras of the site: a lens of 35 mm on 36 mm × 24 mm, px.
K = np.array([[700.0, 0, 359.5], [0, 700, 239.5], [0, 0, 1]])
#: The second camera as a graphics program writes it: x right, y up, z backwards.
FROM_BLENDER = np.array(
    [
        [0.6, -0.224, 0.768, 4.92],
        [0.8, 0.168, -0.576, 12.36],
        [0.0, 0.96, 0.28, 7.10],
        [0.0, 0.0, 0.0, 1.0],
    ]
)
#: The corners of the red house's walls, m: its front (south, north; bottom, top), then its back.
HOUSE = np.array(
    [(x, y, z) for x in (-6.6, -14.1) for y, z in ((16.5, 0), (25.5, 0), (25.5, 5.4), (16.5, 5.4))]
)
#: m: a camera farther away than that is no camera of this street.
FARTHEST = 1e9
#: Mean step of green between neighbours in a row: below it there is only sky or meadow.
PLAIN = 0.1
HOUSE_EDGES = [(i, (i + 1) % 4) for i in range(4)]
HOUSE_EDGES += [(i + 4, j + 4) for i, j in HOUSE_EDGES] + [(i, i + 4) for i in range(4)]
#: The northern end of the front's eaves, m: the tip of a roof that reaches 0.35 m over the walls.
CORNER = np.array([-6.25, 25.85, 5.106])


def first_camera() -> Camera:
    """Return the camera of chapter 01, across the street, level, 12 m from the red house."""
    return camera_at((5.4, 21, 2.9), (-6.6, 21, 2.9), K, SIZE)


def cameras() -> list[Camera]:
    """Return three cameras that stand around the red house and look at its front."""
    eyes = ((5.4, 21.0, 2.9), (4.92, 12.36, 7.1), (4.2, 31.0, 1.7))
    return [camera_at(eye, (-6.6, 21, 2.9), K, SIZE) for eye in eyes]


def corner_camera() -> Camera:
    """Return a wide camera above the road that sees all three directions of the world run away."""
    wide = np.array([[400.0, 0, 359.5], [0, 400, 239.5], [0, 0, 1]])
    return camera_at((-2.6, -4.2, 3.4), (0.6, -0.4, 1.0), wide, SIZE)


def photograph(camera: Camera) -> NDArray[np.uint8]:
    """Return what a camera sees of the street."""
    return renderer().picture(camera)


def say_where_lost(
    ax: Axes, points: Floats, at: tuple[float, float] = (0.5, 0.06), page: str = "picture"
) -> None:
    """Say so where none of a student's points is in the picture, or some are not on the map."""
    (left, right), (bottom, top) = sorted(ax.get_xlim()), sorted(ax.get_ylim())
    seen = ((points >= (left, bottom)) & (points <= (right, top))).all(axis=1)
    if seen.all() or (seen.any() and page == "picture"):  # a picture need not show everything
        return
    words = f"your points are outside of the {page}"
    if seen.any():
        words = f"outside of the {page}: {(~seen).sum()} of your {len(points)} points"
    elif np.isnan(points).any(axis=1).all():
        words = "your points are all nan"
    say(ax, at, words, fontweight="bold")


def say(ax: Axes, at: tuple[float, float], words: str, **look: Any) -> None:
    """Write on white paper, at a place given in parts of the axes' width and height."""
    paper = {"facecolor": "white", "edgecolor": "none", "alpha": 0.9, "pad": 2}
    ax.text(*at, words, transform=ax.transAxes, bbox=paper, ha="center", color=BLACK, **look)


def usable_pose(pose: object) -> tuple[Floats, Floats] | None:
    """Return a student's pose if a picture can be taken with it, and None otherwise."""
    if not isinstance(pose, (tuple, list)) or len(pose) != 2:
        return None
    R, t = same_shape(pose[0], np.eye(3)), same_shape(pose[1], np.zeros(3))
    if R is None or t is None or not np.isfinite(R).all() or not (np.abs(t) < FARTHEST).all():
        return None
    proper = np.abs(R @ R.T - np.eye(3)).max() < 1e-6 and np.linalg.det(R) > 0
    return (R, t) if proper else None


def _what_is_wrong(pose: object) -> str:
    """Say why no picture can be taken with what a student's function gave."""
    if not isinstance(pose, (tuple, list)) or len(pose) != 2:
        return "not a pose (R and t)"
    R, t = same_shape(pose[0], np.eye(3)), same_shape(pose[1], np.zeros(3))
    if R is None or t is None:
        return "not a pose (R is 3 × 3, t has 3 numbers)"
    if np.isnan(R).any() or np.isnan(t).any():
        return "not a pose (nan)"
    far = not (np.abs(t) < FARTHEST).all()
    return "not a pose (t is far too long)" if far else "not a pose (R must be a rotation)"


@figure(
    "What a camera sees of the street with the pose that was given; without one, an empty frame."
)
def taken_from(pose: object, title: str = "") -> Figure:
    """Show the street through the second camera's lens, from a pose of a student's function.

    Parameters
    ----------
    pose : tuple of array_like, shape (3, 3) and (3,), or None
        World to camera.
    title : str
        Stands above the picture.

    Returns
    -------
    Figure
        The photograph; an empty frame where the pose is none.
    """
    fig, ax = panels(1, 1, (6.4, 4.5))
    show_view(ax, pose)
    ax.set_title(title)
    return fig


def show_view(ax: Axes, pose: object) -> Camera | None:
    """Show what the second camera sees from a pose, or that there is no pose."""
    picture_frame(ax, SIZE)
    usable = usable_pose(pose)
    if usable is None:
        words = "no pose yet" if pose is None else _what_is_wrong(pose)
        write(ax, (SIZE[0] / 2, SIZE[1] / 2), words.replace(" (", "\n("), "guide")
        return None
    camera = Camera(K, *usable, SIZE)
    picture = photograph(camera)
    ax.imshow(picture, extent=(-0.5, SIZE[0] - 0.5, SIZE[1] - 0.5, -0.5))
    if np.abs(np.diff(picture[:, :, 1].astype(float), axis=1)).mean() < PLAIN:
        place = "({:.1f}, {:.1f}, {:.1f}) m".format(*camera.centre + 0.0)
        say(ax, (0.5, 0.1), f"hardly a house in sight from\n{place}", fontsize=9)
    return camera


@figure("What a camera sees of the street when its file is read in different ways: {titles}.")
def imports(poses: Sequence[object], titles: Sequence[str]) -> Figure:
    """Show what a camera sees when its matrix is read in different ways.

    Parameters
    ----------
    poses : sequence of (R, t)
        World to camera, as each way of reading has it.
    titles : sequence of str
        One for each.

    Returns
    -------
    Figure
        A photograph for each.
    """
    height = 0.5 + FULL_WIDTH / len(poses) * SIZE[1] / SIZE[0]
    fig, axes = panels(1, len(poses), (FULL_WIDTH, height), squeeze=False)
    for ax, pose, title in zip(axes[0], poses, titles, strict=True):
        show_view(ax, pose)
        ax.set(xticks=[], yticks=[], xlabel="", ylabel="")
        ax.set_title(title, fontsize=10, fontweight="normal")
    return fig


@figure("A map of the street with houses, cameras and what they see; stars mark your results.")
def street_map(
    cameras: Sequence[Camera],
    centres: ArrayLike | None = None,
    point: ArrayLike | None = None,
    names: Sequence[str] = ("1", "2", "3"),
) -> Figure:
    """Show cameras on a map, and where a student's functions put things.

    Parameters
    ----------
    cameras : sequence of Camera
        Where they are and what they see is drawn.
    centres : sequence of array_like, shape (3,), or None, optional
        Centres that a student's function gave; stars.
    point : array_like, shape (3,), optional
        A point that a student's function gave; a star.
    names : sequence of str
        What the cameras are called.

    Returns
    -------
    Figure
        The street from above; north (y) is up.
    """
    fig, ax = panels(1, 1, (6.4, 5.4))
    _ground(ax)
    for name, camera in zip(names, cameras, strict=False):
        _fan(ax, camera)
        ax.plot(*camera.centre[:2], "o", mfc="none", mec=ROLES["camera"], ms=12, mew=2)
        paper = {"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 1}
        write(ax, camera.centre[:2] + np.array([1.4, 0]), name, "camera", bbox=paper)
    ax.plot(*CORNER[:2], "s", mfc="none", mec=BLACK, ms=9, ls="", label="corner of the eaves")
    stars = [same_shape(c, np.zeros(3)) for c in _rows(centres)] + [same_shape(point, np.zeros(3))]
    there = np.array([s[:2] for s in stars if s is not None])
    if len(there):
        ax.plot(
            *there.T, "*", color=ROLES["second"], mec=BLACK, mew=0.5, ms=13, ls="", label="yours"
        )
    ax.legend(loc="center left", bbox_to_anchor=(1.02, 0.5), frameon=False)
    ax.set(
        xlabel="x, east (m)", ylabel="y, north (m)", xlim=(-16, 12), ylim=(3, 36), aspect="equal"
    )
    if len(there):
        say_where_lost(ax, there, at=(0.5, 0.95), page="map")
    return fig


def _rows(centres: ArrayLike | None) -> list[Any]:
    return [] if centres is None else list(np.atleast_1d(np.asarray(centres, dtype=object)))


def _ground(ax: Axes) -> None:
    """Draw the road and the houses beside it."""
    from data_generators.places import HOUSES, KERB

    ax.axvspan(-KERB, KERB, color=LIGHT, lw=0)
    for side, start, length, depth, *_ in HOUSES:
        near, far = side * 6.6, side * (6.6 + depth)
        ax.fill(
            [near, far, far, near], np.repeat([start, start + length], 2), color=GREY, alpha=0.35
        )
    ax.plot([-6.6, -6.6], [16.5, 25.5], color=ROLES["object"], lw=4, label="front of the red house")


def _fan(ax: Axes, camera: Camera) -> None:
    """Draw what a camera sees at the height of its axis, 12 m far."""
    heading = np.arctan2(camera.R[2, 1], camera.R[2, 0])
    half = np.arctan(camera.image_size[0] / 2 / camera.K[0, 0])
    left, right = (12 * rotation_z(heading + turn)[:2, 0] for turn in (half, -half))
    corners = camera.centre[:2] + np.array([left, 0 * left, right])
    ax.fill(*corners.T, color=ROLES["camera"], alpha=0.12, lw=0)
    ax.plot(*corners.T, color=ROLES["camera"], lw=1)
