"""What goes wrong in a student's cell: answers that fail, and right answers that make noise."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping

from course_lib.exercises.pasting import INDENT, Pasted, paste
from course_lib.judging import Exercise

Mishap = Callable[[Exercise], str]


def _instead(*statements: str) -> Mishap:
    """Type these statements for a body."""

    def type_it(exercise: Exercise) -> str:
        signature = paste(exercise.reference).signature
        return "\n".join([signature, *(INDENT + line for line in statements)])

    return type_it


def _before(*statements: str) -> Mishap:
    """Type these statements before a right body."""

    def type_it(exercise: Exercise) -> str:
        own = paste(exercise.reference)
        extra = "\n".join(INDENT + line for line in statements)
        return Pasted(own.signature, own.docstring, f"{extra}\n{own.body}").as_function()

    return type_it


def _outside(*statements: str) -> Mishap:
    """Type these statements into the cell, after a right function."""

    def type_it(exercise: Exercise) -> str:
        return "\n".join([paste(exercise.reference).as_function(), "", *statements])

    return type_it


def _calls_the_reference(exercise: Exercise) -> str:
    reference = exercise.reference
    arguments = ", ".join(inspect.signature(reference).parameters)
    load = f"from {reference.__module__} import {reference.__name__} as ready_made"
    return _instead(load, f"return ready_made({arguments})")(exercise)


def _logs(exercise: Exercise) -> str:
    """Log the inputs with a handler that was made before any check, and so escapes it."""
    logged = _before("logging.info('called with %s', locals())")(exercise)
    return "\n".join(["import logging", "logging.basicConfig(level=logging.INFO)", "", logged])


#: Answers that earn nothing.
TROUBLES: Mapping[str, Mishap] = {
    "syntax error": _instead("return (1, 2"),
    "endless loop": _instead("while True:", "    pass"),
    "text for a number": _instead('return "42"'),
    "missing return": _instead("answer = 42"),
    "undefined name": _instead("return focal_lenght"),
    "stops Python": _instead("exit()"),
    "calls the reference": _calls_the_reference,
    "returns a function": _instead("return np.sin"),
}

#: Right answers that do more than they should.
NOISES: Mapping[str, Mishap] = {
    "prints a lot": _before("for step in range(20_000):", "    print('step', step)"),
    "warns": _before("import warnings", "warnings.warn('this is only a draft')"),
    "writes to stderr": _before("import sys", "print('careful', file=sys.stderr)"),
    "logs": _logs,
    "replaces the check and leaves": _outside("def check(name):", "    return 4.0", "exit()"),
    "shows a picture": _before(
        "from IPython.display import display", "display({'text/plain': 'a plot'}, raw=True)"
    ),
    "prints in the cell": _outside("for step in range(20_000):", "    print('step', step)"),
    "fails in the cell": _outside("1 / 0"),
}

#: Right answers with something in the cell that makes it impossible to grade what follows.
ENDS: Mapping[str, Mishap] = {
    "killed": _outside("import os", "os._exit(1)"),
}
