"""Tables for Canvas, Moodle and nbgrader: right cells for the right people, safe to open."""

import csv
import re
from dataclasses import replace
from types import SimpleNamespace

import pytest

from course_lib.grading.export import (
    Points,
    canvas_table,
    moodle_table,
    nbgrader_table,
    remarks,
    safe,
    worksheet_table,
)
from course_lib.grading.roster import match, read_roster
from course_lib.grading.standings import Item, Standing, Standings

ITEMS = (
    Item("pinhole.one", "nb", "one-check", "one", 40.0, by_hand=False),
    Item("pinhole.why", "nb", "why", "why", 5.0, by_hand=True),
)
NAME = "01_pinhole"


def student(who, first, last, one=None, why=0.0, **more):
    points = {} if one is None else {"pinhole.one": one, "pinhole.why": why}
    return Standing(who, first, last, f"{who}@uni.example", points=points, **more)


CLASS = Standings(
    SimpleNamespace(name=NAME),
    ITEMS,
    (
        student("asa", "Åsa", "Öberg", 31.25, 4.0, handed_in=True),
        student("ana", "Ana", "García, López", 40.0, handed_in=True, waiting=("pinhole.why",)),
        student("late", "Tom", "Baker", 20.0, penalty=5.5, handed_in=True),
        student("sam", "Sam", "=1+1", 3.0, penalty=9.0, handed_in=True),
        student("cut", "Ida", "Hansen", handed_in=True),
        student("gone", "Max", "Keller"),
    ),
    due="2026-10-02 00:00:00",
)
POINTS = Points((CLASS,))


def written(tmp_path, text, encoding="utf-8"):
    path = tmp_path / "roster.csv"
    path.write_bytes(text.encode(encoding))
    return read_roster(path)


def by_name(table, column=0):
    return {row[column]: row[-1] for row in table}


def test_canvas_without_a_list_has_the_columns_that_its_importer_demands():
    header, possible, *rows = canvas_table(POINTS)
    assert header == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", NAME]
    assert possible == ["    Points Possible", "", "", "", "", "45"]
    assert [row[:5] for row in rows][:2] == [
        ["García, López, Ana", "", "", "ana", ""],
        ["Öberg, Åsa", "", "", "asa", ""],
    ]
    points = {"ana": "40", "asa": "35.25", "late": "14.5", "sam": "0", "cut": "", "gone": ""}
    assert by_name(rows, 3) == points


CANVAS = """\
\ufeffStudent;ID;SIS User ID;SIS Login ID;Section;Quiz (7);01_pinhole (4711);Final Score
;;;;;Manual Posting;;
    Points Possible;;;;;10;45;(read only)
"Öberg, Åsa";101;U1;ASA@uni.example;A;1;;
"García, López, Ana";102;U2;ana;A;1;;
"Baker, Thomas";103;U3;tbaker;B;1;;
"Nobody, Knows";104;U4;nk;B;1;;
"Student, Test";199;;;A;;;
"""


def test_canvas_list_is_matched_by_login_and_its_column_is_found(tmp_path):
    roster = written(tmp_path, CANVAS)
    assert roster.kind == "canvas"
    assert len(roster.rows) == 4
    matched = match(roster, POINTS.students)
    header, possible, *rows = canvas_table(POINTS, roster, matched)
    assert header[-1] == "01_pinhole (4711)"
    assert possible[-1] == "45"
    assert rows == [
        ["Öberg, Åsa", "101", "U1", "ASA@uni.example", "A", "35.25"],
        ["García, López, Ana", "102", "U2", "ana", "A", "40"],
    ]
    assert {s.student for s in matched.missing} == {"late", "sam", "cut", "gone"}


WORKSHEET = """\
Identifier,Full name,Email address,Status,Grade,Maximum Grade,Last modified (grade),Feedback
Participant 900,Åsa Öberg,other@uni.example,Submitted,,45.00,-,"two
lines"
Participant 901,Tom Baker,late@uni.example,Submitted,,45.00,-,
Participant 902,Max Keller,,No submission,,45.00,-,
"""


def test_moodle_worksheet_is_filled_in_and_nothing_else_changes(tmp_path):
    roster = written(tmp_path, WORKSHEET)
    matched = match(roster, POINTS.students)  # Åsa and Max by their names
    header, asa, tom, maximilian = worksheet_table(POINTS, roster, matched)
    grade = header.index("Grade")
    assert [asa[grade], tom[grade], maximilian[grade]] == ["35.25", "14.5", ""]
    assert asa[-1] == "two\nlines"
    assert [c for k, c in enumerate(tom) if k != grade] == [
        "Participant 901", "Tom Baker", "late@uni.example", "Submitted", "45.00", "-", "",
    ]  # fmt: skip


def test_a_grade_that_moodle_has_stays_where_there_is_no_other(tmp_path):
    roster = written(tmp_path, WORKSHEET.replace("No submission,,", "No submission,7.5,"))
    header, *_, maximilian = worksheet_table(POINTS, roster, match(roster, POINTS.students))
    assert maximilian[header.index("Grade")] == "7.5"


def test_only_the_assignments_own_column_of_canvas_is_taken(tmp_path):
    roster = written(tmp_path, CANVAS.replace("01_pinhole (4711)", "01_pinhole Final Points"))
    assert canvas_table(POINTS, roster, match(roster, POINTS.students))[0][-1] == NAME


