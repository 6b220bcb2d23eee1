"""What `course grade` says while it works."""

import io
import re

from course_lib.grading.one import Graded
from course_lib.grading.summary import Progress


class Terminal(io.StringIO):
    """A stream that shows a line in place of the one before."""

    def isatty(self):
        return True


def test_on_a_terminal_a_line_says_how_far_it_is_and_how_long_it_takes(monkeypatch):
    now, stream = iter([0.0, 50.0, 60.0, 90.0, 90.0]), Terminal()
    monkeypatch.setattr("time.monotonic", lambda: next(now))
    progress = Progress(3, stream)
    progress.step(Graded("ada", ""))
    progress.step(Graded("ben", "", "The file is empty."))
    progress.step(Graded("eve", ""))
    progress.end()
    said = [part.strip() for part in re.split(r"[\r\n]+", stream.getvalue()) if part.strip()]
    assert said == [
        "1 of 3 graded, about 1:40 min left",
        "2 of 3 graded, about 0:30 min left",
        "ben: not graded",
        "3 of 3 graded, about 0:00 min left",
        "3 graded in 1:30 min, 30.00 s each",
    ]


def test_in_a_file_a_line_comes_now_and_then(monkeypatch):
    now, stream = iter([0.0, 10.0, 20.0, 30.0, 40.0]), io.StringIO()
    monkeypatch.setattr("time.monotonic", lambda: next(now))
    progress = Progress(4, stream)
    for student in ("ada", "ben", "eve", "tom"):
        progress.step(Graded(student, ""))
    progress.end()
    assert stream.getvalue() == "2 of 4 graded, about 0:20 min left\n"
