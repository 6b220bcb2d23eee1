"""The page on a class: scores, exercises, what to say next, who needs a person, who looks alike."""

from __future__ import annotations

import statistics
from collections.abc import Sequence
from html import escape
from pathlib import Path

from course_lib.grading.alike import AlikePair
from course_lib.grading.class_people import alike, cells, person, student_table, table
from course_lib.grading.item_analysis import (
    FEWEST,
    CommonFailure,
    CommonMisconception,
    ItemAnalysis,
    analyse,
    common_failures,
    common_misconceptions,
)
from course_lib.grading.report_pictures import answer_bars, score_histogram
from course_lib.grading.standings import UNREAD, Standings
from course_lib.judging.text import format_points
from course_lib.page import html_page

STYLE = Path(__file__).with_name("report.css")
#: Misconceptions that are listed.
MOST_MISCONCEPTIONS = 12
HARD, EASY, WEAK = 0.4, 0.95, 0.1
WHAT_THE_NUMBERS_MEAN = (
    "<p><b>Mean</b> is the share of the points that the class got. <b>Discrimination</b> says "
    "whether those who do well in the other exercises do well here: it is the correlation of the "
    "points here with those of all other exercises that are graded automatically. From about 0.3 "
    "on the exercise tells students apart; near 0 it says nothing about them, often because nearly "
    "all or nearly none solve it; below 0 look for what misleads the good ones. {how_sure} "
    "<b>Seconds</b> are the median of what the answers took in the grader.</p>"
)


def class_page(standings: Standings, pairs: Sequence[AlikePair], others: float, when: str) -> str:
    """Return the page on a class.

    Parameters
    ----------
    standings : Standings
        What the class has.
    pairs : sequence of AlikePair
        Submissions that look alike.
    others : float
        How alike those are at most who are not among them.
    when : str
        The time of the report, as text.

    Returns
    -------
    str
        HTML that needs no other file; links lead to the students' pages beside it.
    """
    analyses, graded = analyse(standings), standings.graded
    name = standings.assignment.name
    parts = [
        f"<h1>{escape(name)}: report on the class</h1>",
        f"<p class='run'>{escape(when)}. For the instructor: it names students.</p>",
        _overview(standings, analyses, pairs),
        "<h2>Scores</h2>",
        score_histogram([s.score for s in graded if s.has_points], standings.possible),
        "<h2>Exercises</h2>",
        answer_bars(analyses),
        _item_table(analyses, len(graded)),
        "<h2>For the next lecture</h2>",
        _misconceptions(common_misconceptions(standings), len(graded)),
        _failures(common_failures(standings), len(graded)),
        "<h2>What needs a person</h2>",
        person(standings),
        "<h2>Alike, and worth a look</h2>",
        alike(standings, pairs, others),
        "<h2>Students</h2>",
        student_table(standings),
    ]
    return html_page(f"{name}: class", parts, STYLE.read_text("utf-8"))


def _overview(
    standings: Standings, analyses: Sequence[ItemAnalysis], pairs: Sequence[AlikePair]
) -> str:
    graded, known = standings.graded, len(standings.students)
    handed_in = sum(s.handed_in for s in standings.students)
    said = [("good", f"{known} students, {handed_in} handed in, {len(graded)} graded.")]
    if scores := [s.score for s in graded if s.has_points]:
        middle = format_points(statistics.median(scores))
        of = format_points(standings.possible)
        said.append(("good", f"Half of the class has {middle} of {of} points or more."))
    if waiting := sum(len(s.waiting) for s in graded):
        said.append(("note", f"{waiting} answers wait for a person; {UNREAD}."))
    if troubled := sum(bool(s.trouble) for s in standings.students):
        said.append(("bad", f"{_students(troubled)} handed in what cannot be graded."))
    if all(item.by_hand for item in standings.items):
        said.append(("note", "All points are given by a person."))
    elif unknown := sum(not (s.record.get("exercises") or s.trouble) for s in graded):
        text = f"Of {_students(unknown)} only the points are known: not graded by course grade."
        said.append(("note", text))
    remarks = [_remark(analysis) for analysis in analyses]
    said += [("note", remark) for remark in remarks if remark]
    if pairs:
        said.append(("note", f"{_pairs(len(pairs))} of submissions look alike: see below."))
    items = "\n".join(f"<li class='{level}'>{escape(text)}</li>" for level, text in said)
    return f"<ul class='statements'>{items}</ul>"


