"""Answer: run a student's function on the cases. Whatever it does, a list of answers comes back."""

from __future__ import annotations

import copy
import linecache
import sys
import traceback
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import (
    AbstractContextManager,
    contextmanager,
    nullcontext,
    redirect_stderr,
    redirect_stdout,
)
from dataclasses import dataclass, replace
from types import FrameType
from typing import Any, Literal

import numpy as np

from course_lib.judging.exercise import Case, Exercise
from course_lib.judging.limits import (
    BoundedText,
    Limits,
    NotPlainError,
    TimeLimitReached,
    TooLargeError,
    plain,
    time_limit,
)

#: Whose lines no student has written.
LIBRARIES = {"course_lib", "numpy", "scipy", "cv2", *sys.stdlib_module_names}
Status = Literal["value", "not attempted", "raised", "time limit", "not plain", "too large"]


@dataclass(frozen=True)
class Answer:
    """What came back for one case, as plain data.

    Parameters
    ----------
    status : str
        ``"value"``, or why there is none.
    value : object
        The result, made of arrays, numbers, texts, tuples, lists and dictionaries.
    error : str
        The name of the exception, where one was raised.
    message : str
        Its text; may contain the inputs.
    line : str
        The line of the student's code that raised it.
    printed : str
        The beginning of what was printed.
    warned : tuple of str
        What Python and NumPy warned of.
    changed_inputs : tuple of str
        Parameters whose value the function changed in place.
    called : tuple of str
        Ready-made answers that the function called.
    """

    status: Status
    value: Any = None
    error: str = ""
    message: str = ""
    line: str = ""
    printed: str = ""
    warned: tuple[str, ...] = ()
    changed_inputs: tuple[str, ...] = ()
    called: tuple[str, ...] = ()

    @property
    def refuses(self) -> bool:
        """Whether an exception came, and not only because an `if` was given an array."""
        return self.status == "raised" and "truth value of an array" not in self.message


def answer(
    exercise: Exercise,
    function: Callable[..., Any],
    cases: Sequence[Case],
    limits: Limits | None = None,
) -> list[Answer]:
    """Run a function on the cases of an exercise.

    Parameters
    ----------
    exercise : Exercise
        What is answered.
    function : callable
        The student's function. It may raise, loop, print, change its inputs, return anything.
    cases : sequence of Case
        From `pose`.
    limits : Limits, optional
        Bounds for each call. After a call that took too long the rest is not tried.

    Returns
    -------
    list of Answer
        One for each case.
    """
    limits = limits or Limits()
    answers: list[Answer] = []
    for case in cases:
        if answers and answers[-1].status == "time limit":
            answers.append(Answer("time limit"))
        else:
            answers.append(_answer_case(exercise, function, case, limits))
    return answers


def _answer_case(
    exercise: Exercise, function: Callable[..., Any], case: Case, limits: Limits
) -> Answer:
    posed = replace(case, inputs=_copied(case.inputs))
    output, called = BoundedText(limits.characters), set[str]()
    with _quiet(output) as caught:
        guard = _guarded(exercise, limits, called)
        given = _outcome(exercise, function, posed, limits, guard)
    return replace(
        given,
        printed=output.text(),
        warned=tuple(dict.fromkeys(str(warning.message)[:200] for warning in caught)),
        changed_inputs=tuple(name for name in case.inputs if not _same(case, posed, name)),
        called=tuple(sorted(called)),
    )


class OwnAnswers:
    """What the functions of the course give to cases, each worked out once, when it is asked for.

    They are trusted, so not watched. Who judges several answers to the same cases keeps one of
    these: the misconceptions' answers do not depend on the student's.

    Parameters
    ----------
    exercise : Exercise
        What is answered.
    cases : sequence of Case
        From `pose`.
    """

    def __init__(self, exercise: Exercise, cases: Sequence[Case]) -> None:
        self.exercise = exercise
        self.cases = tuple(cases)
        self._given: dict[tuple[Callable[..., Any], int], Answer] = {}
        self._expected: dict[int, Any] = {}

    def of(self, function: Callable[..., Any], index: int) -> Answer:
        """Return what a misconception gives to a case: only status, value, error and message."""
        key = function, index
        if key not in self._given:
            case = self.cases[index]
            posed = replace(case, inputs=_copied(case.inputs))
            with warnings.catch_warnings(), np.errstate(all="ignore"):
                warnings.simplefilter("ignore")
                given = _outcome(self.exercise, function, posed, Limits(), nullcontext())
            self._given[key] = given
        return self._given[key]

    def expected(self, index: int) -> Any:
        """Return the right answer to a case."""
        if index not in self._expected:
            self._expected[index] = expected_answer(self.exercise, self.cases[index])
        return self._expected[index]


