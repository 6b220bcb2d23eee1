"""Two lenses and more against the textbook's closed form, and against traced rays."""

import numpy as np
import pytest

from course_lib.checks import DegenerateConfigurationError
from course_lib.optics import (
    cardinal_points,
    free_space,
    image_distance,
    image_of_point,
    lens_system,
    system_matrix,
    thin_lens,
    trace_rays,
    two_lens_zoom,
)

PAIRS = [(100, 60, 30), (100, -50, 75), (-80, 50, 40), (40, 40, 100), (-50, -70, 20), (30, 70, 0)]
TRIPLET = [thin_lens(60), free_space(12), thin_lens(-35), free_space(15), thin_lens(50)]


class TestLensSystem:
    def test_shapes(self):
        assert [type(value) for value in lens_system(100, 60, 30)] == [float] * 3

    @pytest.mark.parametrize(("f1", "f2", "d"), PAIRS)
    def test_accuracy(self, f1, f2, d):
        f = f1 * f2 / (f1 + f2 - d)  # closed form of two thin lenses
        assert lens_system(f1, f2, d) == pytest.approx((f, f * d / f2, -f * d / f1))

    @pytest.mark.parametrize(("f1", "f2", "d"), PAIRS)
    def test_principal_planes_by_traced_rays(self, f1, f2, d):
        f, front, back = lens_system(f1, f2, d)
        # A ray that comes in parallel seems to be bent at the back principal plane.
        train = [thin_lens(f1), free_space(d), thin_lens(f2)]
        y, angle = trace_rays(train, (1, 0))[-1]
        assert y + back * angle == pytest.approx(1)
        assert -1 / angle == pytest.approx(f)
        # And from the other side, with the lenses in the other order, at the front one.
        y, angle = trace_rays(train[::-1], (1, 0))[-1]
        assert y - front * angle == pytest.approx(1)

    def test_light_from_the_other_side(self):
        f, front, back = lens_system(100, 60, 30)
        assert lens_system(60, 100, 30) == pytest.approx((f, -back, -front))

    def test_touching_lenses_add_their_powers(self):
        f, front, back = lens_system(100, 50, 0)
        assert 1 / f == pytest.approx(1 / 100 + 1 / 50)
        assert (front, back) == (0, 0)

    @pytest.mark.parametrize(("f1", "f2"), [(100, 50), (30.1, 70.3), (100, -20)])
    def test_degenerate(self, f1, f2):
        with pytest.raises(DegenerateConfigurationError, match=r"no focal length.*telescope"):
            lens_system(f1, f2, f1 + f2)

    def test_errors(self):
        with pytest.raises(ValueError, match="f2 must not be zero"):
            lens_system(100, 0, 10)
        with pytest.raises(ValueError, match="d must not be negative"):
            lens_system(100, 50, -10)
        with pytest.raises(TypeError, match="f1 must be real numbers"):
            lens_system("100", 50, 10)


class TestCardinalPoints:
    def test_two_lenses(self):
        for f1, f2, d in PAIRS:
            system = system_matrix([thin_lens(f1), free_space(d), thin_lens(f2)])
            assert cardinal_points(system) == pytest.approx(lens_system(f1, f2, d))

    @pytest.mark.parametrize("Z", [200, 1000, 1e5])
    def test_image_as_by_one_lens(self, Z):
        # Measured from its principal planes, a whole triplet obeys the thin-lens equation.
        system = system_matrix(TRIPLET)
        f, front, back = cardinal_points(system)
        distance, _ = image_of_point(system, Z)
        assert distance - back == pytest.approx(image_distance(f, Z + front))

    def test_degenerate(self):
        with pytest.raises(DegenerateConfigurationError):
            cardinal_points(system_matrix([thin_lens(30.1), free_space(100.4), thin_lens(70.3)]))
        with pytest.raises(DegenerateConfigurationError):
            cardinal_points(free_space(10))

    def test_errors(self):
        with pytest.raises(ValueError, match="determinant 2; between air and air it must be 1"):
            cardinal_points([[1, 0], [-0.1, 2]])
        with pytest.raises(ValueError, match=r"system must have shape \(2, 2\), got \(2, 3\)"):
            cardinal_points(np.ones((2, 3)))


class TestTwoLensZoom:
    @pytest.mark.parametrize(("f1", "f2"), [(-80, 60), (-100, 80)])
    def test_round_trip(self, f1, f2):
        for f in (70, 90, 105, 150):
            d, back = two_lens_zoom(f1, f2, f)
            effective, _, plane = lens_system(f1, f2, d)
            assert effective == pytest.approx(f)
            # A star's rays, parallel, meet on the sensor.
            assert back == pytest.approx(f + plane)
            train = [thin_lens(f1), free_space(d), thin_lens(f2), free_space(back)]
            assert trace_rays(train, (1, 0))[-1, 0] == pytest.approx(0, abs=1e-12)

    def test_longer_means_closer_together(self):
        distances = [two_lens_zoom(-80, 60, f)[0] for f in (60, 100, 200)]
        assert distances == sorted(distances, reverse=True)

    def test_errors(self):
        with pytest.raises(ValueError, match=r"cannot have f = 20 mm.*Choose another f"):
            two_lens_zoom(100, 60, 20)
        with pytest.raises(ValueError, match="f must be positive"):
            two_lens_zoom(100, 60, -20)
