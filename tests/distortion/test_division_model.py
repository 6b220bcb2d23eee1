import numpy as np
import pytest

from course_lib.distortion import distort_division, undistort_division

POINTS = np.random.default_rng(8).uniform(-0.6, 0.6, (60, 2))


class TestDivision:
    def test_shapes(self):
        for function in (distort_division, undistort_division):
            assert function([0.1, 0.2], -0.1).shape == (2,)
            assert function(POINTS, -0.1).shape == POINTS.shape

    def test_accuracy_by_hand(self):
        np.testing.assert_allclose(undistort_division([0.3, 0.4], 0.8), [0.25, 0.4 / 1.2])

    @pytest.mark.parametrize("coefficient", [-1.2, -0.3, -1e-9, 0, 1e-9, 0.2, 0.3])
    def test_round_trip(self, coefficient):
        bent = distort_division(POINTS, coefficient)
        np.testing.assert_allclose(undistort_division(bent, coefficient), POINTS, atol=1e-15)

    def test_small_coefficient_keeps_its_digits(self):
        # To first order the points move by λ r² times themselves.
        moved = distort_division([0.3, 0.4], 1e-8) - [0.3, 0.4]
        np.testing.assert_allclose(moved, 0.25e-8 * np.array([0.3, 0.4]), rtol=1e-6)

    def test_signs(self):
        assert distort_division([0.5, 0], -0.3)[0] < 0.5  # barrel
        assert distort_division([0.5, 0], 0.3)[0] > 0.5  # pincushion

    def test_beyond_the_edge(self):
        assert np.isnan(undistort_division([1.01, 0], -1)).all()
        assert np.isnan(undistort_division([1.01, 0], 1)).all()
        assert np.isnan(distort_division([0.51, 0], 1)).all()
        assert np.isfinite(distort_division([0.5, 0], 1)).all()
        assert distort_division([1e5, 0], -1)[0] == pytest.approx(1, abs=1e-5)

    def test_errors(self):
        for function in (distort_division, undistort_division):
            with pytest.raises(ValueError, match="take K off the pixels"):
                function([3e6, 0], -0.1)
            with pytest.raises(ValueError, match="coefficient must be one number"):
                function([0.1, 0], [-0.1, 0])
            with pytest.raises(ValueError, match="which no lens has"):
                function([0.1, 0], 1e40)
