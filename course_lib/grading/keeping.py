"""A judge for the whole life of a process: its servers stay up from one submission to the next."""

from __future__ import annotations

import atexit
from contextlib import ExitStack
from functools import cache

from course_lib.grading.isolation import Isolation
from course_lib.grading.outside import Judge
from course_lib.sandbox.limits import Allowance


@cache
def kept_judge(isolation: Isolation, allowance: Allowance) -> Judge:
    """Return the judge of this process; it is closed when the process ends.

    Parameters
    ----------
    isolation : str
        ``"bubblewrap"``, or ``"none"``.
    allowance : Allowance
        What a submission may use.
    """
    until_the_end = ExitStack()
    atexit.register(until_the_end.close)
    return until_the_end.enter_context(Judge(isolation, allowance))
