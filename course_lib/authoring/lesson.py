"""Read a lesson: a MyST Markdown notebook in which an exercise is a cell with its name."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import jupytext.myst

from course_lib.exercises import CHAPTERS

Role = Literal["text", "code", "exercise", "explain"]


class LessonError(ValueError):
    """Something in a lesson that its author must mend; the message starts with file and line."""

    def __init__(self, path: Path, line: int, message: str) -> None:
        super().__init__(f"{short_name(path)}:{line}: {message}")


@dataclass(frozen=True)
class LessonCell:
    """One cell: what it is, its text, where it starts, and for exercises which one it names."""

    role: Role
    source: str
    line: int
    metadata: dict[str, Any]
    exercise: str = ""


@dataclass(frozen=True)
class Lesson:
    """A lesson's file and its cells."""

    path: Path
    cells: tuple[LessonCell, ...]

    @property
    def name(self) -> str:
        """The notebook's name, e.g. ``"01_pinhole"``."""
        return self.path.stem

    @property
    def chapter(self) -> str:
        """The chapter's module of exercises, e.g. ``"pinhole"``; empty where there is none."""
        return next((key for key, name in CHAPTERS.items() if name == self.name), "")

    @property
    def named(self) -> list[LessonCell]:
        """The cells that name an exercise, in their order."""
        return [cell for cell in self.cells if cell.exercise]


def short_name(path: Path) -> str:
    """Return folder and file, as an author would say it: ``lessons/01_pinhole.md``."""
    return "/".join(path.parts[-2:])


def read_lesson(path: Path) -> Lesson:
    """Read a lesson.

    Parameters
    ----------
    path : pathlib.Path
        A file in jupytext's ``md:myst`` format. A code cell tagged ``exercise`` holds nothing but
        an exercise's name; a Markdown cell with ``{"tags": ["explain"], "exercise": name}`` is
        a question that a person grades.

    Returns
    -------
    Lesson
        Its cells with the line each starts in.

    Raises
    ------
    LessonError
        If the file is not a MyST notebook, or a tagged cell names no exercise.
    """
    text = path.read_text(encoding="utf-8")
    try:
        notebook = jupytext.myst.myst_to_notebook(text, add_source_map=True)
    except (jupytext.myst.MystMetadataParsingError, ValueError) as error:
        raise LessonError(path, 1, f"not a MyST notebook: {error}") from error
    starts = notebook.metadata["source_map"]
    lines = text.splitlines()
    pairs = zip(notebook.cells, starts, strict=True)
    return Lesson(path, tuple(_read_cell(path, lines, cell, start) for cell, start in pairs))


def _read_cell(path: Path, lines: list[str], cell: Any, start: int) -> LessonCell:
    tags, metadata = cell.metadata.get("tags", []), dict(cell.metadata)
    if cell.cell_type == "code":
        if "exercise" not in tags:
            return LessonCell("code", cell.source, start, metadata)
        return LessonCell("exercise", "", start, metadata, _only_name(path, start, cell.source))
    line = next((n + 1 for n in range(start, len(lines)) if lines[n].strip()), start + 1)
    if "explain" not in tags:
        return LessonCell("text", cell.source, line, metadata)
    name = metadata.get("exercise", "")
    if not name:
        raise LessonError(path, line, 'an explain cell needs "exercise": its name in its metadata')
    return LessonCell("explain", cell.source, line, metadata, name)


def _only_name(path: Path, line: int, source: str) -> str:
    words = source.split()
    if len(words) != 1:
        message = (
            "a cell tagged `exercise` holds one name and nothing else, e.g. pinhole.dolly_zoom"
        )
        raise LessonError(path, line, message)
    return words[0]
