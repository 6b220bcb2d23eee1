"""No answer that needs no thought earns more than a little, in any exercise."""

import numpy as np
import pytest

from course_lib.exercises import all_exercises
from course_lib.judging import Answer, Exercise, OwnAnswers, ValuesExercise, pose, seed_for
from course_lib.judging.exercise import Raises
from course_lib.judging.verdict import judge

EXERCISES = [
    e for e in all_exercises() if isinstance(e, Exercise) and not isinstance(e, ValuesExercise)
]
#: What the best of them may earn: a part on inputs that have no answer, or whose answer is simple.
MOST = 0.35
#: Whose checks a class could have written down: where many answers are right, none is shown.
RECORDABLE = [e for e in EXERCISES if all(e.part(p).demand is None for p in e.parts)]
STUDENTS = 12
FILLINGS = {
    "zeros": np.zeros_like,
    "ones": np.ones_like,
    "the identity": lambda x: np.eye(*x.shape) if x.ndim == 2 else np.ones(x.shape),
    "NaN": lambda x: np.full(x.shape, np.nan),
    "infinity": lambda x: np.full(x.shape, np.inf),
}


def filled(value, filling):
    """Return something of the same form as a value."""
    if isinstance(value, tuple | list):
        return type(value)(filled(item, filling) for item in value)
    if isinstance(value, dict):
        return {key: filled(item, filling) for key, item in value.items()}
    array = np.asarray(value)
    if array.dtype.kind not in "iufb":
        return value
    with np.errstate(invalid="ignore"):
        full = filling(array.astype(float)).astype(bool if array.dtype.kind == "b" else float)
    return full if isinstance(value, np.ndarray) else full.item()


def trivial_answers(own):
    """Yield names and answers to all cases."""
    inputs = [list(case.inputs.values()) for case in own.cases]
    for name, filling in FILLINGS.items():
        yield name, [Answer("value", filled(form(own, k), filling)) for k in range(len(inputs))]
    for place in {0, 1, -1}:
        values = [given[min(place, len(given) - 1)] for given in inputs]
        yield f"input {place}", [Answer("value", value) for value in values]
    for value in (0.0, 1.0, True, False, (), "", {}):
        yield repr(value), [Answer("value", value) for _ in inputs]
    for error in ("ValueError", "LinAlgError", "DegenerateConfigurationError"):
        yield error, [Answer("raised", error=error) for _ in inputs]


def form(own, index):
    """Return the right answer to a case, for its form; 0 where there is none."""
    try:
        return own.expected(index)
    except Exception:
        return 0.0


@pytest.mark.parametrize("exercise", EXERCISES, ids=lambda e: e.name)
def test_trivial_answers_earn_little(exercise):
    cases = pose(exercise, seed_for("trivial", exercise.name))
    own = OwnAnswers(exercise, cases)
    for name, answers in trivial_answers(own):
        earned = judge(exercise, cases, answers, reveal=False, own=own).points
        assert earned <= MOST * exercise.points, name


def numbers_in(value):
    """Return all numbers of some inputs, one after the other; a text counts by its length."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, tuple | list):
        return np.concatenate([np.zeros(0), *map(numbers_in, value)])
    array = np.asarray(value)
    numbers = array if array.dtype.kind in "iufb" else np.array(float(len(str(value))))
    return np.nan_to_num(numbers.astype(float)).ravel()


def recorded(exercise):
    """Yield what a class has read off its checks: inputs, and the right answer to them."""
    for student in range(STUDENTS):
        own = OwnAnswers(exercise, pose(exercise, seed_for(f"student {student}", exercise.name)))
        for k, case in enumerate(own.cases):
            if isinstance(case.truth, Raises):
                yield numbers_in(case.inputs), Answer("raised", error=case.truth.error)
            else:
                yield numbers_in(case.inputs), Answer("value", own.expected(k))


def how_far(one, other):
    return np.abs(one - other).sum() if one.size == other.size else np.inf


@pytest.mark.slow
@pytest.mark.parametrize("exercise", RECORDABLE, ids=lambda e: e.name)
def test_answers_that_a_class_has_recorded_earn_little(exercise):
    """To every question, give the answer to the recorded one whose inputs are nearest."""
    table, points = list(recorded(exercise)), []
    for student in range(4):
        cases = pose(exercise, seed_for(f"another {student}", exercise.name))
        asked = [numbers_in(case.inputs) for case in cases]
        nearest = [min(table, key=lambda entry, one=one: how_far(entry[0], one)) for one in asked]
        given = [answer for _, answer in nearest]
        points.append(judge(exercise, cases, given, reveal=False).points)
    assert np.mean(points) <= MOST * exercise.points
