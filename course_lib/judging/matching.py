"""Find the misconception behind a wrong answer: the one that gives the same answers."""

from __future__ import annotations

from collections.abc import Sequence

from course_lib.judging.answering import Answer, answer
from course_lib.judging.comparison import Close, Comparison
from course_lib.judging.exercise import Case, Exercise, Misconception


def find_misconception(
    exercise: Exercise, cases: Sequence[Case], answers: Sequence[Answer], wrong: Sequence[int]
) -> Misconception | None:
    """Find the misconception that explains all wrong answers.

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
    Misconception or None
        Of those that give the student's answer wherever it is wrong, the one that agrees on most
        of the other cases too.
    """
    if not wrong:
        return None
    agreements = {m.name: _agreement(exercise, m, cases, answers) for m in exercise.misconceptions}
    explaining = [m for m in exercise.misconceptions if all(agreements[m.name][i] for i in wrong)]
    return max(explaining, key=lambda m: sum(agreements[m.name]), default=None)


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
    return any(_agrees(way, given, outcome) for way in (exercise.compare, Close()))


def _agrees(compare: Comparison, given: Answer, outcome: Answer) -> bool:
    try:
        return compare(given.value, outcome.value) is None
    except (TypeError, ValueError):  # what a wrong variant gives need not be comparable in this way
        return False
