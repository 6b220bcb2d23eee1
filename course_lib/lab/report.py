"""The lab report as one file that is handed in beside the notebook, and shown where it is read.

It holds numbers, small copies of the photographs, and one picture of all. The copies are drawn
anew, so nothing of what a phone writes into a photograph (place, time, owner) is in them.
"""

from __future__ import annotations

import base64
import io
import json
import re
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from course_lib.display import described_picture, show_block
from course_lib.drawing.lab.page import Length, report_page
from course_lib.drawing.lab.sheets import thumbnail
from course_lib.lab.photographs import Work
from course_lib.lab.shots import Shot
from course_lib.measuring import Measured
from course_lib.page import html_page

FILE = "lab_report.html"
MOST = 8_000_000  # bytes of a file that is believed to be a report
AROUND = 0.6  # of a length, around it in a cutting
BLOCK = re.compile(r'<script type="application/json" id="lab-report">(.*?)</script>', re.DOTALL)


@dataclass(frozen=True, eq=False)
class Result:
    """A length that was measured, and the ruler beside it.

    Attributes
    ----------
    name : str
        What was measured.
    length : Measured
        By the camera.
    ruler, ruler_pm : float
        By a ruler, and half the width of its interval of 95 %, mm.
    pointed : tuple of (Shot, ndarray)
        Photographs, and where both ends are in each, shape (2, 2), px.
    """

    name: str
    length: Measured
    ruler: float
    ruler_pm: float
    pointed: tuple[tuple[Shot, NDArray[np.float64]], ...]

    @property
    def difference(self) -> float:
        """Camera minus ruler, mm."""
        return self.length.value - self.ruler

    @property
    def ratio(self) -> float:
        """The difference by what both are uncertain by, together: below 1, they agree.

        References
        ----------
        ISO 13528, the E_n number: ``|difference| / √(U₁² + U₂²)`` with intervals of 95 %.
        """
        return abs(self.difference) / float(np.hypot(self.length.plus_minus, self.ruler_pm))

    @property
    def said(self) -> str:
        """The result in a line."""
        by_ruler = f"{self.ruler:g} mm ± {self.ruler_pm:g} mm"
        apart = f"{round(self.difference, 2) + 0.0:+.2f} mm, {self.ratio:.2f} of both ± together"
        return f"{self.name}: {self.length}; ruler {by_ruler}; difference {apart}"


def write_report(work: Work, results: Sequence[Result], folder: str | Path = ".") -> Path:
    """Write the lab report beside the notebook.

    Parameters
    ----------
    work : Work
        With its camera.
    results : sequence of Result
        What was measured.
    folder : str or Path
        Where to.

    Returns
    -------
    Path
        The file, a page that opens anywhere.

    Raises
    ------
    ValueError
        If there is no camera yet.
    OSError
        If the file cannot be written.
    """
    title = "Lab report" if work.own else "Lab report, on the supplied photographs"
    lines = camera_lines(work)
    lengths = [_length(result) for result in results]
    picture = _png(report_page(title, _thumbnails(work), lines, lengths))
    said = "\n".join(f"{line}." for line in (title, *lines, *(r.said for r in results)))
    held = {
        "words": said,
        "png": base64.b64encode(picture).decode("ascii"),
        **_numbers(work, results),
    }
    block = json.dumps(held).replace("<", "\\u003c")
    parts = [
        f"<h1>{escape(title)}</h1>",
        described_picture(picture, said),
        f"<pre>{escape(said)}</pre>",
        f'<script type="application/json" id="lab-report">{block}</script>',
    ]
    path = Path(folder, FILE)
    path.write_text(html_page(title, parts, "img { max-width: 100%; }"), encoding="utf-8")
    print(f"Wrote {path} ({path.stat().st_size / 1e6:.1f} MB): hand it in with the notebook.")
    return path


def show_report(folder: str | Path = ".") -> None:
    """Show the report beside the notebook; say so if there is none.

    Parameters
    ----------
    folder : str or Path
        Where it is.
    """
    held = read_report(Path(folder, FILE))
    if isinstance(held, str):
        print(held)
        return
    picture, words = base64.b64decode(held["png"]), held["words"]
    show_block(described_picture(picture, words), words)
    shell = _bare_shell()
    if shell is not None:  # where submissions are graded: a person must see it
        shell.display_pub.publish({"text/plain": words, "image/png": picture})


