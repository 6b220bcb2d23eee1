"""What became of an answer, in one word: from the record of a grading."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, get_args

State = Literal["full points", "some points", "no points", "error", "not tried", "not reached"]
#: From best to worst.
STATES: tuple[State, ...] = get_args(State)
#: Kinds of a part's feedback in which the function gave no answer.
STOPPED = {"raised", "time limit"}


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
