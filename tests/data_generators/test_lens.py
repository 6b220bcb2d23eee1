import numpy as np
import pytest

from course_lib.camera import Camera
from course_lib.optics import circle_of_confusion
from course_lib.sensor import photons_per_pixel
from data_generators.lens import Lens

PITCH = 0.05  # mm


def camera_of(lens, size=(96, 80)):
    return Camera(lens.intrinsics(PITCH, size), np.eye(3), np.zeros(3), size)


def test_shapes():
    lens = Lens(50, 2, 2000)
    assert lens.disks([1.0, 2.0, np.inf], camera_of(lens)).shape == (3,)
    assert lens.pitch(camera_of(lens)).shape == (2,)
    assert lens.intrinsics((0.01, 0.02), (640, 480)).shape == (3, 3)


def test_accuracy():
    lens = Lens(50, 2.8, 750)
    assert 1 / lens.image_distance + 1 / 750 == pytest.approx(1 / 50)
    assert lens.diameter == pytest.approx(50 / 2.8)
    np.testing.assert_allclose(lens.pitch(camera_of(lens)), PITCH)
    expected = circle_of_confusion([400, 750, np.inf], 750, 50, 2.8) / PITCH
    np.testing.assert_allclose(lens.disks([0.4, 0.75, np.inf], camera_of(lens)), expected)


def test_disks_are_the_aperture_as_an_angle():
    lens = Lens(35, 4, 1500)
    expected = camera_of(lens).K[0, 0] * lens.diameter / 1000 * abs(1 / 0.6 - 1 / 1.5)
    assert lens.disks(0.6, camera_of(lens)) == pytest.approx(expected)


def test_light():
    # Two stops make a quarter of the light; at magnification 1 there is another quarter.
    assert Lens(50, 4).light == pytest.approx(4 * Lens(50, 8).light)
    assert Lens(50, 4).light == pytest.approx(4 * Lens(50, 4, 100).light)
    assert Lens(50, 4).image_distance == 50
    # The same light as that which chapter 04 counts photons with.
    lens = Lens(50, 2.8, 400)
    m = lens.image_distance / 400
    one, far = (photons_per_pixel(100, 2.8, 0.01, 3.45, magnification=x) for x in (m, 0))
    assert lens.light / Lens(50, 2.8).light == pytest.approx(float(one / far))


@pytest.mark.parametrize("arguments", [(0, 2), (50, -1), (50, 2, 50), (50, 2, 20), (50, 2, -1)])
def test_errors(arguments):
    with pytest.raises(ValueError, match=r"positive|larger than the focal length of 50 mm"):
        Lens(*arguments)
