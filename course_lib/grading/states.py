"""What became of an answer, in one word: from the record of a grading."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, get_args

from course_lib.judging.verdict import FIRST

State = Literal["full points", "some points", "no points", "error", "not tried", "not reached"]
#: From best to worst.
STATES: tuple[State, ...] = get_args(State)
#: Kinds of a part's feedback in which the function gave no answer.
STOPPED = {"raised", "time limit"}
#: What is said of a part's feedback where no misconception says more.
FAILURES = {
    "raised": "stopped with an error",
    "time limit": "out of time",
    "type": "an answer of another type",
    "shape": "an array of another shape",
    "values": "otherwise wrong",
    "not attempted": "not answered",
    "ready-made": "calls the ready-made function",
}


def state_of(found: Mapping[str, Any]) -> State:
    """Say what became of an answer.

    Parameters
    ----------
    found : mapping
        What a record holds of one exercise.

    Returns
    -------
    str
        One of `STATES`. "error" is an answer without points that raised or never ended; "not
        reached" one whose check did not come to run, because Python had ended above.
    """
    if not found.get("reached", True):
        return "not reached"
    if not found.get("attempted", True):
        return "not tried"
    if found["points"] >= found["possible"]:
        return "full points"
    if found["points"] > 0:
        return "some points"
    return "error" if STOPPED & set(found.get("parts", {}).values()) else "no points"


def failure_of(found: Mapping[str, Any]) -> str:
    """Say how an answer lost points, where no misconception explains it.

    Parameters
    ----------
    found : mapping
        What a record holds of one exercise.

    Returns
    -------
    str
        A few words on what is to be mended first; nothing for full points.
    """
    if not found.get("reached", True):
        return "not reached, because Python had ended above"
    wrong = [(kind, name) for name, kind in found.get("parts", {}).items() if kind != "right"]
    if not wrong:
        return ""
    kind, part = min(wrong, key=lambda one: (*FIRST, "ready-made").index(one[0]))
    cause = found.get("causes", {}).get(part, "")
    if cause == "None":
        return "no value returned"
    return f"stopped with {cause}" if cause else FAILURES[kind]
