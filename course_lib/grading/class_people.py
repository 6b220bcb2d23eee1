"""Parts of the page on a class that name students: who needs a person, who looks alike, points."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from urllib.parse import quote

from course_lib.grading.alike import AlikePair
from course_lib.grading.standings import Item, Standing, Standings
from course_lib.judging.text import format_points

#: Names in one list.
MOST_NAMES = 20


def person(standings: Standings) -> str:
    """Return what a person must do: answers to read, files that cannot be graded, oddities."""
    parts = []
    for item in standings.items:
        who = [s for s in standings.graded if item.name in s.waiting]
        if who:
            names = ", ".join(_link(s) for s in who[:MOST_NAMES])
            names += f" and {len(who) - MOST_NAMES} more" if len(who) > MOST_NAMES else ""
            text = f"<b>{escape(item.short_name)}</b>: {len(who)} to read, in formgrader. {names}"
            parts.append(("note", text))
    for student in standings.students:
        if student.trouble:
            earlier = " The points are those of an earlier version." if student.is_graded else ""
            text = f"<b>{escape(student.full_name)}</b>: {escape(student.trouble)}{earlier}"
            parts.append(("bad", text))
        elif student.handed_in and not student.is_graded:
            text = f"<b>{escape(student.full_name)}</b>: not graded yet; run course grade."
            parts.append(("bad", text))
        if notes := student.record.get("notes"):
            parts.append(("note", f"{_link(student)}: {escape('; '.join(map(str, notes)))}"))
    if not parts:
        return "<p>Nothing.</p>"
    items = "".join(f"<li class='{level}'>{text}</li>" for level, text in parts)
    return f"<ul class='statements'>{items}</ul>"


def alike(standings: Standings, pairs: Sequence[AlikePair], others: float) -> str:
    """Return the submissions that look alike, side by side, and what that does not mean."""
    names = {student.student: student for student in standings.students}
    rest = f" All others have at most {others:.0%} in common." if others else ""
    how = (
        "<p>Compared are the steps of answers in code, whatever names, comments and line breaks "
        "they have. What most of the class writes counts little, and short answers must look "
        "alike. Working together, a common source or chance can be the reason as well: this is a "
        f"reason to look, and no proof.{rest}</p>"
    )
    if not pairs:
        return f"<p>No two submissions are alike nearly everywhere.</p>{how}"
    parts = [how]
    for pair in pairs:
        one, other = (names[who] for who in pair.students)
        both = f"<b>{_link(one)} and {_link(other)}</b>: {pair.share:.0%} of the smaller submission"
        answers = _beside(pair, one.full_name, other.full_name)
        parts.append(f"<details open><summary>{both}</summary>{answers}</details>")
    return "".join(parts)


def _beside(pair: AlikePair, one: str, other: str) -> str:
    """Show the answers of two students side by side, with what both have marked."""
    boxes = []
    for answer in pair.answers:
        shown = zip((one, other), answer.sources, answer.lines, strict=True)
        for name, source, lines in shown:
            title = f"{escape(name)}, <code>{escape(answer.cell)}</code>"
            boxes.append(f"<div>{title}<pre>{_marked(source, lines)}</pre></div>")
    return f"<div class='beside'>{''.join(boxes)}</div>"


def _marked(source: str, lines: frozenset[int]) -> str:
    """Return an answer without its docstring, with some lines marked."""
    rows, quoted = [], False
    for number, row in enumerate(source.splitlines()):
        fences = row.count('"""')
        if not quoted and not fences:
            text = escape(row)
            rows.append(f"<mark>{text}</mark>" if number in lines and row.strip() else text)
        quoted ^= fences % 2 == 1
    return "\n".join(rows)


def student_table(standings: Standings) -> str:
    """Return a table of all students and their points."""
    if not standings.students:
        return "<p>There are none.</p>"
    heads = "".join(
        f"<th class='number'><abbr title='{escape(item.short_name, quote=True)}'>{k}</abbr></th>"
        for k, item in enumerate(standings.items, 1)
    )
    head = f"<th>student</th><th class='number'>points</th><th class='number'>late</th>{heads}"
    order = sorted(standings.students, key=_by_name)
    rows = [_student_row(student, standings) for student in order]
    key = ", ".join(f"{k} {escape(i.short_name)}" for k, i in enumerate(standings.items, 1))
    return f"<p class='run'>{key}; ? waits for a person.</p>{table(head, rows)}"


def _by_name(student: Standing) -> tuple[str, str, str]:
    return student.last_name.casefold(), student.first_name.casefold(), student.student


def _student_row(student: Standing, standings: Standings) -> str:
    penalty = f"−{format_points(student.penalty)}" if student.penalty else ""
    late = penalty or ("yes" if student.seconds_late > 0 else "")
    total = format_points(student.score) if student.has_points else "–"
    marks = "".join(_mark(student, item) for item in standings.items)
    return f"<tr><td>{_link(student)}</td>{cells(total, late)}{marks}</tr>"


def _mark(student: Standing, item: Item) -> str:
    points = student.points.get(item.name)
    if item.name in student.waiting:
        return "<td class='number waits'>?</td>"
    if points is None:
        return "<td></td>"
    kind = "full" if points >= item.possible else "" if points else "none"
    return f"<td class='number {kind}'>{format_points(points)}</td>"


def _link(student: Standing) -> str:
    """Return a student's name as a link to the page; the name alone where there is none."""
    name = escape(student.full_name)
    if not student.is_graded:
        return name
    return f"<a href='students/{quote(student.student)}.html'>{name}</a>"


def cells(*values: object) -> str:
    """Return cells of numbers."""
    return "".join(f"<td class='number'>{value}</td>" for value in values)


def table(head: str, rows: Iterable[str]) -> str:
    """Return a table that scrolls where it is too wide."""
    body = "".join(rows)
    return (
        f"<div class='scroll'><table class='marks'><thead><tr>{head}</tr></thead>"
        f"<tbody>{body}</tbody></table></div>"
    )
