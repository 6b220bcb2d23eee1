"""No exercise ships unless it rewards right answers, rejects wrong ones and names the reason."""

import ast
import functools
import inspect
import types
from collections.abc import Callable

import numpy as np
import pytest
from second_solutions import second_solutions

from course_lib.exercises import CHAPTERS, all_exercises
from course_lib.judging import (
    Answer,
    Exercise,
    Explain,
    OwnAnswers,
    Raises,
    ValuesExercise,
    Verdict,
    answer,
    judge,
    pose,
)
from course_lib.judging.html import to_html
from course_lib.judging.text import to_text

SEEDS = range(50)
EXERCISES = [e for e in all_exercises() if isinstance(e, Exercise)]
WORDS = [e for e in all_exercises() if isinstance(e, Explain)]
BY_NAME = {e.name: e for e in EXERCISES}

each_exercise = pytest.mark.parametrize("exercise", EXERCISES, ids=lambda e: e.name)


@functools.lru_cache(maxsize=16 * len(SEEDS))  # all seeds of a chapter's exercises
def posed(name: str, seed: int) -> OwnAnswers:
    """Return the cases of an exercise, which nothing may change, with the course's own answers."""
    cases = pose(BY_NAME[name], seed)
    for value in (value for case in cases for value in case.inputs.values()):
        if isinstance(value, np.ndarray):
            value.setflags(write=False)
    return OwnAnswers(BY_NAME[name], cases)


def answers_to(exercise: Exercise, function: Callable, seed: int) -> list[Answer]:
    cases = posed(exercise.name, seed).cases
    if isinstance(exercise, ValuesExercise):  # the student's values do not know what was given
        values = function(**exercise.given) if function else {}
        return answer(exercise, lambda **_: values, cases)
    return answer(exercise, function, cases)


def judged(exercise: Exercise, answers: list[Answer], seed: int, reveal: bool = True) -> Verdict:
    own = posed(exercise.name, seed)
    return judge(exercise, own.cases, answers, reveal=reveal, own=own)


def verdict_for(exercise: Exercise, function: Callable, seed: int) -> Verdict:
    return judged(exercise, answers_to(exercise, function, seed), seed)


def rewritten(function: Callable) -> Callable:
    """Return the same function with a code object of its own: what a student would have typed."""
    return types.FunctionType(
        function.__code__.replace(co_filename="answer.py"),
        function.__globals__,
        function.__name__,
        function.__defaults__,
    )


@each_exercise
def test_reference_earns_all_points(exercise):
    for seed in SEEDS:
        verdict = verdict_for(exercise, rewritten(exercise.reference), seed)
        assert verdict.points == exercise.points, (seed, verdict)


@each_exercise
def test_reference_agrees_with_truth_by_construction(exercise):
    for seed in SEEDS:
        for case in posed(exercise.name, seed).cases:
            if isinstance(case.truth, Raises):
                (given,) = answer(exercise, exercise.reference, [case])
                assert (given.status, given.error) == ("raised", case.truth.error)
            elif case.known:
                reference = exercise.as_answer(exercise.reference, case)
                assert exercise.compare(reference, case.truth) is None


@each_exercise
def test_second_solution_earns_all_points(exercise):
    second = second_solutions(exercise.chapter)[exercise.function_name]
    for seed in SEEDS:
        verdict = verdict_for(exercise, second, seed)
        assert verdict.points == exercise.points, (seed, verdict)


@pytest.mark.parametrize(
    ("exercise", "misconception", "wrong"),
    [(e, m, wrong) for e in EXERCISES for m in e.misconceptions for wrong in (m.variant, *m.also)],
    ids=lambda value: getattr(value, "name", getattr(value, "__name__", "")),
)
def test_misconception_loses_points_and_gets_its_own_hint(exercise, misconception, wrong):
    for seed in SEEDS:
        answers = answers_to(exercise, wrong, seed)
        for reveal in (True, False) if seed < 10 else (True,):  # the hint is the same
            verdict = judged(exercise, answers, seed, reveal)
            assert verdict.points < exercise.points, seed
            assert verdict.misconceptions == (misconception.name,), seed
            assert verdict.hints == (misconception.hint,), seed


@each_exercise
def test_untouched_stub_earns_nothing(exercise):
    def stub(*_):
        raise NotImplementedError

    untouched = stub
    if isinstance(exercise, ValuesExercise):
        untouched = lambda **_: dict.fromkeys(exercise.units)  # noqa: E731
    verdict = verdict_for(exercise, untouched, 0)
    assert verdict.points == 0
    assert not verdict.attempted


