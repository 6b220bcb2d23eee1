"""Still figures: apertures to scale, lens names, diffraction, the aperture that a task needs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.diagrams import (
    figure,
    fit,
    panels,
    plain_numbers,
    same_shape,
    sketch,
    stroke,
    write,
)
from course_lib.drawing.lenses.answers import stars
from course_lib.drawing.style import BLACK, FULL_WIDTH, ROLES
from course_lib.optics import (
    airy_diameter,
    aperture_diameter,
    aperture_for_depth,
    apertures_for_limits,
    circle_of_confusion,
    image_distance,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STOPS = (1.4, 2, 2.8, 4, 5.6, 8, 11, 16)


@figure("The openings of a lens of {f:g} mm at the usual f-numbers, to scale.")
def stops(f: float = 50.0, count: int = 8) -> Figure:
    """Show the openings of a lens to scale, one stop apart, with their share of the light.

    Parameters
    ----------
    f : float
        Focal length, mm.
    count : int
        How many, from f/1.4 on.

    Returns
    -------
    Figure
        A disk for each f-number.
    """
    exact = 2 ** (np.arange(1, count + 1) / 2)  # the printed numbers are rounded
    diameters = np.asarray(aperture_diameter(f, exact))
    fig, ax = panels(1, 1, (FULL_WIDTH, 2.4))
    sketch(ax)
    left, gap, most = 0.0, 0.16 * diameters[0], diameters[0]
    for N, d in zip(STOPS, diameters, strict=False):
        room = max(d, 0.3 * most)
        x = left + room / 2
        turn = np.linspace(0, 2 * np.pi, 100)
        ax.fill(x + d / 2 * np.cos(turn), d / 2 * np.sin(turn), color=ROLES["ray"], lw=0)
        write(ax, (x, -0.66 * most), f"f/{N:g}", fontweight="bold")
        write(ax, (x, -0.82 * most), f"{d:.1f} mm", fontsize=9)
        share = "1" if d == most else f"1/{(most / d) ** 2:.0f}"
        write(ax, (x, -0.96 * most), share, "guide", fontsize=9)
        left += room + gap
    write(ax, (-0.02 * most, -0.66 * most), "f-number", ha="right", fontsize=9)
    write(ax, (-0.02 * most, -0.82 * most), "diameter", ha="right", fontsize=9)
    write(ax, (-0.02 * most, -0.96 * most), "light", "guide", ha="right", fontsize=9)
    fit(ax, -0.5 * most, left, -1.05 * most, 0.55 * most)
    return fig


@figure("The lens name 18-140mm 1:3.5-5.6, taken apart.")
def lens_name() -> Figure:
    """Show what the parts of a lens's name mean.

    Returns
    -------
    Figure
        The name, with a note at each part.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 2.3))
    sketch(ax)
    look: dict[str, Any] = {"fontsize": 24, "family": "monospace"}
    for x, text in ((-3.3, "-"), (-0.9, "mm"), (0.5, "1:"), (3.1, "-")):
        write(ax, (x, 0), text, "guide", **look)
    parts = (
        (-4.2, 1, "18", "shortest\nfocal length"),
        (-2.2, -1, "140", "longest\nfocal length"),
        (1.9, 1, "3.5", "smallest f-number\nat 18 mm"),
        (4.2, -1, "5.6", "smallest f-number\nat 140 mm"),
    )
    for x, side, part, note in parts:
        write(ax, (x, 0), part, **look)
        write(ax, (x, 1.1 * side), note)
        stroke(ax, [(x, 0.38 * side), (x, 0.72 * side)], "guide", lw=1)
    fit(ax, -5.4, 5.4, -1.5, 1.5)
    ax.set_aspect("auto")
    return fig


@figure("The image of a star at several f-numbers, on pixels of {pitch_um:g} µm.")
def airy_on_pixels(
    numbers: Sequence[float] = (2.8, 5.6, 11, 22),
    pitch_um: float = 5.0,
    wavelength: float = 0.00055,
) -> Figure:
    """Show Airy patterns on the grid of the pixels.

    Parameters
    ----------
    numbers : sequence of float
        f-numbers.
    pitch_um : float
        Of the pixels, µm.
    wavelength : float
        mm.

    Returns
    -------
    Figure
        A pattern for each f-number with its Airy disk as a circle; one square is a pixel.
    """
    from scipy.special import j1

    fig, axes = panels(1, len(numbers), (FULL_WIDTH, 2.4), squeeze=False)
    half = 3.5 * pitch_um
    x, y = np.meshgrid(*[np.linspace(-half, half, 240)] * 2)
    for ax, N in zip(axes[0], numbers, strict=True):
        # Irradiance (2 J1(v) / v)² of a star behind a round opening.
        v = np.pi * np.hypot(x, y) / (1000 * wavelength * N)
        light = (2 * j1(v) / v) ** 2
        ax.imshow(light ** (1 / 2.2), extent=(-half, half, -half, half), vmin=0, vmax=1)
        for edge in (np.arange(8) - 3.5) * pitch_um:
            ax.axhline(edge, color="white", lw=0.4, alpha=0.5)
            ax.axvline(edge, color="white", lw=0.4, alpha=0.5)
        disk = float(airy_diameter(1000 * wavelength, N))
        turn = np.linspace(0, 2 * np.pi, 100)
        ax.plot(disk / 2 * np.cos(turn), disk / 2 * np.sin(turn), color=ROLES["image"], lw=2)
        ax.set(xlim=(-half, half), ylim=(-half, half))
        ax.axis("off")
        ax.set_title(f"f/{N:g}: {disk / pitch_um:.1f} px", fontsize=11)
    return fig


