"""Distortion undone: strong lenses, the fold, and what no lens images."""

import numpy as np
import pytest
from strong_lenses import disk, random_coefficients, strong_lenses

from course_lib.distortion import distort, undistort_points, valid_radius
from course_lib.distortion.inverse import CHUNK, radial_guess
from course_lib.distortion.monotone import invert_increasing, smallest_positive_root


class TestUndistort:
    def test_round_trip_of_400_strong_lenses(self):
        worst = 0.0
        for k, points in strong_lenses(400):
            error = np.abs(undistort_points(distort(points, k), k) - points).max()
            assert error <= 1e-9, k  # NaN fails; 1e-6 px at f = 1000 px
            worst = max(worst, error)
        assert worst <= 1e-12

    def test_shapes(self):
        assert undistort_points([0.1, 0.2], [-0.1]).shape == (2,)
        assert undistort_points([[0.1, 0.2]], [-0.1]).shape == (1, 2)
        assert undistort_points(np.empty((0, 2)), [-0.1]).shape == (0, 2)

    def test_more_than_one_chunk(self):
        points = np.random.default_rng(1).uniform(-0.5, 0.5, (CHUNK + 10, 2))
        found = undistort_points(distort(points, [-0.2, 0.05]), [-0.2, 0.05])
        np.testing.assert_allclose(found, points, atol=1e-14)

    def test_the_centre_stays(self):
        np.testing.assert_array_equal(undistort_points([0, 0], [-0.3, 0.1, 0.01, 0.02]), [0, 0])

    def test_one_far_point_spoils_none(self):
        k = [0.05, 0, 0.001, 0.002]
        points = np.concatenate([disk(0.8), [[30.0, -40.0]]])
        found = undistort_points(distort(points, k), k)
        np.testing.assert_allclose(found, points, rtol=1e-12, atol=1e-13)

    def test_long_lens(self):
        # A telephoto lens has a field of 3 degrees, and coefficients to match.
        k, points = [0.5, -60, 0, 0, 3000], disk(0.05)
        np.testing.assert_allclose(undistort_points(distort(points, k), k), points, atol=1e-15)

    @pytest.mark.parametrize(
        "k", [[-0.3], [-0.4, 0.05], [0, 0, 0, 0, -1], [0.1, 0, 0, 0, 0, 1, 1, 0]]
    )
    def test_up_to_the_fold(self, k):
        limit = valid_radius(k)
        points = disk(limit * (1 - 1e-6))
        np.testing.assert_allclose(undistort_points(distort(points, k), k), points, atol=1e-8)
        edge = np.abs(distort([limit, 0], k)[0])
        assert np.isnan(undistort_points([[edge * 1.001, 0], [0, 50]], k)).all()

    def test_only_what_is_near_comes_back(self):
        # Beyond the fold the forward model runs backwards; the inverse gives the ray inside.
        limit = valid_radius([-0.3])
        found = undistort_points(distort([1.3 * limit, 0], [-0.3]), [-0.3])
        assert 0 < found[0] < limit
        np.testing.assert_allclose(distort(found, [-0.3]), distort([1.3 * limit, 0], [-0.3]))

    def test_tangential_terms_beyond_the_radial_reach(self):
        # Just inside the fold, where the tangential terms push the image past the radial maximum.
        k = [-0.3, 0, 0.01, 0.01]
        point = np.array([0.98, 0.05]) * valid_radius(k)
        assert np.linalg.norm(distort(point, k)) > distort([valid_radius(k), 0], k[:1])[0]
        np.testing.assert_allclose(undistort_points(distort(point, k), k), point, atol=1e-10)

    def test_start_at_the_fold(self):
        # The radial terms alone would put this lens's corner at the fold, where no step helps.
        k = [0.5520608255393004, 0.49107097618783635, -0.0014155118888882871]
        k += [0.0086126117867672, 0.06257492106185014, -0.1015167896703032, -0.06899322953266995]
        k += [0.444157415935579, -0.0009336017402507106, -0.01731909898359099]
        k += [-0.012913303517812232, 0.012351902248019419]
        points = np.array([[0.91543883, -0.68657912], [0.91543883, -0.66369315]])
        np.testing.assert_allclose(undistort_points(distort(points, k), k), points, atol=1e-12)

    def test_errors(self):
        with pytest.raises(ValueError, match="take K off the pixels"):
            undistort_points([3e6, 0], [0])
        with pytest.raises(ValueError, match="1, 2, 4, 5, 8 or 12 numbers"):
            undistort_points([0, 0], [0, 0, 0])


