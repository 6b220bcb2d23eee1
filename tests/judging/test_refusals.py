"""Inputs that have no answer: only the right exception is right."""

from dataclasses import replace

import numpy as np
import pytest

from course_lib.judging import Exercise, Known, Misconception, Raises, answer, judge, pose
from course_lib.judging.html import to_html


def root(value):
    """Return the square root."""
    if value < 0:
        raise ValueError("no root")
    return value**0.5


ROOT = Exercise(
    "demo",
    root,
    parts={
        "positive": lambda rng: {"value": float(rng.uniform(1, 9))},
        "negative": lambda rng: Known({"value": -float(rng.uniform(1, 9))}, Raises("ValueError")),
    },
    misconceptions=[Misconception(lambda value: abs(value) ** 0.5, "What about the sign?")],
    points=4,
)


def refusing(error):
    def function(value):
        if value < 0:
            raise error
        return value**0.5

    return function


def refused(function, reveal=True):
    cases = pose(ROOT, 3)
    return judge(ROOT, cases, answer(ROOT, function, cases), reveal=reveal)


def test_refusing_what_has_no_answer_is_right():
    assert refused(refusing(ValueError("negative"))).points == 4


@pytest.mark.parametrize("reveal", [True, False])
def test_an_answer_where_there_is_none_is_wrong(reveal):
    found = refused(lambda value: abs(value) ** 0.5, reveal)
    assert [part.points for part in found.parts] == [2, 0]
    assert found.hints == ("What about the sign?",)
    assert "should raise a ValueError" in found.parts[1].feedback.message
    assert to_html(found)


def test_another_exception_than_the_right_one_is_wrong():
    found = refused(refusing(KeyError("negative")))
    assert found.points == 2
    message = found.parts[1].feedback.message
    assert "should raise a ValueError" in message
    assert "stopped with KeyError" in message


def test_an_array_in_an_if_is_no_refusal():
    def asked_at_once(value):
        if np.array([value, value]) < 0:
            raise ValueError
        return value**0.5

    found = refused(asked_at_once)
    assert found.points == 0
    assert "one yes or no" in found.parts[1].feedback.message


def test_the_words_of_a_students_own_error_do_not_hide_the_misconception():
    def refuses_all(value):
        raise ValueError("this has no root, I think")

    def refuses_all_in_silence(value):
        raise ValueError

    too_strict = Misconception(refuses_all_in_silence, "Has nothing a root?")
    exercise = replace(ROOT, misconceptions=[too_strict])
    cases = pose(exercise, 3)
    assert judge(exercise, cases, answer(exercise, refuses_all, cases)).hints == (too_strict.hint,)


def test_a_function_that_is_not_there_yet_does_not_refuse():
    found = refused(refusing(NotImplementedError()))
    assert found.points == 2
    assert not refused(lambda value: root_not_written()).attempted


def root_not_written():
    raise NotImplementedError
