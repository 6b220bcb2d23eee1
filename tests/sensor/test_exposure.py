from itertools import combinations

import numpy as np
import pytest

from course_lib.sensor.exposure import (
    decibels,
    equivalent_exposure,
    exposure_difference,
    exposure_value,
    luminance,
    photons_per_pixel,
    stops,
)

FUNCTIONS = {
    exposure_value: (8, 0.01, 200),
    equivalent_exposure: (0.01, 8, 4, 100, 200),
    stops: (8,),
    decibels: (8,),
    luminance: (500, 0.18),
    photons_per_pixel: (28.6, 4, 0.01, 3.45),
}
# The lecture's three pictures: f-number, time in s, ISO speed.
THREE = (16, 2, 100), (4.5, 1 / 6, 100), (16, 1 / 6, 1250)


class TestAllFunctions:
    @pytest.mark.parametrize("function", FUNCTIONS)
    @pytest.mark.parametrize("bad", [0, -1, np.nan, np.inf])
    def test_errors(self, function, bad):
        good = FUNCTIONS[function]
        for i in range(len(good)):
            with pytest.raises(ValueError, match=r"positive|finite"):
                function(*good[:i], bad, *good[i + 1 :])

    @pytest.mark.parametrize("function", FUNCTIONS)
    def test_errors_of_type(self, function):
        with pytest.raises(TypeError, match="must be real numbers, got '1/60 s'"):
            function("1/60 s", *FUNCTIONS[function][1:])

    @pytest.mark.parametrize("function", FUNCTIONS)
    def test_shapes(self, function):
        good = FUNCTIONS[function]
        assert np.ndim(function(*good)) == 0
        assert function(np.full((2, 3), good[0]), *good[1:]).shape == (2, 3)


class TestExposureValue:
    def test_accuracy(self):
        # ISO 2720: zero is 1 s at f/1; bright sun ("sunny 16": 1/ISO s at f/16) is near 15.
        assert exposure_value(1, 1) == 0
        assert exposure_value(16, 1 / 100, 100) == pytest.approx(14.64, abs=0.005)
        assert exposure_value(16, 1 / 400, 400) == pytest.approx(14.64, abs=0.005)

    def test_one_stop(self):
        base = exposure_value(4, 1 / 60, 200)
        assert exposure_value(4, 1 / 120, 200) == pytest.approx(base + 1)
        assert exposure_value(4 * np.sqrt(2), 1 / 60, 200) == pytest.approx(base + 1)
        assert exposure_value(4, 1 / 60, 400) == pytest.approx(base - 1)


class TestEquivalentExposure:
    def test_round_trip(self):
        t = equivalent_exposure(0.02, 4, [5.6, 11], 100, 800)
        np.testing.assert_allclose(exposure_value([5.6, 11], t, 800), exposure_value(4, 0.02))
        np.testing.assert_allclose(equivalent_exposure(t, [5.6, 11], 4, 800, 100), 0.02)

    def test_accuracy_three_pictures(self):
        # 12 times less time against 12.6 times the area, or 12.5 times the ISO speed.
        assert equivalent_exposure(2, 16, 4.5) == pytest.approx(0.1582, abs=5e-5)
        assert equivalent_exposure(2, 16, 16, 100, 1250) == pytest.approx(0.16)

    def test_three_pictures_are_almost_alike(self):
        first, second, third = THREE
        # By hand: t ISO / N², and the logarithm of the ratio.
        assert exposure_difference(second, first) == pytest.approx(
            np.log2((100 / 6 / 4.5**2) / (200 / 256))
        )
        assert exposure_difference(second, first) == pytest.approx(0.075, abs=5e-4)
        assert exposure_difference(third, first) == pytest.approx(0.059, abs=5e-4)
        assert max(abs(exposure_difference(a, b)) for a, b in combinations(THREE, 2)) < 0.08

    def test_errors_of_difference(self):
        with pytest.raises(ValueError, match=r"settings \(N, t, iso\) must have shape \(3,\)"):
            exposure_difference((16, 2), THREE[0])
        with pytest.raises(ValueError, match=r"other \(N, t, iso\) must be positive"):
            exposure_difference(THREE[0], (16, 0, 100))


class TestLight:
    def test_lambert(self):
        # A white sheet sends out all it gets: integrate L cos(angle) over the half-sphere.
        angle = np.linspace(0, np.pi / 2, 20_001)
        radiated = np.trapezoid(
            luminance(300, 1) * np.cos(angle) * 2 * np.pi * np.sin(angle), angle
        )
        assert radiated == pytest.approx(300, rel=1e-6)
        with pytest.raises(ValueError, match="reflectance must be at most 1, got 18: 18 % is"):
            luminance(300, 18)

    def test_accuracy(self):
        # A lux second of green light is 4.09e15 photons a square metre: 1 / (683 h c / 555 nm).
        one_lux = 4 / np.pi  # cd/m² that make 1 lux behind f/1
        assert photons_per_pixel(one_lux, 1, 1, 1) == pytest.approx(4091, rel=1e-3)

    def test_laws(self):
        base = photons_per_pixel(100, 4, 0.01, 3)
        assert photons_per_pixel(100, 8, 0.01, 3) == pytest.approx(base / 4)
        assert photons_per_pixel(100, 4, 0.02, 6) == pytest.approx(base * 8)
        assert photons_per_pixel(100, 4, 0.01, 3, magnification=1) == pytest.approx(base / 4)
        assert photons_per_pixel(100, 4, 0.01, 3, transmittance=0.5) == pytest.approx(base / 2)
        assert photons_per_pixel(100, 4, 0.01, 3, wavelength_um=1.11) == pytest.approx(base * 2)

    def test_errors(self):
        with pytest.raises(ValueError, match="magnification must not be negative"):
            photons_per_pixel(100, 4, 0.01, 3, magnification=-0.5)
        with pytest.raises(ValueError, match="transmittance must be at most 1"):
            photons_per_pixel(100, 4, 0.01, 3, transmittance=90)


def test_units_of_ratios():
    assert stops(4096) == 12
    assert decibels(4096) == pytest.approx(72.25, abs=0.005)
