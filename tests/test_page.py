"""A page needs nothing but itself, and shows text as text."""

from course_lib.page import html_page, svg


def test_a_page_holds_its_style_and_escapes_its_title():
    page = html_page("<Ada> & Co", ["<p>one</p>", "<p>two</p>"], "p { color: red }")
    assert page.startswith("<!doctype html>")
    assert "<title>&lt;Ada&gt; &amp; Co</title>" in page
    assert "max-width" in page
    assert "p { color: red }" in page
    assert page.index("<p>one</p>") < page.index("<p>two</p>")
    assert "<script" not in page


def test_a_drawing_says_what_it_shows():
    drawn = svg("0 0 4 3", "<circle r='1'/>", "one 'circle'")
    assert "viewBox='0 0 4 3'" in drawn
    assert "aria-label='one &#x27;circle&#x27;'" in drawn
