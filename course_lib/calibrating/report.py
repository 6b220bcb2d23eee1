"""The report: one page with pictures that opens anywhere, and the camera in files of the trade."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from pathlib import Path

import numpy as np

from course_lib.calibrating.judgement import Judgement
from course_lib.calibrating.options import lengths_of
from course_lib.calibrating.output import REPORT, written_together
from course_lib.calibrating.precision import fields_of_view
from course_lib.calibrating.report_pictures import (
    coverage_svg,
    magnification,
    photo_svg,
    residuals_svg,
)
from course_lib.calibrating.solving import Solved
from course_lib.calibration import Calibration
from course_lib.calibration_files import FORMS, StoredCamera, write_camera
from course_lib.page import html_page

STYLE = Path(__file__).with_name("report.css")
MEANINGS = {
    "fx": "focal length along u, px",
    "fy": "focal length along v, px",
    "s": "skew, px",
    "cx": "principal point, u, px",
    "cy": "principal point, v, px",
    "k1": "radial distortion",
    "p1": "tangential distortion",
    "k3": "radial distortion",
    "k4": "radial distortion, denominator",
    "s1": "thin prism",
}
WHAT_NOW = """<h2>What now</h2>
<p>Straighten a photograph of this camera (same zoom and focus, same size), in Python:</p>
<pre>import numpy as np
from PIL import Image
from course_lib.calibration_files import read_camera
from course_lib.remapping import undistort_picture

