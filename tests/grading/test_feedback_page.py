from course_lib.grading.feedback_page import name_exercises


def test_contents_name_the_exercise():
    line = '<li><a href="#pinhole-dolly_zoom-check">Test cell</a> (Score: 4.0 / 4.0)</li>'
    assert name_exercises(line) == (
        '<li><a href="#pinhole-dolly_zoom-check"><code>pinhole.dolly_zoom</code></a> '
        "(Score: 4.0 / 4.0)</li>"
    )


def test_other_pages_stay_as_they_are():
    for page in ("", "<p>Test cell</p>", '<a href="#top">Test cell</a>'):
        assert name_exercises(page) == page
