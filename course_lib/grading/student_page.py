"""The page on one student: points, what was right, hints; never hidden inputs, never others."""

from __future__ import annotations

import re
from collections.abc import Mapping
from html import escape
from pathlib import Path
from typing import Any

from course_lib.grading.planning import CHECK
from course_lib.grading.standings import Item, Standing, Standings
from course_lib.judging.html import STYLE as VERDICT_STYLE
from course_lib.judging.text import format_points
from course_lib.page import html_page

STYLE = Path(__file__).with_name("report.css")
_OWN_STYLE = re.compile(r"<style>.*?</style>", re.DOTALL)


def student_page(standings: Standings, student: Standing, cells: Mapping[str, Any]) -> str:
    """Return the page on one student, to be sent to this student.

    Parameters
    ----------
    standings : Standings
        What the class has; nothing of the others is told.
    student : Standing
        Whose page.
    cells : mapping of str to mapping
        The cells of the graded notebooks by label, from `graded_cells`.

    Returns
    -------
    str
        HTML that needs no other file.
    """
    name = standings.assignment.name
    parts = [f"<h1>{escape(name)}: {escape(student.full_name)}</h1>", _total(standings, student)]
    if student.trouble:
        parts.append(
            "<p>What you handed in last could not be graded; the points are those of an earlier "
            f"version. {escape(student.trouble)}</p>"
        )
    parts.append(_table(standings, student))
    for item in standings.items:
        parts += [f"<h2>{escape(item.short_name)}</h2>", _feedback(item, student, cells)]
    style = STYLE.read_text("utf-8") + VERDICT_STYLE
    return html_page(f"{name}: {student.full_name}", parts, style)


def _total(standings: Standings, student: Standing) -> str:
    of = format_points(standings.possible)
    if not student.has_points:
        return f"<p><b>Not read yet.</b> There are {of} points.</p>"
    said = f"<b>{format_points(student.score)} of {of} points.</b>"
    if student.penalty:
        said += f" {format_points(student.penalty)} points were taken off because it came late."
    return f"<p>{said}</p>"


def _table(standings: Standings, student: Standing) -> str:
    rows = []
    for item in standings.items:
        points = student.points.get(item.name)
        waits = points is None or item.name in student.waiting
        shown = "not read yet" if waits else format_points(points or 0.0)
        rows.append(
            f"<tr><td>{escape(item.short_name)}</td><td class='number'>{shown}</td>"
            f"<td class='number'>{format_points(item.possible)}</td></tr>"
        )
    head = "<th>exercise</th><th class='number'>points</th><th class='number'>of</th>"
    return f"<table class='marks'><thead><tr>{head}</tr></thead>{''.join(rows)}</table>"


def _feedback(item: Item, student: Standing, cells: Mapping[str, Any]) -> str:
    """Return what is said about one answer: a verdict, or the words and a person's comment."""
    parts = []
    if item.by_hand:
        written = _source(cells.get(item.answer)).strip()
        words = f"<blockquote>{escape(written)}</blockquote>" if written else "<p>No answer.</p>"
        parts.append(f"<p>Your answer:</p>{words}")
    else:
        parts.append(_verdict(cells.get(item.check)))
        parts.append(_changed_by_hand(item, student))
    labels = dict.fromkeys((item.answer, item.check))
    said = [student.comments[label] for label in labels if label in student.comments]
    parts += [f"<p>Comment:</p><blockquote>{escape(text)}</blockquote>" for text in said]
    return f"<div class='verdict'>{''.join(parts)}</div>"


def _changed_by_hand(item: Item, student: Standing) -> str:
    """Say so if the points are others than the check gave."""
    found = student.record.get("exercises", {}).get(item.name, {})
    points = student.points.get(item.name)
    if points is None or not found or points == found["points"]:
        return ""
    return f"<p>A person looked at this and gave {format_points(points)} points.</p>"


def _verdict(cell: Any) -> str:
    """Return the verdict that the grader wrote into a check; its own style comes only once."""
    if cell is None or not CHECK.fullmatch(_source(cell)):
        return "<p>There is no verdict.</p>"
    for output in cell.get("outputs", ()):
        if output["output_type"] == "error":  # the check was not reached
            return f"<p>{escape(output['evalue'])}</p>"
        if page := _text(output.get("data", {}).get("text/html", "")):
            return _OWN_STYLE.sub("", page)
    return "<p>There is no verdict.</p>"


def _source(cell: Any) -> str:
    return "" if cell is None else _text(cell["source"])


def _text(lines: str | list[str]) -> str:
    """Return a text of a notebook's file, which may be written as lines."""
    return lines if isinstance(lines, str) else "".join(lines)
