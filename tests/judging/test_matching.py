"""One mistake in several forms gets one hint, and chance does not hide a huge one."""

import warnings
from dataclasses import replace

import numpy as np
import pytest

from course_lib.exercises import find
from course_lib.exercises.planning.aperture_misconceptions import window
from course_lib.judging import (
    Answer,
    Close,
    Exactly,
    Exercise,
    Misconception,
    OwnAnswers,
    Part,
    answer,
    judge,
    pose,
)
from course_lib.judging.matching import BothBeyond, _agrees, _failure, _far_apart


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


def test_an_answer_that_is_wrong_for_some_inputs_only_gets_its_hint():
    """A part is left at a wrong answer that the mistake does not give, not at a right one."""
    two = Exercise(
        "demo",
        scaled,
        parts={"plain": Part(drawn, cases=2)},
        misconceptions=[Misconception(divided, "Grow or shrink?")],
    )
    cases = pose(two, 3)
    first = cases[0].inputs["factor"]

    def half_mended(values, factor):
        return values * factor if factor == first else values / factor

    verdict = judge(two, cases, answer(two, half_mended, cases))
    assert verdict.hints == ("Grow or shrink?",)


def test_a_form_that_agrees_with_more_parts_does_not_hide_the_one_that_fits():
    def only_for_small_ones(values, factor):
        return values / factor if factor < 1 else values * factor

    two = Exercise(
        "demo",
        scaled,
        parts={"plain": Part(drawn, cases=2), "large": lambda rng: {**drawn(rng), "factor": 90.0}},
        misconceptions=[Misconception(divided, "Grow or shrink?", also=[only_for_small_ones])],
    )
    cases = pose(two, 3)
    wrong = cases[1].inputs["factor"]

    def nearly_mended(values, factor):
        return values / factor if factor == wrong else values * factor

    assert judge(two, cases, answer(two, nearly_mended, cases)).hints == ("Grow or shrink?",)


def with_factors(**factors):
    """Return parts in which the factor is known."""
    return {name: lambda rng, f=f: {**drawn(rng), "factor": f} for name, f in factors.items()}


def test_one_mistake_that_explains_all_goes_before_one_for_each_part():
    """Although the other one agrees with more answers: with those that are right."""

    def above_9(values, factor):
        return values / factor if factor > 9 else values * factor

    def above_9_and_otherwise_above_80(values, factor):
        return above_9(values, factor) + 5 * (factor > 80)

    four = Exercise(
        "demo",
        scaled,
        parts=with_factors(small=2.0, middle=3.0, large=20.0, huge=90.0),
        misconceptions=[
            Misconception(above_9_and_otherwise_above_80, "Of some?"),
            Misconception(divided, "Of all?"),
        ],
    )
    cases = pose(four, 3)
    assert judge(four, cases, answer(four, above_9, cases)).hints == ("Of all?",)


def test_a_mistake_in_two_parts_is_named_once():
    three = replace(EXERCISE, parts=with_factors(one=2.0, two=3.0, three=4.0))
    cases = pose(three, 3)

    def another_in_the_last(values, factor):
        return values / factor if factor < 4 else values - factor

    found = judge(three, cases, answer(three, another_in_the_last, cases))
    assert found.hints == ("Grow or shrink?",)


def test_what_explains_wrong_answers_says_nothing_of_right_ones():
    def small_ones_only(values, factor):
        return values / factor if factor < 3 else values * factor

    two = replace(
        EXERCISE,
        parts={"plain": lambda rng: {**drawn(rng), "factor": float(rng.choice([2, 9]))}},
        misconceptions=[
            Misconception(huge, "What is it?", explains=lambda case, value: True),
            Misconception(small_ones_only, "Only small ones?"),
        ],
    )
    cases = next(c for c in (pose(two, seed) for seed in range(9)) if len({*factors(c)}) == 2)
    found = judge(two, cases, answer(two, small_ones_only, cases))
    assert found.hints == ("Only small ones?",)


def factors(cases):
    return [case.inputs["factor"] for case in cases]


@pytest.mark.parametrize("odd", ["a text", {"a": 1}, [[1.0], [1.0, 2.0]], None, 10**400])
def test_what_cannot_be_explained_is_judged_all_the_same(odd):
    strict = Misconception(huge, "So large?", explains=lambda case, value: value / 1.0 > 1e5)
    exercise = replace(EXERCISE, misconceptions=[strict])
    cases = pose(exercise, 3)
    found = judge(exercise, cases, [Answer("value", odd)] * len(cases))
    assert (found.points, found.hints) == (0, ())


