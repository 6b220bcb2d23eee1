"""What a notebook of the course calls: `check` an answer, `attempt` to use it, see a `solution`."""

from __future__ import annotations

import copy
import getpass
import os
import re
import sys
import textwrap
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from html import escape
from typing import Any

import numpy as np

from course_lib.display import show_block
from course_lib.exercises import all_exercises, find
from course_lib.exercises.pasting import paste
from course_lib.judging import Exercise, ValuesExercise, Verdict, answer, judge, pose, seed_for
from course_lib.judging.comparison import describe
from course_lib.judging.html import to_html
from course_lib.judging.limits import TimeLimitReached, time_limit
from course_lib.judging.text import to_text

#: Seconds that a student's function may take inside a figure's cell.
PATIENCE = 3.0


class _Points(float):
    """The points that a grade cell ends in; Jupyter need not write what the block has said."""

    def _repr_html_(self) -> str:
        return ""


class _UnusableError(TypeError):
    """A result that no figure can use; the text goes on after the function's name."""


def check(name: str, namespace: Mapping[str, Any] | None = None) -> float:
    """Check an answer, show what is right, what is not and why, and return the points.

    Parameters
    ----------
    name : str
        The exercise, e.g. ``"pinhole.project_pinhole"``.
    namespace : mapping, optional
        Where the answer is looked up; the caller's variables unless told otherwise.

    Returns
    -------
    float
        Points earned: a number, because that is what a grade cell must end in.

    Raises
    ------
    ValueError
        If there is no such exercise, or it is graded by a person.
    """
    exercise = find(name)
    if not isinstance(exercise, Exercise):
        raise ValueError(f"{name} is answered in words; a person reads and grades it")
    if namespace is None:
        namespace = sys._getframe(1).f_globals
    verdict = verdict_of(exercise, namespace)
    verdict = replace(verdict, notes=(*_older_than_seen(exercise, namespace), *verdict.notes))
    if _validating() and verdict.points < verdict.possible:
        print(_wrapped(to_text(verdict)), file=sys.stderr)
    else:
        show_block(to_html(verdict), to_text(verdict))
    return _Points(verdict.points)


def attempt(function: Callable[..., Any], *args: Any, **kwargs: Any) -> Any:
    """Return what a student's function answers; while it does not, say why and return None.

    Figures use it to draw a student's answer beside the course's own, so that a notebook runs to
    its end whether an exercise is finished or not. A result of another shape than the course's
    own counts as no answer.

    Parameters
    ----------
    function : callable
        The student's function. It gets copies of the arguments and a few seconds.
    *args, **kwargs
        What it is called with.

    Returns
    -------
    object or None
        Its result; None where it is not written yet, raises or takes too long.
    """
    return attempt_each(function, [args], **kwargs)[0]


def attempt_each(function: Callable[..., Any], cases: Iterable[Any], **kwargs: Any) -> list[Any]:
    """Return what a student's function answers for several inputs, as `attempt` does for one.

    Parameters
    ----------
    function : callable
        The student's function.
    cases : iterable of tuple
        The arguments of each call.
    **kwargs
        Arguments that all calls share.

    Returns
    -------
    list
        A result for each call; all None where one of the calls does not answer.
    """
    calls = [copy.deepcopy((args, kwargs)) for args in cases]
    name = getattr(function, "__name__", "your function")
    try:
        with time_limit(PATIENCE):
            results = [function(*args, **named) for args, named in calls]
        return [_shaped(*pair) for pair in zip(results, _expected(name, calls), strict=True)]
    except NotImplementedError:
        print(f"{name} is not written yet. Run this cell again when it is.")
    except TimeLimitReached:
        print(f"{name} takes too long.")
    except _UnusableError as error:
        print(f"{name} {error}")
    except Exception as error:
        print(f"{name} does not answer: {type(error).__name__}, {error}")
    return [None] * len(calls)


def _expected(name: str, calls: Sequence[Any]) -> list[Any]:
    """Return what the course's own function of that name gives for some calls."""
    exercises = [e for e in all_exercises() if isinstance(e, Exercise) and e.function_name == name]
    if not exercises:
        return [None] * len(calls)
    return [exercises[0].reference(*args, **named) for args, named in calls]


