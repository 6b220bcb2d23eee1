"""What pages say of a class, whatever it is called and however few there are."""

import html
import re
from types import SimpleNamespace

import pytest

from course_lib.grading.class_page import class_page
from course_lib.grading.report_pictures import score_histogram
from course_lib.grading.standings import Item, Standing, Standings
from course_lib.grading.student_page import student_page

ITEMS = (
    Item("pinhole.one", "nb", "one-check", "one", 4.0, by_hand=False),
    Item("pinhole.two", "nb", "two-check", "two", 4.0, by_hand=False),
)
BAD = "<script>alert('x')</script>"


def standings(*students):
    return Standings(SimpleNamespace(name="01_nb"), ITEMS, students)


def student(who, one, two, **more):
    points = {"pinhole.one": one, "pinhole.two": two}
    return Standing(who, points=points, handed_in=True, **more)


def text_of(page):
    return " ".join(html.unescape(re.sub(r"<[^>]+>", " ", page)).split())


def test_nothing_that_a_student_wrote_is_html():
    record = {"trouble": BAD, "notes": [BAD], "exercises": {}}
    bad = student("s1", 1.0, 2.0, first_name=BAD, record=record, comments={"one": BAD})
    written = "def one():\n    return " + BAD
    cells = {"one-check": {"source": BAD, "outputs": []}, "one": {"source": written}}
    for page in (
        class_page(standings(bad), [], 0.0, "now"),
        student_page(standings(bad), bad, cells),
    ):
        assert "<script" not in page
        assert html.escape(BAD) in page


def test_only_a_check_of_the_course_is_shown_as_a_verdict():
    forged = {"output_type": "display_data", "data": {"text/html": ["<b>all right</b>"]}}
    cells = {"one-check": {"source": ["print('mine')"], "outputs": [forged]}}
    page = student_page(standings(student("s1", 0.0, 0.0)), student("s1", 0.0, 0.0), cells)
    assert "all right" not in page
    cells["one-check"]["source"] = ['check("pinhole.one")']
    assert "all right" in student_page(standings(), student("s1", 0.0, 0.0), cells)


def test_a_class_without_students_or_points_has_a_page():
    for class_ in (standings(), standings(Standing("s1", handed_in=True))):
        text = text_of(class_page(class_, [], 0.0, "now"))
        assert "Nobody has points yet." in text
        assert "No known misconception was found." in text
    assert "s1 : not graded yet; run course grade." in text


def test_points_that_no_misconception_explains_are_listed_for_the_lecture():
    lost = {"points": 0.0, "possible": 4.0, "parts": {"all": "type"}, "causes": {"all": "None"}}
    both = {"exercises": {"pinhole.one": lost | {"points": 3.0}, "pinhole.two": lost}}
    class_ = standings(*(student(who, 0.0, 0.0, record=both) for who in ("s1", "s2")))
    text = text_of(class_page(class_, [], 0.0, "now"))
    assert "No known misconception was found." in text
    assert "no value returned – 10 points lost by 2 of 2 students two 8, one 2" in text


def test_what_is_unusual_is_said():
    strong = [student(f"a{k}", 0.0, 4.0) for k in range(6)]
    weak = [student(f"b{k}", 4.0, 0.0) for k in range(6)]
    text = text_of(class_page(standings(*strong, *weak), [], 0.0, "now"))
    assert "one: students who do well elsewhere do worse here (-1.00). What misleads?" in text
    same = [student(f"a{k}", 1.0, 4.0) for k in range(12)]
    assert "one is hard: 25% of its points" in text_of(class_page(standings(*same), [], 0, "now"))
    few = text_of(class_page(standings(*same[:9]), [], 0.0, "now"))
    assert "is hard" not in few
    assert "It is given from 10 students on." in few


def test_an_earlier_version_keeps_its_points_and_its_page_says_so():
    record = {"trouble": "The file is empty."}
    late = student("s1", 4.0, 1.0, record=record)
    text = text_of(class_page(standings(late), [], 0.0, "now"))
    assert "those of an earlier version" in text
    assert "only the points are known" not in text
    assert "only the points" in text_of(class_page(standings(student("s2", 1, 1)), [], 0.0, "now"))
    assert "could not be graded" in text_of(student_page(standings(late), late, {}))


@pytest.mark.parametrize(("scores", "bar"), [([0.0], 0), ([8.0], 9), ([9.5], 9), ([4.0], 5)])
def test_every_score_is_in_a_bar(scores, bar):
    heights = re.findall(r"<rect [^>]*height='([\d.]+)'", score_histogram(scores, 8.0))
    assert [float(h) > 0 for h in heights] == [k == bar for k in range(10)]
