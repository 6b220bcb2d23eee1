"""What a calibration is worth, in plain words: each statement says what to do."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from course_lib.boards import DotGrid
from course_lib.calibrating.photographs import on_distance, on_files, on_focal_length, on_views
from course_lib.calibrating.precision import angle_sigma, length_sigma
from course_lib.calibrating.solving import Solved
from course_lib.calibrating.statement import Statement
from course_lib.calibration import Coverage, board_tilts, coverage
from course_lib.checks import Array

#: Share of the picture's cells, and how far out, that points should cover.
COVERED, REACHED = 0.7, 0.85
#: A board tilted by less tells little of the focal length, degrees.
TILTED_DEG = 15.0
#: RMS by the blur of the edges: good, and still usable. Sharp pictures have a blur of 0.7 px.
GOOD_RMS, FAIR_RMS, SHARP = 0.35, 1.0, 0.7
#: Held-out pictures may be so many times worse.
HELD_OUT = 1.5
#: A view is worth another photograph if its error is so many times the usual one.
WORSE = 1.8


@dataclass(frozen=True, eq=False)
class Judgement:
    """All that is to be said on a calibration.

    Attributes
    ----------
    statements : tuple of Statement
        The most important first.
    coverage : Coverage
        Where in the picture the points are.
    view_rms : ndarray
        Error of each view over the points that were kept, px.
    retake : tuple of str
        Names of photographs that are worth taking again.
    """

    statements: tuple[Statement, ...]
    coverage: Coverage
    view_rms: Array
    retake: tuple[str, ...]

    @property
    def fine(self) -> bool:
        """Whether there is nothing bad to say."""
        return all(statement.level != "bad" for statement in self.statements)


def judge(solved: Solved) -> Judgement:
    """Return a judgement of a calibration.

    Parameters
    ----------
    solved : Solved
        The camera and its photographs.

    Returns
    -------
    Judgement
        Statements on error, number, distances, coverage, tilt, precision and rejected photographs.
    """
    covered = coverage(
        [p[k] for p, k in zip(solved.pixels, solved.kept, strict=True)],
        solved.calibration.image_size,
    )
    squares = [
        (r[k] ** 2).sum(axis=1).mean()
        for r, k in zip(solved.calibration.residuals, solved.kept, strict=True)
    ]
    view_rms = np.sqrt(np.array(squares))
    worse = np.flatnonzero(view_rms > WORSE * np.median(view_rms))
    retake = tuple(solved.views[i].name for i in worse)
    statements = (
        *_on_error(solved),
        *on_views(solved, retake),
        *on_distance(solved),
        *_on_coverage(covered),
        *_on_tilts(solved),
        *_on_numbers(solved),
        *_on_precision(solved),
        *on_focal_length(solved),
        *on_files(solved),
    )
    order = {"bad": 0, "note": 1, "good": 2}
    ranked = sorted(statements, key=lambda s: order[s.level])
    return Judgement(tuple(ranked), covered, view_rms, retake)


def _on_error(solved: Solved) -> Iterator[Statement]:
    """Speak about the reprojection error, on the pictures themselves and on those held out."""
    rms, blur = solved.calibration.rms, _usual_blur(solved)
    part = solved.calibration.image_size[0] / max(rms, 1e-9)
    told = f"A typical point is {rms:.2f} px from where the camera expects it (the picture's width "
    told += f"is {float(f'{part:.2g}'):,.0f} times that)"
    if rms <= GOOD_RMS * blur:
        yield Statement("good", f"{told}: very good.")
    elif rms <= FAIR_RMS * blur:
        yield Statement("good", f"{told}: usable; below {GOOD_RMS * blur:.2g} is very good.")
    else:
        yield Statement(
            "bad",
            f"{told}: too much. Is the board flat, --board right, the focus the same in all "
            "photographs? For a very wide lens, try --coefficients k1,k2,k3,k4,k5,k6.",
        )
    if len(solved.held_out):
        other = float(np.sqrt(np.mean(solved.held_out**2)))
        told = f"In photographs that it was not calibrated with it is {other:.2f} px"
        if other <= HELD_OUT * rms:
            fine = rms <= FAIR_RMS * blur
            rest = "." if fine else ", hardly more: the cause is not too many --coefficients."
            yield Statement("good" if fine else "note", told + rest)
        else:
            said = "fits these pictures only. Take more, or estimate fewer --coefficients."
            yield Statement("bad", f"{told}: the camera {said}")


def _usual_blur(solved: Solved) -> float:
    """Return the blur of the edges in the middle of all photographs, px."""
    blurs = [p.detection.blur for p in solved.views if p.detection is not None]
    return max(float(np.median(blurs)), SHARP) if np.isfinite(blurs).all() else SHARP


PLACES = {
    (0, 0): "upper left corner",
    (0, 2): "upper right corner",
    (2, 0): "lower left corner",
    (2, 2): "lower right corner",
    (0, 1): "upper edge",
    (2, 1): "lower edge",
    (1, 0): "left edge",
    (1, 2): "right edge",
    (1, 1): "middle",
}


def missing_places(covered: Coverage) -> list[str]:
    """Return the names of the parts of the picture in which there are no points."""
    rows, columns = covered.counts.shape
    thirds = np.arange(3)
    row, column = (np.repeat(thirds, n)[np.arange(n) * 3] for n in (rows, columns))
    names = []
    for (i, j), name in PLACES.items():
        part = covered.counts[np.ix_(row == i, column == j)]
        if (part > 0).mean() < 0.34:
            names.append(name)
    return names


def _on_coverage(covered: Coverage) -> Iterator[Statement]:
    """Speak about the parts of the picture in which the board never was."""
    cells = covered.counts
    told = (
        f"There are points in {(cells > 0).sum()} of the {cells.size} fields of the picture, and "
    )
    told += f"up to {100 * covered.reach:.0f} % of the way from the middle to a corner"
    missing = missing_places(covered)
    if covered.share >= COVERED and covered.reach >= REACHED and not missing:
        yield Statement("good", f"{told}.")
        return
    where = f" Hold the board into the {', the '.join(missing)}." if missing else ""
    yield Statement(
        "bad" if covered.share < COVERED / 2 else "note",
        f"{told}. Where there are none, distortion is a guess.{where}",
    )


def _on_tilts(solved: Solved) -> Iterator[Statement]:
    """Speak about how the board was tilted."""
    tilts, ways = board_tilts(solved.calibration.poses)
    degrees = np.degrees(tilts)
    tilted = degrees > TILTED_DEG
    sides = len({int(w // (np.pi / 2)) for w in ways[tilted]})
    if tilted.sum() < 3 or sides < 2:
        yield Statement(
            "bad",
            f"The board is tilted by more than {TILTED_DEG:.0f}° in {tilted.sum()} photographs "
            "only: focal length and distance cannot be told apart. Tilt it by 20° to 45°, each "
            "time another way.",
        )
    else:
        yield Statement(
            "good",
            f"The board is tilted by {degrees.min():.0f}° to {degrees.max():.0f}°, to {sides} of "
            "4 sides.",
        )


def _on_numbers(solved: Solved) -> Iterator[Statement]:
    """Speak about coefficients that the pictures do not determine."""
    camera = solved.calibration
    names = ["k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4"]
    values = dict(zip(names, camera.coefficients.tolist(), strict=False))
    vague = [n for n in names if n in camera.sigma and abs(values[n]) < 2 * camera.sigma[n]]
    if vague:
        others = ",".join(n for n in names if n in camera.sigma and n not in vague) or "none"
        yield Statement(
            "note",
            f"{', '.join(vague)} cannot be told from 0 with these photographs. That does no harm "
            f"where there were points; for a simpler camera, type --coefficients {others}.",
        )


def _on_precision(solved: Solved) -> Iterator[Statement]:
    """Speak about what it means for a measurement."""
    covered = coverage(solved.pixels, solved.calibration.image_size)
    length = length_sigma(solved.calibration)
    angle = angle_sigma(solved.calibration, covered.reach)
    yield Statement(
        "good" if length < 0.005 else "note",
        f"What that means: distances from the camera are scaled right to ± {100 * length:.2g} % "
        f"({1000 * length:.2g} mm in 1 m), and directions, where there were points, to "
        f"± {np.degrees(angle):.2g}° ({1000 * np.tan(angle):.2g} mm at 1 m). That is chance only; "
        "a bent board, or squares of another size than --square, come on top.",
    )
    if isinstance(solved.board, DotGrid):
        yield Statement(
            "note",
            "The middles of the dots were corrected for perspective; corners do not need it.",
        )
