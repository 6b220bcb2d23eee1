"""Find the misconception behind wrong answers: the one that gives the same answers."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from course_lib.judging.answering import Answer, own_answers
from course_lib.judging.comparison import Close, Comparison, Exactly, Mismatch, close_to
from course_lib.judging.exercise import Case, Exercise, Misconception


def find_misconceptions(
    exercise: Exercise, cases: Sequence[Case], answers: Sequence[Answer], wrong: Sequence[int]
) -> list[Misconception]:
    """Find the misconception that explains all wrong answers, or else one for each wrong part.

    Parameters
    ----------
    exercise : Exercise
        Whose misconceptions are tried, on the same cases.
    cases : sequence of Case
        What was asked.
    answers : sequence of Answer
        What the student's function gave.
    wrong : sequence of int
        Which of the answers are wrong.

    Returns
    -------
    list of Misconception
        Empty where no misconception gives the same answers.
    """
    if not wrong:
        return []
    agreements = {
        m.name: _agreement(exercise, m, cases, answers, wrong) for m in exercise.misconceptions
    }

    def explaining(some: Sequence[int]) -> list[Misconception]:
        """Of those that agree with some answers, return the one that agrees with most others."""
        fitting = [m for m in exercise.misconceptions if all(agreements[m.name][i] for i in some)]
        return [max(fitting, key=lambda m: sum(agreements[m.name]))] if fitting else []

    by_part = [[i for i in wrong if cases[i].part == part] for part in exercise.parts]
    found = explaining(wrong) or [m for some in by_part if some for m in explaining(some)]
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


def _agreement(
    exercise: Exercise,
    misconception: Misconception,
    cases: Sequence[Case],
    answers: Sequence[Answer],
    wrong: Sequence[int],
) -> list[bool]:
    """Return which answers a misconception gives too.

    A part is left at the first wrong answer that it does not give: it does not explain that part.
    """
    if misconception.explains:
        explains = misconception.explains
        return [
            i in wrong and given.status == "value" and explains(case, given.value)
            for i, (case, given) in enumerate(zip(cases, answers, strict=True))
        ]
    compare = misconception.compare or exercise.compare
    by_part = [[i for i, case in enumerate(cases) if case.part == p] for p in exercise.parts]

    def agreement(variant: Callable[..., Any]) -> list[bool]:
        agrees = [False] * len(cases)
        for part in by_part:
            outcomes = own_answers(exercise, variant, (cases[i] for i in part))
            for i, outcome in zip(part, outcomes, strict=True):
                agrees[i] = _alike(compare, answers[i], outcome)
                if i in wrong and not agrees[i]:
                    break
        return agrees

    ways = [agreement(variant) for variant in (misconception.variant, *misconception.also)]
    return max(ways, key=lambda way: _explained(cases, way))


def _explained(cases: Sequence[Case], agreement: Sequence[bool]) -> tuple[int, int]:
    """Return how many parts, and how many cases, a variant answers as the student did."""
    parts = {case.part for case in cases}
    differing = {c.part for c, agrees in zip(cases, agreement, strict=True) if not agrees}
    return len(parts - differing), sum(agreement)


def _alike(compare: Comparison, given: Answer, outcome: Answer) -> bool:
    if given.status != "value" or outcome.status != "value":
        return _failure(given) == _failure(outcome)
    if isinstance(compare, Close) and _far_apart(compare, given.value, outcome.value):
        return False
    ways = [compare, *(way for way in (Close(), Exactly()) if way != compare)]
    return any(_agrees(way, given, outcome) for way in ways)


def _far_apart(compare: Close, given: Any, outcome: Any) -> bool:
    """Whether arrays of numbers differ by more than any way of comparing them lets pass.

    It says so in a fraction of the time that a comparison takes to find its words.
    """
    arrays = isinstance(given, np.ndarray) and isinstance(outcome, np.ndarray)
    if not arrays or given.shape != outcome.shape or not given.dtype == outcome.dtype == float:
        return False
    rtol, atol = max(compare.rtol, Close.rtol), max(compare.atol, Close.atol)
    return not close_to(given, outcome, rtol, atol).all()


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
    try:
        return compare(given.value, outcome.value) is None
    except (TypeError, ValueError):  # what a wrong variant gives need not be comparable in this way
        return False
