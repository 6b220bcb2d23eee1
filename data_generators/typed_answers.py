"""What students type into the cells of exercises, and what that is worth."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from inspect import signature
from typing import Any

from course_lib.authoring.expansion import values_answer
from course_lib.exercises.pasting import EXERCISES, Pasted, paste
from course_lib.judging import (
    Exercise,
    Misconception,
    ValuesExercise,
    answer,
    judge,
    pose,
)

#: Seeds on which a wrong answer's points are found; they must agree on all of them.
SEEDS = range(7, 12)


class UnsteadyError(ValueError):
    """What an answer earns depends on the numbers that it is asked with."""


@dataclass(frozen=True)
class Typed:
    """What a student typed into the cell of one exercise, and what that is worth."""

    source: str
    points: float
    hint: str = ""


def right(exercise: Exercise, function: Callable[..., Any] | None = None) -> Typed:
    """Type a right answer: the reference's own source, or that of another function."""
    return Typed(_source(exercise, function or exercise.reference), exercise.points)


def misconceived(exercise: Exercise, misconception: Misconception) -> Typed:
    """Type the answer of someone who has a misconception."""
    points = expected_points(exercise, misconception.variant)
    return Typed(_source(exercise, misconception.variant), points, misconception.hint)


def wrong_answers(exercise: Exercise) -> Iterator[Typed]:
    """Yield the misconceptions whose points are known before the numbers are."""
    for misconception in exercise.misconceptions:
        with suppress(UnsteadyError):
            yield misconceived(exercise, misconception)


def expected_points(exercise: Exercise, function: Callable[..., Any]) -> float:
    """Return what a function earns, on any seed.

    Raises
    ------
    UnsteadyError
        If it depends on the seed.
    """
    found = set()
    for seed in SEEDS:
        cases = pose(exercise, seed)
        found.add(judge(exercise, cases, answer(exercise, function, cases), reveal=False).points)
    if len(found) > 1:
        raise UnsteadyError(f"{function.__name__} earns {sorted(found)}, depending on the seed")
    return found.pop()


def _source(exercise: Exercise, function: Callable[..., Any]) -> str:
    if isinstance(exercise, ValuesExercise):
        return values_answer(exercise, function, exercise.function_name)
    documented = paste(exercise.reference)
    # What is not to be had in a notebook, or not while it is graded.
    elsewhere = not function.__module__.startswith("course_lib.") or _is_an_exercise(function)
    own = paste(function, exercise.function_name, alone=elsewhere)
    renamed = [*signature(function).parameters] != [*signature(exercise.reference).parameters]
    header = own.signature if renamed else documented.signature
    return Pasted(header, documented.docstring, own.body).as_function()


def _is_an_exercise(function: Callable[..., Any]) -> bool:
    return function.__module__.startswith(EXERCISES)
