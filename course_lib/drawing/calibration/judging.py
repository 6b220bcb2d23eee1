"""Still figures that judge a calibration: refinement, coverage, uncertainty, held-out views."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from course_lib.calibration import (
    Calibration,
    CameraModel,
    calibrate,
    held_out_rms,
)
from course_lib.drawing.calibration.photographs import BOARD, SIZE
from course_lib.drawing.diagrams import (
    figure,
    panels,
    plain_numbers,
)
from course_lib.drawing.style import FULL_WIDTH, GREY, ROLES

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Sets of coefficients, one longer than the other.
MODELS: tuple[tuple[str, ...], ...] = (
    (),
    ("k1",),
    ("k1", "k2"),
    ("k1", "k2", "p1", "p2"),
    ("k1", "k2", "p1", "p2", "k3"),
    ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"),
    ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4"),
)


@figure("How the RMS falls step by step, to one floor below which nothing goes.")
def steps_down(histories: Mapping[str, Sequence[float]]) -> Figure:
    """Show the RMS after each step of one way or several to a calibration.

    Parameters
    ----------
    histories : mapping of str to sequence of float
        By name: the RMS at the start and after each step, px.

    Returns
    -------
    Figure
        A line for each.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH, 3.2))
    for (name, rms), role in zip(histories.items(), ("second", "camera", "object"), strict=False):
        ax.plot(range(len(rms)), rms, "o-", color=ROLES[role], label=name, ms=4)
    ax.set_yscale("log")
    ax.set(xlabel="step (number)", ylabel="RMS (px)")
    ax.set_xticks(range(max(len(rms) for rms in histories.values())))
    ax.set_yticks([0.1, 0.2, 0.5, 1, 2, 5])
    plain_numbers(ax)
    ax.legend()
    return fig


@figure("Focal length, principal point and k1 with their sigma, from two views up to all.")
def views_grow(pixels: Sequence[ArrayLike]) -> Figure:
    """Show what is estimated, with its standard deviation, as views are added one by one.

    Parameters
    ----------
    pixels : sequence of array_like, shape (54, 2)
        Corners of each view.

    Returns
    -------
    Figure
        A panel for each of fx, cx and k1, against the number of views.
    """
    counts = range(2, len(pixels) + 1)
    found = [first_views(pixels, n) for n in counts]
    fig, axes = panels(1, 3, (FULL_WIDTH, 2.9))
    labels = {"fx": "fx (px)", "cx": "cx (px)", "k1": "k1 (no unit)"}
    for ax, (name, label) in zip(axes, labels.items(), strict=True):
        values = [
            dict(zip(("fx", "cx", "k1"), (c.K[0, 0], c.K[0, 2], c.coefficients[0]), strict=True))[
                name
            ]
            for c in found
        ]
        ax.axhline(values[-1], color=GREY, lw=0.8)
        ax.errorbar(
            counts,
            values,
            yerr=[c.sigma[name] for c in found],
            fmt="o",
            color=ROLES["camera"],
            ecolor=ROLES["ray"],
            ms=4,
            lw=1.6,
        )
        ax.set(xlabel="views (number)", ylabel=label)
        ax.set_xticks([2, 5, 10, 13])
    return fig


def first_views(pixels: Sequence[ArrayLike], count: int) -> Calibration:
    """Return the calibration with k1 and k2 from the first views."""
    model = CameraModel(coefficients=("k1", "k2"))
    return calibrate(BOARD.points(), pixels[:count], SIZE, model)


@figure("The RMS of the views used falls with every coefficient; that of held-out views rises.")
def held_out_models(pixels: Sequence[ArrayLike]) -> Figure:
    """Show for longer and longer models the RMS of the views used, and of views held out.

    Parameters
    ----------
    pixels : sequence of array_like, shape (54, 2)
        Corners of each view.

    Returns
    -------
    Figure
        Two lines against the number of coefficients, from one on.
    """
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.8, 3.0))
    found = [model_errors(pixels, names) for names in MODELS[1:]]
    counts = [len(names) for names in MODELS[1:]]
    ax.plot(counts, [own for own, _ in found], "o-", color=ROLES["camera"])
    ax.plot(counts, [others for _, others in found], "s-", color=ROLES["object"])
    look: dict[str, Any] = {"textcoords": "offset points", "ha": "right", "va": "center"}
    for name, number, up, role in (
        ("views held out", 1, 12, "object"),
        ("views used", 0, -12, "camera"),
    ):
        ax.annotate(name, (11.5, found[-1][number]), (0, up), color=ROLES[role], **look)
    ax.set(xlabel="coefficients of distortion (number)", ylabel="RMS (px)", xticks=counts)
    ax.margins(y=0.18)
    return fig


def model_errors(pixels: Sequence[ArrayLike], names: tuple[str, ...]) -> tuple[float, float]:
    """Return the RMS of the views used, and of views held out, for a set of coefficients."""
    model = CameraModel(coefficients=names)
    own = calibrate(BOARD.points(), pixels, SIZE, model).rms
    others = held_out_rms(BOARD.points(), pixels, SIZE, model)
    return own, float(np.sqrt((others**2).mean()))
