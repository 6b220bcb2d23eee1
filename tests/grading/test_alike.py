"""Copied submissions are found under other names; honest ones of the same exercises are not."""

import numpy as np
import pytest

from course_lib.authoring.expansion import grade_id
from course_lib.exercises import all_exercises
from course_lib.exercises.pasting import paste
from course_lib.grading.alike import code_words, find_alike, prose_words
from course_lib.judging import Exercise, ValuesExercise
from data_generators.handwriting import copy_off, rewrite
from data_generators.typed_answers import right

EXERCISES = [
    e
    for e in all_exercises("epipolar")
    if isinstance(e, Exercise) and not isinstance(e, ValuesExercise)
]
STUBS = {
    grade_id(e.name): f"{paste(e.reference).signature}\n    raise NotImplementedError"
    for e in EXERCISES
}


def own_work(rng):
    return {grade_id(e.name): rewrite(right(e).source, rng) for e in EXERCISES}


def copy_of(answers, rng):
    return {cell: copy_off(source, rng) for cell, source in answers.items()}


@pytest.fixture(scope="module")
def honest():
    return {f"s{k:02d}": own_work(np.random.default_rng(k)) for k in range(16)}


def test_a_copy_with_other_names_is_found_and_nobody_else(honest):
    copy = copy_of(honest["s03"], np.random.default_rng(99))
    assert all(copy[cell] != source for cell, source in honest["s03"].items())
    pairs, others = find_alike(STUBS, honest | {"x": copy})
    assert [pair.students for pair in pairs] == [("s03", "x")]
    assert pairs[0].share == pytest.approx(1)
    assert others < 0.75


def test_of_three_copies_each_pair_is_found(honest):
    rng = np.random.default_rng(98)
    class_ = honest | {name: copy_of(honest["s05"], rng) for name in ("x", "y")}
    pairs, _ = find_alike(STUBS, class_)
    assert {pair.students for pair in pairs} == {("s05", "x"), ("s05", "y"), ("x", "y")}


def test_what_many_have_and_what_the_notebook_held_counts_nothing(honest):
    same = {f"t{k}": honest["s00"] for k in range(20)}
    assert find_alike(STUBS, honest | same) == ([], pytest.approx(0.0, abs=0.75))
    assert find_alike(honest["s00"], {"a": honest["s00"], "b": honest["s00"]} | honest)[0] == []


def test_short_answers_must_look_alike(honest):
    short = dict.fromkeys(STUBS, "def f(x):\n    return x @ K.T + c")
    pairs, _ = find_alike(STUBS, honest | {"x": short, "y": short})
    assert pairs == []


def test_lines_that_are_the_same_are_marked(honest):
    rng = np.random.default_rng(97)
    added = "\n\n\ndef of_my_own(a, b):\n    return [a[i] - b[i] for i in range(len(a)) if i]"
    copy = {cell: s + added for cell, s in copy_of(honest["s01"], rng).items()}
    (pair,), _ = find_alike(STUBS, honest | {"x": copy})
    answer = pair.answers[0]
    own = answer.sources[1].splitlines().index("def of_my_own(a, b):")
    assert answer.sources == (honest["s01"][answer.cell], copy[answer.cell])
    assert own + 1 not in answer.lines[1]
    assert len(answer.lines[0]) > 2
    assert len(answer.lines[1]) > 2


def test_words_leave_out_what_can_be_changed_freely():
    one = 'def f(x):\n    """Text."""\n    # remark\n    total = np.linalg.norm(x)  # another\n'
    other = "def g(points):\n\n    r = np.linalg.norm(\n        points)"
    assert [w for w, _ in code_words(one)] == [w for w, _ in code_words(other)]
    assert "norm" in [w for w, _ in code_words(one)]
    assert [line for w, line in code_words(other) if w == ")"] == [0, 3]
    assert prose_words("The lens,\nthe Lens") == [("the", 0), ("lens", 0), ("the", 1), ("lens", 1)]


@pytest.mark.parametrize("broken", ["def f(:\n  x = 'open", "   \n x\n  y\n z", "x = (1", ""])
def test_what_is_no_python_is_read_as_far_as_it_goes(broken):
    assert len(code_words(broken)) <= 10
