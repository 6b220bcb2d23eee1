"""The seed is the only secret: it says which inputs are drawn, and nothing else does."""

import numpy as np

from course_lib.judging import Exercise, Part, pose, seed_for


def drawn(rng):
    return {"values": rng.uniform(1, 9, 4), "factor": float(rng.uniform(2, 5))}


ADDING = Exercise(
    "demo",
    lambda values, factor: values + factor,
    parts={"plain": drawn, "again": Part(drawn)},
    misconceptions=[],
)


def test_seeds_depend_on_every_word_and_never_change():
    assert seed_for("key", "ann", "x") == seed_for("key", "ann", "x")
    others = [("a", "b"), ("ab",), ("b", "a"), ("a", "b", "")]
    assert len({seed_for(*words) for words in others}) == len(others)
    assert seed_for("course", "reader") == 6709666866330238218


def test_cases_of_a_part_differ():
    factors = [case.inputs["factor"] for case in pose(ADDING, 1)]
    assert len(set(factors)) == len(factors) == 6


def test_same_seed_same_inputs_other_seed_other_inputs():
    first, again, other = (pose(ADDING, seed)[0].inputs["values"] for seed in (1, 1, 2))
    np.testing.assert_array_equal(first, again)
    assert not np.allclose(first, other)
