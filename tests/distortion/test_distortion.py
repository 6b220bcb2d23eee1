"""The models themselves: forward on normalised coordinates, on pixels, and their derivatives."""

import numpy as np
import pytest

from course_lib.distortion import (
    distort,
    distort_pixels,
    distort_radial,
    distort_rational_prism,
    distortion_jacobian,
    normalised_from_pixels,
    pixels_from_normalised,
    undistort_pixels,
)

K = np.array([[800.0, 3, 330], [0, 790, 250], [0, 0, 1]])
BROWN = [-0.3, 0.12, 0.001, -0.0008, -0.02]
FULL = [*BROWN, 0.1, 0.05, -0.02, 0.002, -0.001, 0.003, 0.0005]


def some_points(count=50, reach=0.7):
    return np.random.default_rng(4).uniform(-reach, reach, (count, 2))


class TestDistort:
    def test_shapes(self):
        assert distort([0.1, 0.2], BROWN).shape == (2,)
        assert distort([[0.1, 0.2]], BROWN).shape == (1, 2)
        assert distort(np.empty((0, 2)), BROWN).shape == (0, 2)
        column = np.array(BROWN)[:, None]  # as OpenCV returns them
        np.testing.assert_array_equal(distort([0.1, 0.2], column), distort([0.1, 0.2], BROWN))

    def test_inputs_stay_as_they_are(self):
        points, k = some_points(), np.array(FULL)
        before = points.copy(), k.copy()
        distort(points, k)
        distortion_jacobian(points, k)
        np.testing.assert_array_equal(points, before[0])
        np.testing.assert_array_equal(k, before[1])

    def test_accuracy_by_hand(self):
        # r² = 0.25; r⁴ = 0.0625; every term on its own.
        x, y = 0.3, 0.4
        moves = {
            0: (0.25 * x, 0.25 * y),
            1: (0.0625 * x, 0.0625 * y),
            2: (2 * x * y, 0.25 + 2 * y * y),
            3: (0.25 + 2 * x * x, 2 * x * y),
            4: (0.015625 * x, 0.015625 * y),
            8: (0.25, 0),
            9: (0.0625, 0),
            10: (0, 0.25),
            11: (0, 0.0625),
        }
        for place, move in moves.items():
            k = np.zeros(12)
            k[place] = 0.01
            expected = np.array([x, y]) + 0.01 * np.array(move)
            np.testing.assert_allclose(distort([x, y], k), expected, rtol=1e-15)

    @pytest.mark.parametrize("place", [5, 6, 7])
    def test_denominator_by_hand(self, place):
        k = np.zeros(12)
        k[place] = 0.5
        factor = 1 / (1 + 0.5 * 0.25 ** (place - 4))
        np.testing.assert_allclose(distort([0.3, 0.4], k), [0.3 * factor, 0.4 * factor])

    @pytest.mark.parametrize("count", [1, 2, 4, 5, 8, 12])
    def test_fewer_coefficients_are_zeros(self, count):
        k = [*FULL[:count], *[0] * (12 - count)]
        np.testing.assert_array_equal(
            distort(some_points(), FULL[:count]), distort(some_points(), k)
        )

    def test_prism_of_a_plane(self):
        k = np.zeros(12)
        assert distort([1, 0], k)[0] == 1
        np.testing.assert_array_equal(distort(some_points(), k), some_points())

    def test_pole_is_nan(self):
        got = distort([[1, 0], [0.5, 0]], [0, 0, 0, 0, 0, -1, 0, 0])
        assert np.isnan(got[0]).all()
        np.testing.assert_allclose(got[1], [0.5 / 0.75, 0])

    @pytest.mark.parametrize(
        ("k", "message"),
        [
            ([1, 2, 3], r"got shape \(3,\).*k3 stands fifth: k1, k2, 0, 0, k3"),
            ([0] * 14, "tilt of the sensor"),
            ([0] * 6, "fill up with zeros"),
            ([], "must be 1, 2, 4, 5, 8 or 12 numbers"),
            ([np.nan], "must be finite"),
            ([1e40], "which no lens has"),
        ],
    )
    def test_errors_of_coefficients(self, k, message):
        for function in (distort, distortion_jacobian):
            with pytest.raises(ValueError, match=message):
                function([0.1, 0.2], k)

    def test_errors_of_points(self):
        with pytest.raises(ValueError, match=r"must have shape \(N, 2\)"):
            distort([1, 2, 3], [0])
        with pytest.raises(ValueError, match=r"tangents X/Z, got 3e\+06: take K off the pixels"):
            distort([3e6, 0], [0])


