"""Answers at the border: what a student's process says is taken for what it can be, no more.

A verdict reaches the student. So nothing in it may carry an input from the answer to the page: no
text of an exception, no name that a student chose.
"""

from __future__ import annotations

import builtins
import warnings
from collections.abc import Mapping, Sequence
from typing import Any, get_args

import numpy as np

from course_lib.checks import DegenerateConfigurationError
from course_lib.judging import Answer, Case, Exercise, Verdict, judge
from course_lib.judging.answering import Status

#: Exceptions of libraries that are named; all of Python's own are.
NAMED = {"LinAlgError", "AxisError", "UFuncTypeError", "QhullError"}
NAMED |= {DegenerateConfigurationError.__name__}
EXCEPTIONS = NAMED | {
    name
    for name, kind in vars(builtins).items()
    if isinstance(kind, type) and issubclass(kind, BaseException)
}
OWN_ERROR = "an exception of its own"
TYPES = {name for name, kind in vars(builtins).items() if isinstance(kind, type)} | {
    "function", "builtin_function_or_method", "generator", "module", "NoneType", "method", "ufunc",
    "Figure", "Axes", "dict_keys", "dict_values", "Series", "DataFrame", "Fraction", "Decimal",
}  # fmt: skip
TOO_MUCH = "too many bytes"
#: Axes of an array; length of an empty one; letters of all texts, each as long as the longest.
MOST_AXES, LONGEST_EMPTY, MOST_LETTERS = 4, 100, 1_000_000
UNCLEAR = "kind that cannot be compared"
CRASHED = "a crash: Python itself was ended, or ran out of memory"


def vet(
    exercise: Exercise, case: Case, reply: Any, lines: Sequence[str], seconds: float
) -> tuple[Answer, frozenset[str]]:
    """Make an answer of what a student's process sent for one case.

    Parameters
    ----------
    exercise : Exercise
        What was asked.
    case : Case
        Its inputs.
    reply : object
        A decoded message.
    lines : sequence of str
        The lines of the submission, without blanks around them.
    seconds : float
        What one call may take.

    Returns
    -------
    answer : Answer
        With nothing in it that the verdict should not show.
    hidden : frozenset of str
        Functions of other exercises that the answer called, and that were not there.
    """
    if not isinstance(reply, Mapping):
        return crashed(), frozenset()
    if "missing" in reply:
        return Answer(
            "not attempted", message=what_is_missing(exercise, reply["missing"])
        ), frozenset()
    status = _status(reply.get("status"))
    if status is None:
        return crashed(), frozenset()
    hidden = frozenset(name for name in _texts(reply.get("hidden")) if "." in name)
    if status == "value" and not is_modest(reply.get("value")):
        return Answer("too large", message=TOO_MUCH), frozenset()
    own = own_names(exercise)
    message = _text(reply.get("message"))
    answer = Answer(
        status,
        value=reply.get("value") if status == "value" else None,
        error=_error(reply.get("error")) if status == "raised" else "",
        message=_vetted_message(status, message, seconds),
        line=_line(reply.get("line"), lines),
        changed_inputs=tuple(n for n in _texts(reply.get("changed_inputs")) if n in case.inputs),
        called=tuple(sorted(({*_texts(reply.get("called"))} | hidden) & own)),
    )
    return answer, hidden - own


def own_names(exercise: Exercise) -> frozenset[str]:
    """Return the names of the ready-made answers to an exercise."""
    reference = exercise.reference
    return frozenset({f"{reference.__module__}.{reference.__name__}", *exercise.forbidden})


def crashed() -> Answer:
    """Return the answer of a process that ended, or that sent what is no answer."""
    return Answer("raised", error=CRASHED)


def what_is_missing(exercise: Exercise, found: Any) -> str:
    """Say that there is no function, or something else under its name."""
    name = exercise.function_name
    if isinstance(found, str) and not found:
        return f"There is no function `{name}`. Was there an error in red when its cell was run?"
    return f"`{name}` is no function here. Keep the line that begins with `def`."


def _status(said: Any) -> Status | None:
    return next((s for s in get_args(Status) if isinstance(said, str) and s == said), None)


def _vetted_message(status: str, message: str, seconds: float) -> str:
    """Return the part of a message that may be shown; advice is looked up in that of an error."""
    if status == "raised":
        return message
    if status == "time limit":
        return f"{seconds:g}"
    if status == "not plain":
        known = message in TYPES or message in ("array of object", "array of bytes")
        return message if known else "kind that you made"
    return TOO_MUCH if status == "too large" else ""


def is_modest(value: Any) -> bool:
    """Whether an answer can be compared and described.

    NumPy gives each text of a list the room of the longest one, so that a message of a few
    megabytes would become an array of many gigabytes. And a shape is shown to the student: that
    of an empty array can hold any numbers.

    Parameters
    ----------
    value : object
        Made of plain values.
    """
    items, longest, todo = 0, 0, [value]
    while todo:
        one = todo.pop()
        items += 1
        if isinstance(one, tuple | list):
            todo += one
        elif isinstance(one, dict):
            todo += [*one.keys(), *one.values()]
        elif isinstance(one, str):
            longest = max(longest, len(one))
        elif isinstance(one, np.ndarray):
            if one.ndim > MOST_AXES or (not one.size and max(one.shape) > LONGEST_EMPTY):
                return False
            letters = one.dtype.itemsize // 4 if one.dtype.kind == "U" else 0
            items, longest = items + one.size * bool(letters), max(longest, letters)
    return items * longest <= MOST_LETTERS


def _error(name: Any) -> str:
    return name if isinstance(name, str) and name in EXCEPTIONS else OWN_ERROR


def _line(line: Any, lines: Sequence[str]) -> str:
    return line if isinstance(line, str) and line in lines else ""


def _text(value: Any) -> str:
    return value[:300] if isinstance(value, str) else ""


def _texts(value: Any) -> list[str]:
    """Return the texts of a short list; the order is the sender's."""
    items = value if isinstance(value, tuple | list) else ()
    return [item for item in items[:50] if isinstance(item, str) and len(item) < 200]


def compare(exercise: Exercise, cases: Sequence[Case], answers: Sequence[Answer]) -> Verdict:
    """Judge answers that may be anything; what cannot be compared is wrong.

    Parameters
    ----------
    exercise : Exercise
        What was asked.
    cases : sequence of Case
        With which inputs.
    answers : sequence of Answer
        Vetted.

    Returns
    -------
    Verdict
        Without examples.
    """
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        try:
            return judge(exercise, cases, answers, reveal=False)
        except Exception:  # a comparison may stumble over values that nobody thought of
            unclear = [
                Answer("not plain", message=UNCLEAR) if a.status == "value" else a for a in answers
            ]
            return judge(exercise, cases, unclear, reveal=False)