@figure("f-number that the near and the far end need, against the focus distance.")
def aperture_branches(
    f: float = 50.0,
    near: float = 1000.0,
    far: float = 1500.0,
    c: float = 0.01,
    yours: ArrayLike | None = None,
) -> Figure:
    """Show which f-number each end of a depth range needs, wherever the lens is focused.

    Parameters
    ----------
    f, near, far, c : float
        Focal length, ends of the range and permissible spot, mm.
    yours : array_like, shape (2,), optional
        f-number and focus distance (mm) that a student's function gave.

    Returns
    -------
    Figure
        Two branches; the higher one decides. They cross at the best focus.
    """
    focus = np.linspace(near, far, 400)
    need_near, need_far = apertures_for_limits(f, near, far, focus, c)
    N, best = (float(value) for value in aperture_for_depth(f, near, far, c))
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.6))
    ax.plot(focus, need_near, color=ROLES["camera"], label="needed by the near end")
    ax.plot(focus, need_far, "--", color=ROLES["object"], label="needed by the far end")
    ax.plot(best, N, "o", color=BLACK, ms=19, mfc="none", mew=1.5, zorder=4)
    top = 1.15 * float(np.max([need_near, need_far]))
    reach = best - 0.06 * (far - near), 1.45 * N
    stroke(ax, [reach, (best, N + 0.05 * top)], "guide", lw=1)
    write(ax, reach, "best focus ", ha="right")
    middle = (near + far) / 2
    ax.axvline(middle, ymax=0.84, color=ROLES["guide"], lw=1.2, ls=(0, (6, 4)))
    write(ax, (middle, 0.03 * top), " half-way", "guide", ha="left", va="bottom")
    ax.set(xlabel="focus distance (mm)", ylabel="f-number (no unit)")
    ax.set(xlim=(near, far), ylim=(0, top))
    drawn = same_shape(yours, np.zeros(2))
    if drawn is not None:
        words = f"N = {drawn[0]:.4g}, D = {drawn[1]:.4g} mm"
        stars(ax, drawn[1:], drawn[:1], [words], "your answer")
    ax.legend(loc="upper center", ncols=3)
    return fig


@figure("Defocus, diffraction and their sum at the ends of a depth range, against the f-number.")
def sweet_spot(
    f: float = 85.0,
    near: float = 2000.0,
    far: float = 2500.0,
    pitch: float = 27.6 / 2048,
    wavelength: float = 0.00055,
) -> Figure:
    """Show both blurs at the ends of a depth range against the f-number.

    Parameters
    ----------
    f, near, far, pitch, wavelength : float
        Focal length, ends of the range, pixel pitch and wavelength, mm.

    Returns
    -------
    Figure
        Blurs in px on logarithmic axes, with the smallest sum.
    """
    N = np.geomspace(1.4, 90, 300)
    _, focus = aperture_for_depth(f, near, far, pitch)
    defocus = circle_of_confusion(near, focus, f, N) / pitch
    behind = image_distance(f, focus)  # with the working f-number, as the lens is focused near
    airy = airy_diameter(wavelength, behind / aperture_diameter(f, N)) / pitch
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.8))
    ax.loglog(N, defocus, "--", color=ROLES["ray"], label="defocus at the ends")
    ax.loglog(N, airy, ":", color=ROLES["image"], label=r"diffraction: $2.44\,\lambda N$")
    ax.loglog(N, defocus + airy, color=BLACK, lw=2.5, label="sum")
    best = int(np.argmin(defocus + airy))
    ax.plot(N[best], (defocus + airy)[best], "o", color=BLACK, ms=8)
    text = f"f/{N[best]:.0f}: {(defocus + airy)[best]:.1f} px"
    write(ax, (N[best], 1.45 * (defocus + airy)[best]), text)
    ax.set(xlabel="f-number N (no unit)", ylabel="blur on the sensor (px)", ylim=(0.1, 60))
    ax.set_xticks([1.4, 2.8, 5.6, 11, 22, 45, 90])
    plain_numbers(ax)
    ax.legend(loc="upper center", ncols=3)
    return fig
