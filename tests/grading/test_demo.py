"""`course demo`: a term with a simulated class, its report and its tables, by real commands."""

import contextlib
import csv
import html
import re
import shutil
from types import SimpleNamespace

import nbformat
import numpy as np
import pytest
from nbgrader.api import Gradebook
from nbgrader.plugins import CsvExportPlugin
from small_course import run, write_course
from walls import walled

from course_lib.authoring.expansion import check_id
from course_lib.cli import main
from course_lib.grading.assignment import read_assignment
from course_lib.grading.demo import SEED
from course_lib.grading.export import Points, nbgrader_table
from course_lib.grading.report import write_report
from course_lib.grading.seeding import grading_seed, read_key
from course_lib.grading.standings import read_standings
from data_generators.everyday_class import everyday_class

pytestmark = [pytest.mark.slow, walled]
CHAPTER, SIZE = "01_pinhole", 12


@pytest.fixture(scope="module")
def shown(tmp_path_factory):
    base = tmp_path_factory.mktemp("demo")
    course = write_course(base / "course")
    done = run("course", "demo", base / "term", "--students", SIZE, cwd=course)
    assert done.returncode == 0, done.stderr
    released = nbformat.read(base / f"term/release/{CHAPTER}/{CHAPTER}.ipynb", as_version=4)
    members = everyday_class(released, "pinhole", SIZE, np.random.default_rng(SEED))
    page = (base / f"term/report/{CHAPTER}/index.html").read_text(encoding="utf-8")
    yield SimpleNamespace(term=base / "term", said=done.stdout, members=members, page=page)
    shutil.rmtree(base)


@pytest.fixture(scope="module")
def standings(shown):
    return read_standings(read_assignment(shown.term, CHAPTER))


def student_page(shown, who):
    path = shown.term / f"report/{CHAPTER}/students/{who}.html"
    return path.read_text(encoding="utf-8")


def test_it_says_what_it_runs_and_where_to_look(shown):
    for command in ("course term", "nbgrader generate_assignment", "course grade", "course report"):
        assert f"$ {command}" in shown.said
    places = re.findall(r"^  (/\S+)$", shown.said, re.MULTILINE)
    assert len(places) == 4
    assert all((shown.term / place).exists() for place in places)


def test_everybody_has_exactly_the_points_that_the_answers_are_worth(shown, standings):
    got = {s.student: s.points for s in standings.students}
    for member in shown.members:
        if member.submission is None or member.submission.points is None:
            assert got[member.id] == {}
        else:
            expected = member.submission.points
            assert {name: got[member.id][name] for name in expected} == expected


def test_points_do_not_depend_on_whose_hidden_numbers_are_asked(shown, standings):
    (copy,) = [m for m in shown.members if m.copied_from]
    points = {s.student: s.points for s in standings.students}
    own, source = points[copy.id], points[copy.copied_from]
    functions = [item.name for item in standings.items if not item.by_hand]
    functions.remove("pinhole.data_sheet")
    assert {name: own[name] for name in functions} == {name: source[name] for name in functions}
    key = read_key(shown.term / "grading.key")
    assert len({grading_seed(key, who, CHAPTER) for who in points}) == SIZE


def test_the_class_page_needs_nothing_else_and_names_what_there_is(shown):
    text = html.unescape(re.sub(r"<[^>]+>", "", shown.page))
    assert not re.search(r"<script|src=|@import|url\(|https?://", shown.page)
    assert f"{SIZE} students, {SIZE - 1} handed in, {SIZE - 2} graded." in text
    assert "Ana García, López: The notebook's file is damaged" in text
    pictures = re.findall(r"<svg[^>]*aria-label='([^']+)'", shown.page)
    assert len(pictures) == 2
    assert "best_pinhole_diameter" in pictures[1]
    links = re.findall(r"href='([^']+)'", shown.page)
    assert {*links} == {f"students/{m.id}.html" for m in shown.members if has_points(m)}


def has_points(member):
    return member.submission is not None and member.submission.points is not None


def test_the_page_shows_misconceptions_with_their_hints_in_order(shown, standings):
    counts = [int(n) for n in re.findall(r"– (\d+) of \d+ students?,", shown.page)]
    assert counts == sorted(counts, reverse=True)
    hints = re.findall(r"They read: ([^<]+)<", shown.page)
    typed = {hint for m in shown.members if has_points(m) for hint in m.submission.hints}
    assert hints
    assert {html.unescape(hint) for hint in hints} <= typed


