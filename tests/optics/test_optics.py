import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from course_lib.optics import (
    airy_diameter,
    best_pinhole_diameter,
    equivalent_focal_length,
    field_of_view,
    pinhole_blur_diameter,
)

FULL_FRAME, FOUR_THIRDS = (36, 24), (17.3, 13.0)
lengths = st.floats(1e-3, 1e6)
FUNCTIONS = {
    field_of_view: (50, FULL_FRAME),
    equivalent_focal_length: (50, FULL_FRAME),
    pinhole_blur_diameter: (0.5, 100, 2000),
    airy_diameter: (0.00055, 8),
    best_pinhole_diameter: (100, 0.00055),
}


class TestAllFunctions:
    @pytest.mark.parametrize("function", FUNCTIONS)
    @pytest.mark.parametrize("bad", [0, -1, np.nan, np.inf])
    def test_errors(self, function, bad):
        arguments = FUNCTIONS[function]
        for i, good in enumerate(arguments):
            wrong = bad if np.isscalar(good) else (good[0], bad)
            with pytest.raises(ValueError, match=r"positive|finite"):
                function(*arguments[:i], wrong, *arguments[i + 1 :])

    @pytest.mark.parametrize("function", FUNCTIONS)
    def test_errors_of_type(self, function):
        with pytest.raises(TypeError, match="must be real numbers, got '50 mm'"):
            function("50 mm", *FUNCTIONS[function][1:])

    @pytest.mark.parametrize("function", [field_of_view, equivalent_focal_length])
    def test_errors_of_shape(self, function):
        with pytest.raises(ValueError, match=r"f must be one number, got an array of shape \(2,\)"):
            function([50, 50], FULL_FRAME)
        with pytest.raises(ValueError, match=r"sensor_size \(width, height\) must have shape"):
            function(50, 36)


class TestFieldOfView:
    def test_shapes(self):
        assert field_of_view(50, FULL_FRAME).shape == (3,)

    def test_accuracy(self):
        # A right angle fits when half the width equals the focal length.
        np.testing.assert_allclose(field_of_view(18, FULL_FRAME)[0], np.pi / 2)
        # Nikon's data sheet of its 50 mm f/1.8G: 47 degrees on FX, 31.5 on DX, corner to corner.
        assert round(np.degrees(field_of_view(50, (35.9, 23.9))[2])) == 47
        assert round(np.degrees(field_of_view(50, (23.5, 15.6))[2]), 1) == 31.5
        horizontal, vertical, diagonal = np.tan(field_of_view(50, FULL_FRAME) / 2)
        np.testing.assert_allclose(diagonal**2, horizontal**2 + vertical**2)

    def test_round_trip(self):
        # From the angle back to the width: W = 2 f tan(half the angle).
        width = 2 * 35 * np.tan(field_of_view(35, FULL_FRAME)[0] / 2)
        np.testing.assert_allclose(width, 36)

    @given(lengths, lengths, lengths)
    def test_fuzz(self, f, width, height):
        angles = field_of_view(f, (width, height))
        assert (angles > 0).all()
        assert (angles <= np.pi).all()
        assert angles[2] >= angles[:2].max()


class TestEquivalentFocalLength:
    def test_shapes(self):
        assert type(equivalent_focal_length(25, FOUR_THIRDS)) is float

    def test_accuracy(self):
        # Published: 25 mm on Micro Four Thirds is equivalent to 50 mm.
        assert round(equivalent_focal_length(25, FOUR_THIRDS)) == 50
        assert equivalent_focal_length(50, FULL_FRAME) == pytest.approx(50)

    @given(lengths, lengths, lengths)
    def test_round_trip(self, f, width, height):
        # The same diagonal angle of view, on both sensors.
        equivalent = equivalent_focal_length(f, (width, height))
        np.testing.assert_allclose(
            field_of_view(equivalent, FULL_FRAME)[2], field_of_view(f, (width, height))[2]
        )


class TestPinholeBlur:
    def test_shapes(self):
        assert np.ndim(pinhole_blur_diameter(0.5, 100, 2000)) == 0
        assert pinhole_blur_diameter([0.5, 1], 100, 2000).shape == (2,)
        assert pinhole_blur_diameter([[0.5], [1]], 100, [1, 2, 3]).shape == (2, 3)

    def test_accuracy(self):
        # Rays from the point through the two ends of the hole, by hand.
        d, s, Z = 0.4, 120.0, 900.0
        ends = np.array([-d / 2, d / 2])
        hit = ends + (ends - 0) * s / Z
        np.testing.assert_allclose(pinhole_blur_diameter(d, s, Z), hit[1] - hit[0])

    def test_far_object(self):
        np.testing.assert_allclose(pinhole_blur_diameter(0.4, 100, 1e12), 0.4)

    @given(lengths, lengths, lengths)
    def test_fuzz(self, d, s, Z):
        blur = pinhole_blur_diameter(d, s, Z)
        assert blur >= d
        np.testing.assert_allclose(blur / d, 1 + s / Z)


class TestDiffraction:
    def test_shapes(self):
        assert np.ndim(airy_diameter(0.55, 8)) == 0
        assert airy_diameter(0.55, [4, 8]).shape == (2,)
        assert best_pinhole_diameter([50, 100], 0.00055).shape == (2,)

    def test_accuracy(self):
        # The first dark ring of the Airy pattern lies at the first zero of J1.
        from scipy.special import jn_zeros

        first_zero = jn_zeros(1, 1)[0]
        np.testing.assert_allclose(airy_diameter(0.55, 8), 2 * first_zero / np.pi * 0.55 * 8, 1e-3)
        assert best_pinhole_diameter(100, 0.00055) == pytest.approx(0.366, abs=5e-4)

    def test_best_is_the_minimum(self):
        best = best_pinhole_diameter(100, 0.00055)
        d = best * np.linspace(0.5, 2, 1001)
        total = pinhole_blur_diameter(d, 100, 1e12) + airy_diameter(0.00055, 100 / d)
        np.testing.assert_allclose(d[np.argmin(total)], best, rtol=2e-3)

    @given(lengths, st.floats(1e-4, 1e-3))
    def test_round_trip(self, image_distance, wavelength):
        # At the best hole both blurs are equally large.
        best = best_pinhole_diameter(image_distance, wavelength)
        np.testing.assert_allclose(airy_diameter(wavelength, image_distance / best), best)
