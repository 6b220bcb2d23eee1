import numpy as np
import pytest

from course_lib.optics import (
    aperture_diameter,
    f_number,
    image_distance,
    object_distance,
    stops_between,
    working_f_number,
)

FUNCTIONS = [f_number, aperture_diameter, stops_between]


@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("bad", [0, -1, np.nan, np.inf])
def test_errors(function, bad):
    with pytest.raises(ValueError, match=r"positive|finite"):
        function(bad, 4)
    with pytest.raises(ValueError, match=r"positive|finite"):
        function(4, bad)


def test_errors_of_magnification():
    with pytest.raises(ValueError, match=r"m must not be negative, got -0\.1: check"):
        working_f_number(8, [0.2, -0.1])


def test_shapes():
    for function in [*FUNCTIONS, working_f_number]:
        assert np.ndim(function(4, 2)) == 0
        assert function([[4], [8]], [2, 3, 4]).shape == (2, 3)


def test_published_numbers():
    assert aperture_diameter(200, 4) == 50
    assert aperture_diameter(40, 8) == 5
    assert f_number(40, 5) == 8


def test_accuracy():
    # Twice the area is one stop: the diameter times the root of 2.
    assert stops_between(f_number(50, 10 * np.sqrt(2)), f_number(50, 10)) == pytest.approx(1)
    assert stops_between(8, 2.8) == pytest.approx(-3, abs=0.04)  # engraved numbers are rounded
    # Focused close by, the sensor stands at the image distance; the opening stays as it is.
    m, f, N = 0.5, 50, 8
    distance = image_distance(f, object_distance(f, m))
    assert working_f_number(N, m) == pytest.approx(distance / aperture_diameter(f, N))
    assert working_f_number(N, 0) == N


def test_round_trip():
    N = np.array([1.4, 2, 2.8, 4])
    np.testing.assert_allclose(f_number(85, aperture_diameter(85, N)), N)
    np.testing.assert_allclose(stops_between(N, 4), -stops_between(4, N))
