import numpy as np
import pytest

from course_lib.exercises import find
from course_lib.grading.vetting import CRASHED, OWN_ERROR, compare, vet
from course_lib.judging import pose
from course_lib.judging.text import to_text

EXERCISE = find("pinhole.dolly_zoom")
CASE = pose(EXERCISE, 1)[0]
NAME = next(iter(CASE.inputs))
LINES = ["return distance / 0"]


def vetted(reply):
    return vet(EXERCISE, CASE, reply, LINES, 5.0)


@pytest.mark.parametrize(
    "reply",
    [
        None, 3, "value", [], {}, {"status": "points", "value": 4.0}, {"status": []},
        {"status": np.array(["value", "raised"])},
    ],
)  # fmt: skip
def test_what_is_no_answer_is_a_crash(reply):
    answer, hidden = vetted(reply)
    assert (answer.status, answer.error) == ("raised", CRASHED)
    assert not hidden


def test_an_honest_answer_passes():
    answer, _ = vetted({"status": "value", "value": 2.5, "changed_inputs": (NAME, "secret")})
    assert (answer.status, answer.value, answer.changed_inputs) == ("value", 2.5, (NAME,))


def test_a_value_that_was_not_given_is_none():
    assert vetted({"status": "raised", "error": "ValueError", "value": 4.0})[0].value is None


@pytest.mark.parametrize(
    ("error", "shown"), [("ValueError", "ValueError"), ("LinAlgError", "LinAlgError"),
                         ("DegenerateConfigurationError", "DegenerateConfigurationError"),
                         ("E0_123", OWN_ERROR), (7, OWN_ERROR), (None, OWN_ERROR)],
)  # fmt: skip
def test_only_known_exceptions_are_named(error, shown):
    assert vetted({"status": "raised", "error": error})[0].error == shown


@pytest.mark.parametrize("status", ["raised", "not attempted", "not plain", "too large"])
def test_no_text_of_the_students_reaches_the_verdict(status):
    reply = {"status": status, "message": "secret", "line": "secret", "error": "secret"}
    answers = [vetted(reply)[0] for _ in pose(EXERCISE, 1)]
    assert "secret" not in to_text(compare(EXERCISE, pose(EXERCISE, 1), answers))


def test_a_line_of_the_submission_is_shown():
    reply = {"status": "raised", "error": "ZeroDivisionError", "line": LINES[0]}
    assert vetted(reply)[0].line == LINES[0]


def test_hidden_functions_count_for_their_own_exercise_only():
    own = f"{EXERCISE.reference.__module__}.dolly_zoom"
    answer, hidden = vetted({"status": "value", "value": 1.0, "hidden": [own, "course_lib.x.y"]})
    assert answer.called == (own,)
    assert hidden == {"course_lib.x.y"}


def test_a_missing_function_is_said_in_words():
    assert "There is no function `dolly_zoom`" in vetted({"missing": ""})[0].message
    for forged in ("secret", np.array(["", ""]), []):
        assert "is no function here" in vetted({"missing": forged})[0].message


@pytest.mark.parametrize("value", [{"a": 1}, "text", [[1], [2, 3]], 1j, (1, 2), float("nan")])
def test_whatever_is_compared_is_judged(value):
    cases = pose(EXERCISE, 1)
    reply = {"status": "value", "value": value}
    verdict = compare(EXERCISE, cases, [vet(EXERCISE, c, reply, [], 5.0)[0] for c in cases])
    assert verdict.points == 0


@pytest.mark.parametrize(
    "value",
    [
        np.zeros((0, 35_123_456)), np.zeros((1,) * 9), [np.zeros((0, 10**6))],
        [""] * 3000 + ["x" * 4_000_000], {"a": ("x" * 1000, *range(10_000))},
        np.array(["", "x" * 1000] * 1000), ("x" * 2_000_000,), {"x" * 2_000_000: 1},
    ],
    ids=lambda value: type(value).__name__,
)  # fmt: skip
def test_values_that_would_fill_the_memory_or_tell_numbers_are_too_large(value):
    """As an array, three thousand texts with one of four million letters take 48 GB."""
    answer, _ = vetted({"status": "value", "value": value})
    assert (answer.status, answer.value, answer.message) == ("too large", None, "too many bytes")


@pytest.mark.parametrize(
    "value", [np.zeros((0, 3)), np.zeros((480, 640, 3)), ["ab"] * 1000, {"a": (1, "text")}, []]
)
def test_usual_values_are_not_too_large(value):
    assert vetted({"status": "value", "value": value})[0].value is value


def test_a_decimal_comma_cannot_bring_an_input_out():
    cases = pose(EXERCISE, 1)
    for value, told in [((12, 5), True), ((35_123_456, 5), False), ((3, 10**30), False)]:
        answers = [vetted({"status": "value", "value": value})[0] for _ in cases]
        assert (f"{value[0]}.{value[1]}" in to_text(compare(EXERCISE, cases, answers))) == told