def read_report(path: Path) -> dict[str, Any] | str:
    """Return what a report holds, or a sentence why it holds nothing."""
    try:
        if path.stat().st_size > MOST:
            return f"{path.name} is larger than a report can be."
        found = BLOCK.search(path.read_text(encoding="utf-8"))
        held: dict[str, Any] = dict(json.loads(found[1] if found else "{}"))
        base64.b64decode(held["png"], validate=True)
        str(held["words"])
    except OSError:
        return f"There is no {path.name} beside this notebook: run the cells above, and hand it in."
    except (ValueError, TypeError, KeyError):
        return f"{path.name} is no report as write_report makes it."
    return held


def _bare_shell() -> Any:
    """Return the IPython that runs without a kernel, as where submissions are graded, or None."""
    import sys

    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell if shell is not None and not hasattr(shell, "kernel") else None


def camera_lines(work: Work) -> list[str]:
    """Return what is to be said of the camera and its photographs."""
    camera, judgement = work.camera, work.judgement
    (fx, _, cx), (_, fy, cy), _ = camera.K
    used = len(work.solved.views) if work.solved else 0
    numbers = {"fx": fx, "fy": fy, "cx": cx, "cy": cy}
    told = [f"{n} {v:.2f} ± {camera.sigma.get(n, 0):.2f}" for n, v in numbers.items()]
    lens = [
        f"{n} {v:.4f}" for n, v in zip(("k1", "k2", "p1", "p2"), camera.coefficients, strict=False)
    ]
    lines = [
        f"{used} of {len(work.photos)} photographs, {camera.image_size[0]} × "
        f"{camera.image_size[1]} px, {work.target.name}; RMS {camera.rms:.3f} px",
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


def _thumbnails(work: Work) -> list[NDArray[np.uint8]]:
    pictures = []
    for photo in work.photos:
        if photo.thumbnail is None or photo.header is None:
            continue
        scale = photo.header.size[0] / photo.thumbnail.shape[1]
        found = photo.detection.points if photo.detection else np.empty((0, 2))
        pictures.append(thumbnail(photo.thumbnail, found / scale, 160))
    return pictures


def _length(result: Result) -> Length:
    cuttings = tuple(_cutting(shot.photograph, ends) for shot, ends in result.pointed)
    return Length(result.said, result.length.parts, cuttings)


def _cutting(
    photograph: NDArray[np.uint8], ends: NDArray[np.float64]
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """Return what is around a length, at most 300 px wide or high, and its ends there."""
    import cv2

    height, width = photograph.shape[:2]
    margin = AROUND * float(np.ptp(ends, axis=0).max()) + 10
    low = np.clip(np.floor(ends.min(axis=0) - margin), 0, None).astype(int)
    high = np.minimum(np.ceil(ends.max(axis=0) + margin), (width, height)).astype(int)
    part = photograph[low[1] : high[1], low[0] : high[0]]
    scale = min(1.0, 300 / max(part.shape[:2]))
    size = (max(1, round(part.shape[1] * scale)), max(1, round(part.shape[0] * scale)))
    small = cv2.resize(part, size, interpolation=cv2.INTER_AREA)
    return np.asarray(small, np.uint8), (ends - low + 0.5) * scale - 0.5


def _numbers(work: Work, results: Sequence[Result]) -> dict[str, Any]:
    """Return the numbers of a report as JSON has them."""
    camera = work.camera
    return {
        "own": work.own,
        "camera": {
            "K": camera.K.tolist(),
            "coefficients": camera.coefficients.tolist(),
            "sigma": camera.sigma,
            "rms": camera.rms,
            "image_size": list(camera.image_size),
        },
        "lengths": [
            {
                "name": r.name,
                "value": r.length.value,
                "plus_minus": r.length.plus_minus,
                "parts": r.length.parts,
                "ruler": r.ruler,
                "ruler_pm": r.ruler_pm,
                "ends": [ends.tolist() for _, ends in r.pointed],
            }
            for r in results
        ],
    }


def _png(figure: Any) -> bytes:
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=100)
    return file.getvalue()
