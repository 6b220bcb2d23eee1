"""The text of a lesson, and what it says."""

from pathlib import Path

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
