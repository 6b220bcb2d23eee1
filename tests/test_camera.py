import doctest

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from course_lib import camera, pinhole, projection
from course_lib.camera import (
    Camera,
    camera_at,
    camera_centre,
    camera_matrix,
    decompose_projection,
    dolly_zoom,
    first_guess_intrinsics,
    pixel_focal_length,
    pixel_ray,
    project,
    project_pinhole,
    vanishing_point,
)
from course_lib.checks import DegenerateConfigurationError
from course_lib.transforms import look_at, rotation_from_omega_phi_kappa

SENSOR, IMAGE = (36.0, 24.0), (6000, 4000)
K = np.array([[810.0, 3.0, 318.0], [0.0, 790.0, 242.0], [0.0, 0.0, 1.0]])
numbers = st.one_of(st.just(0.0), st.floats(1e-6, 1e6), st.floats(-1e6, -1e-6))
points = st.lists(st.tuples(numbers, numbers, numbers), min_size=1, max_size=5)


def a_camera():
    return camera_at((4, -3, 2), (0, 0, 0.5), K, (640, 480))


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


class TestCamera:
    def test_shapes(self):
        cam = a_camera()
        assert cam.project((0, 0, 0)).shape == (2,)
        assert cam.project(np.zeros((4, 3))).shape == (4, 2)
        assert cam.pixel_ray((0, 0)).shape == (3,)
        assert cam.pixel_ray(np.zeros((4, 2))).shape == (4, 3)
        assert cam.image_size == (640, 480)

    @pytest.mark.parametrize(
        ("change", "words"),
        [
            ({"K": np.eye(4)}, r"K must have shape \(3, 3\)"),
            ({"K": K.T}, r"K must be \[\[fx, s, cx\]"),
            ({"K": -K}, r"K must be \[\[fx, s, cx\]"),
            ({"R": 2 * np.eye(3)}, "not a rotation"),
            ({"t": np.zeros(4)}, r"t must have shape \(3,\)"),
            ({"image_size": (640, 0)}, "image_size must be positive"),
            ({"image_size": (640.5, 480)}, "whole pixels"),
        ],
    )
    def test_errors(self, change, words):
        good = {"K": K, "R": np.eye(3), "t": np.zeros(3), "image_size": (640, 480)}
        with pytest.raises(ValueError, match=words):
            Camera(**(good | change))

    def test_is_frozen(self):
        mine = K.copy()
        cam = Camera(mine, np.eye(3), np.zeros(3), (640, 480))
        mine[0, 0] = 1
        assert cam.K[0, 0] == 810
        for array in (cam.K, cam.R, cam.t, cam.P, cam.centre):
            with pytest.raises(ValueError, match="read-only"):
                array[0] = 1

    def test_round_trip(self):
        cam = a_camera()
        pixels = np.random.default_rng(0).uniform(0, 480, (50, 2))
        rays = cam.pixel_ray(pixels)
        np.testing.assert_allclose(np.linalg.norm(rays, axis=1), 1)
        seen = cam.project(cam.centre + 3.7 * rays)
        np.testing.assert_allclose(seen, pixels, atol=1e-9)

    def test_accuracy(self):
        # The target is seen in the principal point, and what stands above it higher up.
        uv = a_camera().project([(0, 0, 0.5), (0, 0, 0.7)])
        np.testing.assert_allclose(uv[0], K[:2, 2])
        assert uv[1, 1] < uv[0, 1]
        assert uv[1, 0] == pytest.approx(uv[0, 0], abs=0.2)  # the skew moves it a little

    def test_degenerate(self):
        cam = Camera(K, *look_at((0, -1, 0), (0, 0, 0)), (640, 480))
        behind = cam.project([(0, -2, 0), (5, -1, 3)])
        assert np.isnan(behind).all()

    def test_properties(self):
        cam = a_camera()
        np.testing.assert_allclose(cam.P, cam.K @ np.column_stack([cam.R, cam.t]))
        np.testing.assert_allclose(cam.centre, (4, -3, 2))
        np.testing.assert_allclose(cam.centre, camera_centre(cam.R, cam.t))


