"""What `course_lib.notebook` is while a submission is graded: it shows nothing and judges nothing.

The grader puts this file in the place of the real one; checks are its own business.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterable
from typing import Any

from course_lib.judging.limits import TimeLimitReached, time_limit

PATIENCE = 3.0
AWAY = "This is not shown while a notebook is graded."


def check(name: str, namespace: Any = None) -> float:
    """Say that the grader judges, not this process."""
    print(f"{name}: judged outside of this notebook.")
    return 0.0


def attempt(function: Callable[..., Any], *args: Any, **kwargs: Any) -> Any:
    """Return what a student's function answers, or None."""
    return attempt_each(function, [args], **kwargs)[0]


def attempt_each(function: Callable[..., Any], cases: Iterable[Any], **kwargs: Any) -> list[Any]:
    """Return what a student's function answers for several inputs, or None for each."""
    calls = [copy.deepcopy((args, kwargs)) for args in cases]
    try:
        with time_limit(PATIENCE):
            return [function(*args, **named) for args, named in calls]
    except (Exception, TimeLimitReached):
        return [None] * len(calls)


def solution(name: str) -> None:
    """Show nothing."""
    print(AWAY)
