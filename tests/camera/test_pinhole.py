import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from course_lib.camera import (
    dolly_zoom,
    first_guess_intrinsics,
    pixel_focal_length,
    project_pinhole,
    vanishing_point,
)

SENSOR, IMAGE = (36.0, 24.0), (6000, 4000)
numbers = st.one_of(st.just(0.0), st.floats(1e-6, 1e6), st.floats(-1e6, -1e-6))
points = st.lists(st.tuples(numbers, numbers, numbers), min_size=1, max_size=5)


class TestIntrinsics:
    def test_shapes(self):
        assert pixel_focal_length(50, SENSOR, IMAGE).shape == (2,)
        assert first_guess_intrinsics(50, SENSOR, IMAGE).shape == (3, 3)

    @pytest.mark.parametrize("function", [pixel_focal_length, first_guess_intrinsics])
    @pytest.mark.parametrize(
        ("arguments", "words"),
        [
            ((0, SENSOR, IMAGE), "f must be positive, got 0"),
            ((-50, SENSOR, IMAGE), "f must be positive, got -50"),
            ((np.nan, SENSOR, IMAGE), "f must be finite"),
            ((50, 36, IMAGE), r"sensor_size .* must have shape \(2,\), got \(\)"),
            ((50, SENSOR, (6000, 0)), "image_size must be positive"),
            ((50, SENSOR, (6000, 4000, 3)), r"image_size .* must have shape \(2,\), got \(3,\)"),
        ],
    )
    def test_errors(self, function, arguments, words):
        with pytest.raises(ValueError, match=words):
            function(*arguments)

    def test_accuracy(self):
        # Published: 85 mm, 2048 x 1920 px on 27.6 x 25.9 mm has 74.2 px/mm, f = 6307.2 px.
        sensor, image = (27.6, 25.9), (2048, 1920)
        fx, fy = pixel_focal_length(85, sensor, image)
        assert round(fx / 85, 1) == 74.2
        assert fx == pytest.approx(6307.2, abs=0.06)
        assert fy == pytest.approx(85 * 1920 / 25.9)
        # It gives c = (1024, 960) counting from the corner; ours counts from the pixel's centre.
        guess = first_guess_intrinsics(85, sensor, image)
        np.testing.assert_allclose(guess[:2, 2] + 0.5, (1024, 960))
        np.testing.assert_allclose(np.diag(guess), (fx, fy, 1))

    def test_round_trip(self):
        # Published: calibrated, the same lens has 6890.5 px. In mm that is 92.9.
        px_per_mm = pixel_focal_length(1, (27.6, 25.9), (2048, 1920))[0]
        assert round(6890.5 / px_per_mm, 1) == 92.9


class TestProjectPinhole:
    def test_shapes(self):
        assert project_pinhole((1, 2, 3), 800, (320, 240)).shape == (2,)
        assert project_pinhole(np.ones((5, 3)), 800, (320, 240)).shape == (5, 2)
        assert project_pinhole(np.ones((0, 3)), 800, (320, 240)).shape == (0, 2)
        assert project_pinhole([[1, 2, 3]], (800, 810), (320, 240)).dtype == np.float64

    @pytest.mark.parametrize(
        ("arguments", "words"),
        [
            ((np.ones((4, 2)), 800, (320, 240)), r"points must have shape \(N, 3\) or \(3,\)"),
            ((np.ones((2, 4, 3)), 800, (320, 240)), "points are rows"),
            (([1, np.nan, 3], 800, (320, 240)), "points must be finite"),
            (([1, 2, 3], -800, (320, 240)), "f must be positive"),
            (([1, 2, 3], (800, 800, 800), (320, 240)), r"f must be one number or \(fx, fy\)"),
            (([1, 2, 3], 800, 320), r"c must have shape \(2,\), got \(\)"),
        ],
    )
    def test_errors(self, arguments, words):
        with pytest.raises(ValueError, match=words):
            project_pinhole(*arguments)

    @pytest.mark.parametrize("bad", ["abc", [1j, 2, 3], [None, 1, 2], [True, False, True]])
    def test_errors_of_type(self, bad):
        with pytest.raises(TypeError, match="points must be real numbers"):
            project_pinhole(bad, 800, (320, 240))

    def test_round_trip(self):
        pixel, Z, f, c = np.array([100.0, 50.0]), 7.0, np.array([800, 820]), np.array([320, 240])
        X, Y = (pixel - c) / f * Z
        np.testing.assert_allclose(project_pinhole((X, Y, Z), f, c), pixel)

    def test_accuracy(self):
        # Similar triangles: twice as far is half as large, fx acts on u and fy on v.
        near, far = project_pinhole([[1, 2, 10], [1, 2, 20]], (1000, 500), (300, 200))
        np.testing.assert_allclose(near, (400, 300))
        np.testing.assert_allclose(far, (350, 250))

    def test_degenerate(self):
        uv = project_pinhole([[1, 1, 1], [1, 1, 0], [1, 1, -1], [0, 0, 0]], 800, (320, 240))
        np.testing.assert_array_equal(
            np.isnan(uv), [[False] * 2, [True] * 2, [True] * 2, [True] * 2]
        )

    @given(points, st.floats(1, 1e5), st.floats(-1e4, 1e4))
    def test_fuzz(self, rows, f, c):
        uv = project_pinhole(rows, f, (c, c))
        X, Y, Z = np.transpose(rows)
        assert (np.isnan(uv).all(axis=1) == (Z <= 0)).all()
        seen = Z > 0
        expected = c + f * np.stack([X, Y], axis=1)[seen] / Z[seen, None]
        np.testing.assert_allclose(uv[seen], expected, rtol=1e-9)