def expected_answer(exercise: Exercise, case: Case) -> Any:
    """Return the right answer for a case: known by construction, or the reference's."""
    if case.known:
        return case.truth
    return exercise.as_answer(exercise.reference, case)


def _copied(inputs: dict[str, Any]) -> dict[str, Any]:
    """Return inputs that may be changed; `copy.deepcopy` takes ten times as long for arrays."""
    return {
        name: value.copy()
        if type(value) is np.ndarray and value.dtype != object
        else copy.deepcopy(value)
        for name, value in inputs.items()
    }


def _outcome(
    exercise: Exercise,
    function: Callable[..., Any],
    case: Case,
    limits: Limits,
    guard: AbstractContextManager[None],
) -> Answer:
    try:
        with guard:
            result = exercise.as_answer(function, case)
        return Answer("value", plain(result, limits.bytes))
    except TimeLimitReached:
        return Answer("time limit", message=f"{limits.seconds:g}")
    except NotImplementedError as error:
        return Answer("not attempted", message=str(error)[:300])
    except NotPlainError as error:
        return Answer("not plain", message=str(error))
    except TooLargeError as error:
        return Answer("too large", message=str(error))
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # also SystemExit: a student's exit() ends the answer only
        name, line = type(error).__name__, _student_line(error)
        return Answer("raised", error=name, message=str(error)[:300], line=line)


@contextmanager
def _guarded(exercise: Exercise, limits: Limits, called: set[str]) -> Iterator[None]:
    """Stop a call that takes too long, and note which ready-made answers it calls."""
    with time_limit(limits.seconds, limits.clock), _watch_calls(exercise, called):
        yield


@contextmanager
def _quiet(output: BoundedText) -> Iterator[list[warnings.WarningMessage]]:
    """Catch what is printed and warned; a grade cell must not write to stderr."""
    with (
        redirect_stdout(output),
        redirect_stderr(output),
        warnings.catch_warnings(record=True) as caught,
        np.errstate(all="warn"),
    ):
        warnings.simplefilter("always")
        yield caught


@contextmanager
def _watch_calls(exercise: Exercise, called: set[str]) -> Iterator[None]:
    """Note calls of the reference or of a forbidden function, whatever name they go by."""
    reference = exercise.reference
    forbidden = {name.rpartition(".")[2]: name for name in exercise.forbidden}

    def watch(frame: FrameType, event: str, argument: Any) -> None:
        name = frame.f_code.co_name
        if event == "call" and frame.f_code is reference.__code__:
            called.add(f"{reference.__module__}.{reference.__name__}")
        elif event == "call" and name in forbidden:  # a student's own may have the same name
            if forbidden[name] == f"{frame.f_globals.get('__name__')}.{name}":
                called.add(forbidden[name])
        elif event == "c_call" and getattr(argument, "__name__", "") in forbidden:
            called.add(forbidden[argument.__name__])

    before = sys.getprofile()
    sys.setprofile(watch)
    try:
        yield
    finally:
        sys.setprofile(before)


def _same(case: Case, posed: Case, name: str) -> bool:
    before, after = case.inputs[name], posed.inputs[name]
    try:
        return bool(np.array_equal(before, after, equal_nan=True))
    except TypeError:  # not numbers
        return bool(before == after)


def _student_line(error: BaseException) -> str:
    """Return the last line outside of all libraries that led to an error.

    Wrong answers of the exercises count as a student's: what they raise is matched with that.
    """
    for frame, number in reversed(list(traceback.walk_tb(error.__traceback__))):
        module = frame.f_globals.get("__name__", "")
        library = module.partition(".")[0] in LIBRARIES
        if not library or module.startswith("course_lib.exercises."):
            return linecache.getline(frame.f_code.co_filename, number).strip()
    return ""