def like(value, fill):
    """Return something of the type and shape of an answer, with one number everywhere."""
    if isinstance(value, dict):
        return {key: like(entry, fill) for key, entry in value.items()}
    if isinstance(value, tuple):
        return tuple(like(entry, fill) for entry in value)
    if isinstance(value, Raises):
        return fill
    if np.asarray(value).dtype == bool:
        return np.full_like(value, bool(fill))
    return np.full_like(np.asarray(value, dtype=float), fill)


@each_exercise
@pytest.mark.parametrize("kind", ["none", "zero", "zeros", "nans", "ones", "inputs"])
def test_lazy_answers_earn_nothing(exercise, kind):
    for seed in range(10):
        own = posed(exercise.name, seed)
        right = [own.expected(i) for i in range(len(own.cases))]
        lazy = {
            "none": lambda _, __: None,
            "zero": lambda _, __: 0.0,
            "zeros": lambda _, value: like(value, 0),
            "nans": lambda _, value: like(value, np.nan),
            "ones": lambda _, value: like(value, 1),
            "inputs": lambda case, _: next(iter(case.inputs.values())),
        }[kind]
        values = [lazy(case, value) for case, value in zip(own.cases, right, strict=True)]
        answers = [Answer("value", value) for value in values]
        assert judged(exercise, answers, seed).points == 0


#: What nobody expects to come back.
ODD = [
    "three", {"a": 1.0}, {}, {1: 2, 3: "x"}, [], [[1.0], [1.0, 2.0]], ((1, (2, "x")), None), 2j,
    np.array(["a", "b"]), np.array([1 + 2j, 3]), np.array([True, False]), 10**400, [10**400, 1],
    np.zeros((3, 0)), np.zeros((0, 2)), np.full((3, 3), 1e300), np.full((3, 4), np.inf),
    (np.eye(3), None), (np.eye(3), np.eye(3), np.zeros((0, 3))), (1.0, "x", None, [2]),
]  # fmt: skip


@each_exercise
def test_whatever_comes_back_is_judged(exercise):
    count = len(posed(exercise.name, 0).cases)
    for odd in ODD:
        verdict = judged(exercise, [Answer("value", odd)] * count, 0)
        assert verdict.points == 0, odd
        assert to_text(verdict)
        assert to_html(verdict)


@each_exercise
def test_calling_the_reference_earns_nothing(exercise):
    if isinstance(exercise, ValuesExercise):
        return  # its answers are numbers, not calls
    verdict = verdict_for(exercise, lambda *inputs: exercise.reference(*inputs), 0)
    assert verdict.points == 0
    assert {part.feedback.kind for part in verdict.parts} == {"ready-made"}


@each_exercise
def test_exercise_is_well_formed(exercise):
    assert len(exercise.misconceptions) >= 3
    names = [m.name for m in exercise.misconceptions]
    hints = [m.hint for m in exercise.misconceptions]
    assert len(set(names)) == len(names)
    assert len(set(hints)) == len(hints)
    assert exercise.chapter in CHAPTERS
    assert sum(map(exercise.part_points, exercise.parts)) == pytest.approx(exercise.points)
    parameters = list(inspect.signature(exercise.reference).parameters)
    for case in posed(exercise.name, 0).cases:
        assert list(case.inputs) == parameters
    for misconception in exercise.misconceptions:
        for wrong in (misconception.variant, *misconception.also):
            assert list(inspect.signature(wrong).parameters) == parameters


@each_exercise
def test_no_hint_reveals_the_answer(exercise):
    """A hint asks; it holds no expression of the solution and no formula of its own."""
    tree = ast.parse(inspect.getsource(exercise.reference).strip())
    expressions = {
        ast.unparse(node).replace(" ", "")
        for node in ast.walk(tree)
        if isinstance(node, ast.BinOp | ast.Call)
    }
    for misconception in exercise.misconceptions:
        hint = misconception.hint
        assert hint.endswith(("?", ".")), hint
        assert "?" in hint, hint
        squeezed = hint.replace(" ", "").replace("`", "")
        assert not [e for e in expressions if e in squeezed], hint
        assert not set("=*√²") & set(hint), hint
        assert len(hint) <= 160, hint


@pytest.mark.parametrize("question", WORDS, ids=lambda e: e.name)
def test_question_in_words_has_a_rubric_and_a_model_answer(question):
    assert question.points >= 2
    assert all(points > 0 and text.endswith(".") for points, text in question.rubric)
    assert len(question.model_answer.split()) >= 30