def _shaped(result: Any, expected: Any) -> Any:
    """Return a result as numbers of the expected shape, or raise what is wrong with it."""
    if expected is None:
        return result
    if isinstance(expected, tuple):
        several = isinstance(result, tuple | list) or np.ndim(result) > 0
        if not several or len(result) != len(expected):
            raise _UnusableError(f"returns {describe(result)} instead of {len(expected)} results.")
        return tuple(_shaped(*pair) for pair in zip(result, expected, strict=True))
    if isinstance(expected, dict):
        if not isinstance(result, dict):
            raise _UnusableError(f"returns {describe(result)} instead of a dictionary.")
        return result
    shape = np.shape(expected)
    kind = f"an array of shape {shape}" if shape else "a number"
    if result is None:
        raise _UnusableError(f"returns None instead of {kind}. Does it end in a return?")
    try:
        numbers = np.asarray(result, dtype=float)
    except (TypeError, ValueError):
        raise _UnusableError(f"returns {describe(result)} instead of {kind}.") from None
    if numbers.shape != shape:
        given = f"an array of shape {numbers.shape}" if numbers.shape else "a number"
        raise _UnusableError(f"returns {given} instead of {kind}.")
    return numbers if shape else float(numbers)


def solution(name: str) -> None:
    """Show the course's own solution of an exercise.

    Parameters
    ----------
    name : str
        The exercise, e.g. ``"pinhole.project_pinhole"``.

    Raises
    ------
    ValueError
        If there is no such exercise.
    """
    exercise = find(name)
    if isinstance(exercise, ValuesExercise):
        _show_source(paste(exercise.reference).as_function())
    elif isinstance(exercise, Exercise):
        _show_source(paste(exercise.reference).without_docstring().as_function())
    else:
        show_block(f"<p>{exercise.model_answer}</p>", exercise.model_answer)


def _show_source(source: str) -> None:
    show_block(f"<pre>{escape(source)}</pre>", source)


def verdict_of(exercise: Exercise, namespace: Mapping[str, Any]) -> Verdict:
    """Pose an exercise, let the function or the variables of a namespace answer it, and judge.

    Parameters
    ----------
    exercise : Exercise
        What is asked.
    namespace : mapping
        Where the student's function (or variables) are.

    Returns
    -------
    Verdict
        With examples: these inputs are the student's to see. Grading poses others.
    """
    cases = pose(exercise, seed_for(_student(), exercise.name))
    answers = answer(exercise, _answering(exercise, namespace), cases)
    return judge(exercise, cases, answers)


def _answering(exercise: Exercise, namespace: Mapping[str, Any]) -> Callable[..., Any]:
    """Return what answers the exercise; one that is missing is one that was not attempted."""
    if isinstance(exercise, ValuesExercise):
        return lambda **_: {variable: namespace.get(variable) for variable in exercise.units}
    function: Callable[..., Any] | None = namespace.get(exercise.function_name)
    if callable(function):
        return function

    def missing(*_: Any) -> Any:
        raise NotImplementedError(_what_is_missing(exercise.function_name, function))

    return missing


def _what_is_missing(name: str, found: Any) -> str:
    if found is None:
        return f"There is no function `{name}` yet. Run its cell, and mend an error in red first."
    return f"`{name}` is {describe(found)}, not a function. Keep the line that begins with `def`."


def _older_than_seen(exercise: Exercise, namespace: Mapping[str, Any]) -> tuple[str, ...]:
    """Say so if the newest text of a function never became one, so that an older one was judged.

    Jupyter keeps the cells that were run as the list `In`, also those that Python could not read.
    """
    name = exercise.function_name
    defines = re.compile(rf"^\s*def\s+{name}\b", re.MULTILINE)
    cells = [cell for cell in namespace.get("In", ()) if defines.search(cell)]
    if not cells or not callable(namespace.get(name)):
        return ()
    try:
        with warnings.catch_warnings(action="ignore"):
            compile(cells[-1], "cell", "exec")
    except SyntaxError as error:
        return (
            f"When you ran the cell of `{name}` last, Python could not read it: {error.msg}, line "
            f"{error.lineno} of the cell. So this is about the version that you ran before.",
        )
    return ()


def _validating() -> bool:
    """Return whether nbgrader's *Validate* runs: it shows what a check writes to stderr."""
    return os.environ.get("NBGRADER_EXECUTION") == "validate"


def _wrapped(text: str, width: int = 80) -> str:
    """Break long lines: nbgrader cuts what does not fit its page off."""
    return "\n".join(
        textwrap.fill(line, width, subsequent_indent=" " * (len(line) - len(line.lstrip()) + 2))
        if len(line) > width
        else line
        for line in text.splitlines()
    )


def _student(environment: Mapping[str, str] = os.environ) -> str:
    """Return who is working here, so that inputs differ from student to student."""
    named = environment.get("COURSE_STUDENT") or environment.get("JUPYTERHUB_USER")
    try:
        return named or getpass.getuser()
    except (KeyError, OSError, ImportError):  # no user name on this system
        return "reader"
