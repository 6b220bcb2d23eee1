import cv2
import numpy as np
import pytest

from course_lib.camera import Camera, camera_at, first_guess_intrinsics
from data_generators.places import street, street_camera
from data_generators.quick import QuickRenderer
from data_generators.render import depth_map, numbers, photograph, radiance
from data_generators.scene import Patch, Scene, polygon
from data_generators.targets import checkerboard

SQUARE = 0.1  # m
COLUMNS, ROWS = 9, 7  # squares of the board


def make_with(engine, scene, camera):
    return QuickRenderer(scene).picture(camera) if engine == "quick" else photograph(scene, camera)


def board_scene():
    """A checkerboard in the plane z = 0, and the world points of its inner corners."""
    texture = checkerboard(COLUMNS, ROWS, 64, 1.0)
    size = np.array([COLUMNS + 2, ROWS + 2]) * SQUARE
    patch = Patch((0, 0, 0), (size[0], 0, 0), (0, -size[1], 0), texture)
    j, i = np.mgrid[1:ROWS, 1:COLUMNS]
    corners = np.stack([(i + 1) * SQUARE, -(j + 1) * SQUARE, 0 * i], axis=-1).reshape(-1, 3)
    return Scene((patch,), (120, 120, 120)), corners


def board_camera(rng, size=(320, 240)):
    K = first_guess_intrinsics(40, (36, 27), size)
    middle = np.array([0.55, -0.45, 0])
    return camera_at(middle + rng.uniform((-0.6, -0.8, 1.4), (0.6, -0.1, 1.7)), middle, K, size)


def wall(Z, colour, reach=10.0):
    """A wall across the view of a camera at the origin."""
    corner = np.array([-reach, -reach, Z])
    return Patch(corner, (2 * reach, 0, 0), (0, 2 * reach, 0), np.array(colour))


def standard_camera(size=(64, 48)):
    return Camera(first_guess_intrinsics(30, (36, 27), size), np.eye(3), np.zeros(3), size)


@pytest.mark.parametrize("engine", ["rays", "quick"])
class TestBothEngines:
    def test_shapes(self, engine):
        picture = make_with(engine, Scene((wall(2.0, (10, 20, 30)),)), standard_camera())
        assert picture.shape == (48, 64, 3)
        assert picture.dtype == np.uint8
        np.testing.assert_array_equal(picture[20, 20], (10, 20, 30))

    @pytest.mark.parametrize("seed", range(3))
    def test_corners_are_where_projected(self, engine, seed):
        rng = np.random.default_rng(seed)
        scene, corners = board_scene()
        camera = board_camera(rng)
        # A little blur, as of any lens: the detector wants edges a pixel wide.
        grey = cv2.GaussianBlur(make_with(engine, scene, camera)[..., 1], (0, 0), 1.0)
        expected = camera.project(corners)
        # OpenCV looks for each corner from a start that is up to 1.5 px off.
        start = (expected + rng.uniform(-1.5, 1.5, expected.shape)).astype(np.float32)
        stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_COUNT, 100, 1e-4)
        detected = cv2.cornerSubPix(grey, start.reshape(-1, 1, 2).copy(), (5, 5), (-1, -1), stop)[
            :, 0
        ]
        error = np.linalg.norm(detected - expected, axis=1)
        # px; the quick engine takes its texture from the nearest level.
        rms, worst = {"rays": (0.03, 0.06), "quick": (0.09, 0.15)}[engine]
        assert np.sqrt(np.mean(error**2)) < rms
        assert error.max() < worst
        assert np.linalg.norm((detected - expected).mean(axis=0)) < 0.015

    def test_occlusion(self, engine):
        near, far = wall(2.0, (200, 0, 0), 0.5), wall(4.0, (0, 200, 0))
        for patches in ((near, far), (far, near)):
            picture = make_with(engine, Scene(patches), standard_camera())
            np.testing.assert_array_equal(picture[24, 32], (200, 0, 0))
            np.testing.assert_array_equal(picture[24, 2], (0, 200, 0))

    def test_edges_are_smooth(self, engine):
        # A dark half plane whose edge lies at u = 31.25: a quarter of the pixel is bright.
        camera = standard_camera()
        edge = (31.25 - camera.K[0, 2]) / camera.K[0, 0] * 2
        half = Patch((edge, -5, 2.0), (9, 0, 0), (0, 10, 0), np.array((0, 0, 0)))
        picture = make_with(engine, Scene((half,), (200, 200, 200)), camera)
        assert picture[24, 30, 0] == 200
        assert picture[24, 32, 0] == 0
        assert int(picture[24, 31, 0]) == pytest.approx(150, abs=30)

    def test_one_sided(self, engine):
        front = [(-1, 1, 2), (-1, -1, 2), (1, -1, 2), (1, 1, 2)]
        for corners, seen in ((front, 200), (front[::-1], 0)):
            patch = polygon(corners, (200, 200, 200), one_sided=True)
            picture = make_with(engine, Scene((patch,), (0, 0, 0)), standard_camera())
            assert picture[24, 32, 0] == seen

    def test_seen_from_the_edge(self, engine):
        floor = Patch((-1, 0, 1), (2, 0, 0), (0, 0, 3), checkerboard(4, 4, 16, 1.0))
        picture = make_with(engine, Scene((floor,), (9, 9, 9)), standard_camera())
        assert (picture != 9).any(axis=(1, 2)).sum() <= 1  # no more than the row of its edge

    def test_behind_and_beside(self, engine):
        patches = (wall(-2.0, (200, 0, 0)), wall(2.0, (0, 200, 0), 0.1))
        picture = make_with(engine, Scene(patches, (7, 7, 7)), standard_camera())
        np.testing.assert_array_equal(picture[2, 2], (7, 7, 7))
        np.testing.assert_array_equal(picture[24, 32], (0, 200, 0))

    def test_no_aliasing(self, engine):
        # A tiled floor up to the horizon, against a picture with 256 samples a pixel.
        tiles = np.kron(np.array([[30, 220], [220, 30]]), np.ones((32, 32), int))
        floor = Patch((-40, 80, 0), (80, 0, 0), (0, -80, 0), tiles, repeat=(40.0, 40.0))
        K = first_guess_intrinsics(30, (36, 27), (96, 72))
        camera = camera_at((0.3, -2, 1.5), (0, 20, 0), K, (96, 72))
        reference = radiance(Scene((floor,)), camera, 16) * 255
        error = make_with(engine, Scene((floor,)), camera) - reference
        assert np.sqrt(np.mean(error**2)) < {"rays": 5, "quick": 14}[engine]
        # Aliasing would show as contrast where the tiles are too fine to be seen.
        fine = slice(1, 8)
        far = make_with(engine, Scene((floor,)), camera)[np.isfinite(error[..., 0]).any(axis=1)]
        assert far[fine].std() <= reference[fine].std() + 5

    def test_determinism(self, engine):
        camera = street_camera((96, 72))
        first = make_with(engine, street(), camera)
        np.testing.assert_array_equal(first, make_with(engine, street(), camera))

    def test_nothing_to_see(self, engine):
        picture = make_with(engine, Scene((), (1, 2, 3)), standard_camera())
        assert (picture == (1, 2, 3)).all()


