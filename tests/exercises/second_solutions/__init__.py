"""Right answers, written differently from the library: loops, matrices, other formulas.

One module a chapter, named as in `course_lib.exercises`; a function is named like its exercise.
"""

import importlib
from collections.abc import Callable


def second_solutions(chapter: str) -> dict[str, Callable]:
    """Return the other solutions of a chapter by the name of the function."""
    return vars(importlib.import_module(f"second_solutions.{chapter}"))
