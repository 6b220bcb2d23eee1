"""The text of a lesson, what it says, and the numbers that it and its explorers print."""

from pathlib import Path

import pytest

LESSONS = Path(__file__).parents[2] / "lessons"


class LessonText(str):
    """A lesson as it is written."""

    def says(self, *parts):
        """Assert that the text contains each part."""
        for part in parts:
            assert part in self, f"the lesson does not say {part!r}"


def lesson_text(name):
    """Return the text of a lesson, e.g. of ``"01_pinhole"``."""
    return LessonText((LESSONS / f"{name}.md").read_text(encoding="utf-8"))


def about(value, digits):
    """Return what agrees with a printed number of so many decimals."""
    return pytest.approx(value, abs=0.5001 * 10.0**-digits)


def readout(frame, label):
    """Return what an explorer's frame shows under a label."""
    (found,) = (r for r in frame.readouts if r.label == label)
    return found.value


def read(frame, label):
    """Return the number that an explorer's frame shows under a label."""
    text = readout(frame, label).removeprefix("± ")
    return float(text.replace("−", "-").replace("∞", "inf").replace("–", "nan"))
