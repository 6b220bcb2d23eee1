"""Still figures made with the synthetic camera, in the street of `data_generators.places`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera import (
    Camera,
    camera_at,
    dolly_zoom,
    first_guess_intrinsics,
    vanishing_point,
)
from course_lib.drawing.diagrams import Floats, figure, panels, picture_frame, same_shape, write
from course_lib.drawing.explorers.street import renderer
from course_lib.drawing.style import BLACK, BLUE, FULL_WIDTH, ORANGE, ROLES, on_screen

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

FULL_FRAME = (36.0, 24.0)
#: The front of the red house: its wall is at x, from y to y, this high, m.
FRONT_X, FRONT_Y, FRONT_HEIGHT = -6.6, (16.5, 25.5), 5.4
#: Kerbs and eaves along the road: x, z, and the y from which they are drawn, m.
ROAD_LINES = ((-3.2, 0.0, 0.5), (3.2, 0.0, 0.5), (-6.6, 5.6, 5.0), (6.6, 5.5, 7.5))
CHART = np.array([1.5, 5.2, 1.3])  # m: what the series and the dolly zoom look at


def _photograph(camera: Camera) -> NDArray[np.uint8]:
    return renderer().picture(camera)


def _shown(light: ArrayLike) -> Floats:
    """Return a picture for Matplotlib from light on a scale to 255; too much light is white."""
    return np.clip(np.asarray(light, dtype=float) / 255, 0, 1)


@figure(
    "A street with a red house, from {Z:g} m through a lens of {f:g} mm; an orange line marks "
    "the 9 m of its front."
)
def facade(
    f: float = 16.0,
    Z: float = 12.0,
    sensor_size: tuple[float, float] = (27.6, 25.9),
    image_size: tuple[int, int] = (2048, 1920),
) -> Figure:
    """Show the red house as a camera across the street sees it.

    Parameters
    ----------
    f, Z : float
        Focal length in mm and distance from the wall in m.
    sensor_size, image_size : tuple
        Width and height of the sensor in mm and of the picture in px.

    Returns
    -------
    Figure
        The photograph, with the width of the house marked.
    """
    shown = (640, round(640 * image_size[1] / image_size[0]))
    middle = np.array([FRONT_X, sum(FRONT_Y) / 2, 2.9])
    eye, K = middle + np.array([Z, 0, 0]), first_guess_intrinsics(f, sensor_size, shown)
    camera = camera_at(eye, middle, K, shown)
    corners = [(FRONT_X, y, FRONT_HEIGHT * 0.62) for y in FRONT_Y]
    ends = (camera.project(corners) + 0.5) * image_size[0] / shown[0] - 0.5
    fig, ax = panels(1, 1, (6.4, 5.6))
    width, height = image_size
    longer = 1.25  # the front lies in the shade
    shade = _shown(longer * _photograph(camera))
    ax.imshow(shade, extent=(-0.5, width - 0.5, height - 0.5, -0.5))
    picture_frame(ax, image_size)
    ax.plot(*ends.T, color=ORANGE, lw=3, marker="|", ms=16, mew=3)
    paper = {"facecolor": "white", "edgecolor": "none", "alpha": 0.9}
    write(ax, ends.mean(axis=0), f"{FRONT_Y[1] - FRONT_Y[0]:g} m", bbox=paper)
    ax.set_title(f"f = {f:g} mm, Z = {Z:g} m")
    return fig


def street_view(turn_deg: float, tilt_deg: float = 0.0, f: float = 24.0) -> Camera:
    """Return a camera on the road, 1.65 m above it, turned to the right and tilted up.

    Parameters
    ----------
    turn_deg, tilt_deg : float
        Angles from the direction of the road, degrees.
    f : float
        Focal length on a sensor of 36 mm × 24 mm, mm.

    Returns
    -------
    Camera
        For pictures of 720 px × 480 px.
    """
    turn, tilt = np.radians([turn_deg, tilt_deg])
    forward = np.array([np.sin(turn) * np.cos(tilt), np.cos(turn) * np.cos(tilt), np.sin(tilt)])
    eye, size = np.array([0.5, -3.5, 1.65]), (720, 480)
    return camera_at(eye, eye + forward, first_guess_intrinsics(f, FULL_FRAME, size), size)


def road_direction(camera: Camera) -> Floats:
    """Return the direction of the road in the camera frame, shape (3,), a unit vector."""
    return np.asarray(camera.R @ (0.0, 1.0, 0.0))


@figure(
    "A street: its kerbs and eaves, made longer, meet in one point, which lies on the dashed "
    "horizon."
)
def street_lines(camera: Camera, yours: ArrayLike | None = None) -> Figure:
    """Show lines along a road running to their vanishing point on the horizon.

    Parameters
    ----------
    camera : Camera
        From `street_view`.
    yours : array_like, shape (2,), optional
        The vanishing point that a student's function gave, px.

    Returns
    -------
    Figure
        The photograph with kerbs and eaves made longer, and the horizon.
    """
    f, c = np.diag(camera.K)[:2], camera.K[:2, 2]
    meeting = vanishing_point(road_direction(camera), f, c)
    fig, ax = panels(1, 1, (FULL_WIDTH, 5.6))
    ax.imshow(_photograph(camera))
    picture_frame(ax, camera.image_size)
    ax.set_autoscale_on(False)
    for x, z, y in ROAD_LINES:
        near = camera.project((x, y, z))
        ax.plot(*np.array([near, meeting]).T, color=ORANGE, lw=2)
    across = vanishing_point(camera.R @ (1.0, 1.0, 0.0), f, c)  # another level direction
    ax.axline(meeting, across, color=BLUE, lw=2, ls=(0, (8, 4)), label="horizon")
    ax.plot(*meeting, "o", mfc="none", mec=BLACK, ms=13, mew=2, ls="", label="vanishing point")
    drawn = same_shape(yours, meeting)
    if drawn is not None:
        label = f"your function{_whereabouts(drawn, camera.image_size)}"
        ax.plot(*drawn, "*", color=ROLES["second"], ms=13, ls="", label=label)
    ax.legend(loc="upper left", frameon=True, framealpha=0.9, handlelength=3)
    return fig


def _whereabouts(pixel: Floats, size: tuple[int, int]) -> str:
    """Say why a pixel is not seen in a picture of `size`, or nothing where it is."""
    if not np.isfinite(pixel).all():
        return ": no point (nan or inf)"
    inside = ((pixel >= 0) & (pixel <= np.subtract(size, 1))).all()
    return "" if inside else ": outside of the picture"


@figure(
    "A letter chart from several distances. First row, one lens: it becomes smaller. Second "
    "row: the focal lengths of your function, once it answers."
)
def dolly_strip(
    f: float = 24.0, Z: Sequence[float] = (3.0, 6.0, 12.0), yours: ArrayLike | None = None
) -> Figure:
    """Show one object from several distances: through one lens, and with the zoom following.

    Parameters
    ----------
    f : float
        Focal length for the first distance, mm, on a sensor of 36 mm × 24 mm.
    Z : sequence of float
        Distances, m.
    yours : array_like, shape (N,), optional
        Focal lengths in mm that a student's function gave; used in the second row.

    Returns
    -------
    Figure
        Two rows of photographs.
    """
    zoomed = dolly_zoom(f, Z[0], Z)
    drawn = same_shape(yours, zoomed)
    usable = drawn is not None and bool(((drawn > 1) & (drawn < 1e6)).all())  # mm; not NaN
    second = drawn if usable and drawn is not None else [None] * len(Z)
    fig, axes = panels(2, len(Z), (FULL_WIDTH, 4.2))
    for row, lengths in zip(axes, ([f] * len(Z), second), strict=True):
        for ax, distance, length in zip(row, Z, lengths, strict=True):
            _chart_from(ax, float(distance), length)
    axes[0, 0].set_ylabel("one lens")
    axes[1, 0].set_ylabel("your lenses")
    return fig


def _chart_from(ax: Axes, Z: float, f: float | None) -> None:
    """Show the letter chart from a distance of `Z` m through a lens of `f` mm, if there is one."""
    size = (480, 320)
    if f is None:
        picture_frame(ax, size)
        ax.set(xticks=[], yticks=[], xlabel="", ylabel="")
        ax.set_title(f"Z = {Z:g} m, f = ?", fontsize=10, fontweight="normal")
        write(ax, (size[0] / 2, size[1] / 2), "your focal length", "guide")
        return
    K = first_guess_intrinsics(f, FULL_FRAME, size)
    ax.imshow(_photograph(camera_at(CHART - np.array([0, Z, 0]), CHART, K, size)))
    ax.set(xticks=[], yticks=[])
    ax.set_title(f"Z = {Z:g} m, f = {f:.0f} mm", fontsize=10, fontweight="normal")


@figure(
    "Photographs of a letter chart through holes of {diameters} mm, {image_distance:g} mm in "
    "front of the sensor."
)
def hole_series(
    diameters: Sequence[float] = (2, 1, 0.6, 0.35, 0.15, 0.07),
    image_distance: float = 100.0,
    wavelength: float = 0.00055,
    Z: float = 5.2,
    same_exposure: bool = False,
) -> Figure:
    """Show the letter chart in the street, photographed through holes of several sizes.

    Parameters
    ----------
    diameters : sequence of float
        Of the holes, mm.
    image_distance, wavelength : float
        Distance from hole to sensor (36 mm × 24 mm), and wavelength of the light, mm.
    Z : float
        Distance from hole to chart, m.
    same_exposure : bool
        Whether all are exposed as long as the first one; if not, all are equally bright.

    Returns
    -------
    Figure
        A photograph for each hole.
    """
    from data_generators.hole import Hole, Spread, with_margin

    size = (420, 280)
    K = first_guess_intrinsics(image_distance, FULL_FRAME, size)
    camera, margin = with_margin(camera_at(CHART - np.array([0, Z, 0]), CHART, K, size), least=70)
    spread = Spread(_photograph(camera), margin, FULL_FRAME[0] / size[0] * np.ones(2), Z)
    rows = -(-len(diameters) // 3)
    fig, axes = panels(rows, 3, (FULL_WIDTH, 2.05 * rows), squeeze=False)
    for ax in axes.flat:
        ax.axis("off")
    for ax, d in zip(axes.flat, diameters, strict=False):
        grey = on_screen((d / diameters[0]) ** 2) if same_exposure else 1.0
        ax.imshow(_shown(grey * spread.through(Hole(d, image_distance, wavelength))))
        ax.set_title(f"d = {d:g} mm")
    if same_exposure:
        fig.suptitle("Equal exposures, as a screen shows them", fontsize=11)
    return fig
