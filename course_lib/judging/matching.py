"""Find the misconception behind wrong answers: the one that gives the same answers."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from course_lib.judging.answering import Answer, OwnAnswers
from course_lib.judging.comparison import Close, Comparison, Exactly, Mismatch, close_to
from course_lib.judging.exercise import Case, Misconception


def find_misconceptions(
    own: OwnAnswers, answers: Sequence[Answer], wrong: Sequence[int]
) -> list[Misconception]:
    """Find the misconception that explains all wrong answers, or else one for each wrong part.

    Parameters
    ----------
    own : OwnAnswers
        What the exercise's misconceptions give to the same cases.
    answers : sequence of Answer
        What the student's function gave.
    wrong : sequence of int
        Which of the answers are wrong.

    Returns
    -------
    list of Misconception
        Empty where no misconception gives the same answers.
    """
    ways = list(_ways(own, answers, wrong))
    cases = own.cases

    def explaining(some: Sequence[int]) -> list[Misconception]:
        """Of those that agree with some answers, return the one that agrees with most others."""
        fitting = [way for way in ways if some and all(map(way.agrees, some))]
        agreeing = [sum(map(way.agrees, range(len(cases)))) for way in fitting]
        return [fitting[int(np.argmax(agreeing))].misconception] if fitting else []

    by_part = [[i for i in wrong if cases[i].part == part] for part in own.exercise.parts]
    found = explaining(wrong) or [m for some in by_part for m in explaining(some)]
    return list({m.name: m for m in found}.values())


@dataclass(frozen=True)
class BothBeyond:
    """Numbers that are both far too large, of either sign: the same mistake, whatever the fit."""

    limit: float

    def __call__(self, got: Any, expected: Any) -> Mismatch | None:
        """Return None where both numbers are beyond the limit."""
        beyond = np.ndim(got) == 0 and min(abs(got), abs(expected)) > self.limit
        return None if beyond else Mismatch("values", "The number is not that large.")


@dataclass(frozen=True)
class SameShape:
    """Tables of one size: the inverse of a singular matrix is made of chance."""

    def __call__(self, got: Any, expected: Any) -> Mismatch | None:
        """Return None where both have the same shape."""
        alike = np.shape(got) == np.shape(expected)
        return None if alike else Mismatch("shape", "The shape is another one.")


@dataclass(frozen=True, eq=False)
class _Way:
    """A way of making a misconception: whether it gives the student's i-th answer too."""

    misconception: Misconception
    agrees: Callable[[int], bool]


def _ways(own: OwnAnswers, answers: Sequence[Answer], wrong: Sequence[int]) -> Iterator[_Way]:
    """Yield all ways; nothing is compared before it is asked for, as one answer rules most out."""

    def explained(explains: Callable[[Case, Any], bool], i: int) -> bool:
        value = i in wrong and answers[i].status == "value"
        return value and _holds(lambda: explains(own.cases[i], answers[i].value))

    def given_too(compare: Comparison, variant: Callable[..., Any], i: int) -> bool:
        return _alike(compare, answers[i], own.of(variant, i))

    for m in own.exercise.misconceptions:
        if m.explains:
            yield _Way(m, partial(explained, m.explains))
            continue
        compare = m.compare or own.exercise.compare
        for variant in (m.variant, *m.also):
            yield _Way(m, partial(given_too, compare, variant))


def _alike(compare: Comparison, given: Answer, outcome: Answer) -> bool:
    if given.status != "value" or outcome.status != "value":
        return _failure(given) == _failure(outcome)
    if not isinstance(compare, Close):
        return _agrees(compare, given, outcome) or _alike(Close(), given, outcome)
    if _far_apart(compare, given.value, outcome.value):
        return False
    ways = [compare, *(way for way in (Close(), Exactly()) if way != compare)]
    return any(_agrees(way, given, outcome) for way in ways)


def _far_apart(compare: Close, given: Any, outcome: Any) -> bool:
    """Whether numbers differ by more than any way of comparing them lets pass.

    It says so in a fraction of the time that a comparison takes to find its words.
    """
    if isinstance(given, tuple) and isinstance(outcome, tuple):
        pairs = zip(given, outcome, strict=False)
        return len(given) != len(outcome) or any(_far_apart(compare, *pair) for pair in pairs)
    if isinstance(given, dict) and isinstance(outcome, dict):
        other = given.keys() != outcome.keys()
        return other or any(_far_apart(compare, given[key], outcome[key]) for key in given)
    if not all(isinstance(value, float | np.ndarray) for value in (given, outcome)):
        return False
    array, truth = np.asarray(given), np.asarray(outcome)
    if not array.dtype == truth.dtype == float:
        return False
    rtol, atol = max(compare.rtol, Close.rtol), max(compare.atol, Close.atol)
    return array.shape != truth.shape or not close_to(array, truth, rtol, atol).all()


def _failure(answer: Answer) -> tuple[str, str, str]:
    """Return why there is no value.

    Of a message only the words count, as its numbers are the inputs'; and none of them where the
    student raised it: everyone writes other words.
    """
    own = answer.refuses and re.search(r"\braise\b", answer.line)
    said = answer.status == "raised" and not own
    words = "".join(c for c in answer.message if c.isalpha()) if said else ""
    return answer.status, answer.error, words


def _agrees(compare: Comparison, given: Answer, outcome: Answer) -> bool:
    return _holds(lambda: compare(given.value, outcome.value) is None)


def _holds(condition: Callable[[], bool]) -> bool:
    """Whether a condition holds, of answers that may be anything."""
    try:
        return condition()
    except Exception:  # it cannot even be asked of these
        return False