class TestCameraMatrix:
    def test_shapes(self):
        assert camera_matrix(K, np.eye(3), (0, 0, 0)).shape == (3, 4)

    @pytest.mark.parametrize(
        ("arguments", "words"),
        [
            ((K.T, np.eye(3), np.zeros(3)), r"K must be \[\[fx, s, cx\]"),
            ((2 * K, np.eye(3), np.zeros(3)), r"K must be \[\[fx, s, cx\]"),
            ((K, np.diag([1, -1, 1]), np.zeros(3)), "R is a reflection"),
            ((K, np.eye(3), np.zeros((3, 1))), r"t must have shape \(3,\), got \(3, 1\)"),
        ],
    )
    def test_errors(self, arguments, words):
        with pytest.raises(ValueError, match=words):
            camera_matrix(*arguments)

    def test_accuracy(self):
        # It takes the centre to zero, and the camera's axis to the principal point.
        cam = a_camera()
        np.testing.assert_allclose(cam.P @ [*cam.centre, 1], 0, atol=1e-12)
        u, v, w = cam.P @ [*(cam.centre + 2.5 * cam.R[2]), 1]
        assert w == pytest.approx(2.5)
        np.testing.assert_allclose((u / w, v / w), K[:2, 2])


class TestProject:
    def test_shapes(self):
        P = a_camera().P
        assert project((0, 0, 0), P).shape == (2,)
        assert project(np.zeros((4, 3)), P).shape == (4, 2)
        assert project(np.zeros((0, 3)), P).shape == (0, 2)
        assert project(np.zeros((4, 3)), P).flags.c_contiguous

    @pytest.mark.parametrize(
        ("points", "P", "words"),
        [
            (np.zeros((3, 4)), np.eye(3, 4), r"points must have shape \(N, 3\) or \(3,\)"),
            (np.zeros((4, 3)), np.eye(3), r"P must have shape \(3, 4\), got \(3, 3\)"),
            ((0, 0, np.nan), np.eye(3, 4), "points must be finite"),
        ],
    )
    def test_errors(self, points, P, words):
        with pytest.raises(ValueError, match=words):
            project(points, P)

    def test_accuracy(self):
        # The same as turning and moving, then dividing by the depth, then K.
        cam = a_camera()
        points = np.random.default_rng(1).normal(size=(30, 3))
        X, Y, Z = cam.R @ points.T + cam.t[:, None]
        v = 790 * Y / Z + 242
        u = 810 * X / Z + 3 * Y / Z + 318
        np.testing.assert_allclose(project(points, cam.P), np.column_stack([u, v]), rtol=1e-12)

    def test_photogrammetric_form_is_the_same_camera(self):
        """``(i, j) = I(π(R (L − C)))``, with the interior orientation I and the landmark L."""
        R, C = rotation_from_omega_phi_kappa(1.1, 0.9, 0.4), np.array([4.0, -3, 2])
        cam = Camera(K, R, -R @ C, (640, 480))
        for L in C + np.random.default_rng(5).uniform((-1, -1, 2), (1, 1, 9), (20, 3)) @ R:
            x, y, z = R @ (L - C)
            i = 318 + 810 * x / z + 3 * y / z
            j = 242 + 790 * y / z
            np.testing.assert_allclose(cam.project(L), (i, j))

    @pytest.mark.parametrize("scale", [-1, 3, -0.01, 1e70, -1e-200])
    def test_scale_and_sign_mean_nothing(self, scale):
        cam = a_camera()
        points = [(0, 0, 0), (8, -6, 4)]  # in front, behind
        expected = project(points, cam.P)
        np.testing.assert_array_equal(np.isnan(expected), [[False, False], [True, True]])
        np.testing.assert_allclose(project(points, scale * cam.P), expected)

    def test_degenerate(self):
        P = camera_matrix(K, np.eye(3), (0, 0, 0))
        uv = project([(1, 1, 1), (1, 1, 0), (0, 0, 0), (1, 1, -1)], P)
        np.testing.assert_array_equal(np.isnan(uv[:, 0]), [False, True, True, True])
        parallel = np.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
        for P in (parallel, np.zeros((3, 4)), np.ones((3, 4))):
            with pytest.raises(DegenerateConfigurationError, match="centre is at infinity"):
                project((0, 0, 0), P)

    def test_inputs_stay_as_they_are(self):
        points, P = np.array([[1.0, 2, -3]]), -camera_matrix(K, np.eye(3), (0, 0, 0))
        copies = points.copy(), P.copy()
        project(points, P)
        np.testing.assert_array_equal(points, copies[0])
        np.testing.assert_array_equal(P, copies[1])