def test_a_folder_may_be_named_after_moodles_participant(tmp_path):
    roster = written(tmp_path, WORKSHEET)
    assert match(roster, [student("902", "M.", "K.")]).students[2].student == "902"


def test_another_maximum_in_moodle_is_refused(tmp_path):
    roster = written(tmp_path, WORKSHEET.replace("45.00", "100"))
    with pytest.raises(ValueError, match="in Moodle the assignment has 100 points, here 45"):
        worksheet_table(POINTS, roster, match(roster, POINTS.students))


def test_moodle_list_of_grades(tmp_path):
    roster = written(tmp_path, "First name,Last name,Email address\nT.,B.,LATE@uni.example\n")
    assert moodle_table(POINTS, roster, match(roster, POINTS.students)) == [
        ["First name", "Last name", "Email address", NAME],
        ["T.", "B.", "LATE@uni.example", "14.5"],
    ]
    assert moodle_table(POINTS)[0][:4] == ["Username", "First name", "Last name", "Email address"]


def test_who_could_be_two_is_nobody(tmp_path):
    twice = "First name,Last name,Email address\nA,B,late@uni.example\nC,D,late@other.example\n"
    roster = written(tmp_path, twice)
    assert match(roster, [student("late", "Tom", "Baker")]).students == {}
    shared = [Standing("late"), Standing("tom", email="late@uni.example")]
    assert match(written(tmp_path, WORKSHEET), shared).students == {}
    same = [student("x1", "Ida", "Ek"), student("x2", "Ida", "Ek")]
    names = written(tmp_path, "First name,Last name,Email address\nIda,Ek,i@uni.example\n")
    assert match(names, same).students == {}
    known = written(tmp_path, "First name,Last name,Email address\nIda,Ek,x1@uni.example\n")
    matched = match(known, same)  # one by the address, so that the name is not the other's either
    assert matched.students == {0: same[0]}
    assert matched.missing == (same[1],)


@pytest.mark.parametrize(
    ("text", "encoding"), [("a,b\n1,2\n", "utf-8"), ("", "utf-8"), ("Vorname,ö", "latin-1")]
)
def test_another_file_is_refused_in_a_sentence(tmp_path, text, encoding):
    with pytest.raises(ValueError, match=r"Canvas's export|no text in UTF-8"):
        written(tmp_path, text, encoding)


def test_a_quotation_mark_that_never_closes_is_said(tmp_path):
    with pytest.raises(ValueError, match=r"roster\.csv cannot be read as CSV .*; export it again"):
        written(tmp_path, CANVAS + '"' + "Baker, Thomas;103\n" * 10_000)


def test_nbgraders_own_table():
    header, *rows = nbgrader_table(POINTS)
    line = dict(zip(header, rows[2], strict=True))
    assert line["student_id"] == "late"
    assert (line["raw_score"], line["late_submission_penalty"], line["score"]) == (20.0, 5.5, 14.5)
    assert (line["max_score"], line["duedate"]) == (45.0, "2026-10-02 00:00:00")
    assert dict(zip(header, rows[3], strict=True))["score"] == 0


@pytest.mark.parametrize("cell", ["=1+1", "+cmd", "-2+3", "@SUM(A1)", "\t=1", "\r=1"])
def test_no_cell_is_a_formula(cell):
    assert safe(cell) == f"'{cell}"


@pytest.mark.parametrize("cell", ["35.25", "-", "-3", "Åsa", "", "a=b", 4.5])
def test_other_cells_stay(cell):
    assert safe(cell) == cell


def test_missing_points_are_written_only_if_told():
    table = canvas_table(Points((CLASS,), missing=0.0))
    assert by_name(table[2:], 3) == {
        "ana": "40", "asa": "35.25", "late": "14.5", "sam": "0", "cut": "", "gone": "0",
    }  # fmt: skip


def test_a_chapter_that_nobody_handed_in_yet_costs_no_points():
    nobody = replace(CLASS, students=CLASS.students[-1:])
    points = Points((CLASS, nobody), missing=0.0)
    assert points.cells(CLASS.students[-1], points.classes) == ["0", ""]
    assert remarks(points)[-1] == f"{NAME}: nothing handed in, so the cell is empty: everybody."


def test_what_one_should_know_is_said():
    said = "\n".join(remarks(POINTS))
    assert re.search(r"not graded, so the cell is empty: cut\.", said)
    assert re.search(r"nothing handed in, so the cell is empty: gone\.", said)
    assert (
        "1 of 4 students have answers that wait for a person; until then they count 0, or" in said
    )
    assert "being late: late, sam" in said
    assert "an earlier one" not in said


def test_what_one_should_know_is_said_of_old_points_and_of_a_class_without_any():
    broken = replace(CLASS.students[0], record={"trouble": "The file is empty."})
    said = remarks(Points((replace(CLASS, students=(broken, *CLASS.students[1:])),)))
    assert any(s.endswith("so the points are those of an earlier one: asa.") for s in said)
    said = remarks(Points((replace(CLASS, students=CLASS.students[-1:]),)))
    assert said == [f"{NAME}: nothing handed in, so the cell is empty: everybody."]


def test_tables_are_read_back_as_they_were(tmp_path):
    path = tmp_path / "canvas.csv"
    with path.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([[safe(c) for c in row] for row in canvas_table(POINTS)])
    roster = read_roster(path)
    assert len(match(roster, POINTS.students).students) == 6
