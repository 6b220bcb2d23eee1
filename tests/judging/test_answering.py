"""A student's function may do anything; a list of plain answers comes back."""

import contextlib
import statistics
import sys
import threading
import time
from collections import defaultdict

import numpy as np
import pytest

from course_lib.judging import Exercise, Limits, Misconception, answer, pose

QUICK = Limits(seconds=0.2)


def doubled(numbers):
    """Return twice the numbers."""
    return 2 * numbers


def draw(rng):
    return {"numbers": rng.uniform(1, 2, 3)}


EXERCISE = Exercise(
    "demo",
    doubled,
    parts={"some numbers": draw},
    misconceptions=[Misconception(lambda numbers: numbers, "Is it twice as much?")],
    forbidden=("numpy.add.reduce", "math.fsum", "textwrap.dedent"),
)
CASES = pose(EXERCISE, 1)


def first(function, limits=QUICK):
    return answer(EXERCISE, function, CASES, limits)[0]


def test_value_comes_back_as_plain_data():
    class Tagged(np.ndarray):
        pass

    given = first(lambda numbers: (2 * numbers).view(Tagged))
    assert given.status == "value"
    assert type(given.value) is np.ndarray
    for number in (np.float64(2), np.array(2.0), np.longdouble(2)):
        assert type(first(lambda numbers, n=number: n).value) is float
    assert first(lambda numbers: np.ones(2, np.longdouble)).value.dtype == float
    assert first(lambda numbers: {"a": (1, [2.5, "x", None, True])}).value == {
        "a": (1, [2.5, "x", None, True])
    }


def test_tuples_with_names_and_dictionaries_with_a_default_are_plain():
    pair = statistics.linear_regression([0, 1], [1, 3])
    given = first(lambda numbers: [pair, defaultdict(int, a=1)]).value
    assert given == [(2, 1), {"a": 1}]
    assert [type(one) for one in given] == [tuple, dict]


def test_stub_was_not_attempted():
    def stub(numbers):
        raise NotImplementedError

    assert [given.status for given in answer(EXERCISE, stub, CASES)] == ["not attempted"] * 3


def test_exception_names_the_student_s_line():
    def broken(numbers):
        return 2 * numbers[7]

    given = first(broken)
    assert (given.status, given.error) == ("raised", "IndexError")
    assert given.line == "return 2 * numbers[7]"


@pytest.mark.parametrize("ending", [SystemExit, RecursionError, MemoryError, GeneratorExit])
def test_any_exception_ends_only_the_answer(ending):
    def stops(numbers):
        raise ending("enough")

    assert first(stops).error == ending.__name__


def test_interrupting_the_kernel_still_works():
    def interrupted(numbers):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        first(interrupted)


def test_endless_loop_ends_at_the_limit_and_the_rest_is_not_tried():
    calls = []

    def loops(numbers):
        calls.append(1)
        while True:
            pass

    answers = answer(EXERCISE, loops, CASES, QUICK)
    assert [given.status for given in answers] == ["time limit"] * 3
    assert len(calls) == 1


def test_loop_that_swallows_exceptions_ends_too():
    def stubborn(numbers):
        while True:
            with contextlib.suppress(Exception):
                time.sleep(0.01)

    assert first(stubborn).status == "time limit"


def test_sleeping_ends_at_the_limit():
    start = time.monotonic()
    assert first(lambda numbers: time.sleep(60)).status == "time limit"
    assert time.monotonic() - start < 30


def test_who_has_to_wait_for_the_processor_is_held_to_the_clock_later():
    def late(numbers):
        time.sleep(0.4)
        return 2 * numbers

    assert first(late).status == "time limit"
    assert first(late, Limits(seconds=0.2, clock=60.0)).status == "value"
    assert first(lambda _: time.sleep(60), Limits(60.0, clock=0.2)).status == "time limit"
    endless = Limits(seconds=0.2, clock=60.0)
    assert first(lambda _: all(True for _ in iter(int, 1)), endless).status == "time limit"


def test_endless_loop_ends_outside_the_main_thread():
    """Where signals do not reach (other threads, Windows) a watchdog stops Python code."""

    def loops(numbers):
        while True:
            pass

    found = []
    thread = threading.Thread(target=lambda: found.append(first(loops).status))
    thread.start()
    thread.join(20)
    assert found == ["time limit"]


def test_watchdog_leaves_a_quick_answer_alone():
    found = []

    def loops(numbers):
        while True:
            pass

    def many():
        first(loops)
        found.extend(first(doubled).status for _ in range(200))
        time.sleep(0.3)  # a late exception would arrive here

    thread = threading.Thread(target=many)
    thread.start()
    thread.join(20)
    assert found == ["value"] * 200


def test_changed_inputs_are_named_and_do_not_spoil_the_case():
    before = CASES[0].inputs["numbers"].copy()

    def changes(numbers):
        numbers *= 2
        return numbers

    given = first(changes)
    assert given.changed_inputs == ("numbers",)
    np.testing.assert_array_equal(CASES[0].inputs["numbers"], before)
    np.testing.assert_array_equal(given.value, 2 * before)


def test_printing_is_caught_and_bounded(capsys):
    def chatty(numbers):
        print("x" * 10_000_000)
        print("error", file=sys.stderr)
        return 2 * numbers

    given = first(chatty)
    assert len(given.printed) < 3000
    assert "more was printed" in given.printed
    captured = capsys.readouterr()
    assert (captured.out, captured.err) == ("", "")


def test_warnings_do_not_reach_stderr(capsys):
    given = first(lambda numbers: numbers / np.zeros(3))
    assert "divide by zero" in given.warned[0]
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize("value", [object(), lambda: 0, {1.5: 2}, [[[[[[1]]]]]], b"bytes"])
def test_what_is_not_plain_is_refused(value):
    assert first(lambda numbers: value).status == "not plain"


@pytest.mark.parametrize(
    "make",
    [
        lambda: np.zeros((5000, 5000)),
        lambda: np.broadcast_to(np.zeros(1), (10**6, 10**6)),
        lambda: [0] * 30_000_000,
        lambda: "x" * 30_000_000,
    ],
)
def test_huge_results_are_refused(make):
    assert first(lambda numbers: make(), Limits(seconds=20)).status == "too large"


def test_ragged_object_array_becomes_lists():
    ragged = np.array([[1, 2], None], dtype=object)
    assert first(lambda numbers: ragged).value == [[1, 2], None]


def test_calls_of_the_reference_are_noted_under_any_name():
    alias = doubled

    def borrowed(numbers):
        return [alias][0](numbers)

    assert first(borrowed).called == (f"{doubled.__module__}.doubled",)
    assert first(lambda numbers: 2 * numbers).called == ()


def test_calls_of_forbidden_builtins_are_noted():
    import math

    assert first(lambda numbers: math.fsum(numbers)).called == ("math.fsum",)


def test_calls_of_forbidden_functions_are_noted_by_the_module_that_defines_them():
    import textwrap

    def dedent(numbers):  # a student's own function may have that name
        return 2 * numbers

    assert first(lambda numbers: textwrap.dedent(" 2")).called == ("textwrap.dedent",)
    assert first(lambda numbers: dedent(numbers)).called == ()


def test_profile_function_and_alarm_are_restored():
    def profile(*_):
        return None

    sys.setprofile(profile)
    try:
        first(doubled)
        assert sys.getprofile() is profile
    finally:
        sys.setprofile(None)
