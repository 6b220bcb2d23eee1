import numpy as np
import pytest

from course_lib.camera import (
    Camera,
    camera_at,
    camera_matrix,
    decompose_projection,
    pixel_ray,
    project,
)
from course_lib.checks import DegenerateConfigurationError
from course_lib.transforms import rotation_from_omega_phi_kappa

K = np.array([[810.0, 3.0, 318.0], [0.0, 790.0, 242.0], [0.0, 0.0, 1.0]])


def a_camera():
    return camera_at((4, -3, 2), (0, 0, 0.5), K, (640, 480))


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
