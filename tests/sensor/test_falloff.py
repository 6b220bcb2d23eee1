import numpy as np
import pytest

from course_lib.sensor.falloff import lateral_chromatic_shift, mechanical_vignetting, vignetting


class TestVignetting:
    def test_shapes(self):
        assert np.ndim(vignetting(0.2)) == 0
        assert vignetting([[0.1, 0.2]]).shape == (1, 2)

    def test_accuracy(self):
        # A small flat piece of lens lights a small flat piece of sensor: both are seen from the
        # side (cos, cos), and are farther apart (1 / cos²).
        angle = np.radians([0, 10, 30, 60])
        distance = 1 / np.cos(angle)
        np.testing.assert_allclose(vignetting(angle), np.cos(angle) ** 2 / distance**2)
        assert vignetting(-0.3) == vignetting(0.3)
        assert vignetting(np.pi / 2) == pytest.approx(0, abs=1e-60)

    def test_errors(self):
        with pytest.raises(ValueError, match=r"beyond a right angle, got 30 rad: degrees must be"):
            vignetting([0, -30])


class TestMechanicalVignetting:
    @pytest.mark.parametrize("rim", [7, 10, 20])
    @pytest.mark.parametrize("angle", [0, 0.05, 0.2, 0.4])
    def test_accuracy(self, rim, angle):
        # Count the points of the pupil that are seen past the rim.
        y, x = np.mgrid[-5:5:801j, -5:5:801j]
        pupil = np.hypot(x, y) <= 5
        seen = pupil & (np.hypot(x - 15 * np.tan(angle), y) <= rim / 2)
        share = mechanical_vignetting(angle, 10, rim, 15)
        assert share == pytest.approx(seen.sum() / pupil.sum(), abs=2e-3)

    def test_shapes(self):
        assert np.ndim(mechanical_vignetting(0.2, 10, 20, 30)) == 0
        assert mechanical_vignetting([[0.1, -0.2]], 10, 20, 30).shape == (1, 2)

    def test_stopping_down_mends_it(self):
        wide, small = (mechanical_vignetting(0.25, d, 20, 30) for d in (16, 4))
        assert wide < 0.75
        assert small == 1

    @pytest.mark.parametrize("i", [1, 2, 3])
    @pytest.mark.parametrize("bad", [0, -1, np.nan])
    def test_errors(self, i, bad):
        good = [0.2, 10, 20, 30]
        good[i] = bad
        with pytest.raises(ValueError, match=r"positive|finite"):
            mechanical_vignetting(*good)


class TestChromaticShift:
    def test_accuracy(self):
        centre, pixels = np.array([320, 240]), np.array([[320, 240], [640, 480], [0, 240]])
        moved = lateral_chromatic_shift(pixels, 1.002, centre)
        np.testing.assert_allclose(moved - pixels, [[0, 0], [0.64, 0.48], [-0.64, 0]], atol=1e-12)

    def test_round_trip(self):
        there = lateral_chromatic_shift((12, 34), 1.01, (50, 60))
        np.testing.assert_allclose(lateral_chromatic_shift(there, 1 / 1.01, (50, 60)), (12, 34))

    def test_errors(self):
        with pytest.raises(ValueError, match="pixels must have shape"):
            lateral_chromatic_shift((1, 2, 3), 1.01, (0, 0))
        with pytest.raises(ValueError, match="scale must be positive"):
            lateral_chromatic_shift((1, 2), 0, (0, 0))