def test_the_copy_is_shown_beside_its_source_and_nobody_else(shown):
    (copy,) = [m for m in shown.members if m.copied_from]
    listed = re.findall(
        r"<summary><b><a[^>]*/(\w+)\.html[^>]*>[^<]*</a> and <a[^>]*/(\w+)\.", shown.page
    )
    assert listed == [(copy.copied_from, copy.id)]
    assert shown.page.count("<mark>") > 6


def test_a_student_reads_hints_and_nothing_that_is_hidden(shown):
    key = read_key(shown.term / "grading.key")
    members = [m for m in shown.members if has_points(m)]
    for member in members:
        page = student_page(shown, member.id)
        text = html.unescape(page)
        assert [
            hint for hint in member.submission.hints if hint not in re.sub("</?code>", "`", text)
        ] == []
        assert grading_seed(key, member.id, CHAPTER) not in text
        assert "What was tried" not in text
        assert [m.last_name for m in members if m is not member and m.last_name in text] == []


def test_tables_are_nbgraders_scores_with_penalties_and_points_by_hand(shown, standings, tmp_path):
    assignment = standings.assignment
    late = next(m.id for m in shown.members if m.is_late)
    first = next(m.id for m in shown.members if has_points(m))
    with Gradebook(assignment.db_url) as gradebook:
        (notebook,) = gradebook.find_submission(CHAPTER, late).notebooks
        notebook.late_submission_penalty = 2.5
        grade = gradebook.find_grade(check_id("pinhole.dolly_zoom"), CHAPTER, CHAPTER, first)
        grade.manual_score, grade.extra_credit, grade.needs_manual_grade = 1.5, 0.25, False
        comment = gradebook.find_comment("pinhole-dolly_zoom", CHAPTER, CHAPTER, first)
        comment.manual_comment = "A <good> idea."
        gradebook.db.commit()
        CsvExportPlugin(to=str(tmp_path / "theirs.csv")).export(gradebook)
    changed = read_standings(assignment)
    header, *rows = nbgrader_table(Points((changed,)))
    ours = {row[3]: row[-4:] for row in rows}
    with (tmp_path / "theirs.csv").open(encoding="utf-8") as file:
        theirs = list(csv.reader(file))
    assert header == tuple(theirs[0])
    for row in theirs[1:]:
        assert ours[row[3]] == pytest.approx([float(cell) for cell in row[-4:]])
    assert sum(ours[late][1:2]) == 2.5
    write_report(changed)
    page = student_page(shown, first)
    assert "A person looked at this and gave 1.75 points." in page
    assert "A &lt;good&gt; idea." in page
    assert "2.5 points were taken off" in student_page(shown, late)


def test_with_a_list_of_canvas_only_its_students_are_written(shown, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(shown.term)
    roster = tmp_path / "canvas.csv"
    lines = ["Student,ID,SIS Login ID,Section", '"Öberg, Åsa",77,s01,A', "Else,78,s99,A"]
    roster.write_text("\n".join(lines), encoding="utf-8")
    assert main(["export", CHAPTER, "--roster", str(roster)]) == 1
    said = capsys.readouterr().out
    assert "but not in the gradebook: Else." in said
    assert re.search(r"not for certain, and so not written: s02, s03, .*s12\.", said)
    with (shown.term / "export/canvas.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))
    assert [row[:2] for row in rows[2:]] == [["Öberg, Åsa", "77"]]


@pytest.mark.parametrize(
    ("typed", "sentence"),
    [
        (["demo", "--chapter", "1"], "no chapter '1'; there are 00_welcome"),
        (["demo", "--students", "0"], "expected a number from 1"),
        (["report", "99_none"], "there is no assignment '99_none' in the gradebook"),
        (["export", "--roster", "nowhere.csv"], "nowhere.csv"),
        (["report", "--term", "/"], "there is no assignment in /release"),
    ],
)
def test_errors_say_what_to_do(shown, typed, sentence, monkeypatch, capsys):
    monkeypatch.chdir(shown.term)
    with contextlib.suppress(SystemExit):  # argparse's own way
        assert main(typed) == 2
    assert sentence in capsys.readouterr().err
