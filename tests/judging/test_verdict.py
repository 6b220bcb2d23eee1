"""Points by parts, feedback in order, the hint of the right misconception, nothing given away."""

import re
from dataclasses import replace

import numpy as np
import pytest

from course_lib.judging import (
    Close,
    Exercise,
    Known,
    Misconception,
    Part,
    ValuesExercise,
    answer,
    judge,
    pose,
)
from course_lib.judging.html import to_html
from course_lib.judging.text import to_text


def scaled(values, factor):
    """Return the values times a factor."""
    return values * factor


def plain_values(rng):
    return {"values": rng.uniform(1, 9, 4), "factor": float(rng.uniform(2, 5))}


def negative_factor(rng):
    return {"values": rng.uniform(1, 9, 4), "factor": -float(rng.uniform(2, 5))}


def divided(values, factor):
    return values / factor


def sign_lost(values, factor):
    return values * abs(factor)


EXERCISE = Exercise(
    "demo",
    scaled,
    parts={"plain": Part(plain_values, weight=3), "negative": negative_factor},
    misconceptions=[
        Misconception(divided, "Should the values grow or shrink?"),
        Misconception(sign_lost, "What about the sign?"),
    ],
    points=4,
)


def verdict(function, reveal=True, seed=3):
    cases = pose(EXERCISE, seed)
    return judge(EXERCISE, cases, answer(EXERCISE, function, cases), reveal=reveal)


def test_what_is_known_by_construction_judges_the_reference_too():
    known = replace(
        EXERCISE,
        parts={"known": lambda rng: Known({"values": np.ones(2), "factor": 3.0}, np.full(2, 3.1))},
    )
    cases = pose(known, 3)
    assert judge(known, cases, answer(known, lambda values, factor: 3.1 * values, cases)).points
    assert not judge(known, cases, answer(known, lambda values, factor: 3 * values, cases)).points


def test_numbers_with_few_digits_are_told():
    exact = replace(EXERCISE, compare=Close(rtol=1e-12))

    def rounded(values, factor):
        return (values * factor).astype(np.float32)

    def off(values, factor):
        return values * factor + 1

    cases = pose(exact, 3)
    for function, told in ((rounded, True), (off, False)):
        found = judge(exact, cases, answer(exact, function, cases))
        assert ("float64 has 16" in found.parts[0].feedback.message) == told


@pytest.mark.parametrize(
    ("second", "kind"),
    [
        (lambda right: 1 / 0, "raised"),
        (lambda right: "text", "type"),
        (lambda right: right[:1], "shape"),
        (lambda right: right, "values"),
        (lambda right: not_written_yet(), "values"),
    ],
)
def test_what_comes_first_in_a_part_is_what_must_be_mended_first(second, kind):
    two = replace(EXERCISE, parts={"both": Part(plain_values, cases=2)})
    cases = pose(two, 3)
    first = cases[0].inputs["factor"]

    def mixed(values, factor):
        return values * factor + 1 if factor == first else second(values * factor)

    for order in (cases, cases[::-1]):
        found = judge(two, order, answer(two, mixed, order))
        assert [part.feedback.kind for part in found.parts] == [kind]
        assert found.attempted


def not_written_yet():
    raise NotImplementedError


@pytest.mark.parametrize(
    ("make", "told"),
    [
        (lambda values: (v for v in values), " Make a list of it: `list(…)`."),
        (lambda values: values.sum, " Round brackets call a function: are they missing?"),
        (lambda values: object(), ""),
    ],
)
def test_what_is_no_answer_yet_is_told_how_to_become_one(make, told):
    message = verdict(lambda values, factor: make(factor * values)).parts[0].feedback.message
    assert message.endswith(f"arrays and numbers are expected.{told}")


def test_full_answer():
    full = verdict(lambda values, factor: np.array([factor * v for v in values]))
    assert (full.points, full.possible, full.hints) == (4, 4, ())


def test_partial_credit_by_weight_and_hint_of_the_failed_part():
    half = verdict(lambda values, factor: values * abs(factor))
    assert [part.points for part in half.parts] == [3, 0]
    assert half.misconceptions == ("sign_lost",)


