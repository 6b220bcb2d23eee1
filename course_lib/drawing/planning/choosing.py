"""Still figures of the first sitting: where the demands leave room, and set-ups compared."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from course_lib.drawing.diagrams import figure, panels, write
from course_lib.drawing.planning.panel import BOX, PHANTOM, TASK, ZEISS, pair, stand
from course_lib.drawing.style import FULL_WIDTH, GREY, ROLES
from course_lib.planning import (
    Setup,
    Verdict,
    aperture_window,
    depth_range,
    judge_setup,
    read_cameras,
    read_lenses,
)
from course_lib.planning.setup import expected_sigma, motion_blur, resolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Set-ups that are compared: camera, lens, distance (m), turn (°), f-number, 1 / exposure time.
COMPARED = (
    (PHANTOM, ZEISS, 2.2, 15, 10, 4000),
    (PHANTOM, ZEISS, 2.2, 30, 10, 4000),
    (PHANTOM, "Nikkor AF-S 50 mm f/1.8G", 1.4, 15, 10, 4000),
    ("Nikon D850", "Micro-Nikkor AF 60 mm f/2.8D", 1.6, 15, 8, 4000),
    ("mvBlueFOX3-2051", "Computar M2514-MP2", 2.1, 15, 3.5, 4000),
)


def compared() -> list[tuple[Setup, list[Verdict]]]:
    """Return the set-ups that the text compares, each with its verdicts as one of a pair."""
    cameras, lenses, found = read_cameras(), read_lenses(), []
    for camera, lens, distance, turn, N, rate in COMPARED:
        one, other = (
            stand(cameras[camera], lenses[lens], distance, side * np.radians(turn), N, 1 / rate)
            for side in (1, -1)
        )
        found.append((one, judge_setup(one, TASK, other)))
    return found


@figure("A table of set-ups and demands: which are met, and which fail by how much.")
def verdicts() -> Figure:
    """Show the verdicts on several set-ups.

    Returns
    -------
    Figure
        A column for each set-up, a row for each demand.
    """
    rows = compared()
    names = [verdict.name for verdict in rows[0][1]]
    fig, ax = panels(1, 1, (FULL_WIDTH, 4.3))
    ax.axis("off")
    ax.set(xlim=(-1.35, len(rows) - 0.45), ylim=(len(names) - 0.5, -2.1))
    for row, name in enumerate(names):
        write(ax, (-1.3, row), name, ha="left", fontsize=10)
    for column, (setup, found) in enumerate(rows):
        _heading(ax, column, setup, COMPARED[column])
        for row, verdict in enumerate(found):
            _cell(ax, (column, row), verdict)
    return fig


def _heading(ax: Axes, column: int, setup: Setup, choice: tuple[object, ...]) -> None:
    camera = setup.camera.name.partition(",")[0]
    _, _, distance, turn, N, rate = choice
    first = camera.split()[-1].removeprefix("mvBlueFOX3-")
    lens = f"{first}, {setup.lens.f_mm:g} mm"
    text = f"{lens}\n{distance:g} m, ± {turn}°\nf/{N:g}, 1/{rate} s"
    write(ax, (column, -1.35), text, fontsize=9, fontweight="bold", linespacing=1.35)


def _cell(ax: Axes, at: tuple[int, int], verdict: Verdict) -> None:
    """Write a value in a field that is green if the demand is met, else red with a cross."""
    from matplotlib.patches import Rectangle

    column, row = at
    role = "image" if verdict.met else "object"
    field = Rectangle((column - 0.46, row - 0.42), 0.92, 0.84, fc=ROLES[role], ec="none", alpha=0.2)
    ax.add_patch(field)
    sign = "✓" if verdict.met else "✗"
    write(ax, at, f"{sign} {shown(verdict.value)} {verdict.unit}", fontsize=9)


def shown(value: float) -> str:
    """Return a value as tables show it: three digits, and none after the point from 100 on."""
    return f"{value:.0f}" if abs(value) >= 99.5 else f"{value:.3g}"


def limits(turn: float, distance: float = 2.2) -> tuple[float, float, float, float, float]:
    """Return what the demands leave of the f-numbers when the cameras are turned.

    Parameters
    ----------
    turn : float
        Of each camera, rad.
    distance : float
        m.

    Returns
    -------
    least, diffraction, light, sigma, pixel : float
        Smallest f-number for the depth of field; largest ones for diffraction, and for the light
        with the longest exposure that does not smear; the standard deviation in space, m; and what
        a pixel covers on the panel, m.
    """
    one, other = pair(distance, turn, 8, 1e-4)
    near, far = depth_range(BOX, one.view)
    window = aperture_window(one.lens.f_mm, near, far, TASK.blur_px * one.camera.pitch_um)
    longest = 1e-4 * TASK.blur_px / motion_blur(one, TASK).value
    light = float(np.sqrt(longest / TASK.exposure_at_f1))
    sigma = expected_sigma(one, other, TASK).value / 1000
    coarsest = resolution(one, TASK).value / 1000
    return window.least, window.most, light, sigma, coarsest


@figure("The f-numbers that the demands leave, against how far the two cameras are turned.")
def room_for_aperture() -> Figure:
    """Show which f-numbers and turns of the two cameras meet all demands.

    Returns
    -------
    Figure
        Lines for depth of field, diffraction and light, and the turn that the precision needs.
    """
    turns = np.arange(1, 31)
    least, diffraction, light, sigma, pixel = np.array([limits(np.radians(t)) for t in turns]).T
    enough = float(np.interp(-TASK.sigma, -sigma, turns))
    fine = float(np.interp(TASK.resolution, pixel, turns))
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.85, 3.7))
    ax.plot(turns, diffraction, ":", color=ROLES["image"])
    ax.plot(turns, light, "--", color=ROLES["ray"])
    ax.plot(turns, least, color=ROLES["camera"])
    for turn in (enough, fine):
        ax.axvline(turn, color=ROLES["object"], lw=1.5)
    across = np.linspace(enough, fine, 20)
    low, high = np.interp(across, turns, least), np.interp(across, turns, light)
    ax.fill_between(across, low, np.maximum(low, high), color=GREY, alpha=0.35)
    write(ax, (6, 15.3), "above: diffraction", "image")
    write(ax, (6, 12.1), "above: too dark", color="#8A5F00")
    write(ax, (5.5, 7.6), "below: ends\nout of focus", "camera")
    write(ax, (enough - 0.4, 1.2), "left: not precise enough", "object", ha="right")
    write(ax, (fine + 0.4, 1.2), "right: too coarse", "object", ha="left")
    write(ax, (20.9, 7.2), "grey: all demands met", ha="left")
    arrow = {"arrowstyle": "-|>", "color": GREY}
    ax.annotate("", xy=((enough + fine) / 2, 10.2), xytext=(22.5, 7.6), arrowprops=arrow)
    ax.set(xlabel="turn of each camera (°)", ylabel="f-number (no unit)")
    ax.set(xlim=(1, 30), ylim=(0, 17))
    return fig


def panel_task() -> tuple[dict[str, float], list[dict[str, float]], list[dict[str, float]]]:
    """Return the task of the panel for one camera straight ahead, and a small catalogue.

    Returns
    -------
    task : dict
        Its demands, in m, s and px.
    cameras, lenses : list of dict
        Figures of two cameras and of two lenses.
    """
    width, depth, height = BOX.size.tolist()
    task = {"width": width, "height": height, "depth": depth, "stand_off": 1.0}
    for name in ("motion", "speed", "resolution", "blur_px", "frame_rate", "exposure_at_f1"):
        task[name] = float(getattr(TASK, name))
    bodies = [read_cameras()[name] for name in ("mvBlueFOX3-2051", PHANTOM)]
    glasses = [read_lenses()[name] for name in ("Nikkor AF-S 50 mm f/1.8G", ZEISS)]
    cameras = [
        {"width": b.image_size[0], "height": b.image_size[1]}
        | {"pitch_um": b.pitch_um, "frame_rate": b.frame_rate}
        for b in bodies
    ]
    names = ("f_mm", "N_least", "N_most", "closest")
    lenses = [{name: getattr(lens, name) for name in names} for lens in glasses]
    return task, cameras, lenses
