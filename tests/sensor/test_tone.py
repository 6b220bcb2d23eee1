import numpy as np
import pytest

from course_lib.sensor.tone import (
    grey_from_rgb,
    hsv_from_rgb,
    rgb_from_hsv,
    srgb_decode,
    srgb_encode,
)

CURVES = [srgb_encode, srgb_decode]
COLOURS = [grey_from_rgb, hsv_from_rgb, rgb_from_hsv]


def colours():
    return np.random.default_rng(5).uniform(0, 1, (40, 30, 3))


class TestGamma:
    @pytest.mark.parametrize("curve", CURVES)
    def test_shapes(self, curve):
        assert np.ndim(curve(0.2)) == 0
        assert curve(np.zeros((2, 3, 3))).shape == (2, 3, 3)

    def test_accuracy(self):
        # IEC 61966-2-1: the two pieces meet at 0.0031308 and 0.04045; mid-grey 18 % is code 118.
        assert srgb_encode(0.0031308) == pytest.approx(0.04045, abs=2e-6)
        assert srgb_encode(0.0031309) == pytest.approx(0.04045, abs=2e-6)
        assert round(255 * float(srgb_encode(0.18))) == 118
        np.testing.assert_allclose(srgb_encode([0, 1]), [0, 1], atol=1e-12)

    def test_round_trip(self):
        light = np.linspace(0, 1, 1001)
        np.testing.assert_allclose(srgb_decode(srgb_encode(light)), light, atol=1e-7)

    def test_twice_is_too_much(self):
        assert srgb_encode(srgb_encode(0.2)) > 0.7

    @pytest.mark.parametrize("curve", CURVES)
    @pytest.mark.parametrize("bad", [[-0.1, 1], [0, 255]])
    def test_errors(self, curve, bad):
        with pytest.raises(ValueError, match=r"must be from 0 to 1, got .* divide 8-bit numbers"):
            curve(bad)


class TestColours:
    @pytest.mark.parametrize("function", COLOURS)
    def test_shapes(self, function):
        extra = () if function is grey_from_rgb else (3,)
        assert function([0.1, 0.2, 0.3]).shape == extra
        assert function(colours()).shape == (40, 30, *extra)

    @pytest.mark.parametrize("function", COLOURS)
    def test_errors(self, function):
        with pytest.raises(ValueError, match=r"must have shape \(\.\.\., 3\), got \(2,\)"):
            function([0.1, 0.2])
        with pytest.raises(ValueError, match="must be from 0 to 1"):
            function([10, 20, 30])

    def test_round_trip(self):
        np.testing.assert_allclose(rgb_from_hsv(hsv_from_rgb(colours())), colours(), atol=1e-12)

    def test_accuracy(self):
        red, yellow, blue, grey = (1, 0, 0), (1, 1, 0), (0, 0, 0.5), (0.3, 0.3, 0.3)
        expected = [[0, 1, 1], [1 / 6, 1, 1], [2 / 3, 1, 0.5], [0, 0, 0.3]]
        np.testing.assert_allclose(hsv_from_rgb([red, yellow, blue, grey]), expected)
        np.testing.assert_array_equal(hsv_from_rgb((0, 0, 0)), 0)

    def test_light_changes_the_value_only(self):
        bright, dim = hsv_from_rgb(colours()), hsv_from_rgb(0.3 * colours())
        np.testing.assert_allclose(dim[..., :2], bright[..., :2], atol=1e-9)
        np.testing.assert_allclose(dim[..., 2], 0.3 * bright[..., 2])
