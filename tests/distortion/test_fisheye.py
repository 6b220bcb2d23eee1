import numpy as np
import pytest

from course_lib.distortion import fisheye_project, fisheye_ray, fisheye_valid_angle

K = np.array([[300.0, 2, 330], [0, 295, 250], [0, 0, 1]])
LENS = [-0.02, 0.004, -0.001, 0.0001]
EQUIDISTANT = [0, 0, 0, 0]


def directions(widest, count=400):
    rng = np.random.default_rng(9)
    angle, turn = rng.uniform(0, widest, count), rng.uniform(0, 2 * np.pi, count)
    return np.stack(
        [np.sin(angle) * np.cos(turn), np.sin(angle) * np.sin(turn), np.cos(angle)], axis=1
    )


class TestProject:
    def test_shapes(self):
        assert fisheye_project([0.1, 0.2, 1], K, LENS).shape == (2,)
        assert fisheye_project(directions(1), K, LENS).shape == (400, 2)
        assert fisheye_project(np.empty((0, 3)), K, LENS).shape == (0, 2)

    def test_equal_angles_are_equal_distances(self):
        angle = np.linspace(0, 3, 31)
        points = np.stack([np.sin(angle), 0 * angle, np.cos(angle)], axis=1)
        u = fisheye_project(5 * points, K, EQUIDISTANT)[:, 0]
        np.testing.assert_allclose(u, 330 + 300 * angle, rtol=1e-14)

    def test_near_the_axis_it_is_a_pinhole(self):
        pixel = fisheye_project([1e-4, -2e-4, 1], K, LENS)
        np.testing.assert_allclose(pixel, [330 + 0.03 - 4e-4, 250 - 0.059], atol=1e-7)

    def test_axis_and_what_has_no_image(self):
        points = [[0, 0, 2], [0, 0, 0], [0, 0, -2], [1, 0, -1e-3]]
        got = fisheye_project(points, K, EQUIDISTANT)
        np.testing.assert_array_equal(got[0], [330, 250])
        assert np.isnan(got[1:3]).all()
        assert np.isfinite(got[3]).all()

    def test_beyond_the_valid_angle(self):
        k = [-0.1, 0, 0, 0]
        limit = fisheye_valid_angle(k)
        for angle, seen in ((limit - 1e-6, True), (limit + 1e-6, False)):
            point = [np.sin(angle), 0, np.cos(angle)]
            assert np.isfinite(fisheye_project(point, K, k)).all() == seen

    def test_errors(self):
        with pytest.raises(ValueError, match=r"four coefficients .* got shape \(5,\)"):
            fisheye_project([0, 0, 1], K, [0] * 5)
        with pytest.raises(ValueError, match="which no lens has"):
            fisheye_ray([0, 0], K, [1e40, 0, 0, 0])
        with pytest.raises(ValueError, match="K must be"):
            fisheye_project([0, 0, 1], np.zeros((3, 3)), LENS)


class TestRay:
    @pytest.mark.parametrize("k", [EQUIDISTANT, LENS, [0.2, 0.1, 0, 0], [-0.1, 0.01, 0, 0]])
    def test_round_trip(self, k):
        rays = directions(0.999 * fisheye_valid_angle(k))
        np.testing.assert_allclose(fisheye_ray(fisheye_project(rays, K, k), K, k), rays, atol=1e-12)

    def test_shapes(self):
        assert fisheye_ray([1, 2], K, LENS).shape == (3,)
        assert fisheye_ray(np.ones((4, 2)), K, LENS).shape == (4, 3)

    def test_principal_point_looks_ahead(self):
        np.testing.assert_array_equal(fisheye_ray([330, 250], K, LENS), [0, 0, 1])

    def test_outside_of_the_image_circle(self):
        edge = 330 + 300 * np.pi
        assert np.isfinite(fisheye_ray([edge - 1, 250], K, EQUIDISTANT)).all()
        assert np.isnan(fisheye_ray([edge + 1, 250], K, EQUIDISTANT)).all()


class TestValidAngle:
    def test_accuracy_against_a_scan(self):
        for k in (LENS, [-0.1, 0.01, 0, 0], [0, -0.05, 0, 0], [0, 0, 0, -0.001]):
            angle = np.linspace(0, np.pi, 100_001)
            distance = sum(c * angle ** (2 * i + 1) for i, c in enumerate([1, *k]))
            falls = np.diff(distance) <= 0
            scanned = angle[falls.argmax()] if falls.any() else np.pi
            assert fisheye_valid_angle(k) == pytest.approx(scanned, abs=1e-4)
