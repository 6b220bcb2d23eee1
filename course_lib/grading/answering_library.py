"""The course's library as a student's process sees it: without references, exercises, judges.

It is a copy, made once for each set of hidden functions. What an exercise asks for is a function
that notes its call and refuses; the modules that hold exercises or grade are not there at all.
"""

from __future__ import annotations

import ast
import hashlib
import shutil
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path

import course_lib
import data_generators
from course_lib.exercises import all_exercises
from course_lib.exercises.pasting import EXERCISES
from course_lib.judging import Exercise

#: What no submission needs, by package.
LEFT_OUT = {
    "course_lib": ("authoring", "exercises", "grading", "starting", "cli.py", "notebook.py"),
    "data_generators": (
        *("classes.py", "everyday_class.py", "handwriting.py"),
        *("mishaps.py", "pasting_mishaps.py", "typed_answers.py", "unusual.py"),
    ),
}
PACKAGES = {"course_lib": course_lib, "data_generators": data_generators}


def hidden_functions(exercises: Iterable[Exercise]) -> frozenset[str]:
    """Return the full names of the library's functions that would answer some exercises.

    Parameters
    ----------
    exercises : iterable of Exercise
        Those that are asked.

    Returns
    -------
    frozenset of str
        The references, and what the exercises forbid of the library.
    """
    names = set()
    for exercise in exercises:
        reference = exercise.reference
        forbidden = [name for name in exercise.forbidden if name.startswith("course_lib.")]
        names |= {f"{reference.__module__}.{reference.__name__}", *forbidden}
    return frozenset(names)


def all_hidden(chapter: str) -> frozenset[str]:
    """Return the names of all hidden functions of a chapter."""
    return hidden_functions(e for e in all_exercises(chapter) if isinstance(e, Exercise))


def make_library(folder: Path, hidden: frozenset[str]) -> Path:
    """Copy the library into a folder, with some functions hidden.

    Parameters
    ----------
    folder : pathlib.Path
        Where copies are kept, one for each set of hidden functions.
    hidden : frozenset of str
        Full names.

    Returns
    -------
    pathlib.Path
        The folder to import from.
    """
    name = hashlib.sha256("\n".join(sorted(hidden)).encode()).hexdigest()[:16]
    target = folder / f"library-{name}"
    if not target.exists():
        growing = folder / f"library-{name}.part"
        shutil.rmtree(growing, ignore_errors=True)
        for package, module in PACKAGES.items():
            source = Path(str(module.__file__)).parent
            shutil.copytree(source, growing / package, ignore=_left_out(source, package))
        plain = growing / "course_lib/sandbox/plain_notebook.py"
        shutil.copyfile(plain, growing / "course_lib/notebook.py")  # with a time of its own
        for full_name in hidden:
            _hide(growing, full_name)
        _drop_stale(growing)
        growing.rename(target)
    return target


def _left_out(source: Path, package: str):  # type: ignore[no-untyped-def]
    """Return what `shutil.copytree` asks which files to leave out."""

    def ignore(folder: str, names: Sequence[str]) -> set[str]:
        return set(LEFT_OUT[package]) & set(names) if Path(folder) == source else set()

    return ignore


def _drop_stale(library: Path) -> None:
    """Remove what Python compiled of modules that are not there any more, or are others now.

    The rest saves a second at every start. Python tells a changed module by its time.
    """
    for compiled in library.rglob("*.pyc"):
        source = compiled.parents[1] / f"{compiled.name.partition('.')[0]}.py"
        header = compiled.read_bytes()[:16]
        known = int.from_bytes(header[8:12], "little")
        if not source.exists() or int(source.stat().st_mtime) & 0xFFFFFFFF != known:
            compiled.unlink()


def _hide(library: Path, full_name: str) -> None:
    """Replace a function's statements by a refusal; its docstring stays."""
    place = _place(library, full_name)
    if place is None:  # it is in what is left out
        return
    path, source, found = place
    documented = ast.get_docstring(found) is not None
    first = found.body[0].end_lineno if documented else found.body[0].lineno - 1
    lines = source.splitlines()
    refusal = [
        "    from course_lib.sandbox.hidden import ready_made",
        "",
        f"    ready_made({full_name!r})",
    ]
    lines[first : found.end_lineno] = refusal
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _place(library: Path, full_name: str) -> tuple[Path, str, ast.FunctionDef] | None:
    """Return where a function stands: file, its text, and the definition in it."""
    module, _, function = full_name.rpartition(".")
    path = library.joinpath(*module.split("."))
    path = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
    if not path.exists():
        return None
    source = path.read_text(encoding="utf-8")
    found = [n for n in ast.parse(source).body if getattr(n, "name", "") == function]
    if not found or not isinstance(found[0], ast.FunctionDef):
        raise ValueError(f"{full_name} is no function of its module, so it cannot be hidden")
    return path, source, found[0]


@cache
def source_of(full_name: str) -> str:
    """Return the text of a hidden function, for a process that may have it after all.

    Parameters
    ----------
    full_name : str
        Of `hidden_functions`.

    Returns
    -------
    str
        Its definition without decorators; empty if a submission never has its module.
    """
    if full_name.startswith(EXERCISES):
        return ""
    place = _place(Path(course_lib.__file__).parents[1], full_name)
    return "" if place is None else ast.get_source_segment(place[1], place[2]) or ""