class TestVanishingPoint:
    def test_shapes(self):
        assert vanishing_point((1, 2, 3), 800, (320, 240)).shape == (2,)
        assert vanishing_point(np.ones((4, 3)), 800, (320, 240)).shape == (4, 2)

    def test_errors(self):
        with pytest.raises(ValueError, match="zero vector, which points nowhere"):
            vanishing_point([[0, 0, 1], [0, 0, 0]], 800, (320, 240))
        with pytest.raises(ValueError, match=r"direction must have shape"):
            vanishing_point((1, 2), 800, (320, 240))

    def test_accuracy(self):
        # The limit of the image of a point that runs along a line, from any start.
        d, f, c = np.array([0.3, -0.2, 0.9]), (800, 810), (320, 240)
        far = project_pinhole(np.array([[5, 4, 3], [-5, 1, 2]]) + 1e9 * d, f, c)
        np.testing.assert_allclose(far, [vanishing_point(d, f, c)] * 2, atol=1e-4)

    def test_round_trip(self):
        d = np.array([0.3, -0.2, 0.9])
        forth, back, longer = vanishing_point([d, -d, 7 * d], 800, (320, 240))
        np.testing.assert_allclose(forth, back)
        np.testing.assert_allclose(forth, longer)

    def test_degenerate(self):
        uv = vanishing_point([[1, 2, 0], [1, 2, 0.5]], 800, (320, 240))
        np.testing.assert_array_equal(np.isnan(uv), [[True, True], [False, False]])

    @given(points)
    def test_fuzz(self, rows):
        if not np.any(rows, axis=1).all():
            with pytest.raises(ValueError, match="zero vector"):
                vanishing_point(rows, 800, (320, 240))
            return
        uv = vanishing_point(rows, 800, (320, 240))
        parallel = np.array(rows)[:, 2] == 0
        assert (np.isnan(uv).all(axis=1) == parallel).all()


class TestDollyZoom:
    def test_shapes(self):
        assert np.ndim(dolly_zoom(50, 2, 6)) == 0
        assert dolly_zoom(50, 2, [2, 4, 6]).shape == (3,)

    @pytest.mark.parametrize("arguments", [(0, 1, 1), (50, 0, 1), (50, 1, -1), (50, np.inf, 1)])
    def test_errors(self, arguments):
        with pytest.raises(ValueError, match=r"positive|finite"):
            dolly_zoom(*arguments)

    def test_accuracy(self):
        # The object keeps its size in the picture, and what is behind it does not.
        f, Z, Z_new = 50.0, 2.0, 6.0
        f_new = dolly_zoom(f, Z, Z_new)
        before = project_pinhole([[1, 1, Z], [1, 1, Z + 10]], f, (0, 0))
        after = project_pinhole([[1, 1, Z_new], [1, 1, Z_new + 10]], f_new, (0, 0))
        np.testing.assert_allclose(before[0], after[0])
        assert (after[1] > 2 * before[1]).all()

    def test_round_trip(self):
        np.testing.assert_allclose(dolly_zoom(dolly_zoom(50, 2, 6), 6, 2), 50)
