"""Each comparison accepts what is right, and says type, shape or values for what is not."""

import numpy as np
import pytest

from course_lib.judging import (
    Close,
    Exactly,
    ImageClose,
    RaySet,
    RotationClose,
    UpToScale,
    YesOrNo,
)
from course_lib.judging.comparison import close_to

ROTATION = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
POINTS = np.array([[1.0, 2], [3, 4], [5, 6]])


@pytest.mark.parametrize(
    ("compare", "got", "expected"),
    [
        (Close(), 2, 2.0),
        (Close(), 1e-10, 0.0),
        (Close(), np.nan, np.nan),
        (Close(), -np.inf, -np.inf),
        (Close(), [[1, 2], [3, 4], [5, 6]], POINTS),
        (Close(), np.array([1, np.nan]), np.array([1, np.nan])),
        (Close(), (1, [2, 3]), (1.0, np.array([2.0, 3.0]))),
        (Close(), {"f": 5}, {"f": 5.0}),
        (Close(rtol=1e-2), 1.005, 1.0),
        (Exactly(), "f/8", "f/8"),
        (Exactly(), True, True),
        (Exactly(), np.array([1, 2]), np.array([1, 2])),
        (Close(), np.array([1, np.inf]), np.array([1, np.inf])),
        (Close(), (1.5, np.inf), (1.5, np.inf)),
        (Close(), {"f": [50, 50]}, {"f": (50.0, 50.0)}),
        (YesOrNo(), True, True),
        (YesOrNo(), np.array(False), False),
        (YesOrNo(), [True, False], np.array([True, False])),
        (UpToScale(), -3 * POINTS, POINTS),
        (UpToScale(rows=True), [[-2, -4], [9, 12], [5, 6]], POINTS),
        (UpToScale(rows=True), [-2, -4], POINTS[0]),
        (RotationClose(), ROTATION.tolist(), ROTATION),
        (RaySet(), 7 * POINTS[::-1], POINTS),
        (ImageClose(), np.full((4, 4), 101, np.uint8), np.full((4, 4), 100, np.uint8)),
    ],
)
def test_right_answers_agree(compare, got, expected):
    assert compare(got, expected) is None


