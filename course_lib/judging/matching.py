"""Find the misconception behind wrong answers: the one that gives the same answers."""

from __future__ import annotations

from collections.abc import Sequence

from course_lib.judging.answering import Answer, answer
from course_lib.judging.comparison import Close, Comparison, Exactly
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
    agreements = {m.name: _agreement(exercise, m, cases, answers) for m in exercise.misconceptions}

    def explaining(some: Sequence[int]) -> list[Misconception]:
        """Of those that agree with some answers, return the one that agrees with most others."""
        fitting = [m for m in exercise.misconceptions if all(agreements[m.name][i] for i in some)]
        return [max(fitting, key=lambda m: sum(agreements[m.name]))] if fitting else []

    by_part = [[i for i in wrong if cases[i].part == part] for part in exercise.parts]
    found = explaining(wrong) or [m for some in by_part if some for m in explaining(some)]
    return list({m.name: m for m in found}.values())


def _agreement(
    exercise: Exercise,
    misconception: Misconception,
    cases: Sequence[Case],
    answers: Sequence[Answer],
) -> list[bool]:
    outcomes = answer(exercise, misconception.variant, cases)
    return [_alike(exercise, a, o) for a, o in zip(answers, outcomes, strict=True)]


def _alike(exercise: Exercise, given: Answer, outcome: Answer) -> bool:
    if given.status != "value" or outcome.status != "value":
        return (given.status, given.error) == (outcome.status, outcome.error)
    return any(_agrees(way, given, outcome) for way in (exercise.compare, Close(), Exactly()))


def _agrees(compare: Comparison, given: Answer, outcome: Answer) -> bool:
    try:
        return compare(given.value, outcome.value) is None
    except (TypeError, ValueError):  # what a wrong variant gives need not be comparable in this way
        return False
