"""What a lab report says of its photographs, its camera and what it assumes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from datetime import date

import numpy as np

from course_lib.calibrating.looking import Photo
from course_lib.drawing.lab.sheets import SIGNS
from course_lib.lab.photographs import Work
from course_lib.lab.results import Result

REASONS = 8  # photographs whose verdict is written
LONGEST = 80  # characters of a name


def report_lines(work: Work, results: Sequence[Result], pointing: float, scale: float) -> list[str]:
    """Return all that is said before the lengths; arguments are those of `write_report`."""
    return [*_camera(work), _assumed(work, results, pointing, scale), *_set_aside(work)]


def who_and_when(work: Work, name: str, today: date) -> list[str]:
    """Return who measured, if that is told, and when was photographed and written.

    Parameters
    ----------
    work : Work
        With its camera.
    name : str
        Of who measured, or nothing.
    today : date
        When the report is written.
    """
    who = " ".join(str(name or "").split())[:LONGEST]
    days = sorted({p.header.taken for p in work.photos if p.used and p.header and p.header.taken})
    when = " to ".join(map(_day, days[:: max(1, len(days) - 1)]))
    taken = f"photographed on {when} (by the camera's clock), " if when else ""
    return [*([f"measured by {who}"] if who else []), f"{taken}written on {_day(today)}"]


def _day(day: date) -> str:
    return f"{day.day} {day:%B %Y}"


def sign(work: Work, photo: Photo) -> str:
    """Return what a photograph was used for."""
    if not photo.used:
        return SIGNS[False]
    return "↔" if photo.name in work.measuring else SIGNS[True]


def _camera(work: Work) -> list[str]:
    """Return what is to be said of the camera and its photographs."""
    camera, judgement = work.camera, work.judgement
    (fx, _, cx), (_, fy, cy), _ = camera.K
    signs = Counter(sign(work, photo) for photo in work.photos)
    numbers = {"fx": fx, "fy": fy, "cx": cx, "cy": cy}
    told = [f"{n} {v:.2f} ± {camera.sigma.get(n, 0):.2f}" for n, v in numbers.items()]
    lens = [
        f"{n} {v:.4f}" for n, v in zip(("k1", "k2", "p1", "p2"), camera.coefficients, strict=False)
    ]
    lines = [
        f"{len(work.photos)} photographs: {signs['✓']} ✓ calibrate the camera, {signs['↔']} ↔ are "
        f"measured in, {signs['✗']} ✗ are set aside",
        f"{camera.image_size[0]} × {camera.image_size[1]} px, {work.target.name}; "
        f"RMS {camera.rms:.3f} px",
        f"{', '.join(told)} px (σ); {', '.join(lens)}",
    ]
    if judgement is not None:
        share = judgement.coverage
        lines.append(
            f"corners in {(share.counts > 0).sum()} of {share.counts.size} fields, up to "
            f"{100 * share.reach:.0f} % of the way to a corner"
        )
    if work.solved is not None and len(work.solved.held_out):
        held = float(np.sqrt(np.mean(work.solved.held_out**2)))
        lines.append(f"photographs held out fit to {held:.3f} px")
    return lines


def _assumed(work: Work, results: Sequence[Result], pointing: float, scale: float) -> str:
    """Return what every ± here relies on."""
    uneven = {shot.view.unevenness for result in results for shot, _ in result.pointed}
    one, other = work.target.points()[:2]
    apart = np.linalg.norm(other - one)
    corners = " and ".join(f"{sigma:g}" for sigma in sorted(uneven))
    return (
        f"assumed: {apart:g} mm from corner to corner, σ {100 * scale:g} %; σ of a corner of the "
        f"target {corners} mm, of a mark {pointing:g} px"
    )


def _set_aside(work: Work) -> list[str]:
    """Return a line for each photograph that could not be used, not for more than a few."""
    aside = [f"✗ {photo.name}: {photo.verdict}" for photo in work.photos if not photo.used]
    more = [f"✗ and {len(aside) - REASONS} more"] if len(aside) > REASONS else []
    return aside[:REASONS] + more
