"""A verdict as plain text: for terminals, reports, and readers of the notebook without HTML."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from course_lib.judging.verdict import Feedback, PartVerdict, Verdict

MARKS = {"right": "✓", "not attempted": "○"}
WRONG = "✗"
#: Numbers in a picture from which on only its shape and range are shown.
LEGIBLE = 60
#: A number so much smaller than the largest one of its table is a rounding error.
NOTHING = 1e-11


def mark(feedback: Feedback) -> str:
    """Return the sign of a part's feedback: right, not attempted, or wrong."""
    return MARKS.get(feedback.kind, WRONG)


def format_points(points: float) -> str:
    """Write points with as few digits as they need."""
    return f"{points:.2f}".rstrip("0").rstrip(".")


def format_value(value: Any) -> str:
    """Write a value as a student would compare it by eye: few digits, aligned, cut when long."""
    if isinstance(value, np.ndarray) and not value.ndim:
        value = value.item()
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, np.ndarray) and value.ndim > 1 and value.size > LEGIBLE:
        return _outline(value)
    if _loses_digits(value):
        return _with_four_digits(value)
    whole = isinstance(value, np.ndarray) and value.dtype.kind in "iu" and value.ndim > 1
    threshold = LEGIBLE if whole else 24
    with np.printoptions(
        precision=5, suppress=True, threshold=threshold, edgeitems=3, linewidth=72
    ):
        if isinstance(value, np.ndarray):
            return str(value)
        if isinstance(value, tuple | list):
            return "(" + ", ".join(format_value(item) for item in value[:12]) + ")"
        text = repr(value)
    return text if len(text) <= 300 else text[:300] + " …"


def _loses_digits(value: Any) -> bool:
    """Whether numbers of a small table would be lost after five decimals, as in F for pixels."""
    table = isinstance(value, np.ndarray) and value.ndim == 2 and value.dtype.kind == "f"
    if not table or not value.size or not np.isfinite(value).all():
        return False
    sizes = np.abs(value)
    return bool(((sizes > NOTHING * sizes.max()) & (sizes < 5e-4)).any())


def _with_four_digits(table: NDArray[Any]) -> str:
    """Write a table with four digits of each number, and rounding errors as zeros."""
    kept = np.where(np.abs(table) > NOTHING * np.abs(table).max(), table, 0.0)
    with np.printoptions(linewidth=90):
        return np.array2string(kept, formatter={"float_kind": lambda x: f"{x:>10.4g}"})


@np.errstate(all="ignore")  # an answer may hold any numbers
def _of_length_1(got: Any, expected: Any) -> tuple[Any, Any] | None:
    """Return two tables, of any scale, of length 1 and with one sign; None where it cannot be."""
    if isinstance(got, tuple | list) and isinstance(expected, tuple) and len(got) == len(expected):
        pairs = [_of_length_1(*both) or both for both in zip(got, expected, strict=True)]
        return tuple(one for one, _ in pairs), tuple(other for _, other in pairs)
    tables = [np.asarray(a) for a in (got, expected) if isinstance(a, np.ndarray)]
    if len(tables) < 2 or tables[0].shape != tables[1].shape or tables[0].ndim != 2:
        return None
    numbers = all(table.dtype.kind in "iuf" for table in tables)
    lengths = np.array([np.linalg.norm(table) if numbers else 0.0 for table in tables])
    if not np.isfinite(lengths).all() or not np.all(lengths):
        return None
    one, other = (table / length for table, length in zip(tables, lengths, strict=True))
    return (-one if (one * other).sum() < 0 else one), other


def _outline(array: NDArray[Any]) -> str:
    """Write what a long array is like: its shape, type and range."""
    text = f"an array of shape {array.shape}, {array.dtype}"
    if array.dtype.kind not in "biuf":
        return text
    known = array[~np.isnan(array)] if array.dtype.kind == "f" else array
    range_ = f"from {known.min():.6g} to {known.max():.6g}" if known.size else "NaN only"
    return f"{text}, {range_}" + (", and some NaN" if 0 < known.size < array.size else "")


def _largest_difference(got: Any, expected: Any) -> list[tuple[str, str]]:
    """Return where a long answer is farthest from the expected one, as a labelled text."""
    if not isinstance(got, np.ndarray) or not isinstance(expected, np.ndarray):
        return []
    numbers = {got.dtype.kind, expected.dtype.kind} <= set("iuf")
    if not numbers or got.shape != expected.shape or got.ndim < 2 or got.size <= LEGIBLE:
        return []
    distance = np.abs(got.astype(float) - expected.astype(float))
    distance[np.isnan(got) != np.isnan(expected)] = np.inf
    distance[np.isnan(distance)] = 0  # NaN in both
    place = tuple(int(i) for i in np.unravel_index(distance.argmax(), got.shape))
    text = f"at {list(place)}: {got[place]:.6g} instead of {expected[place]:.6g}"
    return [("largest difference", text)] if distance[place] > 0 else []


def example_rows(feedback: Feedback) -> list[tuple[str, str]]:
    """Return what was tried: inputs, the answer and the expected answer, as labelled texts."""
    if feedback.case is None:
        return []
    rows = [(name, format_value(value)) for name, value in feedback.case.inputs.items()]
    got, expected, how = feedback.got, feedback.expected, ""
    if feedback.scale_free and (scaled := _of_length_1(got, expected)):
        (got, expected), how = scaled, ", of length 1"
    if got is not None:
        rows += [(f"your answer{how}", format_value(got))]
    if expected is not None:
        rows += [(f"expected{how}", format_value(expected))]
        rows += _largest_difference(got, expected)
    return rows


def summary(verdict: Verdict) -> str:
    """Return one line: what was earned, or that nothing was tried yet."""
    if not verdict.attempted:
        return f"not answered yet, {format_points(verdict.possible)} points to earn"
    return f"{format_points(verdict.points)} of {format_points(verdict.possible)} points"


def first_wrong(verdict: Verdict) -> PartVerdict | None:
    """Return the first part that is not right: its example is the next thing to look at."""
    return next((part for part in verdict.parts if mark(part.feedback) == WRONG), None)


def to_text(verdict: Verdict) -> str:
    """Write a verdict as lines of text.

    Parameters
    ----------
    verdict : Verdict
        From `judge`.

    Returns
    -------
    str
        Summary, parts, the first wrong part's example, hint and notes.
    """
    lines = [f"{verdict.exercise}: {summary(verdict)}"]
    for part in verdict.parts:
        points = f"{format_points(part.points)}/{format_points(part.possible)}"
        lines.append(f"  {mark(part.feedback)} {part.name} ({points}): {part.feedback.message}")
        for label, value in example_rows(part.feedback) if part is first_wrong(verdict) else []:
            lines.append(f"      {label} = " + value.replace("\n", "\n" + " " * (9 + len(label))))
    lines += [f"  Hint: {hint}" for hint in verdict.hints]
    lines += [f"  Note: {note}" for note in verdict.notes]
    lines += [f"  Printed: {verdict.printed.rstrip()}"] if verdict.printed else []
    return "\n".join(lines)
