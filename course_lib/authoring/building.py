"""Build the notebooks that students open, and tell whether those in the repository are fresh."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path

import nbformat
from nbformat import NotebookNode

from course_lib.authoring.expansion import METADATA, expand
from course_lib.authoring.lesson import Lesson, read_lesson
from course_lib.authoring.lint import lint, pictures
from course_lib.authoring.options import release_options
from course_lib.exercises import CHAPTERS

Files = dict[Path, bytes]


def find_lessons(root: Path, names: Sequence[str] = ()) -> list[Path]:
    """Return the lessons of a course, in order.

    Parameters
    ----------
    root : pathlib.Path
        The course's folder, with ``lessons`` in it.
    names : sequence of str, optional
        Which ones, e.g. ``"01_pinhole"``; all unless told otherwise.

    Returns
    -------
    list of pathlib.Path
        Files ``lessons/NN_topic.md``.

    Raises
    ------
    ValueError
        If there is no such lesson, or none at all.
    """
    found = {path.stem: path for path in sorted((root / "lessons").glob("[0-9][0-9]_*.md"))}
    if not found:
        raise ValueError(f"no lessons in {root / 'lessons'}; run this in the course's folder")
    for name in names:
        if name not in found:
            raise ValueError(f"no lesson {name!r}; there are {', '.join(found)}")
    return [found[name] for name in names or found]


def build(root: Path, names: Sequence[str] = ()) -> list[Path]:
    """Write the student notebooks.

    Parameters
    ----------
    root : pathlib.Path
        The course's folder.
    names : sequence of str, optional
        Which lessons; all unless told otherwise.

    Returns
    -------
    list of pathlib.Path
        The notebooks whose content changed.

    Raises
    ------
    LessonError, ValueError
        If a lesson cannot be built.
    """
    changed = []
    for path, content in built_files(root, find_lessons(root, names)).items():
        if not path.exists() or path.read_bytes() != content:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
            changed.append(path)
    return changed


def check_built(root: Path, names: Sequence[str] = ()) -> list[str]:
    """Say what is not right with the lessons, and which notebooks are not what they give.

    Parameters
    ----------
    root : pathlib.Path
        The course's folder.
    names : sequence of str, optional
        Which lessons; all unless told otherwise.

    Returns
    -------
    list of str
        A sentence for each problem; empty when all is well.
    """
    paths = find_lessons(root, names)
    problems = [str(problem) for path in paths for problem in lint(path)]
    problems += [] if names else _left_over(root, paths)
    if problems:
        return problems
    for path, content in built_files(root, paths).items():
        shown = path.relative_to(root).as_posix()
        mend = f"run: course build {path.parent.name}"
        if not path.exists():
            problems.append(f"{shown} is missing; {mend}")
        elif path.read_bytes() != content:
            why = "has outputs" if _has_outputs(path) else "is not what its lesson gives"
            problems.append(f"{shown} {why}; {mend}")
    return problems


def built_files(root: Path, lessons: Iterable[Path]) -> Files:
    """Return what belongs into ``notebooks/``: student notebooks and the pictures they show."""
    read = [read_lesson(path) for path in lessons]
    files: Files = {}
    for lesson, notebook in zip(read, release(read), strict=True):
        folder = root / "notebooks" / lesson.name
        files[folder / f"{lesson.name}.ipynb"] = notebook_bytes(notebook)
        for name in pictures(lesson):
            files[folder / name] = (lesson.path.parent / name).read_bytes()
    return files


def release(lessons: Sequence[Lesson]) -> list[NotebookNode]:
    """Run nbgrader's ``generate_assignment`` on lessons, in a directory of its own.

    Parameters
    ----------
    lessons : sequence of Lesson
        From `read_lesson`.

    Returns
    -------
    list of nbformat.NotebookNode
        Student notebooks: without solutions, model answers, rubrics and outputs.

    Raises
    ------
    RuntimeError
        If nbgrader refuses; the message holds what it said.
    """
    from nbgrader.apps.api import NbGraderAPI

    expanded = [expand(lesson) for lesson in lessons]
    with tempfile.TemporaryDirectory(prefix="course-build-") as directory:
        options = release_options()
        options.CourseDirectory.root = directory
        options.GenerateAssignment.no_database = True  # nobody reads the gradebook of a build
        options.SaveCells.enabled = False
        api = NbGraderAPI(config=options)
        for lesson, notebook in zip(lessons, expanded, strict=True):
            write_notebook(notebook, Path(directory, "source", lesson.name, f"{lesson.name}.ipynb"))
            outcome = api.generate_assignment(lesson.name)
            if not outcome["success"]:
                raise RuntimeError(f"nbgrader could not release {lesson.name}:\n{outcome['log']}")
        released = [Path(directory, "release", x.name, f"{x.name}.ipynb") for x in lessons]
        return [_normal(nbformat.read(path, as_version=4)) for path in released]


def write_notebook(notebook: NotebookNode, path: Path) -> None:
    """Write a notebook, and the folders it needs."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(notebook_bytes(notebook))


def copy_pictures(lesson: Lesson, folder: Path) -> None:
    """Copy the pictures that a lesson shows to where its notebook is."""
    for name in pictures(lesson):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(lesson.path.parent / name, folder / name)


def notebook_bytes(notebook: NotebookNode) -> bytes:
    """Return a notebook as the bytes of its file: UTF-8, sorted keys, a newline at the end."""
    text: str = nbformat.writes(notebook, version=4)
    return (text.rstrip("\n") + "\n").encode("utf-8")


def _normal(notebook: NotebookNode) -> NotebookNode:
    """Leave nothing in a notebook that depends on the machine; it has no outputs any more."""
    notebook.metadata = nbformat.from_dict(METADATA)
    return notebook


def _left_over(root: Path, lessons: Sequence[Path]) -> list[str]:
    """Say which chapters have no lesson, and which notebooks come from none."""
    known = {path.stem for path in lessons}
    lost = [f"lessons/{name}.md is missing" for name in CHAPTERS.values() if name not in known]
    found = sorted((root / "notebooks").glob("*/*.ipynb"))
    stray = [path.relative_to(root) for path in found if path.parent.name not in known]
    return lost + [f"{path.as_posix()} comes from no lesson; delete it" for path in stray]


def _has_outputs(path: Path) -> bool:
    try:
        cells = nbformat.read(path, as_version=4).cells
    except (ValueError, nbformat.reader.NotJSONError):
        return False
    return any(cell.get("outputs") or cell.get("execution_count") for cell in cells)
