"""Where many answers are right: a part's demand judges, and says by how much it is missed."""

import numpy as np
import pytest

from course_lib.judging import Exercise, Misconception, Part, answer, judge, pose
from course_lib.judging.comparison import Mismatch
from course_lib.judging.text import to_text


def sides(area):
    """Return two sides of a rectangle that is at least as large as an area, and no square."""
    return 2 * area, 1.0


def rectangle(rng):
    return {"area": float(rng.uniform(5, 9))}


def large_enough(got, inputs):
    share = got[0] * got[1] / inputs["area"]
    return None if share >= 1 else Mismatch("values", f"Only {share:.0%} of the area.")


def longer_than_wide(got, inputs):
    return None if got[0] != got[1] else Mismatch("values", "This is a square.")


def root(area):
    return np.sqrt(area), np.sqrt(area)


def half(area):
    return area / 2, 1.0


SIDES = Exercise(
    "demo",
    sides,
    parts={
        "large enough": Part(rectangle, demand=large_enough, weight=3),
        "no square": Part(rectangle, demand=longer_than_wide),
    },
    misconceptions=[
        Misconception(root, "Which rectangle is this?"),
        Misconception(
            half,
            "Did you share it out?",
            explains=lambda case, got: large_enough((2 * got[0], got[1]), case.inputs) is None,
        ),
    ],
)


def verdict(function, reveal=True):
    cases = pose(SIDES, 3)
    return judge(SIDES, cases, answer(SIDES, function, cases), reveal=reveal)


@pytest.mark.parametrize(
    "function", [lambda area: (area, 1.0), lambda area: (3.0, area), lambda area: (area / 0.1, 0.5)]
)
def test_any_answer_that_meets_the_demands_earns_all_points(function):
    assert verdict(function).points == SIDES.points


def test_each_demand_has_its_share_of_the_points():
    assert verdict(root).points == 3
    assert verdict(half).points == 1


@pytest.mark.parametrize("reveal", [True, False])
def test_says_by_how_much_a_demand_is_missed_and_expects_no_answer(reveal):
    text = to_text(verdict(half, reveal))
    assert "Only 50% of the area." in text
    assert "expected" not in text
    assert ("your answer" in text) == reveal


def test_a_mistake_is_recognised_in_answers_that_differ_from_its_own():
    assert verdict(lambda area: (area / 1.5, 1.0)).misconceptions == ("half",)
    assert verdict(lambda area: (area / 3, 1.0)).misconceptions == ()
    assert verdict(root).misconceptions == ("root",)


def test_without_a_value_no_mistake_is_explained():
    def fails(area):
        raise ZeroDivisionError

    found = verdict(fails)
    assert found.points == 0
    assert found.misconceptions == ()
