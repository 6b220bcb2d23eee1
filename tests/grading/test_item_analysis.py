"""Difficulty, discrimination and misconceptions of a class of which all is known."""

from types import SimpleNamespace

import numpy as np
import pytest

from course_lib.grading.item_analysis import (
    analyse,
    common_failures,
    common_misconceptions,
    item_rest_correlation,
)
from course_lib.grading.standings import Item, Standing, Standings
from course_lib.grading.states import STATES, failure_of, state_of

ITEMS = (
    Item("pinhole.one", "nb", "one-check", "one", 4.0, by_hand=False),
    Item("pinhole.two", "nb", "two-check", "two", 6.0, by_hand=False),
    Item("pinhole.why", "nb", "why", "why", 2.0, by_hand=True),
)


def student(number, one, two, why=None, **record):
    points = {"pinhole.one": one, "pinhole.two": two, "pinhole.why": why}
    waiting = ("pinhole.why",) if why is None else ()
    return Standing(f"s{number:02d}", points=points, waiting=waiting, record={"exercises": record})


def standings(*students):
    return Standings(SimpleNamespace(name="nb"), ITEMS, students)


def test_values():
    one, two = [4, 4, 4, 4, 4, 2, 0, 0, 0, 0], [6, 6, 6, 3, 3, 3, 3, 0, 0, 0]
    pairs = enumerate(zip(one, two, strict=True))
    first, second, why = analyse(standings(*(student(k, a, b, 1.0) for k, (a, b) in pairs)))
    assert first.difficulty == pytest.approx(22 / 40)
    assert second.difficulty == pytest.approx(30 / 60)
    assert first.discrimination == pytest.approx(np.corrcoef(one, two)[0, 1])
    assert why.difficulty == pytest.approx(0.5)
    assert why.discrimination is None
    assert first.count == 10


def test_an_answer_in_words_has_no_mean_until_all_are_read():
    *_, why = analyse(standings(student(0, 4, 6, 0.0), student(1, 4, 6)))
    assert (why.count, why.difficulty) == (0, None)


def test_a_person_without_points_does_not_count():
    first, *_ = analyse(standings(student(0, 4, 6), Standing("nothing"), student(1, 0, 6)))
    assert (first.count, first.difficulty) == (2, 0.5)


@pytest.mark.parametrize(
    ("points", "rest"),
    [(np.arange(9.0), np.arange(9.0)), (np.ones(20), np.arange(20.0)), (np.zeros(0), np.zeros(0))],
)
def test_no_correlation_where_it_says_nothing(points, rest):
    assert item_rest_correlation(points, rest) is None


def test_an_exercise_that_misleads_the_good_is_negative():
    assert item_rest_correlation(-np.arange(12.0), np.arange(12.0)) == pytest.approx(-1)


@pytest.mark.parametrize(
    ("state", "found"),
    [
        ("full points", {"points": 4, "possible": 4, "attempted": True, "parts": {"a": "right"}}),
        ("some points", {"points": 1, "possible": 4, "attempted": True, "parts": {"a": "raised"}}),
        ("no points", {"points": 0, "possible": 4, "attempted": True, "parts": {"a": "values"}}),
        ("error", {"points": 0, "possible": 4, "attempted": True, "parts": {"a": "time limit"}}),
        ("not tried", {"points": 0, "possible": 4, "attempted": False, "parts": {}}),
        ("not reached", {"points": 0, "possible": 4, "reached": False}),
    ],
)
def test_states(state, found):
    assert state_of(found) == state
    first, *_ = analyse(standings(student(0, 0, 0, **{"pinhole.one": found})))
    assert first.states == {s: int(s == state) for s in STATES}


def test_seconds_are_the_median_of_those_that_are_known():
    def took(seconds):
        return {"pinhole.one": {"points": 4, "possible": 4, "seconds": seconds}}

    found = [student(k, 4, 6, **took(s)) for k, s in enumerate((1.0, 9.0, 0.0, 2.0))]
    first, second, _ = analyse(standings(*found, student(4, 4, 6)))
    assert first.seconds == 2.0
    assert second.seconds is None


def test_misconceptions_of_most_students_come_first_then_those_that_cost_most():
    def wrong(name, points):
        hints = {"misconceptions": [name], "hints": [f"{name}?"]}
        return {"points": points, "possible": 4.0, "attempted": True, "parts": {}, **hints}

    found = common_misconceptions(
        standings(
            student(
                0, 0, 0, **{"pinhole.one": wrong("axes", 3.0), "pinhole.two": wrong("sign", 3)}
            ),
            student(
                1, 0, 0, **{"pinhole.one": wrong("axes", 3.0), "pinhole.two": wrong("unit", 0)}
            ),
        )
    )
    assert [(m.name, m.students, m.points_lost) for m in found] == [
        ("axes", ("s00", "s01"), 2.0),
        ("unit", ("s01",), 4.0),
        ("sign", ("s00",), 1.0),
    ]
    assert found[0].hint == "axes?"


def lost(points, parts, **more):
    return {"points": points, "possible": 4.0, "attempted": True, "parts": parts, **more}


@pytest.mark.parametrize(
    ("said", "found"),
    [
        ("", lost(4.0, {"a": "right", "b": "right"})),
        ("no value returned", lost(0.0, {"a": "type"}, causes={"a": "None"})),
        ("an answer of another type", lost(0.0, {"a": "type"})),
        ("stopped with NameError", lost(0.0, {"a": "raised"}, causes={"a": "NameError"})),
        ("stopped with an error", lost(0.0, {"a": "raised"})),
        ("out of time", lost(0.0, {"a": "time limit"})),
        ("not answered", lost(2.0, {"a": "right", "b": "not attempted"})),
        ("otherwise wrong", lost(0.0, {"a": "values"})),
        ("calls the ready-made function", lost(0.0, {"a": "ready-made"})),
        (
            "stopped with KeyError",
            lost(
                1.0,
                {"a": "type", "b": "right", "c": "raised", "d": "raised"},
                causes={"a": "None", "c": "KeyError", "d": "TypeError"},
            ),
        ),
        ("not reached, because Python had ended above", {"points": 0.0, "reached": False}),
    ],
)
def test_a_failure_is_told_by_what_must_be_mended_first(said, found):
    assert failure_of(found) == said


def test_failures_are_those_without_a_misconception_and_cost_most_first():
    none = lost(2.0, {"a": "type"}, causes={"a": "None"})
    known = lost(0.0, {"a": "values"}, misconceptions=["axes"], hints=["axes?"])
    untried = lost(0.0, {"a": "not attempted"}) | {"attempted": False}
    right = lost(4.0, {"a": "right"})
    found = common_failures(
        standings(
            student(0, 0, 0, **{"pinhole.one": none, "pinhole.two": known}),
            student(1, 0, 0, **{"pinhole.one": none, "pinhole.two": none | {"points": 1.0}}),
            student(2, 0, 0, **{"pinhole.one": known, "pinhole.two": untried}),
            student(3, 0, 0, **{"pinhole.one": right, "pinhole.two": none}),
        )
    )
    assert [(f.name, f.students, f.points_lost) for f in found] == [
        ("no value returned", ("s00", "s01", "s03"), 9.0),
        ("not answered", ("s02",), 4.0),
    ]
    assert list(found[0].lost.items()) == [("pinhole.two", 5.0), ("pinhole.one", 4.0)]
