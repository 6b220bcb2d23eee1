import math

import numpy as np
import pytest

from course_lib.widgets.controls import Choice, Slider, Switch

HOLE = Slider("d", "Hole", "d", "mm", 0.05, 2.5, 1, steps=110, landmarks=(0.35, 0.07))
FOCAL = Slider("f", "Focal length", "f", "mm", 8, 200, 50, step=0.5, digits=1)


def test_a_linear_slider_has_evenly_spaced_positions():
    positions = FOCAL.positions
    assert positions[0] == 8
    assert positions[-1] == 200
    np.testing.assert_allclose(np.diff(positions), 0.5)


def test_a_logarithmic_slider_has_evenly_spaced_logarithms_and_its_landmarks():
    positions = np.array(HOLE.positions)
    assert positions[0] == 0.05
    assert positions[-1] == 2.5
    assert {0.35, 0.07, 1.0} <= set(positions)
    steps = np.diff(np.log(positions))
    assert steps.min() > 0
    assert steps.max() < math.log(1.11)  # two significant digits: from 1.0 to 1.1


@pytest.mark.parametrize(
    ("value", "expected"),
    [(50, 50), (50.2, 50), (-3, 8), (1e9, 200), (math.inf, 200), (math.nan, 50), ("x", 50)],
)
def test_a_bad_value_moves_to_the_nearest_position(value, expected):
    assert FOCAL.nearest(value) == expected


def test_none_and_lists_from_a_browser_give_the_default():
    assert FOCAL.nearest(None) == 50
    assert FOCAL.nearest([3]) == 50


def test_the_text_has_the_digits_that_were_asked_for():
    assert FOCAL.text(50) == "50.0"
    assert HOLE.text(0.35) == "0.35"
    assert HOLE.text(0.05) == "0.050"
    assert HOLE.text(2.5) == "2.5"


def test_a_slider_sends_a_text_for_every_position():
    spec = HOLE.spec()
    assert len(spec["values"]) == len(spec["texts"]) > 90
    assert spec["default"] in spec["values"]


def test_a_choice_takes_its_options_only():
    sensor = Choice("sensor", "Sensor", ("FX", "DX"), "FX")
    assert sensor.nearest("DX") == "DX"
    assert sensor.nearest("XX") == "FX"
    assert sensor.nearest(None) == "FX"
    assert sensor.spec()["options"] == ["FX", "DX"]


def test_a_switch_takes_true_and_false_only():
    coupled = Switch("coupled", "Coupled", True)
    assert coupled.nearest(False) is False
    assert coupled.nearest("no") is True


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Slider("f", "", "f", "mm", 3, 3, 3), "start 3 must be below 3"),
        (lambda: Slider("f", "", "f", "mm", 0, 3, 1, steps=9), "starts above 0"),
        (lambda: Choice("s", "", ("a", "b"), "c"), "'c' is not one of"),
    ],
)
def test_errors(make, words):
    with pytest.raises(ValueError, match=words):
        make()


@pytest.mark.parametrize(
    ("value", "shown"), [(320, "320"), (9999, "9999"), (1e6, "1\u202f000\u202f000")]
)
def test_long_numbers_are_shown_in_groups(value, shown):
    assert Slider("Z", "Distance", "Z", "mm", 1, 1e6, 1, step=1e6).text(value) == shown
