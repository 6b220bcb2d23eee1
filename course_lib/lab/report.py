"""The lab report as one file that is handed in beside the notebook, and shown where it is read.

It holds numbers, small copies of the photographs, and one picture of all. The copies are drawn
anew: of what a phone writes into a photograph, the day is told, and neither place nor owner.
"""

from __future__ import annotations

import base64
import io
import json
import re
from collections.abc import Sequence
from datetime import datetime
from html import escape
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from course_lib.display import described_picture, show_block
from course_lib.drawing.lab.page import Length, report_page
from course_lib.drawing.lab.sheets import short_name
from course_lib.lab.lines import report_lines, sign, who_and_when
from course_lib.lab.photographs import Work, marked
from course_lib.lab.results import Result
from course_lib.lab.words import say
from course_lib.page import html_page

FILE = "lab_report.html"
STYLE = "img { max-width: 100%; } pre { white-space: pre-wrap; }"
MOST = 8_000_000  # bytes of a file that is believed to be a report
AROUND = 0.6  # of a length, around it in a cutting
BLOCK = re.compile(r'<script type="application/json" id="lab-report">(.*?)</script>', re.DOTALL)


def write_report(
    work: Work,
    results: Sequence[Result],
    folder: str | Path = ".",
    *,
    pointing: float,
    scale: float,
    name: str = "",
) -> Path:
    """Write the lab report beside the notebook, unless that would replace one on other photographs.

    Parameters
    ----------
    work : Work
        With its camera.
    results : sequence of Result
        What was measured.
    folder : str or Path
        Where to.
    pointing, scale : float
        What was assumed: standard deviation of a coordinate pointed at, px, and the relative one
        of the target's lengths.
    name : str
        Of who measured; none is written unless given.

    Returns
    -------
    Path
        The file, a page that opens anywhere; if it is not written, a sentence says why.

    Raises
    ------
    ValueError
        If there is no camera yet.
    """
    path = Path(folder, FILE)
    if why := _why_not(path, work):
        say(why)
        return path
    title = "Lab report" if work.own else "Lab report, on the supplied photographs"
    today = datetime.now().astimezone().date()
    lines = report_lines(work, results, pointing, scale)
    lines = [*who_and_when(work, name, today), *lines]
    lengths = [_length(result, pointing) for result in results]
    picture = _png(report_page(title, _thumbnails(work), lines, lengths))
    said = "\n".join((title, *lines, *(length.text for length in lengths)))
    numbers = {"assumed": {"pointing": pointing, "scale": scale}, **_numbers(work, results)}
    numbers |= {"name": str(name or ""), "written": today.isoformat()}
    try:
        path.write_text(_page(title, picture, said, numbers), encoding="utf-8")
    except OSError as error:
        say(f"{path} cannot be written ({error.strerror}): is there such a folder, and room in it?")
        return path
    if work.instead:
        say("This report is on the supplied photographs: the cell with `look` says why.")
    say(f"Wrote {path} ({path.stat().st_size / 1e6:.1f} MB): hand it in with the notebook.")
    return path


def _page(title: str, picture: bytes, said: str, numbers: dict[str, Any]) -> str:
    """Return a page for people, which holds the same for programs."""
    held = {"words": said, "png": base64.b64encode(picture).decode("ascii"), **numbers}
    block = json.dumps(held).replace("<", "\\u003c")
    parts = [
        f"<h1>{escape(title)}</h1>",
        described_picture(picture, said),
        f"<pre>{escape(said)}</pre>",
        f'<script type="application/json" id="lab-report">{block}</script>',
    ]
    return html_page(title, parts, STYLE)


def _why_not(path: Path, work: Work) -> str:
    """Return why no report is written; nothing if one is."""
    if _bare_shell() is not None:
        return (
            f"No {FILE} is written where a notebook runs without JupyterLab, as when it is graded: "
            "what was handed in counts."
        )
    before = read_report(path)
    if not isinstance(before, str) and before.get("own") and not work.own:
        return (
            f"{FILE} stays as it is: it was made with your own photographs, and these are the "
            "supplied ones. To write another one, move it away."
        )
    return ""


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


def _thumbnails(work: Work) -> list[tuple[str, NDArray[np.uint8]]]:
    """Return small photographs and what is written above them."""
    small = [(photo, marked(photo, 160)) for photo in work.photos]
    return [
        (f"{sign(work, photo)} {short_name(photo.name)}", picture)
        for photo, picture in small
        if picture is not None
    ]


def _length(result: Result, pointing: float) -> Length:
    cuttings = tuple(cutting(shot.photograph, ends) for shot, ends in result.pointed)
    return Length(f"{result.said}. {result.taken(pointing)}", result.length.parts, cuttings)


def cutting(
    photograph: NDArray[np.uint8], ends: NDArray[np.float64]
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """Return what is around a length, at most 300 px wide or high, and its ends there."""
    import cv2

    height, width = photograph.shape[:2]
    margin = AROUND * float(np.ptp(ends, axis=0).max()) + 10
    low = np.clip(np.floor(ends.min(axis=0) - margin), 0, None).astype(int)
    high = np.minimum(np.ceil(ends.max(axis=0) + margin), (width, height)).astype(int)
    part = photograph[low[1] : high[1], low[0] : high[0]]
    full = high - low
    size = np.maximum(1, np.rint(full * min(1.0, 300 / full.max()))).astype(int)
    small = cv2.resize(part, size.tolist(), interpolation=cv2.INTER_AREA)
    return np.asarray(small, np.uint8), (ends - low + 0.5) * (size / full) - 0.5


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
                "ruler": r.ruler[0] if r.ruler else None,
                "ruler_pm": r.ruler[1] if r.ruler else None,
                "ends": [ends.tolist() for _, ends in r.pointed],
            }
            for r in results
        ],
    }


def _png(figure: Any) -> bytes:
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=100)
    return file.getvalue()
