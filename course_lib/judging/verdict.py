"""Judge: answers against the truth, part by part, with the misconception behind a wrong one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from course_lib.judging.advice import advice
from course_lib.judging.answering import Answer, OwnAnswers
from course_lib.judging.exercise import Case, Exercise, Raises
from course_lib.judging.matching import find_misconceptions

Kind = Literal[
    "right", "not attempted", "raised", "time limit", "type", "shape", "values", "ready-made"
]

#: In this order the wrong answers to a part are mended: one that fails says why others differ.
FIRST: tuple[Kind, ...] = ("raised", "time limit", "type", "shape", "values", "not attempted")
#: Types of what is not an answer yet, and what makes one of it.
NOT_YET = dict.fromkeys(
    ("map", "zip", "filter", "generator", "range", "dict_values"),
    " Make a list of it: `list(…)`.",
) | dict.fromkeys(
    ("function", "method", "builtin_function_or_method", "ufunc", "_ArrayFunctionDispatcher"),
    " Round brackets call a function: are they missing?",
)
COARSE = " Its numbers are kept with 7 digits (float32); float64 has 16."


@dataclass(frozen=True)
class Feedback:
    """What a part's answer was like: a kind, a sentence, and (where shown) the example."""

    kind: Kind
    message: str
    case: Case | None = None
    got: Any = None
    expected: Any = None
    scale_free: bool = False  # a multiple of the expected answer is as good
    cause: str = ""  # the exception's name; "None" where nothing was returned

    @property
    def has_example(self) -> bool:
        """Whether inputs, the answer and the expected answer may be shown."""
        return self.case is not None


@dataclass(frozen=True)
class PartVerdict:
    """One part: its name, points earned and possible, and why."""

    name: str
    points: float
    possible: float
    feedback: Feedback


@dataclass(frozen=True)
class Verdict:
    """What an answer is worth, and what would help."""

    exercise: str
    parts: tuple[PartVerdict, ...]
    hints: tuple[str, ...] = ()
    misconceptions: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    printed: str = ""

    @property
    def points(self) -> float:
        """Points earned."""
        return round(sum(part.points for part in self.parts), 6)

    @property
    def possible(self) -> float:
        """Points of a full answer."""
        return round(sum(part.possible for part in self.parts), 6)

    @property
    def attempted(self) -> bool:
        """Whether anything was answered."""
        return any(part.feedback.kind != "not attempted" for part in self.parts)


@np.errstate(all="ignore")  # an answer may hold any numbers
def judge(
    exercise: Exercise,
    cases: Sequence[Case],
    answers: Sequence[Answer],
    *,
    reveal: bool = True,
    own: OwnAnswers | None = None,
) -> Verdict:
    """Compare answers with the truth.

    Parameters
    ----------
    exercise : Exercise
        What was asked.
    cases : sequence of Case
        From `pose`.
    answers : sequence of Answer
        From `answer`, in the same order.
    reveal : bool
        Whether feedback may show inputs, results and what was printed: yes for the seeds that a
        student sees, no for grading seeds.
    own : OwnAnswers, optional
        Of this exercise and these cases, where they are judged more than once.

    Returns
    -------
    Verdict
        Points by part, feedback in the order attempted, raised, type and shape, values, and the
        hints of the misconceptions that the wrong answers agree with.
    """
    own = own or OwnAnswers(exercise, cases)
    if own.exercise is not exercise or list(map(id, own.cases)) != list(map(id, cases)):
        raise ValueError("`own` holds answers to other cases; make it of these")
    pairs = zip(range(len(cases)), answers, strict=True)
    judged = [_judge_case(own, i, given, reveal) for i, given in pairs]
    ready_made = sorted({name for given in answers for name in given.called})
    parts = tuple(_part_verdict(exercise, p, judged, reveal, ready_made) for p in exercise.parts)
    wrong = [i for i, f in enumerate(judged) if f.kind not in ("right", "not attempted")]
    found = [] if ready_made else find_misconceptions(own, answers, wrong)
    return Verdict(
        exercise.name,
        parts,
        hints=tuple(misconception.hint for misconception in found),
        misconceptions=tuple(misconception.name for misconception in found),
        notes=_notes(answers, judged, reveal),
        printed=next((a.printed for a in answers if a.printed), "") if reveal else "",
    )


def _part_verdict(
    exercise: Exercise, name: str, judged: list[Feedback], reveal: bool, ready_made: list[str]
) -> PartVerdict:
    possible = exercise.part_points(name)
    if ready_made:
        called = " and ".join(ready_made)
        message = f"This calls `{called}`. Write the steps yourself: that is the exercise."
        return PartVerdict(name, 0.0, possible, Feedback("ready-made", message))
    own = [feedback for feedback in judged if feedback.case and feedback.case.part == name]
    wrong = [feedback for feedback in own if feedback.kind != "right"]
    shown = min(wrong, key=lambda feedback: FIRST.index(feedback.kind)) if wrong else own[0]
    if not reveal or shown.kind == "not attempted":
        shown = Feedback(shown.kind, shown.message, cause=shown.cause)
    return PartVerdict(name, 0.0 if wrong else possible, possible, shown)