def test_a_hint_needs_agreement_in_every_wrong_answer_of_a_part():
    def sometimes(values, factor):
        return values / factor if factor > 3 else values + 1

    assert verdict(sometimes).hints == ()


def test_each_wrong_part_can_have_a_hint_of_its_own():
    def two_mistakes(values, factor):
        return values / factor if factor > 0 else values * abs(factor)

    assert verdict(two_mistakes).misconceptions == ("divided", "sign_lost")


def test_untouched_function_is_told_why_where_there_is_none():
    def missing(values, factor):
        raise NotImplementedError("There is no function yet.")

    found = verdict(missing)
    assert not found.attempted
    assert "There is no function yet." in to_text(found)


def test_exceptions_are_put_in_plain_words():
    found = verdict(lambda values, factor: tuple(values) - 1)
    assert "np.array" in found.parts[0].feedback.message
    found = verdict(lambda values, factor: re.search("a", "b").group())
    assert "a search found nothing" in found.parts[0].feedback.message
    hidden = verdict(lambda values, factor: tuple(values) - 1, reveal=False)
    assert "np.array" in hidden.parts[0].feedback.message


@pytest.mark.parametrize("told", ["a line ends", "a line ends.", "does a line end?"])
def test_what_an_exception_says_ends_with_one_mark(told):
    def stopped(values, factor):
        raise ArithmeticError(told)

    assert re.search(r"ends?[.?]( \w|$)", verdict(stopped).parts[0].feedback.message)


def test_a_misconception_may_give_texts():
    def texts(values, factor):
        return [str(value) for value in values]

    exercise = replace(EXERCISE, misconceptions=[Misconception(texts, "Can one compute with it?")])
    cases = pose(exercise, 3)
    found = judge(exercise, cases, answer(exercise, texts, cases))
    assert found.misconceptions == ("texts",)


def test_warnings_are_a_note_and_cost_nothing():
    def warns(values, factor):
        return values * factor + 0 * (values / np.zeros(4) > 0)

    found = verdict(warns)
    assert found.points == 4
    assert "divide by zero" in found.notes[0]
    assert "harmless" in found.notes[0]
    assert verdict(warns, reveal=False).notes == ()


def rows(values):
    return 1 / np.where(values == 0, np.nan, values)


def with_a_zero(rng):
    return {"values": np.append(rng.uniform(1, 9, (3, 1)), [[0.0]], axis=0)}


ROWS = Exercise("demo", rows, parts={"rows": with_a_zero}, misconceptions=[])


def notes_on(function):
    cases = pose(ROWS, 3)
    return judge(ROWS, cases, answer(ROWS, function, cases)).notes


def test_warning_of_a_wrong_answer_points_to_the_row_and_is_not_called_harmless():
    (note,) = notes_on(lambda values: 1 / values)
    assert "divide by zero" in note
    assert "row 3 of the answer" in note
    assert "harmless" not in note
    (note,) = notes_on(lambda values: np.nan_to_num(1 / values, posinf=5))
    assert "is wrong" in note
    assert "harmless" not in note
    (note,) = notes_on(lambda values: np.vstack([1 / values[:2], 1 / (0 * values[2:])]))
    assert "rows 2 and 3" in note


def test_warning_beside_a_wrong_answer_elsewhere_is_harmless():
    def wrong_for_negative(values, factor):
        if factor < 0:
            return values
        return values * factor + 0 * (values / np.zeros(4) > 0)

    found = verdict(wrong_for_negative)
    assert 0 < found.points < 4
    assert "harmless" in found.notes[0]


def test_nearly_right_says_so():
    found = verdict(lambda values, factor: values * factor * 1.001)
    assert found.points == 0
    assert "Nearly right" in found.parts[0].feedback.message


def test_example_is_labelled_with_its_part():
    html = to_html(verdict(sign_lost))
    assert "What was tried for <i>negative</i>" in html
    lines = to_text(verdict(sign_lost)).splitlines()
    assert next(i for i, x in enumerate(lines) if "negative (" in x) < next(
        i for i, x in enumerate(lines) if "expected =" in x
    )