@pytest.mark.parametrize(
    ("compare", "got", "expected", "kind", "words"),
    [
        (Close(), None, POINTS, "type", "return"),
        (Close(), "text", POINTS, "type", "a text"),
        (Close(), True, 1.0, "type", "True or False"),
        (Close(), 1j, 1.0, "type", "a complex number"),
        (Close(), [[1, 2], [3]], POINTS, "type", "a list"),
        (Close(), POINTS.T, POINTS, "shape", "transposed"),
        (Close(), POINTS[:2], POINTS, "shape", "(3, 2) was expected"),
        (Close(), np.full(3, np.nan), np.ones(3), "values", "NaN"),
        (Close(), np.ones(3), np.array([1, 1, np.nan]), "values", "should be NaN"),
        (Close(), np.array([1, 2, 4.0]), np.array([1, 2, 3.0]), "values", "1 of 3"),
        (Close(), 2.1, 2.0, "values", "not the right one"),
        (Close(), (1,), (1, 2), "type", "2 values"),
        (Close(), {"a": 1}, {"b": 1}, "type", "keys b"),
        (Close(), np.array(1.0), (1, 2), "type", "2 values"),
        (Close(), [1.0], 1.0, "shape", "a list of 1 value; a number"),
        (Close(), np.ones(2) + 0j, np.ones(2), "type", "an array of complex numbers of shape (2,)"),
        (Close(), (1, 3), (1, 2), "values", "Value 2 of 2: "),
        (Close(), (1, 3), (2, 3), "values", "right one. The other one is right."),
        (Close(), (9, 3, 4), (2, 3, 4), "values", "right one. The others are right."),
        (Close(), {"a": 1, "b": (1, 3)}, {"a": 1, "b": (1, 2)}, "values", "`b`: Value 2 of 2: "),
        (Close(), {"a": 1, "b": 3}, {"a": 1, "b": 2}, "values", "one. The other entry is right."),
        (Close(), (1, -70), (1, np.inf), "values", "The value should be infinite"),
        (Close(), np.ones(2), np.array([1, np.inf]), "values", "Some values should be infinite"),
        (Close(), np.inf, 5.0, "values", "not the right one"),
        (Close(), -np.inf, np.inf, "values", "should be infinite"),
        (Close(), np.nan, 1.0, "values", "NaN"),
        (Close(), 1.0, np.nan, "values", "should be NaN"),
        (Close(), 2e-9, 0.0, "values", "not the right one"),
        (Close(), np.array([True, False]), np.ones(2), "type", "truth values of shape (2,)"),
        (
            Close(),
            np.array([1, None]),
            np.ones(2),
            "type",
            "an array of objects, not numbers, of s",
        ),
        (YesOrNo(), 1, True, "type", "True or False was expected"),
        (YesOrNo(), None, True, "type", "return"),
        (YesOrNo(), [[True], [True, False]], np.ones(2, bool), "type", "a list"),
        (YesOrNo(), [1, 0], np.array([True, False]), "type", "truth values of shape (2,)"),
        (YesOrNo(), True, np.array([True, False]), "shape", "truth values of shape (2,)"),
        (YesOrNo(), False, True, "values", "The answer is not the right one."),
        (YesOrNo(), [True, True], np.array([True, False]), "values", "1 of 2 answers"),
        (YesOrNo(), np.array("True"), True, "type", "The answer is a text"),
        (YesOrNo(), np.array(["True"]), np.array([True]), "type", "an array of texts of shape"),
        (Exactly(), 1, "1", "type", "a text"),
        (Exactly(), "f/4", "f/8", "values", "not the right one"),
        (UpToScale(), [[-2, -4], [9, 12], [5, 6]], POINTS, "values", "not a multiple"),
        (UpToScale(rows=True), [[1, 2], [3, 4], [5, 7]], POINTS, "values", "not a multiple"),
        (UpToScale(rows=True), [[1, 2], [0, 0], [5, 6]], POINTS, "values", "zero"),
        (UpToScale(), 0 * POINTS, POINTS, "values", "zero"),
        (UpToScale(), POINTS + 1, POINTS, "values", "multiple"),
        (RotationClose(), 2 * ROTATION, ROTATION, "values", "not a rotation"),
        (RotationClose(), -ROTATION, ROTATION, "values", "reflection"),
        (RotationClose(), ROTATION.T, ROTATION, "values", "not the right one"),
        (RaySet(), -POINTS, POINTS, "values", "directions"),
        (RaySet(), 0 * POINTS, POINTS, "values", "no length"),
        (ImageClose(), np.zeros((4, 4)), np.zeros((4, 4), np.uint8), "type", "uint8"),
        (ImageClose(), np.zeros((4, 4)), np.full((4, 4), 0.1), "values", "differs"),
        (ImageClose(), np.full((4, 4), np.nan), np.full((4, 4), 0.1), "values", "differs"),
    ],
)
def test_wrong_answers_are_told_what_differs(compare, got, expected, kind, words):
    mismatch = compare(got, expected)
    assert mismatch is not None
    assert mismatch.kind == kind
    assert words in mismatch.message


def test_values_are_called_right_only_where_all_others_are():
    for got in ((1, 9, 9), (9, 9, 3), (9, 2, 9)):
        assert "right." not in Close()(got, (1, 2, 3)).message.partition("not the right one.")[2]
    assert "right." not in Close()({"a": 2}, {"a": 1}).message.partition("not the right one.")[2]


def test_picture_with_its_sides_exchanged_is_not_told_of_points():
    assert "Points" in Close()(np.ones((2, 8)), np.ones((8, 2))).message
    assert "Points" not in Close()(np.ones((6, 8)), np.ones((8, 6))).message


def test_two_equal_rays_do_not_stand_for_two_different_ones():
    doubled = POINTS[[0, 0, 1]]
    assert RaySet()(doubled, POINTS) is not None
    assert RaySet()(POINTS, doubled) is not None


def test_text_of_a_number_is_not_the_number():
    assert Close()(50.0, "50") is not None
    assert Close()("50", "50") is None
    assert Close()({"f": (50.0, 50.0)}, {"f": ("50", "50")}) is not None


def test_decimal_comma_is_named():
    miss = Close()((1023, 5), 1023.5)
    assert "`1023.5`" in miss.message
    assert "point" not in Close()((1.5, 2.5), 1023.5).message


def test_close_is_what_numpy_calls_close():
    rng = np.random.default_rng(0)
    special = np.array([0, 1, -1, np.nan, np.inf, -np.inf, 1e-9, 1e300])
    got, truth = rng.choice(special, (2, 4000))
    got = got * rng.choice([1, 1 + 1e-7, 1 + 1e-5], 4000) + rng.choice([0, 1e-10, 1e-8], 4000)
    ours = close_to(got, truth, 1e-6, 1e-9)
    with np.errstate(invalid="ignore"):
        numpys = np.isclose(got, truth, rtol=1e-6, atol=1e-9, equal_nan=True)
    np.testing.assert_array_equal(ours, numpys)
    assert 0 < ours.sum() < 4000
