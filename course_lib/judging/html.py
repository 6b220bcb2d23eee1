"""A verdict as a small block of HTML, legible in light and dark themes and without colour."""

from __future__ import annotations

from html import escape
from pathlib import Path

from course_lib.judging.text import (
    WRONG,
    example_rows,
    first_wrong,
    format_points,
    mark,
    summary,
)
from course_lib.judging.verdict import PartVerdict, Verdict

STYLE = Path(__file__).with_name("verdict.css").read_text(encoding="utf-8")


def to_html(verdict: Verdict) -> str:
    """Write a verdict as one block of HTML with its own style.

    Parameters
    ----------
    verdict : Verdict
        From `judge`.

    Returns
    -------
    str
        A ``<section>``; everything that came from a student is escaped.
    """
    full = verdict.points >= verdict.possible
    state = "right" if full else "wrong" if verdict.attempted else "open"
    function = escape(verdict.exercise.rpartition(".")[2])
    parts = "".join(map(_part, verdict.parts))
    asides = [*map(_hint, verdict.hints), *map(_note, verdict.notes)]
    extras = [*asides, _example(first_wrong(verdict)), _printed(verdict)]
    return (
        f"<style>{STYLE}</style>"
        f'<section class="course-verdict {state}" aria-label="Result of {function}">'
        f"<header><code>{function}</code><b>{escape(summary(verdict))}</b></header>"
        f"<ul>{parts}</ul>{''.join(extras)}</section>"
    )


def _part(part: PartVerdict) -> str:
    sign = mark(part.feedback)
    state = {"✓": "right", WRONG: "wrong"}.get(sign, "open")
    message = (
        "" if state == "right" else f'<span class="message">{_text(part.feedback.message)}</span>'
    )
    word = {"right": "right", "wrong": "not right", "open": "not answered"}[state]
    return (
        f'<li class="{state}"><span class="sign" role="img" aria-label="{word}">{sign}</span>'
        f"<span>{escape(part.name)}</span>"
        f'<span class="earned">{format_points(part.points)}/{format_points(part.possible)}</span>'
        f"{'' if state == 'right' else message}</li>"
    )


def _text(message: str) -> str:
    """Escape a sentence and set what stands between back-ticks as code."""
    pieces = escape(message).split("`")
    return "".join(f"<code>{p}</code>" if i % 2 else p for i, p in enumerate(pieces))


def _hint(hint: str) -> str:
    return f'<p class="hint"><b>Hint.</b> {_text(hint)}</p>'


def _note(note: str) -> str:
    return f'<p class="note"><b>Note.</b> {_text(note)}</p>'


def _example(part: PartVerdict | None) -> str:
    """Show inputs, answer and truth of a wrong part; open, because it is the next step."""
    rows = example_rows(part.feedback) if part else []
    if not part or not rows:
        return ""
    body = "".join(
        f"<tr><th scope='row'>{escape(label)}</th><td><pre>{escape(value)}</pre></td></tr>"
        for label, value in rows
    )
    title = f"What was tried for <i>{escape(part.name)}</i>"
    return f"<details open><summary>{title}</summary><table>{body}</table></details>"


def _printed(verdict: Verdict) -> str:
    if not verdict.printed:
        return ""
    return (
        "<details><summary>What the function printed</summary>"
        f"<pre>{escape(verdict.printed.rstrip())}</pre></details>"
    )
