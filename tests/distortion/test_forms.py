"""The same lens in other words."""

import numpy as np
import pytest

from course_lib.distortion import (
    bouguet_from_opencv,
    distort,
    distort_photogrammetric,
    distort_pixels,
    distort_radial,
    ebner,
    opencv_from_bouguet,
    opencv_from_photogrammetric,
    photogrammetric_from_opencv,
    radial_correction,
    valid_radius,
)

BROWN = np.array([-0.3, 0.12, 0.001, -0.0008, -0.02])
POINTS = np.random.default_rng(6).uniform(-0.6, 0.6, (40, 2))


class TestPhotogrammetric:
    @pytest.mark.parametrize(("f", "unit"), [(1200.0, "px"), (24.0, "mm")])
    def test_is_the_same_lens(self, f, unit):
        centre = np.array([640, 480]) * (1 if unit == "px" else 0.02)
        form = photogrammetric_from_opencv(BROWN, f)
        found = distort_photogrammetric(f * POINTS + centre, centre, *form)
        np.testing.assert_allclose(found, f * distort(POINTS, BROWN) + centre, atol=1e-12)

    def test_round_trip(self):
        back = opencv_from_photogrammetric(*photogrammetric_from_opencv(BROWN, 6890.5), 6890.5)
        np.testing.assert_allclose(back, BROWN, rtol=1e-14)

    def test_pixels_and_millimetres(self):
        # With a pitch of 20 µm, d² in px is 2500 times that in mm.
        pixels, mm = (photogrammetric_from_opencv(BROWN, f) for f in (1200, 24))
        np.testing.assert_allclose(mm.radial / pixels.radial, [2500, 2500**2, 2500**3])
        np.testing.assert_allclose(mm.tangential / pixels.tangential, 50)

    def test_higher_terms_by_hand(self):
        # d² = 25 at (3, 4): the tangential part is multiplied by 1 + 25 P3 + 625 P4.
        moved = distort_photogrammetric([3, 4], (0, 0), [0], [0, 1e-3, 0.02, 1e-3])
        factor = 1 + 25 * 0.02 + 625e-3
        np.testing.assert_allclose(moved, [3 + factor * 43e-3, 4 + factor * 24e-3])
        np.testing.assert_allclose(
            distort_photogrammetric([3, 4], (0, 0), [0, 0, 0, 1e-6])[0], 3 * (1 + 25**4 * 1e-6)
        )

    def test_errors(self):
        with pytest.raises(ValueError, match="no rational and no prism terms"):
            photogrammetric_from_opencv([*BROWN, 0.1, 0, 0], 1000)
        with pytest.raises(ValueError, match="f must be positive"):
            photogrammetric_from_opencv(BROWN, 0)
        with pytest.raises(ValueError, match="tangential must be 2 to 12 numbers"):
            distort_photogrammetric([1, 2], (0, 0), [0], [1])
        with pytest.raises(ValueError, match="check the unit"):
            distort_photogrammetric([1e9, 2], (0, 0), [0])


class TestBouguet:
    K = np.array([[800.0, 4, 330], [0, 790, 250], [0, 0, 1]])

    def test_round_trip(self):
        K, k = opencv_from_bouguet(*bouguet_from_opencv(self.K, BROWN))
        np.testing.assert_allclose(K, self.K, rtol=1e-15)
        np.testing.assert_array_equal(k, BROWN)

    def test_is_the_same_camera(self):
        # The toolbox: u = fc₁ (x_d + alpha_c y_d) + cc₁, v = fc₂ y_d + cc₂.
        fc, cc, alpha_c, kc = bouguet_from_opencv(self.K, BROWN)
        x, y = distort(POINTS, kc).T
        pixels = np.stack([fc[0] * (x + alpha_c * y) + cc[0], fc[1] * y + cc[1]], axis=1)
        ideal = POINTS @ self.K[:2, :2].T + self.K[:2, 2]
        np.testing.assert_allclose(distort_pixels(ideal, self.K, BROWN), pixels, rtol=1e-12)

    def test_errors(self):
        with pytest.raises(ValueError, match="no rational and no prism"):
            bouguet_from_opencv(self.K, [*BROWN, 0.1, 0, 0])
        with pytest.raises(ValueError, match="fc must be positive"):
            opencv_from_bouguet([800, 0], [1, 2], 0, BROWN)
        with pytest.raises(ValueError, match=r"kc must have shape \(5,\)"):
            opencv_from_bouguet([800, 800], [1, 2], 0, BROWN[:4])


class TestEbner:
    def test_terms_are_orthogonal_on_nine_points(self):
        grid = np.stack(np.meshgrid([-7.0, 0, 7], [-7.0, 0, 7]), axis=-1).reshape(-1, 2)
        columns = [ebner(grid, row, 7).ravel() for row in np.eye(12)]
        columns += [np.tile([1.0, 0], 9), np.tile([0, 1.0], 9)]
        columns = np.array([column / np.linalg.norm(column) for column in columns])
        # Neither each other, nor a shift; sixteen terms would fill the nine points up.
        np.testing.assert_allclose(columns @ columns.T, np.eye(14), atol=1e-14)

    def test_shapes(self):
        assert ebner([1, 2], np.ones(12), 5).shape == (2,)
        assert ebner(np.ones((3, 2)), np.ones(12), 5).shape == (3, 2)

    def test_errors(self):
        with pytest.raises(ValueError, match="12"):
            ebner([1, 2], np.ones(11), 5)
        with pytest.raises(ValueError, match="b must be positive"):
            ebner([1, 2], np.ones(12), 0)


class TestCorrection:
    @pytest.mark.parametrize("k", [[-0.3, 0.12], [0.2], [-0.3, 0.1, 0, 0, 0, 0.1, 0.2, 0]])
    def test_error_is_what_it_says(self, k):
        corrections, largest = radial_correction(k, 0.7, terms=4)
        r = np.linspace(0, 0.7, 5000)
        points = np.stack([r, 0 * r], axis=1)
        error = np.abs(distort_radial(distort(points, k), corrections) - points).max()
        assert error == pytest.approx(largest, rel=0.02)
        assert error < 1e-3

    def test_more_terms_fit_better(self):
        errors = [radial_correction([-0.3], 0.7, terms)[1] for terms in range(1, 8)]
        assert (np.diff(errors) < 0).all()
        assert errors[0] > 1e-3
        assert errors[-1] < 3e-5

    def test_first_terms_of_the_series(self):
        # r = r_d - k1 r_d³ + (3 k1² - k2) r_d⁵ - …
        corrections, _ = radial_correction([-0.2, 0.1], 0.1, terms=4)
        assert corrections[0] == pytest.approx(0.2, rel=1e-6)
        assert corrections[1] == pytest.approx(3 * 0.04 - 0.1, rel=1e-3)

    def test_errors(self):
        limit = valid_radius([-0.3])
        for radius in (0, -1, limit * 1.01):
            with pytest.raises(ValueError, match=r"not beyond the valid radius 1\.05409"):
                radial_correction([-0.3], radius)
        with pytest.raises(ValueError, match="terms must be 1 to 10, got 0"):
            radial_correction([-0.3], 0.5, terms=0)
