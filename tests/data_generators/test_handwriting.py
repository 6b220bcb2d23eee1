"""A function in another hand gives the same results, and looks different."""

import numpy as np
import pytest

from course_lib.exercises import find
from data_generators.handwriting import copy_off, rename, rewrite
from data_generators.typed_answers import expected_points, right


@pytest.mark.parametrize("name", ["pinhole.project_pinhole", "epipolar.eight_point"])
def test_every_hand_writes_right_answers(name):
    exercise, seen = find(name), set()
    for seed in range(4):
        rng = np.random.default_rng(seed)
        written = rewrite(right(exercise).source, rng)
        for source in (written, copy_off(written, rng)):
            made = {"np": np}
            exec(source, made)
            assert expected_points(exercise, made[exercise.function_name]) == exercise.points
            seen.add(source)
    assert len(seen) == 8
    assert not [source for source in seen if "check_" in source]


def test_new_names_are_none_of_those_that_are_taken():
    source = "def f(a, b, x, y, z):\n    q = a + b\n    p = q * x\n    return p + y * z + q"
    for seed in range(20):
        made = {}
        exec(rename(source, np.random.default_rng(seed)), made)
        assert made["f"](1, 2, 3, 4, 5) == 32


def test_arguments_that_come_with_a_star_stay_so():
    source = "def f(a, b):\n    return np.hypot(*(a + b)) + max(*a, 2 * b[0])"
    for seed in range(6):
        made = {"np": np}
        exec(rewrite(source, np.random.default_rng(seed)), made)
        assert made["f"](np.array([1.0, 2.0]), np.array([2.0, 2.0])) == 9.0


def test_arguments_keep_their_names():
    renamed = rename(
        "def f(x, y):\n    z = x + y\n    x = z\n    return x", np.random.default_rng(0)
    )
    assert renamed.startswith("def f(x, y):")
    assert "z" not in renamed.replace("return", "")


def test_only_functions_are_rewritten():
    with pytest.raises(ValueError, match="needs a function, got Assign"):
        rewrite("x = 1", np.random.default_rng(0))