class TestVariants:
    def test_radial_is_the_full_model(self):
        k1, k2, k3 = -0.3, 0.1, -0.02
        expected = distort(some_points(), [k1, k2, 0, 0, k3])
        np.testing.assert_allclose(distort_radial(some_points(), [k1, k2, k3]), expected)
        np.testing.assert_allclose(distort_radial(some_points(), k1), distort(some_points(), [k1]))

    def test_radial_of_many_terms(self):
        np.testing.assert_allclose(distort_radial([0.5, 0], [0, 0, 0, 1]), [0.5 + 0.5**9, 0])

    def test_grouped_is_the_full_model(self):
        k, p, s = [*FULL[:2], *FULL[4:8]], FULL[2:4], FULL[8:]
        expected = distort(some_points(), FULL)
        np.testing.assert_array_equal(distort_rational_prism(some_points(), k, p, s), expected)

    def test_errors(self):
        with pytest.raises(ValueError, match=r"k must have shape \(6,\)"):
            distort_rational_prism([0, 0], [0] * 3, [0] * 2, [0] * 4)
        with pytest.raises(ValueError, match="up to ten coefficients"):
            distort_radial([0, 0], [0] * 11)


class TestJacobian:
    def test_shapes(self):
        assert distortion_jacobian([0.1, 0.2], BROWN).shape == (2, 2)
        assert distortion_jacobian(some_points(7), BROWN).shape == (7, 2, 2)

    @pytest.mark.parametrize("count", [1, 2, 4, 5, 8, 12])
    def test_accuracy_against_differences(self, count):
        k, h = FULL[:count], 1e-6
        slopes = [
            (distort(some_points() + step, k) - distort(some_points() - step, k)) / (2 * h)
            for step in ([h, 0], [0, h])
        ]
        found = distortion_jacobian(some_points(), k)
        np.testing.assert_allclose(found, np.stack(slopes, axis=-1), atol=1e-9)

    def test_no_lens(self):
        np.testing.assert_array_equal(distortion_jacobian([0.3, 0.2], [0]), np.eye(2))


class TestPixels:
    def test_round_trip_of_coordinates(self):
        pixels = some_points() * 600
        back = pixels_from_normalised(normalised_from_pixels(pixels, K), K)
        np.testing.assert_allclose(back, pixels, atol=1e-11)

    def test_normalised_is_the_inverse_of_K(self):
        homogeneous = np.linalg.inv(K) @ [123, 45, 1]
        np.testing.assert_allclose(normalised_from_pixels([123, 45], K), homogeneous[:2])

    def test_round_trip(self):
        pixels = some_points() * [500, 400] + [320, 240]
        bent = distort_pixels(pixels, K, BROWN)
        assert np.abs(bent - pixels).max() > 20
        np.testing.assert_allclose(undistort_pixels(bent, K, BROWN), pixels, atol=1e-10)

    def test_new_intrinsics(self):
        new = np.array([[400.0, 0, 100], [0, 400, 100], [0, 0, 1]])
        ideal = pixels_from_normalised([0.2, -0.1], new)
        bent = pixels_from_normalised(distort([0.2, -0.1], BROWN), K)
        np.testing.assert_allclose(undistort_pixels(bent, K, BROWN, new), ideal, atol=1e-10)

    def test_shapes(self):
        assert distort_pixels([1, 2], K, BROWN).shape == (2,)
        assert undistort_pixels([[1, 2]], K, BROWN).shape == (1, 2)

    def test_errors(self):
        for function in (distort_pixels, undistort_pixels):
            with pytest.raises(ValueError, match="K must be"):
                function([1, 2], np.zeros((3, 3)), BROWN)
