"""What a lesson must keep to, checked before anything is built from it."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from course_lib.authoring.expansion import expand
from course_lib.authoring.lesson import Lesson, LessonCell, LessonError, read_lesson
from course_lib.exercises import all_exercises

#: Lines of a code cell: what a student can take in at a glance.
LONGEST_CELL = 15

_MARKDOWN_IMAGE = re.compile(r"!\[(?P<alt>[^\]]*)\]\((?P<target>[^)\s]+)[^)]*\)")
_HTML_IMAGE = re.compile(r"<img\b[^>]*>", re.IGNORECASE)
_FENCED = re.compile(r"^(```|~~~).*?^\1", re.DOTALL | re.MULTILINE)


def lint(path: Path) -> list[LessonError]:
    """Say what is not right with a lesson.

    Parameters
    ----------
    path : pathlib.Path
        ``lessons/NN_topic.md``.

    Returns
    -------
    list of LessonError
        Each with its file and line; empty when all is well.
    """
    try:
        lesson = read_lesson(path)
        expand(lesson)
    except LessonError as error:
        return [error]
    rules = (_one_title, _short_cells, _exercises_once, _images)
    return [LessonError(path, line, message) for rule in rules for line, message in rule(lesson)]


def pictures(lesson: Lesson) -> list[str]:
    """Return the files that a lesson's text shows, as paths relative to the lesson."""
    targets = [m["target"] for cell in _texts(lesson) for m in _markdown_images(cell)]
    return [name for name in dict.fromkeys(targets) if "://" not in name]


def _one_title(lesson: Lesson) -> Iterator[tuple[int, str]]:
    titles = [
        (cell.line + number, line)
        for cell in _texts(lesson)
        for number, line in enumerate(_without_code(cell.source).splitlines())
        if line.startswith("# ")
    ]
    if not titles:
        yield 1, "the lesson has no title; begin it with a line `# Title`"
    for line, title in titles[1:]:
        yield line, f"a second title {title!r}; use ## for a section"


def _short_cells(lesson: Lesson) -> Iterator[tuple[int, str]]:
    for cell in lesson.cells:
        length = len(cell.source.splitlines())
        if cell.role == "code" and length > LONGEST_CELL:
            yield (
                cell.line,
                f"a code cell of {length} lines; move what is not to be read into the "
                f"library (at most {LONGEST_CELL})",
            )


def _exercises_once(lesson: Lesson) -> Iterator[tuple[int, str]]:
    own = [exercise.name for exercise in all_exercises(lesson.chapter)] if lesson.chapter else []
    seen = Counter[str]()
    for cell in lesson.named:
        seen[cell.exercise] += 1
        if cell.exercise not in own:
            yield cell.line, f"{cell.exercise} is an exercise of another chapter"
        elif seen[cell.exercise] == 2:
            yield cell.line, f"{cell.exercise} stands in the lesson twice"
    for name in own:
        if name not in seen:
            yield 1, f"the lesson leaves out the exercise {name}"


def _images(lesson: Lesson) -> Iterator[tuple[int, str]]:
    for cell in _texts(lesson):
        for found in _markdown_images(cell):
            line = _line(cell, found.start())
            if not found["alt"].strip():
                yield line, f"the picture {found['target']} has no text alternative"
            if "://" not in found["target"] and not (lesson.path.parent / found["target"]).exists():
                yield line, f"there is no file {found['target']} beside the lesson"
        for found in _HTML_IMAGE.finditer(_without_code(cell.source)):
            if not re.search(r"\balt\s*=\s*[\"'][^\"']", found[0]):
                yield _line(cell, found.start()), "an <img> has no text alternative"


def _texts(lesson: Lesson) -> list[LessonCell]:
    return [cell for cell in lesson.cells if cell.role in ("text", "explain")]


def _markdown_images(cell: LessonCell) -> list[re.Match[str]]:
    return list(_MARKDOWN_IMAGE.finditer(_without_code(cell.source)))


def _without_code(source: str) -> str:
    """Blank fenced code, keeping the number of lines and characters."""
    return _FENCED.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), source)


def _line(cell: LessonCell, position: int) -> int:
    return cell.line + cell.source.count("\n", 0, position)