class TestGuess:
    def test_newton_starts_close(self):
        k = np.array([-0.3, 0.1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0])
        r = np.linspace(1e-3, 0.8, 300)
        r_d = distort(np.stack([r, 0 * r], axis=1), k)[:, 0]
        guess = radial_guess(k, valid_radius(k), r_d.max())
        x, y = guess(0.6 * r_d, 0.8 * r_d)
        np.testing.assert_allclose(x, 0.6 * r, atol=1e-6)
        np.testing.assert_allclose(y, 0.8 * r, atol=1e-6)


class TestValidRadius:
    @pytest.mark.parametrize("seed", range(30))
    def test_accuracy_against_a_scan(self, seed):
        k = random_coefficients(np.random.default_rng(seed))
        k[2:4], k[8:] = 0, 0
        r = np.linspace(1e-6, 8, 400_001)
        r_d = distort(np.stack([r, 0 * r], axis=1), k)[:, 0]
        falls = np.diff(r_d) <= 0  # at a pole it falls from far above to far below
        scanned = r[falls.argmax()] if falls.any() else np.inf
        found = valid_radius(k)
        if np.isinf(scanned):
            assert found > 8
        else:
            assert found == pytest.approx(scanned, abs=1e-3)

    def test_closed_forms(self):
        assert valid_radius([-0.1]) == pytest.approx(np.sqrt(1 / 0.3))
        assert valid_radius([0, -0.1]) == pytest.approx((1 / 0.5) ** 0.25)
        # r / (1 + r²) grows up to 1; 1 - r²/4 below the line has a pole at 2.
        assert valid_radius([0, 0, 0, 0, 0, 1, 0, 0]) == pytest.approx(1)
        assert valid_radius([0, 0, 0, 0, 0, -0.25, 0, 0]) == pytest.approx(2)

    def test_no_fold(self):
        assert valid_radius([0]) == np.inf
        assert valid_radius([0.1, 0.2, 0.5, 0.5, 0.3]) == np.inf

    def test_a_tiny_last_coefficient_changes_nothing(self):
        assert valid_radius([-0.1, 0, 0, 0, 1e-30]) == pytest.approx(valid_radius([-0.1]))

    def test_tangential_terms_are_left_out(self):
        assert valid_radius([-0.1, 0, 0.1, 0.1]) == valid_radius([-0.1])


class TestMonotone:
    def test_smallest_root(self):
        assert smallest_positive_root([1]) == np.inf
        assert smallest_positive_root([1, 1]) == np.inf
        assert smallest_positive_root([1, -2, 1]) == pytest.approx(1)  # touches
        assert smallest_positive_root([1, -1e-12, 0, 0]) == pytest.approx(1e12)

    @pytest.mark.parametrize("power", [0.5, 1, 2, 7])
    def test_round_trip(self, power):
        x = np.linspace(0.01, 5, 1000)
        function, slope = (lambda x: x**power), (lambda x: power * x ** (power - 1))
        with np.errstate(divide="ignore"):
            found = invert_increasing(function(x), function, slope, 5.0)
        np.testing.assert_allclose(found, x, rtol=1e-12, atol=1e-12)

    def test_out_of_reach(self):
        got = invert_increasing(np.array([0.5, 2.0]), lambda x: x, np.ones_like, 1)
        np.testing.assert_array_equal(got, [0.5, np.nan])