camera = read_camera("camera.json")
photograph = np.asarray(Image.open("photograph.jpg"))
straight = undistort_picture(photograph, camera.K, camera.coefficients)
Image.fromarray(straight).save("straight.png")</pre>
<p>In the new picture straight lines are straight, and it has the same K without distortion. Chapter
05 of the course tells how this works, chapter 07 what a calibration is worth.</p>"""
LEVELS = {"good": "Good", "note": "Note", "bad": "To do"}


def write_report(
    folder: Path, solved: Solved, judgement: Judgement, told: Sequence[str] = ()
) -> list[Path]:
    """Write the report and the camera: all of it, or nothing.

    Parameters
    ----------
    folder : Path
        Where to; it is made if need be.
    solved : Solved
        The camera and its photographs.
    judgement : Judgement
        What is said of it.
    told : sequence of str
        Lines on how the report came about, such as the command.

    Returns
    -------
    list of Path
        The files: report.html, and camera.* in each form that can hold this camera.

    Raises
    ------
    OSError
        If they cannot be written.
    """
    calibration = solved.calibration
    camera = StoredCamera(
        calibration.K,
        calibration.coefficients,
        calibration.image_size,
        calibration.rms,
        dict(calibration.sigma),
    )
    files, notes = [], []
    with written_together(folder) as draft:
        for form, ending in FORMS.items():
            try:
                files.append(write_camera(draft / f"camera{ending}", camera, form))
            except ValueError as error:
                notes.append(f"There is no camera{ending}: {error}.")
        page = report_html(solved, judgement, files, notes, told)
        (draft / REPORT).write_text(page, encoding="utf-8")
    return [folder / REPORT, *(folder / file.name for file in files)]


def report_html(
    solved: Solved, judgement: Judgement, files: list[Path], notes: list[str], told: Sequence[str]
) -> str:
    """Return the page."""
    parts = [
        _about(solved, told),
        "<h2>Judgement</h2>",
        _statements(judgement),
        "<h2>The camera</h2>",
        _numbers(solved.calibration),
        _fields(solved.calibration),
        "<h2>Where the points are</h2>",
        "<div class='pair'>",
        coverage_svg(judgement.coverage, solved.calibration.image_size),
        residuals_svg(solved),
        "</div>",
        "<h2>The photographs</h2>",
        _photographs(solved, judgement),
        "<h2>Files</h2>",
        _files(files, notes),
        WHAT_NOW,
    ]
    return html_page("Calibration report", parts, STYLE.read_text("utf-8"))


def _about(solved: Solved, told: Sequence[str]) -> str:
    """Return the title, and what was calibrated from what."""
    width, height = solved.calibration.image_size
    return (
        f"<h1>Calibration of a camera of {width} × {height} px</h1>"
        f"<p>{len(solved.views)} of {len(solved.photos)} photographs, {solved.board.name}, "
        f"{lengths_of(solved.board)}.</p>"
    ) + "".join(f"<p class='run'>{escape(line)}</p>" for line in told)


def _statements(judgement: Judgement) -> str:
    lines = (
        f"<li class='{s.level}'><b>{LEVELS[s.level]}</b> {escape(s.text)}</li>"
        for s in judgement.statements
    )
    return "<ul class='statements'>" + "\n".join(lines) + "</ul>"


def camera_numbers_by_name(calibration: Calibration) -> dict[str, float]:
    """Return the numbers of a camera that were estimated."""
    (fx, s, cx), (_, fy, cy), _ = calibration.K
    names = ["k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4"]
    values = {"fx": fx, "fy": fy, "s": s, "cx": cx, "cy": cy}
    values |= dict(zip(names, calibration.coefficients, strict=False))
    return {name: float(values[name]) for name in calibration.sigma}


def _numbers(calibration: Calibration) -> str:
    """Return a table of the numbers with their standard deviations."""
    rows, meaning = [], ""
    for name, value in camera_numbers_by_name(calibration).items():
        sigma = calibration.sigma[name]
        digits = 3 if name in ("fx", "fy", "cx", "cy", "s") else 6
        meaning = MEANINGS.get(name, meaning)
        rows.append(
            f"<tr><th>{name}</th><td>{value:.{digits}f}</td><td>± {sigma:.{digits}f}</td>"
            f"<td>{meaning}</td></tr>"
        )
    head = "<tr><th></th><th>value</th><th>± σ</th><th>what it is</th></tr>"
    note = (
        "<p>σ is the standard deviation that follows from the scatter of the points. Pixel (0, 0) "
        "is the middle of the upper left pixel. Distortion is in OpenCV's order.</p>"
    )
    return f"<table>{head}{''.join(rows)}</table>{note}"


def _fields(calibration: Calibration) -> str:
    """Return how wide the camera sees, where its distortion can be undone so far out."""
    across, down = fields_of_view(calibration)
    told = [f"{angle:.1f}° {way}" for angle, way in ((across, "across"), (down, "down"))]
    if not np.isfinite([across, down]).all():
        return ""
    return f"<p>Field of view, from edge to edge through the middle: {', '.join(told)}.</p>"


def _photographs(solved: Solved, judgement: Judgement) -> str:
    """Return a card for each photograph, those that were used first."""
    place, scale = {photo.path: i for i, photo in enumerate(solved.views)}, magnification(solved)
    cards = []
    for photo in sorted(solved.photos, key=lambda p: p.path not in place):
        i = place.get(photo.path)
        if i is None:
            told, kind = photo.verdict, "aside"
            picture = photo_svg(photo)
        else:
            told = f"{judgement.view_rms[i]:.2f} px. {photo.verdict}"
            kind = "retake" if photo.name in judgement.retake else "used"
            picture = photo_svg(
                photo, solved.pixels[i], solved.calibration.residuals[i], solved.kept[i], scale
            )
        cards.append(
            f"<figure class='{kind}'>{picture}<figcaption><b>{escape(photo.name)}</b> "
            f"{escape(told)}</figcaption></figure>"
        )
    legend = (
        f"<p>Circles: points that were found. Orange lines: to where the camera expects them, "
        f"{scale:g} times as long. Orange circles: left out.</p>"
    )
    return legend + "<div class='cards'>" + "\n".join(cards) + "</div>"


def _files(files: list[Path], notes: list[str]) -> str:
    whose = {".yml": "OpenCV", ".m": "Bouguet's toolbox", ".yaml": "Kalibr", ".json": "any program"}
    lines = [f"<li><code>{escape(f.name)}</code> for {whose[f.suffix]}</li>" for f in files]
    lines += [f"<li>{escape(note)}</li>" for note in notes]
    return "<ul>" + "".join(lines) + "</ul>"
