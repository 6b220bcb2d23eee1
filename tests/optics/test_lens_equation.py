"""The thin lens against the two rays that one draws at school, and against published numbers."""

import numpy as np
import pytest

from course_lib.optics import (
    image_distance,
    magnification,
    object_distance,
    optical_power,
    pixel_on_object,
)

FUNCTIONS = {
    image_distance: (50, 250),
    magnification: (50, 250),
    object_distance: (50, 0.1),
    optical_power: (50,),
    pixel_on_object: (0.005, 0.1),
}


def image_by_drawing(f, Z, height):
    """Where the ray through the middle meets the ray that comes in parallel: (distance, height)."""
    # Middle: y = height - height / Z x, from the object at x = 0 to the lens at x = Z and on.
    # Parallel: y = height up to the lens, then down through the focal point behind it.
    middle, parallel = (-height / Z, height), (-height / f, height + height * Z / f)
    x = (parallel[1] - middle[1]) / (middle[0] - parallel[0])
    return x - Z, middle[0] * x + middle[1]


@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("bad", [0, -1, np.nan, -np.inf])
def test_errors(function, bad):
    arguments = FUNCTIONS[function]
    for i in range(len(arguments)):
        with pytest.raises(ValueError, match=r"positive|finite"):
            function(*arguments[:i], bad, *arguments[i + 1 :])


@pytest.mark.parametrize("function", FUNCTIONS)
def test_errors_of_type(function):
    with pytest.raises(TypeError, match="must be real numbers, got '50 mm'"):
        function("50 mm", *FUNCTIONS[function][1:])


@pytest.mark.parametrize("function", [image_distance, magnification])
@pytest.mark.parametrize("Z", [50, 49, [1000, 20]])
def test_object_inside_the_focal_length_is_named(function, Z):
    with pytest.raises(ValueError, match=r"larger than the focal length \(50 mm\).*virtual"):
        function(50, Z)


def test_shapes():
    for function, arguments in FUNCTIONS.items():
        assert np.ndim(function(*arguments)) == 0
    assert image_distance(50, [100, 200]).shape == (2,)
    assert image_distance([[35], [50]], [100, 200, 300]).shape == (2, 3)
    assert magnification([35, 50], 100).shape == (2,)


def test_accuracy():
    assert image_distance(50, 100) == pytest.approx(100)  # life size: both at 2 f
    for f, Z in ((50, 250), (8, 9), (600, 20000)):
        distance, height = image_by_drawing(f, Z, 3.0)
        assert image_distance(f, Z) == pytest.approx(distance)
        assert magnification(f, Z) == pytest.approx(-height / 3)


def test_far_object():
    assert image_distance(50, np.inf) == 50
    assert magnification(50, np.inf) == 0
    np.testing.assert_array_equal(image_distance(50, [100, np.inf]), [100, 50])


def test_published_numbers():
    assert round(float(object_distance(35.7, 0.05)), 1) == 749.7  # printed as 750 mm
    m = 4 / 80
    assert m == 1 / 20
    assert pixel_on_object(4 / 100, m) == pytest.approx(0.8)
    assert optical_power(1000) == 1


def test_round_trip():
    Z = np.geomspace(60, 1e6, 20)
    np.testing.assert_allclose(object_distance(50, magnification(50, Z)), Z)
    # An object in the place of its image has its image in the place of the object.
    np.testing.assert_allclose(image_distance(50, image_distance(50, Z)), Z)
