"""Numbers that a reader writes: taken as they are, or a sentence says what to write."""

import numpy as np
import pytest

from course_lib import lab
from course_lib.lab.numbers import NUMBERS, other_unit, read_ruler
from course_lib.measuring import Measured

NAN = float("nan")
NO_NUMBERS = ["4 cm", "97", [97.0], (97, 5, 3), None, NAN, float("inf"), True, 1j, {}, 10**400]


@pytest.mark.parametrize("name", NUMBERS)
class TestNumber:
    def test_what_can_be_meant_is_taken_in_silence(self, name, heard):
        usual = NUMBERS[name].usual
        for value in (usual, np.float64(usual), 1.5 * usual):
            assert lab.number(name, value) == value
        assert lab.number(name, NUMBERS[name].most) == NUMBERS[name].most
        assert heard() == ""

    @pytest.mark.parametrize("value", [*NO_NUMBERS, -1, -0.001, 1e9])
    def test_what_cannot_be_meant_is_told_and_replaced(self, name, value, heard):
        assert lab.number(name, value) == NUMBERS[name].usual
        said = heard()
        assert said.startswith(f"{name} = ")
        assert f"Write {NUMBERS[name].write}." in said
        assert "do not use what is measured with it" in said


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [
        ("bar", "97 mm", "no quotation marks and no unit"),
        ("bar", (97, 5), "decimals are written with a point, 97.5"),
        ("bar", 9.7, "between 20 and 400"),  # cm
        ("bar", 0.097, "between 20 and 400"),  # m
        ("scale", 0.1, "0.1 mm of 100 mm are 0.001"),
        ("pointing", 0, "between 0.01 and 20"),
        ("pointing", None, "nothing was written"),
        ("unevenness", [0.1], "it is not one number"),
        ("unevenness", NAN, "it is not a finite number"),
    ],
)
def test_the_reason_fits(name, value, said, heard):
    lab.number(name, value)
    assert said in heard()


class TestRuler:
    LENGTH = Measured(85.6, {"pointing": 0.4})

    @pytest.mark.parametrize(
        ("written", "said"),
        [
            (85.5, "its ± is missing"),
            ("4 cm", "it is a text"),
            (None, "nothing was written"),
            ((85, 5), ""),
            ((85, 5, 0, 7), "it is not two numbers"),
            (("85.5", 0.7), "as to the length, it is a text"),
            ((85.5, None), "as to its ±, nothing was written"),
            ((NAN, 0.7), "as to the length, it is not a finite number"),
            ((-85.5, 0.7), "the length is not larger than 0"),
            ((85.5, -0.7), "its ± is not larger than 0"),
            ((85.5, 0), "its ± is not larger than 0"),
            ((0.7, 85.5), "its ± is as large as the length"),
            ({}, "it is not one number"),
        ],
    )
    def test_what_cannot_be_used_is_told_and_not_compared(self, written, said, heard):
        result = lab.result("card", self.LENGTH, written)
        told = heard()
        if not said:
            assert result.ruler == written
            assert told == ""
            return
        assert result.ruler is None
        assert f"cannot be used: {said}" in told
        assert "Write the length and its ± in mm, like (85.5, 0.7)." in told
        assert result.said == "card: 85.6 mm ± 0.8 mm (95 %); not compared with a ruler"

    def test_a_list_is_as_good_as_a_pair(self):
        assert read_ruler([85.5, 0.7]) == (85.5, 0.7)

    @pytest.mark.parametrize(
        ("ruler", "unit"), [(8.55, "cm"), (0.0855, "m"), (3.37, "inches"), (85.5, ""), (7.5, "")]
    )
    def test_another_unit_is_asked_for(self, ruler, unit, heard):
        assert other_unit(ruler, 85.6) == unit
        result = lab.result("card", self.LENGTH, (ruler, 0.01))
        assert result.ruler == (ruler, 0.01)  # what was written stays: it is the reader's
        told = heard()
        assert told == (
            f"card: the camera found 85.6 mm ± 0.8 mm (95 %). Is {ruler:g} in {unit}? Write mm."
            if unit
            else ""
        )

    def test_only_what_has_a_ruler_is_compared(self, heard):
        with_ruler = lab.result("card", self.LENGTH, (85.5, 0.7))
        without = lab.result("lid", self.LENGTH, "12 cm")
        (ax,) = lab.comparison([without, with_ruler]).axes
        assert [text.get_text() for text in ax.texts] == ["card"]
        assert lab.comparison([without]) is None
        assert "There is no ruler's value to compare with." in heard()


class TestPointing:
    def test_attempts(self, heard):
        lab.say_pointing([(790.0, 479.5), (789.4, 479.8), (790.4, 480.2)])
        assert heard() == "σ of a coordinate: 0.43 px"

    @pytest.mark.parametrize(
        "attempts",
        ["790, 479", None, [], [(790, 479)], (790, 479), [(1, 2), (NAN, 3)], [(1,), (2, 3)]],
    )
    def test_what_are_no_attempts(self, attempts, heard):
        lab.say_pointing(attempts)
        assert heard().startswith("attempts cannot be used: two or more pixels are needed")

    def test_another_corner_and_the_same_number(self, heard):
        lab.say_pointing([(790, 479), (942, 507)])
        assert "was it the same corner each time?" in heard()
        lab.say_pointing([(790, 479)] * 3)
        assert "All attempts are the same" in heard()