def _remark(analysis: ItemAnalysis) -> str:
    """Say what is unusual about an exercise; nothing if there is nothing."""
    name, mean, told = analysis.item.short_name, analysis.difficulty, analysis.discrimination
    if mean is None or analysis.count < FEWEST:
        return ""
    if told is not None and told < 0:
        return f"{name}: students who do well elsewhere do worse here ({told:.2f}). What misleads?"
    if mean < HARD:
        return f"{name} is hard: {mean:.0%} of its points were earned."
    if mean < EASY and told is not None and told < WEAK:
        return f"{name} hardly tells students apart ({told:.2f})."
    return ""


def _item_table(analyses: Sequence[ItemAnalysis], count: int) -> str:
    rows = []
    for a in analyses:
        mean = "–" if a.difficulty is None else f"{a.difficulty:.0%}"
        told = "–" if a.discrimination is None else f"{a.discrimination:.2f}"
        seconds = "–" if a.seconds is None else f"{a.seconds:.2f}"
        by_hand = " (in words)" if a.item.by_hand else ""
        untried = a.states["not tried"] + a.states["not reached"]
        recorded = sum(a.states.values())
        rows.append(
            f"<tr><th scope='row'>{escape(a.item.short_name)}{by_hand}</th>"
            + cells(a.count, format_points(a.item.possible), mean, told)
            + (cells(untried, a.states["error"], seconds) if recorded else cells("–", "–", "–"))
            + "</tr>"
        )
    heads = ("students", "points", "mean", "discrimination", "not tried", "error", "seconds")
    head = "<th>exercise</th>" + "".join(f"<th class='number'>{h}</th>" for h in heads)
    how_sure = (
        f"With {count} students it is known to about ±{1 / max(count, 1) ** 0.5:.1f}."
        if count >= FEWEST
        else f"It is given from {FEWEST} students on."
    )
    meaning = WHAT_THE_NUMBERS_MEAN.format(how_sure=how_sure)
    return table(head, rows) + meaning


def _misconceptions(said: Sequence[CommonMisconception], count: int) -> str:
    if not said:
        return "<p>No known misconception was found.</p>"
    items = "".join(
        f"<li><b>{escape(m.exercise.rpartition('.')[2])}</b>: {escape(m.name.replace('_', ' '))} – "
        f"{len(m.students)} of {count} students, {format_points(m.points_lost)} points lost."
        f"<q>They read: {escape(m.hint)}</q></li>"
        for m in said[:MOST_MISCONCEPTIONS]
    )
    left = said[MOST_MISCONCEPTIONS:]
    more = (
        f"<p>{len(left)} more, of at most {_students(len(left[0].students))} each.</p>"
        if left
        else ""
    )
    intro = "<p>Misconceptions behind wrong answers, those of most students first.</p>"
    return f"{intro}<ol class='lecture'>{items}</ol>{more}"


def _failures(said: Sequence[CommonFailure], count: int) -> str:
    if not said:
        return ""
    items = "".join(
        f"<li><b>{escape(f.name)}</b> – {format_points(f.points_lost)} points lost by "
        f"{len(f.students)} of {count} students"
        f"<q>{', '.join(_points_in(*one) for one in f.lost.items())}</q></li>"
        for f in said
    )
    intro = "<p>Points lost without a known misconception, the most first.</p>"
    return f"{intro}<ol class='lecture'>{items}</ol>"


def _points_in(exercise: str, points: float) -> str:
    return f"{escape(exercise.rpartition('.')[2])}&nbsp;{format_points(points)}"


def _pairs(count: int) -> str:
    return f"{count} pair{'' if count == 1 else 's'}"


def _students(count: int) -> str:
    return f"{count} student{'' if count == 1 else 's'}"
