"""A verdict as plain text: for terminals, reports, and readers of the notebook without HTML."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib.judging.verdict import Feedback, PartVerdict, Verdict

MARKS = {"right": "✓", "not attempted": "○"}
WRONG = "✗"
#: Numbers in a stack of pictures from which on only their shape and range are shown.
LEGIBLE = 300


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
    if isinstance(value, np.ndarray) and value.ndim > 2 and value.size > LEGIBLE:
        range_ = f"from {value.min():.6g} to {value.max():.6g}"
        return f"an array of shape {value.shape}, {value.dtype}, {range_}"
    with np.printoptions(precision=5, suppress=True, threshold=24, edgeitems=3, linewidth=72):
        if isinstance(value, np.ndarray):
            return str(value)
        if isinstance(value, tuple | list):
            return "(" + ", ".join(format_value(item) for item in value[:12]) + ")"
        text = repr(value)
    return text if len(text) <= 300 else text[:300] + " …"


def example_rows(feedback: Feedback) -> list[tuple[str, str]]:
    """Return what was tried: inputs, the answer and the expected answer, as labelled texts."""
    if feedback.case is None:
        return []
    rows = [(name, format_value(value)) for name, value in feedback.case.inputs.items()]
    if feedback.got is not None:
        rows += [("your answer", format_value(feedback.got))]
    if feedback.expected is not None:
        rows += [("expected", format_value(feedback.expected))]
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
