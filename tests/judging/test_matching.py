"""One mistake in several forms gets one hint, and chance does not hide a huge one."""

import numpy as np
import pytest

from course_lib.judging import Exercise, Misconception, answer, judge, pose
from course_lib.judging.matching import BothBeyond


def scaled(values, factor):
    """Return the values times a factor."""
    return values * factor


def divided(values, factor):
    return values / factor


def upside_down(values, factor):
    return factor / values


def huge(values, factor):
    return 1e6


def drawn(rng):
    return {"values": float(rng.uniform(6, 9)), "factor": float(rng.uniform(2, 5))}


EXERCISE = Exercise(
    "demo",
    scaled,
    parts={"plain": drawn},
    misconceptions=[
        Misconception(divided, "Grow or shrink?", also=[upside_down]),
        Misconception(huge, "So large?", compare=BothBeyond(1000)),
    ],
)


@pytest.mark.parametrize(
    ("function", "hints"),
    [
        (lambda values, factor: values / factor, ("Grow or shrink?",)),
        (lambda values, factor: factor / values, ("Grow or shrink?",)),
        (lambda values, factor: -3e5 * factor, ("So large?",)),
        (lambda values, factor: values + factor, ()),
        (lambda values, factor: np.full(3, 2e6), ()),
        (lambda values, factor: values * factor, ()),
    ],
)
def test_each_form_of_a_mistake_gets_its_hint(function, hints):
    cases = pose(EXERCISE, 3)
    assert judge(EXERCISE, cases, answer(EXERCISE, function, cases)).hints == hints


def test_the_name_is_that_of_the_first_form():
    cases = pose(EXERCISE, 3)
    found = judge(EXERCISE, cases, answer(EXERCISE, upside_down, cases))
    assert found.misconceptions == ("divided",)


def unpacked(values, factor):
    first, second = np.full(3, values)
    return first * factor + second


def unpacked_elsewhere(values, factor):
    one, other = range(round(9 + factor))  # too many, but another number of them
    return one * other


RAISING = Exercise(
    "demo",
    scaled,
    parts={"plain": drawn},
    misconceptions=[Misconception(unpacked, "How many values are there?")],
)


@pytest.mark.parametrize(
    ("function", "hints"),
    [
        (lambda values, factor: np.full(3, values) * np.full(5, factor), ()),
        (lambda values, factor: float("many"), ()),
        (unpacked, ("How many values are there?",)),
        (unpacked_elsewhere, ("How many values are there?",)),
    ],
)
def test_the_same_exception_for_another_reason_is_another_mistake(function, hints):
    cases = pose(RAISING, 3)
    answers = answer(RAISING, function, cases)
    assert {(a.status, a.error) for a in answers} == {("raised", "ValueError")}
    assert judge(RAISING, cases, answers).hints == hints