class TestPixelRay:
    def test_shapes(self):
        cam = a_camera()
        for pixels, shape in (((0, 0), (3,)), (np.zeros((4, 2)), (4, 3))):
            centre, directions = pixel_ray(pixels, cam.K, cam.R, cam.t)
            assert centre.shape == (3,)
            assert directions.shape == shape

    def test_errors(self):
        with pytest.raises(ValueError, match=r"pixels must have shape \(N, 2\) or \(2,\)"):
            pixel_ray((0, 0, 1), K, np.eye(3), (0, 0, 0))
        with pytest.raises(ValueError, match="not a rotation"):
            pixel_ray((0, 0), K, np.zeros((3, 3)), (0, 0, 0))

    def test_round_trip(self):
        cam = a_camera()
        pixels = np.random.default_rng(2).uniform(-200, 900, (50, 2))
        centre, directions = pixel_ray(pixels, cam.K, cam.R, cam.t)
        np.testing.assert_allclose(np.linalg.norm(directions, axis=1), 1)
        for distance in (0.1, 30):
            seen = project(centre + distance * directions, cam.P)
            np.testing.assert_allclose(seen, pixels, atol=1e-9)

    def test_accuracy(self):
        # The principal point looks along the camera's axis.
        cam = a_camera()
        centre, direction = pixel_ray(K[:2, 2], cam.K, cam.R, cam.t)
        np.testing.assert_allclose(direction, cam.R[2], atol=1e-15)
        np.testing.assert_allclose(centre, (4, -3, 2))


class TestDecomposeProjection:
    #: Published: Hartley & Zisserman, example 6.2.
    P = np.array(
        [
            [3.53553e2, 3.39645e2, 2.77744e2, -1.44946e6],
            [-1.03528e2, 2.33212e1, 4.59607e2, -6.32525e5],
            [7.07107e-1, -3.53553e-1, 6.12372e-1, -9.18559e2],
        ]
    )

    def test_shapes(self):
        K, R, centre = decompose_projection(self.P)
        assert K.shape == R.shape == (3, 3)
        assert centre.shape == (3,)

    def test_errors(self):
        with pytest.raises(ValueError, match=r"P must have shape \(3, 4\)"):
            decompose_projection(np.eye(4))
        with pytest.raises(ValueError, match="P must be finite"):
            decompose_projection(np.full((3, 4), np.nan))

    @pytest.mark.parametrize("scale", [1, -1, 1e-3, -7])
    def test_accuracy(self, scale):
        K, R, centre = decompose_projection(scale * self.P)
        np.testing.assert_allclose(K, [[468.2, 91.2, 300], [0, 427.2, 200], [0, 0, 1]], atol=0.05)
        np.testing.assert_allclose(centre, (1000, 2000, 1500), atol=0.02)
        published = [[0.4138, 0.9091, 0.0471], [-0.5734, 0.22011, 0.7892]]
        np.testing.assert_allclose(R[:2], published, atol=6e-4)

    @pytest.mark.parametrize("scale", [1, -1, 1e-20, -1e20])
    def test_round_trip(self, scale):
        rng = np.random.default_rng(3)
        for _ in range(20):
            cam = camera_at(rng.normal(size=3), rng.normal(size=3), K, (640, 480))
            K2, R, centre = decompose_projection(scale * cam.P)
            np.testing.assert_allclose(K2, K, rtol=1e-11, atol=1e-9)
            np.testing.assert_allclose(R, cam.R, atol=1e-12)
            np.testing.assert_allclose(centre, cam.centre, atol=1e-11)

    def test_degenerate(self):
        for P in (np.zeros((3, 4)), np.ones((3, 4)), np.eye(3, 4) * [[1], [1], [0]]):
            with pytest.raises(DegenerateConfigurationError, match="centre is at infinity"):
                decompose_projection(P)


@pytest.mark.parametrize(
    ("function", "good"),
    [
        (camera_matrix, (K, np.eye(3), np.zeros(3))),
        (project, (np.ones(3), np.eye(3, 4))),
        (pixel_ray, (np.ones(2), K, np.eye(3), np.zeros(3))),
        (decompose_projection, (np.eye(3, 4),)),
    ],
)
@pytest.mark.parametrize(
    ("bad", "words"),
    [
        (lambda good: np.full_like(good, np.nan), "must be finite"),
        (lambda good: np.zeros((2, 7)), "must have shape"),
    ],
    ids=["nan", "shape"],
)
def test_every_argument_is_checked(function, good, bad, words):
    function(*good)
    for i, argument in enumerate(good):
        with pytest.raises(ValueError, match=words):
            function(*good[:i], bad(argument), *good[i + 1 :])


@pytest.mark.parametrize("module", [pinhole, projection, camera])
def test_examples_run(module):
    assert doctest.testmod(module).failed == 0
