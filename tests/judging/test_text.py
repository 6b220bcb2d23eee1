"""What was tried, as text: short arrays in full, long ones by shape, range and worst place."""

import numpy as np
import pytest

from course_lib.judging import Case, UpToScale
from course_lib.judging.text import example_rows, format_value
from course_lib.judging.verdict import Feedback

LONG = np.arange(120.0).reshape(10, 12)


def rows(got, expected, **inputs):
    """Return the labelled texts of a wrong answer."""
    return dict(example_rows(Feedback("values", "Wrong.", Case("part", inputs), got, expected)))


def test_a_short_array_is_written_in_full():
    short = np.arange(54).reshape(6, 9)
    assert "..." not in format_value(short)
    assert format_value(short[:4, :6]) == str(short[:4, :6])
    short = short[:4, :6]
    assert format_value(short) == str(short)
    assert "largest difference" not in rows(short + 1, short)


@pytest.mark.parametrize(
    ("array", "text"),
    [
        (LONG, "an array of shape (10, 12), float64, from 0 to 119"),
        (LONG.astype(np.uint16), "an array of shape (10, 12), uint16, from 0 to 119"),
        (LONG > 7, "an array of shape (10, 12), bool, from 0 to 1"),
        (
            np.where(LONG > 7, LONG, np.nan),
            "an array of shape (10, 12), float64, from 8 to 119, and some NaN",
        ),
        (LONG * np.nan, "an array of shape (10, 12), float64, NaN only"),
    ],
)
def test_a_long_array_is_written_by_shape_and_range(array, text):
    assert format_value(array) == text


def test_the_largest_difference_is_named_with_its_place():
    got = LONG + 0.5
    got[3, 4] = -7
    found = rows(got, LONG, image=LONG)
    assert found["largest difference"] == "at [3, 4]: -7 instead of 40"
    assert all("\n" not in text for text in found.values())


def test_a_number_that_should_be_none_is_the_largest_difference():
    truth = LONG.copy()
    truth[2, 1] = np.nan
    assert rows(LONG + 1, truth)["largest difference"] == "at [2, 1]: 26 instead of nan"


@pytest.mark.parametrize("got", [LONG[:5], None, "text", 3.0, LONG, LONG > 3])
def test_what_cannot_be_compared_place_by_place_does_no_harm(got):
    found = rows(got, LONG)
    assert found["expected"] == format_value(LONG)
    assert "largest difference" not in found


class TestWhatMayBeScaled:
    F = np.array([[2e-6, -1e-6, 3e-3], [4e-6, 0, 1e-3], [-3e-3, -1e-3, 0.9]])

    def rows(self, got, compare):
        feedback = Feedback("values", "", Case("part", {}), got, self.F, compare.scale_free)
        return dict(example_rows(feedback))

    def test_both_are_shown_of_length_1_and_with_one_sign(self):
        rows = self.rows(-700 * self.F, UpToScale())
        assert rows["your answer, of length 1"] == rows["expected, of length 1"]
        assert "2.222e-06" in rows["expected, of length 1"]

    def test_each_of_two_values(self):
        feedback = Feedback(
            "values", "", Case("part", {}), (3 * self.F, None), (self.F, None), True
        )
        rows = dict(example_rows(feedback))
        assert rows["your answer, of length 1"] == rows["expected, of length 1"]

    @pytest.mark.parametrize("got", [None, "F", np.zeros((3, 3)), np.ones((2, 2)), np.ones(9)])
    def test_what_has_no_scale_is_shown_as_it_is(self, got):
        rows = self.rows(got, UpToScale())
        assert "expected" in rows
        assert "expected, of length 1" not in rows


def test_small_numbers_of_a_table_keep_their_digits():
    text = format_value(np.array([[1e-6, 0.5], [1e-17, -3.21456]]))
    assert text.split() == ["[[", "1e-06", "0.5]", "[", "0", "-3.215]]"]
    assert format_value(np.array([[0.5, 0.25]])) == "[[0.5  0.25]]"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (97275.60076644178, "97275.6"),
        (np.array(97275.60076644178), "97275.6"),
        ((1.5, np.inf), "(1.5, inf)"),
        (np.array(True), "True"),
        ({"f": (18.0, 140.0)}, "{'f': (18.0, 140.0)}"),
        (
            np.arange(600, dtype=np.uint16).reshape(3, 10, 20),
            "an array of shape (3, 10, 20), uint16, from 0 to 599",
        ),
    ],
)
def test_values_are_written_short(value, text):
    assert format_value(value) == text
