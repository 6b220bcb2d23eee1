"""Answer the questions of one check: inputs come in, plain values go out."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from socket import socket
from typing import Any

from course_lib.judging import Case, Limits
from course_lib.judging.answering import answer
from course_lib.judging.comparison import describe
from course_lib.sandbox import hidden, wire


class _Asked:
    """What `answer` needs to know of an exercise; the exercise itself is the grader's."""

    def __init__(self, check: Mapping[str, Any]) -> None:
        self.function_name: str = check["function"]
        self.forbidden: tuple[str, ...] = tuple(check["forbidden"])
        self.variables: tuple[str, ...] = tuple(check["variables"])
        self.reference = hidden.ready_made

    def as_answer(self, function: Callable[..., Any], case: Case) -> Any:
        """Return what a function gives for a case, as the exercise does."""
        if self.variables:
            return function(**case.inputs)[case.part]
        return function(*case.inputs.values())


def answer_questions(check: Mapping[str, Any], line: socket, namespace: Mapping[str, Any]) -> None:
    """Answer the grader's questions, one case after the other, until it has no more.

    Parameters
    ----------
    check : mapping
        What is asked: ``function``, ``variables``, ``forbidden``.
    line : socket
        Where questions come from and answers go.
    namespace : mapping
        The notebook's variables at the check.
    """
    asked = _Asked(check)
    function, missing = _answering(asked, namespace)
    while True:
        try:
            question = wire.receive(line, trusted=True)
        except wire.Closed:
            return
        if missing is not None:
            wire.send(line, {"missing": missing})
            continue
        hidden.called.clear()
        case = Case(question["part"], question["inputs"])
        limits = Limits(question["seconds"], clock=question["clock"])
        (given,) = answer(asked, function, [case], limits)  # type: ignore[arg-type]
        reply = vars(given) | {"hidden": sorted(hidden.called)}
        try:
            wire.send(line, reply)
        except (TypeError, ValueError):  # a text with half a letter, a number of a million digits
            kind = type(given.value).__name__
            wire.send(line, {"status": "not plain", "message": kind, "hidden": []})


def _answering(
    asked: _Asked, namespace: Mapping[str, Any]
) -> tuple[Callable[..., Any], str | None]:
    """Return what answers, and what there is in its place where it is missing (or None)."""
    if asked.variables:
        values = {variable: namespace.get(variable) for variable in asked.variables}
        return (lambda **_: values), None
    function = namespace.get(asked.function_name)
    if callable(function):
        return function, None
    return (lambda *_: None), "" if function is None else describe(function)[:100]