def test_fixed_numbers_are_not_given_away():
    exercise = ValuesExercise(
        "demo",
        lambda side: {"area": side**2, "rim": 4 * side},
        misconceptions=[],
        given={"side": 7.0},
        units={"area": "m²", "rim": "m"},
    )
    cases = pose(exercise, 1)
    found = judge(exercise, cases, answer(exercise, lambda **_: {"area": 14.0, "rim": 28}, cases))
    assert [part.points for part in found.parts] == [0, 2]
    assert "49" not in to_text(found) + to_html(found)
    assert "14" in to_text(found)


def test_of_two_explanations_the_one_that_fits_more_answers_wins():
    """Both lose the sign of a negative factor; only the second also spoils the other part."""

    def positive_and_one_more(values, factor):
        return values * abs(factor) + (factor > 0)

    exercise = replace(
        EXERCISE,
        misconceptions=[
            Misconception(positive_and_one_more, "Why one more?"),
            Misconception(sign_lost, "What about the sign?"),
        ],
    )
    cases = pose(exercise, 3)
    found = judge(exercise, cases, answer(exercise, sign_lost, cases))
    assert found.misconceptions == ("sign_lost",)


@pytest.mark.parametrize(
    ("function", "kind"),
    [
        (lambda values, factor: object(), "type"),
        (lambda values, factor: 1 / 0, "raised"),
        (lambda values, factor: None, "type"),
        (lambda values, factor: (values * factor)[:2], "shape"),
        (lambda values, factor: values * factor + 1, "values"),
        (lambda values, factor: scaled(values, factor), "ready-made"),
    ],
)
def test_kinds_of_feedback(function, kind):
    found = verdict(function)
    assert {part.feedback.kind for part in found.parts} == {kind}
    assert found.points == 0


@pytest.mark.parametrize("reveal", [True, False])
@pytest.mark.parametrize(
    ("function", "cause"),
    [
        (lambda values, factor: 1 / 0, "ZeroDivisionError"),
        (lambda values, factor: None, "None"),
        (lambda values, factor: values * factor + 1, ""),
        (lambda values, factor: values * factor, ""),
    ],
)
def test_what_made_an_answer_wrong_is_kept(function, cause, reveal):
    found = verdict(function, reveal)
    assert {part.feedback.cause for part in found.parts} == {cause}


def test_grading_seeds_are_not_given_away():
    def wrong(values, factor):
        print("secret", values, factor)
        raise ValueError(f"{values} {factor}")

    for function in (wrong, divided, lambda values, factor: values * factor + 1):
        hidden = verdict(function, reveal=False)
        shown = to_text(hidden) + to_html(hidden)
        for case in pose(EXERCISE, 3):
            for number in (*case.inputs["values"], case.inputs["factor"]):
                assert f"{number:.3f}"[:5] not in shown
        assert "secret" not in shown
        assert not any(part.feedback.has_example for part in hidden.parts)
    assert verdict(divided, reveal=False).hints == ("Should the values grow or shrink?",)


def test_visible_and_hidden_results_earn_alike():
    for function in (divided, sign_lost, lambda values, factor: values * factor):
        assert verdict(function, True).points == verdict(function, False, seed=99).points


def test_example_shows_inputs_got_and_expected():
    text = to_text(verdict(divided))
    for word in ("values =", "factor =", "your answer =", "expected =", "Hint:"):
        assert word in text


def test_changed_inputs_are_noted_without_loss():
    def in_place(values, factor):
        values *= factor
        return values

    found = verdict(in_place)
    assert found.points == 4
    assert "`values`" in found.notes[0]


def test_html_escapes_what_a_student_writes():
    def nasty(values, factor):
        print("<script>alert(1)</script>")
        raise ValueError("<img src=x onerror=alert(2)>")

    html = to_html(verdict(nasty))
    assert "<script>" not in html
    assert "<img" not in html
    assert "&lt;script&gt;" in html


def test_html_escapes_what_a_student_returns():
    html = to_html(verdict(lambda values, factor: "<b>bold</b>"))
    assert "<b>bold" not in html
    assert "&lt;b&gt;bold" in html


def test_html_does_not_rely_on_colour():
    html = to_html(verdict(sign_lost))
    assert "✓" in html
    assert "✗" in html
    assert 'aria-label="not right"' in html