def _judge_case(own: OwnAnswers, index: int, given: Answer, reveal: bool) -> Feedback:
    exercise, case = own.exercise, own.cases[index]
    if isinstance(case.truth, Raises) and given.status in ("value", "raised"):
        return _judge_refusal(case, given, case.truth, reveal)
    if given.status != "value" or (given.value is None and exercise.none_is_untouched):
        return Feedback(_KINDS[given.status], _sentence(given, reveal), case, cause=given.error)
    if demand := exercise.part(case.part).demand:  # many answers are right: none is expected
        expected, mismatch = None, demand(given.value, case.inputs)
    else:
        expected = own.expected(index)
        mismatch = exercise.compare(given.value, expected)
    if mismatch is None:
        return Feedback("right", "Right.", case, given.value, expected)
    shown = expected if exercise.shows_expected else None
    free = getattr(exercise.compare, "scale_free", False)
    message = mismatch.message + COARSE * (mismatch.kind == "values" and _is_coarse(given.value))
    cause = "None" if given.value is None else ""
    return Feedback(mismatch.kind, message, case, given.value, shown, free, cause)


def _is_coarse(value: Any) -> bool:
    """Whether there are arrays in an answer whose numbers have fewer digits than usual."""
    if isinstance(value, tuple | list | dict):
        return any(map(_is_coarse, value.values() if isinstance(value, dict) else value))
    return isinstance(value, np.ndarray) and value.dtype.kind == "f" and value.itemsize < 8


def _judge_refusal(case: Case, given: Answer, truth: Raises, reveal: bool) -> Feedback:
    """Judge an answer to inputs that have none: only the right exception is right."""
    wanted = f"There is no answer here: the function should raise a {truth.error}."
    if given.status == "value":
        return Feedback("values", wanted, case, given.value)
    if given.refuses and given.error == truth.error:
        return Feedback("right", "Right.", case)
    return Feedback("raised", f"{wanted} {_sentence(given, reveal)}", case, cause=given.error)


_KINDS: dict[str, Kind] = {
    "value": "not attempted",
    "not attempted": "not attempted",
    "raised": "raised",
    "time limit": "time limit",
    "not plain": "type",
    "too large": "type",
}


def _sentence(given: Answer, reveal: bool) -> str:
    if given.status == "raised":
        return _raised(given, reveal)
    return {
        "value": "Not answered yet.",
        "not attempted": given.message
        or "Not answered yet: the function still raises NotImplementedError.",
        "time limit": f"No answer after {given.message} seconds. Does a loop never end? Or is a "
        "library loaded in it? An `import` belongs before the function."
        if given.message
        else "Not tried, because an answer before it took too long.",
        "not plain": f"The answer is of the type {given.message}; arrays and numbers are expected."
        + NOT_YET.get(given.message, ""),
        "too large": f"The answer is far too large ({given.message}).",
    }[given.status]


def _raised(given: Answer, reveal: bool) -> str:
    """Say what an exception means; its own message can hold the inputs."""
    where = f" in the line `{given.line}`" if given.line else ""
    why = f": {given.message}" if given.message and reveal else ""
    words = advice(given.error, given.message)
    stop = "" if why.endswith((".", "?", "!")) else "."
    return f"The function stopped with {given.error}{where}{why}{stop} {words}".rstrip()


def _notes(answers: Sequence[Answer], judged: list[Feedback], reveal: bool) -> tuple[str, ...]:
    notes = []
    changed = sorted({name for given in answers for name in given.changed_inputs})
    if changed:
        names = " and ".join(f"`{name}`" for name in changed)
        notes.append(f"The function changes its input {names}; work on a copy, or on a new array.")
    warned = list(dict.fromkeys(text for given in answers for text in given.warned))
    if warned and reveal:
        meaning = _meaning_of_warnings(answers, judged)
        notes.append(f"Python warned: {'; '.join(warned[:3])}. {meaning}")
    return tuple(notes)


def _meaning_of_warnings(answers: Sequence[Answer], judged: list[Feedback]) -> str:
    """Say that warnings are harmless where the answer is right; elsewhere point to the rows."""
    pairs = zip(answers, judged, strict=True)
    wrong = [given for given, feedback in pairs if given.warned and feedback.kind != "right"]
    if not wrong:
        return "This is harmless: the answers are right there."
    rows = next((rows for given in wrong if (rows := _infinite_rows(given.value))), None)
    if rows is None:
        return "An answer with this warning is wrong: which line does the warning come from?"
    which = f"row {rows[0]}" if len(rows) == 1 else "rows " + " and ".join(map(str, rows[:3]))
    return f"Look at {which} of the answer (the first is row 0). What is divided by zero there?"


def _infinite_rows(value: Any) -> list[int]:
    """Return which rows of an answer hold an infinite number: the mark of a division by zero."""
    if not isinstance(value, np.ndarray) or value.ndim != 2 or value.dtype.kind != "f":
        return []
    return [int(row) for row in np.flatnonzero(np.isinf(value).any(axis=1))]