class TestAgreement:
    def test_street(self):
        # Rays backwards against polygons forwards: two programs, one picture.
        camera = street_camera((240, 180))
        scene = street()
        error = QuickRenderer(scene).picture(camera).astype(float) - photograph(scene, camera)
        assert np.sqrt(np.mean(error**2)) < 8
        assert np.mean(np.abs(error) > 40) < 0.01

    @pytest.mark.parametrize("seed", range(4))
    def test_from_anywhere(self, seed):
        rng = np.random.default_rng(seed)
        eye = rng.uniform((-2.5, -6, 0.8), (2.5, 20, 6))
        target = eye + rng.uniform((-5, -5, -1), (5, 5, 1))
        K = first_guess_intrinsics(24, (36, 27), (120, 90))
        camera = camera_at(eye, target, K, (120, 90))
        scene = street()
        error = QuickRenderer(scene).picture(camera).astype(float) - photograph(scene, camera)
        assert np.mean(np.abs(error).max(axis=2) > 60) < 0.02


class TestStages:
    def test_depth(self):
        camera = standard_camera()
        depth = depth_map(Scene((wall(2.0, (1, 1, 1), 0.5), wall(5.0, (1, 1, 1)))), camera)
        assert depth[24, 32] == pytest.approx(2.0)
        assert depth[24, 2] == pytest.approx(5.0)
        assert np.isinf(depth_map(Scene(()), camera)).all()

    def test_depth_of_a_slanted_plane(self):
        camera = camera_at((0, 0, 1.5), (0, 10, 0), standard_camera().K, (64, 48))
        floor = Patch((-50, 100, 0), (100, 0, 0), (0, -100, 0), np.array((9, 9, 9)))
        depth = depth_map(Scene((floor,)), camera)
        # Back from pixel and depth to the world: the point lies on the floor.
        for u, v in ((3, 40), (32, 30), (60, 47)):
            in_camera = np.linalg.inv(camera.K) @ (u, v, 1) * depth[v, u]
            assert (camera.R.T @ (in_camera - camera.t))[2] == pytest.approx(0, abs=1e-9)

    def test_numbers(self):
        np.testing.assert_array_equal(numbers(np.array([-1, 0, 0.5, 1, 3])), (0, 0, 128, 255, 255))

    def test_exposure(self):
        scene, camera = Scene((), (100, 100, 100)), standard_camera()
        assert photograph(scene, camera, exposure=2.0)[0, 0, 0] == 200

    def test_errors(self):
        scene, camera = Scene(()), standard_camera()
        with pytest.raises(ValueError, match="samples must be a whole number of at least 1, got 0"):
            photograph(scene, camera, samples=0)
        with pytest.raises(ValueError, match="exposure must be positive"):
            photograph(scene, camera, exposure=-1)
        with pytest.raises(ValueError, match="subpixels must be 1, 2, 4 or 8, got 3"):
            QuickRenderer(scene, 3)
