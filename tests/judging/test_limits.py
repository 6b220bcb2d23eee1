"""Limits of time: of the processor or by the clock, one inside another, swallowed or not."""

import signal
import threading
import time
from contextlib import suppress

import pytest

from course_lib.judging.limits import TimeLimitReached, time_limit

LONG = 60.0


def compute(seconds=LONG):
    start = time.process_time()
    while time.process_time() - start < seconds:
        pass


@pytest.mark.parametrize(
    ("limits", "work"),
    [
        ((0.1,), time.sleep),  # by the clock
        ((0.1,), compute),
        ((0.1, LONG), compute),  # of the processor
        ((LONG, 0.1), time.sleep),  # waits without computing
    ],
)
def test_what_takes_too_long_is_stopped(limits, work):
    with pytest.raises(TimeLimitReached), time_limit(*limits) as bell:
        work(LONG)
    assert bell.rang


def test_who_has_to_wait_for_the_processor_loses_nothing():
    with time_limit(0.2, LONG) as bell:
        time.sleep(0.5)
        compute(0.05)
    assert not bell.rang


def test_it_says_so_where_the_exception_was_swallowed():
    with time_limit(0.05) as bell, suppress(BaseException):
        time.sleep(LONG)
    assert bell.rang


@pytest.mark.parametrize("limits", [(0.3,), (0.3, 0.3), (LONG, 0.3)])
@pytest.mark.parametrize("inner", [0.1, LONG])
def test_a_limit_inside_another_takes_nothing_from_it(limits, inner):
    start = time.monotonic()

    def after_the_inner():
        with time_limit(inner):
            pass
        time.sleep(LONG)

    with pytest.raises(TimeLimitReached), time_limit(*limits):
        after_the_inner()
    with pytest.raises(TimeLimitReached), time_limit(*limits), time_limit(inner):
        time.sleep(LONG)
    time.sleep(0.1)  # no limit holds any more
    assert time.monotonic() - start < LONG / 2


def test_what_inner_limits_take_counts():
    def work():
        for _ in range(20):
            with time_limit(LONG):
                time.sleep(0.1)

    with pytest.raises(TimeLimitReached), time_limit(0.3):
        work()


def test_after_an_inner_limit_it_is_said_again_and_again():
    def work():
        with time_limit(LONG):
            pass
        with suppress(BaseException):
            time.sleep(LONG)
        time.sleep(LONG)

    start = time.monotonic()
    with pytest.raises(TimeLimitReached), time_limit(0.1):
        work()
    assert time.monotonic() - start < LONG / 2


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="POSIX signals only")
def test_whenever_it_rings_no_limit_is_left_behind():
    before = signal.getsignal(signal.SIGALRM)
    for k in range(2000):
        with suppress(TimeLimitReached), time_limit(1e-6 * (1 + k % 60)):
            pass
        assert signal.getitimer(signal.ITIMER_REAL) == (0, 0)
        assert signal.getsignal(signal.SIGALRM) is before


def test_in_a_thread_the_clock_holds():
    found = []

    def work():
        try:
            with time_limit(LONG, 0.1):
                compute()
        except TimeLimitReached:
            found.append("stopped")

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert found == ["stopped"]
