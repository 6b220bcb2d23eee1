"""Still figures: how a sensor that counts photons sees colours."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from course_lib.drawing.diagrams import Floats, figure, fit, panels, sketch, stroke, write
from course_lib.drawing.sensor.screen import picture, shown
from course_lib.drawing.style import BLACK, BLUE, FULL_WIDTH, GREY, ORANGE, PURPLE
from course_lib.sensor import (
    bayer_masks,
    demosaic_bilinear,
    hsv_from_rgb,
    rgb_from_hsv,
    srgb_encode,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PRIMARIES = ("#D32F2F", "#2E9E44", "#2458C8")
#: Schematic sensitivities: name, wavelength of the top in nm, width in nm, colour.
SENSITIVITIES = (
    ("blue filter", 455.0, 32.0, PRIMARIES[2]),
    ("green filter", 535.0, 38.0, PRIMARIES[1]),
    ("red filter", 610.0, 36.0, PRIMARIES[0]),
)


@figure(
    "Three drawings: a filter wheel before one sensor; a mosaic of red, green and blue "
    "filters with twice as much green; a prism that sends three colours to three chips."
)
def colour_strategies() -> Figure:
    """Show three ways to see colours: a filter wheel, a mosaic of filters, three chips on a prism.

    Returns
    -------
    Figure
        Three drawings; light comes from the left.
    """
    fig, axes = panels(1, 3, (FULL_WIDTH, 2.5))
    titles = ("one after the other", "side by side", "three chips")
    for ax, title, draw in zip(axes, titles, (_wheel, _mosaic, _prism), strict=True):
        sketch(ax, title)
        draw(ax)
        fit(ax, -0.4, 6.4, -2.5, 2.3)
    return fig


def _wheel(ax: Axes) -> None:
    stroke(ax, [(0, 0.9), (5.4, 0.9)], "ray")
    for k, colour in enumerate(PRIMARIES):
        turn = np.linspace(0, 2 * np.pi / 3, 30) + 2 * np.pi * k / 3 + 0.5
        x, y = 2.6 + 0.75 * np.cos(turn), 0.0 + 1.5 * np.sin(turn)
        ax.fill(np.r_[2.6, x], np.r_[0.0, y], color=colour, alpha=0.85, lw=0)
    ax.plot(2.6, 0, "o", color=BLACK, ms=6)
    _chip(ax, 5.4, 0.9, GREY)
    write(ax, (3.0, -2.1), "filter wheel", fontsize=9)


def _chip(ax: Axes, x: float, y: float, colour: str, half: float = 0.7) -> None:
    ax.fill([x, x + 0.3, x + 0.3, x], [y - half, y - half, y + half, y + half], color=colour, lw=0)


def _mosaic(ax: Axes) -> None:
    stroke(ax, [(0, 0), (2.0, 0)], "ray")
    names = "RGGB"
    for i in range(4):
        for j in range(4):
            name = names[2 * (i % 2) + j % 2]
            x, y = 2.3 + 0.85 * j, 1.7 - 0.85 * i
            colour = PRIMARIES["RGB".index(name)]
            ax.fill([x, x + 0.8, x + 0.8, x], [y, y, y - 0.8, y - 0.8], color=colour, lw=0)
            ax.text(x + 0.4, y - 0.4, name, color="white", ha="center", va="center", fontsize=9)
    write(ax, (3.4, -2.1), "Bayer mosaic, from the front", fontsize=9)


def _prism(ax: Axes) -> None:
    ax.fill([1.6, 3.9, 3.9, 1.6], [-0.9, -0.9, 0.9, 0.9], color=BLUE, alpha=0.12, lw=0)
    for x in (2.1, 3.0):
        stroke(ax, [(x - 0.5, -0.9), (x + 0.4, 0.9)], color=GREY, lw=1.2)
    stroke(ax, [(0, 0), (2.05, 0)], "ray")
    stroke(ax, [(2.05, 0), (2.05, 1.35)], color=PRIMARIES[2])
    stroke(ax, [(2.05, 0), (2.95, 0)], color=ORANGE, lw=1.5)
    stroke(ax, [(2.95, 0), (2.95, -1.35)], color=PRIMARIES[0])
    stroke(ax, [(2.95, 0), (5.0, 0)], color=PRIMARIES[1])
    ax.fill([1.4, 2.7, 2.7, 1.4], [1.35, 1.35, 1.62, 1.62], color=PRIMARIES[2], lw=0)
    ax.fill([2.3, 3.6, 3.6, 2.3], [-1.35, -1.35, -1.62, -1.62], color=PRIMARIES[0], lw=0)
    _chip(ax, 5.0, 0.0, PRIMARIES[1])
    write(ax, (3.0, -2.1), "prism with coatings", fontsize=9)


@figure(
    "Sensitivity against wavelength: blue, green and red filters side by side under the eye's"
    " curve, which is highest near 555 nm, and silicon, which goes on to about 1100 nm."
)
def spectrum() -> Figure:
    """Show which wavelengths the eye, a colour filter and bare silicon react to.

    Returns
    -------
    Figure
        Schematic curves from 380 nm to 1100 nm; the eye's is a usual approximation of CIE V(λ).
    """
    wavelength = np.linspace(380, 1120, 500)
    eye = 1.019 * np.exp(-285.4 * (wavelength / 1000 - 0.559) ** 2)
    silicon = 0.6 / (1 + np.exp((400 - wavelength) / 60)) / (1 + np.exp((wavelength - 1000) / 45))
    fig, ax = panels(1, 1, (FULL_WIDTH, 2.9))
    ax.axvspan(700, 1120, color=PURPLE, alpha=0.08, lw=0)
    ax.fill_between(wavelength, eye, color=GREY, alpha=0.25, lw=0)
    ax.text(559, 1.04, "eye", ha="center", fontsize=9)
    for name, top, width, colour in SENSITIVITIES:
        curve = 0.55 * np.exp(-(((wavelength - top) / width) ** 2) / 2)
        ax.plot(wavelength, curve, color=colour, lw=1.8, label=name)
    ax.plot(wavelength, silicon, color=BLACK, lw=1.8, label="bare silicon")
    ax.text(905, 0.8, "near infrared", ha="center", fontsize=10)
    ax.set(xlabel="wavelength (nm)", ylabel="sensitivity (relative)", ylim=(0, 1.15))
    ax.set(xlim=(380, 1120))
    ax.legend(loc="upper right", fontsize=8)
    return fig


@figure(
    "Six pictures of one raw file: its numbers as grey, a few pixels behind their filters, "
    "demosaiced and dark green, with white balance, encoded for a screen, and the few pixels "
    "again."
)
def development(
    raw: ArrayLike,
    black: float,
    white: float,
    gains: tuple[float, float],
    detail: tuple[int, int] = (418, 40),
) -> Figure:
    """Show how the raw numbers of a camera become a picture, step by step.

    Parameters
    ----------
    raw : array_like, shape (rows, columns)
        Numbers behind an RGGB mosaic, DN.
    black, white : float
        The numbers for no light and for white, DN.
    gains : (float, float)
        Factors that make white paper grey in red and in blue; green has 1.
    detail : (int, int)
        Even column and row of the first of the 18 × 12 pixels that are shown enlarged.

    Returns
    -------
    Figure
        Six pictures, from the raw numbers to the finished one.
    """
    level = np.clip((np.asarray(raw, float) - black) / (white - black), 0, 1)
    part = slice(detail[1], detail[1] + 12), slice(detail[0], detail[0] + 18)
    coloured = level[part][..., None] * bayer_masks((12, 18))
    rgb = demosaic_bilinear(level)
    balanced = np.clip(rgb * np.array([gains[0], 1.0, gains[1]]), 0, 1)
    steps = (
        ("1 raw numbers, as grey", level),
        ("2 a few pixels, as filtered", shown(2 * coloured)),
        ("3 black taken off, demosaiced", rgb),
        ("4 white balance", balanced),
        ("5 encoded for the screen", shown(balanced)),
        ("the same few pixels", shown(balanced)[part]),
    )
    fig, axes = panels(2, 3, (FULL_WIDTH, 4.1))
    for ax, (title, image) in zip(axes.flat, steps, strict=True):
        picture(ax, image, title)
    return fig


@figure(
    "The sRGB curve rises steeply from black and reaches half of the codes at 0.214 of the "
    "light; beside it two ramps of {bits} bits: even steps of code show finer darks than even"
    " steps of light."
)
def gamma_curve(bits: int = 4) -> Figure:
    """Show the sRGB curve, and a ramp of light with few levels with and without it.

    Parameters
    ----------
    bits : int
        Of the ramps.

    Returns
    -------
    Figure
        The curve, and the two ramps as a screen shows them.
    """
    light = np.linspace(0, 1, 400)
    fig, (ax, ramps) = panels(1, 2, (FULL_WIDTH, 2.9), width_ratios=(1, 1.5))
    ax.plot(light, srgb_encode(light), color=BLUE)
    ax.plot([0, 1], [0, 1], color=GREY, lw=1, ls=(0, (5, 3)))
    ax.plot([0.214, 0.214, 0], [0, 0.5, 0.5], color=ORANGE, lw=1.5)
    ax.set(xlabel="light (share)", ylabel="code (share)", xlim=(0, 1), ylim=(0, 1), aspect="equal")
    top = 2**bits - 1
    dark = np.linspace(0, 0.35, 400)
    linear = shown(np.rint(dark * top) / top)
    encoded = np.rint(srgb_encode(dark) * top) / top
    for row, (ramp, name) in enumerate(((linear, "evenly in light"), (encoded, "evenly in code"))):
        where = (0, 0.35, 1.2 * row, 1.2 * row + 0.8)
        ramps.imshow(ramp[None], extent=where, aspect="auto", vmin=0, vmax=1)
        ramps.text(0, 1.2 * row + 0.86, f"{bits} bits, levels {name}", fontsize=9)
    ramps.set(xlim=(0, 0.35), ylim=(0, 2.3), yticks=[], xlabel="light (share), the darkest 35 %")
    return fig


@figure(
    "Washers and two brass nuts under light that falls off to the right, as red, green, blue,"
    " hue, saturation and value: in hue and saturation both nuts look alike, and unlike the rest."
)
def colour_spaces(light: ArrayLike) -> Figure:
    """Show a colour picture with uneven light as red, green, blue and as hue, saturation, value.

    Parameters
    ----------
    light : array_like, shape (rows, columns, 3)
        Linear in light, 0 to 1.

    Returns
    -------
    Figure
        The three channels of each space; the hue is shown where there is some saturation.
    """
    rgb = shown(light)
    hsv = hsv_from_rgb(rgb)
    fig, axes = panels(2, 4, (FULL_WIDTH, 3.2))
    picture(axes[0, 0], rgb, "dim on the right")
    for ax, channel, name in zip(axes[0, 1:], np.moveaxis(rgb, 2, 0), "RGB", strict=True):
        picture(ax, channel, name)
    _scales(axes[1, 0])
    picture(axes[1, 1], np.where(hsv[..., 1:2] < 0.2, 0.85, _pure(hsv[..., 0])), "hue")
    picture(axes[1, 2], hsv[..., 1], "saturation")
    picture(axes[1, 3], hsv[..., 2], "value")
    return fig


def _pure(hue: Floats) -> Floats:
    """Return the colours of hues, strong and bright."""
    return rgb_from_hsv(np.stack([hue, np.full_like(hue, 0.9), np.full_like(hue, 0.9)], axis=-1))


def _scales(ax: Axes) -> None:
    """Draw what the colours of the hue and the greys of saturation and value stand for."""
    along = np.linspace(0, 1, 181)
    hues = _pure(along[None])
    greys = np.repeat(along[None, :, None], 3, axis=2)
    for image, low, high, name in ((hues, 0.62, 0.82, "hue"), (greys, 0.05, 0.25, "the others")):
        ax.imshow(image, extent=(0.06, 0.94, low, high), aspect="auto")
        ends = ("0°", "360°") if name == "hue" else ("0", "1")
        ax.text(0.06, high + 0.04, ends[0], fontsize=8)
        ax.text(0.5, high + 0.04, name, ha="center", fontsize=8)
        ax.text(0.94, high + 0.04, ends[1], ha="right", fontsize=8)
    ax.set(xlim=(0, 1), ylim=(0, 1))
    ax.axis("off")


def dimmed_belt() -> Floats:
    """Return the belt with light that falls off to a sixth on the right, shape (320, 480, 3)."""
    from data_generators.belt import belt

    light = belt().astype(float)
    return np.asarray(np.clip(light * np.linspace(1.0, 0.16, light.shape[1])[None, :, None], 0, 1))
