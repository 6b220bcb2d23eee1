"""What is to be said of the photographs: how many, how far from the board, and which not."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

import numpy as np

from course_lib.calibrating.options import lengths_of
from course_lib.calibrating.solving import Solved
from course_lib.calibrating.statement import Statement

#: From here on, pictures are enough.
ENOUGH, FEW = 10, 6
#: Equivalent focal lengths are rounded, and phones keep a rim of the sensor to themselves.
PROMISED = 0.1
#: So many times as far away as the nearest board should the farthest be.
NEAR_AND_FAR = 1.25
#: Why photographs are set aside, as an adjective.
KINDS = {
    "file": "unreadable",
    "size": "of another size",
    "zoom": "with another lens or zoom",
    "duplicate": "double",
    "no board": "without board",
    "wrong size": "with another board",
    "glare": "with reflections",
    "covered": "partly hidden",
    "other kind": "with a checkerboard",
    "cut off": "with the board cut off",
    "turned": "turned or mirrored",
}


def on_views(solved: Solved, retake: tuple[str, ...]) -> Iterator[Statement]:
    """Speak about how many photographs there are, and which do not fit."""
    count = len(solved.views)
    if count < FEW:
        yield Statement("bad", f"Only {count} photographs were used: take {ENOUGH} or more.")
    elif count < ENOUGH:
        yield Statement(
            "note", f"{count} photographs were used; with {ENOUGH} or more it is safer."
        )
    else:
        yield Statement("good", f"{count} photographs were used.")
    for reason in solved.reasons:
        yield Statement("note", reason)
    if retake:
        yield Statement(
            "note",
            f"The error is larger than usual in {', '.join(retake)}: take these again, sharp and "
            "with the board flat.",
        )


def on_distance(solved: Solved) -> Iterator[Statement]:
    """Ask whether the distances are right: the only sign of a wrong length; and tell their range.

    A lens is not quite the same at all distances.
    """
    middle = solved.board.points().mean(axis=0)
    away = [float(np.linalg.norm(R @ middle + t)) for R, t in solved.calibration.poses]
    near, far = in_words(min(away)), in_words(max(away))
    between = f"{near} to {far}" if near != far else near
    yield Statement(
        "note",
        f"With {lengths_of(solved.board)}, the board was {between} away from the camera: is that "
        "so? If not, the length given is wrong, and every distance measured will be.",
    )
    times, told = max(away) / min(away), "hold it there, too, if you will measure nearer or farther"
    if times >= NEAR_AND_FAR:
        yield Statement(
            "good",
            f"The farthest board was {times:.2g} times as far away as the nearest. Only between "
            f"them is the camera tested: {told}.",
        )
    else:
        yield Statement(
            "note",
            "All boards were about equally far away, so the camera is tested at one distance "
            f"only. Hold the board near and far; {told}.",
        )


def in_words(millimetres: float) -> str:
    """Return a length with a unit that suits it, to two digits."""
    for unit, size in (("m", 1000.0), ("cm", 10.0)):
        if millimetres >= size * (0.995 if unit == "m" else 9.95):
            return f"{float(f'{millimetres / size:.2g}'):g} {unit}"
    return f"{float(f'{millimetres:.2g}'):g} mm"


def on_files(solved: Solved) -> Iterator[Statement]:
    """Speak about photographs that were set aside before."""
    turned = [photo for photo in solved.photos if photo.problem == "turned"]
    for verdict in sorted({photo.verdict for photo in turned}):
        names = ", ".join(photo.name for photo in turned if photo.verdict == verdict)
        yield Statement(
            "note", f"{names}: {verdict.removeprefix('This photograph is ')} Set aside."
        )
    said = ("does not fit", "turned")
    aside = [p for p in solved.photos if not p.used and p.problem not in said]
    if aside:
        kinds = Counter(p.problem for p in aside)
        told = ", ".join(f"{count} {KINDS.get(kind, kind)}" for kind, count in kinds.most_common())
        yield Statement("note", f"{len(aside)} photographs were set aside: {told}; see each.")


def on_focal_length(solved: Solved) -> Iterator[Statement]:
    """Compare the focal length with what the camera wrote into its files."""
    told = [p.header.focal_px for p in solved.views if p.header and p.header.focal_px]
    if not told:
        return
    promised, found = float(np.median(told)), float(np.mean(np.diag(solved.calibration.K)[:2]))
    said = (
        f"By its 35 mm equivalent in the files, the focal length is about {promised:.0f} px; "
        f"calibrated, it is {found:.0f} px"
    )
    if abs(found / promised - 1) <= PROMISED:
        yield Statement("good", f"{said}.")
    else:
        yield Statement(
            "note",
            f"{said}: that is much apart. Were the pictures cropped, or zoomed by the program? Is "
            "the board tilted in many of them?",
        )