def test_own_answers_are_worked_out_once_and_for_these_cases_only():
    calls = {"right": [], "wrong": []}

    def right(values, factor):
        calls["right"].append(factor)
        return values * factor

    def wrong(values, factor):
        calls["wrong"].append(factor)
        return values / factor

    exercise = Exercise(
        "demo", right, parts={"plain": drawn}, misconceptions=[Misconception(wrong, "Smaller?")]
    )
    cases = pose(exercise, 3)
    own, answers = OwnAnswers(exercise, cases), answer(exercise, divided, cases)
    verdicts = [judge(exercise, cases, answers, own=own) for _ in range(3)]
    assert calls == {"right": factors(cases), "wrong": factors(cases)}
    assert [verdict.hints for verdict in verdicts] == [("Smaller?",)] * 3
    assert judge(exercise, cases, answer(exercise, scaled, cases), own=own).points == 4
    for other, posed in ((exercise, pose(exercise, 3)), (replace(exercise), cases)):
        with pytest.raises(ValueError, match="other cases"):
            judge(other, posed, answers, own=own)


def test_trying_mistakes_leaves_the_inputs_as_they_were():
    def in_place(values, factor):
        values /= factor
        return values

    table = Exercise(
        "demo",
        scaled,
        parts={"plain": lambda rng: {"values": rng.uniform(6, 9, 4), "factor": 2.0}},
        misconceptions=[Misconception(in_place, "Grow or shrink?")],
    )
    cases = pose(table, 3)
    before = cases[0].inputs["values"].copy()
    verdict = judge(table, cases, answer(table, divided, cases))
    assert verdict.hints == ("Grow or shrink?",)
    np.testing.assert_array_equal(cases[0].inputs["values"], before)


def test_a_mistake_that_warns_is_tried_in_silence():
    def warning(values, factor):
        warnings.warn("badly conditioned", RuntimeWarning, stacklevel=1)
        return values / factor

    loud = Exercise(
        "demo",
        scaled,
        parts={"plain": drawn},
        misconceptions=[Misconception(warning, "Grow or shrink?")],
    )
    cases = pose(loud, 3)
    assert judge(loud, cases, answer(loud, divided, cases)).hints == ("Grow or shrink?",)


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


def failed(message, line=""):
    return _failure(Answer("raised", error="ValueError", message=message, line=line))


def test_of_an_error_the_words_count_and_not_the_numbers():
    assert failed("no 7 in 7 rows") == failed("no 12 in 12 rows") != failed("no 7 in 7 columns")


def test_words_of_ones_own_do_not_count_but_those_on_an_array_in_an_if_do():
    mine, theirs = (failed(words, "raise ValueError(…)") for words in ("too near", "no depth"))
    assert mine == theirs
    asked = "The truth value of an array with more than one element is ambiguous."
    assert failed(asked, "if a < 0: raise ValueError") != mine


@pytest.mark.parametrize("size", [1e-12, 1.0, 1e9])
@pytest.mark.parametrize("compare", [Close(), Close(rtol=0, atol=1e-4), Close(rtol=0.1, atol=0)])
@pytest.mark.parametrize(
    "form", [np.asarray, lambda a: float(a[0]), lambda a: (float(a[0]), a), lambda a: {"all": a}]
)
def test_numbers_that_are_far_apart_agree_in_no_way(compare, size, form):
    """What is told apart quickly would be told apart slowly."""
    rng = np.random.default_rng(0)
    seen = set()
    for off in 10.0 ** rng.uniform(-13, 1, 300):
        numbers = size * rng.normal(size=3)
        given, outcome = form(numbers), form(numbers * (1 + off))
        answers = Answer("value", given), Answer("value", outcome)
        slowly = any(_agrees(way, *answers) for way in (compare, Close(), Exactly()))
        quickly = not _far_apart(compare, given, outcome)
        assert quickly or not slowly
        seen.add(quickly)
    assert seen == {True, False} or size == 1e-12


@pytest.mark.parametrize(
    ("given", "outcome"),
    [
        ((1.0, 2.0), (1.0, 2.0, 3.0)),
        ({"a": 1.0}, {"b": 1.0}),
        (np.ones(3), np.ones((3, 1))),
        (1.0, np.ones(1)),
    ],
)
def test_other_sizes_are_far_apart(given, outcome):
    assert _far_apart(Close(), given, outcome)
    assert not _far_apart(Close(), given, given)
    assert not any(way(given, outcome) is None for way in (Close(), Exactly()))


def test_who_refuses_in_own_words_gets_the_hint_of_a_wrong_answer_that_refuses():
    exercise = find("planning.aperture_window")

    def mine(f_mm, near, far, spot_um, wavelength_um):
        least, most = window(f_mm, near, far, spot_um, wavelength_um)
        if least > most:
            raise ValueError("these are other words than those of the exercise")
        return least, most

    cases = pose(exercise, 7)
    assert judge(exercise, cases, answer(exercise, mine, cases)).misconceptions == ("refused",)
