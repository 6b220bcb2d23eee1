"""Ray transfer matrices against rays that are traced step by step, without a matrix."""

import numpy as np
import pytest

from course_lib.optics import (
    free_space,
    image_distance,
    image_of_point,
    magnification,
    system_matrix,
    thin_lens,
    trace_rays,
)

ELEMENTS = [free_space(30), thin_lens(80), free_space(45), thin_lens(-60), free_space(200)]


def traced(y, angle):
    """Follow a ray through ELEMENTS by the two rules alone: go straight, bend by -y / f."""
    path = [(y, angle)]
    for kind, value in (("go", 30), ("bend", 80), ("go", 45), ("bend", -60), ("go", 200)):
        y, angle = (y + value * angle, angle) if kind == "go" else (y, angle - y / value)
        path.append((y, angle))
    return np.array(path)


def test_shapes():
    assert free_space(10).shape == thin_lens(10).shape == system_matrix([]).shape == (2, 2)
    assert trace_rays(ELEMENTS, (1, 0)).shape == (6, 2)
    assert trace_rays(ELEMENTS, [(1, 0), (2, 0), (0, 0.1)]).shape == (6, 3, 2)
    assert trace_rays([], [(1, 0)]).shape == (1, 1, 2)


def test_errors():
    with pytest.raises(ValueError, match="d must not be negative, got -1"):
        free_space(-1)
    with pytest.raises(ValueError, match="f must not be zero"):
        thin_lens(0)
    with pytest.raises(ValueError, match=r"f must be one number, got an array of shape \(2,\)"):
        thin_lens([50, 60])
    with pytest.raises(ValueError, match=r"elements\[1\] must have shape \(2, 2\), got \(3, 3\)"):
        system_matrix([np.eye(2), np.eye(3)])
    with pytest.raises(ValueError, match=r"elements\[0\] must have shape"):
        trace_rays([50], (0, 0))
    with pytest.raises(ValueError, match=r"rays must have shape \(N, 2\)"):
        trace_rays(ELEMENTS, (0, 0, 0))
    with pytest.raises(TypeError, match="d must be real numbers"):
        free_space("10 mm")


def test_accuracy():
    for ray in ((1.0, 0.0), (0.0, 0.02), (-3.0, 0.05)):
        np.testing.assert_allclose(trace_rays(ELEMENTS, ray), traced(*ray), atol=1e-14)
        np.testing.assert_allclose(system_matrix(ELEMENTS) @ ray, traced(*ray)[-1], atol=1e-14)


def test_the_first_element_acts_first():
    # A ray parallel to the axis crosses it one focal length behind the lens, not before it.
    assert system_matrix([thin_lens(50), free_space(50)])[0, 0] == pytest.approx(0, abs=1e-15)
    assert system_matrix([free_space(50), thin_lens(50)])[0, 0] == 1


def test_determinant_is_one():
    assert np.linalg.det(system_matrix(ELEMENTS)) == pytest.approx(1)


def test_inputs_are_not_modified():
    rays = np.array([(1.0, 0.0)])
    trace_rays(ELEMENTS, rays)
    assert rays.tolist() == [[1, 0]]


class TestImageOfPoint:
    def test_a_point_in_the_front_focus_of_a_tiny_lens_keeps_its_digits(self):
        system = system_matrix([thin_lens(1e-4), free_space(2049), thin_lens(1)])
        assert image_of_point(system, 1e-4)[1] == pytest.approx(-1e4, rel=1e-9)

    def test_between_air_and_water(self):
        into_water = np.array([[1, 0], [-0.01, 1 / 1.33]])  # the determinant is n / n'
        distance, m = image_of_point(into_water, 300)
        (A, _), (C, _) = into_water
        assert m == pytest.approx(A + distance * C, rel=1e-12)

    @pytest.mark.parametrize("Z", [51, 100, 1e5])
    def test_single_lens(self, Z):
        distance, m = image_of_point(thin_lens(50), Z)
        assert distance == pytest.approx(image_distance(50, Z))
        assert m == pytest.approx(-magnification(50, Z))  # upside down

    def test_virtual_image(self):
        # A magnifying glass: an object at half the focal length looks twice as large and far.
        assert image_of_point(thin_lens(50), 25) == pytest.approx((-50, 2))

    def test_focal_point(self):
        assert image_of_point(thin_lens(50), 50) == (np.inf, np.inf)

    def test_two_lenses_one_after_the_other(self):
        # The image of the first lens is the object of the second.
        first = float(image_distance(40, 100))
        second = float(image_distance(30, 200 - first))
        system = system_matrix([thin_lens(40), free_space(200), thin_lens(30)])
        m = float(magnification(40, 100) * magnification(30, 200 - first))
        assert image_of_point(system, 100) == pytest.approx((second, m))

    def test_all_rays_of_a_point_meet_there(self):
        system = system_matrix(ELEMENTS[1:4])
        distance, m = image_of_point(system, 2000)
        fan = [(2.0, angle) for angle in np.linspace(-0.03, 0.03, 7)]
        path = trace_rays([free_space(2000), *ELEMENTS[1:4], free_space(distance)], fan)
        np.testing.assert_allclose(path[-1, :, 0], 2 * m, rtol=1e-12)
