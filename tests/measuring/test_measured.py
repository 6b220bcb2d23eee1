"""A measured length is written with the digits that are known."""

import numpy as np
import pytest

from course_lib.measuring import Measured, pointing_sigma


@pytest.mark.parametrize(
    ("value", "sigma", "text"),
    [
        (82.31, 0.2, "82.3 mm ± 0.4 mm (95 %)"),
        (82.314, 0.07, "82.31 mm ± 0.14 mm (95 %)"),
        (119.34, 1.1, "119.3 mm ± 2.2 mm (95 %)"),
        (1234.0, 25.0, "1230 mm ± 50 mm (95 %)"),
        (5.0, 0.0, "5.000000 mm ± 0.000000 mm (95 %)"),
        (0.5, 0.00499, "0.500 mm ± 0.010 mm (95 %)"),
    ],
)
def test_text(value, sigma, text):
    assert str(Measured(value, {"pointing": sigma})) == text


def test_interval():
    length = Measured(10.0, {"pointing": 3.0, "pose": 4.0})
    assert length.sigma == 5.0
    assert length.holds(10 + 1.95 * 5)
    assert not length.holds(10 - 1.97 * 5)


def test_pointing():
    clicks = np.random.default_rng(0).normal([300, 200], 0.7, (2000, 2))
    assert pointing_sigma(clicks) == pytest.approx(0.7, rel=0.03)
    few = [[100, 50], [101, 50], [102, 50]]  # squares 1, 0, 1 by 2 (3 - 1)
    assert pointing_sigma(few) == pytest.approx(np.sqrt(2 / 4))
    with pytest.raises(ValueError, match="two or more pixels"):
        pointing_sigma([[1, 2]])
