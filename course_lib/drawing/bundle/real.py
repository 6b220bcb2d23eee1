"""Real blocks with published answers: Strasbourg from the air, and a textbook's resection."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from course_lib import data
from course_lib.bundle import Block, BundleAdjustment, Control, Observations, bundle_adjust
from course_lib.bundle.block import Indices
from course_lib.drawing.diagrams import Floats, figure, panels
from course_lib.drawing.style import FULL_WIDTH, ROLES
from course_lib.orientation import Resection, resect_camera

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Focal length, pixel pitch, middle of the picture and its size, mm, as the reports say.
F, PIXEL, MIDDLE = 123.9392, 0.006, (26.577, 38.811)
K_AERIAL = np.array(
    [[F / PIXEL, 0, MIDDLE[0] / PIXEL], [0, F / PIXEL, MIDDLE[1] / PIXEL], [0, 0, 1]]
)
#: The adjustment that is compared: marks, control points, and their report.
MARKS, SURVEY, REPORT = "f-op0-with-orient", "ctrlpts-fixed", "f-op0-with-orient"


@dataclass(frozen=True, eq=False)
class City:
    """The block of Strasbourg, adjusted here and elsewhere.

    Attributes
    ----------
    fit : BundleAdjustment
        Ours; the origin is the middle of the control points, m.
    control : ndarray of int
        Numbers of the control points.
    published : float
        σ₀ of the report.
    apart : float
        How far our centres are from the published ones at most, m.
    """

    fit: BundleAdjustment
    control: Indices
    published: float
    apart: float


def _lines(name: str) -> list[str]:
    path = data.fetch(f"aerial_block/{name}")
    return path.read_text("utf-8", errors="replace").splitlines()


def _numbered(name: str) -> list[list[str]]:
    """Return the rows of a table that begin with a number."""
    return [line.split(",") for line in _lines(name) if re.match(r"\d+,", line)]


def _published() -> tuple[float, Floats, dict[int, Floats]]:
    """Return σ₀, the centres, and the control points of the report, from its own origin."""
    text = "\n".join(_lines(f"dbatexports/{REPORT}-dbatreport.txt"))
    rows = re.findall(r"[XYZ]c:\s+Value:\s+(\S+)", text)
    prior = text.split("Prior")[1].split("Posterior")[0]
    found = re.findall(r"(\d+),(.+?),(.+?),(.+?),", prior)
    match = re.search(r"Sigma0: +(\S+)", text)
    sigma0 = float(match[1]) if match else np.nan
    control = {int(row[0]): np.array(row[1:], float) for row in found}
    return sigma0, np.array(rows, float).reshape(5, 3), control


@cache
def strasbourg() -> City:
    """Return the block of Strasbourg, adjusted.

    Raises
    ------
    course_lib.data.Unavailable
        If it could not be downloaded.
    """
    sigma0, centres, local = _published()
    survey = {int(row[0]): np.array(row[2:5], float) for row in _numbered(f"ref/{SURVEY}.txt")}
    origin = np.mean([survey[name] - local[name] for name in local], axis=0)
    seen = np.array([row[:4] for row in _numbered(f"pmexports/{MARKS}-2dpts.txt")], float)
    names, points = np.unique(seen[:, 0].astype(int), return_inverse=True)
    cameras, pixels = seen[:, 1].astype(int) - 1, seen[:, 2:]
    surveyed = np.array([int(name) in survey for name in names])
    X = np.array([survey.get(int(name), origin) - origin for name in names])
    starts = [
        resect_camera(X[points[mine]], pixels[mine], K_AERIAL)
        for mine in ((cameras == camera) & surveyed[points] for camera in range(5))
    ]
    start = Block(K_AERIAL, np.array([s.R for s in starts]), np.array([s.t for s in starts]), X)
    control = np.flatnonzero(surveyed)
    observations = Observations(cameras, points, pixels)
    fit = bundle_adjust(start, observations, Control(control, X[control]))
    apart = float(np.linalg.norm(fit.block.centres - centres, axis=1).max())
    return City(fit, control, sigma0, apart)


@figure("Strasbourg from above: five cameras in two strips, what they see, and control points.")
def strasbourg_plan(city: City) -> Figure:
    """Show where the cameras of Strasbourg were, and the points on the ground.

    Parameters
    ----------
    city : City
        The block.

    Returns
    -------
    Figure
        A plan.
    """
    block = city.fit.block
    fig, ax = panels(1, 1, (FULL_WIDTH * 0.8, 4.2))
    corners = 2 * np.array([[0, 0], [MIDDLE[0], 0], MIDDLE, [0, MIDDLE[1]], [0, 0]]) / PIXEL
    rays = np.column_stack([corners, np.ones(5)]) @ np.linalg.inv(K_AERIAL).T
    for camera, (R, C) in enumerate(zip(block.R, block.centres, strict=True)):
        down = rays @ R
        ground = C + down * (-C[2:] / down[:, 2:])
        first = camera == 0
        ax.plot(
            *ground[:, :2].T,
            color=ROLES["image"],
            lw=1,
            label="what a picture shows" if first else None,
        )
        ax.plot(*C[:2], "o", color=ROLES["camera"], ms=6, label="camera" if first else None)
        ax.annotate(
            str(camera + 1), tuple(C[:2]), (7, 7), textcoords="offset points", color=ROLES["camera"]
        )
    places = block.points[city.control, :2].T
    ax.plot(*places, "^k", mfc="white", ms=8, label="control point")
    ax.legend(loc="upper left", bbox_to_anchor=(1, 1), fontsize=10)
    ax.set(aspect="equal", xlabel="east (m)", ylabel="north (m)", xticks=range(-500, 1500, 500))
    return fig


def textbook_resection() -> Resection:
    """Return the pose of a picture in a textbook, from four points.

    Raises
    ------
    course_lib.data.Unavailable
        If the table could not be downloaded.
    """
    table = np.loadtxt(data.fetch("resection_tables/wuhan_resection.txt"))
    # Image coordinates in mm have y upwards; the focal length is in mm, too.
    return resect_camera(table[:, 2:], table[:, :2] * [1, -1], np.diag([153.24, 153.24, 1]))
